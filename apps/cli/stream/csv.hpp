#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Reads comma-separated values with one record per line (RFC 4180 without line
/// breaks inside quotes: an open quote spoils one line, not the file), and
/// values with other separators.
///
/// Programs pass unknown columns through byte for byte, report every bad line
/// in its place and continue. For that they need the raw text of each field,
/// which existing parsers do not give.
namespace cli {

/// How a file separates its fields and writes its numbers.
struct CsvForm {
  char separator = ',';  ///< a comma, ; | or a tab
  /// '.' or ','. If the separator is no comma, the other mark is accepted too,
  /// except in a number that may have a thousands mark (may_be_thousands).
  char decimal = '.';

  bool operator==(const CsvForm&) const = default;
};

/// The separator of a header line: the most frequent candidate outside quotes.
/// @param hint  used if it occurs; a comma is no hint
char find_separator(std::string_view header, char hint);

/// The decimal mark of lines whose separator is no comma.
/// @param comma  true: a comma if the numbers allow both
char find_decimal(std::string_view lines, char separator, bool comma);

/// Splits one line (without its end) into its fields with their quotes. The
/// fields are views into `line`; joined by separators they restore it.
/// @param fields  replaced; keeps its memory from line to line
/// @return "" or the fault of the line; `fields` is then unspecified
std::string_view split_record(std::string_view line,
                              std::vector<std::string_view>& fields,
                              char separator = ',');

/// The value of a raw field: without quotes, doubled quotes as one.
std::string field_value(std::string_view raw);

/// As above, with a decimal point in numbers; numbers for which
/// may_be_thousands() is true stay as they are.
std::string field_value(std::string_view raw, CsvForm form);

/// True for one to three digits and three more after the mark that is not the
/// file's decimal mark: 1,250 may be 1.25 or 1250.
bool may_be_thousands(std::string_view value, CsvForm form);

/// The raw field for a value: quoted if needed.
std::string raw_field(std::string_view value, char separator = ',');

}  // namespace cli
