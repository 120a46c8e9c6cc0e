#include "libcontact/tools/reference/gsl.hpp"

#include <gsl/gsl_errno.h>

namespace contact::reference {

void use_gsl_return_codes() {
  static const auto previous = gsl_set_error_handler_off();
  static_cast<void>(previous);
}

}  // namespace contact::reference
