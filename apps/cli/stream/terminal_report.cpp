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
constexpr std::size_t most_lines = 12;
constexpr std::size_t most_columns = 6;

std::string left(std::string_view text, std::size_t width) {
  const std::size_t own = terminal_width(text);
  return std::string(text) + std::string(width - std::min(width, own), ' ');
}

std::string right(std::string_view text, std::size_t width) {
  const std::size_t own = terminal_width(text);
  return std::string(width - std::min(width, own), ' ') + std::string(text);
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
           return std::ranges::any_of(report_rows, [&](const ReportRow& row) {
             return middle(name, row.column).has_value();
           });
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
  }
  if (rows_.size() < first_rows && !is_table_) return {};
  return table_rows();
}

std::string TerminalReport::rest() {
  std::string text;
  if (!is_table_ && rows_.size() == 1) {
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
  return Line{fmt::format("{}{}", of.label, *middle(names_[at], of.column)),
              with_unit(row[at], names_[at]), beside};
}

// Any column; words get their colour.
std::optional<TerminalReport::Line> TerminalReport::plain_line(
    std::size_t at, const Row& row) const {
  if (row[at].empty()) return std::nullopt;
  return Line{spaced(shown_unit(names_[at]).stem),
              shown(with_unit(row[at], names_[at]), row[at], style_.colour),
              ""};
}

std::vector<TerminalReport::Line> TerminalReport::chosen_lines(
    const Row& row) const {
  std::vector<Line> chosen;
  for (const ReportRow& of : report_rows) {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (!middle(names_[i], of.column) || chosen.size() == most_lines)
        continue;
      if (auto found = line(of, i, row)) chosen.push_back(*std::move(found));
    }
  }
  if (chosen.size() < 2) return {};
  // A verdict, or a status other than the usual one.
  for (const char* word : {"state", "status", "contact_state"}) {
    const std::size_t at = place_of(word, names_);
    if (at == names_.size() || row[at] == "ok" || row[at] == "clearance") {
      continue;
    }
    if (auto found = plain_line(at, row)) chosen.push_back(*std::move(found));
  }
  return chosen;
}

std::string TerminalReport::lines(const Row& row) const {
  std::vector<Line> all;
  if (!style_.all) all = chosen_lines(row);
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
std::string TerminalReport::shown_cell(const Row& row, std::size_t at,
                                       const ShownUnit& unit) const {
  const std::size_t quantity = place_of("quantity", names_);
  if (at == quantity) return spaced(shown_unit(row[at]).stem);
  const auto number = parse_number(row[at]);
  if (!number) return row[at];
  return quantity < names_.size() ? with_unit(row[at], row[quantity])
                                  : unit.text(*number);
}

// Columns before the known ones are differences of joints; they are shown.
void TerminalReport::begin_table() {
  is_table_ = true;
  const auto known = [this](std::size_t at) {
    return std::ranges::any_of(report_rows, [&](const ReportRow& row) {
      return row.in_tables && middle(names_[at], row.column);
    });
  };
  const auto constant = [this](std::size_t at) {
    return std::ranges::all_of(
        rows_, [&](const Row& row) { return row[at] == rows_[0][at]; });
  };
  std::vector<std::size_t> matter;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (known(i) || names_[i] == "b_deg") matter.push_back(i);
  }
  if (style_.all || matter.size() < 2) {
    const std::size_t most =
        style_.all ? names_.size() : std::min(names_.size(), 2 * most_columns);
    for (std::size_t i = 0; i < most; ++i) shown_.push_back(i);
  } else {
    for (std::size_t i = 0; i < matter[0]; ++i) {
      const bool is_word = names_[i] == "status" || names_[i] == "residual" ||
                           names_[i] == "evaluations";
      if (!is_word && !constant(i)) shown_.push_back(i);
    }
    for (const std::size_t i : matter) {
      const bool is_beta = names_[i] == "b_deg" && constant(i);
      if (shown_.size() < most_columns + 1 && !is_beta) shown_.push_back(i);
    }
    const std::size_t status = place_of("status", names_);
    if (status < names_.size() &&
        !(constant(status) && rows_[0][status] == "ok")) {
      shown_.push_back(status);
    }
  }
  for (const std::size_t i : shown_) {
    double largest = 0;
    for (const Row& row : rows_) {
      const auto number = parse_number(row[i]);
      if (number && std::isfinite(*number)) {
        largest = std::max(largest, std::abs(*number));
      }
    }
    ShownUnit unit = shown_unit(names_[i]).scaled(largest);
    std::size_t width = 0;
    bool has_number = false;
    for (const Row& row : rows_) {
      has_number = has_number || parse_number(row[i]);
      width = std::max(width, terminal_width(shown_cell(row, i, unit)));
    }
    const std::string head =
        unit.stem + (unit.symbol.empty() ? "" : ", " + unit.symbol);
    widths_.push_back(std::max(width, terminal_width(head)));
    has_number_.push_back(has_number);
    units_.push_back(std::move(unit));
  }
}

std::string TerminalReport::table_rows() {
  if (rows_.empty()) return {};
  std::string text;
  empty_ = false;
  const auto end_line = [&text] {
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  };
  if (!is_table_) {
    begin_table();
    if (!style_.title.empty()) text = style_.title + "\n\n";
    for (std::size_t c = 0; c < shown_.size(); ++c) {
      const std::string& symbol = units_[c].symbol;
      const std::string head =
          units_[c].stem + (symbol.empty() ? "" : ", " + symbol);
      text += "  " + (has_number_[c] ? right(head, widths_[c])
                                     : left(head, widths_[c]));
    }
    end_line();
  }
  for (const Row& row : rows_) {
    for (std::size_t c = 0; c < shown_.size(); ++c) {
      const std::string cell = shown_cell(row, shown_[c], units_[c]);
      const std::size_t width = widths_[c];
      text +=
          "  " + shown(has_number_[c] ? right(cell, width) : left(cell, width),
                       row[shown_[c]], style_.colour);
    }
    end_line();
  }
  rows_.clear();
  return text;
}

}  // namespace cli
