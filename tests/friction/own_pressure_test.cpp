// Pressures known by their shape only.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "libcontact/base/instruction_set.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/friction/models.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/joint/contact.hpp"
#include "libcontact/pressure/cosine.hpp"
#include "libcontact/pressure/shaped.hpp"
#include "libcontact/pressure/sqrt.hpp"
#include "libcontact/tools/reference/quadrature.hpp"
#include "support/accuracy_report.hpp"
#include "support/allocation_count.hpp"
#include "support/error_message.hpp"
#include "support/friction_reference.hpp"
#include "support/numbers.hpp"

namespace contact::test::own_pressure_test {
namespace {

// Accuracy that ShapedPressure promises.
constexpr double budget = 1e-9;

class Own final : public ShapedPressure {
 public:
  using Shape = std::function<double(double, double)>;
  Own(JointKind kind, std::string name, Shape shape, double largest = 2.5)
      : ShapedPressure(kind, std::move(name), largest),
        shape_(std::move(shape)) {}

 private:
  double shape(double theta, double half_angle) const noexcept override {
    return shape_(theta, half_angle);
  }
  Shape shape_;
};

double falling(double t, double theta0) {
  return (1 - t / theta0) * (1 + t / theta0);
}
// 3/4: between Hertz' edge and a flat one; flat_top: as it says; cone: linear
// from the centre to the edge.
double three_quarters(double t, double theta0) {
  return 7 * std::pow(falling(t, theta0), 0.75);
}
double flat_top(double t, double theta0) {
  return std::sqrt(1 - std::pow(t / theta0, 8));
}
double parabola(double t, double theta0) { return falling(t, theta0); }
double cone(double t, double theta0) { return 1 - t / theta0; }

std::vector<Own> own_laws(JointKind kind) {
  return {Own(kind, "three quarters", three_quarters),
          Own(kind, "flat top", flat_top), Own(kind, "parabola", parabola),
          Own(kind, "cone", cone)};
}

std::string label(double theta0_deg, double alpha_deg) {
  return "theta0 = " + std::to_string(theta0_deg) +
         " deg, a = " + std::to_string(alpha_deg) + " deg";
}

// Poles outside, inside, near the edge, near the centre; two.
TEST(OwnPressure, FrictionAgreesWithQuadratureOfTheDefinition) {
  for (const Own& law : own_laws(JointKind::ball)) {
    AccuracyReport report(law.name(), budget);
    for (const auto& [theta0_deg, alpha_deg] : {std::array{1e-3, 20.0},
                                                {5.0, 20.0},
                                                {30.0, 45.0},
                                                {30.0, 60.01},
                                                {45.0, 89.0},
                                                {60.0, 50.0},
                                                {85.0, 20.0},
                                                {100.0, 40.0},
                                                {115.0, 10.0},
                                                {120.0, 30.0}}) {
      const SlipAxis axis = SlipAxis::from_degrees(alpha_deg);
      const auto expected = reference::quadrature_friction_integrals(
          law, theta0_deg * degree, axis, 1e-10);
      const auto computed = friction_integrals(law, theta0_deg * degree, axis);
      const std::string row = label(theta0_deg, alpha_deg);
      add_integrals(report, computed, expected.value, row);
    }
  }
}

// The same pressure by its shape and by its expansion.
template <class Law>
void check_against(const std::string& name) {
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    const Law known(kind);
    const Own own(kind, name, [&](double t, double theta0) {
      return 0.3 * theta0 * known.pressure(t, theta0);
    });
    AccuracyReport report(name, budget);
    AccuracyReport slopes(name + ", slopes", 1e-6);
    for (const double theta0_deg : {1e-4, 1.0, 20.0, 89.0, 95.0, 119.0}) {
      const double theta0 = theta0_deg * degree;
      const std::string row = label(theta0_deg, 0);
      report.add(own.peak(theta0), known.peak(theta0), row + ", peak");
      report.add(own.mean(theta0), known.mean(theta0), row + ", mean");
      report.add(own.force_ratio(theta0), known.force_ratio(theta0), row);
      for (const double share : {0.0, 0.3, 0.999}) {
        report.add(own.pressure(-share * theta0, theta0),
                   known.pressure(share * theta0, theta0), row + ", p");
      }
      for (const double share : {1e-3, -0.3, 0.999}) {
        slopes.add(own.slope(share * theta0, theta0),
                   known.slope(share * theta0, theta0), row + ", slope");
      }
      // The last two with a pole just outside and inside the edge.
      for (const double a_deg :
           {0.1, 5.0, 40.0, 80.0, 89.99, 90 - theta0_deg * (1 + 1e-6),
            90 - theta0_deg * (1 - 1e-6)}) {
        if (kind == JointKind::pin) continue;
        const SlipAxis axis = SlipAxis::from_degrees(a_deg);
        const std::string at = label(theta0_deg, a_deg);
        add_triple(report, friction_integrals(own, theta0, axis).coefficient,
                   friction_integrals(known, theta0, axis).coefficient, at);
        add_triple(report,
                   viscous_friction_integrals(own, theta0, axis).coefficient,
                   viscous_friction_integrals(known, theta0, axis).coefficient,
                   at + ", viscous");
      }
    }
  }
}

TEST(OwnPressure, IsTheLawOfTheSameShape) {
  check_against<CosinePressure>("cosine");
  check_against<SqrtTanPressure>("sqrt_tan");
  check_against<SqrtThetaPressure>("sqrt_theta");
}

TEST(OwnPressure, BatchIsTheScalarCall) {
  const Own law(JointKind::ball, "flat top", flat_top);
  std::array<std::vector<double>, 3> in;
  for (int i = 0; i < 150; ++i) {
    const SlipAxis axis = SlipAxis::from_degrees(0.6 * i);
    in[0].push_back(0.014 * i);
    in[1].push_back(axis.sin);
    in[2].push_back(axis.cos);
  }
  std::vector<double> sliding(150), normal(150);
  FrictionBatchOutput out{};
  out.sliding = sliding;
  out.normal = normal;
  friction_integrals(law, {in[0], in[1], in[2]}, out);
  for (std::size_t i = 0; i < 150; ++i) {
    const FrictionIntegrals one =
        friction_integrals(law, in[0][i], {in[1][i], in[2][i]});
    EXPECT_EQ(sliding[i], one.coefficient.sliding) << i;
    EXPECT_EQ(normal[i], one.normal) << i;
  }
}

// The instruction set of the process makes the numbers at every door.
TEST(InstructionSets, AreThoseOfTheProcess) {
  const ElasticPair steel({2e11, 0.3}, {2e11, 0.3});
  const auto ball = JointKind::ball;
  const std::array<std::shared_ptr<const PressureLaw>, 3> laws = {
      std::make_shared<CosinePressure>(ball),
      std::make_shared<SqrtThetaPressure>(ball),
      std::make_shared<Own>(ball, "flat top", flat_top)};
  // Count over all laws: compilers that do not contract leave some alike.
  int differences = 0;
  for (const auto& law : laws) {
    const JointContact contact(JointGeometry::ball(0.02, 20e-6), steel,
                               FrictionLaw(0.1),
                               make_half_angle_law("tanh", ball, steel), law);
    for (int i = 1; i < 60; ++i) {
      const double theta0 = 0.03 * i;
      const SlipAxis axis = SlipAxis::from_degrees(1.4 * i);
      double baseline = 0;
      for (const auto set : supported_instruction_sets()) {
        const contact::detail::WithInstructionSet with(set);
        const FrictionTriple direct =
            friction_integrals(*law, theta0, axis).coefficient;
        const FrictionTriple found =
            contact.integrals(theta0, axis).coefficient;
        EXPECT_EQ(found.sliding, direct.sliding) << law->name();
        EXPECT_EQ(found.spinning, direct.spinning) << law->name();
        double force = 0;
        FrictionBatchOutput out{};
        out.force = {&force, 1};
        friction_integrals(*law, {{&theta0, 1}, {&axis.sin, 1}, {&axis.cos, 1}},
                           out);
        if (law != laws[0]) {
          EXPECT_EQ(force, direct.force) << law->name();
        }
        if (set == InstructionSet::baseline) baseline = direct.force;
        differences += direct.force != baseline;
      }
    }
  }
  if (supported_instruction_sets().size() > 1) {
    EXPECT_GT(differences, 0);
  }
}

TEST(OwnPressure, EndsAndNan) {
  const Own law(JointKind::ball, "cone", cone);
  EXPECT_EQ(law.peak(0), infinity);
  EXPECT_EQ(law.mean(0), infinity);
  EXPECT_EQ(law.pressure(0, 0), infinity);
  EXPECT_EQ(law.force_ratio(0), 1);
  EXPECT_EQ(law.slope(0, 1), 0);
  EXPECT_EQ(law.pressure(1.1, 1), 0);
  EXPECT_EQ(law.slope(1.1, 1), 0);
  const auto none = friction_integrals(law, 0, SlipAxis::from_degrees(40));
  EXPECT_EQ(none.coefficient.sliding, 1);
  for (const double bad : {nan, -0.1, 2.6}) {
    EXPECT_TRUE(all_nan({law.peak(bad), law.force_ratio(bad),
                         law.pressure(0.1, bad), law.slope(0.1, bad)}));
    const auto r = friction_integrals(law, bad, SlipAxis::from_degrees(30));
    EXPECT_TRUE(all_nan({r.coefficient.force, r.normal}));
  }
  const double x = 0.5;
  double slope = 0;
  law.edge_slopes(nan, {&x, 1}, {&slope, 1});
  EXPECT_TRUE(all_nan({slope, law.pressure(nan, 1)}));
  EXPECT_EQ(
      Own(JointKind::ball, "wide", cone, 175 * degree).largest_half_angle(),
      175 * degree);
  for (const double wide : {3.0544, 3.1}) {
    EXPECT_ERROR(Own(JointKind::ball, "far", cone, wide),
                 "pressure law far: largest_half_angle = " +
                     detail::message("{}", wide) + " must be in (0, 175 deg]");
  }
}

TEST(OwnPressure, NothingAllocatesAfterTheFirstCall) {
  const Own law(JointKind::ball, "cone", cone);
  const SlipAxis axis = SlipAxis::from_degrees(40);
  friction_integrals(law, 1, axis);
  const std::size_t before = allocation_count();
  friction_integrals(law, 1.1, axis);
  law.slope(0.3, 1);
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace contact::test::own_pressure_test
