#include "libcontact/seat/joint.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/seat/friction.hpp"
#include "libcontact/seat/seat_work.hpp"
#include "libcontact/seat/table.hpp"

namespace contact {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Number of degrees: 1e-3 of the load for slip axes that pierce the contact
// beside a rim, else 1e-5.
constexpr int degrees = 130;
// Tolerance of R: ten times the error that SeatContact leaves.
constexpr double tolerance = 1e-7;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const SeatZone& zone_of(const JointSpec& joint) {
  if (!joint.geometry.seat()) {
    throw Error(detail::needs("a joint in a seat that ends", "[seat]"));
  }
  if (!joint.friction ||
      std::holds_alternative<FrictionStress>(*joint.friction)) {
    throw Error(detail::needs("a joint in a seat that ends",
                              "dry or viscous friction"));
  }
  return *joint.geometry.seat();
}

// Broyden's method for x = 0 of a function that is nearly x less a constant.
template <int n>
class Broyden {
 public:
  using Vector = Eigen::Matrix<double, n, 1>;
  using Matrix = Eigen::Matrix<double, n, n>;

  explicit Broyden(const Matrix& inverse) : inverse_(inverse) {}
  /// The step from where the function is `value`.
  /// @param came  by which step, from the place of the last call
  Vector step(const Vector& value, const Vector& came) {
    if (last_) {
      const Vector change = inverse_ * (value - *last_);
      const double size = came.dot(change);
      if (std::abs(size) > 1e-30) {
        inverse_ += (came - change) * (came.transpose() * inverse_) / size;
      }
    }
    last_ = value;
    return -inverse_ * value;
  }

 private:
  Matrix inverse_;
  std::optional<Vector> last_;
};

}  // namespace

SeatJoint::SeatJoint(const JointSpec& joint, const SeatContact::Grid& grid)
    : contact_(joint, zone_of(joint), grid),
      joint_(contact_.unbounded().with_friction(*joint.friction)),
      side_(joint.geometry.inner_body() == JointBody::carrier ? 1 : -1),
      sums_(std::make_unique<const detail::SeatSums>(degrees)) {
  const auto& axis = contact_.zone().axis();
  from_seat_ = Eigen::Quaterniond::FromTwoVectors(
                   Vector3d::UnitZ(), Vector3d(axis[0], axis[1], axis[2]))
                   .toRotationMatrix();
}

SeatJoint::~SeatJoint() = default;

SeatJointSolution SeatJoint::solve(const Joint::Slip& slip,
                                   const SeatJointSolution& last) const {
  Work work;
  work.state = in_seat(last);
  Joint::Slip turned = slip;
  turned.reaction = from_seat_.transpose() * slip.reaction;
  turned.angular_velocity = from_seat_.transpose() * slip.angular_velocity;
  SeatJointSolution s = slide(turned, work);
  turn(s);
  s.reaction = slip.reaction;
  return s;
}

SeatRestSolution SeatJoint::at_rest(const Joint::Hold& hold) const {
  Work work;
  Joint::Hold turned = hold;
  turned.reaction = from_seat_.transpose() * hold.reaction;
  turned.moment = from_seat_.transpose() * hold.moment;
  SeatRestSolution s = rest(turned, work);
  turn(s.slip);
  s.direction = from_seat_ * s.direction;
  s.slip.reaction = hold.reaction;
  return s;
}

void SeatJoint::turn(SeatJointSolution& s) const {
  s.nominal_area = contact_.nominal_area();
  for (Vector3d* v : {&s.contact.force, &s.contact.shift, &s.friction_force,
                      &s.friction_moment}) {
    *v = from_seat_ * *v;
  }
}

// Whether the contact of a joint without end stays inside the rims.
bool SeatJoint::is_free(const JointSolution& s) const {
  if (s.status != Status::ok || !(s.normal_force > 0)) return false;
  return contact_.is_free(side_ * s.normal, s.half_angle);
}

bool SeatJoint::is_free(const Vector3d& reaction) const {
  const Vector3d force = side_ * from_seat_.transpose() * reaction;
  return contact_.free_half_angle(force).has_value();
}

SeatJointSolution SeatJoint::free_solution(const JointSolution& s) const {
  SeatJointSolution result;
  result.contact =
      contact_.free_state(side_ * s.normal_force * s.normal, s.half_angle);
  result.reaction = s.reaction;
  result.friction_force = s.friction_force;
  result.friction_moment = s.friction_moment;
  result.power = s.power;
  result.moment_coefficient = s.moment_coefficient();
  result.evaluations = s.evaluations;
  return result;
}

// A force that the seat carries, and has a contact for: friction may hold a
// ball that its reaction alone would drive out, or onto the rim itself, where
// the shift is without bound.
Vector3d SeatJoint::start(const Vector3d& force) const {
  const SeatZone& zone = contact_.zone();
  const double direction = detail::polar_angle(force);
  const double pi = std::numbers::pi;
  constexpr double share = 0.98;  // share of the last that it carries
  double inside = direction;
  if (zone.to() <= pi / 2) inside = std::min(inside, share * zone.to());
  if (zone.from() >= pi / 2) {
    inside = std::max(inside, pi - share * (pi - zone.from()));
  }
  if (inside == direction) return force;
  return force.norm() * detail::plane_axes(force) *
         Vector3d(std::sin(inside), 0, std::cos(inside));
}

bool SeatJoint::find_contact(const Vector3d& force, Work& work) const {
  ++work.evaluations;
  const bool has_area = joint_.contact().strength(1).area_part != 0;
  if (table_ && table_->find(force, work.state, &work.harmonics, has_area)) {
    work.basis = &table_->basis();
    return true;
  }
  work.state = contact_.under(force, work.state);
  work.basis = &sums_->basis();
  if (work.state.solution) {
    work.harmonics = sums_->of(*work.state.solution, contact_.unit_force());
  }
  return work.state.status == SeatStatus::ok;
}

SeatJoint::Pull SeatJoint::friction(const Work& work,
                                    const Vector3d& rate) const {
  const Vector3d& force = work.state.force;
  if (work.state.is_free) {
    const JointSolution s = joint_.solve_contact(
        {.normal_force = side_ * force, .angular_velocity = rate});
    return {s.friction_force, s.friction_moment};
  }
  const double speed = rate.norm();
  if (speed == 0) return {Vector3d::Zero(), Vector3d::Zero()};
  const JointContact& contact = joint_.contact();
  const auto strength = contact.strength(speed);
  Eigen::ArrayXd c = strength.pressure_part * work.harmonics.pressure;
  if (strength.area_part != 0) c += strength.area_part * work.harmonics.area;
  const Eigen::Matrix3d axes = detail::plane_axes(force);
  const Vector3d w = axes.transpose() * rate / speed;
  const detail::SeatSlip sums =
      contact.is_viscous() ? work.basis->viscous(c, w) : work.basis->dry(c, w);
  return {-axes * sums.force,
          -contact.geometry().radius() * axes * sums.moment};
}

void SeatJoint::set_ratios(SeatJointSolution& s, const Vector3d& rate) const {
  s.power = s.friction_moment.dot(rate);
  s.moment_coefficient =
      s.friction_moment.norm() /
      (joint_.contact().geometry().radius() * s.reaction.norm());
}

SeatJointSolution SeatJoint::slide(const Joint::Slip& slip, Work& work) const {
  const JointSolution unbounded = joint_.solve(slip);
  if (is_free(unbounded)) return free_solution(unbounded);
  const Vector3d& rate = slip.angular_velocity;
  const Vector3d reaction = slip.reaction;
  SeatJointSolution s;
  s.reaction = reaction;
  const double size = reaction.norm();
  const bool is_warm = work.state.status == SeatStatus::ok;
  Vector3d force = start(is_warm ? work.state.force : side_ * reaction);
  Vector3d step = Vector3d::Zero();
  Broyden<3> newton(Eigen::Matrix3d::Identity());
  s.contact.status = SeatStatus::not_converged;
  s.contact.force.setConstant(nan);
  int outside = 0;
  for (int round = 0; round < 40; ++round) {
    if (!find_contact(force, work)) {
      s.contact.status = work.state.status;
      if (round == 0 || ++outside == 8) break;
      step /= 2;  // too far out of the seat
      force -= step;
      continue;
    }
    const Pull pull = friction(work, rate);
    const Vector3d better = side_ * (reaction - pull.force);
    const Vector3d off = force - better;
    if (off.norm() <= tolerance * size) {
      s.contact = work.state;
      s.contact.force = better;
      s.friction_force = pull.force;
      s.friction_moment = pull.moment;
      set_ratios(s, rate);
      break;
    }
    step = newton.step(off, step);
    force += step;
  }
  s.evaluations = work.evaluations;
  return s;
}

// u = -M/|M| + y, y across M, so that friction across M vanishes: the least of
// a convex function of y while F stays what it is.
SeatRestSolution SeatJoint::rest(const Joint::Hold& hold, Work& work) const {
  SeatRestSolution result;
  const double size = hold.moment.norm();
  const auto slip_about = [&](const Vector3d& u) {
    return Joint::Slip{.reaction = hold.reaction, .angular_velocity = u};
  };
  const RestSolution unbounded = joint_.at_rest(hold);
  if (is_free(unbounded.slip) || size == 0 || joint_.contact().is_viscous()) {
    result.slip = slide(slip_about(unbounded.direction), work);
    if (result.slip.contact.status == SeatStatus::ok) {
      result.utilisation = unbounded.utilisation;
      result.direction = unbounded.direction;
    }
    return result;
  }
  const Vector3d against = -hold.moment / size;
  const Vector3d e1 = against.unitOrthogonal(), e2 = against.cross(e1);
  const auto axis = [&](const Vector2d& y) -> Vector3d {
    return (against + y.x() * e1 + y.y() * e2).normalized();
  };
  const auto across = [&](const Vector3d& moment) -> Vector2d {
    return -Vector2d(moment.dot(e1), moment.dot(e2)) / moment.dot(against);
  };
  Vector2d y = Vector2d::Zero(), step = y;
  if (const double along = unbounded.direction.dot(against); along > 0.1) {
    y = Vector2d(unbounded.direction.dot(e1), unbounded.direction.dot(e2)) /
        along;
  }
  std::optional<Broyden<2>> newton;
  for (int round = 0; round < 40; ++round) {
    const Vector3d u = axis(y);
    result.slip = slide(slip_about(u), work);
    if (result.slip.contact.status != SeatStatus::ok) return result;
    const Vector2d off = across(result.slip.friction_moment);
    if (off.norm() < 10 * tolerance) {
      result.direction = u;
      result.utilisation = size / result.slip.friction_moment.norm();
      return result;
    }
    if (!newton) {
      if (result.slip.contact.is_free) {
        find_contact(result.slip.contact.force, work);
      }
      Eigen::Matrix2d slope;
      constexpr double h = 1e-4;
      for (const int i : {0, 1}) {
        const Vector2d side = h * Vector2d::Unit(i);
        slope.col(i) = (across(friction(work, axis(y + side)).moment) -
                        across(friction(work, axis(y - side)).moment)) /
                       (2 * h);
      }
      newton.emplace(slope.inverse());
    }
    step = newton->step(off, step);
    step *= std::min(1.0, 0.5 * (1 + y.norm()) / step.norm());
    y += step;
  }
  SeatJointSolution none;
  none.contact.status = SeatStatus::not_converged;
  none.contact.force.setConstant(nan);
  none.evaluations = result.slip.evaluations;
  result.slip = none;
  return result;
}

// The contact in the seat's axes. Without one notes ask where the load points.
SeatState SeatJoint::in_seat(const SeatJointSolution& s) const {
  SeatState state = s.contact;
  const bool is_found = s.contact.status == SeatStatus::ok;
  const Vector3d force = is_found ? s.contact.force : side_ * s.reaction;
  state.force = from_seat_.transpose() * force;
  state.shift = from_seat_.transpose() * s.contact.shift;
  return state;
}

// The same, on the grid if it is from the table.
SeatState SeatJoint::on_grid(const SeatJointSolution& s,
                             const SeatState& near) const {
  SeatState state = in_seat(s);
  const bool is_read =
      state.status == SeatStatus::ok && !state.is_free && !state.solution;
  return is_read ? contact_.under(state.force, near) : state;
}

SeatMomentSet SeatJoint::moment_set(const SeatJointSolution& solution) const& {
  auto work = std::make_shared<Work>();
  work->state = in_seat(solution);
  if (solution.contact.status == SeatStatus::ok && !work->state.is_free) {
    find_contact(work->state.force, *work);
  }
  return {*this, std::move(work)};
}

std::vector<double> SeatJoint::pressures(
    const SeatJointSolution& solution, std::span<const Vector3d> places) const {
  const SeatState state = on_grid(solution, {});
  std::vector<double> all;
  for (const Vector3d& place : places) {
    all.push_back(contact_.pressure(
        state, seat_place(state.force, from_seat_.transpose() * place)));
  }
  return all;
}

double SeatJoint::pressure_off_rims(const SeatJointSolution& solution,
                                    const Vector3d& place) const {
  const SeatState state = in_seat(solution);
  const SeatZone& zone = contact_.zone();
  const double off = contact_.report_distance();
  SeatPlace at = seat_place(state.force, from_seat_.transpose() * place);
  if (at.polar_angle >= zone.from() && at.polar_angle <= zone.to()) {
    if (zone.has_lower_rim()) {
      at.polar_angle = std::max(at.polar_angle, zone.from() + off);
    }
    if (zone.has_upper_rim()) {
      at.polar_angle = std::min(at.polar_angle, zone.to() - off);
    }
  }
  return contact_.pressure(state, at);
}

SeatPv SeatJoint::pv(const SeatJointSolution& solution, const Vector3d& rate,
                     SeatState& near) const {
  SeatState state = on_grid(solution, near);
  SeatPv pv = contact_.pv(state, from_seat_.transpose() * rate);
  pv.place = from_seat_ * pv.place;
  near = std::move(state);
  return pv;
}

std::vector<std::string> SeatJoint::notes(const SeatJointSolution& s) const {
  return contact_.notes(in_seat(s));
}

}  // namespace contact
