#include "programs/identify/run.hpp"

#include <fmt/format.h>

#include "cli/choice.hpp"
#include "cli/output.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "programs/identify/data.hpp"
#include "programs/identify/picture.hpp"
#include "programs/identify/report.hpp"

namespace hinge_identify {
namespace {

using contact::FrictionParameter;

constexpr const char* program = "hinge-identify";

constexpr cli::Choice<FrictionParameter> parameters[] = {
    {"f0", FrictionParameter::coefficient},
    {"A", FrictionParameter::adhesion},
    {"clearance", FrictionParameter::clearance}};

std::vector<FrictionParameter> read_fit(const std::string& text) {
  std::vector<FrictionParameter> all;
  for (const std::string_view word : cli::split(text, ",")) {
    const FrictionParameter parameter = cli::choice("--fit", word, parameters);
    if (std::ranges::count(all, parameter) > 0) {
      cli::refuse("--fit", text, "names, each once");
    }
    all.push_back(parameter);
  }
  return all;
}

contact::IdentifyOptions identify_options(const Options& options) {
  contact::IdentifyOptions all{read_fit(options.fit), options.huber,
                               options.profile};
  all.level = options.level;
  return all;
}

// What is not fitted is that of the options or of the joint.
contact::FrictionModel given_friction(
    const Options& options, const cli::Joint& joint,
    const std::vector<FrictionParameter>& fitted) {
  const auto is_fitted = [&](FrictionParameter parameter) {
    return std::ranges::count(fitted, parameter) > 0;
  };
  const bool f0 = is_fitted(FrictionParameter::coefficient);
  if (f0 && options.friction.coefficient) {
    cli::refuse_beside("--friction", "--fit f0");
  }
  if (is_fitted(FrictionParameter::adhesion) && options.friction.adhesion) {
    cli::refuse_beside("--adhesion", "--fit A");
  }
  const std::string fit = "--fit " + options.fit;
  const contact::FrictionLaw law =
      dry_friction(options.friction, joint.spec.friction, fit,
                   "dry friction: the joint's is not");
  if (!f0 && !joint.spec.friction && !options.friction.coefficient) {
    cli::refuse_without(fit, "--friction: the joint has none");
  }
  return law;
}

}  // namespace

cli::ExitStatus run(const Options& options) {
  names_of(options.output).add("--residuals", options.residuals);
  const cli::Joint joint = make_joint(options.joint);
  const contact::IdentifyOptions identify = identify_options(options);
  const contact::JointContact contact =
      joint.contact(given_friction(options, joint, identify.parameters));
  const auto data = read_data(options, joint.is_pin());
  const contact::FrictionFit fit = identify_friction(contact, data, identify);
  cli::warn_of_validity(program, {joint});
  for (const std::string& text : warnings(fit, data, identify)) {
    cli::warn(program, text);
  }
  if (!options.residuals.empty()) {
    write_residuals(fit, data, options.residuals, options.output);
  }
  write_report(fit, identify.profile, options.output);
  cli::ExitStatus status = cli::all_good;
  if (fit.status != contact::Status::ok) {
    cli::warn(program, "the fit has not converged");
    status = cli::some_bad;
  }
  const std::string& plot = options.output.plot;
  if (plot.empty()) return status;
  return cli::drawn(
      program, draw_fit(joint.title, fit, data, identify.level, plot), status);
}

}  // namespace hinge_identify
