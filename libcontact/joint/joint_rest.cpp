#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/magnitude.hpp"
#include "libcontact/base/root_finding.hpp"
#include "libcontact/joint/contact_model.hpp"
#include "libcontact/joint/joint.hpp"

// Moments that a joint at rest holds: H(R) by the sliding moments M_t(R, u).
namespace contact {
namespace {

using Eigen::Vector3d;

using detail::infinity;
using detail::nan;
using detail::pi;

// The search for u in coordinates of its own: R along Z or against it, u in
// the plane XOZ at the angle c from Z. -M_t turns from Z (c = 0) through the
// plane normal to R (c = 90 deg) to -Z; Z is the side of -M, so that the root
// is below 90 deg and keeps its digits near 0.
class SlipSearch {
 public:
  // @param reaction  along Z, with its sign
  // @param angle     between Z and the moment -M that u has to overcome
  SlipSearch(const Joint& joint, double reaction, double angle,
             const SolveOptions& options)
      : joint_(joint),
        reaction_(0, 0, reaction),
        angle_(angle),
        options_(options) {}

  void start_from(const JointSolution& last) { last_ = last; }
  const JointSolution& last() const { return last_; }
  int solves() const { return solves_; }

  // Angle between Z and -M_t(R, u), less what it has to be: rises with c.
  double excess(double c) {
    const Vector3d u(std::sin(c), 0, std::cos(c));
    at_ = c;
    last_ = joint_.solve({reaction_, u}, last_, options_);
    ++solves_;
    const Vector3d& m = last_.friction_moment;
    const double value = std::atan2(std::hypot(m.x(), m.y()), -m.z()) - angle_;
    // Rounding of an angle of up to pi after a handful of operations.
    constexpr double rounding = 2e-15;
    return std::abs(value) <= rounding ? 0 : value;
  }

  void go_to(double c) {
    if (c != at_) excess(c);
  }

  // Secant steps from a start; NaN if they do not settle.
  double near(double c) {
    constexpr int step_limit = 8;
    double slope = 1;
    double value = excess(c);
    for (int i = 0; i < step_limit; ++i) {
      if (value == 0) return c;
      const double next = std::clamp(c - value / slope, 0.0, pi);
      if (next == c) return c;
      const double next_value = excess(next);
      slope = (next_value - value) / (next - c);
      if (!(slope > 0)) return nan;
      c = next;
      value = next_value;
    }
    return nan;
  }

  // Calls visit(c) for the root in each interval of c that has one.
  template <class Visit>
  void all(const Visit& visit) {
    constexpr int intervals = 16;
    double low = 0;
    double low_value = excess(low);
    for (int i = 1; i <= intervals; ++i) {
      const double high = pi * i / intervals;
      const double high_value = excess(high);
      if ((low_value <= 0 && high_value >= 0) ||
          (low_value > 0 && high_value < 0)) {
        visit(between(low, low_value, high, high_value));
      }
      low = high;
      low_value = high_value;
    }
  }

 private:
  double between(double low, double low_value, double high, double high_value) {
    // Small contacts turn their moment within angles of theta0^2.
    constexpr double factor = 16;
    while (low == 0 && low_value < 0 && high_value > 0) {
      const double value = excess(high / factor);
      if (value <= 0) {
        low = high / factor;
        low_value = value;
      } else {
        high /= factor;
        high_value = value;
      }
    }
    if (low_value == 0) return low;
    if (high_value == 0) return high;
    // Some 8 steps.
    return shrink_bracket([this](double x) { return excess(x); }, low, high,
                          low_value, high_value, 52)
        .middle();
  }

  const Joint& joint_;
  Vector3d reaction_;
  double angle_;
  SolveOptions options_;
  JointSolution last_;
  double at_ = nan;  // its c
  int solves_ = 0;
};

// Angle between u and Z at which friction has its moment at `angle` from there,
// without a solution in each step: with the slip axis and R_n the unknowns,
//
//     tan(angle) = |(sigma_Y, sigma_Z sin g)|/(sigma_Z cos g),  R_n = R cos g
//
// is one equation in cot a, nearly a proportion. Secants in logarithms, R_n one
// step behind: 7 to 11 evaluations for f up to 0.5, until two or three
// solutions can polish with the fewest evaluations in all. A start, no more,
// where f is above 1.
double angle_of_slip(const JointContact& contact, double force, double angle) {
  if (angle == 0 || angle == pi / 2) return angle;  // spins, slides
  constexpr int step_limit = 16;
  const double target = std::log(std::tan(angle));
  double normal_force = force;
  double log_cot = target;
  double slope = 1;
  double last_cot = 0;
  double last_excess = 0;
  double c = angle;
  for (int i = 0; i < step_limit; ++i) {
    const double cot = std::exp(log_cot);
    const double sin_a = 1 / std::hypot(1, cot);
    const double cos_a = cot * sin_a;
    const FrictionTriple f =
        contact.friction_at(contact.half_angle(normal_force).half_angle,
                            {sin_a, cos_a}, {normal_force, 1});
    const double size = std::hypot(f.force, normal_force);
    const double cos_g = normal_force / size;
    const double sin_g = f.force / size;
    const double excess = std::log(std::hypot(f.sliding, f.spinning * sin_g) /
                                   (f.spinning * cos_g)) -
                          target;
    c = std::atan2(std::hypot(cos_a, sin_a * sin_g), sin_a * cos_g);
    const double lag = std::abs(force * cos_g / normal_force - 1);
    normal_force = force * cos_g;
    constexpr double settled = 1e-7;
    if (!(std::abs(excess) + lag > settled)) break;
    if (i > 0 && log_cot != last_cot) {
      const double secant = (excess - last_excess) / (log_cot - last_cot);
      slope = secant > 0.3 && secant < 3 ? secant : 1;
    }
    last_cot = log_cot;
    last_excess = excess;
    log_cot -= excess / slope;
  }
  return c;
}

// Whether there is no answer; then it is made NaN.
bool has_no_answer(RestSolution& rest, const Vector3d& moment) {
  rest.status = moment.allFinite() ? rest.slip.status : Status::out_of_range;
  if (rest.status == Status::ok) return false;
  rest.utilisation = nan;
  rest.direction.setConstant(nan);
  return true;
}

// The sliding that friction would oppose with a moment of this sign. A pin that
// slides along its axis holds none about it. Balls have no such placement.
RestSolution pin_at_rest(const Joint& joint, const Joint::Hold& hold,
                         const SolveOptions& options) {
  const Vector3d& moment = hold.moment;
  const Vector3d axis =
      hold.axis.isZero(0) ? Vector3d(moment.stableNormalized()) : hold.axis;
  const double needed = moment.dot(axis);
  RestSolution rest;
  if (needed != 0) rest.direction = needed > 0 ? Vector3d(-axis) : axis;
  const bool slides = hold.placement && hold.placement->axial_velocity != 0;
  const Vector3d u = slides ? Vector3d::Zero() : rest.direction;
  rest.slip = joint.solve({hold.reaction, u, axis, hold.placement}, options);
  rest.solves = 1;
  if (has_no_answer(rest, moment) || needed == 0) return rest;
  const double limit = joint.contact().is_viscous()
                           ? 0
                           : std::abs(rest.slip.friction_moment.dot(u));
  rest.utilisation = std::abs(needed) / limit;
  return rest;
}

RestSolution ball_at_rest(const Joint& joint, const Joint::Hold& hold,
                          const RestSolution* last,
                          const SolveOptions& options) {
  const Vector3d& reaction = hold.reaction;
  const Vector3d& moment = hold.moment;
  RestSolution rest;
  rest.slip = joint.solve({reaction, Vector3d::Zero()});
  const double needed = magnitude(moment);
  if (has_no_answer(rest, moment) || needed == 0) return rest;
  const JointContact::Strength strength = joint.contact().strength(0);
  if (rest.slip.state == JointState::unloaded ||
      (strength.pressure_part == 0 && strength.area_part == 0)) {
    rest.utilisation = infinity;
    return rest;
  }

  const double force = magnitude(reaction);
  const Vector3d m = moment / needed;
  if (force == 0) {  // interference alone: every axis alike
    rest.direction = -m;
    rest.slip = joint.solve({reaction, rest.direction}, options);
    rest.solves = 1;
    rest.utilisation = needed / magnitude(rest.slip.friction_moment);
    return rest;
  }
  // Z: along R, on the side of -M.
  const double sign = reaction.dot(m) > 0 ? -1 : 1;
  const Vector3d z = sign * reaction / force;
  const Vector3d cross = z.cross(m);
  const double across = cross.norm();
  const double angle = std::atan2(across, -z.dot(m));
  SlipSearch search(joint, sign * force, angle, options);

  // M in the plane of z and p; turns the search's X axis to where the found
  // moment has the azimuth of M.
  const Vector3d q = across > 0 ? Vector3d(cross / across) : z.unitOrthogonal();
  const Vector3d p = q.cross(z);
  const auto take = [&](double c) {
    search.go_to(c);
    const Vector3d& found = search.last().friction_moment;
    const double size = std::hypot(found.x(), found.y());
    const Vector3d x =
        size > 0 ? Vector3d((found.x() * p - found.y() * q) / size) : p;
    Eigen::Matrix3d turn;
    turn << x, z.cross(x), z;
    const double tau = needed / magnitude(search.last().friction_moment);
    if (rest.utilisation > 0 && !(tau < rest.utilisation)) return;
    rest.status = search.last().status;
    rest.utilisation = tau;
    rest.direction = turn * Vector3d(std::sin(c), 0, std::cos(c));
    rest.slip = search.last();
    rest.slip.reaction = reaction;
    for (Vector3d* v : {&rest.slip.normal, &rest.slip.friction_force,
                        &rest.slip.friction_moment, &rest.slip.slip_velocity}) {
      *v = turn * *v;
    }
  };

  rest.status = Status::not_converged;
  rest.utilisation = nan;
  if (last && last->utilisation > 0 && last->slip.status == Status::ok) {
    search.start_from(last->slip);
    const SineCosine b = last->slip.reaction_direction;
    const double c = search.near(std::atan2(b.sin, sign * b.cos));
    if (!std::isnan(c)) take(c);
  }
  if (rest.status != Status::ok) {
    const double c = search.near(angle_of_slip(joint.contact(), force, angle));
    if (!std::isnan(c)) take(c);
  }
  if (rest.status != Status::ok) search.all(take);
  rest.solves = search.solves();
  return rest;
}

bool depends_on_speed(const JointContact& contact) {
  return contact.stress() &&
         contact.stress()->over_speed() != FrictionStress::OverSpeed::constant;
}

// Joint::at_rest() with tau(p, 0); none if tau falls with the speed.
template <class... Arguments>
RestSolution slow_at_rest(const JointContact& contact,
                          const Arguments&... arguments) {
  const FrictionStress& stress = *contact.stress();
  if (stress.over_speed() == FrictionStress::OverSpeed::falls) {
    RestSolution none;
    none.utilisation = nan;
    none.direction.setConstant(nan);
    return none;
  }
  return Joint(contact.with_friction(stress.at_rest())).at_rest(arguments...);
}

}  // namespace

RestSolution Joint::at_rest(const Hold& hold,
                            const SolveOptions& options) const noexcept {
  const bool ends_pin = hold.placement && hold.placement->ends_pin();
  if (model_ && !is_pin() && !ends_pin) [[unlikely]]
    return model_->at_rest(hold, {}, options);
  if (depends_on_speed(contact_)) {
    return slow_at_rest(contact_, hold, options);
  }
  return is_pin() || ends_pin ? pin_at_rest(*this, hold, options)
                              : ball_at_rest(*this, hold, nullptr, options);
}

RestSolution Joint::at_rest(const Hold& hold, const RestSolution& last,
                            const SolveOptions& options) const noexcept {
  const bool ends_pin = hold.placement && hold.placement->ends_pin();
  if (is_pin() || ends_pin) return at_rest(hold, options);
  if (model_) [[unlikely]]
    return model_->at_rest(hold, last, options);
  return depends_on_speed(contact_)
             ? slow_at_rest(contact_, hold, last, options)
             : ball_at_rest(*this, hold, &last, options);
}

}  // namespace contact
