#include "libcontact/seat/contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libcontact/base/check.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/seat/patch.hpp"
#include "libcontact/seat/readout.hpp"

namespace contact {

// In the plane of the force, x to its side, and units of detail::SeatPatch.
struct detail::SeatSolution {
  std::shared_ptr<const SeatPatchSolver> solver;
  SeatPatch patch;
};

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
  return {joint.geometry.radius(), joint.inner, joint.outer};
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
    : pair_(pair_of(joint)),
      contact_(exact_contact(joint)),
      zone_(zone),
      grid_(grid) {
  detail::require(grid.cells >= 8 && grid.cells <= 200, "seat", "cells",
                  grid.cells, "8 to 200");
  detail::require(grid.longitudes >= 16 && grid.longitudes <= 720, "seat",
                  "longitudes", grid.longitudes, "16 to 720");
  detail::require(grid.report_distance > 0 && grid.report_distance < 1, "seat",
                  "report_distance", grid.report_distance,
                  "above 0 and below 1 radius");
  detail::require(
      pair_.relative_thickness() >= smallest_relative_thickness, "seat",
      "thickness of the surface layer",
      pair_.relative_thickness() * pair_.radius(),
      detail::message("at least 0.001 radii ({:.4g} m)",
                      smallest_relative_thickness * pair_.radius()));
}

SeatContact::~SeatContact() = default;

// A grid over the share 2^(-step/2) of the zone from one of its ends; step 0:
// over all of it.
SeatContact::Solver SeatContact::solver(int end, int step) const {
  if (step == 0) end = 0;
  const std::lock_guard lock(making_);
  Solver& one = solvers_[{end, step}];
  if (!one) {
    detail::SeatWindow window(zone_);
    const double width = zone_.width() * std::exp2(-step / 2.0);
    if (step > 0 && end == 0) window.to = window.from + width;
    if (step > 0 && end == 1) window.from = window.to - width;
    if (step > 0) window.rim[1 - end] = false;
    one = std::make_shared<const detail::SeatPatchSolver>(
        pair_, window, grid_.cells, grid_.longitudes,
        contact_.geometry().radial_clearance());
  }
  return one;
}

namespace {

// How many times 2^(-1/2) a window may be narrower: it has a quarter of its
// width to spare beyond the contact, which is at one of its ends.
std::pair<int, int> narrower(const detail::SeatSolution& of) {
  const detail::SeatCells& cells = of.solver->cells();
  const auto in_contact = (of.patch.contact.rowwise().sum() > 0).eval();
  const bool lower = in_contact(0) && cells.window.rim[0];
  const bool upper = in_contact(cells.size() - 1) && cells.window.rim[1];
  if (lower == upper) return {0, 0};
  double wide = 0;
  for (int i = 0; i < cells.size(); ++i) {
    if (!in_contact(i)) continue;
    wide = std::max(wide, lower ? cells.bound(i + 1) - cells.window.from
                                : cells.window.to - cells.bound(i));
  }
  constexpr double spare = 4.0 / 3;
  const double share = spare * wide / cells.window.width();
  const int step = static_cast<int>(std::floor(-2 * std::log2(share)));
  return {lower ? 0 : 1, std::clamp(step, 0, 16)};
}

bool reaches_artificial_end(const detail::SeatSolution& of) {
  const detail::SeatCells& cells = of.solver->cells();
  const auto& contact = of.patch.contact;
  return (!cells.window.rim[0] && cells.window.from > 0 &&
          (contact.row(0) > 0).any()) ||
         (!cells.window.rim[1] && cells.window.to < pi &&
          (contact.row(cells.size() - 1) > 0).any());
}

}  // namespace

bool SeatContact::solve(const Eigen::Vector3d& force,
                        detail::SeatSolution& to) const {
  const double unit = contact_.pair().effective_modulus() * pair_.radius() / 4;
  const Eigen::Vector2d goal = in_plane(force) / unit;
  if (!to.solver) {
    to.solver = solver(0, 0);
    // Deep enough to touch: an overlap of the size that the load makes.
    const double direction = polar_angle(force);
    const double eps = contact_.geometry().radial_clearance();
    const double deep = std::max(0.3 * std::abs(eps), goal.norm() / 4);
    const double slope = std::cos(direction - zone_.nearest(direction));
    to.patch.shift = (std::max(eps, 0.0) + deep) / slope * goal.normalized();
  }
  to.solver->balance(goal, to.patch);
  const auto [end, finer] = narrower(to);
  if (!to.patch.converged || finer == 0) return to.patch.converged;
  for (int step = finer; step >= 0; --step) {
    to.solver = solver(end, step);
    to.patch = detail::SeatPatch(to.patch.shift);
    to.solver->balance(goal, to.patch);
    if (to.patch.converged && !reaches_artificial_end(to)) return true;
  }
  return false;
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
  const bool converged = solve(force, *solution);
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
  const double radius = pair_.radius();
  const double modulus = contact_.pair().effective_modulus();
  const double unit = modulus / (4 * radius);  // of pressures
  const detail::SeatReadout read(solver, patch);
  const bool is_axial = in_plane(state.force).x() == 0;
  state.shift = plane_axes(state.force) *
                Eigen::Vector3d(patch.shift.x(), 0, patch.shift.y());
  const bool on_seat = direction >= zone_.from() && direction <= zone_.to();
  state.pressure_at_load = on_seat ? unit * read.pressure(direction, 0) : nan;
  const auto peak = read.peak(grid_.report_distance);
  state.peak_pressure = unit * peak.pressure;
  state.peak_place = {peak.polar_angle, is_axial ? nan : peak.longitude};
  for (const int rim : {0, 1}) {
    const auto at = read.rim(rim);
    state.rims[rim].intensity = at.strength * unit * std::sqrt(2 * pi * radius);
    state.rims[rim].longitude = is_axial ? nan : at.longitude;
    state.rims[rim].half_arc = at.half_arc;
  }
  const auto ends = read.ends(0);
  state.lower_end = ends.lower;
  state.upper_end = ends.upper;
  state.force_ratio = patch.sum * modulus * radius / 4 / state.force.norm();
  state.area = radius * radius * read.area();
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
  const double unit = contact_.pair().effective_modulus() * pair_.radius() / 4;
  return unit * axes * in_axes * axes.transpose();
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
