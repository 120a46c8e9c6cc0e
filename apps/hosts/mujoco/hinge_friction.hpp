// SPDX-License-Identifier: MIT
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "hosts/joint_handle.hpp"

namespace contact_hosts::mujoco {

/// Friction of libcontact in balls and hinges of a MuJoCo model.
///
///     HingeFriction friction(model);
///     friction.add("hip", "hip.toml");
///     while (data->time < 60) friction.step(data);  // in place of mj_step()
///
/// Each step is MuJoCo's own Euler step, with the moments for which
///
///     M = W (Dw - free),   W = Schur complement of H in the hinges' rates / dt
///
/// holds of all hinges at once (contact_mechanism_turn()), H = mass matrix + dt
/// damping; reactions are those of the step before. A hinge that friction holds
/// has a rate of exactly 0, and its angles do not change by a bit.
///
/// Where it ends: the integrator must be Euler; implicit ones get
/// add_damping(), RK4 the torque of add_torque(), which creeps. Contacts,
/// limits and equalities are MuJoCo's soft constraints, solved in turn with
/// friction until both fit to 1e-8 of the moments, in 50 turns at most
/// (turns()). Their forces count in the reaction as far as
/// mj_rnePostConstraint() has them: contacts, no equalities. The axis of a
/// [seat] is in the axes of the body that has it; a load that the seat does not
/// carry throws an exception. Tested with MuJoCo 2.2.2; up to 3.12 by the
/// signatures of its functions alone. Sleeping bodies (3.5 and later) are
/// refused.
class HingeFriction {
 public:
  /// @param model  stays while this is used
  explicit HingeFriction(const mjModel* model);

  /// Friction of a joint file in a ball or hinge of the model.
  /// @throws std::runtime_error if there is no such joint, it is of another
  ///         kind, has a frictionloss of its own or friction already
  void add(const std::string& joint, const std::string& file);

  /// In the place of mj_step().
  /// @throws std::runtime_error for another integrator, and where friction has
  ///         no value
  void step(mjData* data);

  /// For mjcb_passive, with any integrator: adds the moments of sliding under
  /// the reactions of the last note_reactions(). Explicit: it never stops a
  /// hinge, which creeps.
  void add_torque(mjData* data);
  /// The same with k = -M . Dw/|Dw|^2 as the hinge's damping, which Euler and
  /// implicit integrators take at the end of the step: M(w) is -k w for them.
  /// A hinge that friction holds slows down by a factor at each step, and
  /// creeps at 1e-12 rad/s at most. First order, as step(), and not beside it.
  /// @param model  that of this, whose dof_damping of these hinges it changes
  void add_damping(mjModel* model, mjData* data);
  /// After mj_step(): the reactions for the next one.
  void note_reactions(mjData* data);

  /// Last step of the i-th hinge added: of balls in the axes of their body, of
  /// hinges in those of the world.
  const contact_step& hinge(std::size_t i) const { return steps_.at(i); }
  /// Turns of friction and constraints in the last step; 1 without constraints.
  int turns() const { return turns_; }
  const contact_sweeps& sweeps() const { return sweeps_; }

 private:
  struct Hinge {
    int joint;
    int body;
    int dof;    // in qvel
    int size;   // 3 or 1 of them
    int angle;  // in qpos
    FrictionMoment contact;
    double damping = 0;  // given by add_damping()
  };
  contact_mechanism_start start_of(const Hinge& h, const mjData* data) const;
  Eigen::VectorXd slide(const Hinge& h, const mjData* data) const;
  void make_mechanism();
  void weigh(mjData* data);
  void hold(mjData* data);
  void begin(mjData* data, const Eigen::VectorXd& smooth);
  void accelerate(mjData* data, const Eigen::VectorXd& smooth);
  Eigen::VectorXd rates_at_end(const mjData* data) const;

  const mjModel* model_;
  std::vector<Hinge> hinges_;
  std::vector<contact_step> steps_;
  std::unique_ptr<contact_mechanism, void (*)(contact_mechanism*)> mechanism_;
  bool has_damping_ = false;
  bool has_reactions_ = false;
  int turns_ = 0;
  contact_sweeps sweeps_{};
  Eigen::MatrixXd inertia_;             // H
  Eigen::LLT<Eigen::MatrixXd> damped_;  // of H where there is damping
  Eigen::VectorXd force_;               // generalized, of friction
};

}  // namespace contact_hosts::mujoco
