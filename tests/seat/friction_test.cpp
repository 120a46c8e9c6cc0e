#include "libcontact/seat/friction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "libcontact/base/units.hpp"
#include "libcontact/seat/contact.hpp"
#include "support/accuracy_report.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"
#include "support/seat.hpp"

// Friction of contacts on seats that end, by harmonics, against plain sums of
// a program of its own.
namespace contact::test {
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

// Force and moment of the four slip axes of row i, over the load.
void compare(const ReferenceTable& friction, std::size_t i,
             const ReferenceTable::Row& row,
             const detail::SeatHarmonics& harmonics, AccuracyReport& to) {
  for (std::size_t k = 4 * i; k < 4 * i + 4; ++k) {
    const ReferenceTable::Row slip = friction[k];
    ASSERT_EQ(slip.text("id") + slip.text("load") + slip.text("dir_deg"),
              row.text("id") + row.text("load") + row.text("dir_deg"));
    const auto [f, m] = harmonics(vector(slip, "w"));
    const double load = row.value("load");
    to.add_error((f / load - vector(slip, "f")).norm(), slip.label());
    to.add_error((m / load - vector(slip, "m")).norm(), slip.label());
  }
}

TEST(SeatFriction, MatchesTheReference) {
  const ReferenceTable table("edges/edges_ball.csv");
  const ReferenceTable friction("edges/edges_ball_friction.csv");
  ASSERT_EQ(friction.size(), 4 * table.size());
  // Harmonics converge slowly for axes that pierce the contact beside a rim:
  // 7e-4 and 2.3e-3 there; else it is the usual grid's error.
  AccuracyReport many("f and m over the load, 130 degrees", 1e-3);
  AccuracyReport few("f and m over the load, 64 degrees", 3e-3);
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
    compare(friction, i, row, {solution, unit, 130}, many);
    compare(friction, i, row, {solution, unit, 64}, few);
  }
  EXPECT_LT(many.rms(), 2e-4);
}

}  // namespace
}  // namespace contact::test
