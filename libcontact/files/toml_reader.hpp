#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Checked reading of TOML files: every key is declared, has a type, a unit in
/// its name and a range, and no other key may be there.
///
/// Everything that is wrong throws contact::Error with one line in the grammar
/// of base/complaint.hpp, "FILE:LINE: TABLE.KEY = VALUE must be WHAT". Results
/// are in SI units.
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

/// How many numbers an array has.
struct ArrayShape {
  std::size_t rows;
  std::size_t columns = 0;  ///< of each row; 0: rows are numbers
  bool or_more = false;     ///< more rows too
};

/// A key that a table may have.
struct KnownKey {
  std::string_view key;
  Dimension dimension = Dimension::number;
  /// Keys of the table or tables that it stands for.
  std::vector<KnownKey> inside = {};
  /// Words, of which the table's `kind` is one; "": any.
  std::string_view kinds = {};
  /// What it was called in old files, for the message about them.
  std::string_view former = {};
};
using KnownKeys = std::vector<KnownKey>;

/// The key of a table or of an array of tables.
inline KnownKey table_key(std::string_view key, KnownKeys inside) {
  return {key, Dimension::number, std::move(inside)};
}

/// One table of a TOML file. A cheap handle; the file lives as long as any of
/// its tables.
///
/// A function `name` throws if the key is missing, `optional_name` gives no
/// value instead.
class TomlTable {
 public:
  /// Reads a file whose keys are among these. Throws Error if it cannot be
  /// read, is not TOML or has another key, with the first one and the nearest
  /// that is known: it may be why something else is missing.
  static TomlTable from_file(const std::filesystem::path& path, KnownKeys keys);
  /// Reads a text.
  /// @param source  what messages call it
  static TomlTable from_text(std::string_view text, const std::string& source,
                             KnownKeys keys);

  /// True if the key is there, in any of its dimension's spellings.
  bool has(std::string_view key) const;
  /// True if the key is there and is a table.
  bool is_table(std::string_view key) const;

  double number(std::string_view key, const Interval& range) const;
  /// An array of numbers or of arrays of them, row by row.
  std::vector<double> numbers(std::string_view key, const ArrayShape& shape,
                              const Interval& range) const;
  std::int64_t integer(std::string_view key, std::int64_t low,
                       std::int64_t high) const;
  /// A string that is not empty.
  std::string text(std::string_view key) const;
  /// One of some words; returns its index.
  /// @param otherwise  what else the key may be, for the message
  std::size_t choice(std::string_view key,
                     const std::vector<std::string>& words,
                     std::string_view otherwise = "") const;
  /// A table inside this one: [key].
  TomlTable table(std::string_view key) const;

  auto optional_number(std::string_view key, const Interval& range) const {
    return optional(&TomlTable::number, key, range);
  }
  auto optional_numbers(std::string_view key, const ArrayShape& shape,
                        const Interval& range) const {
    return optional(&TomlTable::numbers, key, shape, range);
  }
  auto optional_text(std::string_view key) const {
    return optional(&TomlTable::text, key);
  }
  auto optional_choice(std::string_view key,
                       const std::vector<std::string>& words) const {
    return optional(&TomlTable::choice, key, words, "");
  }
  auto optional_table(std::string_view key) const {
    return optional(&TomlTable::table, key);
  }
  /// True or false; false if the key is missing.
  bool flag(std::string_view key) const;
  /// A string or an array of strings, none of them empty; none if the key is
  /// missing.
  std::vector<std::string> texts(std::string_view key) const;
  /// An array of tables: [[key]]; none if the key is missing.
  std::vector<TomlTable> tables(std::string_view key) const;

  /// Checks that the caller makes. Each throws Error "FILE:LINE: TABLE.KEY =
  /// VALUE" with its end: " must be RULE", " requires OTHER", ": MESSAGE".
  [[noreturn]] void must_be(std::string_view key, std::string_view rule) const;
  [[noreturn]] void needs(std::string_view key, std::string_view other) const;
  [[noreturn]] void fail(std::string_view key, std::string_view message) const;
  /// Throws Error "FILE:LINE: TABLE requires OTHER".
  [[noreturn]] void needs(std::string_view other) const;
  /// Throws Error "... KEY = VALUE conflicts with OTHER (line N)" if both keys
  /// are there.
  void refuse_both(std::string_view key, std::string_view other) const;

  /// Throws Error for the first key of the whole file that nothing has asked
  /// for, because of what else is there. Call it when everything is read.
  void refuse_idle() const;

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

  TomlTable(std::shared_ptr<const File> file, const void* table,
            const KnownKeys* keys, std::string path);
  static TomlTable parse(std::string_view text, const std::string& source,
                         std::filesystem::path folder, KnownKeys keys);
  template <class Value, class... Parameters, class... Arguments>
  std::optional<Value> optional(Value (TomlTable::*read)(std::string_view,
                                                         Parameters...) const,
                                std::string_view key,
                                const Arguments&... arguments) const {
    if (!has(key)) return {};
    return (this->*read)(key, arguments...);
  }
  std::string line() const;
  std::string subject(std::string_view key) const;
  const KnownKey& declared(std::string_view key) const;
  std::optional<Entry> find(std::string_view key) const;
  Entry at(std::string_view key) const;
  TomlTable inner(const void* table, std::string_view key,
                  std::string path) const;

  std::shared_ptr<const File> file_;
  const void* table_;
  const KnownKeys* keys_;
  std::string path_;
};

}  // namespace contact
