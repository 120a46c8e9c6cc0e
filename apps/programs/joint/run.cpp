#include "programs/joint/run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <string>

#include "cli/gnuplot.hpp"
#include "cli/output.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/magnitude.hpp"
#include "programs/joint/beside.hpp"
#include "programs/joint/contact_picture.hpp"
#include "programs/joint/equivalent_table.hpp"
#include "programs/joint/input.hpp"
#include "programs/joint/loop_table.hpp"
#include "programs/joint/measured_moment.hpp"
#include "programs/joint/point_table.hpp"
#include "programs/joint/points/plot.hpp"
#include "programs/joint/solution_table.hpp"
#include "programs/joint/torque_plot.hpp"

namespace hinge_joint {
namespace {

constexpr const char* one_row =
    "one joint, one state, one law and one pressure law";

// Warns of forces along a pin's axis, which the pin does not carry.
void warn_of_axial_force(const Setup& setup, const Inputs& inputs) {
  if (!setup.joints[0].joint.is_pin() || inputs.forces()) return;
  const Input input = inputs[0];
  const Eigen::Vector3d& force = input.force;
  const Eigen::Vector3d& turn = input.turn;
  if (force.isZero(0) || turn.isZero(0)) return;
  const double axial = std::abs(force.dot(turn.stableNormalized()));
  // A force normal to the axis has an axial part of this size by rounding.
  if (axial <= 1e-12 * contact::magnitude(force)) return;
  cli::warn("hinge-joint", fmt::format("a pin carries no force along its axis: "
                                       "{:.4g} N of the reaction are ignored",
                                       axial));
}

// Warns before the work, after all options are accepted.
void warn_of_states(const Setup& setup, const Inputs& inputs) {
  warn_of_validity("hinge-joint", setup.given);
  warn_of_axial_force(setup, inputs);
}

// The only state and pair of laws, for a loop.
const NamedJoint& only_joint(const Setup& setup, const Inputs& inputs,
                             std::string_view option) {
  if (inputs.size() != 1 || setup.joints.size() != 1) {
    cli::refuse_without(option, one_row);
  }
  const Input input = inputs[0];
  if (inputs.question() != Question::reaction || input.force.isZero(0) ||
      input.turn.isZero(0)) {
    cli::refuse_without(option, "a reaction and a rate that are not 0");
  }
  return setup.joints[0];
}

cli::ExitStatus run_loops(const Options& options, const Setup& setup,
                          const Inputs& inputs) {
  const bool outer = options.outer.has_value();
  const NamedJoint& joint =
      only_joint(setup, inputs, outer ? "--outer" : "--trace");
  const Beside beside(options.beside, setup.given[0].spec.name,
                      !outer          ? "trace"
                      : options.trace ? "inner"
                                      : "outer",
                      options.output);
  warn_of_states(setup, inputs);
  if (!outer) return write_trace(joint, inputs[0], beside, options.output);
  return write_outer(joint, inputs[0], options, beside);
}

// The contacts of each joint and pair of laws.
void warn_of_contacts(const Problems& problems, const Setup& setup) {
  std::set<std::string> notes;
  for (std::size_t i = 0; i < problems.notes.size(); ++i) {
    const NamedJoint& joint = setup.joints[i];
    const std::set<std::string>& of_seat = problems.notes[i].of_seat();
    notes.insert(of_seat.begin(), of_seat.end());
    for (const std::string& note : problems.notes[i].notes(joint.joint)) {
      if (of_seat.contains(note)) continue;
      notes.insert(fmt::format("law {}, pressure {}: {}", joint.law,
                               joint.pressure, note));
    }
  }
  for (const std::string& note : notes) cli::warn("hinge-joint", note);
}

cli::ExitStatus report(const Problems& problems, const Setup& setup) {
  warn_of_contacts(problems, setup);
  // Messages for bad lines were printed before.
  if (problems.out_of_range > 0) {
    cli::warn("hinge-joint",
              fmt::format("rows without a value: {}; the half-angle law or the "
                          "pressure law is undefined there",
                          problems.out_of_range));
  }
  if (problems.not_converged > 0) {
    cli::warn("hinge-joint", fmt::format("rows that have not converged: {}",
                                         problems.not_converged));
  }
  if (problems.out_of_seat > 0) {
    cli::warn("hinge-joint", fmt::format("rows whose ball leaves its seat: {}",
                                         problems.out_of_seat));
  }
  return problems.out_of_range + problems.not_converged + problems.out_of_seat +
                     problems.bad_lines ==
                 0
             ? cli::all_good
             : cli::some_bad;
}

cli::ExitStatus run_points(const Options& options, Setup& setup) {
  if (setup.joints.size() != 1) {
    cli::refuse_without("--points", "one joint, one law and one pressure law");
  }
  const PointResult result = write_points(
      setup, options, [&] { warn_of_validity("hinge-joint", setup.given); });
  const std::string& plot = options.output.plot;
  if (!result.series.time_problem().empty()) {
    cli::warn("hinge-joint",
              result.series.time_problem() + "; the time is left out");
  }
  const cli::ExitStatus status = report(result.problems, setup);
  if (plot.empty()) return status;
  return cli::drawn("hinge-joint", draw_points(setup, result.series, plot),
                    status);
}

// Rejects inputs that draw_torque() cannot draw.
void check_plot(const Setup& setup, const Inputs& inputs) {
  if (!inputs.forces() || inputs.size() == 1) {
    cli::refuse_without(
        "--plot", "a range of --reaction, --normal-force, --beta or --alpha");
  }
  if (inputs.rates()->size() > 1) cli::refuse_without("--plot", "one --rate");
  if (setup.joints.size() > most_pairs_of_laws) {
    cli::refuse_without("--plot",
                        fmt::format("at most {} curves of joints, half-angle "
                                    "laws and pressure laws; these are {}",
                                    most_pairs_of_laws, setup.joints.size()));
  }
}

// Rejects maps that draw_contact() cannot draw, and files that cannot be made.
void check_map(const Options& options, const Setup& setup,
               const Inputs& inputs) {
  const std::string& map = options.map;
  if (inputs.size() != 1 || setup.joints.size() != 1) {
    cli::refuse_without("--map", one_row);
  }
  cli::check_picture_name("--map", map);
  names_of(options.output).add("--map", map);
}

Pointing pointing(const Inputs& inputs) {
  if (inputs.question() == Question::contact) return Pointing::nowhere;
  return inputs.forces() ? Pointing::angle : Pointing::vector;
}

void check_rest(const Setup& setup, const Inputs& inputs) {
  if (inputs.question() != Question::rest) return;
  for (const NamedJoint& joint : setup.joints) {
    const std::string refusal = joint.joint.contact().rest_refusal();
    if (!refusal.empty()) cli::refuse_without("--moment-xyz", refusal);
  }
}

// Rejects inputs that write_summary() cannot write.
void check_summary(const Setup& setup, const Inputs& inputs) {
  if (inputs.size() == 1 && setup.joints.size() == 1) return;
  cli::refuse_without("--summary", one_row);
}

}  // namespace

cli::ExitStatus run(const Options& options) {
  Setup setup = make_setup(options);
  if (!options.kernel.language.empty()) {
    give_ends(options, Pointing::angle, setup);
    return write_kernel(options, setup);
  }
  if (!options.points.empty()) return run_points(options, setup);
  const Inputs inputs(options, setup);
  give_ends(options, pointing(inputs), setup);
  if (options.trace || options.outer.has_value()) {
    return run_loops(options, setup, inputs);
  }
  const bool plot = !options.output.plot.empty();
  if (plot) check_plot(setup, inputs);
  const bool map = !options.map.empty();
  if (map) check_map(options, setup, inputs);
  check_rest(setup, inputs);
  if (options.equivalent) {
    warn_of_states(setup, inputs);
    return write_equivalent(setup, inputs, options.output);
  }
  if (options.summary) check_summary(setup, inputs);
  if (options.measured_moment) {
    find_friction(*options.measured_moment, inputs, setup);
  }
  const Beside beside(options.beside, setup.given[0].spec.name, "solution",
                      options.output);
  const auto begin = [&] { warn_of_states(setup, inputs); };
  const auto write = options.summary ? write_summary : write_solutions;
  cli::ExitStatus status =
      report(write(setup, inputs, beside, options.output, begin), setup);
  if (plot) {
    status = cli::drawn(
        "hinge-joint", draw_torque(setup, inputs, options.output.plot), status);
  }
  if (map) {
    const NamedJoint& joint = setup.joints[0];
    status = cli::drawn(
        "hinge-joint",
        draw_contact(joint, answer(joint, inputs.question(), inputs[0]),
                     setup.given[0].title, options.map),
        status);
  }
  return status;
}

}  // namespace hinge_joint
