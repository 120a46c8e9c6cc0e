#include "programs/separation/option_check.hpp"

#include <algorithm>
#include <vector>

#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/file_name.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/pressure/factory.hpp"

namespace separation {
namespace {

bool is_standard_output(const std::string& name) {
  return name.empty() || name == "-";
}

void refuse_idle_law(const char* option, const std::string& name) {
  if (name.empty()) return;
  cli::refuse_beside(cli::given(option, name), "--friction ideal");
}

// Standard output holds the summary unless the summary has a file.
void check_standard_output(const char* option, const std::string& name,
                           const Options& options) {
  if (name != "-" || !is_standard_output(options.output.output)) return;
  cli::refuse_without(cli::given(option, name),
                      "--output FILE: standard output has the summary");
}

void check_law(const char* option, const std::string& name,
               const std::vector<std::string>& names) {
  if (name.empty() || std::ranges::find(names, name) != names.end()) return;
  throw contact::Error(contact::detail::unknown(option + 2, name, names));
}

// Table options apply to CSV tables only.
void check_table_options(const Options& o) {
  if (!o.output.columns.empty() && o.history.empty()) {
    cli::refuse_without("--columns", "--history or --compare");
  }
  const bool csv =
      !o.events.empty() || (!o.history.empty() && !cli::is_hdf5(o.history));
  if (csv || (o.output.separator == ',')) return;
  cli::refuse_without(
      o.output.decimal_comma ? "--decimal-comma" : "--separator",
      "--history in CSV, --events or --compare");
}

void check_run(const Options& o, bool format_given) {
  check_table_options(o);
  if (o.friction == "ideal") {
    refuse_idle_law("--law", o.half_angle_law);
    refuse_idle_law("--pressure", o.pressure_law);
  }
  if (format_given && o.output.format != cli::Format::json &&
      o.output.format != cli::Format::report) {
    cli::refuse_without("--format",
                        "--compare: the summary is JSON or a report");
  }
  check_standard_output("--history", o.history, o);
  check_standard_output("--events", o.events, o);
}

void check_replays(const Options& o) {
  bool page = false;
  for (const std::string& name : o.replays) {
    if (!cli::ends_in(name, ".glb") && !cli::is_page(name)) {
      cli::refuse("--replay", name, "a name that ends in .glb or .html");
    }
    page = page || cli::is_page(name);
  }
  if (o.no_case && !page)
    cli::refuse_without("--no-case", "--replay NAME.html");
}

}  // namespace

void check_options(const Options& o, bool format_given) {
  if (!o.events.empty()) {
    cli::check_ending("--events", o.events, {".csv"},
                      ".csv; - for standard output");
  }
  check_replays(o);
  if (!o.compare) check_run(o, format_given);
  // blend:K contains a number, which the joints check.
  if (!o.half_angle_law.starts_with("blend:")) {
    check_law("--law", o.half_angle_law, contact::half_angle_law_names());
  }
  check_law("--pressure", o.pressure_law, contact::pressure_law_names());
  if (!o.checkpoint.empty() && o.checkpoint_every == 0 && o.resume.empty()) {
    cli::refuse_without("--checkpoint", "--checkpoint-every");
  }
}

}  // namespace separation
