// Identities of the friction integrals that need no reference values, for
// every method. A method is one line in the lists at the end.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <ostream>
#include <string>

#include "libcontact/base/units.hpp"
#include "libcontact/friction/elliptic/friction.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/friction/models.hpp"
#include "libcontact/friction/special.hpp"
#include "libcontact/pressure/cosine.hpp"
#include "libcontact/tools/reference/quadrature.hpp"
#include "support/friction_reference.hpp"
#include "support/numbers.hpp"

namespace contact::test::identities_test {
namespace {

struct Method {
  std::string name;
  FrictionIntegrals (*function)(double half_angle, SlipAxis axis);
  /// Relative error of its results, and the smallest half-angle, degrees,
  /// from which that holds.
  double error;
  double smallest_deg;
  /// Whether one sign of a is the other's mirror to the last bit.
  bool is_mirrored = true;

  FrictionIntegrals operator()(double theta0, double a) const {
    return function(theta0, SlipAxis::from_angle(a));
  }
};

std::ostream& operator<<(std::ostream& out, const Method& method) {
  return out << method.name;
}

// Away from the edge (theta0 + |a| = 90 deg), where second derivatives are
// infinite; both sides of it, and both poles inside at 110 deg, 10 deg.
const double theta0_values[] = {20 * degree, 70 * degree, 110 * degree};
const double a_values[] = {-35 * degree, 10 * degree, 62 * degree};

/// Derivative by central differences with steps h and 2h: error
/// h^4 f'''''/30 and 1.5 times the relative error of f over h.
double derivative(const std::function<double(double)>& f, double x, double h) {
  const double near = (f(x + h) - f(x - h)) / (2 * h);
  const double far = (f(x + 2 * h) - f(x - 2 * h)) / (4 * h);
  return (4 * near - far) / 3;
}

constexpr double step = 1e-3;
/// For derivatives of numbers up to 10: h^4 f'''''/30 stays below 1e-10 (the
/// edge is 15 deg away at least), the rest is the method's error.
double derivative_tolerance(const Method& method) {
  return 1e-9 + 20 * method.error / step;
}

std::string name_of(const testing::TestParamInfo<Method>& info) {
  return info.param.name;
}

class AnyFrictionMethod : public testing::TestWithParam<Method> {};

TEST_P(AnyFrictionMethod, ForceAndSlidingAreEvenSpinningIsOdd) {
  const Method& f = GetParam();
  const double tolerance = 2 * f.error;
  for (const double theta0 : theta0_values) {
    for (const double a : a_values) {
      const FrictionIntegrals plus = f(theta0, a), minus = f(theta0, -a);
      const auto check = [&](const FrictionTriple& p, const FrictionTriple& m) {
        EXPECT_NEAR(m.force / p.force, 1, tolerance);
        EXPECT_NEAR(m.sliding / p.sliding, 1, tolerance);
        EXPECT_NEAR(m.spinning / p.spinning, -1, tolerance);
      };
      check(plus.pressure, minus.pressure);
      check(plus.area, minus.area);
      check(plus.coefficient, minus.coefficient);
      EXPECT_EQ(plus.normal, minus.normal);
    }
  }
}

TEST_P(AnyFrictionMethod, MirrorIsExact) {
  const Method& f = GetParam();
  if (!f.is_mirrored) GTEST_SKIP() << "both signs are integrated as they come";
  for (const double theta0_deg : {0.3, 20.0, 42.6, 60.0, 89.0, 104.0}) {
    for (const double a_deg :
         {1e-7, 1.0, 12.0, 30.0, 40.0, 45.0, 47.4, 88.0, 89.5, 90.0}) {
      SCOPED_TRACE(std::to_string(theta0_deg) + ' ' + std::to_string(a_deg));
      const auto at = [&](double sign) {
        return f.function(theta0_deg * degree,
                          SlipAxis::from_degrees(sign * a_deg));
      };
      const FrictionIntegrals plus = at(1), minus = at(-1);
      for (const auto triple :
           {&FrictionIntegrals::pressure, &FrictionIntegrals::area}) {
        EXPECT_EQ((plus.*triple).force, (minus.*triple).force);
        EXPECT_EQ((plus.*triple).sliding, (minus.*triple).sliding);
        EXPECT_EQ((plus.*triple).spinning, -(minus.*triple).spinning);
      }
    }
  }
}

TEST_P(AnyFrictionMethod, NormalIntegralAndCoefficients) {
  const Method& f = GetParam();
  for (const double theta0 : theta0_values) {
    const FrictionIntegrals r = f(theta0, 0.5);
    // Two correctly rounded routes to the same polynomial.
    EXPECT_NEAR(r.normal / cosine_normal_integral(JointKind::ball, theta0), 1,
                3e-15);
    EXPECT_NEAR(r.coefficient.force * r.normal / r.pressure.force, 1, 3e-15);
    EXPECT_NEAR(r.coefficient.sliding * r.normal / r.pressure.sliding, 1,
                3e-15);
    EXPECT_NEAR(r.coefficient.spinning * r.normal / r.pressure.spinning, 1,
                3e-15);
  }
}

// d/dtheta0 of the weight cos t - cos theta0 is sin theta0, whatever the slip
// velocity: each pressure integral grows by sin theta0 times the area one.
TEST_P(AnyFrictionMethod, PressureIntegralsGrowByTheAreaIntegrals) {
  const Method& f = GetParam();
  const double tolerance = derivative_tolerance(f);
  for (const double theta0 : theta0_values) {
    for (const double a : a_values) {
      const auto growth = [&](double FrictionTriple::*role) {
        return derivative([&](double t) { return f(t, a).pressure.*role; },
                          theta0, step);
      };
      const FrictionTriple area = f(theta0, a).area;
      const double s = std::sin(theta0);
      EXPECT_NEAR(growth(&FrictionTriple::force), s * area.force, tolerance);
      EXPECT_NEAR(growth(&FrictionTriple::sliding), s * area.sliding,
                  tolerance);
      EXPECT_NEAR(growth(&FrictionTriple::spinning), s * area.spinning,
                  tolerance);
    }
  }
}

TEST_P(AnyFrictionMethod, StayBelowTheSumOfTractions) {
  // |e| <= 1 and |r| = 1: no component exceeds the contact's area, or the
  // sum of pressures, 3/(2 + c) per unit normal force.
  const Method& f = GetParam();
  for (const double theta0 : theta0_values) {
    for (const double a : a_values) {
      const FrictionIntegrals r = f(theta0, a);
      const double c = std::cos(theta0);
      const double limit[] = {2 * pi * (1 - c), 3 / (2 + c)};
      const FrictionTriple triples[] = {r.area, r.coefficient};
      for (int i = 0; i < 2; ++i) {
        EXPECT_GT(triples[i].force, 0);
        EXPECT_GT(triples[i].sliding, 0);
        EXPECT_GT(triples[i].spinning * a, 0);
        EXPECT_LT(triples[i].force, limit[i]);
        EXPECT_LT(std::hypot(triples[i].sliding, triples[i].spinning),
                  limit[i]);
      }
    }
  }
}

TEST_P(AnyFrictionMethod, SmallContacts) {
  const Method& f = GetParam();
  const double theta0 = std::max(f.smallest_deg, 0.01) * degree;
  // Corrections of second order: below theta0^2 in all four.
  const double tolerance = theta0 * theta0 + 10 * f.error;
  const FrictionIntegrals slide = f.function(theta0, {0, 1});
  EXPECT_NEAR(slide.coefficient.force, 1, tolerance);
  EXPECT_NEAR(slide.coefficient.sliding, 1, tolerance);
  EXPECT_EQ(slide.coefficient.spinning, 0);
  const FrictionIntegrals spin = f.function(theta0, {1, 0});
  EXPECT_EQ(spin.coefficient.force, 0);
  EXPECT_EQ(spin.coefficient.sliding, 0);
  // Planar disc: dry with parabolic pressure 8/15; viscous, where the speed
  // is the distance from the centre, theta0/3.
  const double disc = f.name == "viscous" ? theta0 / 3 : 8.0 / 15;
  EXPECT_NEAR(spin.coefficient.spinning / theta0, disc, tolerance);
  const double area = pi * theta0 * theta0;
  EXPECT_NEAR(slide.area.force / area, 1, tolerance);
  EXPECT_NEAR(slide.area.sliding / area, 1, tolerance);
}

TEST_P(AnyFrictionMethod, NoContact) {
  for (const double a_deg :
       {-90.0, -89.9, -60.0, -30.0, 0.0, 22.4, 45.0, 60.0, 89.999, 90.0}) {
    const SlipAxis axis = SlipAxis::from_degrees(a_deg);
    const FrictionIntegrals r = GetParam().function(0, axis);
    EXPECT_EQ(r.normal, 0);
    for (const FrictionTriple& t : {r.pressure, r.area}) {
      EXPECT_EQ(t.force, 0);
      EXPECT_EQ(t.sliding, 0);
      EXPECT_EQ(t.spinning, 0);
    }
    EXPECT_EQ(r.coefficient.spinning, 0);
    // Exactly 1 up to the rounding of weights and scale: 4 units of 1.1e-16.
    if (a_deg == 0) {
      EXPECT_NEAR(r.coefficient.force, 1, 5e-16);
      EXPECT_NEAR(r.coefficient.sliding, 1, 5e-16);
    } else if (std::abs(a_deg) == 90) {
      EXPECT_EQ(r.coefficient.force, 0);
      EXPECT_EQ(r.coefficient.sliding, 0);
    }
  }
}

TEST_P(AnyFrictionMethod, NanAndOutOfRangeGiveNan) {
  const auto expect_nan = [&](double theta0, SlipAxis axis) {
    const FrictionIntegrals r = GetParam().function(theta0, axis);
    for (const FrictionTriple& t : {r.pressure, r.area, r.coefficient}) {
      EXPECT_TRUE(all_nan({t.force, t.sliding, t.spinning})) << theta0;
    }
    // The normal integral does not depend on the axis.
    if (!std::isnan(axis.sin)) {
      EXPECT_TRUE(all_nan({r.normal})) << theta0;
    }
  };
  for (const double bad : {nan, -0.1, -1e-3, -1e-9, 3.2, infinity}) {
    expect_nan(bad, {0.6, 0.8});
    expect_nan(bad, SlipAxis::from_degrees(30));
  }
  expect_nan(1.0, {nan, nan});
}

/// Methods of dry friction on the sphere: all must be the same function.
class DryFrictionMethod : public testing::TestWithParam<Method> {};

TEST_P(DryFrictionMethod, NoContactKeepsTheLimitsOfTheCoefficients) {
  const auto at = [&](double a_deg) {
    return GetParam().function(0, SlipAxis::from_degrees(a_deg)).coefficient;
  };
  for (const double a_deg : {-89.9, -30.0, 0.0, 22.4, 45.0, 89.999}) {
    EXPECT_EQ(at(a_deg).force, 1);
    EXPECT_EQ(at(a_deg).sliding, 1);
  }
}

// Friction power per unit |Dw|: Phi = J cos a + K sin a. M = -grad Phi means
// dPhi/da = K cos a - J sin a.
TEST_P(DryFrictionMethod, MomentsAreTheGradientOfThePower) {
  const Method& f = GetParam();
  const double tolerance = derivative_tolerance(f);
  for (const double theta0 : theta0_values) {
    for (const double a : a_values) {
      const auto check = [&](FrictionTriple FrictionIntegrals::*weight) {
        const auto power = [&](double b) {
          const FrictionTriple m = f(theta0, b).*weight;
          return m.sliding * std::cos(b) + m.spinning * std::sin(b);
        };
        const FrictionTriple m = f(theta0, a).*weight;
        EXPECT_NEAR(derivative(power, a, step),
                    m.spinning * std::cos(a) - m.sliding * std::sin(a),
                    tolerance);
      };
      check(&FrictionIntegrals::area);
      check(&FrictionIntegrals::pressure);
    }
  }
}

// Phi(u + v) <= Phi(u) + Phi(v) for vectors u, v in the plane OYZ, with the
// pole on either side of the edge and on it.
TEST_P(DryFrictionMethod, PowerIsConvex) {
  const Method& f = GetParam();
  for (const double theta0 : theta0_values) {
    const auto power = [&](double y, double z) {
      const double size = std::hypot(y, z);
      const FrictionIntegrals r = f.function(theta0, {z / size, y / size});
      return std::pair(r.area.sliding * y + r.area.spinning * z,
                       r.pressure.sliding * y + r.pressure.spinning * z);
    };
    for (double u = 5; u < 90; u += 20) {
      for (double v = u - 85; v < u; v += 25) {
        const double uy = std::cos(u * degree), uz = std::sin(u * degree);
        const double vy = std::cos(v * degree), vz = std::sin(v * degree);
        const auto [area_u, pressure_u] = power(uy, uz);
        const auto [area_v, pressure_v] = power(vy, vz);
        const auto [area, pressure] = power(uy + vy, uz + vz);
        // The vectors are not parallel: strictly convex.
        EXPECT_LT(area, area_u + area_v);
        EXPECT_LT(pressure, pressure_u + pressure_v);
      }
    }
  }
}

// A cap beyond the hemisphere is the sphere less the opposite cap, whose
// pressure weight has the opposite sign.
TEST_P(DryFrictionMethod, ReflectionBeyondTheHemisphere) {
  const Method& f = GetParam();
  for (const double theta0_deg : {93.0, 110.0, 120.0, 150.0}) {
    for (const double a : a_values) {
      const double theta0 = theta0_deg * degree;
      const double rest = pi - theta0;
      const double q = std::cos(a), sa = std::sin(a), c = std::cos(rest);
      const FrictionIntegrals over = f(theta0, a), under = f(rest, a);
      // Numbers up to 15, and the rounding of pi - theta0.
      const double tolerance = 20 * f.error + 2e-14;
      EXPECT_NEAR(over.area.force, under.area.force, tolerance);
      EXPECT_NEAR(over.area.sliding, pi * pi * q - under.area.sliding,
                  tolerance);
      EXPECT_NEAR(over.area.spinning, pi * pi * sa - under.area.spinning,
                  tolerance);
      EXPECT_NEAR(over.pressure.force, pi * pi / 2 * q - under.pressure.force,
                  tolerance);
      EXPECT_NEAR(over.pressure.sliding,
                  under.pressure.sliding + pi * pi * c * q, tolerance);
      EXPECT_NEAR(over.pressure.spinning,
                  under.pressure.spinning + pi * pi * c * sa, tolerance);
    }
  }
}

// I[p] = (J[1] - c I[1])/2 for every slip axis
// (docs/internals/elliptic_form.md).
TEST_P(DryFrictionMethod, ForceFollowsFromTheAreaIntegrals) {
  const Method& f = GetParam();
  for (const double theta0 : theta0_values) {
    for (const double a : a_values) {
      const FrictionIntegrals r = f(theta0, a);
      // Numbers up to 10.
      EXPECT_NEAR(r.pressure.force,
                  (r.area.sliding - std::cos(theta0) * r.area.force) / 2,
                  10 * f.error + 1e-14);
    }
  }
}

TEST_P(DryFrictionMethod, SpecialCases) {
  const Method& f = GetParam();
  const auto check = [&](const FrictionIntegrals& r,
                         const FrictionIntegrals& special) {
    for (const auto& quantity : friction_quantities()) {
      // Both sides' errors, relative; 0 is 0.
      EXPECT_NEAR(quantity.of(r), quantity.of(special),
                  (f.error + 3e-15) * std::abs(quantity.of(special)))
          << quantity.column;
    }
  };
  for (const double theta0 : theta0_values) {
    check(f.function(theta0, {0, 1}), sliding_friction_integrals(theta0));
    check(f.function(theta0, {1, 0}), spinning_friction_integrals(theta0));
  }
  for (const double a_deg : {-35.0, 10.0, 62.0}) {
    const SlipAxis axis = SlipAxis::from_degrees(a_deg);
    check(f.function(pi / 2, axis), hemisphere_friction_integrals(axis));
  }
}

FrictionIntegrals batch(double half_angle, SlipAxis axis) {
  FrictionIntegrals r;
  const auto one = [](double& x) { return std::span<double>(&x, 1); };
  friction_integrals(
      {{&half_angle, 1}, {&axis.sin, 1}, {&axis.cos, 1}},
      {one(r.normal), one(r.pressure.force), one(r.pressure.sliding),
       one(r.pressure.spinning), one(r.area.force), one(r.area.sliding),
       one(r.area.spinning), one(r.coefficient.force),
       one(r.coefficient.sliding), one(r.coefficient.spinning)});
  return r;
}

FrictionIntegrals quadrature(double half_angle, SlipAxis axis) {
  return reference::quadrature_friction_integrals(half_angle, axis).value;
}

// Errors: docstrings of the methods; elliptic in double from 20 deg.
const Method exact_method{"exact",
                          [](double half_angle, SlipAxis axis) {
                            return friction_integrals(half_angle, axis);
                          },
                          2e-15, 0};
const Method batch_method{"batch", batch, 2e-15, 0};
const Method elliptic_method{"elliptic", elliptic_friction_integrals, 3e-12,
                             20};
const Method quadrature_method{"quadrature", quadrature, 1e-10, 0, false};

INSTANTIATE_TEST_SUITE_P(Methods, DryFrictionMethod,
                         testing::Values(exact_method, batch_method,
                                         elliptic_method, quadrature_method),
                         name_of);
INSTANTIATE_TEST_SUITE_P(
    Methods, AnyFrictionMethod,
    testing::Values(exact_method, batch_method, elliptic_method,
                    quadrature_method,
                    Method{"planar", planar_friction_integrals, 2e-12, 0},
                    Method{"viscous", viscous_friction_integrals, 1e-15, 0},
                    Method{"cosine", cosine_friction_integrals, 4e-15, 0}),
    name_of);

}  // namespace
}  // namespace contact::test::identities_test
