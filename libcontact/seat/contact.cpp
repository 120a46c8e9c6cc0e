#include "libcontact/seat/contact.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "libcontact/base/check.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/seat/friction.hpp"
#include "libcontact/seat/readout.hpp"
#include "libcontact/seat/rim_warning.hpp"
#include "libcontact/seat/side_face_mesh.hpp"
#include "libcontact/seat/side_face_reach.hpp"

namespace contact {

namespace {

using detail::nan;
using detail::pi;
constexpr const char* rim_names[] = {"lower", "upper"};

JointContact exact_contact(JointSpec joint) {
  if (joint.geometry.kind() != JointKind::ball) {
    throw Error(detail::needs("a seat that ends", "a ball"));
  }
  if (joint.loading.is_back()) {
    throw Error(detail::needs("a seat that ends", "loading = centre"));
  }
  joint = joint.without_seat();
  joint.half_angle_law = joint.pressure_law = "exact";
  joint.half_angle_options = {};
  joint.friction = FrictionLaw(0);
  return joint.contact();
}

LayeredPair pair_of(const JointSpec& joint) {
  const LayeredPair pair(joint.geometry.radius(), joint.inner, joint.outer);
  const double least = SeatContact::smallest_relative_thickness * pair.radius();
  detail::require(
      pair.relative_thickness() >= SeatContact::smallest_relative_thickness,
      "seat", "thickness of the surface layer",
      pair.relative_thickness() * pair.radius(),
      detail::message("at least 0.001 radii ({:.4g} m)", least));
  return pair;
}

// Between two places on the sphere, a longitude apart.
double angle_between(double v1, double v2, double longitude) {
  const double across = std::sin(longitude / 2);
  const double along = std::sin((v1 - v2) / 2);
  return 2 * std::asin(std::sqrt(std::min(
                 along * along + std::sin(v1) * std::sin(v2) * across * across,
                 1.0)));
}

// How the pressure goes at a corner whose side face is free.
std::string at_corner(double corner) {
  const double exponent = detail::corner_exponent(corner);
  constexpr double small = -0.005;
  if (std::isnan(exponent)) return "falls to 0";
  if (exponent > small) return "is finite";
  return detail::message("grows like s^{:.2f}, s the distance", exponent);
}

Eigen::Vector2d in_plane(const Eigen::Vector3d& force) {
  return {std::hypot(force.x(), force.y()), force.z()};
}

}  // namespace

SeatContact::SeatContact(const JointSpec& joint, const SeatZone& zone,
                         const Grid& grid)
    : radius_(joint.geometry.radius()),
      contact_(exact_contact(joint)),
      zone_(zone) {
  detail::require(grid.cells >= 8 && grid.cells <= 200, "seat", "cells",
                  grid.cells, "8 to 200");
  detail::require(grid.longitudes >= 16 && grid.longitudes <= 720, "seat",
                  "longitudes", grid.longitudes, "16 to 720");
  const LayeredPair pair = pair_of(joint);
  surface_layer_ = radius_ * pair.relative_thickness();
  set_rim_warning(pair);
  windows_ = std::make_unique<const detail::SeatWindows>(
      pair, zone, grid.cells, grid.longitudes,
      joint.geometry.radial_clearance());
}

SeatContact::~SeatContact() = default;

// Says at once what its side faces do not allow, and how they are had.
void SeatContact::set_rim_warning(const LayeredPair& pair) {
  const SeatEdge& edge = zone_.edge();
  std::string why = detail::SideFaceMesh(pair, zone_).refusal();
  if (edge.side_face == SideFace::free) {
    if (!why.empty()) throw Error(why);
  } else if (edge.housing == SideFace::free) {
    throw Error(detail::needs("housing = free", "side_face = free"));
  }
  if (why.empty()) why = "side_face = \"free\" of the [seat] computes it";
  rim_warning_ =
      std::make_unique<const detail::RimWarning>(pair, zone_, std::move(why));
}

SeatState SeatContact::under(const Eigen::Vector3d& force) const {
  return under(force, {});
}

SeatState SeatContact::under(const Eigen::Vector3d& force,
                             const SeatState& near) const {
  SeatState state;
  state.force = force;
  const double load = force.norm();
  if (!(load > 0 && std::isfinite(load))) return state;
  if (const auto half_angle = free_half_angle(force)) {
    return free_state(force, *half_angle);
  }
  if (!zone_.carries(detail::polar_angle(force))) {
    state.status = SeatStatus::out_of_seat;
    return state;
  }
  return confined(force, near);
}

bool SeatContact::is_free(double direction, double half_angle) const {
  if (!(zone_.margin(direction, half_angle) >= 0)) return false;
  // A side face that is free yields to contacts before it too.
  return !has_free_side_face() || half_angle <= reach().half_angle(direction);
}

const detail::SideFaceReach& SeatContact::reach() const {
  std::call_once(made_reach_, [&] {
    reach_ = std::make_unique<const detail::SideFaceReach>(
        windows_->pair(), zone_, [&](double half_angle) {
          return contact_.approach(half_angle).stiffness;
        });
  });
  return *reach_;
}

Eigen::Vector3d SeatContact::more_shift(const Eigen::Vector3d& force,
                                        double half_angle) const {
  if (!has_free_side_face()) return Eigen::Vector3d::Zero();
  const Eigen::Vector2d shift =
      reach().more(detail::polar_angle(force), half_angle).shift;
  return force.norm() * detail::plane_axes(force) *
         Eigen::Vector3d(shift.x(), 0, shift.y());
}

std::optional<double> SeatContact::free_half_angle(
    const Eigen::Vector3d& force) const {
  const HalfAngleResult result = contact_.half_angle(force.norm());
  if (result.status != Status::ok ||
      !is_free(detail::polar_angle(force), result.half_angle)) {
    return {};
  }
  return result.half_angle;
}

SeatState SeatContact::confined(const Eigen::Vector3d& force,
                                const SeatState& near) const {
  SeatState state;
  state.force = force;
  auto solution = near.solution
                      ? std::make_shared<detail::SeatSolution>(*near.solution)
                      : std::make_shared<detail::SeatSolution>();
  if (!windows_->balance(in_plane(force), *solution)) {
    state.status = SeatStatus::not_converged;
    return state;
  }
  state.status = SeatStatus::ok;
  state.solution = std::move(solution);
  set_confined(detail::polar_angle(force), state);
  return state;
}

bool SeatContact::has_free_side_face() const {
  return zone_.edge().side_face == SideFace::free &&
         (zone_.has_lower_rim() || zone_.has_upper_rim());
}

double SeatContact::unit_force() const { return windows_->unit_force(); }

SeatState SeatContact::free_state(const Eigen::Vector3d& force,
                                  double half_angle) const {
  const double load = force.norm();
  const double direction = detail::polar_angle(force);
  SeatState state;
  state.force = force;
  state.status = SeatStatus::ok;
  state.is_free = true;
  state.shift = contact_.shift(load, half_angle) / load * state.force +
                more_shift(force, half_angle);
  state.pressure_at_load = contact_.pressure(0, load, half_angle);
  state.peak_pressure = contact_.peak_pressure(load, half_angle);
  state.peak_place = {direction, 0};
  state.lower_end = std::max(0.0, direction - half_angle);
  state.upper_end = std::min(pi, direction + half_angle);
  state.half_width = half_angle;
  state.force_ratio = contact_.sum_of_pressures(load, half_angle) / load;
  state.area = contact_.area(half_angle);
  for (SeatRim& rim : state.rims) rim.intensity = rim.half_arc = 0;
  set_rims(state);
  return state;
}

void SeatContact::set_confined(double direction, SeatState& state) const {
  const detail::SeatPatchSolver& solver = *state.solution->solver;
  const detail::SeatPatch& patch = state.solution->patch;
  const double modulus = contact_.pair().effective_modulus();
  const double unit = modulus / (4 * radius_);  // unit of pressures
  const detail::SeatReadout read(solver, patch);
  const bool is_axial = in_plane(state.force).x() == 0;
  state.shift = detail::plane_axes(state.force) *
                Eigen::Vector3d(patch.shift.x(), 0, patch.shift.y());
  const bool on_seat = direction >= zone_.from() && direction <= zone_.to();
  state.pressure_at_load = on_seat ? unit * read.pressure(direction, 0) : nan;
  const auto peak = read.peak(report_distance());
  state.peak_pressure = unit * peak.pressure;
  state.peak_place = {peak.polar_angle, is_axial ? nan : peak.longitude};
  for (const int rim : {0, 1}) {
    const auto at = read.rim(rim);
    state.rims[rim].intensity =
        at.strength * unit * std::sqrt(2 * pi * radius_);
    // The pressure there is not a punch's.
    if (has_free_side_face() && at.strength > 0)
      state.rims[rim].intensity = nan;
    state.rims[rim].longitude = is_axial ? nan : at.longitude;
    state.rims[rim].half_arc = at.half_arc;
  }
  double area = 0;
  const auto ends = read.ends(0);
  state.lower_end = ends.lower;
  state.upper_end = ends.upper;
  if (on_seat) state.half_width = read.half_width(direction);
  state.force_ratio = patch.sum * windows_->unit_force() / state.force.norm();
  const Eigen::MatrixXd covered = read.covered();
  for (int j = 0; j <= solver.order(); ++j) {
    area += solver.longitude_weight(j) *
            covered.col(j).dot(solver.cells().unit.matrix());
  }
  state.area = radius_ * radius_ * area;
  // The largest pressure lies nearer to a rim than the reported distance.
  if (state.peak_pressure < state.mean_pressure()) {
    state.peak_pressure = nan;
    state.peak_place = {};
  }
  set_rims(state);
}

void SeatContact::set_rims(SeatState& state) const {
  constexpr double none = std::numeric_limits<double>::infinity();
  state.rims[0].distance =
      zone_.has_lower_rim() ? state.lower_end - zone_.from() : none;
  state.rims[1].distance =
      zone_.has_upper_rim() ? zone_.to() - state.upper_end : none;
  for (SeatRim& rim : state.rims) {
    rim.gap = radius_ * rim.distance;
    if (!(zone_.edge().radius > 0 && rim.intensity > 0)) continue;
    const RoundedRim rounded = rounded_rim(rim.intensity, zone_.edge().radius);
    rim.peak_pressure = rounded.peak_pressure;
    rim.reach = rounded.reach;
  }
}

SeatPlace seat_place(const Eigen::Vector3d& force,
                     const Eigen::Vector3d& place) {
  const Eigen::Vector3d in_plane =
      detail::plane_axes(force).transpose() * place;
  return {detail::polar_angle(place), std::atan2(in_plane.y(), in_plane.x())};
}

double SeatContact::pressure(const SeatState& state,
                             const SeatPlace& place) const {
  const double v = place.polar_angle;
  if (std::isnan(v)) return nan;
  if (state.is_free) {
    const double load = state.force.norm();
    const double direction = detail::polar_angle(state.force);
    const double angle = angle_between(v, direction, place.longitude);
    const double half_angle = contact_.half_angle(load).half_angle;
    return angle < half_angle ? contact_.pressure(angle, load, half_angle) : 0;
  }
  if (!state.solution) return nan;
  if (v < zone_.from() || v > zone_.to()) return 0;
  const detail::SeatReadout read(*state.solution->solver,
                                 state.solution->patch);
  return contact_.pair().effective_modulus() / (4 * radius_) *
         read.pressure(v, place.longitude);
}

ContactPv SeatContact::pv(const SeatState& state,
                          const Eigen::Vector3d& rate) const {
  if (!state.solution) return {};
  const double speed = rate.norm();
  const Eigen::Matrix3d axes = detail::plane_axes(state.force);
  const Eigen::Vector3d axis =
      speed > 0 ? Eigen::Vector3d(axes.transpose() * rate / speed)
                : Eigen::Vector3d::UnitZ();
  const detail::SeatReadout read(*state.solution->solver,
                                 state.solution->patch);
  const auto slip = read.slip(axis, report_distance());
  const double modulus = contact_.pair().effective_modulus();
  const double unit = modulus / (4 * radius_) * radius_ * speed;
  return {unit * radius_ * radius_ * slip.total, unit * slip.largest,
          axes * slip.place};
}

Eigen::Matrix3d SeatContact::stiffness(const SeatState& state) const {
  if (state.is_free) return free_stiffness(state.force);
  if (!state.solution) return Eigen::Matrix3d::Constant(nan);
  const detail::SeatSolution& of = *state.solution;
  const double h = 0.1 * of.solver->overlap(of.patch.shift);
  Eigen::Matrix2d k;
  for (const int axis : {0, 1}) {
    const auto force_at = [&](double steps) {
      detail::SeatPatch patch = of.patch;
      of.solver->solve(of.patch.shift + steps * h * Eigen::Vector2d::Unit(axis),
                       patch);
      return patch.force;
    };
    k.col(axis) =
        (8 * (force_at(1) - force_at(-1)) - force_at(2) + force_at(-2)) /
        (12 * h);
  }
  const double cross = (k(0, 1) + k(1, 0)) / 2;
  const Eigen::Vector2d force = of.patch.force;
  // A turn about the seat's axis turns F with D.
  const double across = force.x() > 1e-6 * force.norm()
                            ? force.x() / of.patch.shift.x()
                            : k(0, 0);
  Eigen::Matrix3d in_axes;
  in_axes << k(0, 0), 0, cross, 0, across, 0, cross, 0, k(1, 1);
  const Eigen::Matrix3d axes = detail::plane_axes(state.force);
  return windows_->unit_force() * axes * in_axes * axes.transpose();
}

Eigen::Matrix3d SeatContact::free_stiffness(
    const Eigen::Vector3d& force) const {
  const double load = force.norm();
  const double half_angle = contact_.half_angle(load).half_angle;
  const Eigen::Vector3d n = force / load;
  const Eigen::Matrix3d at_load = n * n.transpose();
  const Eigen::Matrix3d stiffness =
      contact_.approach(half_angle).stiffness * at_load +
      load / contact_.shift(load, half_angle) *
          (Eigen::Matrix3d::Identity() - at_load);
  if (!has_free_side_face()) return stiffness;
  // Small: alike for all forces that are near.
  Eigen::Matrix3d more;
  constexpr double h = 1e-3;
  for (const int axis : {0, 1, 2}) {
    const Eigen::Vector3d by = h * load * Eigen::Vector3d::Unit(axis);
    more.col(axis) = (more_shift(force + by, half_angle) -
                      more_shift(force - by, half_angle)) /
                     (2 * h * load);
  }
  const Eigen::Matrix3d sum = stiffness.inverse() + more;
  return (sum + sum.transpose()).eval().inverse() * 2;
}

RoundedRim SeatContact::rounded_rim(double intensity, double radius) const {
  const double modulus = contact_.pair().contact_modulus();
  return {0.582 * std::cbrt(intensity * intensity * modulus / radius),
          std::pow(1.880 * intensity * radius / modulus, 2.0 / 3)};
}

double SeatContact::nominal_area() const { return zone_.nominal_area(radius_); }

std::string SeatContact::note(const SeatState& state) const {
  switch (state.status) {
    case SeatStatus::ok:
      return "";
    case SeatStatus::no_load:
      return "the seat has no load";
    case SeatStatus::not_converged:
      return "the contact on the seat was not found to full accuracy";
    case SeatStatus::out_of_seat:
      break;
  }
  const bool is_cup = zone_.to() <= pi / 2;
  return detail::message(
      "the load points {:.4g} deg from the seat's axis, and the seat carries "
      "loads {} {:.4g} deg only: the ball leaves it",
      detail::polar_angle(state.force) / degree, is_cup ? "below" : "above",
      (is_cup ? zone_.to() : zone_.from()) / degree);
}

std::vector<std::string> SeatContact::notes(const SeatState& state) const {
  if (std::string why = note(state); !why.empty()) return {std::move(why)};
  std::vector<std::string> all;
  if (std::isnan(state.peak_pressure) && state.area > 0) {
    all.push_back(detail::message(
        "no largest pressure: at the reported distance of {:.3g} mm or more "
        "from the rims it is below the mean of the contact, {:.4g} MPa{}",
        radius_ * report_distance() * 1e3, state.mean_pressure() / 1e6,
        has_free_side_face() ? "" : "; see K of the rim"));
  }
  constexpr std::string_view both = "both its rims";
  const bool are_alike =
      !has_free_side_face() &&
      rim_sentence(state, 0, both) == rim_sentence(state, 1, both);
  for (const int rim : {0, 1}) {
    if (has_free_side_face()) {
      add_side_face_notes(state, rim, all);
      continue;
    }
    std::string text =
        rim_sentence(state, rim,
                     are_alike ? std::string(both)
                               : detail::message("its {} rim", rim_names[rim]));
    if (text.empty()) continue;
    if (!are_alike || rim == 0) all.push_back(std::move(text));
    add_rounding_notes(state, rim, all);
  }
  return all;
}

// The warning on a rim; "" if it has no effect.
std::string SeatContact::rim_sentence(const SeatState& state, int rim,
                                      std::string_view place) const {
  const bool is_reached = state.rims[rim].intensity > 0;
  if (!is_reached && !(state.rims[rim].distance < rim_warning_->reach(rim))) {
    return {};
  }
  return rim_warning_->sentence(
      rim, place, is_reached, detail::polar_angle(state.force),
      contact_.half_angle(state.force.norm()).half_angle);
}

// Adds notes for a rim with a side face that has an effect.
void SeatContact::add_side_face_notes(const SeatState& state, int rim,
                                      std::vector<std::string>& all) const {
  const double corner = zone_.side_angle(rim);
  const std::string taken =
      zone_.edge().angle
          ? ""
          : detail::message(", assuming {}", zone_.has_bore(rim)
                                                 ? "a bore"
                                                 : "a flat side face");
  if (state.rims[rim].half_arc > 0) {
    all.push_back(detail::message(
        "the contact is at its {} rim, a corner of {:.4g} deg{}: within {:.3g} "
        "mm of it the pressure is not reported; at the corner it {}",
        rim_names[rim], corner / degree, taken,
        radius_ * report_distance() * 1e3, at_corner(corner)));
  } else if (!zone_.edge().angle && !state.is_free &&
             state.rims[rim].distance < rim_warning_->reach(rim)) {
    all.push_back(detail::message(
        "the contact ends beside its {} rim, and its side face has an effect: "
        "a corner of {:.4g} deg{}; edge_angle of the [seat] sets another angle",
        rim_names[rim], corner / degree, taken));
  }
}

void SeatContact::add_rounding_notes(const SeatState& state, int rim,
                                     std::vector<std::string>& all) const {
  const SeatRim& of = state.rims[rim];
  if (std::isnan(of.peak_pressure)) return;
  for (const auto& note : contact_.limits().notes({0, of.peak_pressure})) {
    all.push_back(detail::message("on the rounding of its {} rim: {}",
                                  rim_names[rim], note));
  }
  constexpr double millimetre = 1e-3;
  // The formula assumes a half-space and an edge that is a small part of the
  // contact.
  constexpr double largest_share = 0.1;
  const double width = radius_ * (state.upper_end - state.lower_end);
  if (of.reach <= largest_share * std::min(width, surface_layer_)) return;
  all.push_back(detail::message(
      "the contact extends {:.3g} mm over the rounding of its {} rim, more "
      "than a tenth of {:.3g} mm, {}: the pressure there holds only for a much "
      "smaller rounding",
      of.reach / millimetre, rim_names[rim],
      std::min(width, surface_layer_) / millimetre,
      surface_layer_ < width ? "the surface layer" : "its width"));
}

}  // namespace contact
