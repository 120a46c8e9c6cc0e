#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "multibody/system/force_model.hpp"
#include "separation/case/case.hpp"

namespace separation {

/// A force at one instant of the motion.
struct ForceInstant {
  const Case& of;
  int body;  ///< on which it acts
  std::span<const multibody::BodyMotion> bodies;
  double time;   ///< since the motion began, s
  double begin;  ///< begin of the force, s
  double own;    ///< time of its own clock, s

  const multibody::BodyMotion& on() const { return bodies[body]; }
  const multibody::BodyMotion& carrier() const { return bodies[0]; }
  /// Only for a body with a hinge.
  const Hinge& hinge() const { return of.bodies[body - 1].hinge; }
  const multibody::BodyMotion& parent() const { return bodies[hinge().on]; }
};

/// Points of application of a force, from the bodies' centres of mass, in their
/// axes, m.
struct ForceEnds {
  Eigen::Vector3d point;  ///< on its body
  int other = -1;         ///< rigid body with the opposite force; -1: none
  Eigen::Vector3d other_point = Eigen::Vector3d::Zero();
  /// Where an engine's gas leaves to, unit, body axes; else 0.
  Eigen::Vector3d exhaust = Eigen::Vector3d::Zero();
};

/// Propellant of an engine.
struct Propellant {
  double exhaust_speed;  ///< thrust over mass flow
  double mass = std::numeric_limits<double>::infinity();  ///< kg
  /// The body without propellant: its centre of mass, as ForceEnds::point;
  /// by default it does not move. The inertia about it, body axes; by default
  /// in proportion to the mass.
  std::optional<Eigen::Vector3d> empty_com = {};
  std::optional<Eigen::Matrix3d> empty_inertia = {};
};

/// Action of a force between its begin and its end.
class ForceLaw {
 public:
  virtual ~ForceLaw() = default;

  /// Adds its forces and moments, as ForceModel::add_forces().
  virtual void add(const ForceInstant& at,
                   std::span<multibody::BodyForce> forces) const = 0;
  /// The points of application for pictures; a moment is drawn at its point
  /// too.
  virtual ForceEnds where(const Case& of, int body) const = 0;
  /// A time at which it has a kink, in addition to its begin and end.
  virtual Clock own_clock() const { return never; }
  /// Appends the times of its other kinks and jumps.
  /// @param begin  of the force, s
  virtual void add_breaks([[maybe_unused]] double begin,
                          [[maybe_unused]] std::vector<double>& breaks) const {}
  /// Appends the variables over which it has kinks, as ForceModel::add_kinks().
  virtual void add_kinks(
      [[maybe_unused]] const ForceInstant& at,
      [[maybe_unused]] std::vector<multibody::KinkedVariable>& to) const {}
  /// The propellant that it burns; null: none. It ends when that is used up.
  virtual const Propellant* propellant() const { return nullptr; }
  /// Thrust of an engine, N, and its integral since it began, N s.
  /// @param begin, own  as in ForceInstant
  virtual double thrust_at([[maybe_unused]] double time,
                           [[maybe_unused]] double begin,
                           [[maybe_unused]] double own) const {
    return 0;
  }
  virtual double impulse_until([[maybe_unused]] double time,
                               [[maybe_unused]] double begin,
                               [[maybe_unused]] double own) const {
    return 0;
  }
  /// It acts through the hinge of its body and ends with it.
  virtual bool ends_with_hinge() const { return false; }
  /// Whether it stores energy, like a torsion spring, and the stored energy, J.
  virtual bool stores() const { return false; }
  virtual double stored([[maybe_unused]] const ForceInstant& at) const {
    return 0;
  }
  /// Used part of the stroke minus its length, m, for a force that ends when
  /// its stroke is used up: when this rises to 0.
  virtual std::optional<double> overrun(
      [[maybe_unused]] int body,
      [[maybe_unused]] std::span<const multibody::BodyMotion> bodies) const {
    return {};
  }

  /// Signs of unintended action: sentences about the force, with {body} and
  /// {time}.
  virtual std::span<const std::string_view> faults() const { return {}; }
  /// Number of the present fault, from 1; 0: none.
  /// @param begins    whether the force is checked for the first time
  /// @param released  whether its body has no hinge any more
  virtual int find_fault([[maybe_unused]] const ForceInstant& at,
                         [[maybe_unused]] bool begins,
                         [[maybe_unused]] bool released) const {
    return 0;
  }
  /// Whether faults may also occur after it has acted for a while.
  virtual bool is_watched() const { return false; }
};

}  // namespace separation
