#include "multibody/motion/motion_sample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/base/constants.hpp"
#include "multibody/motion/equations.hpp"
#include "multibody/motion/stepper.hpp"
#include "multibody/system/eigen_conversion.hpp"

namespace multibody {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct MotionSample::Instant : MotionInstant {
  explicit Instant(const Equations& equations)
      : MotionInstant(equations.system), memory(equations.memory) {}

  FrictionMemory memory;
  std::vector<double> rates;
  bool is_worked_out = false, is_found = false;
};

MotionSample::MotionSample(const Equations& equations)
    : equations_(equations), now_(std::make_unique<Instant>(equations)) {}

MotionSample::~MotionSample() = default;

std::span<const BodyMotion> MotionSample::motions() const {
  return now_->bodies;
}

void MotionSample::keep_hinge_angle(int body, double angle) {
  now_->bodies[1 + body].hinge_angle = angle;
}

void MotionSample::show(double time, std::span<const double> state) {
  time_ = time;
  state_.assign(state.begin(), state.end());
  set_bodies(equations_.system, equations_.coupled.layout(), equations_.modes(),
             state_.data(), now_->bodies);
  now_->is_worked_out = false;
}

void MotionSample::show(Stepper& stepper, double time) {
  trial_.resize(equations_.number_count());
  stepper.interpolate(time, trial_);
  keep_at_stops(stepper.begin_state());
  show(time, trial_);
}

// A body that rests on the stop of its axis is exactly there; interpolation
// adds rounding.
void MotionSample::keep_at_stops(std::span<const double> begin) {
  const CoupledDynamics& coupled = equations_.coupled;
  for (int i = 0; i < coupled.size(); ++i) {
    const Hinge& hinge = coupled.hinge(i);
    if (hinge.stops.empty() || !hinge.is_axis) continue;
    const int at = equations_.offset(i);
    if (hinge.mode == HingeMode::resting) trial_[at] = begin[at];
  }
}

void MotionSample::show_estimate(Stepper& stepper, double time) {
  trial_.resize(equations_.number_count());
  stepper.estimate(time, trial_);
  keep_at_stops(stepper.begin_state());
  show(time, trial_);
}

bool MotionSample::work_out() const {
  asked_ = true;
  Instant& now = *now_;
  if (!now.is_worked_out) {
    now.rates.resize(state_.size());
    now.memory = equations_.memory;
    now.is_found = equations_.rates(time_, state_.data(), now.memory, now,
                                    now.rates.data());
    now.is_worked_out = true;
  }
  return now.is_found;
}

Hinges MotionSample::hinges() const {
  return equations_.coupled.at(now_->memory, now_->friction);
}

double MotionSample::utilisation(int body) const {
  return work_out() ? equations_.coupled.utilisation(body, hinges())
                    : std::numeric_limits<double>::quiet_NaN();
}

HingeMode MotionSample::mode(int body) const {
  return equations_.coupled.mode(body);
}
double MotionSample::angle(int body) const {
  return state_[equations_.offset(body)];
}
bool MotionSample::rests_on_stop(int body) const {
  return equations_.coupled.hinge(body).rests_on_stop(
      &state_[equations_.offset(body)]);
}
Vector3d MotionSample::rate_of(int body) const {
  return equations_.rate_of(body, state_.data());
}

HingeSample MotionSample::hinge(int body) const {
  using contact::detail::nan;
  const Link& link = equations_.system.links()[body];
  HingeSample s;
  s.mode = equations_.coupled.mode(body);
  s.dissipated = state_[equations_.dissipated_at(body)];
  s.angle = s.angle_rate = s.utilisation = nan;
  s.stop_moment = 0;
  s.friction_moment.setZero();
  if (s.mode == HingeMode::released) {
    s.rotation.setConstant(nan);
    s.relative_angular_velocity.setConstant(nan);
    s.reaction_force.setZero();
    s.reaction_moment.setZero();
    return s;
  }
  const bool known = work_out();
  const double* numbers = &state_[equations_.offset(body)];
  s.rotation = relative_rotation(link, numbers) * link.axes.transpose();
  s.relative_angular_velocity = link.axes * relative_rate(link, numbers);
  if (equations_.is_axis(body)) {
    s.angle = numbers[0];
    s.angle_rate = numbers[1];
  }
  if (!known) {
    s.reaction_force.setConstant(nan);
    s.reaction_moment.setConstant(nan);
    s.friction_moment.setConstant(nan);
    return s;
  }
  Hinges hinges = this->hinges();
  const Reaction<double>& reaction = hinges.reaction(body);
  s.reaction_force = link.axes * vec3(reaction.force);
  s.reaction_moment = link.axes * vec3(reaction.moment);
  if (const ConeRest* cone = hinges.cone_of(body)) {
    s.reaction_moment += link.axes * (cone->moment * cone->axis);
  }
  s.stop_moment = std::max(0.0, hinges.stop_moment(body));
  if (equations_.coupled.hinge(body).has_friction && !is_fixed(s.mode)) {
    s.joints = hinges.joints(body);
    if (s.mode == HingeMode::sliding) {
      s.friction_moment = link.axes * hinges.memory(body).moment;
      s.utilisation = 1;
    } else {
      s.utilisation = utilisation(body);
    }
  }
  return s;
}

Vector3d MotionSample::acceleration(int place) const {
  if (!work_out()) return Vector3d::Constant(NAN);
  constexpr int v = StateLayout::velocity;
  if (place == 0) return Eigen::Map<const Vector3d>(&now_->rates[v]);
  const int body = place - 1;
  if (equations_.coupled.mode(body) == HingeMode::released) {
    return Eigen::Map<const Vector3d>(
        &now_->rates[equations_.offset(body) + v]);
  }
  // (F + R)/m and gravity
  const std::vector<Link>& links = equations_.system.links();
  Hinges hinges = this->hinges();
  const auto axes = [&](int i) -> Matrix3d {
    return motions()[1 + i].rotation * links[i].axes;
  };
  Vector3d force =
      axes(body) * (vec3(now_->friction.forces.bodies[body].force) +
                    vec3(hinges.reaction(body).force));
  for (int i = 0; i < equations_.size(); ++i) {
    if (links[i].parent != body) continue;
    force -= axes(i) * vec3(hinges.reaction(i).force);
  }
  for (const BodyMass& mass : now_->masses) {
    if (mass.body != place) continue;
    // Acceleration of the centre of mass, which is at c.
    const BodyMotion& motion = motions()[place];
    const Vector3d c = motion.rotation * mass.com;
    const Vector3d& w = motion.angular_velocity;
    return equations_.gravity + force / mass.mass -
           angular_acceleration(place).cross(c) - w.cross(w.cross(c));
  }
  return equations_.gravity + force / links[body].mass;
}

Vector3d MotionSample::angular_acceleration(int place) const {
  if (!work_out()) return Vector3d::Constant(NAN);
  if (place == 0) {
    return carrier().rotation * vec3(now_->friction.dynamics.carrier().angular);
  }
  return motions()[place].rotation * equations_.system.links()[place - 1].axes *
         vec3(now_->friction.dynamics.angular_acceleration(place - 1));
}

EnergyBook MotionSample::energy() const {
  EnergyBook book{};
  book.gravity = -0.0;  // -0 keeps the sign of added terms
  std::vector<BodyMass> changed;
  if (equations_.forces) equations_.forces->add_masses(time_, changed);
  const auto add = [&](int place, double mass, const Matrix3d& inertia,
                       const Matrix3d& axes) {
    const BodyMotion& body = motions()[place];
    const auto now = std::ranges::find(changed, place, &BodyMass::body);
    if (now == changed.end()) {
      book.kinetic += kinetic_energy(mass, inertia, axes, body);
      book.gravity -= mass * equations_.gravity.dot(body.position);
      return;
    }
    BodyMotion com = body;
    com.position = body.point(now->com);
    com.velocity = body.point_velocity(now->com);
    book.kinetic +=
        kinetic_energy(now->mass, now->inertia, Matrix3d::Identity(), com);
    book.gravity -= now->mass * equations_.gravity.dot(com.position);
  };
  const Carrier& carrier = equations_.system.carrier();
  add(0, carrier.mass, carrier.inertia, Matrix3d::Identity());
  for (int i = 0; i < equations_.size(); ++i) {
    const Link& link = equations_.system.links()[i];
    add(1 + i, link.mass, link.inertia, link.axes);
    book.dissipated += state_[equations_.dissipated_at(i)];
    book.impacts += equations_.losses[i];
  }
  book.active_work = state_[equations_.work_at()];
  return book;
}

}  // namespace multibody
