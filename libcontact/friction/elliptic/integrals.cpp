#include "libcontact/friction/elliptic/integrals.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/friction/elliptic/integrals_real.hpp"
#include "libcontact/friction/elliptic/log_coefficients.hpp"

namespace contact {
namespace {

constexpr double ln4 = 2 * std::numbers::ln2;

/// Rounding of the log forms, measured 9e-16 at order 9
/// (friction/elliptic_integrals_test.cpp).
constexpr double log_form_rounding = 1e-15;

/// c_0 + c_1 x + ..., `size` terms.
double polynomial(const double* c, int size, double x) {
  double sum = c[size - 1];
  for (int i = size - 2; i >= 0; --i) sum = sum * x + c[i];
  return sum;
}

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

EllipticLogForm::EllipticLogForm(int order) : order_(order) {
  if (order < 1 || order > max_order) {
    throw Error(
        detail::must_be("elliptic log form: order = " + std::to_string(order),
                        "1 to " + std::to_string(max_order)));
  }
}

double EllipticLogForm::k(double x) const {
  const auto& c = detail::elliptic_k_log[order_ - 1];
  return ln4 + x * polynomial(c.p, order_, x) -
         (0.5 + x * polynomial(c.q, order_, x)) * std::log(x);
}

double EllipticLogForm::e(double x) const {
  const auto& c = detail::elliptic_e_log[order_ - 1];
  return 1 + x * polynomial(c.p, order_, x) +
         polynomial(c.q, order_, x) * minus_x_ln_x(x);
}

double EllipticLogForm::error_k() const {
  return detail::elliptic_k_log[order_ - 1].error + log_form_rounding;
}

double EllipticLogForm::error_e() const {
  return detail::elliptic_e_log[order_ - 1].error + log_form_rounding;
}

}  // namespace contact
