#include "cli/joint/joint_reports.hpp"

#include "libcontact/base/complaint.hpp"

namespace cli {
namespace {

// Calls a function with the column and the cell of each number of a report, and
// of the numbers beside it.
template <class Call>
void for_cells(const Report& report, const Call& call) {
  const std::vector<std::string> columns = report.columns();
  for (const Report::Line& line : report.lines()) {
    call(line.name, line.value);
    for (std::size_t i = 0; i < line.beside.size(); ++i) {
      if (std::holds_alternative<std::monostate>(line.beside[i])) continue;
      call(line.name + '_' + columns[i + 2], line.beside[i]);
    }
  }
}

}  // namespace

void write_reports(const std::vector<Joint>& joints,
                   const std::vector<Report>& reports, Output& output,
                   const TableStyle& plain) {
  const TableStyle style = plain.titled(shared_title(joints, ""));
  if (joints.size() == 1) {
    reports[0].write(output, style);
    return;
  }
  std::vector<std::vector<std::string>> columns;
  for (const Report& report : reports) {
    std::vector<std::string>& names = columns.emplace_back();
    for_cells(report, [&](const std::string& name, const Cell&) {
      names.push_back(name);
    });
  }
  write_table(style, joint_columns(joints, columns), output,
              [&](RowWriter& row) {
                for (std::size_t i = 0; i < joints.size(); ++i) {
                  write_differences(joints[i].differences, row);
                  for_cells(reports[i], [&](const std::string&, const Cell& c) {
                    write_cell(c, row);
                  });
                  row.end();
                }
              });
}

std::string said_of(const Joint& joint, const std::string& text) {
  return joint.among_several.empty() ? text : joint.among_several + ": " + text;
}

void check_one_kind(const std::vector<Joint>& joints) {
  for (const Joint& joint : joints) {
    if (joint.kind() == joints[0].kind()) continue;
    throw contact::Error(contact::detail::must_be(
        "the joints of --joint",
        "all balls or all pins, as they share a file"));
  }
}

}  // namespace cli
