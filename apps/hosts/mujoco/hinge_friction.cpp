#include "hosts/mujoco/hinge_friction.hpp"

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

bool is_ball_or_hinge(const mjModel* model, int joint) {
  const int type = model->jnt_type[joint];
  return type == mjJNT_BALL || type == mjJNT_HINGE;
}

std::string names_of_hinges(const mjModel* model) {
  std::string names;
  for (int i = 0; i < model->njnt; ++i) {
    const char* const name = mj_id2name(model, mjOBJ_JOINT, i);
    if (!name || !is_ball_or_hinge(model, i)) continue;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  return names;
}

// mj_fullM() of MuJoCo 3.10 and later, and of earlier versions.
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
      mechanism_(nullptr, contact_mechanism_free),
      has_damping_(std::any_of(model->dof_damping,
                               model->dof_damping + model->nv,
                               [](double d) { return d > 0; })),
      force_(VectorXd::Zero(model->nv)) {}

void HingeFriction::add(const std::string& joint, const std::string& file) {
  const auto refuse = [&](const std::string& rule) {
    throw std::runtime_error("joint \"" + joint + "\" must " + rule);
  };
  const int id = mj_name2id(model_, mjOBJ_JOINT, joint.c_str());
  if (id < 0) refuse("be one of the model: " + names_of_hinges(model_));
  if (!is_ball_or_hinge(model_, id)) refuse("be a ball or hinge");
  const int dof = model_->jnt_dofadr[id];
  if (model_->dof_frictionloss[dof] > 0) {
    refuse("have no frictionloss beside this friction");
  }
  const auto is_same = [&](const Hinge& h) { return h.joint == id; };
  if (std::any_of(hinges_.begin(), hinges_.end(), is_same)) {
    refuse("have friction of one file");
  }
  const bool is_ball = model_->jnt_type[id] == mjJNT_BALL;
  JointHandle contact = read_joint(file, "joint \"" + joint + "\"",
                                   is_ball ? CONTACT_BALL : CONTACT_PIN);
  hinges_.push_back({id, model_->jnt_bodyid[id], dof, is_ball ? 3 : 1,
                     model_->jnt_qposadr[id],
                     FrictionMoment(std::move(contact))});
  steps_.push_back({});
  mechanism_.reset();
}

void HingeFriction::make_mechanism() {
  std::vector<contact_mechanism_joint> joints;
  for (const Hinge& h : hinges_) {
    joints.push_back({h.contact.joint(), static_cast<std::size_t>(h.dof)});
  }
  contact_mechanism* made = nullptr;
  must(contact_mechanism_make(joints.data(), joints.size(), model_->nv, &made));
  mechanism_.reset(made);
}

void HingeFriction::note_reactions(mjData* data) {
  mj_rnePostConstraint(model_, data);
  has_reactions_ = true;
}

// Vectors of balls are in the axes of their body, as MuJoCo's rates; vectors of
// hinges are in world axes.
contact_mechanism_start HingeFriction::start_of(const Hinge& h,
                                                const mjData* data) const {
  contact_mechanism_start s{};
  const Vector3d reaction = reaction_on(data, h.body);
  Vector3d::Map(s.reaction) = reaction;
  if (h.size == 1) {
    std::copy_n(data->xaxis + 3 * h.joint, 3, s.axis);
    return s;
  }
  const Eigen::Map<const Rotation> axes(data->xmat + 9 * h.body);
  Vector3d::Map(s.reaction) = axes.transpose() * reaction;
  if (h.contact.seat() == Seat::on_carrier) {
    const Eigen::Map<const Rotation> parent(data->xmat +
                                            9 * model_->body_parentid[h.body]);
    Eigen::Map<Rotation>(s.from_seat) = axes.transpose() * parent;
  }
  return s;
}

// Adds to H the constraints whose force is linear in the acceleration, such as
// equalities, so that friction accounts for their compliance.
void HingeFriction::weigh(mjData* data) {
  const int nv = model_->nv;
  const double dt = model_->opt.timestep;
  inertia_.resize(nv, nv);
  full_inertia(mj_fullM, model_, data, inertia_.data());
  inertia_.diagonal() += dt * mapped(model_->dof_damping, nv);
  if (has_damping_) damped_.compute(inertia_);
  std::vector<double> rows;
  std::vector<double> stiffness;
  for (int i = 0; i < data->nefc; ++i) {
    if (data->efc_state[i] != mjCNSTRSTATE_QUADRATIC) continue;
    const VectorXd one = VectorXd::Unit(data->nefc, i);
    rows.resize(rows.size() + nv);
    mj_mulJacTVec(model_, data, rows.data() + rows.size() - nv, one.data());
    stiffness.push_back(data->efc_D[i]);
  }
  must(contact_mechanism_weigh(mechanism_.get(), inertia_.data(), rows.data(),
                               stiffness.data(), stiffness.size(), dt));
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

VectorXd HingeFriction::rates_at_end(const mjData* data) const {
  const Eigen::Map<const VectorXd> rate(data->qvel, model_->nv);
  const Eigen::Map<const VectorXd> acceleration(data->qacc, model_->nv);
  return rate + model_->opt.timestep * acceleration;
}

// The first reactions, computed with constant rates of the hinges.
void HingeFriction::begin(mjData* data, const VectorXd& smooth) {
  must(contact_mechanism_hold(mechanism_.get(), data->qvel,
                              rates_at_end(data).data(), force_.data()));
  accelerate(data, smooth);
  note_reactions(data);
}

void HingeFriction::step(mjData* data) {
  if (model_->opt.integrator != mjINT_EULER) {
    throw std::runtime_error(
        "the integrator must be Euler; implicit ones have add_damping(), "
        "others add_torque()");
  }
#if mjVERSION_HEADER >= 350
  if (model_->opt.enableflags & mjENBL_SLEEP) {
    throw std::runtime_error("bodies must not sleep: friction holds them");
  }
#endif
  // Assumes that accelerations stay the same.
  const VectorXd likely = rates_at_end(data);
  mj_checkPos(model_, data);
  mj_checkVel(model_, data);
  mj_forward(model_, data);
  mj_checkAcc(model_, data);
  if (!hinges_.empty()) {
    if (!mechanism_) make_mechanism();
    force_.setZero();
    const VectorXd smooth = mapped(data->qfrc_smooth, model_->nv);
    weigh(data);
    if (has_damping_) accelerate(data, smooth);
    if (!has_reactions_) begin(data, smooth);
    std::vector<contact_mechanism_start> starts;
    for (const Hinge& h : hinges_) starts.push_back(start_of(h, data));
    must(contact_mechanism_begin(mechanism_.get(), starts.data(), data->qvel,
                                 likely.data()));
    constexpr int turn_limit = 50;
    for (turns_ = 1;; ++turns_) {
      double change = 0;
      must(contact_mechanism_turn(mechanism_.get(), rates_at_end(data).data(),
                                  force_.data(), &change));
      accelerate(data, smooth);
      if (data->nefc == 0 || turns_ == turn_limit || change <= 1e-8) break;
      weigh(data);
    }
    for (std::size_t i = 0; i < hinges_.size(); ++i) {
      must(contact_mechanism_get(mechanism_.get(), i, &steps_[i], &sweeps_));
    }
    note_reactions(data);
  }
  hold(data);
}

// MuJoCo's step; hinges held by friction keep their angles.
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

// Moment of a sliding hinge, in its degrees of freedom.
VectorXd HingeFriction::slide(const Hinge& h, const mjData* data) const {
  const contact_mechanism_start s = start_of(h, data);
  const Vector3d axis(s.axis);
  const Eigen::Map<const VectorXd> rate(data->qvel + h.dof, h.size);
  contact_slip slip{};
  std::copy_n(s.reaction, 3, slip.reaction);
  std::copy_n(s.axis, 3, slip.axis);
  Vector3d::Map(slip.angular_velocity) =
      h.size == 3 ? Vector3d(rate) : Vector3d(rate[0] * axis);
  Vector3d moment;
  h.contact.find(slip, s.from_seat, moment.data());
  if (h.size == 3) return moment;
  return VectorXd::Constant(1, moment.dot(axis));
}

void HingeFriction::add_torque(mjData* data) {
  for (const Hinge& h : hinges_) {
    mapped(data->qfrc_passive + h.dof, h.size) += slide(h, data);
  }
}

void HingeFriction::add_damping(mjModel* model, mjData* data) {
  for (Hinge& h : hinges_) {
    auto force = mapped(data->qfrc_passive + h.dof, h.size);
    auto damping = mapped(model->dof_damping + h.dof, h.size);
    const auto rate = mapped(data->qvel + h.dof, h.size);
    // Below this rate the damping is not changed; a held hinge creeps more
    // slowly.
    constexpr double least = 1e-12;  // rad/s
    if (rate.norm() < least) continue;
    const VectorXd moment = slide(h, data);
    // MuJoCo has already added the force of the previous damping.
    force.array() += h.damping * rate.array() + moment.array();
    damping.array() -= h.damping;
    h.damping = -moment.dot(rate) / rate.squaredNorm();
    damping.array() += h.damping;
  }
}

}  // namespace contact_hosts::mujoco
