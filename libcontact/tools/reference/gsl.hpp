#pragma once

namespace contact::reference {

/// GSL's default error handler aborts the program; this switches it off, once
/// and for all threads. Every function of contact::reference that calls GSL
/// calls this first and reads GSL's return codes instead.
void use_gsl_return_codes();

}  // namespace contact::reference
