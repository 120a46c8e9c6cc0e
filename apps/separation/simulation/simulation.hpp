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

/// Forces that the nodes of a body put on it, body axes, N.
struct NodeReactions {
  Eigen::Vector3d hinge;  ///< the upper node (the only one after the lock)
  Eigen::Vector3d lock;   ///< the lower node, normal to the line between both
};

/// How hinge and lock share what holds a locked body: R and M about the hinge
/// are known; with d from hinge to lock, the lock takes M x d/|d|^2 and the
/// hinge the rest of the force. What turns about d itself no force normal to d
/// can hold: it is left to the nodes' fittings.
NodeReactions node_reactions(const Body& body,
                             const multibody::HingeSample& hinge);

/// An event that has come for a body.
struct Happening {
  int event;
  int body;
  bool operator==(const Happening&) const = default;
};

/// All that is needed to go on later.
struct SimulationState {
  multibody::MotionState motion;
  History history;
};

/// The motion of a case with its events.
class Simulation {
 public:
  /// @param c  has to outlive this object
  /// @throws contact::Error if the motion cannot begin as the case says
  Simulation(const Case& c, FrictionChoice friction);
  ~Simulation();

  const Case& of() const { return case_; }
  double time() const { return motion_.time(); }
  const multibody::MotionSample& sample() const { return motion_.sample(); }
  const multibody::Motion& motion() const { return motion_; }
  const History& history() const { return history_; }

  /// Load by a force of the case on its body at time(), were the bodies there;
  /// none while it is off.
  std::optional<multibody::BodyForce> force(
      int force, std::span<const multibody::BodyMotion> bodies) const {
    return forces_->of(force, sample().time(), bodies);
  }

  /// Energy that torsion springs store, J.
  double stored_energy() const {
    return forces_->stored_energy(time(), sample().motions());
  }

  /// Masses now, and what becomes of them.
  const MassFlow& flow() const { return forces_->flow(); }

  /// Moment by which a stop pushes a body, as far as friction does not have to,
  /// and by which a latch holds one (on an axis about it), N m.
  /// @param of  the sample's hinge of the body
  double stop_moment(const multibody::MotionSample& sample,
                     const multibody::HingeSample& of, int body) const;
  double latch_moment(const multibody::HingeSample& of, int body) const;
  /// Impacts on stops and by latches so far, in order; without impulse and loss
  /// on compliant stops, which take time.
  const std::vector<multibody::HingeImpact>& impacts() const {
    return impacts_;
  }

  /// As Motion::watch_steps().
  void watch_steps(std::function<void(const multibody::MotionSample&)> look) {
    motion_.watch_steps(std::move(look));
  }

  /// As Motion::halt_when().
  void halt_when(std::function<bool()> halt) {
    motion_.halt_when(std::move(halt));
  }

  enum class Stop {
    time,    ///< the time asked for
    event,   ///< happenings() are due; nothing has been done yet
    failed,  ///< message() says why
    halted,  ///< as halt_when() wanted
  };
  Stop advance_to(double time);
  const std::vector<Happening>& happenings() const { return due_; }
  /// Breaks what the events that are due break.
  /// @return false if that cannot be: message() says why
  bool apply();
  /// A latch that is due engages: not where the hinge turns too fast for it.
  bool engages(const Happening& h) const;
  /// How fast bodies approach each other whose event is due, m/s; 0: it is not
  /// about distances.
  double approach(const Happening& h) const;
  /// An event has ended the run.
  bool is_over() const;
  const std::string& message() const { return message_; }

  /// Angle of a body's hinge, also after its release: hinge_angle(). NaN
  /// without a hinge.
  double angle(int body) const;
  double angle(const multibody::MotionSample& sample, int body) const;

  /// As Motion::save().
  SimulationState save();
  /// @throws contact::Error as Motion::restore()
  void restore(const SimulationState& state);

 private:
  void add_events();
  void add_touch(const Happening& h);
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
  std::size_t impacts_taken_ = 0;  ///< of the motion's
  /// Begun, gone on from a checkpoint, or broken something at time().
  bool changed_ = true;
  std::string message_;
};

}  // namespace separation
