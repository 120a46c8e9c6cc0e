#include "programs/pressure/placed_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "cli/joint/joint_reports.hpp"
#include "cli/joint/placed_table.hpp"
#include "cli/plot.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/quantities/finite_pin.hpp"

namespace hinge_pressure {
namespace {

using contact::Joint;
using contact::JointSolution;
using Eigen::Vector3d;

constexpr int picture_points = 201;

// Number i of `count` evenly spaced values.
double step(double from, double to, int i, int count) {
  return from + (to - from) * i / (count - 1);
}

// Angle from the load to the edge of the contact, rad, to 1e-6. Slices are
// pressed in the direction of the pin's displacement.
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

void write_pin(const Joint& joint, const JointSolution& s, int points,
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

// Polar angles between the rims, as near to them as peak pressures are
// searched.
std::pair<double, double> reported_angles(const Joint& joint) {
  const contact::SeatZone& zone = *joint.contact().geometry().drawn_seat();
  const double near = zone.edge().report_distance;
  return {zone.from() + (zone.has_lower_rim() ? near : 0),
          zone.to() - (zone.has_upper_rim() ? near : 0)};
}

void write_seat(const Joint& joint, const JointSolution& s, int points,
                const std::function<void()>& begin, cli::RowWriter& row) {
  const auto [from, to] = reported_angles(joint);
  const auto polar = [&](int i) { return step(from, to, i, points); };
  const auto turn = [&](int j) { return step(0, std::numbers::pi, j, points); };
  std::vector<Vector3d> places;
  for (int i = 0; i < points; ++i) {
    for (int j = 0; j < points; ++j) {
      const double v = polar(i), phi = turn(j);
      places.emplace_back(std::sin(v) * std::cos(phi),
                          std::sin(v) * std::sin(phi), std::cos(v));
    }
  }
  const std::vector<double> pressures = joint.pressures(s, places);
  for (std::size_t k = 0; k < places.size(); ++k) {
    begin();
    row.number(polar(static_cast<int>(k) / points) / contact::degree);
    row.number(turn(static_cast<int>(k) % points) / contact::degree);
    row.number(pressures[k]);
    row.end();
  }
}

// The curve ends where the contact does.
cli::Curve curve_at(const cli::PlacedState& state, std::vector<double> x,
                    const std::vector<Vector3d>& places) {
  const std::vector<double> pressures =
      state.joint.pressures(state.solution, places);
  std::vector<double> shown = pressures;
  const auto is_outside = [&](std::size_t i) {
    return i >= pressures.size() || pressures[i] == 0;  // 0 - 1 wraps
  };
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (is_outside(i - 1) && is_outside(i) && is_outside(i + 1)) shown[i] = NAN;
  }
  return {"", std::move(x), std::move(shown)};
}

// In the plane of the load from rim to rim; for a cup through its middle.
cli::Curve curve_in_seat(const cli::PlacedState& state) {
  const auto [first, to] = reported_angles(state.joint);
  const double from = first > 0 ? first : -to;
  std::vector<double> x;
  std::vector<Vector3d> places;
  for (int i = 0; i < picture_points; ++i) {
    const double v = step(from, to, i, picture_points);
    x.push_back(v / contact::degree);
    places.emplace_back(std::sin(v), 0, std::cos(v));
  }
  return curve_at(state, std::move(x), places);
}

// Along the pin: the largest pressure at each place.
cli::Curve curve_of_pin(const cli::PlacedState& state) {
  const contact::JointGeometry& geometry = state.joint.contact().geometry();
  const double half = geometry.length() / 2;
  std::vector<double> x;
  std::vector<Vector3d> places;
  for (int i = 0; i < picture_points; ++i) {
    const double z = step(-half, half, i, picture_points);
    const Vector3d to = state.lie
                            ? Vector3d(state.lie->shift + z * state.lie->tilt)
                            : Vector3d::UnitX();
    const double theta = std::atan2(to.y(), to.x());
    x.push_back(z);
    places.emplace_back(std::cos(theta), std::sin(theta),
                        z / geometry.radius());
  }
  return curve_at(state, std::move(x), places);
}

// These columns do not depend on friction.
void add_pin_columns(std::vector<cli::PlacedColumn>& to) {
  for (const auto& q : contact::lie_quantities()) {
    if (q.key == "moment" || q.key == "axial_friction_force") continue;
    if (q.key == "peak_place") cli::add_solution_column("peak_pressure", to);
    cli::add_lie_column(q.key, to);
  }
}

void add_columns_in_seat(std::vector<cli::PlacedColumn>& to) {
  const auto area = [](const cli::PlacedState& s) {
    return s.joint.contact().geometry().nominal_area();
  };
  to.push_back({"nominal_area_m2", area});
  to.push_back({"p_nominal_Pa", [area](const cli::PlacedState& s) {
                  return s.load / area(s);
                }});
  cli::add_seat_columns(to);
}

}  // namespace

cli::ExitStatus run_placed(const Options& options) {
  const bool in_seat = !options.direction.empty();
  cli::PlacedTable table{.program = "hinge-pressure",
                         .loads = options.load.load,
                         .tilt = options.tilt,
                         .direction = options.direction};
  if (in_seat) {
    add_columns_in_seat(table.columns);
  } else {
    add_pin_columns(table.columns);
  }
  if (const int points = options.points; points > 0) {
    table.map_columns = {"theta_deg", "z_m", "p_Pa"};
    if (in_seat) table.map_columns = {"v_deg", "phi_deg", "p_Pa"};
    table.write_map = [points, write = in_seat ? write_seat : write_pin](
                          const cli::PlacedState& s,
                          const std::function<void()>& begin,
                          cli::RowWriter& row) {
      write(s.joint, s.solution, points, begin, row);
    };
  }
  const std::vector<cli::Joint> joints = make_joints(options.joint);
  const std::string& picture = options.output.plot;
  cli::LinePlot plot;
  if (!picture.empty()) {
    plot.title = shared_title(joints, "");
    plot.x = in_seat ? cli::Axis{"angle from the seat's axis", "deg"}
                     : cli::Axis{"place along the pin", "m"};
    plot.y = {"pressure", "Pa"};
    plot.family = true;
    table.show = [&plot, curve = in_seat ? curve_in_seat : curve_of_pin](
                     const cli::PlacedState& state, const std::string& label) {
      plot.curves.push_back(curve(state));
      plot.curves.back().label = label;
    };
  }
  const cli::ExitStatus status = write_placed(joints, table, options.output);
  if (picture.empty()) return status;
  return cli::drawn("hinge-pressure", draw(plot, picture), status);
}

}  // namespace hinge_pressure
