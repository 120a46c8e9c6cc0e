// Joints with a bounded contact, from C, are bit-identical to C++.
#include "libcontact/c/ends.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "c/door.hpp"
#include "c/expect_table.hpp"
#include "libcontact/c/moments.h"
#include "libcontact/c/step.h"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/finite_pin.hpp"
#include "libcontact/joint/step.hpp"
#include "libcontact/quantities/finite_pin.hpp"
#include "libcontact/quantities/seat.hpp"
#include "libcontact/quantities/tables.hpp"
#include "libcontact/seat/contact.hpp"

namespace contact::test::ends_test {
namespace {

using contact::Joint;
using contact::JointSolution;
using contact::test::c_joint;
using contact::test::CJoint;
using contact::test::expect_failure;
using contact::test::expect_same;
using Eigen::Matrix3d;
using Eigen::Vector3d;

const std::string cup = CONTACT_DATA_DIR "/joints/hip_cup.toml";
const std::string ring =
    CONTACT_DATA_DIR "/joints/spherical_plain_bearing_ge50.toml";
const std::string bush = CONTACT_DATA_DIR "/joints/relieved_bush.toml";
constexpr contact_slip loaded = {{3e5, 0, 0}, {0.1, 0, 0.5}, {}};

Joint::Slip cpp(const contact_slip& slip) {
  return {.reaction = Vector3d(slip.reaction),
          .angular_velocity = Vector3d(slip.angular_velocity),
          .axis = Vector3d(slip.axis)};
}

// One quantity of a slip.
Vector3d got(const CJoint& joint, const contact_slip& slip, const char* key,
             const contact_placement* placement = nullptr,
             contact_memory* memory = nullptr) {
  Vector3d v = Vector3d::Zero();
  EXPECT_EQ(contact_joint_get(joint.get(), &slip, placement, memory, &key, 1,
                              v.data()),
            CONTACT_OK)
      << contact_last_message();
  return v;
}

contact_solution solved(const CJoint& joint, const contact_slip& slip) {
  contact_solution s;
  EXPECT_EQ(contact_joint_solve(joint.get(), &slip, nullptr, &s), CONTACT_OK)
      << contact_last_message();
  return s;
}

// All quantities of a slip by one call, in the order of their keys.
void expect_all(const CJoint& c, const contact_slip& slip, const Joint& joint) {
  std::vector<const char*> keys;
  std::size_t size = 0;
  for (std::size_t i = 0; contact_joint_quantity(i); ++i) {
    keys.push_back(contact_joint_quantity(i)->key);
    size += contact_joint_quantity(i)->size;
  }
  std::vector<double> values(size);
  ASSERT_EQ(contact_joint_get(c.get(), &slip, nullptr, nullptr, keys.data(),
                              keys.size(), values.data()),
            CONTACT_OK);
  const JointSolution s = joint.solve(cpp(slip));
  const auto rims = joint.rims(s);
  std::size_t i = 0, at = 0;
  const auto compare = [&](const auto& all, const auto* of) {
    for (const auto& q : all) {
      ASSERT_EQ(keys.at(i++), q.key);
      for (int k = 0; k < (q.is_vector() ? 3 : 1); ++k) {
        expect_same(
            values.at(at++),
            of ? value_of(q, *of, q.is_vector() ? k : contact::whole) : NAN,
            q.key);
      }
    }
  };
  compare(contact::solution_quantities(), &s);
  compare(contact::rim_quantities(), rims ? &*rims : nullptr);
  const auto lie = joint.lie(s);
  compare(contact::lie_quantities(), lie ? &*lie : nullptr);
  EXPECT_EQ(at, size);
}

// At both rims, at none, and without any.
TEST(CEnds, AllQuantitiesAreThoseOfCpp) {
  const CJoint c = c_joint(ring);
  const Joint joint(contact::read_joint(ring));
  expect_all(c, loaded, joint);
  expect_all(c, {{1e3, 0, 0}, {0.1, 0, 0.5}, {}}, joint);
  EXPECT_EQ(got(c, loaded, "free")[0], 0);
  const std::string open = CONTACT_DATA_DIR "/joints/hip_cocr_uhmwpe.toml";
  expect_all(c_joint(open), {{1e3, 0, 0}, {0.1, 0, 0.5}, {}},
             Joint(contact::read_joint(open)));
  expect_all(c_joint(bush), {{1e4, 200, 0}, {0, 0, 1}, {0, 0, 1}},
             Joint(contact::read_joint(bush)));
}

TEST(CEnds, HasThePressureOnARoundedRim) {
  const contact_setting rounded = {"seat.edge_radius_mm", "0.5"};
  contact_joint* made = nullptr;
  ASSERT_EQ(contact_joint_read(cup.c_str(), &rounded, 1, &made), CONTACT_OK);
  const CJoint joint(made, contact_joint_free);
  const contact_slip slip = {{3e3, 0, 1e3}, {0, 0, 1}, {}};
  const double intensity = got(joint, slip, "upper_intensity")[0];
  ASSERT_GT(intensity, 0);
  const auto spec = contact::read_joint(cup, {{"seat.edge_radius_mm", "0.5"}});
  const contact::SeatContact contact(spec, *spec.geometry.seat());
  EXPECT_EQ(got(joint, slip, "upper_rim_pressure")[0],
            contact.rounded_rim(intensity, 0.5e-3).peak_pressure);
}

// The numbers are those that hinge-joint --reaction-xyz prints.
TEST(CEnds, SolutionsAreInTheSeat) {
  const CJoint hip = c_joint(cup);
  contact_joint_size size;
  ASSERT_EQ(contact_joint_get_size(hip.get(), &size), CONTACT_OK);
  EXPECT_EQ(size.has_seat, 1);
  const contact_solution s = solved(hip, {{0, 1000, 3000}, {1, 0, 0}, {}});
  EXPECT_NEAR(s.peak_pressure, 30542236.4, 0.05);
  contact_solution none;
  const contact_slip away = {{0, 2000, 0}, {1, 0, 0}, {}};
  expect_failure(
      contact_joint_solve(hip.get(), &away, nullptr, &none),
      CONTACT_OUT_OF_SEAT,
      "contact_joint_solve: the load points 135 deg from the seat's axis, and "
      "the seat carries loads below 90 deg only: the ball leaves it");
  EXPECT_EQ(none.status, CONTACT_OUT_OF_SEAT);
  EXPECT_TRUE(std::isnan(none.peak_pressure));
  // The contact lies nearer to a rim than report_distance: no peak, not 0.
  const contact_slip narrow = {{100 * std::sin(20 * std::numbers::pi / 180), 0,
                                100 * std::cos(20 * std::numbers::pi / 180)},
                               {0, 0, 1},
                               {}};
  EXPECT_TRUE(std::isnan(solved(c_joint(ring), narrow).peak_pressure));
}

TEST(CEnds, RestAndStepsAreThoseOfCpp) {
  const CJoint c = c_joint(ring);
  const Joint joint(contact::read_joint(ring));
  const contact_hold hold = {{3e5, 0, 0}, {0, 10, 100}, {}};
  const contact::RestSolution s =
      joint.at_rest({.reaction = {3e5, 0, 0}, .moment = {0, 10, 100}});
  contact_rest rest;
  ASSERT_EQ(contact_joint_at_rest(c.get(), &hold, nullptr, &rest), CONTACT_OK);
  EXPECT_GT(rest.utilisation, 0);
  EXPECT_EQ(rest.utilisation, s.utilisation);
  EXPECT_EQ(rest.direction[1], s.direction.y());
  EXPECT_EQ(rest.slip.friction_moment[2], s.slip.friction_moment.z());
  const contact_step_start start = {
      {3e5, 0, 0}, {0.1, 0, 0.5}, {0.1, 0.1, 0.4}, {}};
  const Matrix3d inertia = 1e4 * Matrix3d::Identity();
  contact_step step;
  ASSERT_EQ(contact_joint_step(c.get(), &start, inertia.data(), nullptr, &step),
            CONTACT_OK);
  const contact::JointStep done = contact::step(
      joint, {{3e5, 0, 0}, {0.1, 0, 0.5}, {0.1, 0.1, 0.4}}, inertia);
  EXPECT_EQ(Vector3d(step.moment), done.moment);
  EXPECT_EQ(Vector3d(step.angular_velocity), done.angular_velocity);
}

// The whole of a joint turned, its seat known by the placement.
TEST(CEnds, PlacementTurnsTheSeat) {
  const CJoint c = c_joint(ring);
  const Matrix3d turn =
      Eigen::AngleAxisd(0.9, Vector3d(0.36, 0.48, 0.8)).toRotationMatrix();
  contact_placement placement = {};
  placement.size = sizeof placement;
  Matrix3d::Map(placement.from_seat) = turn.transpose();  // row by row
  contact_slip turned = {};
  Vector3d::Map(turned.reaction) = turn * Vector3d(loaded.reaction);
  Vector3d::Map(turned.angular_velocity) =
      turn * Vector3d(loaded.angular_velocity);
  for (const char* key : {"friction_moment", "seat_force"}) {
    const Vector3d level = got(c, loaded, key);
    EXPECT_LT((got(c, turned, key, &placement) - turn * level).norm(),
              1e-12 * level.norm())
        << key;
  }
  const auto refused = [&](const contact_placement& wrong) {
    const char* const key = "power";
    double power = 0;
    EXPECT_EQ(
        contact_joint_get(c.get(), &turned, &wrong, nullptr, &key, 1, &power),
        CONTACT_BAD_INPUT);
    EXPECT_TRUE(std::isnan(power));
    return std::string(contact_last_message());
  };
  placement.from_seat[0] *= -1;
  EXPECT_EQ(refused(placement),
            "contact_joint_get: placement.from_seat must be a rotation, row by "
            "row, or all 0");
  EXPECT_EQ(refused({}),
            "contact_joint_get: placement.size must be "
            "sizeof(contact_placement)");
}

// Numbers equal FinitePin's, whose z is the hole's axis.
TEST(CEnds, PinsTiltAndSlide) {
  const CJoint c = c_joint(bush);
  const contact::FinitePin pin(contact::read_joint(bush));
  const auto expect = [&](double rate, const contact_placement& placement,
                          const contact::FinitePinSolution& wanted) {
    const contact_slip slip = {{1e4, 200, 0}, {0, 0, rate}, {0, 0, 1}};
    const auto is = [&](const char* key, double number, int part = 0) {
      EXPECT_NEAR(got(c, slip, key, &placement)[part], number,
                  1e-9 * std::abs(number) + 1e-12)  // moments that are 0
          << key;
    };
    is("peak_pressure", wanted.contact.peak_pressure);
    is("high", wanted.contact.high);
    is("friction_moment", wanted.moment.z(), 2);
    is("friction_force", wanted.friction_force.y(), 1);
    is("tilting_moment", wanted.contact.force_moment.x());
    is("tilt", wanted.contact.tilt.x());
    is("moment", wanted.moment.y(), 1);
    is("axial_friction_force", wanted.axial_friction_force);
  };
  contact_placement placement = {};
  placement.size = sizeof placement;
  placement.tilt[0] = 2e-4;
  placement.tilt[1] = 1e-4;
  expect(1, placement, pin.solve({1e4, 200}, {2e-4, 1e-4}, 1));
  placement.is_placed = 1;
  placement.place = 1e-3;
  placement.axial_velocity = 0.01;
  expect(-2, placement, pin.solve_at({1e4, 200}, 1e-3, {-2, 0.01}));
  // Level, it ends too; without a placement it does not.
  placement = {};
  placement.size = sizeof placement;
  expect(1, placement, pin.solve({1e4, 200}, {0, 0}, 1));
  placement.axial_velocity = 0.01;
  // A joint without slices refuses.
  const CJoint ball = c_joint(cup);
  const char* const key = "power";
  double power = 0;
  EXPECT_EQ(contact_joint_get(ball.get(), &loaded, &placement, nullptr, &key, 1,
                              &power),
            CONTACT_OUT_OF_RANGE);
  EXPECT_TRUE(std::isnan(power));
  EXPECT_NE(std::string(contact_last_message()).find("a pin of a JointSpec"),
            std::string::npos)
      << contact_last_message();
}

// The second of two solutions that are near begins from the first.
TEST(CEnds, GoesOnFromItsMemory) {
  const CJoint c = c_joint(ring);
  const Joint joint(contact::read_joint(ring));
  contact_memory* memory = nullptr;
  ASSERT_EQ(contact_memory_make(&memory), CONTACT_OK);
  JointSolution last;
  for (const double load : {3e5, 3.01e5}) {
    const contact_slip slip = {{load, 0, 0}, {0.1, 0, 0.5}, {}};
    last = joint.solve(cpp(slip), last);
    const Vector3d warm = got(c, slip, "friction_moment", nullptr, memory);
    EXPECT_EQ(warm, last.friction_moment);
    // Loads are found to 1e-5 of themselves by either way.
    const Vector3d cold = got(c, slip, "friction_moment");
    EXPECT_EQ(warm == cold, load == 3e5);
    EXPECT_LT((warm - cold).norm(), 1e-4 * cold.norm());
    // Out of the seat: the memory stays as it was.
    const contact_slip outside = {{NAN, 0, 0}, {0, 0, 1}, {}};
    const char* const key = "friction_moment";
    double none[3];
    EXPECT_EQ(
        contact_joint_get(c.get(), &outside, nullptr, memory, &key, 1, none),
        CONTACT_OUT_OF_RANGE);
    EXPECT_TRUE(std::isnan(none[0]));
  }
  contact_memory_free(memory);
  contact_memory_free(nullptr);
}

// Functions of a solution that C keeps find the contact at its rims again, from
// another start.
TEST(CEnds, SolutionsAreFoundAnew) {
  const contact_slip level = {{3e5, 0, 0}, {0, 0, 0.5}, {}};
  const CJoint c = c_joint(ring);
  const Joint joint(contact::read_joint(ring));
  const JointSolution s = joint.solve(cpp(level));
  const contact_solution found = solved(c, level);
  const auto pv = joint.pv(s, {0, 0, 0.5});
  for (const auto& [key, wanted] :
       {std::pair("pv_total", pv.total), {"pv_max", pv.largest}}) {
    double value;
    ASSERT_EQ(contact_rating_get(c.get(), &level, &found, key, &value),
              CONTACT_OK);
    EXPECT_NEAR(value / wanted, 1, 1e-4) << key;
  }
  double heat;
  ASSERT_EQ(contact_rating_get(c.get(), &level, &found, "heat", &heat),
            CONTACT_OK);
  EXPECT_EQ(heat, -s.power);
  // A pin with a relief, with the axis of its moment.
  const contact_slip turning = {{1e4, 200, 0}, {0, 0, 1}, {0, 0, 1}};
  const Joint pin(contact::read_joint(bush));
  const CJoint c_pin = c_joint(bush);
  const contact_solution turned = solved(c_pin, turning);
  double pv_max;
  ASSERT_EQ(
      contact_rating_get(c_pin.get(), &turning, &turned, "pv_max", &pv_max),
      CONTACT_OK);
  EXPECT_NEAR(pv_max / pin.pv(pin.solve(cpp(turning)), {0, 0, 1}).largest, 1,
              1e-8);
  // The moment of the slip is one of the edge.
  contact_held held;
  ASSERT_EQ(contact_joint_held(c.get(), &found, found.friction_moment, &held),
            CONTACT_OK);
  EXPECT_NEAR(held.utilisation, 1, 1e-4);
  // At the load, symmetrically on both sides of the middle, and beside the
  // seat.
  const Vector3d load = got(c, level, "seat_force").normalized();
  const double places[] = {
      load.x(),      load.y(), load.z(),       std::sin(1.2), 0, std::cos(1.2),
      std::sin(1.2), 0,        -std::cos(1.2), std::sin(1.1), 0, std::cos(1.1)};
  double pressure[4];
  ASSERT_EQ(contact_joint_pressures(c.get(), &found, places, 4, pressure),
            CONTACT_OK);
  EXPECT_NEAR(pressure[0] / got(c, level, "pressure_at_load")[0], 1, 1e-4);
  EXPECT_NEAR(pressure[1] / pressure[2], 1, 1e-3);
  EXPECT_EQ(pressure[3], 0);
  char text[2000];
  ASSERT_EQ(contact_joint_solution_notes(c.get(), &found, text, sizeof text),
            CONTACT_OK);
  const std::string notes = text;
  EXPECT_NE(notes.find("the contact is at both its rims"), notes.npos) << notes;
  EXPECT_NE(notes.find("in nine of ten cups of all sizes"), notes.npos);
}

TEST(CEnds, WithoutItsSeatItGoesOn) {
  contact_joint* made = nullptr;
  ASSERT_EQ(contact_joint_without_seat(c_joint(cup).get(), &made), CONTACT_OK);
  const CJoint endless(made, contact_joint_free);
  expect_all(endless, {{0, 2000, 0}, {1, 0, 0}, {}},
             Joint(contact::read_joint(cup).without_seat()));
  EXPECT_TRUE(
      std::isnan(got(endless, {{0, 2000, 0}, {1, 0, 0}, {}}, "shift")[0]));
}

// A friction without a solution in seats must be known before the joint is
// made.
TEST(CEnds, ItsSeatMayBeLeftOutBeforeItIsMade) {
  const std::string text =
      "name = \"cup\"\nkind = \"ball\"\n[geometry]\nradius_mm = 14\n"
      "radial_clearance_um = 50\n[materials.inner]\n"
      "youngs_modulus_GPa = 200\npoissons_ratio = 0.3\n[materials.outer]\n"
      "youngs_modulus_GPa = 100\npoissons_ratio = 0.3\n[friction]\n"
      "law = \"stribeck\"\nstatic_coefficient = 0.1\n"
      "dynamic_coefficient = 0.05\nstribeck_velocity_mm_per_s = 1\n";
  const std::string seated = text + "[seat]\ncup_deg = 60\n";
  contact_joint* made = nullptr;
  EXPECT_EQ(contact_joint_parse(seated.c_str(), nullptr, nullptr, 0, &made),
            CONTACT_BAD_INPUT);
  EXPECT_NE(std::string(contact_last_message()).find("left_out = true"),
            std::string::npos);
  const contact_setting out = {"seat.left_out", "true"};
  ASSERT_EQ(contact_joint_parse(seated.c_str(), nullptr, &out, 1, &made),
            CONTACT_OK)
      << contact_last_message();
  const CJoint left_out(made, contact_joint_free);
  ASSERT_EQ(contact_joint_parse(text.c_str(), nullptr, nullptr, 0, &made),
            CONTACT_OK);
  const CJoint without(made, contact_joint_free);
  const contact_slip slip = {{0, 2000, 100}, {1, 0, 0}, {}};
  EXPECT_EQ(got(left_out, slip, "friction_moment"),
            got(without, slip, "friction_moment"));
}

TEST(CEnds, TablesAreKept) {
  const CJoint exact = c_joint(ring);
  contact_joint* to = nullptr;
  ASSERT_EQ(contact_joint_tabulate(exact.get(), 2.9e5, 3e5, &to), CONTACT_OK);
  const CJoint made(to, contact_joint_free);
  std::size_t size = 0;
  const char* bytes = contact_joint_table(made.get(), &size);
  ASSERT_NE(bytes, nullptr);
  EXPECT_LE(contact_joint_table_error(made.get()), 1e-3);
  ASSERT_EQ(contact_joint_set_table(exact.get(), bytes, size, &to), CONTACT_OK);
  const CJoint read(to, contact_joint_free);
  const contact_slip slip = {{2.95e5, 0, 3e4}, {0, 0, 0.5}, {}};
  const double moment = solved(made, slip).friction_moment[2];
  EXPECT_EQ(moment, solved(read, slip).friction_moment[2]);
  const double wanted = solved(exact, slip).friction_moment[2];
  EXPECT_NE(moment, wanted);
  EXPECT_NEAR(moment / wanted, 1, 2e-3);
  expect_failure(contact_joint_set_table(c_joint(cup).get(), bytes, size, &to),
                 CONTACT_BAD_INPUT, "a table of another joint");
  EXPECT_EQ(to, nullptr);
  EXPECT_EQ(contact_joint_table(exact.get(), &size), nullptr);
  EXPECT_EQ(size, 0u);
  EXPECT_TRUE(std::isnan(contact_joint_table_error(nullptr)));
  const CJoint open = c_joint(CONTACT_DATA_DIR "/joints/hip_cocr_uhmwpe.toml");
  expect_failure(contact_joint_tabulate(open.get(), 1, 2, &to),
                 CONTACT_BAD_INPUT,
                 "a table of contacts requires a joint with a [seat]");
}

TEST(CEnds, RefusesWhatCannotBe) {
  const CJoint c = c_joint(cup);
  const char* keys[] = {"power", "peak_presure"};
  double values[2] = {0, 0};
  const auto get = [&](const contact_joint* joint, const contact_slip* slip) {
    return contact_joint_get(joint, slip, nullptr, nullptr, keys, 2, values);
  };
  EXPECT_EQ(get(c.get(), &loaded), CONTACT_BAD_INPUT);
  EXPECT_EQ(std::string(contact_last_message())
                .find("unknown quantity \"peak_presure\": did you mean "
                      "\"peak_pressure\"?"),
            0u)
      << contact_last_message();
  keys[1] = "half_angle";
  expect_failure(get(c.get(), nullptr), CONTACT_BAD_INPUT,
                 "contact_joint_get: slip must be other than NULL");
  EXPECT_TRUE(std::isnan(values[0]) && std::isnan(values[1]));
  expect_failure(get(nullptr, &loaded), CONTACT_BAD_INPUT,
                 "contact_joint_get: joint must be other than NULL");
  expect_failure(contact_memory_make(nullptr), CONTACT_BAD_INPUT,
                 "contact_memory_make: memory must be other than NULL");
  contact_joint* none = nullptr;
  expect_failure(contact_joint_without_seat(nullptr, &none), CONTACT_BAD_INPUT,
                 "contact_joint_without_seat: joint must be other than NULL");
}

}  // namespace
}  // namespace contact::test::ends_test
