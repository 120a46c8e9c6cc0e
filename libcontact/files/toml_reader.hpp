#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Checked reading of TOML files: every key has a type, a unit in its name and
/// an allowed range, and no other key may be there.
///
/// Everything that is wrong throws contact::Error with one line,
/// "FILE:LINE: TABLE.KEY = VALUE: allowed: WHAT". Results are in SI units.
namespace contact {

/// What a key measures, which fixes the unit endings it takes: the length
/// `radius` may be spelled radius (in m), radius_m, radius_mm, radius_um.
/// A key without an ending is in the first unit of its list.
enum class Dimension {
  number,                ///< no unit, no ending
  length,                ///< m, mm, um, km
  stress,                ///< Pa, kPa, MPa, GPa
  force,                 ///< N, kN, MN
  line_force,            ///< N_per_m, kN_per_m, N_per_mm
  moment,                ///< N_m, kN_m, N_mm
  angle,                 ///< rad, deg
  angular_velocity,      ///< rad_per_s, deg_per_s, rpm
  angular_acceleration,  ///< rad_per_s2, deg_per_s2
  velocity,              ///< m_per_s, mm_per_s, km_per_h
  acceleration,          ///< m_per_s2
  time,                  ///< s, ms
  mass,                  ///< kg, g, t
  inertia,               ///< kg_m2
  viscous_constant,      ///< Pa_s_per_m, kPa_s_per_m, ... GPa_s_per_m
  inverse_velocity,      ///< s_per_m
};

/// Values that a number may take, in SI units. Always finite, unless
/// `or_infinity`.
struct Interval {
  double low;
  double high;
  bool low_excluded = false;
  bool high_excluded = false;
  bool or_infinity = false;  ///< +infinity too

  static constexpr double largest = std::numeric_limits<double>::max();
  static constexpr Interval any() { return {-largest, largest}; }
  static constexpr Interval positive() { return {0, largest, true}; }
  static constexpr Interval non_negative() { return {0, largest}; }

  /// False for NaN.
  bool contains(double value) const;
};

/// A key that a table may have, for refuse_keys_beside().
struct KnownKey {
  std::string_view key;
  Dimension dimension = Dimension::number;
  /// Keys of the table or tables that it stands for.
  std::vector<KnownKey> inside = {};
  /// Words, of which the table's `kind` is one; "": any.
  std::string_view kinds = {};
};

/// One table of a TOML file. A cheap handle; the file lives as long as any of
/// its tables.
///
/// A function `name` throws if the key is missing, `optional_name` gives no
/// value instead. Each marks its key as known for refuse_unknown_keys().
class TomlTable {
 public:
  /// Reads a file. Throws Error if it cannot be read or is not TOML.
  static TomlTable from_file(const std::filesystem::path& path);
  /// Reads a text.
  /// @param source  what messages call it
  static TomlTable from_text(std::string_view text, const std::string& source);

  double number(std::string_view key, const Interval& allowed,
                Dimension dimension = Dimension::number) const;
  std::optional<double> optional_number(
      std::string_view key, const Interval& allowed,
      Dimension dimension = Dimension::number) const;

  /// An array of `size` numbers.
  std::vector<double> numbers(std::string_view key, std::size_t size,
                              const Interval& allowed,
                              Dimension dimension = Dimension::number) const;
  std::optional<std::vector<double>> optional_numbers(
      std::string_view key, std::size_t size, const Interval& allowed,
      Dimension dimension = Dimension::number) const;

  /// An array of `rows` arrays of `columns` numbers, row by row.
  std::vector<double> matrix(std::string_view key, std::size_t rows,
                             std::size_t columns, const Interval& allowed,
                             Dimension dimension = Dimension::number) const;
  std::optional<std::vector<double>> optional_matrix(
      std::string_view key, std::size_t rows, std::size_t columns,
      const Interval& allowed, Dimension dimension = Dimension::number) const;

  /// An array of at least `least` numbers.
  std::vector<double> list(std::string_view key, std::size_t least,
                           const Interval& allowed,
                           Dimension dimension = Dimension::number) const;
  std::optional<std::vector<double>> optional_list(
      std::string_view key, std::size_t least, const Interval& allowed,
      Dimension dimension = Dimension::number) const;
  /// An array of at least `least` arrays of `columns` numbers, row by row.
  std::vector<double> rows(std::string_view key, std::size_t least,
                           std::size_t columns, const Interval& allowed,
                           Dimension dimension = Dimension::number) const;

  std::int64_t integer(std::string_view key, std::int64_t low,
                       std::int64_t high) const;
  std::optional<std::int64_t> optional_integer(std::string_view key,
                                               std::int64_t low,
                                               std::int64_t high) const;
  bool boolean(std::string_view key) const;
  std::optional<bool> optional_boolean(std::string_view key) const;

  /// A string that is not empty.
  std::string text(std::string_view key) const;
  std::optional<std::string> optional_text(std::string_view key) const;
  /// A string or an array of strings, none of them empty; none if the key is
  /// missing.
  std::vector<std::string> texts(std::string_view key) const;
  /// One of some words; returns its index.
  /// @param otherwise  what else the key may be, for the message
  std::size_t choice(std::string_view key,
                     const std::vector<std::string>& words,
                     std::string_view otherwise = "") const;
  std::optional<std::size_t> optional_choice(
      std::string_view key, const std::vector<std::string>& words,
      std::string_view otherwise = "") const;

  /// True if the key is there and is a table.
  bool is_table(std::string_view key) const;
  /// A table inside this one: [key].
  TomlTable table(std::string_view key) const;
  std::optional<TomlTable> optional_table(std::string_view key) const;
  /// An array of tables: [[key]]; none if the key is missing.
  std::vector<TomlTable> tables(std::string_view key) const;

  /// True if the key is there, in any of the dimension's spellings.
  bool has(std::string_view key, Dimension dimension = Dimension::number) const;

  /// Throws Error for the first key of the whole file that no call has asked
  /// for, with the nearest one that was. Call it when everything is read.
  void refuse_unknown_keys() const;
  /// Throws Error for the first key of the whole file that is not among these,
  /// with the nearest one that is. Call it before anything is read: an unknown
  /// key may be why something else is missing.
  void refuse_keys_beside(const std::vector<KnownKey>& known) const;

  /// Throws Error "FILE:LINE: TABLE.KEY = VALUE: MESSAGE" for a check that the
  /// caller makes; a missing key gives the place of the table.
  [[noreturn]] void fail(std::string_view key,
                         const std::string& message) const;
  /// Throws Error "FILE:LINE: TABLE.KEY is missing: WHY" for a key that is
  /// missing because of what else is there or not.
  [[noreturn]] void fail_missing(std::string_view key,
                                 const std::string& why) const;

  /// What the file says, in one form: the same for files that differ only in
  /// comments, blanks, the order of keys or the notation of numbers.
  std::string canonical_text() const;

  /// The file, or the name given to from_text().
  const std::string& source() const;
  /// Its folder; empty for a text.
  const std::filesystem::path& folder() const;

 private:
  struct File;
  struct Entry;

  TomlTable(std::shared_ptr<File> file, const void* table, std::string path);
  static TomlTable parse(std::string_view text, const std::string& source,
                         std::filesystem::path folder);
  std::optional<Entry> find(std::string_view key, Dimension dimension) const;
  std::optional<Entry> find(std::string_view key) const;
  [[noreturn]] void missing(std::string_view key, Dimension dimension) const;

  std::shared_ptr<File> file_;
  const void* table_;
  std::string path_;
};

}  // namespace contact
