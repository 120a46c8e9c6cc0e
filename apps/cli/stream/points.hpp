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

/// Points from a CSV file: the programs as filters, a line in, a line out.
namespace cli {

/// A column that a file of points needs.
struct PointColumn {
  std::string_view name;
  Allowed allowed;
};

/// A header line, where it stands, and how its file is written.
struct PointHeader {
  std::string line;
  std::string place;  ///< "points.csv, line 1", for messages
  CsvForm form = {};

  /// Whether it names all of these columns.
  bool has(std::span<const PointColumn> columns) const;
  /// The header that was read, for messages: "the header has a, b (separator
  /// ;)".
  std::string shown() const;
  /// "PLACE: PROBLEM; the header has ..."
  [[noreturn]] void fail(std::string_view problem) const;
};

/// The header of a file, with the form that it and the lines behind it have:
/// the first line that is no comment, blank, or "sep=;". A comment begins with
/// # or %, unless numbers stand on the next line. Throws contact::Error if
/// there is none.
/// @param hints  separator and decimal comma where the file leaves them open
PointHeader read_header(LineReader& reader, const TableStyle& hints);

/// Whether a column's name is this one, in small or capital letters; the mark
/// of a comment in front of it is left out.
bool is_named(std::string_view column, std::string_view name);

/// Columns of a file of points: the needed ones, and others that ride along.
struct PointColumns {
  /// Reads a header. Throws contact::Error if a needed column is missing or
  /// occurs twice.
  PointColumns(const PointHeader& header, std::span<const PointColumn> needed);

  CsvForm form;
  std::vector<PointColumn> needed;
  std::vector<std::size_t> at;  ///< field of each needed column
  /// Fields of the columns that ride along, and their names.
  std::vector<std::size_t> riding_at;
  std::vector<std::string> riding;
  std::size_t count;
};

/// Some points on their way through a program.
struct PointLines : RowBlock {
  LineBlock lines;
  std::vector<char> good;  ///< 0 for a bad line
  /// Values of the needed columns, each point after point; NaN of bad lines.
  std::vector<std::vector<double>> values;
  /// Raw fields of the riding columns, point after point; empty where the line
  /// could not be split.
  std::vector<std::string_view> riding;
  std::vector<std::string_view> fields;
};

/// Points of `block.lines`, one for each line that is not blank.
void read_points(const PointColumns& columns, PointLines& block);

/// Points as rows, read in the thread that works on them.
class PointRows {
 public:
  explicit PointRows(LineReader& reader) : reader_(reader) {}
  std::size_t count() const { return 0; }
  bool next(PointLines& block) { return reader_.next(block.lines); }

 private:
  LineReader& reader_;
};

/// All points of a file, block after block. Throws contact::Error for the
/// first bad line.
void read_all_points(LineReader& reader, const PointColumns& columns,
                     const std::function<void(const PointLines&)>& each);

/// The riding fields of a point as the last cells of its row.
void write_riding(const PointColumns& columns, const PointLines& block,
                  std::size_t point, RowWriter& row);

}  // namespace cli
