#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace cli {

/// A number printed beside the answer of a line.
struct ReportPart {
  std::string_view label = {};
  std::string_view column = {};
  bool compares = false;  ///< prints the answer's deviation from it, in percent
};

/// A line of the report on one row. The lines list the most important columns
/// of the tables of all programs first. A * in a column stands for the law.
struct ReportRow {
  /// Whether it is also a column of a report on several rows.
  enum class Use {
    everywhere,  ///< it is, as long as there is room
    one_row,     ///< it is not
    asked_for,   ///< always: it is only there if an option asked for it
  };
  std::string_view label;
  std::string_view column;
  std::array<ReportPart, 2> beside = {};
  Use use = Use::everywhere;
};

inline constexpr ReportRow report_rows[] = {
    {"load", "load_N", {{{"load parameter", "x"}}}},
    {"load", "load_N_per_m", {{{"load parameter", "x"}}}},
    {"reaction", "R_N", {{{"at beta", "b_deg"}}}},
    {"friction torque",
     "M_t_N_m",
     {{{"textbook f0 R r", "M_textbook_N_m", true}}}},
    {"largest friction torque",
     "largest_M_t_N_m",
     {{{"mean", "mean_M_t_N_m"}}}},
    {"contact half-angle", "theta0*_deg", {{{"lifts off at", "R_lift_off_N"}}}},
    {"largest half-angle",
     "largest_theta0_deg",
     {{{"least", "least_theta0_deg"}}}},
    {"peak pressure",
     "p_peak*_Pa",
     {{{"mean", "p_mean_Pa"}, {"nominal", "p_nominal_Pa"}}}},
    {"largest peak pressure", "largest_p_peak_Pa"},
    {"catalogue friction f_M", "f_M", {{{"R_t/R_n", "f"}}}},
    {"part of what it holds", "utilisation"},
    {"torque without load",
     "M_0_N_m",
     {{{"pressure", "p_0_Pa"}}},
     ReportRow::Use::one_row},
    {"largest p v",
     "pv_max_W_per_m2",
     {{{"nominal", "pv_nominal_W_per_m2"}}},
     ReportRow::Use::one_row},
    {"largest p v",
     "largest_pv_max_W_per_m2",
     {{{"nominal", "largest_pv_nominal_W_per_m2"}}}},
    {"energy of a cycle", "energy_J", {{{"mean heat", "mean_heat_W"}}}},
    {"sliding path", "sliding_path_m", {{{"in", "period_s"}}}},
    {"approach",
     "approach_m",
     {{{"stiffness", "stiffness_N_per_m"}}},
     ReportRow::Use::one_row},
    {"contact area", "contact_area_m2", {}, ReportRow::Use::one_row},
    {"measured wear coefficient k",
     "k_measured_mm3_per_N_m",
     {{{"standard error", "k_measured_error_mm3_per_N_m"}}},
     ReportRow::Use::asked_for},
    {"wear of a cycle", "volume*_mm3", {}, ReportRow::Use::asked_for},
    {"deepest wear of a cycle",
     "largest_depth*_mm",
     {},
     ReportRow::Use::asked_for},
    {"wear after cycles",
     "worn_volume_seat_mm3",
     {{{"cycles", "worn_cycles"}, {"deepest", "worn_penetration_mm"}}},
     ReportRow::Use::asked_for},
    {"half-angle after them", "worn_theta0_deg", {}, ReportRow::Use::asked_for},
    {"peak pressure after them",
     "worn_p_peak_Pa",
     {},
     ReportRow::Use::asked_for},
    {"largest p v after them",
     "worn_pv_max_W_per_m2",
     {},
     ReportRow::Use::one_row},
    {"mean torque after them",
     "worn_mean_M_t_N_m",
     {{{"energy of a cycle", "worn_energy_J"}}},
     ReportRow::Use::one_row},
    {"smallest distance",
     "smallest_distance_m",
     {{{"at", "distance_time_s"}, {"of", "pair"}}}},
    {"largest energy", "largest_energy_J", {{{"drift", "energy_drift_J"}}}},
};

/// True if a table with these columns or numbers has such lines.
bool has_report_lines(std::span<const std::string> names);

}  // namespace cli
