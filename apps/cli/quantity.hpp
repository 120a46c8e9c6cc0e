#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "cli/number.hpp"
#include "libcontact/base/dimension.hpp"
#include "libcontact/files/setting.hpp"

/// Numbers of options, with units or without: "2kN", "30 deg", "1.5". Units are
/// spelled as in the keys of files; "N/m" and "N_per_m" are one, and so are
/// "N_m", "N*m" and "Nm". A plain number is in degrees if it is an angle,
/// otherwise in SI units. The functions return SI units.
namespace cli {

/// A number within an interval. Throws contact::Error with the name of its
/// option for anything else.
/// @param option   name for messages, such as "--adhesion"
/// @param allowed  in degrees or SI units
double parse_quantity(std::string_view option, std::string_view text,
                      contact::Dimension dimension, const Allowed& allowed);

/// A number of one dimension, not looked at further; no value if `text` does
/// not begin with one. Throws contact::Error for a unit of something else.
std::optional<double> read_quantity(std::string_view option,
                                    std::string_view text,
                                    contact::Dimension dimension);

/// A number as a key of a file of this dimension: KEY_UNIT = NUMBER, marked as
/// coming from OPTION TEXT. The reader of the key checks its range. Throws
/// contact::Error unless it is a number with such a unit.
contact::KeySetting quantity_key(std::string_view option, std::string_view text,
                                 std::string_view key,
                                 contact::Dimension dimension);

/// Throws contact::Error if some numbers of a list or range have units and
/// others, which are not 0, have none: "1:10:1kN" says too little.
void refuse_some_units(std::string_view option, std::string_view text);

/// Dimension, among some, of the first unit in a value, list or range; none if
/// it has no unit, or none of these.
std::optional<contact::Dimension> unit_dimension(
    std::string_view text, std::initializer_list<contact::Dimension> among);

/// The parts of a text between any of some characters.
std::vector<std::string_view> split(std::string_view text,
                                    std::string_view cuts);

/// Whether a list is more likely to be one number with commas between its
/// thousands, or a decimal one: "2,500", "12,500", "0,5kN".
bool looks_like_thousands(std::string_view text);

/// Whether a list has a number with a leading zero, which suggests a thousands
/// or decimal comma: 100,000 and 0,05.
bool has_cut_number(std::string_view text);

/// A number without a unit within an interval. Throws contact::Error for
/// anything else.
double parse_value(std::string_view option, std::string_view text,
                   const Allowed& allowed);

/// A whole number within an interval. Throws contact::Error for anything else.
int parse_count(std::string_view option, std::string_view text, int min,
                int max);

/// "X,Y,Z": three numbers, finite. Throws contact::Error for anything else.
/// @param what  for messages: "a force in N"
std::array<double, 3> parse_vector(
    std::string_view option, std::string_view text, std::string_view what,
    contact::Dimension dimension = contact::Dimension::number);

}  // namespace cli
