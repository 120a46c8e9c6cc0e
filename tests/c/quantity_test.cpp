// Quantities from C by their names: all of the tables, as C++ has them.
#include "libcontact/c/quantity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "c/door.hpp"
#include "c/expect_table.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"
#include "libcontact/joint/group.hpp"
#include "libcontact/play/impact.hpp"
#include "libcontact/play/play_joint.hpp"
#include "libcontact/quantities/play.hpp"
#include "libcontact/quantities/seat.hpp"
#include "libcontact/quantities/stuck.hpp"
#include "libcontact/quantities/tables.hpp"

namespace contact::test::quantity_test {
namespace {

using contact::Joint;
using contact::JointSpec;
using contact::test::c_joint;
using contact::test::CJoint;
using contact::test::expect_table;

constexpr double infinity = std::numeric_limits<double>::infinity();
const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
const std::string hip = CONTACT_DATA_DIR "/joints/hip_cocr_uhmwpe.toml";
const std::string pressed = CONTACT_DATA_DIR "/joints/lined_bush_pressed.toml";

TEST(CQuantities, OfSolutionsAreThoseOfCpp) {
  for (const std::string& file : {hip, pressed}) {
    const Joint cpp(contact::read_joint(file).contact());
    const CJoint c = c_joint(file);
    // One slides, one rests.
    for (const double rate : {0.8, 0.0}) {
      const contact_slip slip = {{100, 0, 2000}, {rate, 0, rate}, {}};
      contact_solution s;
      ASSERT_EQ(contact_joint_solve(c.get(), &slip, nullptr, &s), CONTACT_OK);
      expect_table(contact::solution_quantities(),
                   cpp.solve({{100, 0, 2000}, {rate, 0, rate}}),
                   contact_solution_quantity, [&](const char* key, double* to) {
                     return contact_solution_get(&s, key, to);
                   });
    }
  }
}

TEST(CQuantities, OfRestAreThoseOfCpp) {
  const Joint cpp(contact::read_joint(hip).contact());
  const CJoint c = c_joint(hip);
  const contact_hold hold = {{0, 0, 2000}, {0.5, 0, 0.2}, {}};
  contact_rest rest;
  ASSERT_EQ(contact_joint_at_rest(c.get(), &hold, nullptr, &rest), CONTACT_OK);
  expect_table(contact::rest_quantities(),
               cpp.at_rest({{0, 0, 2000}, {0.5, 0, 0.2}}),
               contact_rest_quantity, [&](const char* key, double* to) {
                 return contact_rest_get(&rest, key, to);
               });
}

TEST(CQuantities, OfPatchesAreThoseOfCpp) {
  for (const std::string& file : {hip, pressed}) {
    const Joint cpp(contact::read_joint(file).contact());
    const CJoint c = c_joint(file);
    const contact::ContactPatch patch = {
        cpp.contact(), 2000, cpp.contact().half_angle(2000).half_angle};
    expect_table(contact::patch_quantities(), patch, contact_patch_quantity,
                 [&](const char* key, double* to) {
                   return contact_patch_get(c.get(), 2000, key, to);
                 });
  }
}

TEST(CQuantities, OfRatingsAreThoseOfCpp) {
  const Joint cpp(contact::read_joint(hip).contact());
  const CJoint c = c_joint(hip);
  const contact_slip slip = {{100, 0, 2000}, {0.8, 0, 0.8}, {}};
  contact_solution s;
  ASSERT_EQ(contact_joint_solve(c.get(), &slip, nullptr, &s), CONTACT_OK);
  const Eigen::Vector3d rate(0.8, 0, 0.8);
  const auto solution = cpp.solve({{100, 0, 2000}, rate});
  expect_table(contact::rating_quantities(),
               contact::SlidingContact(cpp.contact(), solution, rate).rating(),
               contact_rating_quantity, [&](const char* key, double* to) {
                 return contact_rating_get(c.get(), &slip, &s, key, to);
               });
}

TEST(CQuantities, OfStuckJointsAreThoseOfCpp) {
  for (const char* name : {"hip_cocr_uhmwpe", "pin_joint"}) {
    const std::string file =
        CONTACT_DATA_DIR "/joints/" + std::string(name) + ".toml";
    const JointSpec spec = contact::read_joint(file);
    const contact::JointContact contact = spec.contact();
    const CJoint c = c_joint(file);
    const double angle = contact.half_angle(2000).half_angle;
    contact_stuck stuck;
    ASSERT_EQ(contact_joint_stuck(c.get(), 2000, &stuck), CONTACT_OK)
        << contact_last_message();
    expect_table(contact::stuck_quantities(),
                 contact::stuck_joint(spec, contact, 2000, angle),
                 contact_stuck_quantity, [&](const char* key, double* to) {
                   return contact_stuck_get(&stuck, key, to);
                 });
  }
}

TEST(CQuantities, OfStuckJointsHaveTheirLimits) {
  contact_stuck stuck;
  const CJoint tight = c_joint(pressed);
  EXPECT_EQ(contact_joint_stuck(tight.get(), 2000, &stuck),
            CONTACT_OUT_OF_RANGE);
  EXPECT_STREQ(contact_last_message(),
               "contact_joint_stuck: the stuck contact has no stiffness here, "
               "because the joint has interference");
  EXPECT_TRUE(std::isnan(stuck.load_stiffness));
  // No reason is given for another one.
  const CJoint cup = c_joint(CONTACT_DATA_DIR "/joints/hip_cup.toml");
  EXPECT_EQ(contact_joint_stuck(cup.get(), std::nan(""), &stuck),
            CONTACT_OUT_OF_RANGE);
  EXPECT_STREQ(contact_last_message(),
               "contact_joint_stuck: normal_force must be a number, and the "
               "bodies held");
  EXPECT_EQ(contact_joint_stuck(nullptr, 2000, &stuck), CONTACT_BAD_INPUT);
  EXPECT_TRUE(std::isnan(stuck.shape));
  // Above 43 deg it includes the attachment of homogeneous bodies.
  const CJoint steel = c_joint(CONTACT_DATA_DIR "/joints/paper_example_1.toml");
  char text[400];
  ASSERT_EQ(contact_joint_stuck_notes(steel.get(), 2.63e5, text, sizeof text),
            CONTACT_OK);
  EXPECT_EQ(std::string(text).rfind("half-angle 4", 0), 0u) << text;
  ASSERT_EQ(contact_joint_stuck_notes(steel.get(), 2e4, text, sizeof text),
            CONTACT_OK);
  EXPECT_STREQ(text, "");
}

// Neighbours of one type, each with a number of its own.
TEST(Quantities, OfRimsAreTheirMembers) {
  contact::RimContact rim;
  rim.area = 1;
  rim.peak_pressure = 2;
  rim.peak_place = {3, 4};
  rim.pressure_at_load = 5;
  rim.lower_end = 6;
  rim.upper_end = 7;
  rim.half_width = 8;
  for (const int i : {0, 1}) {
    rim.rims[i].distance = 9 + i;
    rim.rims[i].gap = 11 + i;
    rim.rims[i].intensity = 13 + i;
    rim.rims[i].peak_pressure = 15 + i;
  }
  rim.force_ratio = 17;
  rim.nominal_area = 18;
  rim.shift = {0, 19, 0};
  rim.force = {0, 0, 20};
  const std::map<std::string_view, double> expected = {
      {"free", 0},
      {"contact_area", 1},
      {"peak_pressure", 2},
      {"peak_polar_angle", 3},
      {"peak_longitude", 4},
      {"pressure_at_load", 5},
      {"lower_end", 6},
      {"upper_end", 7},
      {"half_width", 8},
      {"lower_rim_distance", 9},
      {"upper_rim_distance", 10},
      {"lower_rim_gap", 11},
      {"upper_rim_gap", 12},
      {"lower_intensity", 13},
      {"upper_intensity", 14},
      {"lower_rim_pressure", 15},
      {"upper_rim_pressure", 16},
      {"force_ratio", 17},
      {"nominal_area", 18},
      {"shift", 19},
      {"seat_force", 20}};
  for (const auto all :
       {contact::seat_quantities(), contact::rim_quantities()}) {
    for (const auto& quantity : all) {
      ASSERT_TRUE(expected.contains(quantity.key)) << quantity.key;
      EXPECT_EQ(contact::value_of(quantity, rim), expected.at(quantity.key))
          << quantity.key;
    }
  }
}

// Joints whose laws end where loads do not, each pair of laws that a ball and a
// pin may have, and the joints of files.
std::vector<JointSpec> joints_that_end() {
  const contact::Material rigid{infinity, 0};
  const contact::Material rubber{5e8, 0.5};
  const contact::Material steel{2.1e11, 0.3};
  const contact::LayeredBody lined{{{7.5e-4, rubber}},
                                   contact::Backing::rigid()};
  const contact::LayeredBody ring{{{4.5e-4, steel}}, contact::Backing::held()};
  const contact::FrictionLaw friction(0.1, 1e3);
  const auto ball = contact::JointGeometry::ball(0.01, 2e-5);
  const auto pin = contact::JointGeometry::pin(0.01, 2e-5, 0.02);
  std::vector<JointSpec> all = {
      {.geometry = pin.with_clearance(0),
       .inner = rigid,
       .outer = lined,
       .friction = friction},
      {.geometry = pin, .inner = rigid, .outer = lined, .friction = friction},
      {.geometry = pin, .inner = steel, .outer = ring, .friction = friction},
      {.geometry = ball,
       .inner = rubber,
       .outer = rigid,
       .friction = friction,
       .half_angle_law = "exact"}};
  for (const auto& geometry : {ball, pin}) {
    for (const std::string& half_angle : contact::half_angle_law_names()) {
      for (const std::string& pressure : contact::pressure_law_names()) {
        all.push_back({.geometry = geometry,
                       .inner = steel,
                       .outer = {{1e11, 0.34}},
                       .friction = friction,
                       .half_angle_law = half_angle,
                       .pressure_law = pressure});
      }
    }
  }
  for (const auto& entry :
       std::filesystem::directory_iterator(CONTACT_DATA_DIR "/joints")) {
    all.push_back(contact::read_joint(entry.path()));
  }
  return all;
}

template <class T>
void expect_numbers(std::span<const contact::Quantity<T>> all, const T& of,
                    const std::string& label) {
  for (const contact::Column<T>& column : contact::columns_of(all)) {
    const auto* q = column.quantity;
    if (q->exists && !q->exists(of)) continue;
    EXPECT_FALSE(std::isnan(column(of))) << label << ", " << column.name;
  }
}

// Numbers may be used where the status is ok: what is not known is not ok.
TEST(Quantities, AreNumbersWhereTheStatusIsOk) {
  using contact::Status;
  using Eigen::Vector3d;
  const Vector3d z = Vector3d::UnitZ();
  int without = 0;
  for (const JointSpec& spec : joints_that_end()) {
    const Joint joint(spec.without_seat().without_relief());
    const bool falls = !joint.contact().rest_refusal().empty();
    for (double load = 1e-9; load < 1e13; load *= 20) {
      const std::string label =
          spec.canonical_text() + "under " + std::to_string(load);
      const Vector3d reaction(load, 0, joint.is_pin() ? 0 : 0.3 * load);
      for (const double rate : {0.0, 0.1}) {
        for (const auto& s : {joint.solve({reaction, rate * z, z}),
                              joint.solve_contact({reaction, rate * z, z})}) {
          without += s.status != Status::ok;
          if (s.status != Status::ok) continue;
          expect_numbers(contact::solution_quantities(), s, label);
          const contact::SlidingContact sliding(joint.contact(), s, rate * z);
          expect_numbers(contact::rating_quantities(), sliding.rating(), label);
        }
        const auto step =
            contact::step(joint, {reaction, rate * z, z, z}, 1e-3 * identity);
        if (step.status == Status::ok) {
          expect_numbers(contact::step_quantities(), step, label);
        }
      }
      if (falls) continue;
      const auto rest = joint.at_rest({reaction, 1e-3 * load * z, z});
      if (rest.status == Status::ok) {
        expect_numbers(contact::rest_quantities(), rest, label);
      }
    }
  }
  // As many have none.
  EXPECT_GT(without, 100);
}

// The joints beside another one on an axis.
TEST(Quantities, OfGroupsAreNumbersWhereTheStatusIsOk) {
  using contact::Status;
  const contact::Material steel{2.1e11, 0.3};
  const auto plain = [&](const contact::JointGeometry& geometry) {
    return Joint(JointSpec{.geometry = geometry,
                           .inner = steel,
                           .outer = steel,
                           .friction = contact::FrictionLaw(0.1)});
  };
  const Joint ball = plain(contact::JointGeometry::ball(0.01, 2e-5));
  const Joint pin = plain(contact::JointGeometry::pin(0.01, 2e-5, 0.02));
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  int without = 0;
  for (const JointSpec& spec : joints_that_end()) {
    const Joint joint(spec.without_seat().without_relief());
    const contact::JointGroup group(
        {{joint, 0}, {joint.is_pin() ? ball : pin, 0.1}});
    for (double load = 1e-9; load < 1e13; load *= 20) {
      const std::string label =
          spec.canonical_text() + "under " + std::to_string(load);
      const Eigen::Vector3d reaction(load, 0, 0.3 * load);
      auto s = group.make_solution();
      const auto expect_known = [&] {
        without += s.status != Status::ok;
        if (s.status != Status::ok) return;
        EXPECT_TRUE(std::isfinite(s.friction_moment) &&
                    std::isfinite(s.power) && s.cross_moment.allFinite())
            << label;
        for (const contact::JointSolution& one : s.joints) {
          EXPECT_EQ(one.status, Status::ok) << label;
          expect_numbers(contact::solution_quantities(), one, label);
        }
      };
      for (const double rate : {0.1, 0.0}) {
        group.solve({reaction, {}, z, rate}, s);
        expect_known();
      }
      const double utilisation =
          group.utilisation({reaction, {}, z, 1e-3 * load}, s);
      expect_known();
      EXPECT_EQ(std::isnan(utilisation),
                s.status != Status::ok || joint.contact().stress() != nullptr)
          << label;
    }
  }
  EXPECT_GT(without, 100);
}

// Pins that end, and the forces of joints with play, which have notes
// in the place of a status.
TEST(Quantities, OfPinsThatEndAndOfPlayAreNumbersUnlessTheySayWhy) {
  using contact::Status;
  using Eigen::Vector2d;
  using Eigen::Vector3d;
  int pins = 0;
  int without = 0;
  for (const JointSpec& spec : joints_that_end()) {
    if (!spec.half_angle_law.empty() && spec.half_angle_law != "exact")
      continue;
    if (!spec.friction ||
        !std::holds_alternative<contact::FrictionLaw>(*spec.friction)) {
      continue;
    }
    const double length = spec.geometry.length();
    const double clearance = spec.geometry.radial_clearance();
    // A pin in an infinite body is pressed in without limit.
    if (clearance <= 0 ||
        (spec.geometry.kind() == contact::JointKind::pin &&
         spec.outer.backing.kind() == contact::Backing::Kind::medium)) {
      continue;
    }
    const std::string name = spec.canonical_text();
    std::optional<contact::ForceLaw> law;  // takes seconds for thin walls
    if (spec.geometry.kind() == contact::JointKind::pin) {
      const contact::FinitePin pin(spec);
      law = pin.force_law();
      ++pins;
      for (double load = 1e-9; load < 1e13; load *= 400) {
        const std::string label = name + "under " + std::to_string(load);
        const Vector2d reaction(load, 0);
        const contact::FinitePin::Motion motion{0.1, 1e-3};
        for (const auto& s : {pin.solve(reaction, {0, 0}, motion),
                              pin.solve(reaction, {1e-3, -2e-4}, motion),
                              pin.solve(reaction, {0, 0}, {0, 0}),
                              pin.solve_at(reaction, 0.1 * length, motion)}) {
          without += s.contact.status != Status::ok;
          if (s.contact.status != Status::ok) continue;
          const contact::FinitePinState& c = s.contact;
          for (const double x :
               {c.peak_pressure, c.largest_half_angle, c.end_pressure[0],
                c.end_pressure[1], c.end_half_angle[0], c.end_half_angle[1],
                s.axial_friction_force}) {
            EXPECT_FALSE(std::isnan(x)) << label;
          }
          EXPECT_TRUE(c.force_moment.allFinite()) << label;
          EXPECT_TRUE(c.stiffness.allFinite() && s.moment.allFinite()) << label;
          EXPECT_FALSE(std::isnan(pin.largest_pv(s.contact, motion))) << label;
          EXPECT_FALSE(std::isnan(pin.pressure(s.contact, 0, 0))) << label;
        }
      }
    }
    const contact::PlayJoint play(spec, {},
                                  law ? *law : contact::ForceLaw(spec));
    const std::optional<contact::JointImpact> impact =
        law ? std::nullopt : std::optional<contact::JointImpact>(spec);
    for (double share = 1e-9; share < 1e6; share *= 10) {
      const std::string label = name + "at " + std::to_string(share);
      const contact::PlayMotion motion = {
          {(1 + share) * clearance, 0, 0}, {1e-4, 2e-4, 0}, {0, 0, 0.5}};
      contact::PlayDerivatives derivatives;
      const contact::PlayForce force = play(motion, derivatives);
      if (play.notes(motion).empty()) {
        expect_numbers(contact::play_force_quantities(), force, label);
        EXPECT_TRUE(derivatives.allFinite()) << label;
      }
      if (!impact) continue;
      const contact::Impact hit = (*impact)({}, 1, share);
      if (impact->notes(hit, 0).empty()) {
        expect_numbers(contact::impact_quantities(), hit, label);
      }
    }
  }
  EXPECT_GE(pins, 3);
  EXPECT_GT(without, 50);
}

TEST(CQuantities, RefuseWhatIsNotThere) {
  const contact_solution s = {};
  double value;
  EXPECT_EQ(contact_solution_get(&s, "friction_momnet", &value),
            CONTACT_BAD_INPUT);
  EXPECT_EQ(std::string(contact_last_message())
                .find("unknown quantity \"friction_momnet\": did you mean "
                      "\"friction_moment\"?"),
            0u);
  EXPECT_EQ(contact_solution_get(nullptr, "power", &value), CONTACT_BAD_INPUT);
  EXPECT_EQ(contact_solution_get(&s, nullptr, &value), CONTACT_BAD_INPUT);
  EXPECT_EQ(contact_solution_get(&s, "power", nullptr), CONTACT_BAD_INPUT);
}

}  // namespace
}  // namespace contact::test::quantity_test
