#include "programs/separation/output/compare.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "cli/stream/report.hpp"
#include "libcontact/base/units.hpp"
#include "separation/results/quantities.hpp"

namespace separation {
namespace {

using contact::degree;

// A value of one body in one run; NaN if there is none.
struct Quantity {
  std::string name;
  std::function<double(const Outcome&, int body)> value;
};

// Value in the first row in which no lock holds the body (NaN if there is
// none), or in the last row.
double number_in_row(const Case& c, const Outcome& o, int body,
                     const char* quantity, bool first) {
  const Rows& rows = o.memory.rows;
  const std::string name = column_name(c.bodies[body].rigid.name);
  const std::size_t column = rows.column(name + quantity);
  if (!first) return rows.at(rows.size() - 1, column);
  const std::size_t mode = rows.column(name + ".mode");
  constexpr auto locked = static_cast<double>(multibody::HingeMode::locked);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (rows.at(row, mode) != locked) return rows.at(row, column);
  }
  return NAN;
}

// @param of  the body
std::vector<Quantity> quantities(const Case& c, int of) {
  const auto record = [](const Outcome& o, int body) -> const BodyRecord& {
    return o.memory.bodies[body];
  };
  const auto peak = [record](double JointPeaks::*what) {
    return [record, what](const Outcome& o, int body) {
      double largest = o.friction == FrictionChoice::ideal ? NAN : 0;
      for (const JointPeaks& joint : record(o, body).joints) {
        largest = std::max(largest, joint.*what);
      }
      return largest;
    };
  };
  using Release = BodyRecord::Release;
  const auto at_release = [record](double Release::*what, double unit) {
    return [=](const Outcome& o, int body) {
      const Release& release = record(o, body).release;
      return release.time == History::not_yet ? NAN : release.*what / unit;
    };
  };
  std::vector<Quantity> all = {
      {"acceleration_at_start_deg_per_s2",
       [&c](const Outcome& o, int body) {
         return number_in_row(c, o, body, ".acceleration_deg_per_s2", true);
       }},
      {"friction_moment_at_start_N_m",
       [&c](const Outcome& o, int body) {
         return number_in_row(c, o, body, ".friction_moment_N_m", true);
       }},
      {"release_s", at_release(&Release::time, 1)},
      {"angle_at_release_deg", at_release(&Release::angle, degree)},
      {"rate_at_release_deg_per_s", at_release(&Release::rate, degree)},
      {"angle_at_end_deg",
       [&c](const Outcome& o, int body) {
         return number_in_row(c, o, body, ".angle_deg", false);
       }},
      {"rate_at_end_deg_per_s",
       [&c](const Outcome& o, int body) {
         return number_in_row(c, o, body, ".rate_deg_per_s", false);
       }},
      {"work_of_friction_J",
       [=](const Outcome& o, int body) { return record(o, body).work; }},
      {"peak_reaction_N",
       [=](const Outcome& o, int body) {
         return record(o, body).peak_reaction;
       }},
      {"largest_friction_moment_of_joint_N_m", peak(&JointPeaks::moment)},
      {"peak_pressure_Pa", peak(&JointPeaks::pressure)},
      {"largest_theta0_deg",
       [half_angle = peak(&JointPeaks::half_angle)](const Outcome& o,
                                                    int body) {
         return half_angle(o, body) / degree;
       }},
  };
  const auto add = [&](std::span<const contact::Quantity<BodyRecord>> more) {
    for (const auto& q : more) {
      all.push_back({summary_name(q), [record, &q](const Outcome& o, int body) {
                       return summary_unit(q.dimension)
                           .from_si(number_of(q, record(o, body)));
                     }});
    }
  };
  if (!c.bodies[of].hinge.stops.empty()) add(stop_quantities());
  if (c.has_latch(of)) add(latch_quantities());
  return all;
}

}  // namespace

void write_comparison(const Case& c, const std::vector<Outcome>& outcomes,
                      const cli::OutputOptions& options) {
  std::vector<std::string> columns = {"body", "quantity"};
  std::vector<std::string> frictions;
  for (const Outcome& outcome : outcomes) {
    frictions.emplace_back(to_string(outcome.friction));
  }
  columns.insert(columns.end(), frictions.begin(), frictions.end());
  cli::Output output(options.output);
  const cli::TableStyle style = options.titled(c.name).of_quantity(frictions);
  cli::write_table(style, columns, output, [&](cli::RowWriter& row) {
    for (int body = 0; body < static_cast<int>(c.bodies.size()); ++body) {
      if (c.bodies[body].hinge.kind == multibody::HingeKind::none) continue;
      for (const Quantity& quantity : quantities(c, body)) {
        row.text(c.bodies[body].rigid.name);
        row.text(quantity.name);
        for (const Outcome& outcome : outcomes) {
          row.number(quantity.value(outcome, body));
        }
        row.end();
      }
    }
  });
  output.commit();
}

}  // namespace separation
