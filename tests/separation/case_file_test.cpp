// Case files: what a good one means, and the one message that every bad one
// gives.
#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/case/system_of.hpp"
#include "support/error_message.hpp"

namespace {

namespace fs = std::filesystem;
using contact::degree;
using contact::test::error_message;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using multibody::HingeKind;
using separation::Case;
using separation::Event;
using separation::parse_case;

// A case line by line, so that a test can exchange one.
const std::vector<std::string> good_lines = {
    "name = \"test\"",                                        // 1
    "gravity_m_per_s2 = [0, 0, -9.81]",                       // 2
    "[run]",                                                  // 3
    "end_time_s = 2",                                         // 4
    "output_step_ms = 10",                                    // 5
    "[carrier]",                                              // 6
    "name = \"core\"",                                        // 7
    "mass_t = 1",                                             // 8
    "com_m = [1, 0, 0]",                                      // 9
    "principal_inertia_kg_m2 = [1, 2, 2]",                    // 10
    "[[body]]",                                               // 11
    "name = \"arm\"",                                         // 12
    "density_kg_per_m3 = 1000",                               // 13
    "[[body.shape]]",                                         // 14
    "kind = \"cylinder\"",                                    // 15
    "from_m = [0, 0, 0]",                                     // 16
    "to_m = [2, 0, 0]",                                       // 17
    "radius_mm = 100",                                        // 18
    "[body.pattern]",                                         // 19
    "count = 2",                                              // 20
    "axis = [1, 0, 0]",                                       // 21
    "[body.hinge]",                                           // 22
    "kind = \"axis\"",                                        // 23
    "carrier_point_m = [3, 0.5, 0]",                          // 24
    "axis = [0, 0, 2]",                                       // 25
    "[[body.hinge.joint]]",                                   // 26
    "file = \"" CONTACT_DATA_DIR "/joints/pin_joint.toml\"",  // 27
    "[body.lock]",                                            // 28
    "body_point_m = [2, 0, 0]",                               // 29
    "[[event]]",                                              // 30
    "name = \"open\"",                                        // 31
    "time_s = 0.5",                                           // 32
    "breaks = \"lock\"",                                      // 33
    "[[event]]",                                              // 34
    "name = \"off\"",                                         // 35
    "angle_deg = 30",                                         // 36
    "bodies = [\"arm 2\"]",                                   // 37
    "after = \"open\"",                                       // 38
    "breaks = \"hinge\"",                                     // 39
    "[[force]]",                                              // 40
    "name = \"engine\"",                                      // 41
    "body = \"arm\"",                                         // 42
    "kind = \"thrust\"",                                      // 43
    "point_m = [0, 0, 0]",                                    // 44
    "direction = [1, 0, 0]",                                  // 45
    "thrust_kN = 2",                                          // 46
    "cutoff_at_event = \"open\"",                             // 47
    "decay_s = 0.1",                                          // 48
};

std::string text_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

// The good case with a ball joint, line by line.
std::vector<std::string> ball_lines() {
  std::vector<std::string> lines = good_lines;
  lines[22] = "kind = \"ball\"";
  lines[24] = lines[25] = lines[26] = "";
  return lines;
}

// What reading the good case with line `number` (from 1) exchanged says.
std::string message_with_line(int number, const std::string& line) {
  std::vector<std::string> lines = good_lines;
  lines[number - 1] = line;
  return error_message([&] { parse_case(text_of(lines), "c.toml"); });
}

TEST(CaseFile, ReadsEverything) {
  const Case c = parse_case(text_of(good_lines), "c.toml");
  EXPECT_EQ(c.name, "test");
  EXPECT_EQ(c.end_time, 2);
  EXPECT_EQ(c.output_step, 0.01);
  EXPECT_EQ(c.options.gravity, Vector3d(0, 0, -9.81));
  EXPECT_EQ(c.carrier.mass, 1000);
  ASSERT_EQ(c.bodies.size(), 2U);
  const separation::Body& body = c.bodies[1];
  EXPECT_EQ(body.rigid.name, "arm 2");
  EXPECT_EQ(body.group, "arm");
  // A cylinder of water; its middle is the centre of mass.
  EXPECT_NEAR(body.rigid.mass, 1000 * std::numbers::pi * 0.01 * 2, 1e-12);
  EXPECT_LE((body.rigid.com - Vector3d(1, 0, 0)).norm(), 1e-15);
  EXPECT_NEAR(body.rigid.inertia(0, 0), body.rigid.mass * 0.01 / 2, 1e-12);
  EXPECT_LE((body.rigid.shapes[0].from - Vector3d(-1, 0, 0)).norm(), 1e-15);
  EXPECT_EQ(body.hinge.kind, HingeKind::axis);
  EXPECT_LE((body.hinge.body_point - Vector3d(-1, 0, 0)).norm(), 1e-15);
  // The second copy is turned by 180 deg about x.
  EXPECT_LE((body.hinge.carrier_point - Vector3d(2, -0.5, 0)).norm(), 1e-15);
  EXPECT_LE((body.hinge.axis - Vector3d(0, 0, -1)).norm(), 1e-15);
  EXPECT_TRUE(body.start.locked);
  EXPECT_EQ(body.hinge.joints.size(), 1U);
  ASSERT_EQ(c.events.size(), 2U);
  EXPECT_EQ(c.events[0].bodies, (std::vector<int>{0, 1}));
  EXPECT_EQ(c.events[0].trigger, Event::Trigger::time);
  EXPECT_EQ(c.events[1].bodies, std::vector<int>{1});
  EXPECT_EQ(c.events[1].after, 0);
  EXPECT_NEAR(c.events[1].value, 30 * degree, 1e-15);
  ASSERT_EQ(c.forces.size(), 2U);
  const auto& thrust = std::get<separation::Thrust>(c.forces[1].what);
  EXPECT_EQ(thrust.force, Vector3d(2000, 0, 0));
  EXPECT_EQ(thrust.cutoff.event, 0);
  // The carrier has no shape.
  ASSERT_EQ(c.clearance.size(), 1U);
  EXPECT_EQ(c.clearance[0].a, 1);
  EXPECT_EQ(c.clearance[0].b, 2);
}

TEST(CaseFile, AnglesOfTheAxisComeBack) {
  const Case c = parse_case(text_of(good_lines), "c.toml");
  const separation::Hinge& hinge = c.bodies[1].hinge;
  for (const double angle : {-3.0, -0.5, 0.0, 1e-9, 2.0, 3.1}) {
    const Matrix3d rotation =
        Eigen::AngleAxisd(angle, hinge.axis).toRotationMatrix() *
        hinge.zero_rotation;
    EXPECT_NEAR(separation::hinge_angle(hinge, rotation), angle, 1e-15);
  }
}

TEST(CaseFile, EveryBadLineHasItsMessage) {
  EXPECT_EQ(message_with_line(2, "gravity = 9.81"),
            "c.toml:2: gravity = 9.81: allowed: an array of 3 numbers");
  EXPECT_EQ(message_with_line(4, "end_time_s = -1"),
            "c.toml:4: run.end_time_s = -1: allowed: above 0 s");
  EXPECT_EQ(message_with_line(4, ""),
            "c.toml:3: run.end_time is missing: allowed: end_time (in s), "
            "end_time_s, end_time_ms");
  EXPECT_EQ(message_with_line(5, "output_step_s = 1e-9"),
            "c.toml:5: run.output_step_s = 1e-09: allowed: 1000000 rows at "
            "most");
  EXPECT_EQ(message_with_line(5, "ouput_step_s = 0.1"),
            "c.toml:5: run.ouput_step_s: unknown key: did you mean "
            "output_step_s?");
  EXPECT_EQ(message_with_line(8, "mass_t = nan"),
            "c.toml:8: carrier.mass_t = nan: allowed: above 0 t");
  EXPECT_EQ(message_with_line(10, "principal_inertia = [1, 2, 4]"),
            "c.toml:10: carrier.principal_inertia = [1, 2, 4]: allowed: "
            "principal moments of a body: none negative, none above the sum "
            "of the other two");
  EXPECT_EQ(message_with_line(10, ""),
            "c.toml:6: carrier.inertia is missing: there are no shapes to take "
            "it from");
  EXPECT_EQ(message_with_line(12, "name = \"core\""),
            "c.toml:12: body[1].name = \"core\": allowed: a name that no "
            "other body has");
  EXPECT_EQ(message_with_line(12, "name = \"a.b\""),
            "c.toml:12: body[1].name = \"a.b\": allowed: a name without . / "
            ", \" and line ends");
  EXPECT_EQ(message_with_line(15, "kind = \"box\""),
            "c.toml:15: body[1].shape[1].kind = \"box\": allowed: "
            "\"capsule\", \"cylinder\", \"cone\", \"hull\"");
  EXPECT_EQ(message_with_line(17, "to_m = [0, 0, 0]"),
            "c.toml:17: body[1].shape[1].to_m = [0, 0, 0]: allowed: a point "
            "apart from \"from\"");
  EXPECT_EQ(message_with_line(20, "count = 1"),
            "c.toml:20: body[1].pattern.count = 1: allowed: an integer, 2 to "
            "1000");
  std::vector<std::string> pin_on_a_ball_hinge = good_lines;
  pin_on_a_ball_hinge[22] = "kind = \"ball\"";
  pin_on_a_ball_hinge[24] = "";
  EXPECT_EQ(error_message(
                [&] { parse_case(text_of(pin_on_a_ball_hinge), "c.toml"); }),
            "c.toml:26: body[1].hinge.joint[1].kind: allowed: a ball joint on "
            "a ball hinge");
  EXPECT_EQ(message_with_line(25, "axis = [0, 0, 0]"),
            "c.toml:25: body[1].hinge.axis = [0, 0, 0]: allowed: a vector "
            "that "
            "is not 0");
  EXPECT_EQ(message_with_line(27, "file = \"none.toml\""),
            "c.toml:27: body[1].hinge.joint[1].file = \"none.toml\": "
            "none.toml: cannot be read: No such file or directory");
  EXPECT_EQ(message_with_line(29, "body_point_m = [0, 0, 0]"),
            "c.toml:29: body[1].lock.body_point_m = [0, 0, 0]: allowed: a "
            "point apart from the hinge");
  EXPECT_EQ(message_with_line(32, ""),
            "c.toml:30: event[1].time is missing: an event needs time, angle, "
            "reaction or after");
  EXPECT_EQ(message_with_line(32, "time_s = 1\nreaction_N = 3"),
            "c.toml:33: event[1].reaction_N = 3: allowed: not together with "
            "time");
  EXPECT_EQ(message_with_line(33, "breaks = \"weld\""),
            "c.toml:33: event[1].breaks = \"weld\": allowed: \"lock\", "
            "\"hinge\"");
  EXPECT_EQ(message_with_line(35, "name = \"open\""),
            "c.toml:35: event[2].name = \"open\": allowed: a name that no "
            "other event has");
  EXPECT_EQ(
      message_with_line(37, "bodies = [\"arm 3\"]"),
      "c.toml:37: event[2].bodies = [\"arm 3\"]: allowed: arm, arm 1, arm "
      "2");
  EXPECT_EQ(message_with_line(38, "after = \"opne\""),
            "c.toml:38: event[2].after = \"opne\": allowed: open");
  EXPECT_EQ(message_with_line(38, "after = \"off\""),
            "c.toml:38: event[2].after = \"off\": allowed: open");
  EXPECT_EQ(message_with_line(42, "body = \"tank\""),
            "c.toml:42: force[1].body = \"tank\": allowed: core, arm, arm 1, "
            "arm 2");
  EXPECT_EQ(message_with_line(43, "kind = \"glue\""),
            "c.toml:43: force[1].kind = \"glue\": allowed: \"applied\", "
            "\"thrust\", \"spring\", \"pusher\", \"motor\", \"aerodynamic\"");
  EXPECT_EQ(message_with_line(47, "cutoff_at_s = 1\ncutoff_delay_s = 1"),
            "c.toml:48: force[1].cutoff_delay_s = 1: allowed: with "
            "cutoff_at_event");
  EXPECT_EQ(message_with_line(47, ""),
            "c.toml:48: force[1].decay_s = 0.1: allowed: with cutoff_at or "
            "cutoff_at_event");
  EXPECT_EQ(message_with_line(48, "decays = 0.1"),
            "c.toml:48: force[1].decays: unknown key: did you mean decay?");
}

// Tables of other kinds of forces, in place of the engine.
std::string message_of_force(const std::string& text) {
  const std::vector<std::string> lines(good_lines.begin(),
                                       good_lines.begin() + 40);
  return error_message([&] { parse_case(text_of(lines) + text, "c.toml"); });
}

TEST(CaseFile, Forces) {
  EXPECT_EQ(message_of_force("name = \"f\"\nbody = \"arm\"\n"
                             "kind = \"applied\"\n"),
            "c.toml:40: force[1].force is missing: there is no moment "
            "either");
  EXPECT_EQ(message_of_force("name = \"f\"\nbody = \"arm\"\n"
                             "kind = \"applied\"\ntime_s = [0, 1]\n"
                             "force_N = [1, 0, 0]\n"),
            "c.toml:45: force[1].force_N = [1, 0, 0]: allowed: an array of 2 "
            "arrays of 3 numbers");
  EXPECT_EQ(message_of_force("name = \"f\"\nbody = \"arm\"\n"
                             "kind = \"applied\"\ntime_s = [1, 1]\n"
                             "force_N = [[1, 0, 0], [0, 0, 0]]\n"),
            "c.toml:44: force[1].time_s = [1, 1]: allowed: numbers that "
            "grow from one to the next");
  EXPECT_EQ(message_of_force("name = \"f\"\nbody = \"core\"\n"
                             "kind = \"pusher\"\n"),
            "c.toml:42: force[1].body = \"core\": allowed: a body");
  EXPECT_EQ(message_of_force("name = \"f\"\nbody = \"core\"\n"
                             "kind = \"motor\"\nmoment_N_m = 1\n"),
            "c.toml:42: force[1].body = \"core\": allowed: a body on an axis");
  const auto motor = [](const std::string& angles) {
    return message_of_force(
        "name = \"f\"\nbody = \"arm\"\nkind = \"motor\"\nangle_deg = " +
        angles + "\nmoment_N_m = [1, 0]\n");
  };
  EXPECT_EQ(motor("[-180, 1440]"), "(no error)");
  EXPECT_EQ(
      message_of_force("name = \"f\"\nbody = \"arm\"\nkind = \"aerodynamic\"\n"
                       "axis = [1, 0, 0]\nreference_area_m2 = 1\n"
                       "flow = [-1, 0, 0]\ndynamic_pressure_Pa = 10\n"
                       "angle_deg = [0, 10]\nnormal = [0, 0.1, 0.2]\n"),
      "c.toml:49: force[1].normal = [0, 0.1, 0.2]: allowed: an array of 2 "
      "numbers");
  EXPECT_EQ(
      message_of_force("name = \"f\"\nbody = \"arm\"\nkind = \"spring\"\n"
                       "point_m = [0, 0, 0]\ncarrier_point_m = [1, 0, 0]\n"
                       "stiffness_N_per_m = 10\nfree_length_m = 0.1\n"),
      "(no error)");
}

// The angle of a ball joint is that between two directions.
TEST(CaseFile, AnglesOfBallJointsEndAtHalfATurn) {
  std::vector<std::string> lines = ball_lines();
  const auto with_event = [&](const std::string& angle) {
    lines[35] = "angle_deg = " + angle;
    return error_message([&] { parse_case(text_of(lines), "c.toml"); });
  };
  EXPECT_EQ(with_event("0"), "(no error)");
  EXPECT_EQ(with_event("180"), "(no error)");
  EXPECT_EQ(with_event("180.1"),
            "c.toml:36: event[2].angle_deg = 180.1: allowed: 0 deg to 180 deg "
            "on the ball hinge of body \"arm 2\": it is the angle between "
            "two directions");
  EXPECT_EQ(with_event("-1"),
            "c.toml:36: event[2].angle_deg = -1: allowed: 0 deg to 180 deg on "
            "the ball hinge of body \"arm 2\": it is the angle between "
            "two directions");
  lines[35] = "angle_deg = 30";
  const auto with_table = [&](const std::string& angles) {
    return error_message([&] {
      parse_case(text_of(lines) +
                     "[[force]]\nname = \"f\"\nbody = \"arm\"\n"
                     "kind = \"applied\"\nangle_deg = " +
                     angles + "\nforce_N = [[1, 0, 0], [0, 0, 0]]\n",
                 "c.toml");
    });
  };
  EXPECT_EQ(with_table("[0, 180]"), "(no error)");
  EXPECT_EQ(with_table("[0, 181]"),
            "c.toml:53: force[2].angle_deg = [0, 181]: allowed: 0 deg to 180 "
            "deg on a ball hinge: it is the angle between two directions");
  EXPECT_EQ(with_table("[-1, 90]"),
            "c.toml:53: force[2].angle_deg = [-1, 90]: allowed: 0 deg to 180 "
            "deg on a ball hinge: it is the angle between two directions");
}

TEST(CaseFile, ForcesEndAfterTheyBegin) {
  const auto clocks = [](const std::string& keys) {
    return message_of_force(
        "name = \"f\"\nbody = \"arm\"\nkind = \"applied\"\n"
        "force_N = [1, 0, 0]\n" +
        keys);
  };
  EXPECT_EQ(clocks("starts_at_s = 1\nends_at_s = 1.5\n"), "(no error)");
  EXPECT_EQ(clocks("starts_at_s = 1\nends_at_ms = 500\n"),
            "c.toml:46: force[1].ends_at_ms = 500: allowed: later than the "
            "force begins, 1 s");
  EXPECT_EQ(clocks("ends_at_s = 0\n"),
            "c.toml:45: force[1].ends_at_s = 0: allowed: later than the force "
            "begins, 0 s");
  const std::string open = "starts_at_event = \"open\"\n";
  EXPECT_EQ(clocks(open + "ends_at_event = \"open\"\nends_delay_s = 1\n"),
            "(no error)");
  EXPECT_EQ(clocks(open + "ends_at_event = \"off\"\n"), "(no error)");
  EXPECT_EQ(clocks(open + "ends_at_event = \"open\"\n"),
            "c.toml:46: force[1].ends_at_event = \"open\": allowed: later than "
            "the force begins, 0 s after the event");
  EXPECT_EQ(clocks(open + "starts_delay_s = 2\nends_at_event = \"open\"\n"
                          "ends_delay_s = 1\n"),
            "c.toml:48: force[1].ends_delay_s = 1: allowed: later than the "
            "force begins, 2 s after the event");
}

TEST(CaseFile, NamesOfBodiesAndColumnsAreTheirOwn) {
  // "arm" stands for its copies "arm 1" and "arm 2".
  const auto named = [](const std::string& name) {
    return error_message([&] {
      parse_case(text_of(good_lines) + "[[body]]\nname = \"" + name +
                     "\"\nmass_kg = 1\nprincipal_inertia_kg_m2 = "
                     "[1, 1, 1]\n",
                 "c.toml");
    });
  };
  for (const std::string name : {"arm", "arm 2", "core"}) {
    EXPECT_EQ(named(name), "c.toml:50: body[2].name = \"" + name +
                               "\": allowed: a name that no other body has");
  }
  EXPECT_EQ(named("arm_2"),
            "c.toml:50: body[2].name = \"arm_2\": allowed: a name that is not "
            "that of \"arm 2\" in columns, where blanks are underscores");
}

TEST(CaseFile, DirectionsOfABallJointComeInPairs) {
  std::vector<std::string> lines = ball_lines();
  lines[13] =
      "direction = [{ name = \"along\", vector = [1, 0, 0] }]\n" + lines[13];
  lines[9] +=
      "\n[[carrier.direction]]\nname = \"axis\"\nvector = [1, 0, 0]"
      "\n[[carrier.direction]]\nname = \"up\"\nvector = [0, 1, 0]";
  const std::string text = text_of(lines);
  const auto with = [&](const std::string& keys) {
    const std::string place = "[body.hinge]\n";
    std::string all = text;
    all.insert(all.find(place) + place.size(), keys);
    return error_message([&] { parse_case(all, "c.toml"); });
  };
  const std::string along = "body_direction = \"along\"\n";
  EXPECT_EQ(with(""), "(no error)");
  EXPECT_EQ(with(along + "carrier_direction = \"up\"\n"), "(no error)");
  EXPECT_EQ(with(along),
            "c.toml:30: body[1].hinge.body_direction = \"along\": allowed: "
            "together with carrier_direction");
  EXPECT_EQ(with("carrier_direction = \"axis\"\n"),
            "c.toml:30: body[1].hinge.carrier_direction = \"axis\": allowed: "
            "together with body_direction");
  EXPECT_EQ(with(along + "carrier_direction = \"axes\"\n"),
            "c.toml:31: body[1].hinge.carrier_direction = \"axes\": allowed: "
            "axis, up, the directions of \"core\"");
  std::vector<std::string> none = ball_lines();
  none[24] = "body_direction = \"a\"";
  none[25] = "carrier_direction = \"a\"";
  EXPECT_EQ(error_message([&] { parse_case(text_of(none), "c.toml"); }),
            "c.toml:25: body[1].hinge.body_direction = \"a\": \"arm\" has no "
            "directions");
}

TEST(CaseFile, KeysOfTheOtherIntegratorAreRefused) {
  const auto with = [](const std::string& keys) {
    return message_with_line(5, keys);
  };
  EXPECT_EQ(with("step_ms = 5"),
            "c.toml:5: run.step_ms = 5: allowed: with integrator = \"rk4\"");
  EXPECT_EQ(with("step_ms = 5\nintegrator = \"rk4\""), "(no error)");
  EXPECT_EQ(with("longest_step_s = 5\nintegrator = \"rk4\""),
            "c.toml:5: run.longest_step_s = 5: allowed: with integrator = "
            "\"adaptive\"");
  EXPECT_EQ(with("relative_tolerance = 1e-6\nintegrator = \"rk4\""),
            "c.toml:5: run.relative_tolerance = 1e-06: allowed: with "
            "integrator = \"adaptive\"");
  EXPECT_EQ(with("absolute_tolerance = 1e-6\nintegrator = \"rk4\""),
            "c.toml:5: run.absolute_tolerance = 1e-06: allowed: with "
            "integrator = \"adaptive\"");
  EXPECT_EQ(with("longest_step_s = 5\nrelative_tolerance = 1e-6\n"
                 "absolute_tolerance = 1e-6"),
            "(no error)");
}

TEST(CaseFile, DistancesAreOfTwoBodies) {
  const auto pairs = [](const std::string& a, const std::string& b) {
    return text_of(good_lines) + "[[clearance]]\na = \"" + a + "\"\nb = \"" +
           b + "\"\n";
  };
  EXPECT_EQ(
      error_message([&] { parse_case(pairs("arm 1", "arm 1"), "c.toml"); }),
      "c.toml:51: clearance[1].b = \"arm 1\": allowed: another body than "
      "a");
  // The copies of a body against each other.
  EXPECT_EQ(parse_case(pairs("arm", "arm"), "c.toml").clearance.size(), 1U);
}

TEST(CaseFile, LocksOfAxesHaveALeverArm) {
  // On the axis, which is along z through the body's origin.
  EXPECT_EQ(message_with_line(29, "body_point_m = [0, 0, 0.3]"),
            "c.toml:29: body[1].lock.body_point_m = [0, 0, 0.3]: allowed: a "
            "point off the hinge's axis: on it a lock holds nothing");
  EXPECT_EQ(message_with_line(29, "body_point_m = [0, 1e-6, 0.3]"),
            "(no error)");
  // The axis is given in carrier axes: along x of a body turned about y.
  const std::string turned =
      "axis = [0, 0, 1]\nzero_rotation_deg = [0, -90, 0]";
  std::vector<std::string> lines = good_lines;
  lines[24] = turned;
  lines[28] = "body_point_m = [0.7, 0, 0]";
  EXPECT_NE(error_message([&] {
              parse_case(text_of(lines), "c.toml");
            }).find("a point off the hinge's axis"),
            std::string::npos);
  lines[28] = "body_point_m = [0, 0, 0.7]";
  EXPECT_EQ(error_message([&] { parse_case(text_of(lines), "c.toml"); }),
            "(no error)");
  // A ball joint turns about any line.
  lines = ball_lines();
  lines[28] = "body_point_m = [0, 0, 0.3]";
  EXPECT_EQ(error_message([&] { parse_case(text_of(lines), "c.toml"); }),
            "(no error)");
}

// Before what is missing for want of them.
TEST(CaseFile, MisspeltNamesAreReportedFirst) {
  EXPECT_EQ(message_with_line(3, "[runs]"),
            "c.toml:3: runs: unknown key: did you mean run?");
  EXPECT_EQ(message_with_line(6, "[carier]"),
            "c.toml:6: carier: unknown key: did you mean carrier?");
  // Where a table inside makes one of the right name.
  EXPECT_EQ(message_with_line(6, "[carrier.start]\n[carier]"),
            "c.toml:7: carier: unknown key: did you mean carrier?");
  EXPECT_EQ(message_with_line(4, "end_tiem_s = 2"),
            "c.toml:4: run.end_tiem_s: unknown key: did you mean end_time_s?");
  std::vector<std::string> lines = good_lines;
  lines[21] = "[body.hinges]";
  lines[25] = "[[body.hinges.joint]]";
  EXPECT_EQ(error_message([&] { parse_case(text_of(lines), "c.toml"); }),
            "c.toml:22: body[1].hinges: unknown key: did you mean hinge?");
  EXPECT_EQ(message_with_line(1, ""), "c.toml:1: name is missing");
  EXPECT_EQ(error_message([] { parse_case("name = \"x\"\n", "c.toml"); }),
            "c.toml:1: the table [run] is missing");
  EXPECT_EQ(error_message([] {
              parse_case(text_of({good_lines.begin(), good_lines.begin() + 10}),
                         "c.toml");
            }),
            "c.toml:1: body is missing: a case has one or more [[body]]");
  // These are keys of their own, not "kind" and "axis".
  EXPECT_EQ(message_of_force("name = \"f\"\nbody = \"arm\"\n"
                             "wind = [1, 0, 0]\n"),
            "c.toml:40: force[1].kind is missing (is it wind in line 43?)");
  EXPECT_EQ(message_of_force("name = \"f\"\nbody = \"arm\"\n"
                             "kind = \"aerodynamic\"\naxial = [1]\n"),
            "c.toml:40: force[1].axis is missing");
}

// Before everything else that is wrong: here the line before, or what follows
// from it.
TEST(CaseFile, UnknownKeysComeFirst) {
  // A file of its own for each of the good case's tables that has keys.
  for (const int table : {3, 6, 11, 14, 19, 22, 26, 28, 30, 40}) {
    std::vector<std::string> lines = good_lines;
    lines[0] = "";
    lines[3] = "end_time_s = -1";
    lines[table - 1] += "\nzeta_N = 1";
    const std::string message =
        error_message([&] { parse_case(text_of(lines), "c.toml"); });
    EXPECT_TRUE(message.starts_with("c.toml:" + std::to_string(table + 1)) &&
                message.find("zeta_N: unknown key: allowed: ") != message.npos)
        << message;
  }
  // A unit that the key does not have: without it the node is indeterminate.
  std::vector<std::string> lines = good_lines;
  lines[26] += "\n[[body.hinge.joint]]\n" + lines[26] + "\nposition_m = 1";
  lines[24] += "\nradial_stiffness_N_per_m = [1, 1]\naxial_share = [0, 1]";
  EXPECT_EQ(error_message([&] { parse_case(text_of(lines), "c.toml"); }),
            "c.toml:26: body[1].hinge.radial_stiffness_N_per_m: unknown key: "
            "did you mean radial_stiffness?");
  // Of another kind.
  EXPECT_EQ(message_with_line(46, "free_length_m = 1"),
            "c.toml:46: force[1].free_length_m: unknown key: allowed: body, "
            "cutoff_at, cutoff_at_event, cutoff_delay, decay, direction, "
            "ends_at, ends_at_event, ends_delay, kind, name, point, "
            "starts_at, starts_at_event, starts_delay, thrust");
  EXPECT_EQ(
      message_with_line(25, "carrier_direction = \"x\""),
      "c.toml:25: body[1].hinge.carrier_direction: unknown key: "
      "allowed: axial_share, axis, body_point, carrier_point, joint, kind, "
      "name, radial_stiffness, sharing, zero_rotation");
}

TEST(CaseFile, ForcesHaveNamesOfTheirOwn) {
  std::vector<std::string> lines = good_lines;
  for (std::size_t i = 39; i < 48; ++i) lines.push_back(good_lines[i]);
  EXPECT_EQ(error_message([&] { parse_case(text_of(lines), "c.toml"); }),
            "c.toml:50: force[2].name = \"engine\": allowed: a name that no "
            "other force has");
  lines[49] = "name = \"engine 2\"";
  EXPECT_EQ(parse_case(text_of(lines), "c.toml").forces.size(), 4U);
}

TEST(CaseFile, EventsDoNotWaitForThemselves) {
  EXPECT_EQ(message_with_line(32, "after = \"off\""),
            "c.toml:32: event[1].after = \"off\": allowed: an event that does "
            "not wait for this one: open after off after open");
  // Three in a circle, and one that waits for them.
  std::vector<std::string> lines = good_lines;
  lines[29] =
      "[[event]]\nname = \"first\"\nafter = \"open\"\n"
      "breaks = \"lock\"\n" +
      lines[29];
  lines[31] = "after = \"third\"";
  lines[38] +=
      "\n[[event]]\nname = \"third\"\nafter = \"off\"\n"
      "breaks = \"lock\"";
  EXPECT_EQ(error_message([&] { parse_case(text_of(lines), "c.toml"); }),
            "c.toml:36: event[2].after = \"third\": allowed: an event that "
            "does not wait for this one: open after third after off after "
            "open");
}

// What a file says, however it is written.
TEST(CaseFile, ContentIsThatOfTheText) {
  const auto content = [](const std::string& text) {
    return contact::TomlTable::from_text(text, "t.toml").canonical_text();
  };
  const std::string text = content(
      "a = 1\nb = \"x\"\n[t]\nc = [1, 2.5]\nd = { e = true }\n"
      "[[u]]\n[[u]]\nf = 1979-05-27\n");
  EXPECT_EQ(text, content("# first\nb   = 'x' # b\na = 1.0\n\n[[u]]\n[[u]]\n"
                          "f = 1979-05-27\n\n[t.d]\ne = true\n"
                          "[t]\nc = [ 0x1,\n 25e-1, ] \n"));
  for (const char* other :
       {"a = 2\nb = \"x\"\n[t]\nc = [1, 2.5]\nd = { e = true }\n"
        "[[u]]\n[[u]]\nf = 1979-05-27\n",
        "a = 1\nb = \"y\"\n[t]\nc = [1, 2.5]\nd = { e = true }\n"
        "[[u]]\n[[u]]\nf = 1979-05-27\n",
        "a = 1\nb = \"x\"\n[t]\nc = [2.5, 1]\nd = { e = true }\n"
        "[[u]]\n[[u]]\nf = 1979-05-27\n",
        "a = 1\nb = \"x\"\n[t]\nc = [1, 2.5]\nd = { e = false }\n"
        "[[u]]\n[[u]]\nf = 1979-05-27\n",
        "a = 1\nb = \"x\"\n[t]\nc = [1, 2.5]\nd = { e = true }\n"
        "[[u]]\nf = 1979-05-27\n[[u]]\n"}) {
    EXPECT_NE(text, content(other)) << other;
  }
  // Texts end where they end, and long lists are whole.
  EXPECT_NE(content("a = \"b,1:c=\\\"1:d\""), content("a = \"b\"\nc = \"d\""));
  std::string list = "a = [0";
  for (int i = 1; i < 200; ++i) list += ", " + std::to_string(i);
  EXPECT_NE(content(list + ", 200]"), content(list + ", 201]"));
}

// Joints of one file are told apart.
TEST(CaseFile, JointsOfAFileHaveNamesOfTheirOwn) {
  std::vector<std::string> lines = good_lines;
  lines[26] += "\nname = \"left pin\"";
  const Case c = parse_case(text_of(lines), "c.toml");
  EXPECT_EQ(c.bodies[0].hinge.joints[0].joint.name, "left pin");
}

std::vector<const contact::JointContact*> contacts(const Case& c) {
  std::vector<const contact::JointContact*> all;
  for (const separation::Body& body : c.bodies) {
    for (const auto& joint : body.hinge.joints) all.push_back(&joint.contact);
  }
  return all;
}

// The good case with a second body, whose joint names the same file.
std::string with_second_body() {
  std::vector<std::string> lines = good_lines;
  std::vector<std::string> body(lines.begin() + 10, lines.begin() + 29);
  body[1] = "name = \"leg\"";
  lines.insert(lines.begin() + 29, body.begin(), body.end());
  return text_of(lines);
}

TEST(CaseFile, JointsThatAreAlikeShareTheirLaws) {
  const fs::path cases = fs::path(CONTACT_DATA_DIR) / "cases";
  const Case arms = separation::read_case(cases / "platform.toml");
  const Case one_file =
      parse_case(with_second_body(), "c.toml", {"exact", "exact"});
  ASSERT_EQ(contacts(arms).size(), 6U);
  ASSERT_EQ(contacts(one_file).size(), 4U);
  for (const Case* c : {&arms, &one_file}) {
    const auto all = contacts(*c);
    for (const contact::JointContact* other : all) {
      EXPECT_EQ(&other->half_angle_law(), &all[0]->half_angle_law());
      EXPECT_EQ(&other->pressure_law(), &all[0]->pressure_law());
    }
  }
}

TEST(CaseFile, LawsOfTheCommandLineAreTaken) {
  const Case c = parse_case(text_of(good_lines), "c.toml", {"tanh", ""});
  EXPECT_EQ(c.bodies[0].hinge.joints[0].joint.half_angle_law, "tanh");
  const auto message = [](const separation::JointLaws& laws) {
    return error_message(
        [&] { parse_case(text_of(good_lines), "c.toml", laws); });
  };
  EXPECT_EQ(
      message({"blend:x", ""}),
      "--law blend:x: joint \"pin joint, 40 mm steel pin in bronze\": "
      "half-angle law blend:x: allowed: blend:K with K a number from 0 to 1");
  EXPECT_EQ(message({"", "tahn"}),
            "--pressure tahn: joint \"pin joint, 40 mm steel pin in bronze\": "
            "pressure law tahn: allowed: cosine, sqrt_tan, sqrt_theta, "
            "mixture, exact");
}

TEST(CaseFile, AllCasesOfTheProjectAreGood) {
  int count = 0;
  for (const auto& file :
       fs::directory_iterator(fs::path(CONTACT_DATA_DIR) / "cases")) {
    EXPECT_NO_THROW(separation::read_case(file.path())) << file.path();
    ++count;
  }
  EXPECT_GE(count, 5);
}

}  // namespace
