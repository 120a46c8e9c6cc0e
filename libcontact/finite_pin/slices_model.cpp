#include "libcontact/finite_pin/slices_model.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/magnitude.hpp"
#include "libcontact/joint/slip/taken_force.hpp"

namespace contact::detail {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

const SlicesFound* found_of(const JointSolution& s) {
  return dynamic_cast<const SlicesFound*>(s.work.get());
}

Vector3d in_space(const Matrix3d& axes, const Vector2d& across) {
  return axes.leftCols<2>() * across;
}

// A unit vector along the axis; any one across the force for a level pin that
// rests and was given no axis: the size of the force alone counts then.
Vector3d axis_of(const Vector3d& given, const Vector3d& rate,
                 const Vector3d& force) {
  if (!given.isZero(0)) return given.stableNormalized();
  if (!rate.isZero(0)) return rate.stableNormalized();
  return force.isZero(0) ? Vector3d::UnitZ() : force.unitOrthogonal();
}

}  // namespace

std::shared_ptr<const ContactWork> SlicesFound::without_grid() const {
  return std::make_shared<SlicesFound>(*this);
}

// Question of a call, in the axes of the slices.
struct SlicesModel::Asked {
  Vector3d force;  // across the axis
  Vector3d rate;
  Placement placement;
  Matrix3d axes;
  bool has_answer;

  template <class Call>
  Asked(const Joint& joint, const Call& call, const Vector3d& given)
      : force(taken(joint, given, call.angular_velocity, call.axis)),
        rate(call.angular_velocity),
        placement(call.placement ? *call.placement : Placement()) {
    Vector3d z = axis_of(call.axis, rate, force);
    Vector3d x =
        force.isZero(0) ? z.unitOrthogonal() : force.stableNormalized();
    x = (x - x.dot(z) * z).normalized();
    axes << x, z.cross(x), z;
    const bool has_axis = !call.axis.isZero(0) || !rate.isZero(0);
    has_answer = given.allFinite() && rate.allFinite() && axes.allFinite() &&
                 placement.tilt.allFinite() && !std::isinf(placement.place) &&
                 std::isfinite(placement.axial_velocity) &&
                 (has_axis || !placement.ends_pin());
  }

  bool is_placed() const { return !std::isnan(placement.place); }
  Vector2d tilt() const {
    return axes.leftCols<2>().transpose() * placement.tilt;
  }
  FinitePin::Motion motion() const {
    return {axes.col(2).dot(rate), placement.axial_velocity};
  }
};

struct SlicesModel::Numerics {
  JointSpec spec;
  std::once_flag once;
  std::unique_ptr<const FinitePin> pin;
};

SlicesModel::SlicesModel(const JointSpec& joint, const JointContact& contact)
    : level_(contact),
      side_(joint.geometry.side()),
      numerics_(new Numerics{joint, {}, {}}) {
  if (const std::string why = FinitePin::refusal(joint); !why.empty()) {
    throw Error(why);
  }
  joint.relief.pieces(joint.geometry.length());
}

SlicesModel::~SlicesModel() = default;

// The pin; null if its law cannot be made although refusal() has let it pass.
const FinitePin* SlicesModel::pin() const noexcept {
  std::call_once(numerics_->once, [this] {
    try {
      numerics_->pin = std::make_unique<FinitePin>(numerics_->spec);
    } catch (const Error&) {
    }
  });
  return numerics_->pin.get();
}

JointSolution SlicesModel::solve(const Joint::Slip& slip,
                                 const JointSolution& /*last*/,
                                 const SolveOptions& /*options*/) const {
  const Asked asked(level_, slip, slip.reaction);
  const FinitePin* of = asked.has_answer ? pin() : nullptr;
  if (!of) return not_a_number(Status::out_of_range, asked.force);
  const Vector2d force(magnitude(asked.force), 0);
  const double place = asked.placement.place;
  return answer(asked, asked.is_placed()
                           ? of->solve_at(force, place, asked.motion())
                           : of->solve(force, asked.tilt(), asked.motion()));
}

JointSolution SlicesModel::solve_contact(
    const Joint::KnownContact& known) const {
  Asked asked(level_, known, known.normal_force);
  const FinitePin* of = asked.has_answer ? pin() : nullptr;
  if (!of) return not_a_number(Status::out_of_range, asked.force);
  const Vector2d force(side_ * magnitude(asked.force), 0);
  const FinitePinSolution found = of->friction(
      asked.is_placed() ? of->under_moment(force, asked.placement.place * force)
                        : of->under(force, asked.tilt()),
      asked.motion());
  asked.force += in_space(asked.axes, found.friction_force);
  return answer(asked, found);
}

JointSolution SlicesModel::answer(const Asked& asked,
                                  const FinitePinSolution& found) const {
  const FinitePinState& state = found.contact;
  JointSolution s = not_a_number(state.status, asked.force);
  s.evaluations = state.iterations;
  if (state.status != Status::ok) return s;
  const auto work = std::make_shared<SlicesFound>();
  work->axes = asked.axes;
  work->pin = found;
  work->axial_velocity = asked.placement.axial_velocity;
  const FinitePin::Motion motion = asked.motion();
  const bool slides = motion.rate != 0 || motion.axial_velocity != 0;
  if (state.pieces == 0) {
    s = level_.solve({Vector3d::Zero(), asked.rate, asked.axes.col(2)});
  } else {
    const JointContact& contact = level_.contact();
    const double rho = contact.geometry().radius();
    const Vector3d axis = asked.axes.col(2);
    const bool is_pressed = !asked.force.isZero(0);
    s.state = slides ? JointState::sliding : JointState::resting;
    s.normal_force = is_pressed ? state.force.norm() : 0;
    s.normal.setZero();
    if (is_pressed) {
      s.normal = in_space(asked.axes, side_ / s.normal_force * state.force);
    }
    s.friction_force = in_space(asked.axes, found.friction_force) +
                       found.axial_friction_force * axis;
    s.friction_moment = found.moment.z() * axis;
    s.power = found.moment.z() * motion.rate +
              found.axial_friction_force * motion.axial_velocity;
    s.textbook_moment = textbook_moment(contact, asked.force);
    s.reaction_direction = {1, 0};
    s.force_coefficient = s.friction_force.norm() / s.normal_force;
    set_state(s, contact, contact.strength(std::abs(motion.rate)));
    s.peak_pressure = state.peak_pressure;
    s.contact_area = state.area_moment / rho;
    work->moment_coefficient =
        std::abs(found.moment.z()) / (rho * magnitude(asked.force));
  }
  s.work = work;
  return s;
}

std::optional<PinLie> SlicesModel::lie(const JointSolution& s) const {
  const SlicesFound* found = found_of(s);
  if (!found || s.status != Status::ok) return {};
  const FinitePinSolution& pin = found->pin;
  const FinitePinState& state = pin.contact;
  const auto turned = [&](const Vector2d& across) {
    return in_space(found->axes, across);
  };
  return PinLie{.tilt = turned(state.tilt),
                .shift = turned(state.shift),
                .pieces = state.pieces,
                .low = state.low,
                .high = state.high,
                .peak_pressure = state.peak_pressure,
                .peak_place = state.peak_place,
                .largest_half_angle = state.largest_half_angle,
                .half_angle_place = state.half_angle_place,
                .end_pressure = state.end_pressure,
                .end_half_angle = state.end_half_angle,
                .tilting_moment = turned(state.force_moment),
                .tilting_stiffness = state.stiffness(2, 2),
                .moment = found->axes * pin.moment,
                .axial_friction_force = pin.axial_friction_force};
}

ContactPv SlicesModel::pv(const JointSolution& s, const Vector3d& rate) const {
  const SlicesFound* found = found_of(s);
  const FinitePin* of = found && s.status == Status::ok ? pin() : nullptr;
  if (!of) return {};
  const FinitePinState& state = found->pin.contact;
  const FinitePin::Motion motion{found->axes.col(2).dot(rate),
                                 found->axial_velocity};
  return {of->slip_speed(motion) * state.pressure_moment /
              level_.contact().geometry().radius(),
          of->largest_pv(state, motion),
          in_space(found->axes, of->slice(state, state.peak_place).direction)};
}

std::vector<double> SlicesModel::pressures(
    const JointSolution& s, std::span<const Vector3d> places,
    Joint::RimPressure /*at_rims*/) const {
  std::vector<double> all(places.size(), nan);
  const SlicesFound* found = found_of(s);
  const FinitePin* of = found && s.status == Status::ok ? pin() : nullptr;
  if (!of) return all;
  const JointGeometry& geometry = level_.contact().geometry();
  const double rho = geometry.radius();
  const double half = geometry.length() / 2;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vector3d at = found->axes.transpose() * places[i];
    const double across = std::hypot(at.x(), at.y());
    double z = rho * at.z() / across;
    // Rounding may put a place at an end beyond it.
    if (std::abs(z) <= half * (1 + 1e-14)) z = std::clamp(z, -half, half);
    if (std::isnan(across) || std::isnan(at.z())) continue;
    all[i] = std::isfinite(z) ? of->pressure(found->pin.contact, z,
                                             std::atan2(at.y(), at.x()))
                              : 0;
  }
  return all;
}

std::vector<std::string> SlicesModel::notes(const JointSolution& s) const {
  return failure_notes(s.status,
                       "the load needs a half-angle along the pin beyond 80 "
                       "deg, or beyond the limit of the pair");
}

}  // namespace contact::detail
