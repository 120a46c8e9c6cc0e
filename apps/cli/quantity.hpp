#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "cli/number.hpp"
#include "libcontact/base/dimension.hpp"
#include "libcontact/files/setting.hpp"

/// Numbers of options, with or without units: "2kN", "30 deg", "1.5". Units are
/// spelled as in the keys of files; "N/m" equals "N_per_m", and "N_m", "N*m"
/// and "Nm" are equal. A plain number is in degrees if it is an angle,
/// otherwise in SI units. The functions return SI units.
namespace cli {

/// Parses a number within an interval. Throws contact::Error, naming the
/// option, for anything else.
/// @param option   name for messages, such as "--adhesion"
/// @param allowed  in degrees or SI units
double parse_quantity(std::string_view option, std::string_view text,
                      contact::Dimension dimension, const Allowed& allowed);

/// Parses a number of one dimension without a check of its range; returns no
/// value if `text` does not begin with a number. Throws contact::Error for a
/// unit of another dimension.
std::optional<double> read_quantity(std::string_view option,
                                    std::string_view text,
                                    contact::Dimension dimension);

/// A number as a key of a file, KEY_UNIT = NUMBER, marked as coming from OPTION
/// TEXT. The reader of the key checks its range. Throws contact::Error unless
/// the text is a number with a unit of this dimension.
contact::KeySetting quantity_key(std::string_view option, std::string_view text,
                                 std::string_view key,
                                 contact::Dimension dimension);

/// Throws contact::Error for a list or range in which some numbers have units
/// and others, not 0, have none: "1:10:1kN" is ambiguous.
void refuse_some_units(std::string_view option, std::string_view text);

/// Which of some dimensions the first unit of a value, list or range has; no
/// value without a unit or with a unit of another dimension.
std::optional<contact::Dimension> unit_dimension(
    std::string_view text, std::initializer_list<contact::Dimension> among);

/// Splits a text at any of some characters.
std::vector<std::string_view> split(std::string_view text,
                                    std::string_view cuts);

/// True if a list is probably one number with a thousands or decimal comma:
/// "2,500", "12,500", "0,5kN".
bool looks_like_thousands(std::string_view text);

/// True if a number of the list has a leading zero, which suggests a thousands
/// or decimal comma: 100,000 and 0,05.
bool has_cut_number(std::string_view text);

/// Parses a number without a unit within an interval. Throws contact::Error for
/// anything else.
double parse_value(std::string_view option, std::string_view text,
                   const Allowed& allowed);

/// Parses a whole number within an interval. Throws contact::Error for anything
/// else.
int parse_count(std::string_view option, std::string_view text, int min,
                int max);

/// Parses "X,Y,Z", three finite numbers. Throws contact::Error for anything
/// else.
/// @param what  for messages: "a force in N"
std::array<double, 3> parse_vector(
    std::string_view option, std::string_view text, std::string_view what,
    contact::Dimension dimension = contact::Dimension::number);

}  // namespace cli
