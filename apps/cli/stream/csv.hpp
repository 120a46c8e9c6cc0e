#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Reading of comma-separated values, a record on each line (RFC 4180 without
/// line breaks inside quotes: an open quote spoils one line, not the file), and
/// of those that other characters separate.
///
/// The programs hand columns that they do not know on byte for byte, answer
/// every bad line in its place and go on; for that they need the raw text of
/// each field, which the parsers at hand do not give.
namespace cli {

/// How a file separates its fields and writes its numbers.
struct CsvForm {
  char separator = ',';  ///< a comma, ; | or a tab
  /// '.' or ','. Beside a separator that is no comma the other one is read as
  /// well, but in a number that may have thousands (may_be_thousands).
  char decimal = '.';

  bool operator==(const CsvForm&) const = default;
};

/// The separator of a header line: the one it has most of, outside quotes.
/// @param hint  is taken if it is there; a comma says nothing
char find_separator(std::string_view header, char hint);

/// The decimal mark of lines whose separator is no comma.
/// @param comma  it is a comma if the numbers leave that open
char find_decimal(std::string_view lines, char separator, bool comma);

/// Splits one line (no line end) into its fields, quotes and all: views into
/// `line`, which joined by separators give it back.
/// @param fields  replaced; keeps its memory from line to line
/// @return "" or what is wrong with the line; `fields` is then unspecified
std::string_view split_record(std::string_view line,
                              std::vector<std::string_view>& fields,
                              char separator = ',');

/// The value of a raw field: without its quotes, doubled quotes as one.
std::string field_value(std::string_view raw);

/// The same, numbers with a decimal point; numbers for which may_be_thousands()
/// holds do not change.
std::string field_value(std::string_view raw, CsvForm form);

/// Whether a value in a file of this form is a number of one to three digits
/// and three more behind the mark that is not the file's: 1,250 may be 1.25 or
/// 1250.
bool may_be_thousands(std::string_view value, CsvForm form);

/// The raw field for a value: quoted if it has to be.
std::string raw_field(std::string_view value, char separator = ',');

}  // namespace cli
