#include "programs/angle/run.hpp"

#include <fmt/format.h>

#include <set>
#include <string>
#include <vector>

#include "cli/output.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/row_blocks.hpp"
#include "cli/table.hpp"
#include "programs/angle/angle_plot.hpp"
#include "programs/angle/angle_table.hpp"
#include "programs/angle/compare.hpp"
#include "programs/angle/input.hpp"
#include "programs/angle/limits.hpp"
#include "programs/angle/pin_table.hpp"

namespace hinge_angle {
namespace {

// A block of rows that the program works on.
struct Block : cli::RowBlock {
  std::vector<std::vector<Findings>> findings;  // for each joint and law
};

// One table of several joints, one after the other.
class Tables {
 public:
  Tables(const std::vector<cli::Joint>& joints,
         const std::vector<Input>& inputs, bool own_hertz) {
    const bool preload = cli::JointPreload::any_of(joints);
    std::vector<std::vector<std::string>> columns;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      tables_.emplace_back(joints[i], inputs[i], own_hertz, preload);
      columns.push_back(tables_.back().columns());
      none_.emplace_back(joints[i].laws.size());
    }
    columns_ = joint_columns(joints, columns);
  }

  const std::vector<std::string>& columns() const { return columns_; }
  /// Rows of all joints, the same number for each.
  std::size_t size() const { return tables_.size() * tables_[0].size(); }
  void write(Block& block, cli::RowWriter& row) const {
    block.findings = none_;
    const std::size_t each = tables_[0].size();
    for (std::size_t i = block.first; i < block.last; ++i) {
      tables_[i / each].write_row(i % each, row, block.findings[i / each]);
    }
  }
  const std::vector<std::vector<Findings>>& none() const { return none_; }

 private:
  std::vector<AngleTable> tables_;
  std::vector<std::string> columns_;
  std::vector<std::vector<Findings>> none_;
};

// Writes the table; returns the findings on each joint and law.
std::vector<std::vector<Findings>> write_table(
    const Tables& tables, const cli::Table& table,
    const cli::OutputOptions& options) {
  cli::Output output(options.output);
  cli::NumberedRows rows(tables.size());
  auto findings = tables.none();
  cli::write_rows<Block>(
      options, output, table, rows, "rows",
      [&](Block& block, cli::RowWriter& row) { tables.write(block, row); },
      [&](const Block& block) {
        for (std::size_t j = 0; j < findings.size(); ++j) {
          for (std::size_t i = 0; i < findings[j].size(); ++i) {
            findings[j][i].add(block.findings[j][i]);
          }
        }
      });
  return findings;
}

// Warns of rows without a value, and of unreliable rows.
cli::ExitStatus report(const std::vector<cli::Joint>& joints,
                       const std::vector<std::vector<Findings>>& findings,
                       std::size_t rows) {
  cli::ExitStatus status = cli::all_good;
  std::set<std::string> notes;
  for (std::size_t i = 0; i < joints[0].laws.size(); ++i) {
    const std::string& law = joints[0].laws[i].name;
    Findings all;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const Findings& one = findings[j][i];
      all.add(one);
      for (const std::string& note :
           limits_of(joints[j], i).notes(one.largest)) {
        notes.insert(fmt::format("law {}: {}", law, note));
      }
    }
    if (all.out_of_range > 0) {
      cli::warn("hinge-angle",
                fmt::format("law {}: no value for {} of {} rows, which "
                            "are outside its range",
                            law, all.out_of_range, rows));
    }
    if (all.empty > 0) status = cli::some_bad;
    if (all.not_converged > 0) {
      cli::warn("hinge-angle",
                fmt::format("law {}: {} of {} rows have not converged", law,
                            all.not_converged, rows));
      status = cli::some_bad;
    }
  }
  for (const std::string& note : notes) cli::warn("hinge-angle", note);
  return status;
}

// Uses all laws unless some are named.
cli::Joint compared_joint(cli::JointOptions options) {
  if (options.laws.empty()) options.laws = {"all"};
  cli::Joint joint = make_joint(options);
  const contact::ContactConditions conditions = joint.spec.conditions();
  if (conditions.loading.is_back() || conditions.walls ||
      conditions.clearance != contact::Clearance::positive) {
    cli::refuse_beside("--compare",
                       to_string(conditions) +
                           ": it compares laws for a force at the centre, an "
                           "infinite outer body and a clearance above 0");
  }
  return joint;
}

Input compared_input(LoadOptions options, const cli::Joint& joint) {
  // Covers the range from Hertz contact to the limit half-angle.
  if (!options.given()) options.load_parameter = "1e-6:1e8:log281";
  return make_input(options, joint);
}

void check_plot(const cli::OutputOptions& options,
                const std::vector<Input>& inputs) {
  if (options.plot.empty() || inputs[0].values.size() > 1) return;
  cli::refuse_without("--plot", "a range of loads or half-angles");
}

cli::ExitStatus run_comparison(const Options& options) {
  const std::vector<cli::Joint> joints = {compared_joint(options.joint)};
  const std::vector<Input> inputs = {compared_input(options.load, joints[0])};
  check_plot(options.output, inputs);
  const auto comparison = compare(inputs[0], joints[0], options.tolerance);
  warn_of_validity("hinge-angle", joints);
  write_comparison(comparison, joints[0], options.output);
  if (options.output.plot.empty()) return cli::all_good;
  return cli::drawn("hinge-angle", draw(inputs, joints, options.output.plot),
                    cli::all_good);
}

}  // namespace

cli::ExitStatus run(const Options& options) {
  if (options.play.force_law) {
    return run_force_law(options.play, options.joint, options.load,
                         options.compare, options.output);
  }
  if (options.play.impact) {
    return run_impact(options.play, options.joint, options.output);
  }
  if (options.tilt.given()) return run_placed(options);
  if (options.compare) return run_comparison(options);
  const std::vector<cli::Joint> joints = make_joints(options.joint);
  std::vector<Input> inputs;
  for (const cli::Joint& joint : joints) {
    inputs.push_back(make_input(options.load, joint));
  }
  const bool own_hertz =
      options.joint.pressures.empty() &&
      joints[0].spec.pressure_law == contact::default_pressure_law;
  const Tables tables(joints, inputs, own_hertz);
  check_plot(options.output, inputs);
  if (!options.output.plot.empty()) check_curves(joints);
  const cli::Table table(options.output.titled(shared_title(joints, "")),
                         tables.columns());
  warn_of_validity("hinge-angle", joints);
  const auto findings = write_table(tables, table, options.output);
  const cli::ExitStatus status = report(joints, findings, tables.size());
  if (options.output.plot.empty()) return status;
  return cli::drawn("hinge-angle", draw(inputs, joints, options.output.plot),
                    status);
}

}  // namespace hinge_angle
