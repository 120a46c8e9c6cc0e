#include "hosts/mujoco/hinge_friction.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <type_traits>

namespace contact_hosts::mujoco {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using Rotation = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
static_assert(sizeof(mjtNum) == sizeof(double), "MuJoCo in double precision");

Eigen::Map<VectorXd> mapped(mjtNum* numbers, int size) {
  return {numbers, size};
}

// Force of the parent on a body, world axes.
Vector3d reaction_on(const mjData* data, int body) {
  return Vector3d(data->cfrc_int + 6 * body + 3);
}

// mj_fullM() of MuJoCo 3.10 and later, and of those before.
template <class Full, class Data>
void full_inertia(Full full, const mjModel* model, Data* data, mjtNum* to) {
  if constexpr (std::is_invocable_v<Full, const mjModel*, Data*, mjtNum*>) {
    full(model, data, to);
  } else {
    full(model, to, data->qM);
  }
}

}  // namespace

HingeFriction::HingeFriction(const mjModel* model)
    : model_(model),
      has_damping_(std::any_of(model->dof_damping,
                               model->dof_damping + model->nv,
                               [](double d) { return d > 0; })),
      force_(VectorXd::Zero(model->nv)) {
  for (int i = 0; i < model->nv; ++i) other_.push_back(i);
}

void HingeFriction::add(const std::string& joint, const std::string& file) {
  const auto refuse = [&](const char* rule) {
    throw std::runtime_error("joint \"" + joint + "\" must " + rule);
  };
  const int id = mj_name2id(model_, mjOBJ_JOINT, joint.c_str());
  if (id < 0) refuse("be one of the model");
  const int type = model_->jnt_type[id];
  if (type != mjJNT_BALL && type != mjJNT_HINGE) refuse("be a ball or hinge");
  const int dof = model_->jnt_dofadr[id];
  if (model_->dof_frictionloss[dof] > 0) {
    refuse("have no frictionloss beside this friction");
  }
  if (std::find(own_.begin(), own_.end(), dof) != own_.end()) {
    refuse("have friction of one file");
  }
  const bool is_ball = type == mjJNT_BALL;
  JointHandle contact = read_joint(file, "joint \"" + joint + "\"",
                                   is_ball ? CONTACT_BALL : CONTACT_PIN);
  const bool on_carrier = seat_of(contact.get()) == Seat::on_carrier;
  hinges_.push_back({id, model_->jnt_bodyid[id], dof, is_ball ? 3 : 1,
                     model_->jnt_qposadr[id], std::move(contact), on_carrier});
  for (int i = dof; i < dof + hinges_.back().size; ++i) {
    own_.push_back(i);
    other_.erase(std::find(other_.begin(), other_.end(), i));
  }
  contacts_.push_back(hinges_.back().contact.get());
  starts_.push_back({});
  steps_.push_back({});
}

void HingeFriction::note_reactions(mjData* data) {
  mj_rnePostConstraint(model_, data);
  has_reactions_ = true;
}

// Starts of balls in the axes of their body, or of the one with their seat; of
// hinges in those of the world.
void HingeFriction::start(const mjData* data) {
  for (std::size_t i = 0; i < hinges_.size(); ++i) {
    Hinge& h = hinges_[i];
    contact_step_start& s = starts_[i];
    const Vector3d reaction = reaction_on(data, h.body);
    const double* const rate = data->qvel + h.dof;
    if (h.size == 3) {
      const Eigen::Map<const Rotation> axes(data->xmat + 9 * h.body);
      if (h.on_carrier) {
        h.turn = Eigen::Map<const Rotation>(data->xmat +
                                            9 * model_->body_parentid[h.body])
                     .transpose() *
                 axes;
      }
      Vector3d::Map(s.reaction) = h.turn * (axes.transpose() * reaction);
      Vector3d::Map(s.angular_velocity) = h.turn * Vector3d(rate);
    } else {
      const Vector3d axis(data->xaxis + 3 * h.joint);
      Vector3d::Map(s.reaction) = reaction;
      Vector3d::Map(s.axis) = axis;
      Vector3d::Map(s.angular_velocity) = *rate * axis;
    }
  }
}

// Rates from which the search begins.
void HingeFriction::guess(const VectorXd& rates) {
  for (std::size_t i = 0; i < hinges_.size(); ++i) {
    const Hinge& h = hinges_[i];
    Vector3d::Map(steps_[i].angular_velocity) =
        h.size == 3 ? Vector3d(h.turn * rates.segment<3>(h.dof))
                    : Vector3d(rates[h.dof] * Vector3d(starts_[i].axis));
  }
}

// H and W. Constraints whose force is linear in the acceleration, as those of
// equalities, are part of H: friction knows how they give way.
void HingeFriction::weigh(mjData* data) {
  const int nv = model_->nv;
  const double dt = model_->opt.timestep;
  inertia_.resize(nv, nv);
  full_inertia(mj_fullM, model_, data, inertia_.data());
  inertia_.diagonal() += dt * mapped(model_->dof_damping, nv);
  if (has_damping_) damped_.compute(inertia_);
  VectorXd row(data->nefc > 0 ? nv : 0);
  for (int i = 0; i < data->nefc; ++i) {
    if (data->efc_state[i] != mjCNSTRSTATE_QUADRATIC) continue;
    const VectorXd one = VectorXd::Unit(data->nefc, i);
    mj_mulJacTVec(model_, data, row.data(), one.data());
    inertia_ += data->efc_D[i] * row * row.transpose();
  }
  if (other_.empty() && std::is_sorted(own_.begin(), own_.end())) {
    weight_ = inertia_ / dt;
    return;
  }
  weight_ = inertia_(own_, own_);
  const Eigen::MatrixXd across = inertia_(other_, own_);
  weight_ -= across.transpose() *
             Eigen::MatrixXd(inertia_(other_, other_)).llt().solve(across);
  weight_ /= dt;
}

// Accelerations with a force of friction: H^-1 times all forces.
void HingeFriction::accelerate(mjData* data, const VectorXd& smooth) {
  const int nv = model_->nv;
  mapped(data->qfrc_smooth, nv) = smooth + force_;
  if (data->nefc > 0) {
    mj_solveM(model_, data, data->qacc_smooth, data->qfrc_smooth, 1);
    mj_fwdConstraint(model_, data);
  }
  const VectorXd all =
      mapped(data->qfrc_smooth, nv) + mapped(data->qfrc_constraint, nv);
  auto acceleration = mapped(data->qacc, nv);
  if (has_damping_) {
    acceleration = damped_.solve(all);
  } else {
    mj_solveM(model_, data, data->qacc, all.data(), 1);
  }
}

// The rates that hinges would have without their friction.
VectorXd HingeFriction::free_rates(const mjData* data) const {
  const double dt = model_->opt.timestep;
  const auto vector = [&](const double* numbers) {
    return Eigen::Map<const VectorXd>(numbers, model_->nv);
  };
  const VectorXd rate = vector(data->qvel) + dt * vector(data->qacc);
  if (force_.isZero(0)) return rate(own_);
  return rate(own_) - weight_.llt().solve(VectorXd(force_(own_)));
}

// The moments of friction in place of those that there are; the change.
double HingeFriction::solve(const VectorXd& free) {
  const VectorXd before = force_;
  const bool turns = std::any_of(hinges_.begin(), hinges_.end(),
                                 [](const Hinge& h) { return h.on_carrier; });
  if (turns) turned_ = weight_;
  int at = 0;
  for (std::size_t i = 0; i < hinges_.size(); at += hinges_[i++].size) {
    contact_step_start& s = starts_[i];
    const Hinge& h = hinges_[i];
    Vector3d::Map(s.free) = h.size == 3 ? Vector3d(h.turn * free.segment<3>(at))
                                        : Vector3d(free[at] * Vector3d(s.axis));
    if (!h.on_carrier) continue;
    turned_.middleRows<3>(at) = (h.turn * turned_.middleRows<3>(at)).eval();
    turned_.middleCols<3>(at) =
        (turned_.middleCols<3>(at) * h.turn.transpose()).eval();
  }
  must(contact_joints_step(contacts_.data(), contacts_.size(), starts_.data(),
                           (turns ? turned_ : weight_).data(), steps_.data(),
                           &sweeps_));
  for (std::size_t i = 0; i < hinges_.size(); ++i) {
    const Hinge& h = hinges_[i];
    const Vector3d moment(steps_[i].moment);
    if (h.size == 3) {
      force_.segment<3>(h.dof) = h.turn.transpose() * moment;
    } else {
      force_[h.dof] = moment.dot(Vector3d(starts_[i].axis));
    }
  }
  return (force_ - before).norm();
}

// The first reactions: as if the hinges' rates stayed as they are.
void HingeFriction::begin(mjData* data, const VectorXd& smooth) {
  const VectorXd rate = mapped(data->qvel, model_->nv);
  force_(own_) = weight_ * (rate(own_) - free_rates(data));
  accelerate(data, smooth);
  note_reactions(data);
}

void HingeFriction::step(mjData* data) {
  if (model_->opt.integrator != mjINT_EULER) {
    throw std::runtime_error(
        "the integrator must be Euler; implicit ones have add_damping(), "
        "others add_torque()");
  }
  // As if accelerations stayed as they were.
  const VectorXd likely = mapped(data->qvel, model_->nv) +
                          model_->opt.timestep * mapped(data->qacc, model_->nv);
  mj_checkPos(model_, data);
  mj_checkVel(model_, data);
  mj_forward(model_, data);
  mj_checkAcc(model_, data);
  if (!hinges_.empty()) {
    force_.setZero();
    const VectorXd smooth = mapped(data->qfrc_smooth, model_->nv);
    weigh(data);
    if (has_damping_) accelerate(data, smooth);
    if (!has_reactions_) begin(data, smooth);
    start(data);
    guess(likely);
    constexpr int turn_limit = 50;
    for (turns_ = 1;; ++turns_) {
      const double change = solve(free_rates(data));
      accelerate(data, smooth);
      if (data->nefc == 0 || turns_ == turn_limit ||
          change <= 1e-8 * force_.norm()) {
        break;
      }
      weigh(data);
    }
    note_reactions(data);
  }
  hold(data);
}

// MuJoCo's step; hinges that friction holds stay where they are.
void HingeFriction::hold(mjData* data) {
  std::vector<double> angles(data->qpos, data->qpos + model_->nq);
  mj_Euler(model_, data);
  for (std::size_t i = 0; i < hinges_.size(); ++i) {
    const Hinge& h = hinges_[i];
    if (!steps_[i].holds) continue;
    std::fill_n(data->qvel + h.dof, h.size, 0.0);
    std::copy_n(angles.data() + h.angle, h.size == 3 ? 4 : 1,
                data->qpos + h.angle);
  }
}

// Moment of a hinge that slides, in its dofs.
VectorXd HingeFriction::slide(std::size_t i) {
  const Hinge& h = hinges_[i];
  contact_slip slip{};
  std::copy_n(starts_[i].reaction, 3, slip.reaction);
  std::copy_n(starts_[i].angular_velocity, 3, slip.angular_velocity);
  std::copy_n(starts_[i].axis, 3, slip.axis);
  contact_solution& s = steps_[i].solution;
  must(contact_joint_solve(h.contact.get(), &slip, &s, &s));
  const Vector3d moment(s.friction_moment);
  if (h.size == 3) return h.turn.transpose() * moment;
  return VectorXd::Constant(1, moment.dot(Vector3d(slip.axis)));
}

void HingeFriction::add_torque(mjData* data) {
  start(data);
  for (std::size_t i = 0; i < hinges_.size(); ++i) {
    const Hinge& h = hinges_[i];
    mapped(data->qfrc_passive + h.dof, h.size) += slide(i);
  }
}

void HingeFriction::add_damping(mjModel* model, mjData* data) {
  start(data);
  for (std::size_t i = 0; i < hinges_.size(); ++i) {
    Hinge& h = hinges_[i];
    auto force = mapped(data->qfrc_passive + h.dof, h.size);
    auto damping = mapped(model->dof_damping + h.dof, h.size);
    const auto rate = mapped(data->qvel + h.dof, h.size);
    // Below it damping stays as it is: a hinge that holds creeps at less.
    constexpr double least = 1e-12;  // rad/s
    if (rate.norm() < least) continue;
    const VectorXd moment = slide(i);
    // MuJoCo has added the force of the damping that there was.
    force.array() += h.damping * rate.array() + moment.array();
    damping.array() -= h.damping;
    h.damping = -moment.dot(rate) / rate.squaredNorm();
    damping.array() += h.damping;
  }
}

}  // namespace contact_hosts::mujoco
