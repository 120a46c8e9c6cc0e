#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/number.hpp"
#include "cli/stream/csv.hpp"
#include "cli/stream/line_blocks.hpp"
#include "cli/stream/row_blocks.hpp"
#include "cli/table.hpp"

/// Points from a CSV file: programs work as filters, with one output line for
/// each input line.
namespace cli {

/// A column that a file of points needs.
struct PointColumn {
  std::string_view name;
  Allowed allowed;
};

/// A header line, its place, and the form of its file.
struct PointHeader {
  std::string line;
  std::string place;  ///< "points.csv, line 1", for messages
  CsvForm form = {};

  /// True if the header names all of these columns.
  bool has(std::span<const PointColumn> columns) const;
  /// The header for messages: "the header has a, b (separator ;)".
  std::string shown() const;
  /// Throws "PLACE: PROBLEM; the header has ..."
  [[noreturn]] void fail(std::string_view problem) const;
};

/// Reads the header of a file and finds the form of the file. The header is the
/// first line that is not blank, a comment or "sep=;". A comment begins with #
/// or %, unless numbers stand on the next line. Throws contact::Error if there
/// is none.
/// @param hints  separator and decimal comma, used if the file is ambiguous
PointHeader read_header(LineReader& reader, const TableStyle& hints);

/// True if a column has this name, in upper or lower case; a comment mark
/// before it is ignored.
bool is_named(std::string_view column, std::string_view name);

/// Columns of a file of points: the required ones, and others that are passed
/// through.
struct PointColumns {
  /// Reads a header. Throws contact::Error if a required column is missing or
  /// occurs twice.
  PointColumns(const PointHeader& header, std::span<const PointColumn> needed);

  CsvForm form;
  std::vector<PointColumn> needed;
  std::vector<std::size_t> at;  ///< field of each required column
  /// Fields of the columns that are passed through, and their names.
  std::vector<std::size_t> riding_at;
  std::vector<std::string> riding;
  std::size_t count;
};

/// A block of points that a program works on.
struct PointLines : RowBlock {
  LineBlock lines;
  std::vector<char> good;  ///< 0 for a bad line
  /// Values of the required columns, point after point; NaN for bad lines.
  std::vector<std::vector<double>> values;
  /// Raw fields that are passed through, point after point; empty where the
  /// line could not be split.
  std::vector<std::string_view> riding;
  std::vector<std::string_view> fields;
};

/// Reads the points of `block.lines`, one for each line that is not blank.
void read_points(const PointColumns& columns, PointLines& block);

/// Points as rows, parsed by the thread that works on them.
class PointRows {
 public:
  explicit PointRows(LineReader& reader) : reader_(reader) {}
  std::size_t count() const { return 0; }
  bool next(PointLines& block) { return reader_.next(block.lines); }

 private:
  LineReader& reader_;
};

/// Reads all points of a file, block by block. Throws contact::Error for the
/// first bad line.
void read_all_points(LineReader& reader, const PointColumns& columns,
                     const std::function<void(const PointLines&)>& each);

/// Writes the fields of a point that are passed through as the last cells of
/// its row.
void write_riding(const PointColumns& columns, const PointLines& block,
                  std::size_t point, RowWriter& row);

}  // namespace cli
