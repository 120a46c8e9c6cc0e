// Free growth of layered bodies, against a table and closed forms.
#include "libcontact/joint/thermal_growth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/accuracy_report.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"

namespace contact::test::thermal_growth_test {
namespace {

using detail::free_growth;
using Side = detail::LayerCompliance::Side;

Material material(double modulus, double nu, double expansion) {
  return {modulus, nu, "", infinity, expansion};
}

// The table warms each part by another amount: here all are warmed by 1 K.
Material part(const ReferenceTable::Row& row, const std::string& name,
              bool rigid = false) {
  return material(rigid ? infinity : row.value(name + "_E"),
                  rigid ? 0 : row.value(name + "_nu"),
                  row.value(name + "_alpha") * row.value(name + "_dT"));
}

LayeredBody outer_of(const ReferenceTable::Row& row) {
  LayeredBody body{{}, Backing::held()};
  if (row.text("end") != "free") {
    body.backing =
        Backing::medium(part(row, "end", row.text("end") == "rigid"));
  }
  for (const std::string layer : {"La", "Lb"}) {
    if (!row.given(layer + "_t")) continue;
    body.layers.push_back({row.value(layer + "_t"), part(row, layer)});
  }
  return body;
}

TEST(ThermalGrowth, MatchesTheReference) {
  const ReferenceTable table("preload/thermal.csv");
  // The table has 14 digits.
  AccuracyReport outer("U_outer", 1e-13);
  AccuracyReport inner("U_inner", 1e-13);
  for (const ReferenceTable::Row row : table) {
    const JointKind kind =
        row.text("kind") == "ball" ? JointKind::ball : JointKind::pin;
    const AxialGrowth axial =
        row.text("axial") == "held" ? AxialGrowth::held : AxialGrowth::free;
    const double rho = row.value("rho");
    outer.add(free_growth(kind, Side::outer, outer_of(row), rho, 1, axial),
              row.value("U_outer"), row.label());
    inner.add(free_growth(kind, Side::inner, part(row, "pin"), rho, 1, axial),
              row.value("U_inner"), row.label());
  }
}

const Material steel = material(2.1e11, 0.3, 11.5e-6);

// A body of one material grows alike everywhere, however it is divided.
TEST(ThermalGrowth, OneMaterialGrowsByItsStrain) {
  const double rho = 0.02;
  const double warming = 60;
  const LayeredBody bodies[] = {
      steel,
      {{{0.001, steel}, {0.003, steel}}, Backing::medium(steel)},
      {{{0.001, steel}, {0.003, steel}},
       Backing::medium(material(infinity, 0, 11.5e-6))}};
  for (const JointKind kind : kinds) {
    for (const Side side : {Side::inner, Side::outer}) {
      for (const LayeredBody& body : bodies) {
        EXPECT_NEAR(
            free_growth(kind, side, body, rho, warming, AxialGrowth::free) /
                (11.5e-6 * warming * rho),
            1, 1e-14);
      }
    }
    const LayeredBody ring{{{0.001, steel}, {0.003, steel}}, Backing::held()};
    EXPECT_NEAR(
        free_growth(kind, Side::outer, ring, rho, warming, AxialGrowth::free) /
            (11.5e-6 * warming * rho),
        1, 1e-13);
  }
  // Held along its axis it widens by Poisson's ratio more.
  EXPECT_NEAR(free_growth(JointKind::pin, Side::inner, steel, rho, warming,
                          AxialGrowth::held) /
                  (1.3 * 11.5e-6 * warming * rho),
              1, 1e-14);
}

// A thin liner in a shell that does not grow can only grow inwards:
// (1 + nu)/(1 - nu) of its strain times its thickness.
TEST(ThermalGrowth, ThinLinerGrowsInwards) {
  const double rho = 0.025;
  for (const double thickness : {1e-5, 1e-6}) {
    const LayeredBody liner{{{thickness, material(5e8, 0.4, 135e-6)}},
                            Backing::medium(material(infinity, 0, 0))};
    for (const JointKind kind : kinds) {
      const double expected = -1.4 / 0.6 * 135e-6 * 30 * thickness;
      EXPECT_NEAR(
          free_growth(kind, Side::outer, liner, rho, 30, AxialGrowth::free) /
              expected,
          1, 3 * thickness / rho)
          << thickness;
    }
  }
}

// A coat on a core that does not grow: Lame's solution of the ball, with
// U = 0 at the core and S = 0 outside, by hand.
TEST(ThermalGrowth, CoatOnARigidCore) {
  const double rho = 0.02;
  const double core = 0.015;
  const double nu = 0.3;
  const double strain = 11.5e-6 * 50;
  // W = a r + b/r^2, S ~ (1 + nu) a - 2 (1 - 2 nu) b/r^3 = 0 at rho,
  // W = -e core at the core.
  const double cube = std::pow(rho / core, 3);
  const double b =
      -strain * core /
      (2 * (1 - 2 * nu) / (1 + nu) / cube / core / core + 1 / core / core);
  const double a = 2 * (1 - 2 * nu) / (1 + nu) * b / std::pow(rho, 3);
  const double expected = strain * rho + a * rho + b / rho / rho;
  const LayeredBody body{{{rho - core, steel}},
                         Backing::medium(material(infinity, 0, 0))};
  EXPECT_NEAR(free_growth(JointKind::ball, Side::inner, body, rho, 50,
                          AxialGrowth::free) /
                  expected,
              1, 1e-13);
}

TEST(ThermalGrowth, AsksForCoefficientsOnlyWhereItIsWarmer) {
  const Material plain{1e9, 0.4, "liner"};
  const LayeredBody body{{{0.001, steel}, {0.002, plain}}, Backing::held()};
  const auto growth = [&](double warming) {
    return free_growth(JointKind::ball, Side::outer, body, 0.02, warming,
                       AxialGrowth::free);
  };
  EXPECT_EQ(growth(0), 0);
  EXPECT_ERROR(growth(10),
               "a temperature requires thermal_expansion of the wall layer 2 "
               "liner");
}

}  // namespace
}  // namespace contact::test::thermal_growth_test
