#include "programs/duty/tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "libcontact/base/units.hpp"
#include "programs/duty/worn_quantities.hpp"

namespace hinge_duty {
namespace {

using Instant = contact::JointCycle::Instant;
using contact::degree;
using contact::SlidingContact;
using Eigen::Vector3d;

// Writes a table whose rows `write` makes.
template <class Rows>
void write_table(cli::TableStyle style, const std::vector<std::string>& columns,
                 cli::Output& output, const Rows& write) {
  style.columns.clear();
  const cli::Table table(style, columns);
  cli::Text text;
  cli::RowWriter to(table, text);
  write(to);
  cli::TableWriter writer(output, table);
  writer.write(text.view());
  writer.finish();
}

struct StateColumn {
  std::string name;
  std::function<double(const Instant&, const SlidingContact&)> of;
};

std::vector<StateColumn> state_columns() {
  std::vector<StateColumn> all;
  using Number = double (*)(const Instant&, const SlidingContact&);
  const auto number = [&](const char* name, Number of) {
    all.push_back({name, of});
  };
  using Vector = const Vector3d& (*)(const Instant&);
  const auto vector = [&](const std::string& name, const std::string& unit,
                          Vector of) {
    for (const int k : {0, 1, 2}) {
      all.push_back({fmt::format("{}_{}{}", name, "xyz"[k], unit),
                     [of, k](const auto& i, auto&) {
                       return of(i)[k] + 0.0;  // no -0
                     }});
    }
  };
  using I = const Instant&;
  using S = const SlidingContact&;
  number("time_s", [](I i, S) { return i.time; });
  vector("R", "_N", [](I i) -> const Vector3d& { return i.state.reaction; });
  vector("w", "_rad_per_s",
         [](I i) -> const Vector3d& { return i.state.angular_velocity; });
  number("R_n_N", [](I i, S) { return i.solution.normal_force; });
  vector("n", "", [](I i) -> const Vector3d& { return i.solution.normal; });
  number("theta0_deg", [](I i, S) { return i.solution.half_angle / degree; });
  number("g_deg", [](I i, S) { return i.solution.friction_angle() / degree; });
  number("a_deg", [](I i, S) { return i.solution.slip_axis_angle() / degree; });
  vector("M_t", "_N_m",
         [](I i) -> const Vector3d& { return i.solution.friction_moment; });
  number("heat_W", [](I, S s) { return s.heat(); });
  number("p_peak_Pa", [](I i, S) { return i.solution.peak_pressure; });
  number("pv_max_W_per_m2", [](I, S s) { return s.largest_pv().value; });
  number("pv_max_theta_deg",
         [](I, S s) { return s.largest_pv().theta / degree; });
  number("q_max_W_per_m2", [](I, S s) { return s.largest_heat_flux().value; });
  number("pv_total_W", [](I, S s) { return s.pv_total(); });
  number("pv_nominal_W_per_m2", [](I, S s) { return s.pv_nominal(); });
  return all;
}

template <class Columns>
std::vector<std::string> names_of(const Columns& columns) {
  std::vector<std::string> names;
  for (const auto& column : columns) names.emplace_back(column.name);
  return names;
}

}  // namespace

void write_blocks(const std::vector<contact::WearIn::State>& worn,
                  cli::Output& output, cli::TableStyle style) {
  write_table(std::move(style), names_of(worn_quantities), output,
              [&](cli::RowWriter& to) {
                for (const contact::WearIn::State& state : worn) {
                  for (const WornQuantity& q : worn_quantities) {
                    to.number(q.of(state));
                  }
                  to.end();
                }
              });
}

void write_states(const contact::JointCycle& cycle, cli::Output& output,
                  cli::TableStyle style) {
  const auto columns = state_columns();
  write_table(std::move(style), names_of(columns), output,
              [&](cli::RowWriter& to) {
                for (const Instant& i : cycle.rows()) {
                  const SlidingContact sliding = cycle.sliding(i);
                  for (const StateColumn& column : columns) {
                    to.number(column.of(i, sliding));
                  }
                  to.end();
                }
              });
}

void write_map(const std::vector<BodyWear>& wear, bool is_pin,
               cli::Output& output, cli::TableStyle style) {
  std::vector<std::string> columns = {"body", "beta_deg"};
  if (!is_pin) columns = {"body", "x", "y", "z"};
  columns.insert(columns.end(),
                 {"pv_integral_Pa_m", "depth_mm", "cross_shear"});
  write_table(std::move(style), columns, output, [&](cli::RowWriter& to) {
    for (const BodyWear& w : wear) {
      for (std::size_t i = 0; i < w.points.size(); ++i) {
        if (w.wear[i].pv == 0) continue;
        const Vector3d& point = w.points[i];
        to.text(w.body);
        if (is_pin) {
          to.number(std::atan2(point.y(), point.x()) / degree);
        } else {
          for (const double x : point) to.number(x);
        }
        to.number(w.wear[i].pv);
        to.number(w.depth(w.wear[i]));
        to.number(w.wear[i].cross_shear);
        to.end();
      }
    }
  });
}

}  // namespace hinge_duty
