#include "programs/joint/solution_table.hpp"

#include <algorithm>

#include "cli/output.hpp"
#include "cli/stream/report.hpp"
#include "cli/stream/row_blocks.hpp"

namespace hinge_joint {
namespace {

// A block of rows that the program works on.
struct Block : cli::RowBlock {
  Problems problems;
};

contact::LoadDirection direction_of(const Answer& answer) {
  using enum contact::LoadDirection;
  if (answer.question == Question::contact) return none;
  return answer.given ? angle : vector;
}

std::vector<AnswerColumn> columns_of(const Setup& setup, const Inputs& inputs) {
  return answer_columns(
      {.rest = inputs.question() == Question::rest,
       .approach = setup.has_approach(),
       .preload = setup.has_preload(),
       .friction = setup.friction_found,
       .pv = setup.joints[0].pv,
       .rims = setup.has_any(std::mem_fn(&NamedJoint::has_rims)),
       .lie = setup.has_any([](const NamedJoint& j) { return j.ends; }),
       .place = inputs.is_placed()});
}

}  // namespace

void Problems::add(const Answer& answer, const NamedJoint& joint,
                   std::size_t number) {
  const contact::JointSolution& s = answer.solution();
  if (s.status == contact::Status::out_of_range) ++out_of_range;
  if (s.status == contact::Status::not_converged) ++not_converged;
  if (s.status == contact::Status::out_of_seat) ++out_of_seat;
  notes.resize(std::max(notes.size(), number + 1));
  notes[number].add(joint.joint, s, direction_of(answer));
}

void Problems::add(const Problems& more) {
  out_of_range += more.out_of_range;
  not_converged += more.not_converged;
  out_of_seat += more.out_of_seat;
  bad_lines += more.bad_lines;
  notes.resize(std::max(notes.size(), more.notes.size()));
  for (std::size_t i = 0; i < more.notes.size(); ++i) {
    notes[i].add(more.notes[i]);
  }
}

std::vector<std::string> solution_columns(const NamedJoint& joint,
                                          std::span<const AnswerColumn> columns,
                                          const Beside& beside) {
  std::vector<std::string> names;
  for (const cli::Difference& difference : joint.differences) {
    names.push_back(difference.column);
  }
  names.insert(names.end(), {"law", "pressure", "state", "status"});
  if (have_preload(columns)) names.emplace_back("contact_state");
  for (const AnswerColumn& column : columns) {
    names.push_back(column.name);
  }
  return with_beside(names, beside);
}

void write_cells(cli::RowWriter& to, const NamedJoint& joint,
                 std::span<const AnswerColumn> columns, const Answer& a,
                 std::size_t row, const Beside& beside) {
  cli::write_differences(joint.differences, to);
  to.text(joint.law);
  to.text(joint.pressure);
  to.text(state_text(a));
  to.text(to_string(a.solution().status));
  if (have_preload(columns)) to.text(contact_state_text(a));
  for (const AnswerColumn& column : columns) {
    write_number(to, column(a), column.name, row, beside);
  }
}

Problems write_solutions(const Setup& setup, const Inputs& inputs,
                         const Beside& beside,
                         const cli::OutputOptions& options,
                         const std::function<void()>& begin) {
  const std::vector<AnswerColumn> columns = columns_of(setup, inputs);
  const std::size_t joints = setup.joints.size();
  cli::Output output(options.output);
  const cli::Table table(options.titled(shared_title(setup.given, "")),
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
          block.problems.add(a, joint, i % joints);
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
  std::vector<cli::Report::Beside> printed;
  if (!beside.empty()) printed.push_back({"value_printed", true});
  cli::Output output(options.output);
  // Checks the requested columns before the work.
  const cli::Table table(options, cli::Report(printed).columns());
  begin();
  const Answer a = answer(joint, inputs.question(), inputs[0]);
  cli::Report report(printed);
  report.add("law", joint.law, "half-angle law");
  report.add("pressure", joint.pressure, "pressure law");
  report.add("state", std::string(state_text(a)), "");
  report.add("status", std::string(to_string(a.solution().status)),
             "of the solver");
  if (setup.has_preload()) {
    report.add("contact_state", std::string(contact_state_text(a)),
               "state of the contact by clearance and load");
  }
  for (const AnswerColumn& column : columns_of(setup, inputs)) {
    std::vector<cli::Cell> cells;
    if (!beside.empty()) cells = {beside.at(1, column.name)};
    report.add(column.name, column(a), column.meaning, cells);
  }
  report.write(output, options.titled(shared_title(setup.given, "")));
  output.commit();
  Problems problems;
  problems.add(a, joint, 0);
  return problems;
}

}  // namespace hinge_joint
