#include "libcontact/friction/friction_integrals.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "libcontact/friction/kernel/cap_point.hpp"
#include "support/accuracy_report.hpp"
#include "support/friction_reference.hpp"
#include "support/numbers.hpp"

namespace contact::test::exact_test {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

TEST(ExactFriction, ReferenceTable) {
  // Measured 1.4e-15; the project's bound for every quantity is 1e-14.
  check_friction_accuracy(
      [](double half_angle, SlipAxis axis) {
        return friction_integrals(half_angle, axis);
      },
      2e-15);
}

// The polynomials, computed again at 50 digits as their header describes.
using Real = boost::multiprecision::cpp_bin_float_50;

// (d - sin d cos d)/sin^3 d from its series in sin^2(d/2) where the closed
// form would cancel, at x = cos d.
Real arc_f(const Real& x) {
  using Wide = boost::multiprecision::cpp_bin_float_100;
  const Wide c(x);
  const Wide s2 = (1 - c) * (1 + c);
  const Wide s = sqrt(s2);
  return Real((acos(c) - s * c) / (s * s2));
}
Real arc_h(const Real& x) {
  return (Real(2) / 3 - x * arc_f(x)) / ((1 - x) * (1 + x));
}

// Coefficients of the interpolant at the n Chebyshev points of [lower, 1], in
// powers of x - centre.
std::vector<Real> interpolant(Real (*f)(const Real&), const Real& lower,
                              int n) {
  const Real& pi = boost::math::constants::pi<Real>();
  const Real centre = (lower + 1) / 2;
  const Real half = (1 - lower) / 2;
  std::vector<Real> power(n, Real(0));
  std::vector<Real> t0{1}, t1{0, 1};  // T_j in powers of (x - centre)/half
  for (int j = 0; j < n; ++j) {
    Real c = 0;
    for (int k = 0; k < n; ++k) {
      const Real angle = pi * (2 * k + 1) / (2 * n);
      c += f(centre + half * cos(angle)) * cos(j * angle);
    }
    c *= Real(j == 0 ? 1 : 2) / n;
    for (std::size_t i = 0; i < t0.size(); ++i) power[i] += c * t0[i];
    std::vector<Real> t2(t1.size() + 1, Real(0));
    for (std::size_t i = 0; i < t1.size(); ++i) t2[i + 1] = 2 * t1[i];
    for (std::size_t i = 0; i < t0.size(); ++i) t2[i] -= t0[i];
    t0 = t1;
    t1 = t2;
  }
  Real scale = 1;
  for (Real& p : power) {
    p /= scale;
    scale *= half;
  }
  return power;
}

template <int n>
void check_polynomial(const char* name, Real (*f)(const Real&),
                      const detail::ArcPolynomial<n>& polynomial,
                      const char* lower) {
  const std::vector<Real> made = interpolant(f, Real(lower), n);
  // The header's decimals carry 20 digits, rounded once to double: 1.1e-16.
  AccuracyReport report(name, 1.2e-16);
  for (int i = 0; i < n; ++i) {
    report.add(Real(polynomial.coefficients[i]), made[i],
               "coefficient " + std::to_string(i));
  }
  EXPECT_EQ(polynomial.lower, std::stod(lower));
}

TEST(ExactFriction, PolynomialsAreTheInterpolantsTheyClaimToBe) {
  using namespace detail;
  check_polynomial("arc_h_short", arc_h, arc_h_short, "0.8");
  check_polynomial("arc_h_medium", arc_h, arc_h_medium, "0.4");
  check_polynomial("arc_f_long", arc_f, arc_f_long, "0");
}

// Every branch the method takes at a point.
auto branches(double half_angle, SlipAxis axis) {
  const auto cap = detail::prepare(half_angle, axis.sin, axis.cos);
  const double c = cap.point.c;
  return std::tuple{detail::cap_rule_index(cap.point.m), cap.pole_inside,
                    cap.beyond_hemisphere, detail::arc_range(c), c < 0.7};
}

TEST(ExactFriction, NoJumpAcrossAnySwitch) {
  // Both neighbours carry up to 2e-15 of error. The functions themselves move
  // by less than 1e-15 but for one corner: K at theta0 = 90 deg and a -> 0 has
  // the slope ln(1/a), 5e-15 from one double to the next at a = 1e-9 deg.
  AccuracyReport report("jump between neighbouring doubles", 8e-15);
  int switches = 0;
  for (const double a_deg : {0.0, 1e-9, 0.5, 5.0, 20.0, 30.0, 44.0, 45.0, 50.0,
                             63.0, 80.0, 89.0, 89.9999, 90.0, -33.0}) {
    const SlipAxis axis = SlipAxis::from_degrees(a_deg);
    double low = 1e-6;
    for (int step = 1; step <= 2400; ++step) {
      // The last steps crowd around the pole's distance from the centre.
      const double pole = right_angle - std::abs(a_deg) * degree;
      const double high =
          step <= 1200 ? step * (120 * degree / 1200)
                       : pole * (1 + std::ldexp(step % 2 ? 1.0 : -1.0,
                                                -(step - 1200) / 40 - 2));
      double left = std::min(low, high);
      double right = std::max(low, high);
      low = high;
      if (branches(left, axis) == branches(right, axis)) continue;
      // Some switch lies between: close in on it.
      while (std::nextafter(left, right) < right) {
        const double middle = left + (right - left) / 2;
        const bool same = branches(left, axis) == branches(middle, axis);
        (same ? left : right) = middle;
      }
      ++switches;
      add_integrals(report, friction_integrals(right, axis),
                    friction_integrals(left, axis),
                    "a=" + std::to_string(a_deg) +
                        " theta0=" + std::to_string(left / degree));
    }
  }
  EXPECT_GT(switches, 300);
}

TEST(ExactFriction, CoefficientsSurviveUnderflowOfTheIntegrals) {
  const SlipAxis spinning = SlipAxis::from_degrees(90);
  for (const double half_angle : {1e-80, 1e-150, 1e-300}) {
    const auto slide =
        friction_integrals(half_angle, SlipAxis::from_degrees(30));
    EXPECT_NEAR(slide.coefficient.force, 1, 5e-16);
    EXPECT_NEAR(slide.coefficient.sliding, 1, 5e-16);
    // Planar disc under a paraboloid of pressure: 8/15 of its radius.
    EXPECT_NEAR(friction_integrals(half_angle, spinning).coefficient.spinning /
                    half_angle,
                8.0 / 15, 1e-15);
  }
}

}  // namespace
}  // namespace contact::test::exact_test
