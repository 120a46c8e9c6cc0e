#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "libcontact/pair/fit.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace cli {

/// The size of a joint as it was written on the command line; "" for options
/// that were not given.
struct SizeOptions {
  std::string radius = {};
  std::string diameter = {};
  std::string clearance = {};
  std::string diametral_clearance = {};
  std::string hole = {};
  std::string shaft = {};
  std::string fit_clearance = "mean";
};

/// Adds them. Each requires the option `pair`.
void add_size_options(CLI::App& app, SizeOptions& options, CLI::Option* pair);

/// What --help says of them.
inline constexpr std::string_view size_help =
    R"(Size: --clearance is the difference of the radii of the two surfaces,
--diametral-clearance that of their diameters, which is twice as much. Or a fit
by ISO 286 gives it: --diameter 50mm --hole H7 --shaft g6, with the nominal
size, 3 to 500 mm, holes E, F, G, H, shafts d, e, f, g, h and grades 5 to 9. The
joint takes the mean of the fit's clearances or the one of --fit-clearance; all
three are said on standard error.
)";

/// Radius of the ball or pin and radial clearance, m.
struct JointSize {
  double radius;
  double clearance;
  std::optional<contact::Fit> fit = {};  ///< that they are from
};

/// None if no option was given. Throws contact::Error if they do not fit
/// together or a value is not allowed.
std::optional<JointSize> make_size(const SizeOptions& options);

}  // namespace cli
