#include "angle/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "angle/angle_plot.hpp"
#include "angle/angle_table.hpp"
#include "angle/compare.hpp"
#include "angle/input.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/ordered_blocks.hpp"
#include "cli/table.hpp"

namespace hinge_angle {
namespace {

// Some rows on their way through the program.
struct Block {
  std::size_t first;
  std::size_t last;
  cli::Text rows;
  std::vector<Failures> failures;
};

// Writes the table; returns what the laws could not give.
std::vector<Failures> write_table(const AngleTable& angles, const Input& input,
                                  std::size_t laws,
                                  const cli::OutputOptions& options) {
  constexpr std::size_t block_rows = 256;
  cli::Output output(options.output);
  const cli::Table table(
      options, input.inverse ? angles.inverse_columns() : angles.columns());
  cli::TableWriter writer(output, table);
  cli::Progress progress("rows", input.values.size());
  std::vector<Failures> failures(laws);
  std::size_t taken = 0;
  cli::ordered_blocks<Block>(
      options.jobs,
      [&](Block& block) {
        block.first = taken;
        block.last = taken = std::min(taken + block_rows, input.values.size());
        return block.first < block.last;
      },
      [&](Block& block) {
        block.rows.clear();
        block.failures.assign(laws, {});
        cli::RowWriter row(table, block.rows);
        for (std::size_t i = block.first; i < block.last; ++i) {
          if (input.inverse) {
            angles.write_inverse_row(input.values[i], row, block.failures);
          } else {
            angles.write_row(input.variable, input.values[i], row,
                             block.failures);
          }
        }
      },
      [&](const Block& block) {
        writer.write(block.rows.view());
        progress.add(block.last - block.first);
        for (std::size_t i = 0; i < laws; ++i) {
          failures[i].out_of_range += block.failures[i].out_of_range;
          failures[i].not_converged += block.failures[i].not_converged;
        }
      });
  writer.finish();
  output.commit();
  return failures;
}

// The table; says what the laws could not give.
cli::ExitStatus write_half_angles(const AngleTable& angles, const Input& input,
                                  const std::vector<NamedLaw>& laws,
                                  const cli::OutputOptions& options) {
  const auto failures = write_table(angles, input, laws.size(), options);
  cli::ExitStatus status = cli::all_good;
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const auto [out_of_range, not_converged] = failures[i];
    if (out_of_range > 0) {
      cli::warn("hinge-angle",
                fmt::format("law {}: no value for {} of {} rows, which "
                            "are outside its range",
                            laws[i].name, out_of_range, input.values.size()));
    }
    if (not_converged > 0) {
      cli::warn("hinge-angle",
                fmt::format("law {}: {} of {} rows have not converged",
                            laws[i].name, not_converged, input.values.size()));
      status = cli::some_bad;
    }
  }
  return status;
}

// All laws unless some are named.
cli::Joint compared_joint(cli::JointOptions options) {
  if (options.laws.empty()) options.laws = {"all"};
  cli::Joint joint = make_joint(options);
  if (joint.conditions.loading.is_back() || joint.conditions.walls) {
    cli::refuse_beside("--compare",
                       to_string(joint.conditions) +
                           ": its laws are of a force at the centre and an "
                           "infinite outer body");
  }
  return joint;
}

Input compared_input(LoadOptions options, const cli::Joint& joint) {
  // From where Hertz holds to where the limit does.
  if (!options.given()) options.load_parameter = "1e-6:1e8:log281";
  return make_input(options, joint);
}

}  // namespace

cli::ExitStatus run(const Options& options) {
  const cli::Joint joint = options.compare ? compared_joint(options.joint)
                                           : make_joint(options.joint);
  const double tolerance =
      cli::parse_value("--tolerance", options.tolerance, {0, 100, "%"});
  const Loads loads(joint.kind, joint.geometry, joint.pair);
  const AngleTable angles(joint, loads);
  const Input input = options.compare ? compared_input(options.load, joint)
                                      : make_input(options.load, joint);
  if (!options.output.plot.empty() && input.values.size() == 1) {
    cli::refuse_without("--plot", "a range of loads or half-angles");
  }
  std::vector<LawComparison> comparison;
  if (options.compare) comparison = compare(loads, input, joint, tolerance);
  warn_of_validity("hinge-angle", joint);

  cli::ExitStatus status = cli::all_good;
  if (options.compare) {
    write_comparison(comparison, loads, joint, options.output);
  } else {
    status = write_half_angles(angles, input, joint.laws, options.output);
  }
  if (options.output.plot.empty()) return status;
  return cli::drawn("hinge-angle",
                    draw(loads, input, joint, options.output.plot), status);
}

}  // namespace hinge_angle
