#include "programs/duty/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "libcontact/quantities/seat.hpp"
#include "libcontact/quantities/tables.hpp"
#include "programs/duty/tables.hpp"

namespace hinge_duty {
namespace {

using Instant = contact::JointCycle::Instant;
using contact::JointCycle;
using Eigen::Vector3d;

using cli::Report;
using contact::find_quantity;

std::vector<cli::Cell> at_place(cli::Cell time, const Vector3d& place) {
  return {std::move(time), place.x(), place.y(), place.z()};
}

// Time of a value; NaN if there is no value.
double time_of(double value, const Instant& at) {
  return std::isnan(value) ? value : at.time;
}

void add_moments(const JointCycle& cycle, Report& to) {
  constexpr std::string_view axes[] = {"x", "y", "z"};
  for (int k = 0; k < 3; ++k) {
    for (const int sign : {-1, 1}) {
      const Instant most = cycle.largest([&](const Instant& i) {
        return sign * i.solution.friction_moment[k];
      });
      to.add(
          fmt::format("{}_M_t_{}_N_m", sign < 0 ? "least" : "largest", axes[k]),
          most.solution.friction_moment[k], "friction moment on the body",
          {time_of(most.solution.friction_moment[k], most)});
    }
  }
}

using Place = double contact::PinLie::*;

// Cells beside a value: its time, and the place along pins that end.
std::vector<cli::Cell> along(const JointCycle& cycle, const Instant& i,
                             double value, Place place, Have have) {
  if (!have.ends) return {time_of(value, i)};
  const auto lie = cycle.joint().lie(i.solution);
  return {time_of(value, i), {}, {}, lie ? (*lie).*place : std::nan("")};
}

std::string meaning_of(std::string_view meaning, Have have) {
  return std::string(meaning) +
         (have.ends ? "; z in m from the middle of a pin" : "");
}

// The largest pressure and half-angle, and the least.
void add_extremes(const JointCycle& cycle, Have have, Report& to) {
  const auto add = [&](std::string_view key, std::string_view prefix,
                       const Instant& i, double value, Place place) {
    const auto column = contact::columns_of(
        *find_quantity(contact::solution_quantities(), key))[0];
    to.add(std::string(prefix) + column.name, column.unit->from_si(value),
           meaning_of(column.meaning, have),
           along(cycle, i, value, place, have));
  };
  const Instant peak = cycle.largest_peak();
  add("peak_pressure", "largest_", peak, peak.solution.peak_pressure,
      &contact::PinLie::peak_place);
  for (const int sign : {1, -1}) {
    const Instant i = cycle.largest(
        [&](const Instant& x) { return sign * cycle.half_angle(x); });
    add("half_angle", sign < 0 ? "least_" : "largest_", i, cycle.half_angle(i),
        &contact::PinLie::half_angle_place);
  }
}

void add_peaks(const JointCycle& cycle, Have have, Report& to) {
  const auto heat = [&](const Instant& i) {
    return cycle.sliding(i).largest_heat_flux();
  };
  const auto nominal = [&](const Instant& i) {
    return cycle.sliding(i).pv_nominal();
  };
  const auto moment = [](const Instant& i) {
    return i.solution.friction_moment.norm();
  };
  Instant i = cycle.largest(moment);
  to.add("largest_M_t_N_m", moment(i), "friction moment",
         {time_of(moment(i), i)});
  add_moments(cycle, to);
  add_extremes(cycle, have, to);
  i = cycle.largest_pv();
  const contact::ContactPv pv = cycle.pv(i);
  if (have.ends) {
    to.add("largest_pv_max_W_per_m2", pv.largest,
           meaning_of("largest p v", have),
           along(cycle, i, pv.largest, &contact::PinLie::peak_place, have));
  } else {
    to.add("largest_pv_max_W_per_m2", pv.largest,
           "largest p v; x, y, z from the joint's centre, carrier axes",
           at_place(time_of(pv.largest, i), pv.place));
  }
  i = cycle.largest([&](const Instant& x) { return heat(x).value; });
  const contact::SlidingContact::Peak q = heat(i);
  to.add("largest_q_max_W_per_m2", q.value,
         "largest heat flux of friction, into both bodies",
         at_place(time_of(q.value, i),
                  std::isnan(q.value) ? Vector3d::Constant(q.value) : q.place));
  i = cycle.largest(nominal);
  to.add("largest_pv_nominal_W_per_m2", nominal(i),
         "nominal PV over nominal_area_m2; catalogues may use another area",
         {time_of(nominal(i), i)});
  to.add("nominal_area_m2", cycle.contact().geometry().nominal_area(),
         "projected: pi rho^2 or 2 rho L");
}

void add_volume(const std::string& surface, double k, double pv_integral,
                Report& to) {
  to.add("k_" + surface + "_mm3_per_N_m", k, "wear coefficient, as given");
  to.add("volume_" + surface + "_mm3", k * pv_integral,
         "wear of one cycle: k times the integral of p v");
}

void add_wear(const BodyWear& wear, double pv_integral, Report& to) {
  const std::string of = "_" + wear.body;
  const auto place = at_place({}, wear.deepest.point);
  if (wear.k) {
    add_volume(wear.surface, *wear.k, pv_integral, to);
    to.add("largest_depth" + of + "_mm", wear.depth(wear.deepest.wear),
           "wear of one cycle; x, y, z in the axes of the " + wear.body, place);
  }
  to.add("largest_pv_integral" + of + "_Pa_m", wear.deepest.wear.pv,
         "largest integral of p v over time; times k: depth", place);
  to.add("cross_shear" + of, wear.deepest.wear.cross_shear,
         "at this place: share of friction work across the main direction");
  to.add("volume_defect" + of, wear.volume_defect,
         "relative difference between the map's volume and the integral");
}

// V = N k pv_integral.
void add_measured(const MeasuredWear& measured, double pv_integral,
                  Report& to) {
  const double per_volume = 1 / (measured.cycles * pv_integral);
  to.add("k_measured_mm3_per_N_m", measured.volume * per_volume,
         "measured volume over cycles and the integral of p v");
  if (!measured.error) return;
  to.add("k_measured_error_mm3_per_N_m", *measured.error * per_volume,
         "standard error, of the measured volume alone");
}

// The worst values at the rims, without the columns of every contact.
void add_rims(const JointCycle& cycle, Report& to) {
  const Instant nearest = cycle.least_gap();
  const Instant sharpest = cycle.largest_intensity();
  const std::pair<std::string_view, const Instant*> rows[] = {
      {"least_gap", &nearest},
      {"largest_intensity", &sharpest},
      {"largest_rim_pressure", &sharpest}};
  for (const auto& column : columns_of(contact::worst_quantities())) {
    if (std::ranges::find(to.lines(), column.name, &Report::Line::name) !=
        to.lines().end()) {
      continue;
    }
    const auto* row = std::ranges::find(rows, column.quantity->key,
                                        [](const auto& r) { return r.first; });
    const double value = column(cycle);
    if (row == std::end(rows)) {
      to.add(column.name, value, column.meaning);
    } else {
      to.add(column.name, value, column.meaning,
             {time_of(value, *row->second)});
    }
  }
}

}  // namespace

cli::Report summary_of(const JointDuty& duty,
                       const std::optional<MeasuredWear>& measured, Have have) {
  Report report({{"at_time_s"}, {"x"}, {"y"}, {"z"}});
  for (const auto& q : contact::cycle_quantities()) report.add(q, duty.cycle);
  const double pv_integral = duty.cycle.sums().pv;
  add_peaks(duty.cycle, have, report);
  for (const BodyWear& w : duty.wear) add_wear(w, pv_integral, report);
  if (have.ends) {
    if (duty.wear_seat)
      add_volume("seat", *duty.wear_seat, pv_integral, report);
    if (duty.wear_inner) {
      add_volume("inner", *duty.wear_inner, pv_integral, report);
    }
  }
  if (measured) add_measured(*measured, pv_integral, report);
  if (have.rims) add_rims(duty.cycle, report);
  if (!duty.worn.empty()) {
    for (const auto& column : worn_columns()) {
      report.add(
          column.name.starts_with("worn") ? column.name : "worn_" + column.name,
          column(duty.worn.back()), column.meaning);
    }
  }
  return report;
}

}  // namespace hinge_duty
