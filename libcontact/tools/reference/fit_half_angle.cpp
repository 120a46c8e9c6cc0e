#include <cstdio>

#include "libcontact/tools/reference/half_angle_fit.hpp"

/// Prints libcontact/half_angle/coefficients.hpp.
int main() {
  std::fputs(contact::reference::half_angle_coefficients_header().c_str(),
             stdout);
}
