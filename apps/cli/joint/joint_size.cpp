#include "cli/joint/joint_size.hpp"

#include <CLI/CLI.hpp>

#include <array>

#include "cli/choice.hpp"
#include "cli/program.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"

namespace cli {
namespace {

using contact::Fit;
using contact::FitClearance;

constexpr std::array<Choice<FitClearance>, 3> fit_clearances = {
    {{"minimum", FitClearance::minimum},
     {"mean", FitClearance::mean},
     {"maximum", FitClearance::maximum}}};

void refuse_other(const char* option, const std::string& name,
                  const contact::ToleranceClasses& classes) {
  if (!classes.contains(name)) refuse(option, name, classes.rule);
}

JointSize size_of_fit(const SizeOptions& o) {
  refuse_other("--hole", o.hole, contact::fit_holes);
  refuse_other("--shaft", o.shaft, contact::fit_shafts);
  const double diameter = parse_length("--diameter", o.diameter);
  if (!Fit::has_size(diameter)) {
    refuse("--diameter", o.diameter, "3 to 500 mm with a fit");
  }
  const Fit fit(o.hole, o.shaft, diameter,
                choice("--fit-clearance", o.fit_clearance, fit_clearances));
  if (fit.radial_clearance() == 0) {
    refuse("--fit-clearance", o.fit_clearance,
           "mean or maximum: " + fit.name() + " may have none");
  }
  return {fit.radius(), fit.radial_clearance(), fit};
}

double clearance_of(const SizeOptions& o, double radius) {
  if (o.diametral_clearance.empty()) {
    const double clearance = parse_length("--clearance", o.clearance);
    if (clearance < radius) return clearance;
    refuse("--clearance", o.clearance, "below the radius");
  }
  const double clearance =
      parse_length("--diametral-clearance", o.diametral_clearance) / 2;
  if (clearance < radius) return clearance;
  refuse("--diametral-clearance", o.diametral_clearance, "below the diameter");
}

}  // namespace

void add_size_options(CLI::App& app, SizeOptions& o, CLI::Option* pair) {
  const auto add = [&](const char* name, std::string& value, const char* what,
                       const char* kind) {
    return app.add_option(name, value, what)->option_text(kind)->needs(pair);
  };
  add("--radius", o.radius, "of the ball or pin", "LENGTH");
  auto* diameter =
      add("--diameter", o.diameter,
          "in place of --radius; of a fit the nominal size", "LENGTH");
  add("--clearance", o.clearance, "difference of the radii", "LENGTH");
  add("--diametral-clearance", o.diametral_clearance, "of the diameters",
      "LENGTH");
  auto* hole = add("--hole", o.hole,
                   "in place of a clearance: a fit by ISO 286, as H7", "NAME");
  auto* shaft =
      add("--shaft", o.shaft, "of the ball or pin in that hole, as g6", "NAME");
  add("--fit-clearance", o.fit_clearance,
      "of a fit: minimum, mean (default) or maximum", "NAME")
      ->needs(hole);
  hole->needs(shaft)->needs(diameter);
  shaft->needs(hole);
  exclude(app, "--radius", {"--diameter"});
  exclude(app, "--clearance", {"--diametral-clearance", "--hole"});
  exclude(app, "--diametral-clearance", {"--hole"});
}

std::optional<JointSize> make_size(const SizeOptions& o) {
  if (!o.hole.empty()) return size_of_fit(o);
  const bool has_radius = !o.radius.empty();
  const bool has_clearance = !o.clearance.empty();
  if (!has_clearance && o.diametral_clearance.empty()) {
    if (has_radius) {
      refuse_without("--radius", "--clearance or --diametral-clearance");
    }
    if (o.diameter.empty()) return {};
    refuse_without("--diameter",
                   "--clearance, --diametral-clearance, or --hole and --shaft");
  }
  if (!has_radius && o.diameter.empty()) {
    refuse_without(has_clearance ? "--clearance" : "--diametral-clearance",
                   "--radius or --diameter");
  }
  const double radius = has_radius ? parse_length("--radius", o.radius)
                                   : parse_length("--diameter", o.diameter) / 2;
  return JointSize{radius, clearance_of(o, radius)};
}

}  // namespace cli
