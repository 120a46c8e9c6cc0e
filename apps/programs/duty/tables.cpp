#include "programs/duty/tables.hpp"

#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>
#include <utility>

#include "cli/stream/report.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/quantities/finite_pin.hpp"
#include "libcontact/quantities/seat.hpp"
#include "libcontact/quantities/tables.hpp"

namespace hinge_duty {
namespace {

using contact::Column;
using Instant = contact::JointCycle::Instant;
using contact::degree;
using contact::Dimension;
using contact::JointSolution;
using Rating = contact::SlidingContact::Rating;
using Eigen::Vector3d;

// A time of the cycle, and the rating of its contact.
struct State {
  const Instant& instant;
  const Rating& rating;
  const contact::RimContact& rims;
  const contact::PinLie& lie;
};
const Instant& part(const State& s, const Column<Instant>& /*of*/) {
  return s.instant;
}
const JointSolution& part(const State& s, const Column<JointSolution>& /*of*/) {
  return s.instant.solution;
}
const Rating& part(const State& s, const Column<Rating>& /*of*/) {
  return s.rating;
}
const contact::RimContact& part(const State& s,
                                const Column<contact::RimContact>& /*of*/) {
  return s.rims;
}
const contact::PinLie& part(const State& s,
                            const Column<contact::PinLie>& /*of*/) {
  return s.lie;
}

struct StateColumn {
  std::string name;
  std::function<double(const State&)> of;
};

// @param rims, ends  whether to include the columns of seats and finite-length
// pins
std::vector<StateColumn> state_columns(bool rims, bool ends) {
  std::vector<StateColumn> all;
  // Components of vectors, without their length.
  const auto add_one = [&](const auto& quantity) {
    for (auto& column : columns_of(quantity)) {
      if (quantity.is_vector() && column.part == contact::whole) continue;
      all.push_back({column.name, [column](const State& s) {
                       return column(part(s, column));
                     }});
    }
  };
  const auto add = [&](auto table, std::initializer_list<const char*> keys) {
    for (const char* key : keys) add_one(*find_quantity(table, key));
  };
  const auto solution = contact::solution_quantities();
  const auto rating = contact::rating_quantities();
  add(contact::instant_quantities(), {"time", "reaction", "angular_velocity"});
  add(solution, {"normal_force", "normal", "half_angle", "friction_angle",
                 "slip_axis_angle", "friction_moment"});
  add(rating, {"heat"});
  add(solution, {"peak_pressure"});
  add(rating,
      {"pv_max", "pv_max_theta", "heat_flux_max", "pv_total", "pv_nominal"});
  if (rims) {
    for (const auto& quantity : contact::rim_quantities()) add_one(quantity);
  }
  if (ends) {
    for (const auto& quantity : contact::lie_quantities()) add_one(quantity);
  }
  return all;
}

template <class Columns>
std::vector<std::string> names_of(const Columns& columns) {
  std::vector<std::string> names;
  for (const auto& column : columns) names.emplace_back(column.name);
  return names;
}

}  // namespace

std::vector<Column<contact::WearIn::State>> worn_columns() {
  std::vector<Column<contact::WearIn::State>> all;
  for (const auto& q : contact::worn_quantities()) {
    const bool is_small = q.dimension == Dimension::length;
    const bool is_volume = q.dimension == Dimension::volume;
    for (auto& column :
         columns_of(q, is_small    ? contact::unit_of(q.dimension, "mm")
                       : is_volume ? contact::unit_of(q.dimension, "mm3")
                                   : contact::printed_unit(q.dimension))) {
      all.push_back(std::move(column));
    }
  }
  return all;
}

void write_blocks(const std::vector<JointDuty>& duties, cli::Output& output,
                  const cli::TableStyle& style) {
  const auto columns = worn_columns();
  write_rows(duties, names_of(columns), output, style,
             [&](const JointDuty& duty, cli::RowWriter& to, const auto& begin) {
               for (const contact::WearIn::State& state : duty.worn) {
                 begin();
                 for (const auto& column : columns) to.number(column(state));
                 to.end();
               }
             });
}

void write_states(const std::vector<JointDuty>& duties, cli::Output& output,
                  const cli::TableStyle& style) {
  const bool rims = have_seat(duties);
  const auto columns = state_columns(rims, have_ends(duties));
  std::vector<std::string> names = names_of(columns);
  if (rims) names.emplace_back("status");
  write_rows(
      duties, names, output, style,
      [&](const JointDuty& duty, cli::RowWriter& to, const auto& begin) {
        const contact::JointCycle& cycle = duty.cycle;
        for (const Instant& i : cycle.rows()) {
          const Rating rating = cycle.rating(i);
          const contact::RimContact at_rims =
              cycle.joint().rims(i.solution).value_or(contact::RimContact());
          const contact::PinLie lie =
              cycle.joint().lie(i.solution).value_or(contact::PinLie());
          begin();
          for (const StateColumn& column : columns) {
            to.number(column.of({i, rating, at_rims, lie}) + 0.0);  // no -0
          }
          if (rims) to.text(to_string(i.solution.status));
          to.end();
        }
      });
}

void write_map(const std::vector<JointDuty>& duties, cli::Output& output,
               const cli::TableStyle& style) {
  const bool is_pin = duties[0].joint.is_pin();
  std::vector<std::string> columns = {"body", "beta_deg"};
  if (!is_pin) columns = {"body", "x", "y", "z"};
  columns.insert(columns.end(),
                 {"pv_integral_Pa_m", "depth_mm", "cross_shear"});
  write_rows(duties, columns, output, style,
             [&](const JointDuty& duty, cli::RowWriter& to, const auto& begin) {
               for (const BodyWear& w : duty.wear) {
                 for (std::size_t i = 0; i < w.points.size(); ++i) {
                   if (w.wear[i].pv == 0) continue;
                   const Vector3d& point = w.points[i];
                   begin();
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
