#include <cstdio>

#include "libcontact/tools/reference/elliptic_fit.hpp"

/// Prints libcontact/friction/elliptic/log_coefficients.hpp.
int main() {
  std::fputs(contact::reference::elliptic_log_coefficients_header().c_str(),
             stdout);
}
