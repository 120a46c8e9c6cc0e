#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cli/output.hpp"
#include "cli/text.hpp"

namespace cli {

enum class Format { csv, json, markdown, latex };

/// A table's columns in one format. Rows are built in any Text by any thread
/// (RowWriter) and leave through a TableWriter, so a table of any length
/// takes the memory of a few blocks of rows.
///
/// csv, json: shortest numbers that read back as the same doubles. NaN, no
/// value, is an empty cell in CSV and null in JSON; infinity is inf or -inf in
/// CSV and the text "inf" or "-inf" in JSON. JSON is an array of objects, one
/// on each line.
/// markdown, latex: for print, numbers with 4 significant digits.
class Table {
 public:
  Table(Format format, std::vector<std::string> column_names);

  Format format() const { return format_; }
  std::size_t columns() const { return before_.size(); }
  std::string header() const;
  std::string footer() const;

 private:
  friend class RowWriter;
  Format format_;
  std::vector<std::string> names_;
  std::vector<std::string> before_;  ///< what stands before each cell
  std::string end_of_row_;
};

/// Writes the cells of a row from left to right.
class RowWriter {
 public:
  RowWriter(const Table& table, Text& text) : table_(table), text_(text) {}

  void number(double value);
  /// A whole number, in full in every format.
  void count(std::size_t value);
  /// No value: empty, null or a dash.
  void empty();
  void text(std::string_view value);
  /// A field as it stood in a CSV file, handed on byte for byte to CSV.
  void field(std::string_view raw);
  /// All cells of the row must have been written.
  void end();

 private:
  void printed(std::string_view cell);

  const Table& table_;
  Text& text_;
  std::size_t column_ = 0;
};

/// Sends a table to an output: header, blocks of rows, footer.
class TableWriter {
 public:
  TableWriter(Output& output, const Table& table);
  /// Whole rows that RowWriters of the same table have built.
  void write(std::string_view rows);
  void finish();

 private:
  Output& output_;
  const Table& table_;
  bool first_ = true;
};

/// `names`, changed where needed so that none is in `taken` or occurs twice
/// ("_in" is added): the names of columns that are handed on.
std::vector<std::string> distinct_names(std::vector<std::string> names,
                                        const std::vector<std::string>& taken);

}  // namespace cli
