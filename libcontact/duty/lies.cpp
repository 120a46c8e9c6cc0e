#include "libcontact/duty/lies.hpp"

#include <memory>

#include "libcontact/duty/periodic_spline.hpp"

namespace contact {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Placement tilted_by(const Vector2d& tilt) {
  Placement placement;
  placement.tilt.head<2>() = tilt;
  return placement;
}

Placement placed_at(double place) {
  Placement placement;
  placement.place = place;
  return placement;
}

}  // namespace

Lies loaded_at(double place) {
  return [place](const DutyCycle::State& /*state*/, double /*time*/) {
    return placed_at(place);
  };
}

Lies tilted_with_load(const Vector2d& tilt) {
  return [tilt](const DutyCycle::State& state, double /*time*/) {
    const Vector2d force = state.reaction.head<2>();
    if (force.isZero(0)) return tilted_by(tilt);
    const Vector2d x = force.stableNormalized();
    return tilted_by(tilt.x() * x + tilt.y() * Vector2d(-x.y(), x.x()));
  };
}

Lies tilted_at(const std::vector<double>& times, double period,
               const std::vector<Vector2d>& tilts) {
  std::vector<Vector3d> values;
  for (const Vector2d& tilt : tilts) values.emplace_back(tilt.x(), tilt.y(), 0);
  const auto spline =
      std::make_shared<const PeriodicSpline>(times, period, values);
  return [spline](const DutyCycle::State& /*state*/, double time) {
    return tilted_by(spline->value(time).head<2>());
  };
}

Lies loaded_at(const std::vector<double>& times, double period,
               const std::vector<double>& places) {
  std::vector<Vector3d> values;
  for (const double place : places) values.emplace_back(place, 0, 0);
  const auto spline =
      std::make_shared<const PeriodicSpline>(times, period, values);
  return [spline](const DutyCycle::State& /*state*/, double time) {
    return placed_at(spline->value(time).x());
  };
}

}  // namespace contact
