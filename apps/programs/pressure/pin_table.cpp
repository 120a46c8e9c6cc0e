#include "programs/pressure/pin_table.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/quantities/finite_pin.hpp"

namespace hinge_pressure {
namespace {

using contact::FinitePin;
using contact::FinitePinSolution;
using contact::FinitePinState;
using Begin = std::function<void()>;

// The i-th of some numbers with even steps.
double step(double from, double to, int i, int count) {
  return from + (to - from) * i / (count - 1);
}

// Angle from the load beyond which nothing touches, rad.
double edge_of(const FinitePin& pin, const FinitePinState& state, double half) {
  constexpr int count = 201;
  double edge = 0;
  for (int i = 0; i < count; ++i) {
    const auto s = pin.slice(state, step(-half, half, i, count));
    if (!(s.force > 0)) continue;
    const double middle = std::atan2(s.direction.y(), s.direction.x());
    edge = std::max(edge, std::abs(middle) + s.half_angle);
  }
  return std::min(edge, std::numbers::pi);
}

void write_map(const FinitePin& pin, const FinitePinState& state, int points,
               const Begin& begin, cli::RowWriter& row) {
  const double half = pin.force_law().geometry().length() / 2;
  const double edge = edge_of(pin, state, half);
  for (int i = 0; i < points; ++i) {
    const double z = step(-half, half, i, points);
    for (int j = 0; j < points; ++j) {
      const double theta = step(-edge, edge, j, points);
      begin();
      row.number(theta / contact::degree);
      row.number(z);
      row.number(pin.pressure(state, z, theta));
      row.end();
    }
  }
}

}  // namespace

cli::ExitStatus run_tilted(const Options& options) {
  cli::TiltedTable table{.program = "hinge-pressure",
                         .load_flag = "--load",
                         .load_column = "load_N",
                         .loads = options.load.load,
                         .motion = {},
                         .columns = {}};
  if (const int points = options.points; points > 0) {
    table.columns = {{"theta_deg", {}}, {"z_m", {}}, {"p_Pa", {}}};
    table.write = [points](const FinitePin& pin, const FinitePinSolution& s,
                           const Begin& begin, cli::RowWriter& row) {
      write_map(pin, s.contact, points, begin, row);
    };
  } else {
    // Friction has no part in it.
    std::vector<std::string_view> keys;
    for (const auto& q : contact::finite_pin_quantities()) {
      if (q.is_word() || q.key == "moment") continue;
      if (q.key != "axial_friction_force") keys.push_back(q.key);
    }
    table.columns = cli::pin_columns(keys);
  }
  return write_tilted(make_joints(options.joint), options.tilt, table,
                      options.output);
}

}  // namespace hinge_pressure
