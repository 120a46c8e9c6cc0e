// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "multibody/motion/motion.hpp"
#include "separation/case/case.hpp"
#include "separation/simulation/case_forces.hpp"
#include "separation/simulation/touches.hpp"

namespace separation {

/// Forces of the nodes on a body, body axes, N.
struct NodeReactions {
  Eigen::Vector3d hinge;  ///< the upper node (the only one after the lock)
  Eigen::Vector3d lock;   ///< the lower node, normal to the line between both
};

/// Distribution of the load of a locked body between hinge and lock: R and M
/// about the hinge are known; with d from hinge to lock, the lock carries M x
/// d/|d|^2 and the hinge the rest of the force. Forces normal to d cannot hold
/// the moment about d itself: the fittings of the nodes carry it.
NodeReactions node_reactions(const Body& body,
                             const multibody::HingeSample& hinge);

/// An event that has occurred for a body.
struct Happening {
  int event;
  int body;
  int pair = -1;  ///< event by distances: index of the pair
  bool operator==(const Happening& other) const {
    return event == other.event && body == other.body;
  }
};

/// State from which a simulation can continue.
struct SimulationState {
  multibody::MotionState motion;
  History history;
};

/// The motion of a case with its events.
class Simulation {
 public:
  /// @param c  must outlive this object
  /// @throws contact::Error if the motion cannot begin as in the case
  Simulation(const Case& c, FrictionChoice friction);
  ~Simulation();

  const Case& of() const { return case_; }
  double time() const { return motion_.time(); }
  const multibody::MotionSample& sample() const { return motion_.sample(); }
  const multibody::Motion& motion() const { return motion_; }
  const History& history() const { return history_; }

  /// Load by a force of the case on its body at time() for given positions of
  /// the bodies; none while it is off.
  std::optional<multibody::BodyForce> force(
      int force, std::span<const multibody::BodyMotion> bodies) const {
    return forces_->of(force, sample().time(), bodies);
  }

  /// Energy stored by torsion springs, J.
  double stored_energy() const {
    return forces_->stored_energy(time(), sample().motions());
  }

  /// Mass flow of the case's engines.
  const MassFlow& flow() const { return forces_->flow(); }

  /// Moment of a stop on a body, without the part that friction carries, and
  /// moment of a latch (about the axis, if there is one), N m.
  /// @param of  hinge of the body in the sample
  double stop_moment(const multibody::MotionSample& sample,
                     const multibody::HingeSample& of, int body) const;
  double latch_moment(const multibody::HingeSample& of, int body) const;
  /// Impacts on stops and by latches so far, in order; impacts on compliant
  /// stops have no impulse and loss, because they take time.
  const std::vector<multibody::HingeImpact>& impacts() const {
    return impacts_;
  }

  /// See Motion::watch_steps().
  void watch_steps(std::function<void(const multibody::MotionSample&)> look) {
    motion_.watch_steps(std::move(look));
  }

  /// See Motion::halt_when().
  void halt_when(std::function<bool()> halt) {
    motion_.halt_when(std::move(halt));
  }

  enum class Stop {
    time,    ///< requested time reached
    event,   ///< happenings() are due, but not yet applied
    failed,  ///< message() says why
    halted,  ///< by halt_when()
  };
  Stop advance_to(double time);
  const std::vector<Happening>& happenings() const { return due_; }
  /// Loads from outside, inputs_of(), from time() on once use_inputs() is
  /// called.
  void set_inputs(std::vector<double> values);
  bool has_new_inputs() const { return has_new_inputs_; }
  void use_inputs();
  /// Applies the due events.
  /// @return false if this is impossible; message() gives the reason
  bool apply();
  /// Whether a due latch engages: not if the hinge turns too fast.
  bool engages(const Happening& h) const;
  /// Speed at which bodies approach each other when their event is due, m/s; 0
  /// for other events.
  double approach(const Happening& h) const;
  /// An event has ended the run.
  bool is_over() const;
  const std::string& message() const { return message_; }

  /// Angle of a body's hinge, also after its release: hinge_angle(). NaN
  /// without a hinge.
  double angle(int body) const;
  double angle(const multibody::MotionSample& sample, int body) const;

  /// See Motion::save().
  SimulationState save();
  /// @throws contact::Error as Motion::restore()
  void restore(const SimulationState& state);

 private:
  void add_events();
  void add_touches(const Happening& h);
  void add_due(const Happening& h);
  bool is_due(const Happening& h) const;
  bool is_armed(const Happening& h) const;
  bool has_happened(const Happening& h) const;
  double due_time(const Happening& h) const;
  double condition(const multibody::MotionSample& sample,
                   const Happening& h) const;
  bool is_at_latch(const multibody::MotionSample& sample,
                   const Happening& h) const;
  void find_due();
  void add_latches_here();
  void add_stops();
  void take_impacts();
  void note_touch(int body, std::size_t stop);
  double next_time() const;
  void note_motion_event();
  bool end_pushes();
  void renew_forces();
  std::string failure_text() const;
  bool perform(const Happening& h, multibody::MotionChange& breaks);

  const Case& case_;
  History history_;
  std::optional<Touches> touches_;
  std::shared_ptr<const CaseForces> forces_;
  multibody::Motion motion_;
  /// +1: an angle event of a body waits for larger angles; [event][body].
  std::vector<std::vector<double>> sense_;
  /// Meaning of a motion event: the happening, the force whose stroke ends, or
  /// the body that touches a compliant stop.
  struct Meaning {
    Happening happening;
    int force = -1;
    int body = -1;
    std::size_t stop = 0;
  };
  std::vector<Meaning> meanings_;
  std::vector<Happening> due_;
  std::vector<multibody::HingeImpact> impacts_;
  std::size_t impacts_taken_ = 0;  ///< impacts of the motion
  /// Started, resumed, or changed by an event at time().
  bool changed_ = true;
  bool has_new_inputs_ = false;
  std::string message_;
};

}  // namespace separation
