// Stiffness of contacts that stick all over, against a program of its own
// (data/reference/presliding), closed limits and the exact contact.
#include "libcontact/conforming/stuck/stuck.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "libcontact/base/units.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/joint/joint.hpp"
#include "support/accuracy_report.hpp"
#include "support/reference_table.hpp"

namespace contact::test::stuck_test {
namespace {

using detail::stuck_stiffness;
using detail::StuckStiffness;

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

LayeredBody solid(double modulus, double nu) {
  return {{}, Backing::medium({modulus, nu})};
}
LayeredBody lined(double thickness, double modulus, double nu,
                  Backing behind = Backing::rigid()) {
  return {{{thickness, {modulus, nu}}}, std::move(behind)};
}
const LayeredBody rigid{{}, Backing::rigid()};

// The pairs of stuck.csv, radius 1.
LayeredPair pair_of(const std::string& name) {
  if (name == "similar") return {1, solid(1, 0.3), solid(1, 0.3)};
  if (name == "rigid_inner") return {1, rigid, solid(1, 0.3)};
  if (name == "cup") return {1, rigid, lined(0.5, 1, 0.4)};
  if (name == "liner.05") return {1, rigid, lined(0.05, 1, 0.4)};
  if (name == "liner.02inc") return {1, rigid, lined(0.02, 1, 0.49)};
  if (name == "liner_on_medium") {
    return {1, solid(60, 0.3), lined(0.03, 1, 0.4, Backing::medium({60, 0.3}))};
  }
  EXPECT_EQ(name, "bush");
  return {1, solid(2, 0.3), lined(0.2, 1, 0.34, Backing::medium({2, 0.3}))};
}

TEST(Stuck, StiffnessesAreThoseOfTheReference) {
  // The reference's own change with fewer unknowns is up to 2.1e-4.
  AccuracyReport load("K_load", 5e-4);
  AccuracyReport held("K_held", 5e-4);
  AccuracyReport spin("K_spin", 5e-4);
  AccuracyReport free("R/D", 5e-4);
  for (const auto& row : ReferenceTable("presliding/stuck.csv")) {
    const JointKind kind =
        row.text("kind") == "ball" ? JointKind::ball : JointKind::pin;
    const LayeredPair pair = pair_of(row.text("case"));
    const double unit = pair.surfaces().effective_modulus();
    const double angle = row.value("theta0_deg") * degree;
    const StuckStiffness k = stuck_stiffness(kind, pair, angle);
    const std::string label =
        row.label() + ", theta0 " + row.text("theta0_deg");
    load.add(unit * k.load(), row.value("K_fixed_load"), label);
    if (row.given("K_ww_centre_held")) {
      held.add(unit * k.turn, row.value("K_ww_centre_held"), label);
    }
    if (kind == JointKind::ball) {
      spin.add(unit * k.spin, row.value("K_spin"), label);
    }
    free.add(unit * k.frictionless, row.value("R_over_D_frictionless"), label);
  }
}

// Small contacts: a flat punch that is shifted, rocks or spins.
TEST(Stuck, SmallContactsAreHalfSpaces) {
  const LayeredPair pair(1, solid(1, 0.3), solid(1, 0.3));
  const double unit = pair.surfaces().effective_modulus();
  const double angle = 1 * degree;
  const double a = std::sin(angle);
  const double shear = 1 / 2.6;
  const double normal = 1 / (2 * (1 - 0.09));  // E*
  const StuckStiffness k = stuck_stiffness(JointKind::ball, pair, angle);
  const double mindlin = 8 * a / (2 * 1.7 / shear);
  // The references of rotation and curvature: 0.18 theta0 of Mindlin's.
  EXPECT_NEAR(unit * k.turn / mindlin, 1.0031, 5e-4);
  EXPECT_NEAR(unit * k.load() / (4.0 / 3 * normal * a * a * a), 1, 5e-4);
  EXPECT_NEAR(unit * k.spin / (16.0 / 3 * a * a * a * shear / 2), 1, 5e-4);
}

// A thin liner shears alone: G/t over the contact, to first order in t.
TEST(Stuck, ThinLinersShear) {
  const double angle = pi / 3;
  const double c = 0.5;
  const double across = 2.0 / 3 - c + c * c * c / 3;
  double spin[2];
  double held[2];
  double pin[2];
  const double thickness[] = {0.01, 0.005};
  for (int i = 0; i < 2; ++i) {
    const double t = thickness[i];
    const LayeredPair pair(1, rigid, lined(t, 1, 0.4));
    const double unit = pair.surfaces().effective_modulus() * 2.8 * t;
    const StuckStiffness ball = stuck_stiffness(JointKind::ball, pair, angle);
    const StuckStiffness of_pin = stuck_stiffness(JointKind::pin, pair, angle);
    spin[i] = unit * ball.spin / (2 * pi * across) - 1;
    held[i] = unit * ball.turn / (pi * (2 * (1 - c) - across)) - 1;
    pin[i] = unit * of_pin.turn / (2 * angle) - 1;
  }
  // Measured by the reference at t = 0.01, to three digits.
  EXPECT_NEAR(spin[0], 0.034, 2e-3);
  EXPECT_NEAR(held[0], 0.029, 2e-3);
  EXPECT_NEAR(pin[0], 0.022, 2e-3);
  EXPECT_NEAR(spin[1] / spin[0], 0.5, 0.02);
  EXPECT_NEAR(held[1] / held[0], 0.5, 0.02);
  EXPECT_NEAR(pin[1] / pin[0], 0.5, 0.02);
}

// The first two are as summed over all 12,000 and 24,000 harmonics up to where
// a layer is a half-space, the last over 24,000.
TEST(Stuck, ThinLayersAreTheSumOfTheirHarmonics) {
  const auto on_steel = [&](double t) {
    return LayeredPair(1, solid(60, 0.3),
                       lined(t, 1, 0.4, Backing::medium({60, 0.3})));
  };
  struct Row {
    JointKind kind;
    LayeredPair pair;
    double angle, load, held, spin;
  };
  const Row rows[] = {
      {JointKind::ball, on_steel(0.002), 1, 12.4607726, 28.56599284,
       13.87855182},
      {JointKind::ball,
       {1, rigid, lined(0.001, 1, 0.49)},
       1.5,
       494.4631183,
       507.1396186,
       478.783394},
      {JointKind::pin, on_steel(0.001), 0.3, 0.9078426144, 8.453882403, 0}};
  for (const Row& row : rows) {
    const StuckStiffness k = stuck_stiffness(row.kind, row.pair, row.angle);
    EXPECT_NEAR(k.load() / row.load, 1, 5e-4);
    EXPECT_NEAR(k.turn / row.held, 1, 5e-4);
    if (row.spin > 0) {
      EXPECT_NEAR(k.spin / row.spin, 1, 5e-4);
    }
  }
}

// For narrow contacts one harmonic represents its neighbours: the numbers refer
// to sums over each, and the tolerance is twice the largest difference.
TEST(Stuck, NarrowContactsAreTheSumOfTheirHarmonics) {
  struct Row {
    JointKind kind;
    double thickness, angle_deg, load, held, spin;
  };
  const Row rows[] = {
      {JointKind::ball, 0.1, 1, 3.601245216e-06, 0.0146690173, 4.315535711e-06},
      {JointKind::ball, 0.01, 1, 6.586911428e-06, 0.02602462177,
       5.152108007e-06},
      {JointKind::ball, 0.001, 1, 4.982555937e-05, 0.1332195079,
       2.269063029e-05},
      {JointKind::ball, 0.001, 5, 0.01586225112, 1.942819685, 0.00997744978},
      {JointKind::pin, 0.001, 1, 0.002209403788, 3.675335186, 0},
      {JointKind::pin, 0.001, 5, 0.1242089298, 9.997723998, 0}};
  for (const Row& row : rows) {
    const LayeredPair pair(1, solid(70, 0.3), lined(row.thickness, 1, 0.4));
    const StuckStiffness k =
        stuck_stiffness(row.kind, pair, row.angle_deg * degree);
    EXPECT_NEAR(k.load() / row.load, 1, 1e-4);
    EXPECT_NEAR(k.turn / row.held, 1, 1e-4);
    if (row.spin > 0) {
      EXPECT_NEAR(k.spin / row.spin, 1, 1e-4);
    }
  }
}

// All round: both bodies twist as wholes.
TEST(Stuck, AllRoundIsClosed) {
  const LayeredPair pair(1, solid(1, 0.3), solid(1, 0.3));
  const double unit = pair.surfaces().effective_modulus() * 2.6;
  const double angle = 3.1;
  const StuckStiffness ball = stuck_stiffness(JointKind::ball, pair, angle);
  const double closed = 8 * pi / 3 / (1.0 / 7 + 1.0 / 3);
  EXPECT_NEAR(unit * ball.spin / closed, 1, 1e-3);
  EXPECT_NEAR(unit * ball.turn / closed, 1, 1e-3);
  const double pin = stuck_stiffness(JointKind::pin, pair, angle).turn;
  EXPECT_NEAR(unit * pin / (2 * pi / (1.0 / 6 + 0.5)), 1, 2e-3);
}

// Without shear the shift equals the exact contact's, R/D: another solver.
TEST(Stuck, FrictionlessShiftIsTheExactContact) {
  AccuracyReport report("R/D", 1e-4);
  for (const std::string name :
       {"hip_cocr_uhmwpe", "spherical_plain_bearing", "paper_example_1"}) {
    JointSpec spec =
        read_joint(CONTACT_DATA_DIR "/joints/" + name + ".toml").without_seat();
    spec.half_angle_law = "exact";
    spec.friction = FrictionLaw(0.1);
    const JointContact contact = spec.contact();
    const LayeredPair pair(spec.geometry.radius(), spec.inner, spec.outer);
    for (const double force : {1e3, 1e4, 5e4}) {
      const double angle = contact.half_angle(force).half_angle;
      const double unit =
          pair.surfaces().effective_modulus() * spec.geometry.radius();
      report.add(
          unit * stuck_stiffness(JointKind::ball, pair, angle).frictionless,
          force / contact.shift(force, angle),
          name + ", " + std::to_string(force));
    }
  }
}

// A layer of the body's own material changes nothing.
TEST(Stuck, LayersOfTheSameMaterialAreNotThere) {
  const LayeredPair plain(1, solid(1, 0.3), solid(2, 0.4));
  // Thick enough to be summed with as many terms.
  const LayeredPair cut(1, lined(0.4, 1, 0.3, Backing::medium({1, 0.3})),
                        lined(0.35, 2, 0.4, Backing::medium({2, 0.4})));
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    for (const double angle : {0.3, 1.0}) {
      const StuckStiffness a = stuck_stiffness(kind, plain, angle);
      const StuckStiffness b = stuck_stiffness(kind, cut, angle);
      EXPECT_NEAR(b.load() / a.load(), 1, 1e-10);
      EXPECT_NEAR(b.turn / a.turn, 1, 1e-10);
      if (kind == JointKind::ball) {
        EXPECT_NEAR(b.spin / a.spin, 1, 1e-10);
      }
    }
  }
}

TEST(Stuck, IsNanOutsideItsRange) {
  const LayeredPair pair(1, solid(1, 0.3), solid(1, 0.3));
  for (const double angle : {0.0, 0.0099, 3.11, std::nan("")}) {
    EXPECT_TRUE(
        std::isnan(stuck_stiffness(JointKind::ball, pair, angle).load()));
    EXPECT_TRUE(
        std::isnan(stuck_stiffness(JointKind::pin, pair, angle).frictionless));
  }
  const LayeredPair thin(1, rigid, lined(5e-4, 1, 0.4));
  EXPECT_TRUE(std::isnan(stuck_stiffness(JointKind::pin, thin, 1).turn));
  EXPECT_TRUE(std::isnan(stuck_stiffness(JointKind::pin, pair, 1).spin));
}

}  // namespace
}  // namespace contact::test::stuck_test
