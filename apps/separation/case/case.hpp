// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/joint/group.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/joint/spec.hpp"
#include "multibody/motion/motion.hpp"
#include "separation/case/shape.hpp"

/// A separation as described by its case file
/// (libcontact/docs/reference/case_file.md).
///
/// Body axes: directions as in the file, origin at the centre of mass; the
/// origin of the file is discarded after reading. rigid_body(0) is the carrier,
/// rigid_body(1 + i) belongs to bodies[i].
namespace separation {

struct NamedDirection {
  std::string name;
  Eigen::Vector3d vector;  ///< unit, body axes
};

struct RigidBody {
  std::string name;
  double mass = 0;  ///< kg
  /// In the file's axes of the body, m.
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  /// About the centre of mass, kg m^2.
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  /// A carrier fixed in inertial space: mass, com and inertia are 0.
  bool fixed = false;
  std::vector<Shape> shapes;
  std::vector<NamedDirection> directions;
};

/// A joint of a hinge: its joint file and its position.
struct HingeJoint {
  contact::JointSpec joint;
  double position;  ///< along the axis from the hinge's centre, m
  /// The joint for solutions. Identical joints of the case share laws.
  contact::Joint model;

  const contact::JointContact& contact() const { return model.contact(); }
};

/// End of the rotation of a hinge.
struct HingeStop {
  double angle = 0;        ///< rad
  int side = 1;            ///< 1: the body is at larger angles, -1: at smaller
  double restitution = 0;  ///< e
  double stiffness = 0;    ///< compliant stop, N m; 0: rigid
  double damping = 0;      ///< X = a v0 of contact::HuntCrossley

  bool is_rigid() const { return stiffness == 0; }
  /// Distance of the body from the stop, rad.
  double gap(double at) const { return side * (at - angle); }
};

/// Path and factors of the torque margin of a hinge.
struct MarginPath {
  double from, to;             ///< rad
  double friction_factor = 1;  ///< of resisting friction
  double other_factor = 1;     ///< of other resisting moments
  double spring_factor = 1;    ///< of driving torsion springs
  /// Least ratio that a standard requires, and its name; 0: none.
  double required = 0;
  std::string_view standard = {};
};

/// The upper node, on which a body turns.
struct Hinge {
  std::string name;
  /// The rigid body that carries the hinge, the parent: the carrier or another
  /// body.
  int on = 0;
  multibody::HingeKind kind = multibody::HingeKind::none;
  /// Axes of the body and of its parent, m.
  Eigen::Vector3d body_point = Eigen::Vector3d::Zero();
  Eigen::Vector3d parent_point = Eigen::Vector3d::Zero();
  /// Body axes to parent axes at angle zero.
  Eigen::Matrix3d zero_rotation = Eigen::Matrix3d::Identity();
  /// axis: unit, parent axes.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  std::vector<HingeJoint> joints;
  /// axis: shares of an indeterminate node.
  std::optional<contact::JointGroup::Sharing> sharing;
  /// axis: carries the force along it, beside pins.
  std::optional<contact::ThrustFace> thrust_face;
  /// ball: the hinge's angle lies between these directions.
  Eigen::Vector3d body_direction = Eigen::Vector3d::UnitX();
  Eigen::Vector3d parent_direction = Eigen::Vector3d::UnitX();
  std::vector<HingeStop> stops;
  std::optional<MarginPath> margin;
};

/// The lower node: holds a body until it breaks.
struct Lock {
  std::string name;
  Eigen::Vector3d body_point;  ///< body axes, m
};

struct Body {
  RigidBody rigid;
  std::string group;  ///< name in the file, without the copy's number
  Hinge hinge;
  std::optional<Lock> lock;
  multibody::BodyStart start;
};

/// Begin or end of a force: at a time, or `delay` after an event.
struct Clock {
  double time = 0;
  int event = -1;  ///< -1: at the time
  double delay = 0;
};
inline constexpr Clock never{std::numeric_limits<double>::infinity(), -1, 0};

/// Bodies whose distance is watched, a < b.
struct WatchedPair {
  int a, b;
  std::string name = {};  ///< the clearance's; "": none
  /// Time window of the watch. An event about one of the bodies counts from the
  /// time it occurred for that body; an event about both from the time it
  /// occurred for both.
  Clock begin = {}, end = never;
  std::vector<int> a_shapes = {}, b_shapes = {};  ///< empty: all

  bool is_plain() const {
    return name.empty() && begin.event < 0 && begin.time == 0 &&
           end.event < 0 && end.time == never.time && a_shapes.empty() &&
           b_shapes.empty();
  }
};

class ForceLaw;

struct Force {
  std::string name;
  std::string group;  ///< name in the file, without the number of a pattern
  int body;
  Clock begin, end = never;
  /// Action of the force, one of force_kinds(); copies of a case share it.
  std::shared_ptr<const ForceLaw> law;
  bool burns = false;  ///< mass of its body leaves with it
};

/// An event that occurs once for each of its bodies.
struct Event {
  enum class Trigger { time, angle, reaction, after, distance };
  enum class Node { hinge, lock };
  enum class Action {
    break_lock,
    break_hinge,
    open_latch,
    /// By angle: what passes it from the side on which the hinge starts.
    latch,
    end_run,
    none,  ///< it is noted
  };
  std::string name;
  Trigger trigger;
  double value;  ///< s, rad, N; after: delay, s; distance: m, falling
  Node node;     ///< the node of a reaction
  Action action;
  std::vector<int> bodies;
  int after = -1;  ///< the event that arms it; -1: always armed
  /// True: occurs for all its bodies when the first one meets the condition.
  bool together;
  /// Latches engage at or below this rate of the hinge, rad/s.
  double rate_below = std::numeric_limits<double>::infinity();
  /// distance: for each of its bodies the pairs that contain the body; a body
  /// in no pair uses all pairs.
  std::vector<WatchedPair> pairs = {};
};

/// A body whose motion is recorded at an event or at the end.
struct TipOff {
  int body;   ///< rigid body
  int event;  ///< -1: the end
  /// Direction across which its rate is wanted, body axes.
  std::optional<Eigen::Vector3d> direction;
};

/// Friction of a run.
enum class FrictionChoice { full, ideal, traditional };
/// Words for these, in order.
inline constexpr std::array friction_choices = {"full", "ideal", "traditional"};
constexpr const char* to_string(FrictionChoice choice) {
  return friction_choices[static_cast<std::size_t>(choice)];
}

/// Limit of the number of rows, far above practical use.
inline constexpr double most_rows = 1e6;

struct Case {
  std::string name;
  std::string file;
  std::string content;  ///< TomlTable::canonical_text()
  double end_time;      ///< s
  double output_step;   ///< s
  FrictionChoice friction;
  multibody::MotionOptions options;
  RigidBody carrier;
  multibody::BodyMotion carrier_start;
  std::vector<Body> bodies;
  std::vector<Force> forces;
  std::vector<Event> events;
  using Pair = WatchedPair;
  std::vector<Pair> clearance;
  std::vector<TipOff> tip_offs;

  const RigidBody& rigid_body(int i) const {
    return i == 0 ? carrier : bodies[i - 1].rigid;
  }
  bool has_hinges() const {
    return std::any_of(bodies.begin(), bodies.end(), [](const Body& body) {
      return body.hinge.kind != multibody::HingeKind::none;
    });
  }
  /// Whether bodies hang on bodies.
  bool is_tree() const {
    return std::any_of(bodies.begin(), bodies.end(),
                       [](const Body& body) { return body.hinge.on > 0; });
  }
  /// True if the mass of a rigid body changes.
  bool flows(int body) const {
    return std::ranges::any_of(forces, [body](const Force& force) {
      return force.body == body && force.burns;
    });
  }
  /// True if an event latches the hinge of this body.
  bool has_latch(int body) const {
    return std::ranges::any_of(events, [body](const Event& event) {
      return event.action == Event::Action::latch &&
             std::ranges::count(event.bodies, body) > 0;
    });
  }
  /// Events by distances.
  bool has_touches() const {
    return std::ranges::any_of(
        events, [](const Event& event) { return !event.pairs.empty(); });
  }
  /// Stops or latches take energy.
  bool has_impacts() const {
    return std::ranges::any_of(
               bodies,
               [](const Body& body) { return !body.hinge.stops.empty(); }) ||
           std::ranges::any_of(events, [](const Event& event) {
             return event.action == Event::Action::latch;
           });
  }
  /// With friction.
  bool has_joints() const {
    return std::any_of(bodies.begin(), bodies.end(), [](const Body& body) {
      return !body.hinge.joints.empty();
    });
  }
};

/// The name of a body in columns: blanks become underscores.
inline std::string column_name(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}
/// The distance of two bodies in columns, without its unit.
inline std::string clearance_column(const Case& c, const Case::Pair& pair) {
  const std::string name =
      pair.name.empty() ? "" : column_name(pair.name) + ".";
  return "clearance." + name + column_name(c.rigid_body(pair.a).name) + "." +
         column_name(c.rigid_body(pair.b).name);
}

/// Laws from the command line that replace the laws of the joint files.
struct JointLaws {
  std::string half_angle;  ///< "": as in the file
  std::string pressure;
};

}  // namespace separation
