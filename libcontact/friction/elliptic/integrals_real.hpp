#pragma once

#include <boost/math/special_functions/ellint_rc.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rg.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <limits>

/// The functions of friction/elliptic/integrals.hpp for any real type that
/// Boost.Math takes (Boost.Multiprecision to 100 digits and more). Same
/// arguments and limits.
namespace contact {
namespace elliptic_policy {

/// Nothing throws, nothing is computed in a wider type than asked for.
using Policy = boost::math::policies::policy<
    boost::math::policies::domain_error<boost::math::policies::ignore_error>,
    boost::math::policies::pole_error<boost::math::policies::ignore_error>,
    boost::math::policies::overflow_error<boost::math::policies::ignore_error>,
    boost::math::policies::evaluation_error<
        boost::math::policies::ignore_error>,
    boost::math::policies::promote_double<false>>;

template <class Real>
bool valid(const Real& x) {
  return x >= 0 && x <= (std::numeric_limits<Real>::max)();
}

template <class Real>
Real not_a_number() {
  return std::numeric_limits<Real>::quiet_NaN();
}

template <class Real>
Real infinity() {
  return std::numeric_limits<Real>::infinity();
}

/// Below this x the parts of K are differences of K and E without loss,
/// above it those differences would cancel; both are good at the switch
/// (factor 2 at most).
inline constexpr double parts_switch = 0.25;

}  // namespace elliptic_policy

template <class Real>
Real elliptic_k(const Real& x) {
  using namespace elliptic_policy;
  if (!valid(x)) return not_a_number<Real>();
  if (x == 0) return infinity<Real>();
  return boost::math::ellint_rf(Real(0), x, Real(1), Policy());
}

template <class Real>
Real elliptic_e(const Real& x) {
  using namespace elliptic_policy;
  if (!valid(x)) return not_a_number<Real>();
  if (x == 0) return Real(1);
  if (x < boost::math::tools::root_epsilon<Real>() / 16) {
    // DLMF 19.12.2 to first order; the next term is (3/16) x^2 K at most.
    return 1 + x * (elliptic_k<Real>(x) - 0.5) / 2;
  }
  return 2 * boost::math::ellint_rg(Real(0), x, Real(1), Policy());
}

template <class Real>
Real elliptic_k_cosine(const Real& x) {
  using namespace elliptic_policy;
  if (!valid(x)) return not_a_number<Real>();
  if (x == 0) return Real(1);
  if (x < parts_switch) {
    return (elliptic_e<Real>(x) - x * elliptic_k<Real>(x)) / (1 - x);
  }
  return x * boost::math::ellint_rd(Real(0), Real(1), x, Policy()) / 3;
}

template <class Real>
Real elliptic_k_sine(const Real& x) {
  using namespace elliptic_policy;
  if (!valid(x)) return not_a_number<Real>();
  if (x == 0) return infinity<Real>();
  if (x < parts_switch) {
    return (elliptic_k<Real>(x) - elliptic_e<Real>(x)) / (1 - x);
  }
  return boost::math::ellint_rd(Real(0), x, Real(1), Policy()) / 3;
}

template <class Real>
Real elliptic_pi_cosine(const Real& p, const Real& x) {
  using namespace elliptic_policy;
  if (!valid(x) || !valid(p)) return not_a_number<Real>();
  if (p == 0) return elliptic_k<Real>(x);
  const Real ratio = x / p;
  const Real negligible = std::numeric_limits<Real>::epsilon() / 128;
  if (x < negligible && ratio < negligible) {
    return boost::math::ellint_rc(Real(1), p, Policy());  // the limit x = 0
  }
  return ratio / 3 *
         boost::math::ellint_rj(Real(0), x, Real(1), ratio, Policy());
}

template <class Real>
Real elliptic_pi_sine(const Real& p, const Real& x) {
  using namespace elliptic_policy;
  if (!valid(x) || !valid(p)) return not_a_number<Real>();
  if (x == 0 || p == 0) return infinity<Real>();
  return boost::math::ellint_rj(Real(0), x, Real(1), p, Policy()) / 3;
}

template <class Real>
Real elliptic_pi(const Real& p, const Real& x) {
  using namespace elliptic_policy;
  if (!valid(x) || !valid(p)) return not_a_number<Real>();
  if (x == 0 || p == 0) return infinity<Real>();
  // Both terms are positive on either side of p = 1.
  const Real sine = elliptic_pi_sine<Real>(p, x);
  if (p <= 1) return elliptic_k<Real>(x) + (1 - p) * sine;
  return elliptic_pi_cosine<Real>(p, x) + sine;
}

}  // namespace contact
