// Torque of bushes with interference over that with a clearance, as in
// docs/explanation/measured.md: what a measured ratio of 1.50 would ask for.
#include <gtest/gtest.h>

#include <boost/math/tools/toms748_solve.hpp>
#include <limits>
#include <memory>

#include "libcontact/base/units.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "libcontact/joint/contact.hpp"
#include "libcontact/pressure/exact.hpp"

namespace contact::test::published_torque_test {
namespace {

class Bush {
 public:
  Bush(double thickness, double nu, const Backing& backing)
      : pair_(1, Material{std::numeric_limits<double>::infinity(), 0},
              {{{thickness, {5e8, nu}}}, backing}),
        pressed_(contact(-150e-6)),
        loose_(contact(350e-6)) {}

  struct State {
    double half_angle, sum;
  };
  // At a load over the load of lift-off.
  State pressed(double load) const { return at(pressed_, load); }
  State loose(double load) const { return at(loose_, load); }
  double ratio(double load) const {
    return pressed(load).sum / loose(load).sum;
  }

 private:
  JointContact contact(double clearance) const {
    const auto kind = JointKind::pin;
    return {JointGeometry::pin(1, clearance, 1),
            pair_.surfaces(),
            FrictionLaw(0.1),
            std::make_shared<ExactLaw>(kind, pair_),
            std::make_shared<ExactPressure>(kind, pair_),
            {.walls = pair_}};
  }
  State at(const JointContact& joint, double load) const {
    const double force = load * pressed_.lift_off_force();
    const double half_angle = joint.half_angle(force).half_angle;
    return {half_angle / degree,
            joint.sum_of_pressures(force, half_angle) / force};
  }

  LayeredPair pair_;
  JointContact pressed_;
  JointContact loose_;
};

TEST(PublishedTorque, IsThatOfThePage) {
  struct Row {
    double thickness, nu, load;
    Bush::State pressed, loose;
    double ratio[3];
  };
  constexpr Row rows[] = {
      {0.1, 0.46, 1.23, {142, 1.71}, {68, 1.14}, {1.75, 1.30, 1.09}},
      {0.3, 0.46, 1.21, {143, 1.74}, {70, 1.16}, {1.72, 1.30, 1.09}},
      {0.1, 0.40, 1.24, {139, 1.70}, {64, 1.13}, {1.76, 1.30, 1.09}},
      {0.1, 0.49, 1.20, {150, 1.76}, {77, 1.17}, {1.71, 1.29, 1.09}}};
  constexpr double last_digit = 0.0051;
  for (const Row& row : rows) {
    const Bush bush(row.thickness, row.nu, Backing::rigid());
    std::uintmax_t steps = 50;
    const double load =
        boost::math::tools::toms748_solve(
            [&](double u) { return bush.ratio(u) - 1.5; }, 1.01, 5.0,
            boost::math::tools::eps_tolerance<double>(30), steps)
            .first;
    EXPECT_NEAR(load, row.load, last_digit);
    EXPECT_NEAR(bush.pressed(load).half_angle, row.pressed.half_angle, 0.51);
    EXPECT_NEAR(bush.pressed(load).sum, row.pressed.sum, last_digit);
    EXPECT_NEAR(bush.loose(load).half_angle, row.loose.half_angle, 0.51);
    EXPECT_NEAR(bush.loose(load).sum, row.loose.sum, last_digit);
    for (int i = 0; i < 3; ++i) {
      constexpr double loads[] = {1.01, 1.67, 5};
      EXPECT_NEAR(bush.ratio(loads[i]), row.ratio[i], last_digit) << i;
    }
  }
  const Bush ring(0.3, 0.46, Backing::held());
  constexpr double ratios[][2] = {{1.01, 1.38}, {1.67, 1.15}, {5, 1.05}};
  for (const auto& [load, ratio] : ratios) {
    EXPECT_NEAR(ring.ratio(load), ratio, last_digit);
  }
}

}  // namespace
}  // namespace contact::test::published_torque_test
