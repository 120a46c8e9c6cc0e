#include "cli/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include "cli/number.hpp"
#include "cli/stream/csv.hpp"
#include "cli/stream/quoting.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace cli {
namespace {

constexpr int printed_digits = 4;

// A quoted JSON string; bytes that are not UTF-8 are replaced.
std::string json_text(std::string_view value) {
  return nlohmann::json(value).dump(-1, ' ', false,
                                    nlohmann::json::error_handler_t::replace);
}

// -1.234e-07 as $-1.234\cdot10^{-7}$
std::string latex_number(double value) {
  if (std::isinf(value)) return value > 0 ? "$\\infty$" : "$-\\infty$";
  std::string text = rounded_text(value, printed_digits);
  if (text == "-") return text;
  const std::size_t e = text.find('e');
  if (e != std::string::npos) {
    text = fmt::format("{}\\cdot10^{{{}}}", text.substr(0, e),
                       std::stoi(text.substr(e + 1)));
  }
  return '$' + text + '$';
}

// Cells of markdown are padded to the width of usual numbers.
std::string padded(const std::string& cell, const std::string& name) {
  const std::size_t width = std::max(name.size(), std::string("0.1234").size());
  return fmt::format("{:>{}}", cell, width);
}

// The column that is probably meant: the most similar name, or the shortest one
// that continues it with a unit, such as M_t_N_m for M_t.
std::string near_column(const std::string& name,
                        const std::vector<std::string>& names) {
  std::string near = contact::detail::nearest(name, names);
  if (!near.empty()) return near;
  for (const std::string& column : names) {
    if (column.starts_with(name + '_') &&
        (near.empty() || column.size() < near.size())) {
      near = column;
    }
  }
  return near;
}

// Indices of the names asked for, in that order; all if none is given.
std::vector<std::size_t> shown(const std::vector<std::string>& asked,
                               const std::vector<std::string>& names) {
  std::vector<std::size_t> places(asked.empty() ? names.size() : 0);
  std::iota(places.begin(), places.end(), 0);
  for (const std::string& name : asked) {
    const auto place = std::ranges::find(names, name) - names.begin();
    if (place == std::ssize(names)) {
      // List all names only if none is similar.
      const std::string near = near_column(name, names);
      throw contact::Error(contact::detail::unknown(
          "column", name, near,
          near.empty() ? names : std::vector<std::string>()));
    }
    places.push_back(static_cast<std::size_t>(place));
  }
  return places;
}

std::string shown_name(const std::string& name, const TableStyle& style) {
  switch (style.format) {
    case Format::csv:
      return raw_field(name, style.separator);
    case Format::json:
      return json_text(name);
    case Format::markdown:
      return markdown_text(name);
    case Format::report:
      return contact::detail::printable(name, name.npos);
    case Format::latex:
      break;
  }
  return latex_text(name);
}

// Width of a row of Markdown, estimated from the names.
std::size_t width_of(const std::vector<std::string>& names) {
  std::size_t width = 1;
  for (const std::string& name : names) width += padded("", name).size() + 3;
  return width;
}

}  // namespace

Table::Table(TableStyle style, std::vector<std::string> column_names)
    : style_(std::move(style)),
      names_(std::move(column_names)),
      shown_(shown(style_.columns, names_)) {
  style_.report.chosen = !style_.columns.empty();
  for (std::string& name : names_) name = shown_name(name, style_);
  collected_ = style_.format == Format::report ||
               (style_.format >= Format::markdown &&
                width_of(shown_names()) > TurnedTable::widest);
  set_marks();
}

void Table::set_marks() {
  if (collected_) {
    before_.assign(shown_.size(), "");
    return;
  }
  const auto marks = [this](std::string_view first, std::string_view later,
                            std::string_view end) {
    before_.assign(shown_.size(), std::string(later));
    before_[0] = first;
    end_of_row_ = end;
  };
  switch (style_.format) {
    case Format::csv:
      return marks("", std::string(1, style_.separator), "\n");
    case Format::json:
      marks(",\n{", ",", "}");
      for (std::size_t i = 0; i < shown_.size(); ++i) {
        before_[i] += names_[shown_[i]] + ":";
      }
      return;
    case Format::markdown:
      return marks("| ", " | ", " |\n");
    case Format::latex:
      return marks("", " & ", " \\\\\n");
    case Format::report:
      return;  // collected
  }
}

std::vector<std::string> Table::shown_names() const {
  std::vector<std::string> names;
  for (const std::size_t column : shown_) names.push_back(names_[column]);
  return names;
}

std::string Table::header() const {
  if (style_.format == Format::json) return "[";
  if (collected_) return {};
  std::string text;
  if (style_.format == Format::latex) {
    text =
        "\\begin{tabular}{" + std::string(shown_.size(), 'r') + "}\n\\hline\n";
  }
  const auto names = shown_names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += before_[i];
    text += style_.format == Format::markdown ? padded(names[i], "") : names[i];
  }
  text += end_of_row_;
  if (style_.format == Format::latex) text += "\\hline\n";
  if (style_.format == Format::markdown) {
    for (const std::string& name : names) {
      text += "| " + std::string(padded("", name).size() - 1, '-') + ": ";
    }
    text += "|\n";
  }
  return text;
}

std::string Table::footer() const {
  if (style_.format == Format::json) return "\n]\n";
  if (collected_ || style_.format != Format::latex) return {};
  return "\\hline\n\\end{tabular}\n";
}

Text& RowWriter::begin_cell() {
  const std::size_t column = column_++;
  if (picks_) {
    starts_.push_back(cells_.view().size());
    return cells_;
  }
  text_.append(table_.before_[column]);
  return text_;
}

void RowWriter::number(double value) {
  const TableStyle& style = table_.style_;
  if (style.format == Format::report) {
    return std::isnan(value) ? printed("") : printed(number_text(value));
  }
  if (style.format >= Format::markdown) {
    return printed(style.format == Format::latex
                       ? latex_number(value)
                       : rounded_text(value, printed_digits));
  }
  if (std::isnan(value)) return empty();
  if (std::isinf(value) && style.format == Format::json) {
    return text(number_text(value));
  }
  Text& cell = begin_cell();
  char* const begin = cell.reserve(longest_number);
  char* const end = write_number(begin, value);
  if (style.decimal_comma) std::replace(begin, end, '.', ',');
  cell.end_at(end);
}

void RowWriter::count(std::size_t value) {
  const std::string text = std::to_string(value);
  if (table_.style_.format >= Format::markdown) return printed(text);
  begin_cell().append(text);
}

void RowWriter::empty() {
  if (table_.style_.format == Format::report) return printed("");
  if (table_.style_.format >= Format::markdown) return printed("-");
  Text& cell = begin_cell();
  if (table_.style_.format == Format::json) cell.append("null");
}

void RowWriter::text(std::string_view value) {
  switch (table_.style_.format) {
    case Format::csv:
      begin_cell().append(raw_field(value, table_.style_.separator));
      break;
    case Format::json:
      begin_cell().append(json_text(value));
      break;
    case Format::markdown:
      printed(markdown_text(value));
      break;
    case Format::latex:
      printed(latex_text(value));
      break;
    case Format::report:
      printed(contact::detail::printable(value, value.npos));
      break;
  }
}

void RowWriter::field(std::string_view raw, CsvForm form) {
  const TableStyle& style = table_.style_;
  const bool is_csv = style.format == Format::csv;
  if (is_csv &&
      form == CsvForm{style.separator, style.decimal_comma ? ',' : '.'}) {
    begin_cell().append(raw);
    return;
  }
  std::string value = field_value(raw, form);
  if (is_csv && style.decimal_comma && parse_number(value)) {
    std::ranges::replace(value, '.', ',');
  }
  text(value);
}

void RowWriter::printed(std::string_view cell) {
  const std::string& name = table_.names_[column_];
  Text& text = begin_cell();
  if (table_.collected_) {
    text.append(cell);
    text.append(TurnedTable::end_of_cell);
  } else if (table_.style_.format == Format::markdown) {
    text.append(padded(std::string(cell), name));
  } else {
    text.append(cell);
  }
}

void RowWriter::end() {
  assert(column_ == table_.names_.size());
  if (picks_) {
    starts_.push_back(cells_.view().size());
    for (std::size_t i = 0; i < table_.shown_.size(); ++i) {
      const std::size_t cell = table_.shown_[i];
      text_.append(table_.before_[i]);
      text_.append(cells_.view().substr(starts_[cell],
                                        starts_[cell + 1] - starts_[cell]));
    }
    starts_.clear();
    cells_.clear();
  }
  text_.append(table_.end_of_row_);
  column_ = 0;
}

TableWriter::TableWriter(Output& output, const Table& table)
    : output_(output), table_(table) {
  if (table.style().format == Format::report) {
    report_.emplace(table.shown_names(), table.style().report);
  } else if (table.is_turned()) {
    turned_.emplace(table.shown_names(), table.style().format == Format::latex);
  }
  output_.write(table_.header());
}

void TableWriter::write(std::string_view rows) {
  if (rows.empty()) return;
  if (turned_) return output_.write(turned_->add(rows));
  if (report_) return output_.write_coloured(report_->add(rows));
  // Every JSON row starts with the comma that ends the row before it.
  if (first_ && table_.style().format == Format::json) rows.remove_prefix(1);
  first_ = false;
  output_.write(rows);
}

void TableWriter::finish() {
  if (turned_) output_.write(turned_->rest());
  if (report_) output_.write_coloured(report_->rest());
  output_.write(table_.footer());
}

std::vector<std::string> distinct_names(std::vector<std::string> names,
                                        const std::vector<std::string>& taken) {
  std::unordered_set<std::string> all(taken.begin(), taken.end());
  // Number of changes for each name, so that no suffix is tried twice.
  std::unordered_map<std::string, std::size_t> changes;
  for (std::string& name : names) {
    const std::string given = name;
    while (!all.insert(name).second) {
      const std::size_t number = ++changes[given];
      name = given + (number == 1 ? "_in" : fmt::format("_in{}", number));
    }
  }
  return names;
}

}  // namespace cli
