// JointSpec: one value from which everything about a joint follows, its text,
// and the input that JointContact rejects.
#include "libcontact/joint/spec.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string>
#include <utility>

#include "libcontact/base/units.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "libcontact/half_angle/fitted.hpp"
#include "libcontact/joint/contact_notes.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/exact.hpp"
#include "libcontact/pressure/mixture.hpp"
#include "support/error_message.hpp"
#include "support/every_joint.hpp"

namespace contact::test::spec_test {
namespace {

const Material steel{2.1e11, 0.3, "steel"};
const Material bronze{1.1e11, 0.34, "bronze"};
const Material liner{3e9, 0.4, "liner"};

JointSpec lined_ball() {
  return {.geometry = JointGeometry::ball(0.02, 40e-6),
          .inner = steel,
          .outer = {{{0.004, liner}}, Backing::medium(steel)},
          .friction = FrictionLaw(0.1)};
}

// The text of a joint is a joint file that gives an equal joint, and the same
// text, for every kind of friction and wall.
TEST(JointSpec, CanonicalTextComesBack) {
  for (const JointText& given : every_joint()) {
    const JointSpec joint = parse_joint(given.toml, given.name);
    const std::string text = joint.canonical_text();
    const JointSpec again = parse_joint(text, "text");
    EXPECT_EQ(again, joint) << given.name << '\n' << text;
    EXPECT_EQ(again.canonical_text(), text) << given.name;
  }
}

TEST(JointSpec, CanonicalTextHasFitsLawsAndLoading) {
  const std::string bodies =
      "[materials.inner]\nyoungs_modulus_GPa = inf\n[materials.outer]\n"
      "youngs_modulus_GPa = 3\npoissons_ratio = 0.4\n";
  const JointSpec fitted = parse_joint(
      "name = \"a\\tb\"\nkind = \"pin\"\ninner_body = \"body\"\n[geometry]\n"
      "diameter_mm = 50\nhole = \"H7\"\nshaft = \"g6\"\nclearance = "
      "\"maximum\"\nlength_mm = 30\n" +
          bodies +
          "[half_angle]\nlaw = \"blend:0.3\"\nlimit_half_angle_deg = 80\n"
          "degrees_per_radian = 57.3\n[pressure]\nlaw = \"cosine\"\n"
          "[relief]\nkind = \"ends\"\ndepth_um = 7\nrelieved_length_mm = 5\n",
      "fit");
  EXPECT_EQ(fitted.relief, Relief::ends(7e-6, 5e-3));
  EXPECT_EQ(parse_joint(fitted.canonical_text(), "text"), fitted);
  const JointSpec pressed = parse_joint(
      "name = \"b\"\nkind = \"ball\"\n[geometry]\nradius_mm = 20\n"
      "relative_clearance = 1e-3\n" +
          bodies +
          "[half_angle]\nlaw = \"exact\"\n[loading]\nkind = \"back\"\n"
          "patch_half_angle_deg = 20\n",
      "loading");
  EXPECT_EQ(parse_joint(pressed.canonical_text(), "text"), pressed);
}

// Every property of a joint counts in a comparison.
TEST(JointSpec, ADifferenceAnywhereIsSeen) {
  const JointSpec joint = lined_ball();
  std::vector<JointSpec> others(16, joint);
  others[0].name = "b";
  others[1].geometry = JointGeometry::ball(0.02, 41e-6);
  others[2].geometry = JointGeometry::ball(0.02, 40e-6, JointBody::body);
  others[3].inner = bronze;
  others[4].outer.layers[0].thickness = 0.005;
  others[5].outer.backing = Backing::rigid();
  others[6].friction = FrictionLaw(0.1, 1);
  others[7].friction = FrictionStress::stribeck(0.1, 0.05, 0.01);
  others[8].friction = FrictionStress::stribeck(0.1, 0.05, 0.02);
  others[9].half_angle_law = "fitted";
  others[10].pressure_law = "worn";
  others[11].loading = InnerLoading::back(0.1);
  others[12].relief = Relief::barrel(1e-5);
  others[13].relief = Relief::ends(1e-5, 0.01);
  others[14].geometry = joint.geometry.with_seat(SeatZone::cup(1));
  others[15].geometry = joint.geometry.with_seat(SeatZone(0.5, 1));
  for (std::size_t i = 0; i < others.size(); ++i) {
    EXPECT_NE(others[i], joint) << i;
    EXPECT_NE(others[i].canonical_text(), joint.canonical_text()) << i;
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_NE(others[i], others[k]) << i << ' ' << k;
    }
  }
  EXPECT_EQ(lined_ball(), joint);
}

TEST(JointSpec, OwnFrictionIsEqualToItsCopies) {
  const FrictionStress::Function half = [](double p, double) { return p / 2; };
  const FrictionStress one(half, FrictionStress::OverSpeed::constant);
  const FrictionStress copy = one;
  const FrictionStress other(half, FrictionStress::OverSpeed::constant);
  EXPECT_EQ(one, copy);
  EXPECT_NE(one, other);
}

// The laws that a spec names take its walls.
TEST(JointSpec, GivesTheLawsOfItsWalls) {
  const JointSpec joint = lined_ball();
  EXPECT_EQ(joint.half_angle_law_name(), "exact");
  const LayeredPair walls(0.02, steel, joint.outer);
  const auto ball = JointKind::ball;
  const JointContact by_hand(joint.geometry, walls.surfaces(), *joint.friction,
                             std::make_shared<ExactLaw>(ball, walls),
                             std::make_shared<ExactPressure>(ball, walls),
                             {.walls = walls});
  const Joint::Slip slip = {{100, 0, 2000}, {0.3, 0, 1}};
  EXPECT_EQ(Joint(joint).solve(slip).friction_moment,
            Joint(by_hand).solve(slip).friction_moment);
  JointSpec plain = joint;
  plain.outer = liner;
  EXPECT_EQ(plain.half_angle_law_name(), "fitted");
}

std::string refusal(const ElasticPair& pair,
                    std::shared_ptr<const HalfAngleLaw> law,
                    std::shared_ptr<const PressureLaw> pressure,
                    const ContactConditions& conditions = {}) {
  return error_message([&] {
    JointContact(JointGeometry::ball(0.02, 40e-6), pair, FrictionLaw(0.1),
                 std::move(law), std::move(pressure), conditions);
  });
}

// Laws of another joint would give plausible numbers.
TEST(JointContact, RefusesLawsOfAnotherJoint) {
  const auto ball = JointKind::ball;
  const ElasticPair pair(steel, bronze), other(steel, liner);
  const LayeredPair walls(0.02, steel, lined_ball().outer);
  const ContactConditions walled{.walls = walls};
  const auto half_angle = [&](const char* name, const ElasticPair& of) {
    return std::shared_ptr(make_half_angle_law(name, ball, of));
  };
  const auto pressure = [&](const char* name, const ElasticPair& of) {
    return std::shared_ptr(make_pressure_law(name, ball, of));
  };
  for (const std::string& name : half_angle_law_names()) {
    const auto law = half_angle(name.c_str(), other);
    const std::string message = refusal(pair, law, pressure("cosine", pair));
    if (name == "hertz") {
      EXPECT_EQ(message, "(no error)");
    } else {
      EXPECT_EQ(message, "ball joint: half-angle law " + law->name() +
                             " must be made for the materials, the loading and "
                             "the walls of this joint");
    }
    EXPECT_EQ(
        refusal(pair, half_angle(name.c_str(), pair), pressure("cosine", pair)),
        "(no error)");
    EXPECT_NE(
        refusal(walls.surfaces(), half_angle(name.c_str(), walls.surfaces()),
                std::make_shared<ExactPressure>(ball, walls), walled),
        "(no error)")
        << name << " does not know walls";
  }
  for (const std::string& name : pressure_law_names()) {
    const std::string message =
        refusal(pair, half_angle("hertz", pair), pressure(name.c_str(), other));
    EXPECT_EQ(message != "(no error)", name == "mixture" || name == "exact")
        << name << ": " << message;
  }
  const auto exact = std::make_shared<ExactLaw>(ball, walls);
  EXPECT_NE(refusal(walls.surfaces(), exact, pressure("worn", pair)),
            "(no error)")
      << "walls that are not named";
  EXPECT_EQ(refusal(walls.surfaces(), exact, pressure("worn", pair), walled),
            "(no error)");
  const LayeredPair wider(0.021, steel, lined_ball().outer);
  EXPECT_EQ(refusal(wider.surfaces(), exact, pressure("worn", pair),
                    {.walls = wider}),
            "ball joint: radius of its walls = 0.021 m must be the joint's, "
            "0.02 m");
}

// Names, limits and roundings of converted units make no other joint.
TEST(JointContact, TakesLawsOfTheSameConstants) {
  const auto ball = JointKind::ball;
  const Material nameless{2.1e11 * (1 + 2e-16), 0.3};
  const ElasticPair pair(steel, bronze), same(nameless, {1.1e11, 0.34});
  EXPECT_EQ(refusal(pair, std::make_shared<FittedLaw>(ball, same),
                    std::make_shared<MixturePressure>(ball, same)),
            "(no error)");
  // The ratios alone count: a pair of another scale serves.
  const auto ratio = ElasticPair::from_modulus_ratio(2.1 / 1.1, 0.3, 0.34);
  EXPECT_EQ(refusal(pair, std::make_shared<FittedLaw>(ball, ratio),
                    std::make_shared<MixturePressure>(ball, ratio)),
            "(no error)");
}

// Notes of several rows, or threads, cover all of them.
TEST(ContactNotes, AddUp) {
  const JointSpec spec{.geometry = JointGeometry::ball(0.033, 1e-5)
                                       .with_seat(SeatZone::ring(0.028, 0.033)),
                       .inner = Material{2e11, 0.3, "a", 1e8},
                       .outer = Material{1e11, 0.3, "b", 1e8},
                       .friction = FrictionLaw(0.1)};
  const Joint joint(spec);
  const Joint endless(spec.without_seat());
  const JointSolution large =
      endless.solve({{5e5, 0, 0}, Eigen::Vector3d::UnitZ()});
  JointSolution lost;
  lost.status = Status::out_of_seat;
  ContactNotes first;
  first.add(endless, large);
  ContactNotes second;
  second.add(joint, lost);
  const auto of_first = first.notes(joint);
  const auto of_second = second.notes(joint);
  EXPECT_GE(of_first.size(), 1u);
  EXPECT_GE(of_second.size(), 1u);
  EXPECT_NE(of_first, of_second);
  std::set<std::string> expected(of_first.begin(), of_first.end());
  expected.insert(of_second.begin(), of_second.end());
  for (const auto& [one, other] : {std::pair(first, second), {second, first}}) {
    ContactNotes all = one;
    all.add(other);
    const auto notes = all.notes(joint);
    EXPECT_EQ(std::set<std::string>(notes.begin(), notes.end()), expected);
  }
}

}  // namespace
}  // namespace contact::test::spec_test
