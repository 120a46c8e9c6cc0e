#include "programs/joint/solution_table.hpp"

#include <algorithm>

#include "cli/output.hpp"
#include "cli/stream/row_blocks.hpp"

namespace hinge_joint {
namespace {

// Some rows on their way through the program.
struct Block : cli::RowBlock {
  Problems problems;
};

std::vector<Quantity> quantities_of(const Setup& setup, const Inputs& inputs) {
  return quantities(inputs.question() == Question::rest, setup.has_approach(),
                    setup.friction_found, setup.joints[0].pv);
}

}  // namespace

void Problems::add(const Answer& answer, std::size_t joint) {
  const contact::JointSolution& s = answer.solution;
  if (s.status == contact::Status::out_of_range) ++out_of_range;
  if (s.status == contact::Status::not_converged) ++not_converged;
  largest.resize(std::max(largest.size(), joint + 1));
  largest[joint].add(s.half_angle, s.peak_pressure);
}

void Problems::add(const Problems& more) {
  out_of_range += more.out_of_range;
  not_converged += more.not_converged;
  bad_lines += more.bad_lines;
  largest.resize(std::max(largest.size(), more.largest.size()));
  for (std::size_t i = 0; i < more.largest.size(); ++i) {
    largest[i].add(more.largest[i]);
  }
}

std::vector<std::string> solution_columns(const NamedJoint& joint,
                                          std::span<const Quantity> columns,
                                          const Beside& beside) {
  std::vector<std::string> names;
  for (const cli::Difference& difference : joint.differences) {
    names.push_back(difference.column);
  }
  names.insert(names.end(), {"law", "pressure", "state", "status"});
  for (const Quantity& quantity : columns) {
    names.emplace_back(quantity.name);
  }
  return with_beside(names, beside);
}

void write_cells(cli::RowWriter& to, const NamedJoint& joint,
                 std::span<const Quantity> columns, const Answer& a,
                 std::size_t row, const Beside& beside) {
  cli::write_differences(joint.differences, to);
  to.text(joint.law);
  to.text(joint.pressure);
  to.text(state_text(a));
  to.text(status_text(a.solution.status));
  for (const Quantity& quantity : columns) {
    write_number(to, quantity.of(a), quantity.name, row, beside);
  }
}

Problems write_solutions(const Setup& setup, const Inputs& inputs,
                         const Beside& beside,
                         const cli::OutputOptions& options,
                         const std::function<void()>& begin) {
  const std::vector<Quantity> columns = quantities_of(setup, inputs);
  const std::size_t joints = setup.joints.size();
  cli::Output output(options.output);
  const cli::Table table(options,
                         solution_columns(setup.joints[0], columns, beside));
  begin();
  cli::NumberedRows rows(inputs.size() * joints);
  Problems problems;
  cli::write_rows<Block>(
      options, output, table, rows, "rows",
      [&](Block& block, cli::RowWriter& row) {
        block.problems = {};
        for (std::size_t i = block.first; i < block.last; ++i) {
          const NamedJoint& joint = setup.joints[i % joints];
          const Answer a = answer(joint, inputs.question(), inputs[i / joints]);
          block.problems.add(a, i % joints);
          write_cells(row, joint, columns, a, i + 1, beside);
          row.end();
        }
      },
      [&](const Block& block) { problems.add(block.problems); });
  return problems;
}

Problems write_summary(const Setup& setup, const Inputs& inputs,
                       const Beside& beside, const cli::OutputOptions& options,
                       const std::function<void()>& begin) {
  const NamedJoint& joint = setup.joints[0];
  std::vector<std::string> columns = {"quantity", "value"};
  if (!beside.empty()) columns.emplace_back("value_printed");
  columns.emplace_back("meaning");

  cli::Output output(options.output);
  const cli::Table table(options, columns);
  begin();
  const Answer a = answer(joint, inputs.question(), inputs[0]);
  cli::TableWriter writer(output, table);
  cli::Text rows;
  cli::RowWriter row(table, rows);
  const auto text_row = [&](std::string_view name, std::string_view value,
                            std::string_view meaning) {
    row.text(name);
    row.text(value);
    if (!beside.empty()) row.empty();
    row.text(meaning);
    row.end();
  };
  text_row("law", joint.law, "half-angle law");
  text_row("pressure", joint.pressure, "pressure law");
  text_row("state", state_text(a), "");
  text_row("status", status_text(a.solution.status), "of the solver");
  for (const Quantity& quantity : quantities_of(setup, inputs)) {
    row.text(quantity.name);
    row.number(quantity.of(a) + 0.0);  // no -0
    if (!beside.empty()) row.number(beside.at(1, quantity.name));
    row.text(quantity.meaning);
    row.end();
  }
  writer.write(rows.view());
  writer.finish();
  output.commit();
  Problems problems;
  problems.add(a, 0);
  return problems;
}

}  // namespace hinge_joint
