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
  std::string_view label;
  std::string_view column;
  std::array<ReportPart, 2> beside = {};
  bool in_tables = true;  ///< also a column of a report on several rows
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
    {"torque without load", "M_0_N_m", {{{"pressure", "p_0_Pa"}}}, false},
    {"largest p v",
     "pv_max_W_per_m2",
     {{{"nominal", "pv_nominal_W_per_m2"}}},
     false},
    {"largest p v",
     "largest_pv_max_W_per_m2",
     {{{"nominal", "largest_pv_nominal_W_per_m2"}}}},
    {"energy of a cycle", "energy_J", {{{"mean heat", "mean_heat_W"}}}},
    {"sliding path", "sliding_path_m", {{{"in", "period_s"}}}},
    {"approach", "approach_m", {{{"stiffness", "stiffness_N_per_m"}}}, false},
    {"contact area", "contact_area_m2", {}, false},
};

/// True if a table with these columns or numbers has such lines.
bool has_report_lines(std::span<const std::string> names);

}  // namespace cli
