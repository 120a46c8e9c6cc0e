#include "libcontact/seat/contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libcontact/base/check.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/seat/readout.hpp"
#include "libcontact/seat/windows.hpp"

namespace contact {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

JointContact exact_contact(JointSpec joint) {
  if (joint.geometry.kind() != JointKind::ball) {
    throw Error(detail::needs("a seat that ends", "a ball"));
  }
  if (joint.loading.is_back()) {
    throw Error(detail::needs("a seat that ends", "loading = centre"));
  }
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

// Axes whose x is that of the force's component across the seat's axis.
Eigen::Matrix3d plane_axes(const Eigen::Vector3d& force) {
  const double across = std::hypot(force.x(), force.y());
  const double c = across > 0 ? force.x() / across : 1;
  const double s = across > 0 ? force.y() / across : 0;
  Eigen::Matrix3d axes;
  axes << c, -s, 0, s, c, 0, 0, 0, 1;
  return axes;
}

Eigen::Vector2d in_plane(const Eigen::Vector3d& force) {
  return {std::hypot(force.x(), force.y()), force.z()};
}

double polar_angle(const Eigen::Vector3d& force) {
  return std::atan2(std::hypot(force.x(), force.y()), force.z());
}

}  // namespace

SeatContact::SeatContact(const JointSpec& joint, const SeatZone& zone,
                         const Grid& grid)
    : radius_(joint.geometry.radius()),
      contact_(exact_contact(joint)),
      zone_(zone),
      report_distance_(grid.report_distance) {
  detail::require(grid.cells >= 8 && grid.cells <= 200, "seat", "cells",
                  grid.cells, "8 to 200");
  detail::require(grid.longitudes >= 16 && grid.longitudes <= 720, "seat",
                  "longitudes", grid.longitudes, "16 to 720");
  detail::require(grid.report_distance > 0 && grid.report_distance < 1, "seat",
                  "report_distance", grid.report_distance,
                  "above 0 and below 1 radius");
  windows_ = std::make_unique<const detail::SeatWindows>(
      pair_of(joint), zone, grid.cells, grid.longitudes,
      joint.geometry.radial_clearance());
}

SeatContact::~SeatContact() = default;

SeatState SeatContact::under(const Eigen::Vector3d& force) const {
  return under(force, {});
}

SeatState SeatContact::under(const Eigen::Vector3d& force,
                             const SeatState& near) const {
  SeatState state;
  state.force = force;
  const double load = force.norm();
  if (!(load > 0 && std::isfinite(load))) return state;
  const double direction = polar_angle(force);
  const HalfAngleResult half_angle = contact_.half_angle(load);
  state.is_free = half_angle.status == Status::ok &&
                  zone_.margin(direction, half_angle.half_angle) >= 0;
  if (state.is_free) {
    set_free(half_angle.half_angle, direction, state);
    return state;
  }
  if (!zone_.carries(direction)) {
    state.status = SeatStatus::out_of_seat;
    return state;
  }
  auto solution = near.solution
                      ? std::make_shared<detail::SeatSolution>(*near.solution)
                      : std::make_shared<detail::SeatSolution>();
  const bool converged = windows_->balance(in_plane(force), *solution);
  state.status = converged ? SeatStatus::ok : SeatStatus::not_converged;
  state.solution = std::move(solution);
  set_confined(direction, state);
  return state;
}

void SeatContact::set_free(double half_angle, double direction,
                           SeatState& state) const {
  const double load = state.force.norm();
  state.status = SeatStatus::ok;
  state.shift = contact_.shift(load, half_angle) / load * state.force;
  state.pressure_at_load = contact_.pressure(0, load, half_angle);
  state.peak_pressure = contact_.peak_pressure(load, half_angle);
  state.peak_place = {direction, 0};
  state.lower_end = std::max(0.0, direction - half_angle);
  state.upper_end = std::min(pi, direction + half_angle);
  state.force_ratio = contact_.sum_of_pressures(load, half_angle) / load;
  state.area = contact_.area(half_angle);
  set_rims(state);
}

void SeatContact::set_confined(double direction, SeatState& state) const {
  const detail::SeatPatchSolver& solver = *state.solution->solver;
  const detail::SeatPatch& patch = state.solution->patch;
  const double modulus = contact_.pair().effective_modulus();
  const double unit = modulus / (4 * radius_);  // of pressures
  const detail::SeatReadout read(solver, patch);
  const bool is_axial = in_plane(state.force).x() == 0;
  state.shift = plane_axes(state.force) *
                Eigen::Vector3d(patch.shift.x(), 0, patch.shift.y());
  const bool on_seat = direction >= zone_.from() && direction <= zone_.to();
  state.pressure_at_load = on_seat ? unit * read.pressure(direction, 0) : nan;
  const auto peak = read.peak(report_distance_);
  state.peak_pressure = unit * peak.pressure;
  state.peak_place = {peak.polar_angle, is_axial ? nan : peak.longitude};
  for (const int rim : {0, 1}) {
    const auto at = read.rim(rim);
    state.rims[rim].intensity =
        at.strength * unit * std::sqrt(2 * pi * radius_);
    state.rims[rim].longitude = is_axial ? nan : at.longitude;
    state.rims[rim].half_arc = at.half_arc;
  }
  const auto ends = read.ends(0);
  state.lower_end = ends.lower;
  state.upper_end = ends.upper;
  state.force_ratio = patch.sum * windows_->unit_force() / state.force.norm();
  state.area = radius_ * radius_ * read.area();
  set_rims(state);
}

void SeatContact::set_rims(SeatState& state) const {
  if (zone_.has_lower_rim()) {
    state.rims[0].distance = state.lower_end - zone_.from();
  }
  if (zone_.has_upper_rim()) {
    state.rims[1].distance = zone_.to() - state.upper_end;
  }
}

Eigen::Matrix3d SeatContact::stiffness(const SeatState& state) const {
  const Eigen::Vector3d n = state.force.normalized();
  if (state.is_free) {
    const double load = state.force.norm();
    const double along =
        contact_.approach(contact_.half_angle(load).half_angle).stiffness;
    const Eigen::Matrix3d at_load = n * n.transpose();
    return along * at_load +
           load / state.shift.norm() * (Eigen::Matrix3d::Identity() - at_load);
  }
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
  const Eigen::Matrix3d axes = plane_axes(state.force);
  return windows_->unit_force() * axes * in_axes * axes.transpose();
}

RoundedRim SeatContact::rounded_rim(double intensity, double radius) const {
  const double modulus = contact_.pair().contact_modulus();
  return {0.582 * std::cbrt(intensity * intensity * modulus / radius),
          std::pow(1.880 * intensity * radius / modulus, 2.0 / 3)};
}

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
      polar_angle(state.force) / degree, is_cup ? "below" : "above",
      (is_cup ? zone_.to() : zone_.from()) / degree);
}

}  // namespace contact
