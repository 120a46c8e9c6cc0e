#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libcontact/base/dimension.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/files/setting.hpp"

/// Checked reading of TOML files: every key is declared, has a type, a unit in
/// its name and a range, and no other key may be there.
///
/// Everything that is wrong throws contact::Error with one line in the grammar
/// of base/complaint.hpp, "FILE:LINE: TABLE.KEY = VALUE must be WHAT". Results
/// are in SI units.
namespace contact {

/// How many numbers an array has.
struct ArrayShape {
  std::size_t rows;
  std::size_t columns = 0;  ///< columns of each row; 0: rows are numbers
  bool or_more = false;     ///< more rows too
};

/// Values that a key may have, for its reader and its schema alike.
struct AllowedValues {
  /// Numbers of it, also those of an array; in SI units.
  std::optional<Interval> numbers = {};
  /// The first and the last integer.
  std::optional<std::pair<std::int64_t, std::int64_t>> integers = {};
  /// One of these.
  std::vector<std::string> words = {};
};

/// A key that a table may have.
struct KnownKey {
  std::string_view key;
  Dimension dimension = Dimension::number;
  /// Keys of the table or tables that it stands for.
  std::vector<KnownKey> inside = {};
  /// Words that the table's `kind` may be; "": any.
  std::string_view kinds = {};
  /// Name in old files, for the message about them.
  std::string_view former = {};
  /// Keys of the file that this key names.
  std::vector<KnownKey> of_file = {};
  AllowedValues allowed = {};
};
using KnownKeys = std::vector<KnownKey>;

/// The key of a number, or of an array of numbers.
inline KnownKey number_key(std::string_view key, Dimension dimension,
                           const Interval& range) {
  return {.key = key, .dimension = dimension, .allowed = {.numbers = range}};
}
inline KnownKey number_key(std::string_view key, const Interval& range) {
  return number_key(key, Dimension::number, range);
}
inline KnownKey integer_key(std::string_view key, std::int64_t low,
                            std::int64_t high) {
  return {.key = key, .allowed = {.integers = {{low, high}}}};
}
/// The key of one of some words.
inline KnownKey word_key(std::string_view key, std::vector<std::string> words) {
  return {.key = key, .allowed = {.words = std::move(words)}};
}

/// The key of a table or of an array of tables.
inline KnownKey table_key(std::string_view key, KnownKeys inside) {
  return {key, Dimension::number, std::move(inside)};
}

class TomlFiles;

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
  /// @param settings  made before anything is looked at, each of another key;
  ///   throws RepeatedSetting
  static TomlTable from_file(const std::filesystem::path& path, KnownKeys keys,
                             const KeySettings& settings = {});
  /// Reads a text.
  /// @param source  what messages call it; "": they name no place
  /// @param folder  what paths in it are relative to
  static TomlTable from_text(std::string_view text, const std::string& source,
                             KnownKeys keys, std::filesystem::path folder = {},
                             const KeySettings& settings = {});

  /// True if the key is there, in any of its dimension's spellings.
  bool has(std::string_view key) const;
  /// True if the key is there and is a table.
  bool is_table(std::string_view key) const;

  /// A number as its key allows.
  double number(std::string_view key) const;
  /// One in a range of its own, as where it depends on other numbers.
  double number(std::string_view key, const Interval& range) const;
  /// An array of numbers or of arrays of them, row by row.
  std::vector<double> numbers(std::string_view key,
                              const ArrayShape& shape) const;
  std::vector<double> numbers(std::string_view key, const ArrayShape& shape,
                              const Interval& range) const;
  std::int64_t integer(std::string_view key) const;
  /// A string that is not empty.
  std::string text(std::string_view key) const;
  /// One of the key's words; returns its index.
  /// @param otherwise  what else the key may be, for the message
  std::size_t choice(std::string_view key,
                     std::string_view otherwise = "") const;
  /// A table inside this one: [key].
  TomlTable table(std::string_view key) const;

  std::optional<double> optional_number(std::string_view key) const {
    if (!has(key)) return {};
    return number(key);
  }
  std::optional<double> optional_number(std::string_view key,
                                        const Interval& range) const {
    if (!has(key)) return {};
    return number(key, range);
  }
  std::optional<std::vector<double>> optional_numbers(
      std::string_view key, const ArrayShape& shape) const {
    if (!has(key)) return {};
    return numbers(key, shape);
  }
  auto optional_text(std::string_view key) const {
    return optional(&TomlTable::text, key);
  }
  auto optional_choice(std::string_view key) const {
    return optional(&TomlTable::choice, key, "");
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

  /// Throws Error for the first key of the whole file that was not read, given
  /// its other keys. Call it when everything is read.
  void refuse_idle() const;

  /// Content of the table in one form: the same for files that differ only in
  /// comments, blanks, the order of keys or the notation of numbers.
  std::string canonical_text() const;
  /// The file with its settings as TOML, which reads as the same.
  std::string toml_text() const;

  /// The file, or the name given to from_text().
  const std::string& source() const;
  /// Its folder; empty for a text.
  const std::filesystem::path& folder() const;
  /// The file that a text names (named_file.hpp), with the settings that are
  /// left to it. Throws Error as from_file().
  TomlTable file(std::string_view key, KnownKeys (*keys)()) const;

 private:
  friend class TomlFiles;
  friend class TomlForm;
  struct File;
  struct Parsed;
  struct Cache;
  struct Entry;

  static Parsed parsed(std::string_view text, const std::string& source,
                       KnownKeys keys);
  static TomlTable of(Parsed parsed, const std::string& source,
                      std::filesystem::path folder, const KeySettings& settings,
                      std::shared_ptr<Cache> cache);
  static TomlTable cached(const std::shared_ptr<Cache>& cache,
                          const std::filesystem::path& path,
                          KnownKeys (*keys)(), const KeySettings& settings);
  TomlTable(std::shared_ptr<File> file, const void* table,
            const KnownKeys* keys, std::string path);
  template <class Value, class... Parameters, class... Arguments>
  std::optional<Value> optional(Value (TomlTable::*read)(std::string_view,
                                                         Parameters...) const,
                                std::string_view key,
                                const Arguments&... arguments) const {
    if (!has(key)) return {};
    return (this->*read)(key, arguments...);
  }
  std::string subject(std::string_view key) const;
  const KnownKey& declared(std::string_view key) const;
  std::optional<Entry> find(std::string_view key) const;
  Entry at(std::string_view key) const;
  TomlTable inner(const void* table, std::string_view key,
                  std::string path) const;

  std::shared_ptr<File> file_;
  const void* table_;
  const KnownKeys* keys_;
  std::string path_;
};

/// Files that are parsed once and read again and again, each time with other
/// settings, and so are the files that they name. Any thread may open one.
/// Messages have no lines.
class TomlFiles {
 public:
  TomlFiles();
  /// As TomlTable::from_file() when it was opened first.
  TomlTable open(const std::filesystem::path& path, KnownKeys (*keys)(),
                 const KeySettings& settings = {}) const;
  /// The same of a text, which is parsed anew.
  TomlTable text(std::string_view text, const std::string& source,
                 KnownKeys (*keys)(), const std::filesystem::path& folder,
                 const KeySettings& settings = {}) const;

 private:
  std::shared_ptr<TomlTable::Cache> cache_;
};

}  // namespace contact
