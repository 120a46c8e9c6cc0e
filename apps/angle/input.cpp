#include "angle/input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>

#include "libcontact/base/error.hpp"

namespace hinge_angle {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

Input make_input(const Options& options, const Setup& setup) {
  if (options.inverse || !options.theta0.empty()) {
    if (!options.inverse || options.theta0.empty() || !options.load.empty() ||
        !options.load_parameter.empty() || !options.x.empty()) {
      throw contact::Error("--inverse and --theta0: belong together, no load");
    }
    if (options.compare) {
      throw contact::Error("--compare: takes a load, not --inverse");
    }
    // Curves are drawn over the load where there is one.
    return {setup.geometry ? LoadVariable::load : LoadVariable::load_parameter,
            true, cli::Sweep("--theta0", options.theta0, {0, 180, "deg"})};
  }
  const bool ball = setup.kind == contact::JointKind::ball;
  struct Source {
    std::string_view option;
    const std::string& text;
    LoadVariable variable;
    std::string_view unit;
  };
  const std::array<Source, 3> sources = {{
      {"--load", options.load, LoadVariable::load, ball ? "N" : "N/m"},
      {"--load-parameter", options.load_parameter, LoadVariable::load_parameter,
       ""},
      {"--x", options.x, LoadVariable::x, ""},
  }};
  const auto given = [](const Source& source) { return !source.text.empty(); };
  const auto count = std::count_if(sources.begin(), sources.end(), given);
  if (count == 0 && options.compare) {
    // From where Hertz holds to where the limit does.
    return {
        LoadVariable::load_parameter, false,
        cli::Sweep("--load-parameter", "1e-6:1e8:log281", {0, infinity, ""})};
  }
  if (count != 1) {
    throw contact::Error(
        fmt::format("{} one of --load, --load-parameter, --x (see --help)",
                    count == 0 ? "needs" : "needs no more than"));
  }
  const Source& source = *std::find_if(sources.begin(), sources.end(), given);
  if (source.variable == LoadVariable::load && !setup.geometry) {
    throw contact::Error(
        "--load: a dimensionless joint takes --load-parameter or --x; a load "
        "needs --radius and --clearance");
  }
  return {source.variable, false,
          cli::Sweep(source.option, source.text, {0, infinity, source.unit})};
}

}  // namespace hinge_angle
