#include "separation/option_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "libcontact/base/error.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/pressure/factory.hpp"
#include "separation/output/file_name.hpp"

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

void check_law(const char* option, const std::string& name,
               const std::vector<std::string>& names) {
  if (name.empty() || std::ranges::find(names, name) != names.end()) return;
  throw contact::Error(
      fmt::format("{} {}: allowed {}", option, name, fmt::join(names, ", ")));
}

void check_compare(const Options& o) {
  if (o.no_clearance) {
    throw contact::Error(
        "--compare: allowed without --no-clearance: it has no distances");
  }
  const bool checkpoints = !o.checkpoint.empty() || !o.resume.empty();
  if (checkpoints || !o.history.empty() || !o.events.empty() ||
      !o.output.plot.empty() || !o.friction.empty()) {
    throw contact::Error(
        "--compare: allowed without --history, --events, --plot, --friction, "
        "--checkpoint, --resume");
  }
}

void check_run(const Options& o, bool format_given) {
  if (o.friction == "ideal") {
    refuse_idle_law("--law", o.half_angle_law);
    refuse_idle_law("--pressure", o.pressure_law);
  }
  if (format_given && o.output.format != cli::Format::json) {
    throw contact::Error(
        "--format: the summary is JSON; tables need --compare");
  }
  check_standard_output("--history", o.history, o);
  check_standard_output("--events", o.events, o);
}

}  // namespace

void check_options(const Options& o, bool format_given) {
  if (!o.events.empty()) {
    check_ending("--events", o.events, {".csv"}, ".csv; - for standard output");
  }
  if (o.compare) {
    check_compare(o);
  } else {
    check_run(o, format_given);
  }
  // blend:K has a number; the joints look at it.
  if (!o.half_angle_law.starts_with("blend:")) {
    check_law("--law", o.half_angle_law, contact::half_angle_law_names());
  }
  check_law("--pressure", o.pressure_law, contact::pressure_law_names());
  if (!o.checkpoint.empty() && o.checkpoint_every == 0 && o.resume.empty()) {
    throw contact::Error("--checkpoint: allowed with --checkpoint-every");
  }
}

}  // namespace separation
