#include "programs/joint/input.hpp"

#include <fmt/format.h>

#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace hinge_joint {
namespace {

using contact::Dimension;

// The sweep of an angle, which pins do not have.
cli::Sweep angle_sweep(std::string_view option, const std::string& text,
                       const char* force, const cli::Allowed& allowed, bool pin,
                       std::string_view fixed_angle) {
  if (pin && !text.empty()) {
    cli::refuse_beside(cli::given(option, text),
                       "--joint: a pin has no such angle");
  }
  if (!fixed_angle.empty()) {
    return {option, fixed_angle, allowed, Dimension::angle};
  }
  if (text.empty()) cli::refuse_without(force, option);
  return {option, text, allowed, Dimension::angle};
}

}  // namespace

Inputs::Inputs(const Options& options, const Setup& setup) {
  const bool pin = setup.joints[0].joint.is_pin();
  if (options.tilt.given()) {
    for (const cli::Joint& joint : setup.given) {
      placements_.emplace(options.tilt, joint);
    }
    slide_ = options.slide.value_or(0);
  }
  const bool reaction = !options.reaction.empty();
  if (options.reaction_xyz) {
    if (!options.rate_xyz && !options.moment_xyz) {
      cli::refuse_without("--reaction-xyz",
                          "--rate-xyz or, at rest, --moment-xyz");
    }
    if (options.moment_xyz) question_ = Question::rest;
    vectors_.force = *options.reaction_xyz;
    vectors_.turn =
        options.moment_xyz ? *options.moment_xyz : *options.rate_xyz;
    return;
  }
  if (!reaction && options.normal_force.empty()) {
    cli::refuse_without("a state",
                        "one of --reaction-xyz, --reaction, "
                        "--normal-force, --points (see --help)");
  }
  rates_ = rates_of(options);
  if (reaction) {
    forces_.emplace("--reaction", options.reaction, allowed_force,
                    Dimension::force);
    // A zero force has no direction.
    const bool unloaded = forces_->size() == 1 && (*forces_)[0] == 0;
    const bool by_designation =
        setup.given[0].spec.bearing && options.beta.empty();
    if (by_designation) {
      cli::note(
          "hinge-joint",
          "--beta 90 taken: a bearing turns about its ring's axis, across "
          "the reaction");
    }
    const bool any =
        pin || by_designation || (unloaded && options.beta.empty());
    angles_ = angle_sweep("--beta", options.beta, "--reaction", allowed_beta,
                          pin, any ? "90" : "");
  } else {
    question_ = Question::contact;
    forces_.emplace("--normal-force", options.normal_force, allowed_force,
                    Dimension::force);
    angles_ = angle_sweep("--alpha", options.alpha, "--normal-force",
                          allowed_alpha, pin, pin ? "0" : "");
  }
  // Each row, for up to 35 pairs of laws, needs a number.
  constexpr double most = 1e12;
  if (static_cast<double>(forces_->size()) *
          static_cast<double>(angles_->size()) *
          static_cast<double>(rates_->size()) * static_cast<double>(lies()) >
      most) {
    throw contact::Error(
        contact::detail::must_be(fmt::format("{} forces and {} angles",
                                             forces_->size(), angles_->size()),
                                 "at most 1e12 states"));
  }
}

Input Inputs::operator[](std::size_t index) const {
  if (!forces_) return vectors_;
  const std::size_t turn = index / lies();
  const std::size_t state = turn / rates_->size();
  Input input =
      at((*forces_)[state / angles_->size()],
         (*angles_)[state % angles_->size()], (*rates_)[turn % rates_->size()]);
  if (placements_) {
    input.placement = (*placements_)[index % lies()];
    input.placement->axial_velocity = slide_;
  }
  return input;
}

Input Inputs::at(double force, double angle_deg, double rate) const {
  return question_ == Question::contact
             ? state_from_contact(force, angle_deg, rate)
             : state_from_reaction(force, angle_deg, rate);
}

cli::Sweep rates_of(const Options& options) {
  return {"--rate", options.rate.empty() ? "1" : options.rate, allowed_rate,
          Dimension::angular_velocity};
}

double only_rate(const Options& options) {
  const cli::Sweep rates = rates_of(options);
  if (rates.size() > 1) {
    cli::refuse_without(cli::given("--rate", options.rate), "one rate here");
  }
  return rates[0];
}

}  // namespace hinge_joint
