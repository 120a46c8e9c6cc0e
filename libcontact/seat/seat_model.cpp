#include "libcontact/seat/seat_model.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "libcontact/base/linear/turn.hpp"

namespace contact::detail {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

// Number of degrees: 1e-3 of the load for slip axes that pierce the contact
// beside a rim, else 1e-5.
constexpr int degrees = 130;
// Tolerance of R: ten times the error that SeatContact leaves.
constexpr double tolerance = 1e-7;

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
    if (has_last_) {
      const Vector change = inverse_ * (value - last_);
      const double size = came.dot(change);
      if (std::abs(size) > 1e-30) {
        inverse_ += (came - change) * (came.transpose() * inverse_) / size;
      }
    }
    last_ = value;
    has_last_ = true;
    return -inverse_ * value;
  }

 private:
  Matrix inverse_;
  Vector last_ = Vector::Zero();
  bool has_last_ = false;
};

// The work that found a solution in a seat that ends; null of a free one in the
// axes of its body.
const SeatFound* found_of(const JointSolution& s) {
  return dynamic_cast<const SeatFound*>(s.work.get());
}

const SeatFound* at_rim(const JointSolution& s) {
  const SeatFound* found = found_of(s);
  return found && found->is_at_rim ? found : nullptr;
}

Status status_of(SeatStatus status) {
  switch (status) {
    case SeatStatus::ok:
      return Status::ok;
    case SeatStatus::not_converged:
      return Status::not_converged;
    case SeatStatus::out_of_seat:
      return Status::out_of_seat;
    case SeatStatus::no_load:
      break;
  }
  return Status::out_of_range;
}

SineCosine between(const Vector3d& a, const Vector3d& b) {
  const double size = a.norm() * b.norm();
  if (size == 0) return {1, 0};
  return {a.cross(b).norm() / size, a.dot(b) / size};
}

bool has_grid(const SeatFound& found) {
  return found.state.solution != nullptr;
}

}  // namespace

SeatGrids::SeatGrids(const JointSpec& joint, const SeatContact::Grid& grid)
    : contact(joint, *joint.geometry.seat(), grid), sums(degrees) {}

std::shared_ptr<const ContactWork> SeatFound::without_grid() const {
  auto other = std::make_shared<SeatFound>(*this);
  other->state.solution = nullptr;
  other->harmonics = {};
  other->basis = nullptr;
  return other;
}

// R and Dw, in the axes of the seat and of the solution.
struct SeatModel::Turning {
  Vector3d given;  // R as it was given
  Vector3d reaction;
  Vector3d rate;
  JointSolution::Memory memory;  // memory of the seat without end

  Turning(const Matrix3d& to_solution, const Vector3d& force,
          const Vector3d& angular_velocity, const JointSolution::Memory& last)
      : given(force),
        reaction(to_solution.transpose() * force),
        rate(to_solution.transpose() * angular_velocity),
        memory(last) {}
};

// Slip axes near that against a moment, and directions across it.
struct SeatModel::Against {
  Vector3d against, e1, e2;

  // @param moment  of length 1
  explicit Against(const Vector3d& moment)
      : against(-moment), e1(against.unitOrthogonal()), e2(against.cross(e1)) {}
  Vector3d axis(const Vector2d& y) const {
    return (against + y.x() * e1 + y.y() * e2).normalized();
  }
  // The parts of v across the moment, over that along it.
  Vector2d across(const Vector3d& v) const {
    return Vector2d(v.dot(e1), v.dot(e2)) / v.dot(against);
  }
};

SeatModel::SeatModel(const JointSpec& joint,
                     std::shared_ptr<const SeatGrids> grids, Joint endless,
                     std::shared_ptr<const SeatTable> table)
    : spec_(joint),
      grids_(std::move(grids)),
      endless_(std::move(endless)),
      side_(joint.geometry.side()),
      table_(std::move(table)) {
  const auto& axis = grids_->contact.zone().axis();
  to_body_ = turn_of_z(Vector3d(axis[0], axis[1], axis[2]));
}

Matrix3d SeatModel::to_solution(const Placement* placement) const {
  return placement ? Matrix3d(placement->from_seat * to_body_) : to_body_;
}

// Whether a contact of the seat without end stays inside the rims.
bool SeatModel::is_free(const JointSolution& s, const Matrix3d& turn) const {
  if (s.status != Status::ok || !(s.normal_force > 0)) return false;
  const SineCosine angle = between(turn.col(2), side_ * s.normal);
  return grids_->contact.is_free(std::atan2(angle.sin, angle.cos),
                                 s.half_angle);
}

// A solution of the seat without end, which keeps the axes of a placement.
JointSolution SeatModel::in_its_axes(JointSolution s,
                                     const Placement* placement) const {
  if (!placement) return s;
  auto axes = std::make_shared<SeatFound>();
  axes->to_solution = to_solution(placement);
  s.work = std::move(axes);
  return s;
}

std::shared_ptr<SeatFound> SeatModel::begin(const JointSolution& last,
                                            const Placement* placement) const {
  auto found = std::make_shared<SeatFound>();
  found->to_solution = to_solution(placement);
  found->is_at_rim = true;
  if (const SeatFound* near = at_rim(last)) found->state = near->state;
  return found;
}

JointSolution SeatModel::solve(const Joint::Slip& slip,
                               const JointSolution& last,
                               const SolveOptions& options) const {
  JointSolution s = endless_.solve(slip, last, options);
  if (is_free(s, to_solution(slip.placement))) {
    return in_its_axes(std::move(s), slip.placement);
  }
  const bool is_finite =
      slip.reaction.allFinite() && slip.angular_velocity.allFinite();
  if (!is_finite || s.state == JointState::unloaded) return s;
  const auto found = begin(last, slip.placement);
  return slide(
      {found->to_solution, slip.reaction, slip.angular_velocity, s.memory},
      found);
}

JointSolution SeatModel::solve_contact(const Joint::KnownContact& known) const {
  const JointSolution s = endless_.solve_contact(known);
  if (is_free(s, to_solution(known.placement))) {
    return in_its_axes(s, known.placement);
  }
  if (s.status != Status::ok || s.state == JointState::unloaded) return s;
  const auto found = begin({}, known.placement);
  Turning turning(found->to_solution, known.normal_force,
                  known.angular_velocity, {});
  if (!find_contact(side_ * turning.reaction, *found)) {
    return no_answer(turning, found->state.status, found);
  }
  const Pull pull = friction(*found, turning.rate);
  turning.reaction += pull.force;
  turning.given += found->to_solution * pull.force;
  return answer(turning, pull, found);
}

JointSolution SeatModel::no_answer(
    const Turning& turning, SeatStatus status,
    const std::shared_ptr<SeatFound>& found) const {
  found->is_at_rim = true;
  found->state = {};
  found->state.status = status;
  found->state.force = side_ * turning.reaction;  // notes say where it points
  found->basis = nullptr;
  JointSolution s = not_a_number(status_of(status), turning.given);
  s.evaluations = found->evaluations;
  s.memory = turning.memory;
  s.work = found;
  return s;
}

// A contact that was found, with the force on the seat and the friction.
JointSolution SeatModel::answer(const Turning& turning, const Pull& pull,
                                const std::shared_ptr<SeatFound>& found) const {
  const SeatState& state = found->state;
  found->is_at_rim = !state.is_free;  // friction may free it
  JointSolution s =
      state.is_free
          ? endless_.solve_contact(
                {.normal_force = found->to_solution * (side_ * state.force),
                 .angular_velocity = found->to_solution * turning.rate})
          : at_rim_solution(turning, pull, *found);
  s.reaction = turning.given;
  s.evaluations = found->evaluations;
  s.memory = turning.memory;
  found->moment_coefficient =
      pull.moment.norm() /
      (endless_.contact().geometry().radius() * turning.reaction.norm());
  s.work = found;
  return s;
}

JointSolution SeatModel::at_rim_solution(const Turning& turning,
                                         const Pull& pull,
                                         const SeatFound& found) const {
  const SeatState& state = found.state;
  const Matrix3d& turn = found.to_solution;
  const JointContact& contact = endless_.contact();
  JointSolution s = not_a_number(status_of(state.status), turning.given);
  const double speed = turning.rate.norm();
  s.state = speed > 0 ? JointState::sliding : JointState::resting;
  s.normal_force = state.force.norm();
  s.normal = turn * (side_ * state.force / s.normal_force);
  s.friction_force = turn * pull.force;
  s.friction_moment = turn * pull.moment;
  s.power = pull.moment.dot(turning.rate);
  s.textbook_moment = textbook_moment(contact, turning.reaction);
  s.reaction_direction = between(turning.reaction, turning.rate);
  s.force_coefficient = pull.force.norm() / s.normal_force;
  set_state(s, contact, contact.strength(speed));
  s.peak_pressure = state.peak_pressure;
  s.contact_area = state.area;
  return s;
}

// A first force that the seat carries: friction may hold a ball that its
// reaction alone would drive out, or onto the rim itself, where the shift is
// unbounded.
Vector3d SeatModel::start(const Vector3d& force) const {
  const SeatZone& zone = grids_->contact.zone();
  const double direction = polar_angle(force);
  const double pi = std::numbers::pi;
  constexpr double share = 0.98;  // share of the way to the last one carried
  double inside = direction;
  if (zone.to() <= pi / 2) inside = std::min(inside, share * zone.to());
  if (zone.from() >= pi / 2) {
    inside = std::max(inside, pi - share * (pi - zone.from()));
  }
  if (inside == direction) return force;
  return force.norm() * plane_axes(force) *
         Vector3d(std::sin(inside), 0, std::cos(inside));
}

bool SeatModel::find_contact(const Vector3d& force, SeatFound& found) const {
  ++found.evaluations;
  const bool has_area = endless_.contact().strength(1).area_part != 0;
  if (table_ && table_->find(force, found.state, &found.harmonics, has_area)) {
    found.basis = {table_, &table_->basis()};
    return true;
  }
  found.state = grids_->contact.under(force, found.state);
  found.basis = nullptr;
  add_harmonics(found);
  return found.state.status == SeatStatus::ok;
}

void SeatModel::add_harmonics(SeatFound& found) const {
  if (found.basis || !has_grid(found)) return;
  found.harmonics =
      grids_->sums.of(*found.state.solution, grids_->contact.unit_force());
  found.basis = {grids_, &grids_->sums.basis()};
}

SeatModel::Pull SeatModel::friction(const SeatFound& found,
                                    const Vector3d& rate) const {
  const Vector3d& force = found.state.force;
  if (found.state.is_free) {
    const JointSolution s = endless_.solve_contact(
        {.normal_force = side_ * force, .angular_velocity = rate});
    return {s.friction_force, s.friction_moment};
  }
  const double speed = rate.norm();
  if (speed == 0) return {Vector3d::Zero(), Vector3d::Zero()};
  const JointContact& contact = endless_.contact();
  const auto strength = contact.strength(speed);
  Eigen::ArrayXd c = strength.pressure_part * found.harmonics.pressure;
  if (strength.area_part != 0) c += strength.area_part * found.harmonics.area;
  const Matrix3d axes = plane_axes(force);
  const Vector3d w = axes.transpose() * rate / speed;
  const SeatSlip sums = contact.is_viscous() ? found.basis->viscous(c, w)
                                             : found.basis->dry(c, w);
  return {-axes * sums.force,
          -contact.geometry().radius() * axes * sums.moment};
}

JointSolution SeatModel::slide(const Turning& turning,
                               const std::shared_ptr<SeatFound>& found) const {
  const Vector3d& reaction = turning.reaction;
  const double size = reaction.norm();
  const bool is_warm = found->state.status == SeatStatus::ok;
  Vector3d force = start(is_warm ? found->state.force : side_ * reaction);
  Vector3d step = Vector3d::Zero();
  Broyden<3> newton(Matrix3d::Identity());
  int outside = 0;
  for (int round = 0; round < 40; ++round) {
    if (!find_contact(force, *found)) {
      if (round == 0 || ++outside == 8) {
        return no_answer(turning, found->state.status, found);
      }
      step /= 2;  // too far out of the seat
      force -= step;
      continue;
    }
    const Pull pull = friction(*found, turning.rate);
    const Vector3d better = side_ * (reaction - pull.force);
    const Vector3d off = force - better;
    if (off.norm() <= tolerance * size) {
      found->state.force = better;
      return answer(turning, pull, found);
    }
    step = newton.step(off, step);
    force += step;
  }
  return no_answer(turning, SeatStatus::not_converged, found);
}

RestSolution SeatModel::at_rest(const Joint::Hold& hold,
                                const RestSolution& last,
                                const SolveOptions& options) const {
  RestSolution rest = endless_.at_rest(hold, last, options);
  if (is_free(rest.slip, to_solution(hold.placement))) {
    rest.slip = in_its_axes(std::move(rest.slip), hold.placement);
    return rest;
  }
  const bool is_finite = hold.reaction.allFinite() && hold.moment.allFinite();
  if (!is_finite || rest.slip.state == JointState::unloaded) return rest;
  const auto found = begin(last.slip, hold.placement);
  if (hold.moment.isZero(0) || endless_.contact().is_viscous()) {
    rest.slip =
        slide({found->to_solution, hold.reaction, rest.direction, {}}, found);
    rest.status = rest.slip.status;
    rest.solves = 1;
  } else if (find_rest(hold, rest.direction, found, rest)) {
    return rest;
  }
  if (rest.status == Status::ok) return rest;
  rest.utilisation = std::numeric_limits<double>::quiet_NaN();
  rest.direction.setConstant(rest.utilisation);
  return rest;
}

// u = -M/|M| + y, y across M, so that friction across M vanishes: the least of
// a convex function of y while F stays what it is.
// @param direction  u of the seat without end
bool SeatModel::find_rest(const Joint::Hold& hold, const Vector3d& direction,
                          const std::shared_ptr<SeatFound>& found,
                          RestSolution& rest) const {
  const Matrix3d& turn = found->to_solution;
  const double size = hold.moment.norm();
  const Against against(turn.transpose() * hold.moment / size);
  const Vector3d start = turn.transpose() * direction;
  Vector2d y = Vector2d::Zero(), step = y;
  if (start.dot(against.axis(y)) > 0.1) y = against.across(start);
  std::optional<Broyden<2>> newton;
  for (rest.solves = 1; rest.solves <= 40; ++rest.solves) {
    const Vector3d u = turn * against.axis(y);
    rest.slip = slide({turn, hold.reaction, u, {}}, found);
    rest.status = rest.slip.status;
    if (rest.status != Status::ok) return false;
    const Vector3d& held = rest.slip.friction_moment;
    const Vector2d off = against.across(turn.transpose() * held);
    if (off.norm() < 10 * tolerance) {
      rest.direction = u;
      rest.utilisation = size / held.norm();
      return true;
    }
    if (!newton) newton.emplace(slope(*found, against, y).inverse());
    step = newton->step(off, step);
    step *= std::min(1.0, 0.5 * (1 + y.norm()) / step.norm());
    y += step;
  }
  rest.status = Status::not_converged;
  return false;
}

// Slope of friction across M over y, at one contact: by central differences.
Eigen::Matrix2d SeatModel::slope(const SeatFound& found, const Against& against,
                                 const Vector2d& y) const {
  constexpr double h = 1e-4;
  Eigen::Matrix2d slope;
  for (const int i : {0, 1}) {
    const auto across = [&](double by) {
      return against.across(
          friction(found, against.axis(y + by * Vector2d::Unit(i))).moment);
    };
    slope.col(i) = (across(h) - across(-h)) / (2 * h);
  }
  return slope;
}

// Friction of one contact in the axes of its solution.
class SeatModel::Moments final : public ContactMoments {
 public:
  Moments(const SeatModel& model, SeatFound found)
      : model_(model), found_(std::move(found)) {}

  Vector3d moment(const Vector3d& angular_velocity) const override {
    const Matrix3d& turn = found_.to_solution;
    return turn *
           model_.friction(found_, turn.transpose() * angular_velocity).moment;
  }

 private:
  const SeatModel& model_;
  SeatFound found_;
};

std::shared_ptr<const ContactMoments> SeatModel::moments(
    const JointSolution& solution) const {
  const SeatFound* found = at_rim(solution);
  if (!found || solution.status != Status::ok) return nullptr;
  SeatFound with_friction = *found;
  add_harmonics(with_friction);
  if (!with_friction.basis) find_contact(found->state.force, with_friction);
  return std::make_shared<const Moments>(*this, std::move(with_friction));
}

// The contact of a solution in the seat's axes.
SeatState SeatModel::state_of(const JointSolution& s) const {
  if (const SeatFound* found = at_rim(s)) return found->state;
  if (s.status != Status::ok || !(s.normal_force > 0)) return {};
  const SeatFound* found = found_of(s);
  const Matrix3d& turn = found ? found->to_solution : to_body_;
  return grids_->contact.free_state(
      turn.transpose() * (side_ * s.normal_force * s.normal), s.half_angle);
}

std::optional<RimContact> SeatModel::rims(const JointSolution& s) const {
  RimContact contact = state_of(s);
  if (contact.force.isZero(0)) return {};
  const SeatFound* found = found_of(s);
  const Matrix3d& turn = found ? found->to_solution : to_body_;
  contact.force =
      s.status == Status::ok
          ? Vector3d(turn * contact.force)
          : Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  contact.shift = turn * contact.shift;
  contact.nominal_area = grids_->contact.nominal_area();
  return contact;
}

JointSolution SeatModel::with_grid(const JointSolution& s,
                                   const JointSolution& near) const {
  const SeatFound* found = at_rim(s);
  if (!found || s.status != Status::ok || has_grid(*found)) return s;
  const SeatFound* start = at_rim(near);
  const SeatState state = grids_->contact.under(
      found->state.force, start ? start->state : SeatState());
  auto finer = std::make_shared<SeatFound>(*found);
  finer->state.solution = state.solution;
  JointSolution other = s;
  other.work = std::move(finer);
  return other;
}

ContactPv SeatModel::pv(const JointSolution& s, const Vector3d& rate) const {
  const JointSolution whole = with_grid(s, {});
  const SeatFound* found = at_rim(whole);
  if (!found || s.status != Status::ok) return {};
  const Matrix3d& turn = found->to_solution;
  ContactPv pv = grids_->contact.pv(found->state, turn.transpose() * rate);
  pv.place = turn * pv.place;
  return pv;
}

std::vector<double> SeatModel::pressures(const JointSolution& s,
                                         std::span<const Vector3d> places,
                                         Joint::RimPressure at_rims) const {
  std::vector<double> all(places.size(),
                          std::numeric_limits<double>::quiet_NaN());
  const JointSolution whole = with_grid(s, {});
  const SeatFound* found = at_rim(whole);
  if (!found || s.status != Status::ok) return all;
  const SeatContact& contact = grids_->contact;
  const SeatZone& zone = contact.zone();
  const double off = zone.edge().report_distance;
  for (std::size_t i = 0; i < places.size(); ++i) {
    SeatPlace at = seat_place(found->state.force,
                              found->to_solution.transpose() * places[i]);
    if (at_rims == Joint::RimPressure::reported &&
        at.polar_angle >= zone.from() && at.polar_angle <= zone.to()) {
      if (zone.has_lower_rim()) {
        at.polar_angle = std::max(at.polar_angle, zone.from() + off);
      }
      if (zone.has_upper_rim()) {
        at.polar_angle = std::min(at.polar_angle, zone.to() - off);
      }
    }
    all[i] = contact.pressure(found->state, at);
  }
  return all;
}

std::vector<std::string> SeatModel::notes(const JointSolution& s) const {
  if (s.state == JointState::unloaded && s.status == Status::ok) return {};
  return grids_->contact.notes(state_of(s));
}

std::shared_ptr<const ContactModel> SeatModel::tabulated(
    const RimTableOptions& options) const {
  return std::make_shared<const SeatModel>(
      spec_, grids_, endless_,
      std::make_shared<const SeatTable>(grids_->contact, options));
}

std::shared_ptr<const ContactModel> SeatModel::tabulated(
    std::string_view table) const {
  return std::make_shared<const SeatModel>(
      spec_, grids_, endless_,
      std::make_shared<const SeatTable>(grids_->contact, spec_, table));
}

std::string SeatModel::table() const {
  return table_ ? table_->bytes(spec_) : std::string();
}

std::optional<RimTableCheck> SeatModel::table_check() const {
  if (!table_) return {};
  return table_->check();
}

}  // namespace contact::detail
