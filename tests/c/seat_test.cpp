// Balls in seats that end, from C, are those of C++ to the last bit.
#include "libcontact/c/seat.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "c/door.hpp"
#include "c/expect_table.hpp"
#include "libcontact/duty/seat_pv.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/quantities/seat.hpp"
#include "libcontact/seat/table.hpp"

namespace {

using contact::SeatJoint;
using contact::SeatJointSolution;
using contact::test::c_joint;
using contact::test::CJoint;
using contact::test::expect_failure;
using contact::test::expect_table;
using CSeat = std::unique_ptr<contact_seat, void (*)(contact_seat*)>;

const std::string cup = CONTACT_DATA_DIR "/joints/hip_cup.toml";
const std::string ring =
    CONTACT_DATA_DIR "/joints/spherical_plain_bearing_ge50.toml";

CSeat c_seat(const std::string& file,
             const contact_seat_options* options = nullptr) {
  const CJoint joint = c_joint(file);
  contact_seat* seat = nullptr;
  EXPECT_EQ(contact_seat_make(joint.get(), options, &seat), CONTACT_OK)
      << contact_last_message();
  return {seat, contact_seat_free};
}

void expect_same(const contact_seat_solution& c, const SeatJointSolution& cpp) {
  expect_table(contact::seat_joint_quantities(), cpp,
               contact_seat_solution_quantity,
               [&](const char* key, double* value) {
                 return contact_seat_solution_get(&c, key, value);
               });
  EXPECT_EQ(c.status, static_cast<int>(cpp.contact.status));
  EXPECT_EQ(c.is_free, cpp.contact.is_free);
  EXPECT_EQ(c.peak_pressure, cpp.contact.peak_pressure);
  EXPECT_EQ(c.friction_moment[2], cpp.friction_moment.z());
  EXPECT_EQ(c.rims[0].gap, cpp.contact.rims[0].gap);
  EXPECT_EQ(c.rims[1].intensity, cpp.contact.rims[1].intensity);
  EXPECT_EQ(c.rims[1].half_arc, cpp.contact.rims[1].half_arc);
}

TEST(CSeat, HasThePressureOnARoundedRim) {
  const contact_setting rounded = {"seat.edge_radius_mm", "0.5"};
  contact_joint* made = nullptr;
  ASSERT_EQ(contact_joint_read(cup.c_str(), &rounded, 1, &made), CONTACT_OK);
  const CJoint joint(made, contact_joint_free);
  contact_seat* seat = nullptr;
  ASSERT_EQ(contact_seat_make(joint.get(), nullptr, &seat), CONTACT_OK);
  const CSeat owner(seat, contact_seat_free);
  const contact_slip slip = {{3e3, 0, 1e3}, {0, 0, 1}, {}};
  contact_seat_solution c;
  ASSERT_EQ(contact_seat_solve(seat, &slip, &c), CONTACT_OK);
  ASSERT_GT(c.rims[1].intensity, 0);
  const SeatJoint cpp(
      contact::read_joint(cup, {{"seat.edge_radius_mm", "0.5"}}));
  const auto rim = cpp.contact().rounded_rim(c.rims[1].intensity, 0.5e-3);
  EXPECT_EQ(c.rims[1].peak_pressure, rim.peak_pressure);
  EXPECT_EQ(c.rims[1].reach, rim.reach);
  double value;
  ASSERT_EQ(contact_seat_solution_get(&c, "upper_rim_pressure", &value),
            CONTACT_OK);
  EXPECT_EQ(value, rim.peak_pressure);
}

// At both rims, at none, and at rest.
TEST(CSeat, IsWhatCppSays) {
  const CSeat seat = c_seat(ring);
  const SeatJoint joint(contact::read_joint(ring));
  for (const double load : {3e5, 1e3}) {
    const contact_slip slip = {{load, 0, 0}, {0.1, 0, 0.5}, {}};
    const SeatJointSolution s = joint.solve(
        {.reaction = {load, 0, 0}, .angular_velocity = {0.1, 0, 0.5}});
    contact_seat_solution c;
    ASSERT_EQ(contact_seat_solve(seat.get(), &slip, &c), CONTACT_OK);
    expect_same(c, s);
    EXPECT_EQ(c.is_free, load == 1e3);
    contact::SeatState near;
    const contact::SeatPv pv = contact::seat_pv(joint, s, {0.1, 0, 0.5}, near);
    contact_seat_rating rating;
    ASSERT_EQ(contact_seat_rate(seat.get(), &c, &slip, &rating), CONTACT_OK);
    // A contact at a rim is found from another start.
    const double found = c.is_free ? 1e-12 : 1e-4;
    EXPECT_NEAR(rating.pv_total / pv.total, 1, found);
    EXPECT_NEAR(rating.pv_max / pv.largest, 1, found);
    EXPECT_NEAR(rating.pv_max_place[0], pv.place.x(), c.is_free ? 1e-6 : 1e-2);
  }
  const contact_hold hold = {{3e5, 0, 0}, {0, 10, 100}, {}};
  const contact::SeatRestSolution s =
      joint.at_rest({.reaction = {3e5, 0, 0}, .moment = {0, 10, 100}});
  contact_seat_rest rest;
  ASSERT_EQ(contact_seat_at_rest(seat.get(), &hold, &rest), CONTACT_OK);
  EXPECT_GT(rest.utilisation, 0);
  EXPECT_EQ(rest.utilisation, s.utilisation);
  EXPECT_EQ(rest.direction[1], s.direction.y());
  expect_same(rest.slip, s.slip);
}

// The second of two solutions that are near begins from the first.
TEST(CSeat, GoesOnFromItsMemory) {
  const CSeat seat = c_seat(ring);
  const SeatJoint joint(contact::read_joint(ring));
  contact_seat_memory* memory = nullptr;
  ASSERT_EQ(contact_seat_memory_make(&memory), CONTACT_OK);
  SeatJointSolution last;
  for (const double load : {3e5, 3.01e5}) {
    const contact_slip slip = {{load, 0, 0}, {0.1, 0, 0.5}, {}};
    last = joint.solve(
        {.reaction = {load, 0, 0}, .angular_velocity = {0.1, 0, 0.5}}, last);
    contact_seat_solution c;
    ASSERT_EQ(contact_seat_solve_from(seat.get(), &slip, memory, &c),
              CONTACT_OK);
    expect_same(c, last);
    // Loads are found to 1e-5 of themselves by either way.
    contact_seat_solution cold;
    ASSERT_EQ(contact_seat_solve(seat.get(), &slip, &cold), CONTACT_OK);
    EXPECT_NEAR(c.shift[0] / cold.shift[0], 1, 1e-4);
    EXPECT_NEAR(c.friction_moment[2] / cold.friction_moment[2], 1, 1e-4);
    // Out of the seat: the memory stays as it was.
    const contact_slip outside = {{NAN, 0, 0}, {0, 0, 1}, {}};
    EXPECT_NE(contact_seat_solve_from(seat.get(), &outside, memory, &c),
              CONTACT_OK);
    EXPECT_TRUE(std::isnan(c.friction_moment[0]));
  }
  contact_seat_memory_free(memory);
  contact_seat_memory_free(nullptr);
  const contact_slip slip = {{3e5, 0, 0}, {0, 0, 1}, {}};
  contact_seat_solution c;
  expect_failure(contact_seat_solve_from(seat.get(), &slip, nullptr, &c),
                 CONTACT_BAD_INPUT,
                 "contact_seat_solve_from: memory must be other than NULL");
}

// Radial rings have side faces at acute angles to the seat.
TEST(CSeat, SaysWhatTheModelLeavesOut) {
  const CSeat seat = c_seat(ring);
  const contact_slip slip = {{3e5, 0, 0}, {0, 0, 0.5}, {}};
  contact_seat_solution c;
  ASSERT_EQ(contact_seat_solve(seat.get(), &slip, &c), CONTACT_OK);
  char text[1000];
  ASSERT_EQ(contact_seat_notes(seat.get(), &c, text, sizeof text), CONTACT_OK);
  const std::string notes = text;
  EXPECT_NE(notes.find("the contact is at its lower rim"), notes.npos) << notes;
  EXPECT_NE(notes.find("larger by 9 to 16 %, the approach by up to 18 %"),
            notes.npos);
  EXPECT_NE(notes.find('\n'), notes.npos);
  // At the load, alike on both sides of the middle, and beside the seat.
  const double places[] = {c.seat_force[0],
                           c.seat_force[1],
                           c.seat_force[2],
                           std::sin(1.2),
                           0,
                           std::cos(1.2),
                           std::sin(1.2),
                           0,
                           -std::cos(1.2),
                           std::sin(1.1),
                           0,
                           std::cos(1.1)};
  double pressure[4];
  ASSERT_EQ(contact_seat_pressure(seat.get(), &c, places, 4, pressure),
            CONTACT_OK);
  EXPECT_NEAR(pressure[0] / c.pressure_at_load, 1, 1e-6);
  EXPECT_NEAR(pressure[1] / pressure[2], 1, 1e-3);
  EXPECT_EQ(pressure[3], 0);
}

TEST(CSeat, OutOfTheSeatThereIsNoContact) {
  const CSeat seat = c_seat(cup);
  contact_seat_solution c;
  const contact_slip away = {{0, 1000, -1000}, {1, 0, 0}, {}};
  expect_failure(
      contact_seat_solve(seat.get(), &away, &c), CONTACT_OUT_OF_RANGE,
      "contact_seat_solve: the load points 180 deg from the seat's axis, and "
      "the seat carries loads below 90 deg only: the ball leaves it");
  EXPECT_EQ(c.status, CONTACT_SEAT_OUT_OF_SEAT);
  EXPECT_TRUE(std::isnan(c.peak_pressure));
  double pressure = 0;
  EXPECT_EQ(contact_seat_pressure(seat.get(), &c, away.reaction, 1, &pressure),
            CONTACT_OUT_OF_RANGE);
  EXPECT_TRUE(std::isnan(pressure));
  contact_seat_rating rating = {};
  EXPECT_EQ(contact_seat_rate(seat.get(), &c, &away, &rating),
            CONTACT_OUT_OF_RANGE);
  EXPECT_TRUE(std::isnan(rating.pv_max));
  const contact_slip none = {};
  expect_failure(contact_seat_solve(seat.get(), &none, &c),
                 CONTACT_OUT_OF_RANGE,
                 "contact_seat_solve: the seat has no load");
}

TEST(CSeat, TablesAreKept) {
  const contact_seat_options loads = {2.9e5, 3e5, nullptr, 0};
  const CSeat made = c_seat(ring, &loads);
  std::size_t size = 0;
  const char* bytes = contact_seat_table(made.get(), &size);
  ASSERT_NE(bytes, nullptr);
  EXPECT_LE(contact_seat_table_error(made.get()), 1e-3);
  const contact_seat_options kept = {0, 0, bytes, size};
  const CSeat read = c_seat(ring, &kept);
  const contact_slip slip = {{2.95e5, 0, 3e4}, {0, 0, 0.5}, {}};
  contact_seat_solution a, b, exact;
  ASSERT_EQ(contact_seat_solve(made.get(), &slip, &a), CONTACT_OK);
  ASSERT_EQ(contact_seat_solve(read.get(), &slip, &b), CONTACT_OK);
  ASSERT_EQ(contact_seat_solve(c_seat(ring).get(), &slip, &exact), CONTACT_OK);
  EXPECT_EQ(a.friction_moment[2], b.friction_moment[2]);
  EXPECT_NE(a.friction_moment[2], exact.friction_moment[2]);
  EXPECT_NEAR(a.friction_moment[2] / exact.friction_moment[2], 1, 2e-3);
  contact_seat* seat = nullptr;
  expect_failure(contact_seat_make(c_joint(cup).get(), &kept, &seat),
                 CONTACT_BAD_INPUT, "a table of another joint");
  EXPECT_EQ(seat, nullptr);
  EXPECT_EQ(contact_seat_table(c_seat(ring).get(), &size), nullptr);
  EXPECT_EQ(size, 0u);
  EXPECT_TRUE(std::isnan(contact_seat_table_error(nullptr)));
}

TEST(CSeat, RefusesWhatCannotBe) {
  contact_seat* seat = nullptr;
  const CJoint open = c_joint(CONTACT_DATA_DIR "/joints/hip_cocr_uhmwpe.toml");
  expect_failure(contact_seat_make(open.get(), nullptr, &seat),
                 CONTACT_BAD_INPUT,
                 "a joint in a seat that ends requires [seat]");
  expect_failure(contact_seat_make(nullptr, nullptr, &seat), CONTACT_BAD_INPUT,
                 "contact_seat_make: joint must be other than NULL");
  const CSeat good = c_seat(cup);
  contact_seat_solution c;
  expect_failure(contact_seat_solve(good.get(), nullptr, &c), CONTACT_BAD_INPUT,
                 "contact_seat_solve: slip must be other than NULL");
  EXPECT_EQ(c.status, CONTACT_SEAT_NO_LOAD);
  EXPECT_TRUE(std::isnan(c.shift[2]) && std::isnan(c.rims[1].gap));
  contact_seat_rest rest;
  expect_failure(contact_seat_at_rest(nullptr, nullptr, &rest),
                 CONTACT_BAD_INPUT,
                 "contact_seat_at_rest: seat must be other than NULL");
  EXPECT_TRUE(std::isnan(rest.utilisation) && std::isnan(rest.slip.power));
  double value;
  EXPECT_EQ(contact_seat_solution_get(&c, "peak", &value), CONTACT_BAD_INPUT);
  contact_seat_free(nullptr);
}

}  // namespace
