// The pressure of joints that wear: a mixture of two laws, in all its members
// and in the friction that follows.
#include "libcontact/pressure/running_in.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/friction/models.hpp"
#include "libcontact/half_angle/worn.hpp"
#include "libcontact/pressure/exact.hpp"
#include "libcontact/pressure/factory.hpp"
#include "libcontact/pressure/profile.hpp"
#include "libcontact/pressure/shaped.hpp"
#include "support/accuracy_report.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/wall.hpp"

namespace contact::test::running_in_test {
namespace {

constexpr double wear_numbers[] = {1e-4, 0.02, 0.5};
constexpr double half_angles[] = {12 * degree, 40 * degree, 75 * degree};

// A law without expansion.
class Own final : public ShapedPressure {
 public:
  explicit Own(JointKind kind) : ShapedPressure(kind, "own") {}

 private:
  double shape(double theta, double half_angle) const noexcept override {
    return std::pow(1 - std::pow(theta / half_angle, 2), 0.75);
  }
};

// A ring that is free outside and presses hardest off the centre.
std::shared_ptr<const PressureLaw> ring() {
  return std::make_shared<ExactPressure>(JointKind::ball,
                                         Wall{0.04, 0.4, true}.pair());
}

std::vector<std::shared_ptr<const PressureLaw>> laws(JointKind kind) {
  const auto pair = ElasticPair::from_modulus_ratio(7, 0.3, 0.4);
  std::vector<std::shared_ptr<const PressureLaw>> all;
  for (const std::string& name : pressure_law_names()) {
    all.push_back(make_pressure_law(name, kind, pair));
  }
  all.push_back(std::make_shared<Own>(kind));
  return all;
}

// Calls visit(law before wear, WornPressure, RunningInPressure, s, theta0,
// label) where v is below g(theta0).
template <class Visit>
void for_all(JointKind kind, const Visit& visit) {
  const WornPressure worn(kind);
  for (const auto& law : laws(kind)) {
    for (const double v : wear_numbers) {
      const RunningInPressure both(law, v);
      for (const double theta0 : half_angles) {
        const double pressed = WornHalfAngle::overlap(kind, theta0) - v;
        if (pressed <= 0) continue;
        const double power = std::pow(v / pressed, 1.8);
        visit(*law, worn, both, power / (2.8 + power), theta0,
              law->name() + ' ' + to_string(kind) + ", v = " +
                  std::to_string(v) + ", theta0 = " + std::to_string(theta0));
      }
    }
  }
}

TEST(RunningInPressure, MixesTwoLaws) {
  AccuracyReport report("pressure, slope, peak, S", 1e-14);
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    for_all(kind, [&](const PressureLaw& law, const WornPressure& worn,
                      const RunningInPressure& both, double s, double theta0,
                      const std::string& label) {
      const auto mixed = [&](double a, double b) { return a + s * (b - a); };
      const detail::PressureProfile profile(both, theta0);
      for (const double share : {0., 0.3, 0.9, 1.}) {
        const double t = share * theta0;
        const double p =
            mixed(law.pressure(t, theta0), worn.pressure(t, theta0));
        report.add(both.pressure(t, theta0), p, label);
        report.add(profile.pressure(t), p, label);
        if (share == 1) continue;
        const double slope = mixed(law.slope(t, theta0), worn.slope(t, theta0));
        report.add(both.slope(t, theta0), slope, label);
        report.add(profile.slope(t), slope, label);
      }
      report.add(both.peak(theta0), mixed(law.peak(theta0), worn.peak(theta0)),
                 label);
      report.add(both.force_ratio(theta0),
                 mixed(law.force_ratio(theta0), worn.force_ratio(theta0)),
                 label);
    });
  }
}

// Friction is linear in the pressure that carries the load: integrals mix as
// the pressures do, for any path of the mixture.
TEST(RunningInPressure, FrictionMixesLikewise) {
  // Own laws are good to 1e-9; the others' ways through one sum and through
  // two differ by rounding.
  AccuracyReport own("coefficients of a law without expansion", 1e-9);
  AccuracyReport report("coefficients", 1e-12);
  AccuracyReport viscous("viscous coefficients", 1e-12);
  for_all(JointKind::ball, [&](const PressureLaw& law, const WornPressure& worn,
                               const RunningInPressure& both, double s,
                               double theta0, const std::string& label) {
    for (const double a : {0.1, 0.6, 1.4}) {
      const SlipAxis axis{std::sin(a), std::cos(a)};
      const auto compare = [&](AccuracyReport& to, const auto& integrals) {
        const auto one = integrals(law).coefficient;
        const auto two = integrals(worn).coefficient;
        const auto mixed = integrals(both).coefficient;
        const auto add = [&](double x, double y, double found) {
          to.add(found, x + s * (y - x), label);
        };
        add(one.force, two.force, mixed.force);
        add(one.sliding, two.sliding, mixed.sliding);
        add(one.spinning, two.spinning, mixed.spinning);
      };
      compare(law.name() == "own" ? own : report, [&](const PressureLaw& p) {
        return friction_integrals(p, theta0, axis);
      });
      compare(law.name() == "own" ? own : viscous, [&](const PressureLaw& p) {
        return viscous_friction_integrals(p, theta0, axis);
      });
    }
  });
}

// The largest of the sum lies between the largest of its parts.
TEST(RunningInPressure, PeakOfAFreeRing) {
  const auto law = ring();
  const RunningInPressure both(law, 1e-3);
  bool is_off_centre = false;
  for (double theta0 = 25 * degree; theta0 < 80 * degree;
       theta0 += 5 * degree) {
    double largest = 0;
    for (int i = 0; i <= 20000; ++i) {
      largest = std::max(largest, both.pressure(theta0 * i / 20000, theta0));
    }
    // Tolerance of a grid of 20,000 points.
    EXPECT_NEAR(both.peak(theta0) / largest, 1, 1e-6);
    EXPECT_GE(both.peak(theta0), largest * (1 - 1e-14));
    is_off_centre |= largest > both.pressure(0, theta0) * (1 + 1e-6);
  }
  EXPECT_TRUE(is_off_centre);
}

// Without wear it is the law, without load the worn pressure.
TEST(RunningInPressure, Limits) {
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    const auto law = laws(kind)[1];
    const WornPressure worn(kind);
    const RunningInPressure fresh(law, 0);
    EXPECT_EQ(fresh.peak(0.4), law->peak(0.4));
    EXPECT_EQ(fresh.pressure(0.1, 2), law->pressure(0.1, 2));
    EXPECT_EQ(fresh.largest_half_angle(), law->largest_half_angle());
    const RunningInPressure both(law, 0.3);
    const double unloaded = WornHalfAngle::half_angle_of_overlap(kind, 0.3);
    EXPECT_NEAR(both.peak(unloaded) / worn.peak(unloaded), 1, 1e-9);
    EXPECT_EQ(both.share(unloaded / 2), 1);
    EXPECT_EQ(both.largest_half_angle(), std::numbers::pi / 2);
    EXPECT_NEAR(both.peak(std::numbers::pi / 2),
                law->peak(std::numbers::pi / 2), 1e-15);
    EXPECT_TRUE(all_nan({both.peak(1.6), both.share(std::nan(""))}));
    EXPECT_EQ(both.name(), law->name() + "_worn");
  }
  EXPECT_ERROR(RunningInPressure(laws(JointKind::pin)[0], -1),
               "running-in pressure: wear_number = -1 must be 0 or above and "
               "finite");
}

}  // namespace
}  // namespace contact::test::running_in_test
