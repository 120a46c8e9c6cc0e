#include <gtest/gtest.h>

#include <cmath>

#include "libcontact/base/units.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/pin.hpp"
#include "support/accuracy_report.hpp"
#include "support/numbers.hpp"
#include "support/unilateral_contact.hpp"

// The exact solutions against an independent method that does not assume a
// single contact interval: complementarity on the whole circumference
// (support/unilateral_contact.hpp).
namespace contact::test::unilateral_test {
namespace {

struct Case {
  double modulus_ratio;
  double inner_poissons_ratio;
  double outer_poissons_ratio;
  double load_parameter;
  double patch_half_angle;  // negative: force at the centre
};

constexpr Case cases[] = {{0, 0.1, 0.3, 0.05, -1},
                          {0, 0.3, 0.3, 3, -1},
                          {0, 0.45, 0.3, 30, -1},
                          {0.2, 0.2, 0.4, 1, -1},
                          {1, 0.3, 0.3, 0.3, -1},
                          {1, 0.5, 0, 10, -1},
                          {5, 0.1, 0.45, 2, -1},
                          {infinity, 0.3, 0.25, 20, -1},
                          {0, 0.3, 0.3, 3, 20 * degree},
                          {0, 0.3, 0.3, 3, 60 * degree},
                          {0.5, 0.4, 0.2, 0.5, 5 * degree},
                          {1, 0.3, 0.3, 10, 40 * degree}};

constexpr int nodes = 200;

template <class Contact>
void compare(JointKind kind) {
  // The edge of the contact lies between two nodes, pi/nodes = 0.9 deg apart;
  // the extrapolation places it within a quarter of that.
  AccuracyReport angle("theta0, deg", 0.25 * 180 / nodes);
  // The pressure well inside the contact and the load that follows from it
  // converge like nodes^-2: 5e-4 at worst, for the narrowest contact.
  AccuracyReport pressure("p / peak", 1e-3);
  for (const Case& c : cases) {
    const ElasticPair pair = ElasticPair::from_modulus_ratio(
        c.modulus_ratio, c.inner_poissons_ratio, c.outer_poissons_ratio);
    const bool back = c.patch_half_angle >= 0;
    const Contact exact(pair, back ? InnerLoading::back(c.patch_half_angle)
                                   : InnerLoading::centre());
    const ExactHalfAngle result = exact.half_angle(c.load_parameter);
    ASSERT_EQ(result.status, Status::ok);
    const double theta0 = result.half_angle;
    const ContactPressure p = exact.pressure(theta0);
    const UnilateralContact other = solve_unilateral(
        kind, pair, c.load_parameter, nodes, c.patch_half_angle);
    ASSERT_TRUE(other.converged);
    const std::string label =
        "Ebar = " + std::to_string(c.modulus_ratio) +
        ", load = " + std::to_string(c.load_parameter) +
        ", psi_deg = " + std::to_string(c.patch_half_angle / degree);
    angle.add_error(std::abs(other.half_angle - theta0) / degree, label);
    for (int j = 0; j < nodes; ++j) {
      // Complementarity, to rounding.
      EXPECT_GE(other.pressure(j), 0) << label;
      EXPECT_GE(other.gap(j), -1e-10) << label;
      EXPECT_LT(other.pressure(j) * std::abs(other.gap(j)), 1e-9) << label;
      if (other.theta(j) < 0.85 * theta0) {
        pressure.add_error(
            std::abs(other.pressure(j) - p.pressure(other.theta(j))) / p.peak(),
            label + ", theta_deg = " + std::to_string(other.theta(j) / degree));
      }
    }
  }
}

TEST(UnilateralContact, AgreesWithThePin) {
  compare<PinContact>(JointKind::pin);
}

TEST(UnilateralContact, AgreesWithTheBall) {
  compare<BallContact>(JointKind::ball);
}

// The discretisation error falls as the nodes are refined; so does what
// separates the two methods.
TEST(UnilateralContact, ConvergesToTheExactPressure) {
  const ElasticPair pair = ElasticPair::from_modulus_ratio(0.2, 0.2, 0.4);
  const auto difference = [&pair](JointKind kind, int count) {
    const double load = 2;
    const UnilateralContact other = solve_unilateral(kind, pair, load, count);
    const bool is_pin = kind == JointKind::pin;
    const PinContact pin(pair);
    const BallContact ball(pair);
    const double theta0 = is_pin ? pin.half_angle(load).half_angle
                                 : ball.half_angle(load).half_angle;
    const ContactPressure p =
        is_pin ? pin.pressure(theta0) : ball.pressure(theta0);
    double largest = 0;
    for (int j = 0; j < count && other.theta(j) < theta0 / 2; ++j) {
      largest = std::max(
          largest,
          std::abs(other.pressure(j) / p.pressure(other.theta(j)) - 1));
    }
    return largest;
  };
  for (const JointKind kind : {JointKind::pin, JointKind::ball}) {
    const double coarse = difference(kind, 50);
    const double fine = difference(kind, 400);
    // Order 2 would give 64; the place of the edge between two nodes makes
    // single factors vary by some.
    EXPECT_LT(fine, coarse / 16) << to_string(kind);
    EXPECT_LT(fine, 5e-5) << to_string(kind);
  }
}

}  // namespace
}  // namespace contact::test::unilateral_test
