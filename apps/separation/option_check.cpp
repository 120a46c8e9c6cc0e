#include "separation/option_check.hpp"

#include <fmt/format.h>

#include "libcontact/error.hpp"
#include "separation/file_name.hpp"

namespace separation {
namespace {

bool is_standard_output(const std::string& name) {
  return name.empty() || name == "-";
}

void refuse_idle_law(const char* option, const std::string& name) {
  if (name.empty()) return;
  throw contact::Error(fmt::format(
      "{} {}: allowed with friction, not with --friction ideal", option, name));
}

// The summary goes there unless it has a file.
void check_standard_output(const char* option, const std::string& name,
                           const Options& options) {
  if (name != "-" || !is_standard_output(options.output.output)) return;
  throw contact::Error(
      fmt::format("{} -: standard output has the summary; allowed with "
                  "--output FILE for that",
                  option));
}

}  // namespace

void check_options(const Options& options, bool format_given) {
  if (!options.events.empty()) {
    check_ending("--events", options.events, {".csv"},
                 ".csv; - for standard output");
  }
  if (options.compare) {
    if (!options.no_clearance) return;
    throw contact::Error(
        "--compare: allowed without --no-clearance: it has no distances");
  }
  if (options.friction == "ideal") {
    refuse_idle_law("--law", options.half_angle_law);
    refuse_idle_law("--pressure", options.pressure_law);
  }
  // The default is for --compare.
  if (format_given && options.output.format == cli::Format::csv) {
    throw contact::Error(
        "--format: the summary is JSON; tables need --compare");
  }
  check_standard_output("--history", options.history, options);
  check_standard_output("--events", options.events, options);
}

}  // namespace separation
