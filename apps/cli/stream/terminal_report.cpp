#include "cli/stream/terminal_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "cli/number.hpp"
#include "cli/stream/quoting.hpp"
#include "cli/stream/verdict.hpp"
#include "libcontact/base/text.hpp"

namespace cli {
namespace {

// Number of rows that decide the units and widths of a table.
constexpr std::size_t first_rows = 200;
constexpr std::size_t most_lines = 16;
// Heads are not broken to be narrower.
constexpr std::size_t least_head = 8;

std::string left(std::string_view text, std::size_t width) {
  const std::size_t own = terminal_width(text);
  return std::string(text) + std::string(width - std::min(width, own), ' ');
}

std::string right(std::string_view text, std::size_t width) {
  const std::size_t own = terminal_width(text);
  return std::string(width - std::min(width, own), ' ') + std::string(text);
}

std::string placed(std::string_view text, std::size_t width, bool to_right) {
  return to_right ? right(text, width) : left(text, width);
}

// A column that says how a row was computed.
bool is_word(std::string_view name) {
  return name == "status" || name == "residual" || name == "evaluations";
}

// The text matched by the * of the pattern; none if the name does not match.
std::optional<std::string> middle(std::string_view name,
                                  std::string_view pattern) {
  const auto star = pattern.find('*');
  if (star == pattern.npos) {
    if (name != pattern) return std::nullopt;
    return "";
  }
  const std::string_view begin = pattern.substr(0, star);
  const std::string_view end = pattern.substr(star + 1);
  if (name.size() < begin.size() + end.size() || !name.starts_with(begin) ||
      !name.ends_with(end)) {
    return std::nullopt;
  }
  std::string law(
      name.substr(begin.size(), name.size() - begin.size() - end.size()));
  if (!law.empty() && law[0] != '_') return std::nullopt;
  std::ranges::replace(law, '_', ' ');
  return law.empty() ? "" : " (" + law.substr(1) + ')';
}

// The row of the report on a column; null if there is none.
const ReportRow* row_of(std::string_view column) {
  const auto* found =
      std::ranges::find_if(report_rows, [&](const ReportRow& row) {
        return middle(column, row.column).has_value();
      });
  return found == std::end(report_rows) ? nullptr : found;
}

std::string label_of(const ReportRow& row, std::string_view column) {
  return fmt::format("{}{}", row.label, *middle(column, row.column));
}

std::string head_of(const ShownUnit& unit) {
  return unit.stem + (unit.symbol.empty() ? "" : ", " + unit.symbol);
}

// The lines of a head whose column has numbers of some width: it is broken
// within its name, and before its unit.
std::vector<std::string> broken_head(const ShownUnit& unit, std::size_t width) {
  std::vector<std::string> pieces(1);
  for (const char c : unit.stem) {
    pieces.back() += c;
    if (c == '_' || c == '.' || c == ' ') pieces.emplace_back();
  }
  if (!unit.symbol.empty()) {
    pieces.back() += ", ";
    pieces.push_back(unit.symbol);
  }
  width = std::max(width, least_head);
  std::vector<std::string> lines;
  for (const std::string& piece : pieces) {
    const std::size_t with = lines.empty() ? 0 : terminal_width(lines.back());
    const auto end = piece.find_last_not_of(' ') + 1;
    if (!lines.empty() &&
        with + terminal_width(piece.substr(0, end)) <= width) {
      lines.back() += piece;
    } else {
      lines.push_back(piece);
    }
  }
  for (std::string& line : lines) line.erase(line.find_last_not_of(' ') + 1);
  return lines;
}

std::size_t widest(const std::vector<std::string>& lines) {
  std::size_t width = 0;
  for (const std::string& line : lines) {
    width = std::max(width, terminal_width(line));
  }
  return width;
}

void end_line(std::string& text) {
  text.erase(text.find_last_not_of(' ') + 1);
  text += '\n';
}

std::size_t place_of(std::string_view name,
                     const std::vector<std::string>& names) {
  return static_cast<std::size_t>(std::ranges::find(names, name) -
                                  names.begin());
}

// The number of a cell with its unit; "" for an empty cell.
std::string with_unit(std::string_view cell, std::string_view column) {
  const auto number = parse_number(cell);
  if (!number || std::isnan(*number)) return std::string(cell);
  const ShownUnit unit = shown_unit(column).scaled(*number);
  const std::string text = unit.text(*number);
  if (unit.symbol.empty()) return text;
  return text + (unit.symbol == "°" ? "" : " ") + unit.symbol;
}

std::string spaced(std::string text) {
  std::ranges::replace(text, '_', ' ');
  return text;
}

std::string shown(const std::string& padded, std::string_view word,
                  bool colour) {
  return colour ? coloured(padded, word) : padded;
}

}  // namespace

bool has_report_lines(std::span<const std::string> names) {
  return std::ranges::count_if(names, [](const std::string& name) {
           return row_of(name) != nullptr;
         }) > 1;
}

TerminalReport::TerminalReport(std::vector<std::string> names, Style style)
    : names_(std::move(names)), style_(std::move(style)) {
  // Names in files must not control the terminal.
  style_.title = contact::detail::printable(style_.title, style_.title.npos);
}

std::string TerminalReport::add(std::string_view cells) {
  while (!cells.empty()) {
    Row& row = rows_.emplace_back();
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const std::size_t end = cells.find(end_of_cell);
      row.emplace_back(cells.substr(0, end));
      cells.remove_prefix(end + 1);
    }
    if (!says_something(row)) rows_.pop_back();
  }
  if (rows_.size() < first_rows && !is_table_) return {};
  return table_rows();
}

// False if none of the row's numbers of its quantity has a value.
bool TerminalReport::says_something(const Row& row) const {
  bool has_place = false;
  for (const std::string& name : style_.of_quantity) {
    const std::size_t at = place_of(name, names_);
    if (at == names_.size()) continue;
    if (!row[at].empty()) return true;
    has_place = true;
  }
  return !has_place;
}

std::string TerminalReport::rest() {
  std::string text;
  if (!is_table_ && rows_.size() == 1 && !style_.always_table) {
    text = lines(rows_[0]);
    rows_.clear();
    empty_ = false;
  } else {
    text = table_rows();
  }
  if (!style_.more.empty() && !empty_) text += "\nmore: " + style_.more + '\n';
  return text;
}

// "  friction torque      10.79 N m      textbook f0 R r: 8 N m (+34.8 %)"
std::optional<TerminalReport::Line> TerminalReport::line(const ReportRow& of,
                                                         std::size_t at,
                                                         const Row& row) const {
  const auto number = parse_number(row[at]);
  if (!number || std::isnan(*number)) return std::nullopt;
  std::string beside;
  for (const ReportPart& part : of.beside) {
    const std::size_t place = place_of(part.column, names_);
    if (place == names_.size() || row[place].empty()) continue;
    beside += fmt::format("{}{} {}", beside.empty() ? "" : ", ", part.label,
                          with_unit(row[place], part.column));
    const auto other = parse_number(row[place]);
    if (part.compares && other && *other != 0) {
      beside += fmt::format(" ({:+.3g} %)", 100 * (*number / *other - 1));
    }
  }
  return Line{label_of(of, names_[at]), with_unit(row[at], names_[at]), beside};
}

// Any column; words get their colour.
std::optional<TerminalReport::Line> TerminalReport::plain_line(
    std::size_t at, const Row& row) const {
  if (row[at].empty()) return std::nullopt;
  return Line{spaced(shown_unit(names_[at]).stem),
              shown(with_unit(row[at], names_[at]), row[at], style_.colour),
              ""};
}

// A column that the user named, also without a value.
TerminalReport::Line TerminalReport::chosen_line(std::size_t at,
                                                 const Row& row) const {
  Line chosen = plain_line(at, row).value_or(
      Line{spaced(shown_unit(names_[at]).stem), "-", ""});
  if (const ReportRow* of = row_of(names_[at])) {
    chosen.label = label_of(*of, names_[at]);
  }
  return chosen;
}

std::vector<TerminalReport::Line> TerminalReport::important_lines(
    const Row& row) const {
  std::vector<Line> lines;
  for (const ReportRow& of : report_rows) {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (!middle(names_[i], of.column) || lines.size() == most_lines) continue;
      if (auto found = line(of, i, row)) lines.push_back(*std::move(found));
    }
  }
  if (lines.size() < 2) return {};
  // A verdict, or a status other than the usual one.
  for (const char* word : {"state", "status", "contact_state"}) {
    const std::size_t at = place_of(word, names_);
    if (at == names_.size() || row[at] == "ok" || row[at] == "clearance") {
      continue;
    }
    if (auto found = plain_line(at, row)) lines.push_back(*std::move(found));
  }
  return lines;
}

std::string TerminalReport::lines(const Row& row) const {
  std::vector<Line> all;
  if (style_.chosen) {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      all.push_back(chosen_line(i, row));
    }
  } else if (!style_.all) {
    all = important_lines(row);
  }
  const std::size_t most = style_.all ? names_.size() : most_lines;
  if (all.empty()) {
    for (std::size_t i = 0; i < names_.size() && all.size() < most; ++i) {
      if (auto found = plain_line(i, row)) all.push_back(*std::move(found));
    }
  }
  std::size_t label = 0;
  std::size_t value = 0;
  for (const Line& each : all) {
    label = std::max(label, terminal_width(each.label));
    if (!each.beside.empty())
      value = std::max(value, terminal_width(each.value));
  }
  std::string text = style_.title.empty() ? "" : style_.title + "\n\n";
  for (const Line& each : all) {
    text += fmt::format(
        "  {}  {}", left(each.label, label),
        each.beside.empty() ? each.value : left(each.value, value + 3));
    text += each.beside + '\n';
  }
  return text;
}

// A number in the unit of its column, or of the quantity of its row.
std::string TerminalReport::shown_cell(const Row& row,
                                       const Column& column) const {
  const std::size_t quantity =
      style_.of_quantity.empty() ? names_.size() : place_of("quantity", names_);
  const std::string& cell = row[column.at];
  if (column.at == quantity) return spaced(shown_unit(cell).stem);
  const auto number = parse_number(cell);
  if (!number) return cell;
  const bool has_own =
      quantity == names_.size() ||
      std::ranges::count(style_.of_quantity, names_[column.at]) == 0;
  return has_own ? column.unit.text(*number) : with_unit(cell, row[quantity]);
}

std::vector<TerminalReport::Column> TerminalReport::all_columns() const {
  const bool wanted =
      style_.all || style_.chosen || !style_.of_quantity.empty();
  std::vector<Column> all;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    all.push_back({.at = i, .rank = wanted ? 0 : i});
  }
  return all;
}

// Columns before the known ones are differences of joints; they are shown. Next
// come the numbers that an option asked for.
std::vector<TerminalReport::Column> TerminalReport::important_columns() const {
  const auto constant = [this](std::size_t at) {
    return std::ranges::all_of(
        rows_, [&](const Row& row) { return row[at] == rows_[0][at]; });
  };
  std::vector<Column> differences;
  std::vector<Column> asked;
  std::vector<Column> matter;
  bool is_known = false;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const ReportRow* row = row_of(names_[i]);
    const bool is_beta = names_[i] == "b_deg";
    const auto is = [row](ReportRow::Use use) {
      return row != nullptr && row->use == use;
    };
    if (is(ReportRow::Use::asked_for)) {
      asked.push_back({.at = i});
    } else if (is(ReportRow::Use::everywhere)) {
      matter.push_back({.at = i, .rank = 1 + std::size_t(row - report_rows)});
    } else if (is_beta && !constant(i)) {
      matter.push_back({.at = i});
    } else if (!is_known && !is_beta && !constant(i) && !is_word(names_[i])) {
      differences.push_back({.at = i});
    }
    is_known = is_known || is_beta || !asked.empty() || !matter.empty();
  }
  if (asked.size() + matter.size() < 2) return all_columns();
  std::vector<Column> all;
  for (const auto& part : {differences, asked, matter}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  const std::size_t status = place_of("status", names_);
  if (status < names_.size() &&
      !(constant(status) && rows_[0][status] == "ok")) {
    all.push_back({.at = status});
  }
  return all;
}

// Finds the unit and the width of the cells.
void TerminalReport::measure(Column& column) const {
  double largest = 0;
  for (const Row& row : rows_) {
    const auto number = parse_number(row[column.at]);
    if (number && std::isfinite(*number)) {
      largest = std::max(largest, std::abs(*number));
    }
  }
  column.unit = shown_unit(names_[column.at]).scaled(largest);
  for (const Row& row : rows_) {
    column.has_number = column.has_number || parse_number(row[column.at]);
    column.width =
        std::max(column.width, terminal_width(shown_cell(row, column)));
  }
  column.head = {head_of(column.unit)};
}

std::size_t TerminalReport::table_width() const {
  std::size_t all = 0;
  for (const Column& column : columns_) {
    all += 2 + std::max(column.width, widest(column.head));
  }
  return all;
}

void TerminalReport::begin_table() {
  is_table_ = true;
  columns_ = style_.all || style_.chosen ? all_columns() : important_columns();
  for (Column& column : columns_) measure(column);
  if (table_width() > widest_table) {
    for (Column& column : columns_) {
      column.head = broken_head(column.unit, column.width);
    }
  }
  while (table_width() > widest_table) {
    const auto last = std::ranges::max_element(columns_, {}, &Column::rank);
    if (last->rank == 0) break;
    columns_.erase(last);
  }
  for (Column& column : columns_) {
    column.width = std::max(column.width, widest(column.head));
  }
}

// Heads end at the same line.
std::string TerminalReport::heads() const {
  std::size_t most = 0;
  for (const Column& column : columns_) {
    most = std::max(most, column.head.size());
  }
  std::string text;
  for (std::size_t below = most; below > 0; --below) {
    for (const Column& column : columns_) {
      const std::size_t lines = column.head.size();
      text += "  " + placed(below > lines ? "" : column.head[lines - below],
                            column.width, column.has_number);
    }
    end_line(text);
  }
  return text;
}

std::string TerminalReport::table_rows() {
  if (rows_.empty()) return {};
  std::string text;
  empty_ = false;
  if (!is_table_) {
    begin_table();
    if (!style_.title.empty()) text = style_.title + "\n\n";
    text += heads();
  }
  for (const Row& row : rows_) {
    for (const Column& column : columns_) {
      text += "  " + shown(placed(shown_cell(row, column), column.width,
                                  column.has_number),
                           row[column.at], style_.colour);
    }
    end_line(text);
  }
  rows_.clear();
  return text;
}

}  // namespace cli
