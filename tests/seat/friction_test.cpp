#include "libcontact/seat/friction.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "libcontact/base/units.hpp"
#include "libcontact/seat/contact.hpp"
#include "support/accuracy_report.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"
#include "support/seat.hpp"

// Friction of contacts on seats that end, by harmonics, against plain sums of
// a program of its own.
namespace contact::test::friction_test {
namespace {

double unit_force(const SeatContact& seat) {
  return seat.unbounded().pair().effective_modulus() *
         seat.unbounded().geometry().radius() / 4;
}

Eigen::Vector3d vector(const ReferenceTable::Row& row,
                       const std::string& name) {
  return {row.value(name + "_x"), row.value(name + "_y"),
          row.value(name + "_z")};
}

// Force and moment of the four slip axes of row i, over the load, and the same
// of dS.
void compare(const ReferenceTable& friction, std::size_t i,
             const ReferenceTable::Row& row, const detail::SeatBasis& basis,
             const detail::SeatHarmonics& harmonics, AccuracyReport& to,
             AccuracyReport& area) {
  for (std::size_t k = 4 * i; k < 4 * i + 4; ++k) {
    const ReferenceTable::Row slip = friction[k];
    ASSERT_EQ(slip.text("id") + slip.text("load") + slip.text("dir_deg"),
              row.text("id") + row.text("load") + row.text("dir_deg"));
    const Eigen::Vector3d w = vector(slip, "w");
    const double load = row.value("load");
    const auto [f, m] = basis.dry(harmonics.pressure, w);
    to.add_error((f / load - vector(slip, "f")).norm(), slip.label());
    to.add_error((m / load - vector(slip, "m")).norm(), slip.label());
    const auto [fa, ma] = basis.dry(harmonics.area, w);
    area.add_error((fa - vector(slip, "fa")).norm(), slip.label());
    area.add_error((ma - vector(slip, "ma")).norm(), slip.label());
  }
}

TEST(SeatFriction, MatchesTheReference) {
  const ReferenceTable table("edges/edges_ball.csv");
  const ReferenceTable friction("edges/edges_ball_friction.csv");
  ASSERT_EQ(friction.size(), 4 * table.size());
  // Harmonics converge slowly for axes that pierce the contact beside a rim:
  // 7e-4 and 2.3e-3 there; elsewhere the error is the usual grid's.
  AccuracyReport many("f and m over the load, 130 degrees", 1e-3);
  AccuracyReport few("f and m over the load, 64 degrees", 3e-3);
  // The ends of the contact are known to a part of a cell, its area to 4e-2.
  AccuracyReport area("sums over the area, over the squared radius", 5e-2);
  const detail::SeatSums of_many(130), of_few(64);
  std::string id;
  std::unique_ptr<const SeatContact> seat;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const ReferenceTable::Row row = table[i];
    if (is_cut(row) || row.text("route") == "free") continue;
    if (row.text("id") != id) {
      id = row.text("id");
      seat = std::make_unique<const SeatContact>(joint_of(row), zone_of(row));
    }
    const SeatState state = seat->under(force_of(row));
    ASSERT_EQ(state.status, SeatStatus::ok) << row.label();
    const detail::SeatSolution& solution = *state.solution;
    const double unit = unit_force(*seat);
    for (const auto& [sums, report] :
         {std::pair{&of_many, &many}, {&of_few, &few}}) {
      compare(friction, i, row, sums->basis(), sums->of(solution, unit),
              *report, area);
    }
  }
  EXPECT_LT(many.rms(), 2e-4);
}

// Viscous sums by the second moments of the pressure of one free contact, whose
// directions lie within 1 deg of the load's: w - n (n.w), and w x n.
TEST(SeatFriction, ViscousSumsOfANarrowContact) {
  const detail::SeatBasis basis(8);
  const double v = 0.7;
  // A point: N_nm(v) times what orders sum up to, 1 for m = 0, else 2.
  Eigen::ArrayXd c = basis.functions(v) * basis.factors() / pi;
  for (int n = 0; n < 8; ++n) c(basis.index(n, 0)) /= 2;
  const Eigen::Vector3d r(std::sin(v), 0, std::cos(v));
  const Eigen::Vector3d w = Eigen::Vector3d(0.3, -0.5, 0.4).normalized();
  const auto [f, m] = basis.viscous(c, w);
  EXPECT_LT((f - w.cross(r)).norm(), 1e-14);
  EXPECT_LT((m - (w - r * r.dot(w))).norm(), 1e-14);
}

TEST(SeatFriction, MirrorsAcrossTheEquator) {
  const detail::SeatBasis basis(40);
  Eigen::ArrayXd c = basis.functions(0.7), image = basis.functions(pi - 0.7);
  basis.mirror(c);
  EXPECT_LT((c - image).abs().maxCoeff(), 1e-13);
}

}  // namespace
}  // namespace contact::test::friction_test
