#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/conforming/gap/ball_gap.hpp"
#include "libcontact/conforming/gap/pin_gap.hpp"
#include "libcontact/conforming/wall_harmonics.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "support/accuracy_report.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"
#include "support/wall.hpp"

// ExactLaw of joints without clearance and with interference.
namespace contact::test::interference_test {
namespace {

using detail::BallGap;
using detail::PinGap;
using detail::SignedContact;

bool has_layers(const LayeredPair& pair) {
  return std::isfinite(pair.relative_thickness());
}

std::unique_ptr<const ExactLaw> law_of(JointKind kind,
                                       const LayeredPair& pair) {
  return has_layers(pair)
             ? std::make_unique<const ExactLaw>(kind, pair)
             : std::make_unique<const ExactLaw>(kind, pair.surfaces());
}

void compare_with_rows(JointKind kind) {
  const bool is_pin = kind == JointKind::pin;
  // Through the table: 1e-7 for homogeneous bodies and walls from 0.1 radii,
  // 5e-6 for thinner ones.
  AccuracyReport angle("theta0", 1e-7);
  AccuracyReport thin("theta0, thin walls", 5e-6);
  AccuracyReport shift("shift", 1e-7);
  AccuracyReport stiffness("stiffness", 1e-7);
  // Rows of one pair of bodies are adjacent.
  std::optional<LayeredPair> last;
  std::unique_ptr<const HalfAngleLaw> shared;
  for (const ReferenceTable::Row row :
       ReferenceTable("preload/preload_" + to_string(kind) + ".csv")) {
    const LayeredPair pair = test::reference_pair(row);
    if (!last || !(pair == *last)) {
      shared = law_of(kind, pair);
      last = pair;
    }
    const HalfAngleLaw& law = *shared;
    const std::string& state = row.text("state");
    const std::string& inverse = row.text("inverse_parameter");
    const double rho = row.value("rho");
    const double load_parameter = state == "zero"   ? infinity
                                  : inverse.empty() ? -0.0
                                  : is_pin
                                      ? 1 / (2 * row.value("inverse_parameter"))
                                      : 1 / row.value("inverse_parameter");
    const HalfAngleResult result = law.half_angle(load_parameter);
    EXPECT_EQ(result.status, Status::ok) << row.label();
    const double expected = row.value("theta0_deg") * degree;
    (pair.relative_thickness() < 0.1 ? thin : angle)
        .add(result.half_angle, expected, row.label());
    if (state == "closed") {
      EXPECT_EQ(result.half_angle, pi) << row.label();
    }
    if (state == "clearance") continue;
    const ContactApproach solved = law.shift(result.half_angle);
    if (row.text("stiffness").empty()) {
      EXPECT_TRUE(std::isnan(solved.approach)) << row.label();
      EXPECT_TRUE(std::isnan(solved.stiffness)) << row.label();
      continue;
    }
    const double modulus = pair.surfaces().effective_modulus();
    const double load = row.value("load");
    const double k1 =
        load * (is_pin ? 4 / (pi * modulus) : 3 / (pi * rho * modulus));
    shift.add(solved.approach * k1, row.value("shift"), row.label());
    stiffness.add(solved.stiffness * modulus * (is_pin ? 1 : rho),
                  row.value("stiffness"), row.label());
  }
}

TEST(Interference, IsThatOfTheReference) {
  for (const JointKind kind : kinds) compare_with_rows(kind);
}

// Homogeneous pairs and walls, thick, thin and free outside.
std::vector<LayeredPair> pairs() {
  std::vector<LayeredPair> all;
  for (const double ratio : {0.0, 1.0, 20.0, infinity}) {
    all.push_back(detail::without_layers(
        ElasticPair::from_modulus_ratio(ratio, 0.3, 0.4)));
  }
  for (const test::Wall& wall : {test::Wall{1, 0.45, true},
                                 {0.3, 0.4, false},
                                 {0.1, 0.3, true},
                                 {0.1, 0.49, false},
                                 {0.03, 0.4, false}}) {
    all.push_back(wall.pair());
  }
  return all;
}

template <class Gap>
void compare_with_solver(JointKind kind) {
  AccuracyReport load("x + c_0 at theta0", 1e-7);
  AccuracyReport thin("x + c_0 at theta0, thin walls", 5e-6);
  AccuracyReport back("theta0 -> load -> theta0", 1e-12);
  AccuracyReport slope("log_slope", 1e-6);
  const double unit = kind == JointKind::pin ? 0.5 : pi / 2;
  for (const LayeredPair& pair : pairs()) {
    const auto made = law_of(kind, pair);
    const ExactLaw& law = *made;
    const Gap gap(pair, 64);
    EXPECT_NEAR(unit / law.closing_load(), -gap.mean_compliance(),
                1e-14 * gap.mean_compliance());
    // The results are smooth at eps = 0 and where the contact closes.
    const double limit = law.limit_half_angle();
    EXPECT_EQ(law.half_angle(infinity).half_angle, limit);
    EXPECT_NEAR(law.half_angle(-infinity).half_angle, limit, 1e-7 * limit);
    EXPECT_EQ(law.half_angle(-0.0).half_angle, pi);
    EXPECT_EQ(law.half_angle(law.closing_load() * (1 - 1e-12)).half_angle, pi);
    for (const double opening : {1e-4, 0.01, 0.1, 0.3, 0.7, 1.1, 1.3}) {
      const double theta0 = pi - opening;
      if (theta0 < std::max(limit, Gap::smallest_half_angle)) continue;
      const std::string label = to_string(kind) + " t " +
                                std::to_string(pair.relative_thickness()) +
                                " psi " + std::to_string(opening);
      const double tabulated = law.load_parameter(theta0).load_parameter;
      (pair.relative_thickness() < 0.1 ? thin : load)
          .add(unit / tabulated + gap.mean_compliance(),
               gap.solve(opening).beyond_closure, label);
      const HalfAngleResult result = law.half_angle(tabulated);
      back.add(result.half_angle, theta0, label);
      if (opening < 0.1) continue;
      // Truncated like (h/psi^2)^2, rounded like 1e-13/h.
      const double h = 1e-6;
      slope.add(result.log_slope,
                std::log(law.half_angle(tabulated * (1 + h)).half_angle /
                         law.half_angle(tabulated * (1 - h)).half_angle) /
                    (2 * h),
                label);
    }
  }
}

TEST(Interference, TableIsTheSolverOfPins) {
  compare_with_solver<PinGap>(JointKind::pin);
}

TEST(Interference, TableIsTheSolverOfBalls) {
  compare_with_solver<BallGap>(JointKind::ball);
}

// d(D/R)/d theta0 = -(eps/R^2) d(S R)/d theta0, and dR/dD, by differences
// along a joint of constant interference.
TEST(Interference, ShiftAndStiffnessBelongTogether) {
  AccuracyReport stiffness("stiffness, by differences of the shift", 1e-6);
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    const LayeredPair pair = test::Wall{0.3, 0.4, false}.pair();
    const ExactLaw law(kind, pair);
    const double unit = kind == JointKind::pin ? pi / 4 : pi / 3;
    // R over unit E is K_1; eps is constant.
    const auto shift = [&](double load) {
      return load / unit * law.shift(law.half_angle(load).half_angle).approach;
    };
    for (const double share : {1.05, 1.5, 3.0, 20.0}) {
      const double load = share * law.closing_load();
      const double h = 1e-4;
      const double expected =
          (shift(load * (1 + h)) - shift(load * (1 - h))) / (2 * h * load);
      stiffness.add(1 / law.shift(law.half_angle(load).half_angle).stiffness,
                    expected, to_string(kind) + " " + std::to_string(share));
    }
  }
}

TEST(Interference, OtherLawsAndLoadingsKnowNone) {
  const ElasticPair pair = ElasticPair::from_modulus_ratio(1, 0.3, 0.3);
  const ExactLaw back(JointKind::pin, pair, InnerLoading::back(20 * degree));
  EXPECT_EQ(back.half_angle(-1).status, Status::out_of_range);
  EXPECT_TRUE(std::isnan(back.closing_load()));
  for (const char* name : {"hertz", "arctan", "tanh", "fitted"}) {
    const auto law = make_half_angle_law(name, JointKind::pin, pair);
    EXPECT_EQ(law->half_angle(-1).status, Status::out_of_range) << name;
    EXPECT_TRUE(std::isnan(law->closing_load())) << name;
    EXPECT_TRUE(std::isnan(law->shift(2).approach)) << name;
  }
  // An incompressible liner between rigid bodies.
  const LayeredPair liner(1, {{}, Backing::rigid()},
                          {{{0.3, {1, 0.5}}}, Backing::rigid()});
  const ExactLaw incompressible(JointKind::ball, liner);
  EXPECT_TRUE(std::isnan(incompressible.closing_load()));
  EXPECT_EQ(incompressible.half_angle(-1).status, Status::out_of_range);
  for (const double not_a_number : {nan, -nan}) {
    const ExactLaw law(JointKind::ball, pair);
    EXPECT_EQ(law.half_angle(not_a_number).status, Status::out_of_range);
    EXPECT_TRUE(std::isnan(law.half_angle(not_a_number).half_angle));
  }
}

}  // namespace
}  // namespace contact::test::interference_test
