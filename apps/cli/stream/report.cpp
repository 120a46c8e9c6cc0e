#include "cli/stream/report.hpp"

#include <algorithm>
#include <utility>

namespace cli {

void write_cell(const Cell& cell, RowWriter& row) {
  if (const auto* number = std::get_if<double>(&cell)) {
    row.number(*number + 0.0);  // no -0
  } else if (const auto* count = std::get_if<std::size_t>(&cell)) {
    row.count(*count);
  } else if (const auto* text = std::get_if<std::string>(&cell)) {
    row.text(*text);
  } else {
    row.empty();
  }
}

double Report::number(std::string_view name) const {
  return std::get<double>(std::ranges::find(lines_, name, &Line::name)->value);
}

std::vector<std::string> Report::columns() const {
  std::vector<std::string> names = {"quantity", "value"};
  for (const Beside& column : beside_) names.push_back(column.name);
  names.emplace_back("meaning");
  return names;
}

void Report::write_for_people(Output& output, const TableStyle& style) const {
  std::vector<std::string> names;
  for (const Line& line : lines_) names.push_back(line.name);
  if (!has_report_lines(names)) {
    TableStyle shown = style;
    shown.columns = columns();
    shown.columns.pop_back();  // --all prints the meaning
    return write_lines(output, style.report.all ? style : shown);
  }
  write_table(style, names, output, [this](RowWriter& row) {
    for (const Line& line : lines_) write_cell(line.value, row);
    row.end();
  });
}

void Report::write(Output& output, const TableStyle& style) const {
  if (style.format == Format::report && style.columns.empty()) {
    return write_for_people(output, style);
  }
  write_lines(output, style);
}

void Report::write_lines(Output& output, const TableStyle& style) const {
  std::vector<std::string> of_quantity = {"value"};
  for (const Beside& column : beside_) {
    if (column.has_unit_of_value) of_quantity.push_back(column.name);
  }
  const TableStyle shown = style.of_quantity(std::move(of_quantity));
  write_table(shown, columns(), output, [this](RowWriter& row) {
    for (const Line& line : lines_) {
      row.text(line.name);
      write_cell(line.value, row);
      for (const Cell& cell : line.beside) write_cell(cell, row);
      for (std::size_t i = line.beside.size(); i < beside_.size(); ++i) {
        row.empty();
      }
      row.text(line.meaning);
      row.end();
    }
  });
}

}  // namespace cli
