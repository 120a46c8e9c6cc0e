#include "cli/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/number.hpp"
#include "cli/stream/csv.hpp"

namespace cli {
namespace {

constexpr int printed_digits = 4;

// A JSON string, quotes and all; bytes that are not UTF-8 are replaced.
std::string json_text(std::string_view value) {
  return nlohmann::json(value).dump(-1, ' ', false,
                                    nlohmann::json::error_handler_t::replace);
}

// Text that prints as itself.
std::string markdown_text(std::string_view value) {
  std::string text;
  for (const char c : value) {
    if (std::string_view("|\\`*<").find(c) != std::string_view::npos) {
      text += '\\';
    }
    text += c;
  }
  return text;
}

std::string latex_text(std::string_view value) {
  std::string text;
  for (const char c : value) {
    switch (c) {
      case '\\':
        text += "\\textbackslash{}";
        break;
      case '~':
        text += "\\textasciitilde{}";
        break;
      case '^':
        text += "\\textasciicircum{}";
        break;
      case '#':
      case '$':
      case '%':
      case '&':
      case '_':
      case '{':
      case '}':
        text += '\\';
        [[fallthrough]];
      default:
        text += c;
    }
  }
  return text;
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

}  // namespace

Table::Table(Format format, std::vector<std::string> column_names)
    : format_(format), names_(std::move(column_names)) {
  for (std::string& name : names_) {
    if (format == Format::csv) name = raw_field(name);
    if (format == Format::json) name = json_text(name);
    if (format == Format::markdown) name = markdown_text(name);
    if (format == Format::latex) name = latex_text(name);
    const bool first = before_.empty();
    switch (format) {
      case Format::csv:
        before_.push_back(first ? "" : ",");
        break;
      case Format::json:
        before_.push_back((first ? ",\n{" : ",") + name + ":");
        break;
      case Format::markdown:
        before_.push_back(first ? "| " : " | ");
        break;
      case Format::latex:
        before_.push_back(first ? "" : " & ");
        break;
    }
  }
  switch (format) {
    case Format::csv:
      end_of_row_ = "\n";
      break;
    case Format::json:
      end_of_row_ = "}";
      break;
    case Format::markdown:
      end_of_row_ = " |\n";
      break;
    case Format::latex:
      end_of_row_ = " \\\\\n";
      break;
  }
}

std::string Table::header() const {
  if (format_ == Format::json) return "[";
  std::string text;
  if (format_ == Format::latex) {
    text = "\\begin{tabular}{" + std::string(columns(), 'r') + "}\n\\hline\n";
  }
  for (std::size_t i = 0; i < columns(); ++i) {
    text += before_[i];
    text += format_ == Format::markdown ? padded(names_[i], "") : names_[i];
  }
  text += end_of_row_;
  if (format_ == Format::latex) text += "\\hline\n";
  if (format_ == Format::markdown) {
    for (const std::string& name : names_) {
      text += "| " + std::string(padded("", name).size() - 1, '-') + ": ";
    }
    text += "|\n";
  }
  return text;
}

std::string Table::footer() const {
  if (format_ == Format::json) return "\n]\n";
  if (format_ == Format::latex) return "\\hline\n\\end{tabular}\n";
  return {};
}

void RowWriter::number(double value) {
  if (table_.format_ >= Format::markdown) {
    return printed(table_.format_ == Format::latex
                       ? latex_number(value)
                       : rounded_text(value, printed_digits));
  }
  if (std::isnan(value)) return empty();
  if (std::isinf(value) && table_.format_ == Format::json) {
    return text(number_text(value));
  }
  const std::string& before = table_.before_[column_++];
  char* to = text_.reserve(before.size() + longest_number);
  to = std::copy(before.begin(), before.end(), to);
  text_.end_at(write_number(to, value));
}

void RowWriter::count(std::size_t value) {
  const std::string text = std::to_string(value);
  if (table_.format_ >= Format::markdown) return printed(text);
  text_.append(table_.before_[column_++]);
  text_.append(text);
}

void RowWriter::empty() {
  if (table_.format_ >= Format::markdown) return printed("-");
  text_.append(table_.before_[column_++]);
  if (table_.format_ == Format::json) text_.append("null");
}

void RowWriter::text(std::string_view value) {
  switch (table_.format_) {
    case Format::csv:
      text_.append(table_.before_[column_++]);
      text_.append(raw_field(value));
      break;
    case Format::json:
      text_.append(table_.before_[column_++]);
      text_.append(json_text(value));
      break;
    case Format::markdown:
      printed(markdown_text(value));
      break;
    case Format::latex:
      printed(latex_text(value));
      break;
  }
}

void RowWriter::field(std::string_view raw) {
  if (table_.format_ != Format::csv) return text(field_value(raw));
  text_.append(table_.before_[column_++]);
  text_.append(raw);
}

void RowWriter::printed(std::string_view cell) {
  text_.append(table_.before_[column_]);
  if (table_.format_ == Format::markdown) {
    text_.append(padded(std::string(cell), table_.names_[column_]));
  } else {
    text_.append(cell);
  }
  ++column_;
}

void RowWriter::end() {
  assert(column_ == table_.columns());
  text_.append(table_.end_of_row_);
  column_ = 0;
}

TableWriter::TableWriter(Output& output, const Table& table)
    : output_(output), table_(table) {
  output_.write(table_.header());
}

void TableWriter::write(std::string_view rows) {
  if (rows.empty()) return;
  // Every JSON row starts with the comma that ends the row before it.
  if (first_ && table_.format() == Format::json) rows.remove_prefix(1);
  first_ = false;
  output_.write(rows);
}

void TableWriter::finish() { output_.write(table_.footer()); }

std::vector<std::string> distinct_names(std::vector<std::string> names,
                                        const std::vector<std::string>& taken) {
  std::vector<std::string> all = taken;
  for (std::string& name : names) {
    while (std::find(all.begin(), all.end(), name) != all.end()) name += "_in";
    all.push_back(name);
  }
  return names;
}

}  // namespace cli
