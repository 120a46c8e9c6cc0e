#include "libcontact/friction/models.hpp"

#include <gsl/gsl_integration.h>
#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <functional>
#include <memory>

#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/tools/reference/gsl.hpp"
#include "support/accuracy_report.hpp"
#include "support/friction_reference.hpp"
#include "support/numbers.hpp"

namespace contact::test::models_test {
namespace {

double gsl(const std::function<double(double)>& f, double a, double b) {
  reference::use_gsl_return_codes();
  const std::unique_ptr<gsl_integration_workspace,
                        decltype(&gsl_integration_workspace_free)>
      workspace(gsl_integration_workspace_alloc(2000),
                gsl_integration_workspace_free);
  gsl_function wrapped{
      [](double x, void* p) { return (*static_cast<decltype(&f)>(p))(x); },
      const_cast<std::function<double(double)>*>(&f)};
  double result = 0, error = 0;
  gsl_integration_qags(&wrapped, a, b, 0, 1e-12, 2000, workspace.get(), &result,
                       &error);
  return result;
}

// Component of the planar model, straight from its velocity field.
enum class Role { force, sliding, spinning };
double planar_by_definition(double theta0, SlipAxis a, Role role,
                            bool pressure) {
  const auto outer = [&](double t) {
    const auto inner = [&](double f) {
      const double vx = a.cos - a.sin * std::sin(t) * std::sin(f);
      const double vy = a.sin * std::sin(t) * std::cos(f);
      const double v = std::hypot(vx, vy);
      if (v == 0) return 0.0;
      const double x = std::sin(t) * std::cos(f);
      const double y = std::sin(t) * std::sin(f);
      switch (role) {
        case Role::force:
          return vx / v;
        case Role::sliding:  // -y component of e x r
          return vx / v * std::cos(t);
        default:  // -z component of e x r
          return (vy * x - vx * y) / v;
      }
    };
    const double weight = pressure ? std::cos(t) - std::cos(theta0) : 1;
    // Symmetric about f = 90 deg, where the velocity can vanish.
    return 2 * weight * std::sin(t) * gsl(inner, -pi / 2, pi / 2);
  };
  const double pole =
      std::abs(a.sin) > a.cos ? std::asin(a.cos / std::abs(a.sin)) : pi / 2;
  double sum = 0, left = 0;
  for (const double cut : {pole, pi - pole, theta0}) {
    const double right = std::min(cut, theta0);
    if (right > left) sum += gsl(outer, left, right);
    left = std::max(left, right);
  }
  return sum;
}

TEST(PlanarFriction, AgreesWithItsDefinition) {
  // The two nested adaptive quadratures are asked for 1e-12.
  AccuracyReport report("planar against definition", 2e-11);
  // At (90, 50) a node of the outer rule is rounded to the pole's circle.
  for (const double theta0_deg : {0.5, 30.0, 60.0, 85.0, 90.0, 110.0}) {
    for (const double a_deg : {0.0, 10.0, 45.0, 50.0, 59.0, 80.0, 89.9, 90.0}) {
      const double theta0 = theta0_deg * degree;
      const SlipAxis axis = SlipAxis::from_degrees(a_deg);
      const FrictionIntegrals r = planar_friction_integrals(theta0, axis);
      const std::string at = "theta0=" + std::to_string(theta0_deg) +
                             " a=" + std::to_string(a_deg);
      const auto check = [&](double computed, Role role, bool pressure) {
        const double expected =
            planar_by_definition(theta0, axis, role, pressure);
        // By symmetry 0 at a = 0 and 90 deg: the definition keeps rounding.
        if (std::abs(expected) < 1e-14 * r.area.force ||
            std::abs(expected) < 1e-14 * std::abs(r.area.spinning)) {
          EXPECT_NEAR(computed, 0, 1e-14) << at;
        } else {
          report.add(computed, expected, at);
        }
      };
      check(r.area.force, Role::force, false);
      check(r.area.sliding, Role::sliding, false);
      check(r.area.spinning, Role::spinning, false);
      check(r.pressure.force, Role::force, true);
      check(r.pressure.sliding, Role::sliding, true);
      check(r.pressure.spinning, Role::spinning, true);
    }
  }
}

TEST(PlanarFriction, SmallContactsAreFlat) {
  // The two models differ by terms of second order in theta0.
  for (const double theta0 : {1e-6, 1e-5, 1e-4}) {
    for (const double distance : {0.0, 0.3, 1.0, 2.0, 10.0}) {
      const SlipAxis axis = SlipAxis::from_complement(distance * theta0);
      const auto planar = planar_friction_integrals(theta0, axis);
      const auto exact = friction_integrals(theta0, axis);
      EXPECT_NEAR(planar.coefficient.force, exact.coefficient.force,
                  theta0 * theta0 + 1e-13);
      EXPECT_NEAR(planar.coefficient.spinning / theta0,
                  exact.coefficient.spinning / theta0, theta0 * theta0 + 1e-13);
    }
  }
}

using Real = boost::multiprecision::cpp_bin_float_100;

TEST(ViscousFriction, AgreesWithTheClosedFormsAtHundredDigits) {
  // Sine, square and two or three products: 4 roundings of 2.2e-16.
  AccuracyReport report("viscous", 1e-15);
  for (const double theta0 : {1e-9, 1e-3, 0.1, 0.7, 1.5, 2.0}) {
    for (const double a_deg : {-60.0, 0.0, 30.0, 89.0, 90.0}) {
      const SlipAxis axis = SlipAxis::from_degrees(a_deg);
      const auto r = viscous_friction_integrals(theta0, axis);
      const Real c = cos(Real(theta0));
      const Real u = 2 * pow(sin(Real(theta0) / 2), 2);
      const Real q = axis.cos, sa = axis.sin;
      const Real& p = boost::math::constants::pi<Real>();
      // The polynomials in c of the sheet's form cancel up to u^3.
      const Real normal = p / 3 * u * u * (2 + c);
      const Real jp = p * (u * u - u * u * u / 3 + u * u * u * u / 12) * q;
      const Real kp = 2 * p * (u * u * u / 3 - u * u * u * u / 12) * sa;
      const std::string at =
          "theta0=" + std::to_string(theta0) + " a=" + std::to_string(a_deg);
      report.add(Real(r.normal), normal, at + " normal");
      report.add(Real(r.area.force), Real(p * (1 - c * c) * q), at);
      report.add(Real(r.area.sliding),
                 Real(p * (Real(4) / 3 - c - c * c * c / 3) * q), at);
      report.add(Real(r.area.spinning),
                 Real(2 * p * (Real(2) / 3 - c + c * c * c / 3) * sa), at);
      report.add(Real(r.pressure.force), Real(normal * q), at);
      report.add(Real(r.pressure.sliding), jp, at);
      report.add(Real(r.pressure.spinning), kp, at);
      report.add(Real(r.coefficient.sliding), Real(jp / normal), at);
      report.add(Real(r.coefficient.spinning), Real(kp / normal), at);
    }
  }
}

TEST(ViscousFriction, AgreesWithItsDefinition) {
  // J = -y, K = -z of the mean of (Dw x r) x r over the cap, weight g.
  AccuracyReport report("viscous against definition", 1e-11);
  const double theta0 = 1.1;
  const SlipAxis axis = SlipAxis::from_degrees(35);
  const auto r = viscous_friction_integrals(theta0, axis);
  const auto ring = [&](double t, int component, bool pressure) {
    const double weight = pressure ? std::cos(t) - std::cos(theta0) : 1;
    return weight * std::sin(t) *
           gsl(
               [&](double f) {
                 const double x = std::sin(t) * std::cos(f);
                 const double y = std::sin(t) * std::sin(f);
                 const double z = std::cos(t);
                 const double vx = axis.cos * z - axis.sin * y;
                 const double vy = axis.sin * x;
                 const double vz = -axis.cos * x;
                 if (component == 0) return vx;
                 if (component == 1) return -(vz * x - vx * z);
                 return -(vx * y - vy * x);
               },
               0, 2 * pi);
  };
  const auto integral = [&](int component, bool pressure) {
    return gsl([&](double t) { return ring(t, component, pressure); }, 0,
               theta0);
  };
  report.add(r.area.force, integral(0, false), "I_a");
  report.add(r.area.sliding, integral(1, false), "J_a");
  report.add(r.area.spinning, integral(2, false), "K_a");
  report.add(r.pressure.force, integral(0, true), "I_p");
  report.add(r.pressure.sliding, integral(1, true), "J_p");
  report.add(r.pressure.spinning, integral(2, true), "K_p");
}

TEST(CosineFriction, ExactAtBothEnds) {
  for (const double theta0 : {0.01, 0.8, 1.57, 2.0}) {
    const auto at = [&](double a_deg) {
      const SlipAxis axis = SlipAxis::from_degrees(a_deg);
      return std::pair{cosine_friction_integrals(theta0, axis),
                       friction_integrals(theta0, axis)};
    };
    const auto [slide, exact_slide] = at(0);
    const auto [spin, exact_spin] = at(90);
    for (const auto& quantity : friction_quantities()) {
      EXPECT_EQ(quantity.of(slide), quantity.of(exact_slide));
      EXPECT_EQ(quantity.of(spin), quantity.of(exact_spin));
    }
    const auto [thirty, exact_thirty] = at(30);
    EXPECT_DOUBLE_EQ(thirty.pressure.spinning, spin.pressure.spinning / 2);
  }
}

TEST(CosineFriction, ExactForAreaMomentsOfTheHemisphere) {
  // J[1] = (pi^2/2) cos a, K[1] = (pi^2/2) sin a at theta0 = 90 deg.
  for (const double a_deg : {5.0, 30.0, 77.0}) {
    const SlipAxis axis = SlipAxis::from_degrees(a_deg);
    const auto r = cosine_friction_integrals(pi / 2, axis);
    EXPECT_NEAR(r.area.sliding, pi * pi / 2 * axis.cos, 4e-15);
    EXPECT_NEAR(r.area.spinning, pi * pi / 2 * axis.sin, 4e-15);
  }
}

}  // namespace
}  // namespace contact::test::models_test
