#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Reading of comma-separated values, a record on each line (RFC 4180 without
/// line breaks inside quotes: an open quote spoils one line, not the file).
///
/// The programs hand columns that they do not know on byte for byte, answer
/// every bad line in its place and go on; for that they need the raw text of
/// each field, which the parsers at hand do not give.
namespace cli {

/// Splits one line (no line end) into its fields, quotes and all: views into
/// `line`, which joined by commas give it back.
/// @param fields  replaced; keeps its memory from line to line
/// @return "" or what is wrong with the line; `fields` is then unspecified
std::string_view split_record(std::string_view line,
                              std::vector<std::string_view>& fields);

/// The value of a raw field: without its quotes, doubled quotes as one.
std::string field_value(std::string_view raw);

/// The raw field for a value: quoted if it has to be.
/// @param separator  of the fields; one that is not a comma is for writing only
std::string raw_field(std::string_view value, char separator = ',');

}  // namespace cli
