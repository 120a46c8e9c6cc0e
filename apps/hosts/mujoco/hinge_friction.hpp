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
/// Each step is MuJoCo's own Euler step, with moments that satisfy
///
///     M = W (Dw - free),   W = Schur complement of H in the hinges' rates / dt
///
/// for all hinges at once (contact_mechanism_turn()), where H = mass matrix +
/// dt damping. Reactions come from the previous step. A hinge held by friction
/// has a rate of exactly 0, and its angles stay bit-identical.
///
/// Limits: the integrator must be Euler; for implicit integrators use
/// add_damping(), for RK4 add_torque(), with which hinges creep. Contacts,
/// limits and equalities are MuJoCo's soft constraints. They are solved
/// alternately with friction until both agree to 1e-8 of the moments, at most
/// 50 times (turns()). Reactions include the constraint forces that
/// mj_rnePostConstraint() provides: contacts, but not equalities. The axis of a
/// [seat] is in the axes of the body with the seat; a load that the seat does
/// not carry throws an exception. Tested with MuJoCo 2.2.2; for versions up to
/// 3.12 only the signatures of the functions were checked. Sleeping bodies (3.5
/// and later) are rejected.
class HingeFriction {
 public:
  /// @param model  must outlive this object
  explicit HingeFriction(const mjModel* model);

  /// Adds the friction of a joint file to a ball or hinge of the model.
  /// @throws std::runtime_error if there is no such joint, its kind differs, or
  ///   it has a frictionloss or friction already
  void add(const std::string& joint, const std::string& file);

  /// Replaces mj_step().
  /// @throws std::runtime_error for another integrator, and if friction has no
  ///   solution
  void step(mjData* data);

  /// For mjcb_passive with any integrator: adds the moments of sliding under
  /// the reactions of the last note_reactions(). They are explicit and never
  /// stop a hinge, so that it creeps.
  void add_torque(mjData* data);
  /// Sets k = -M . Dw/|Dw|^2 as the hinge's damping, so that M(w) = -k w; Euler
  /// and implicit integrators apply it at the end of the step. A hinge held by
  /// friction slows down by a factor at each step and creeps at 1e-12 rad/s at
  /// most. First order, as step(); do not combine it with step().
  /// @param model  the model of this object; the dof_damping of its hinges
  ///               changes
  void add_damping(mjModel* model, mjData* data);
  /// Call after mj_step(): stores the reactions for the next step.
  void note_reactions(mjData* data);

  /// Last step of the i-th hinge added: for a ball in the axes of its body, for
  /// a hinge in world axes.
  const contact_step& hinge(std::size_t i) const { return steps_.at(i); }
  /// Iterations between friction and constraints in the last step; 1 without
  /// constraints.
  int turns() const { return turns_; }
  const contact_sweeps& sweeps() const { return sweeps_; }

 private:
  struct Hinge {
    int joint;
    int body;
    int dof;    // index in qvel
    int size;   // number of rates: 3 or 1
    int angle;  // index in qpos
    FrictionMoment contact;
    double damping = 0;  // set by add_damping()
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
  Eigen::LLT<Eigen::MatrixXd> damped_;  // factor of H with damping
  Eigen::VectorXd force_;               // generalized, of friction
};

}  // namespace contact_hosts::mujoco
