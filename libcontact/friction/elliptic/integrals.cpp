#include "libcontact/friction/elliptic/integrals.hpp"

#include <cmath>

#include "libcontact/friction/elliptic/integrals_real.hpp"

namespace contact {
namespace {

/// -x ln x, 0 at x = 0.
double minus_x_ln_x(double x) { return x == 0 ? 0.0 : -x * std::log(x); }

}  // namespace

double elliptic_k(double x) { return elliptic_k<double>(x); }
double elliptic_e(double x) { return elliptic_e<double>(x); }
double elliptic_pi(double p, double x) { return elliptic_pi<double>(p, x); }
double elliptic_k_cosine(double x) { return elliptic_k_cosine<double>(x); }
double elliptic_k_sine(double x) { return elliptic_k_sine<double>(x); }
double elliptic_pi_cosine(double p, double x) {
  return elliptic_pi_cosine<double>(p, x);
}
double elliptic_pi_sine(double p, double x) {
  return elliptic_pi_sine<double>(p, x);
}

double elliptic_k_chebyshev(double x) {
  return 1.3863 + 0.1845 * x - (0.5 + 0.0879 * x) * std::log(x);
}

double elliptic_e_chebyshev(double x) {
  return 1 + 0.5708 * x + 0.1948 * minus_x_ln_x(x);
}

}  // namespace contact
