#include <cstdio>

#include "libcontact/tools/reference/pressure_mixture_fit.hpp"

/// Prints libcontact/pressure/mixture_coefficients.hpp.
int main() {
  std::fputs(contact::reference::pressure_mixture_header().c_str(), stdout);
}
