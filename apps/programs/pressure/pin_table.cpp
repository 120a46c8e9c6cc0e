#include "programs/pressure/pin_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/quantities/finite_pin.hpp"

namespace hinge_pressure {
namespace {

using contact::Joint;
using contact::JointSolution;
using Eigen::Vector3d;

// The i-th of some numbers with even steps.
double step(double from, double to, int i, int count) {
  return from + (to - from) * i / (count - 1);
}

// Angle from the load beyond which nothing touches, rad, to 1e-6: slices are
// pressed where the pin's axis has gone.
double edge_of(const Joint& joint, const JointSolution& s, double half) {
  const auto lie = joint.lie(s);
  if (!lie) return 0;
  const double rho = joint.contact().geometry().radius();
  constexpr int count = 201;
  double edge = 0;
  for (int i = 0; i < count; ++i) {
    const double z = step(-half, half, i, count);
    const Vector3d to = lie->shift + z * lie->tilt;
    const double middle = std::abs(std::atan2(to.y(), to.x()));
    const auto touches = [&](double theta) {
      const double at = std::copysign(middle + theta, to.y());
      const Vector3d place(std::cos(at), std::sin(at), z / rho);
      return joint.pressures(s, {&place, 1})[0] > 0;
    };
    double inside = 0;
    double outside = lie->largest_half_angle;
    if (!touches(inside)) continue;
    while (outside - inside > 1e-6) {
      const double between = (inside + outside) / 2;
      (touches(between) ? inside : outside) = between;
    }
    edge = std::max(edge, middle + outside);
  }
  return std::min(edge, std::numbers::pi);
}

void write_map(const Joint& joint, const JointSolution& s, int points,
               const std::function<void()>& begin, cli::RowWriter& row) {
  const contact::JointGeometry& geometry = joint.contact().geometry();
  const double half = geometry.length() / 2;
  const double edge = edge_of(joint, s, half);
  std::vector<Vector3d> places;
  for (int i = 0; i < points; ++i) {
    const double z = step(-half, half, i, points);
    for (int j = 0; j < points; ++j) {
      const double theta = step(-edge, edge, j, points);
      places.emplace_back(std::cos(theta), std::sin(theta),
                          z / geometry.radius());
    }
  }
  const std::vector<double> pressures = joint.pressures(s, places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    begin();
    row.number(step(-edge, edge, static_cast<int>(i) % points, points) /
               contact::degree);
    row.number(step(-half, half, static_cast<int>(i) / points, points));
    row.number(pressures[i]);
    row.end();
  }
}

// Friction has no part in it.
std::vector<std::string_view> keys() {
  std::vector<std::string_view> all;
  for (const auto& q : contact::lie_quantities()) {
    if (q.key == "moment" || q.key == "axial_friction_force") continue;
    if (q.key == "peak_place") all.emplace_back("peak_pressure");
    all.push_back(q.key);
  }
  return all;
}

}  // namespace

cli::ExitStatus run_tilted(const Options& options) {
  cli::TiltedTable table{.program = "hinge-pressure",
                         .loads = options.load.load,
                         .columns = keys()};
  if (const int points = options.points; points > 0) {
    table.columns = {"theta_deg", "z_m", "p_Pa"};
    table.write = [points](const Joint& joint, const JointSolution& s,
                           const std::function<void()>& begin,
                           cli::RowWriter& row) {
      write_map(joint, s, points, begin, row);
    };
  }
  return write_tilted(make_joints(options.joint), options.tilt, table,
                      options.output);
}

}  // namespace hinge_pressure
