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
    {"clearance", FrictionParameter::clearance},
    {"drag", FrictionParameter::drag},
    {"offset", FrictionParameter::offset}};

std::vector<FrictionParameter> read_fit(const std::string& text) {
  std::vector<FrictionParameter> all;
  for (const std::string_view word : cli::split(text, ",")) {
    const FrictionParameter parameter = cli::choice("--fit", word, parameters);
    if (std::ranges::count(all, parameter) > 0) {
      cli::refuse("--fit", text, "parameters that are each named once");
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

// Friction that is not fitted, from the options or the joint.
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
                   "dry friction; that of the joint is not dry");
  if (!f0 && !joint.spec.friction && !options.friction.coefficient) {
    cli::refuse_without(fit, "--friction: the joint has none");
  }
  return law;
}

// All fits are complete before anything is written.
void write_tables(const Options& options, const std::vector<cli::Joint>& joints,
                  const std::vector<contact::FrictionFit>& fits,
                  std::span<const contact::MeasuredMoment> data) {
  std::vector<cli::Report> reports;
  for (const contact::FrictionFit& fit : fits) {
    reports.push_back(report_of(fit, options.profile));
  }
  cli::Output output(options.output.output);
  write_reports(joints, reports, output, options.output);
  if (!options.residuals.empty()) {
    cli::Output residuals(options.residuals);
    write_residuals(joints, fits, data, residuals, options.output);
    residuals.commit();
  }
  output.commit();
}

}  // namespace

cli::ExitStatus run(const Options& options) {
  names_of(options.output).add("--residuals", options.residuals);
  const std::vector<cli::Joint> joints = make_joints(options.joint);
  check_one_kind(joints);
  const std::string& plot = options.output.plot;
  if (!plot.empty() && joints.size() > 1) {
    cli::refuse_without("--plot", "one joint");
  }
  contact::IdentifyOptions identify = identify_options(options);
  std::vector<contact::JointContact> contacts;
  for (const cli::Joint& joint : joints) {
    contacts.push_back(made_of(joint, [&] {
      return joint.contact(given_friction(options, joint, identify.parameters));
    }));
  }
  const auto data = read_data(options, joints[0].is_pin(), identify);
  std::vector<contact::FrictionFit> fits;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    fits.push_back(made_of(joints[i], [&] {
      return identify_friction(contacts[i], data, identify);
    }));
  }
  cli::warn_of_validity(program, joints);
  cli::ExitStatus status = cli::all_good;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    std::vector<std::string> notes = warnings(fits[i], data, identify);
    if (fits[i].status != contact::Status::ok) {
      notes.emplace_back("the fit has not converged");
      status = cli::some_bad;
    }
    for (const std::string& text : notes) {
      cli::warn(program, said_of(joints[i], text));
    }
  }
  write_tables(options, joints, fits, data);
  if (plot.empty()) return status;
  return cli::drawn(
      program, draw_fit(joints[0].title, fits[0], data, identify.level, plot),
      status);
}

}  // namespace hinge_identify
