#include "libcontact/conforming/layer_compliance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "libcontact/conforming/kernel/ball_kernel.hpp"
#include "libcontact/conforming/wall_harmonics.hpp"
#include "libcontact/pair/layers.hpp"
#include "support/accuracy_report.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"

namespace contact::test::layer_compliance_test {
namespace {

using detail::HarmonicCompliance;
using detail::LayerCompliance;
using Side = LayerCompliance::Side;

// A body of the table: radius 1, moduli in units of the surface layer's.
LayeredBody body_of(const ReferenceTable::Row& row) {
  const std::string& end = row.text("end");
  LayeredBody body{{},
                   end == "rigid"  ? Backing::rigid()
                   : end == "free" ? Backing::held()
                                   : Backing::medium({row.value("end_E"),
                                                      row.value("end_nu")})};
  for (const std::string layer : {"La", "Lb"}) {
    if (row.text(layer + "_t").empty()) continue;
    body.layers.push_back(
        {row.value(layer + "_t"),
         {row.value(layer + "_E"), row.value(layer + "_nu")}});
  }
  return body;
}

JointKind kind_of(const ReferenceTable::Row& row) {
  return row.text("kind") == "ball" ? JointKind::ball : JointKind::pin;
}

Side side_of(const ReferenceTable::Row& row) {
  return row.text("side") == "inner" ? Side::inner : Side::outer;
}

TEST(LayerCompliance, MatchesTheReference) {
  const ReferenceTable table("walls/cn_values.csv");
  AccuracyReport report("c_n", 1e-10);  // asked for
  for (const ReferenceTable::Row row : table) {
    const double modulus = row.value("La_E");
    const LayerCompliance compliance(kind_of(row), side_of(row), body_of(row),
                                     1, modulus);
    const int n = static_cast<int>(row.value("n"));
    report.add(4 * compliance(n).total, row.value("C_n*La_E/rho"),
               row.label() + " n=" + std::to_string(n));
  }
}

constexpr Side sides[] = {Side::inner, Side::outer};
constexpr double degrees_of_poisson[] = {0, 0.3, 0.499, 0.5};

TEST(LayerCompliance, LayersOfOneMaterialAreNone) {
  // Three thicknesses, on a medium of the same material.
  for (const JointKind kind : kinds) {
    for (const Side side : sides) {
      for (const double nu : degrees_of_poisson) {
        const Material material{3, nu};
        const LayeredBody plain{{}, Backing::medium(material)};
        const LayeredBody layered{
            {{0.01, material}, {0.2, material}, {0.03, material}},
            Backing::medium(material)};
        const LayerCompliance expected(kind, side, plain, 1, 2);
        const LayerCompliance compliance(kind, side, layered, 1, 2);
        for (const int n : {0, 1, 2, 3, 10, 100, 1000, 100000}) {
          const HarmonicCompliance c = compliance(n);
          const double total = expected(n).total;
          EXPECT_EQ(expected(n).correction, 0);
          if (std::isnan(total)) {  // a pin in an infinite hole
            EXPECT_EQ(n, 1);
            EXPECT_TRUE(std::isnan(c.total));
            continue;
          }
          // c_0 and c_1 are 0 for nu = 1/2: rounding of the displacement.
          EXPECT_NEAR(c.total, total, 1e-12 * total + 1e-16) << n << " " << nu;
          EXPECT_NEAR(c.correction, 0, 1e-12 * total + 1e-16) << n << " " << nu;
        }
      }
    }
  }
}

TEST(LayerCompliance, ARigidBodyDoesNotGiveWay) {
  const LayeredBody rigid{{}, Backing::rigid()};
  for (const Side side : sides) {
    const LayerCompliance compliance(JointKind::ball, side, rigid, 1, 1);
    for (const int n : {0, 1, 2, 50}) {
      EXPECT_EQ(compliance(n).total, 0);
      EXPECT_EQ(compliance(n).correction, 0);
    }
    EXPECT_EQ(compliance.corrected(), 0);
  }
}

TEST(LayerCompliance, TailIsThatOfAFlatLayer) {
  // n c_n -> F(x), x = n ln(1 + t/rho), over the value of a half-space, for n
  // large and t/rho small: the difference from the sphere falls like 1/n.
  const double thickness = 1e-4;
  for (const JointKind kind : kinds) {
    for (const Side side : sides) {
      for (const double nu : {0.2, 0.5}) {
        const double k = 3 - 4 * nu;
        const auto rigid = [k](double x) {
          return (2 * k * std::sinh(2 * x) - 4 * x) /
                 (2 * k * std::cosh(2 * x) + 1 + k * k + 4 * x * x);
        };
        const auto free = [](double x) {
          return (std::sinh(2 * x) + 2 * x) /
                 (std::cosh(2 * x) - 1 - 2 * x * x);
        };
        for (const bool is_free : {false, true}) {
          const LayeredBody body{{{thickness, {1, nu}}},
                                 is_free ? Backing::held() : Backing::rigid()};
          const LayerCompliance compliance(kind, side, body, 1, 1);
          const double half_space = (1 - nu) * (1 + nu) / 2;
          for (const int n : {5000, 20000, 39000, 41000, 60000}) {
            const double x = n * thickness;
            const double f = is_free ? free(x) : rigid(x);
            const HarmonicCompliance c = compliance(n);
            EXPECT_NEAR(n * c.total / half_space, f, 2e-3 * f) << n;
            // The correction itself, where it is tiny.
            EXPECT_NEAR(n * c.correction / half_space, f - 1,
                        0.02 * std::abs(f - 1) + 3e-4)
                << n;
          }
        }
      }
    }
  }
}

TEST(LayerCompliance, TheCorrectionKeepsItsDigits) {
  // Both sides of the switch between its two formulas, n width = 4: as a
  // ratio to the asymptotic decay it is smooth in the thickness.
  for (const JointKind kind : kinds) {
    for (const double nu : {0.0, 0.3, 0.5}) {
      const auto correction = [&](double width) {
        const LayeredBody body{{{std::expm1(width), {1, nu}}},
                               Backing::rigid()};
        return LayerCompliance(kind, Side::outer, body, 1, 1)(40).correction;
      };
      const double step = 1e-5;
      const double below = correction(0.1 - step);
      const double at = correction(0.1);
      const double above = correction(0.1 + step);
      // Second difference: (80 step)^2 of the value, and the rounding of the
      // formula by a difference, 1e-13 of c_n = 2e3 times the value.
      EXPECT_NEAR((below + above) / 2, at, 2e-6 * std::abs(at)) << nu;
      EXPECT_NEAR(std::sqrt(below * above), std::abs(at), 2e-8 * std::abs(at))
          << nu;
    }
  }
}

TEST(LayeredPair, SaysWhatIsWrong) {
  const Material steel{210e9, 0.3};
  const LayeredBody seat{{}, Backing::medium(steel)};
  const auto message = [](double radius, const LayeredBody& inner,
                          const LayeredBody& outer) {
    return error_message([&] { LayeredPair(radius, inner, outer); });
  };
  const auto coated = [&](double thickness) {
    return LayeredBody{{{thickness, steel}}, Backing::medium(steel)};
  };
  EXPECT_EQ(message(0.01, seat, seat), "(no error)");
  EXPECT_EQ(message(0.01, seat, coated(0)),
            "wall layer 1: thickness = 0 must be above 0 m");
  EXPECT_EQ(message(0.01, coated(-1e-3), seat),
            "coating 1: thickness = -0.001 must be above 0 m");
  EXPECT_EQ(message(0.01, coated(9e-8), seat),
            "coating 1: thickness = 9e-08 must be at least 1e-5 of the radius "
            "of 0.01 m");
  EXPECT_EQ(message(0.01, coated(0.01), seat),
            "coatings: thickness = 0.01 must be below the radius of 0.01 m");
  EXPECT_EQ(message(0, seat, seat),
            "layered pair: radius = 0 must be above 0 m");
  EXPECT_EQ(message(0.01, {{}, Backing::held()}, seat),
            "coatings: backing = held must be rigid or a material");
  EXPECT_EQ(message(0.01, seat, {{}, Backing::held()}),
            "wall: backing = held requires at least one layer");
  EXPECT_EQ(message(0.01, seat, {{{0.001, {infinity, 0.3}}}, Backing::rigid()}),
            "wall layer 1: youngs_modulus = inf must be finite; a rigid body "
            "is a backing");
  EXPECT_EQ(message(0.01, seat,
                    {{{0.001, steel}, {0.001, {1e9, 0.6}}}, Backing::rigid()}),
            "wall layer 2: poissons_ratio = 0.6 must be 0 to 0.5");
  EXPECT_EQ(message(0.01, {{}, Backing::rigid()}, {{}, Backing::rigid()}),
            "elastic pair: rigid inner body conflicts with rigid outer body");
}

// A ring bends as one, of however many layers it is.
TEST(WallHarmonics, AFreeRingIsAllOfItsLayers) {
  const Layer thin{0.1, {1, 0.3}};
  const Layer thick{0.3, {2, 0.3}};
  const LayeredBody rigid{{}, Backing::rigid()};
  const auto ring = [&](const Backing& backing) {
    return detail::free_ring_thickness(
        {2, rigid, {{thick, thin, thin}, backing}});
  };
  EXPECT_DOUBLE_EQ(ring(Backing::held()), 0.25);
  EXPECT_EQ(ring(Backing::rigid()), infinity);
}

}  // namespace
}  // namespace contact::test::layer_compliance_test
