#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "libcontact/files/key_setting.hpp"
#include "libcontact/files/toml_reader.hpp"

namespace contact {

/// A file that is read again and again, by one thread at a time, with other
/// numbers of some keys: the same as to read it with settings that say so, but
/// the keys are looked up once.
class TomlForm {
 public:
  /// @param settings  of these keys: some number, or "*" and some factor
  /// @throws Error as TomlFiles::open(), or of a key that has no number
  TomlForm(const TomlFiles& files, const std::filesystem::path& path,
           KnownKeys (*keys)(), const KeySettings& settings)
      : TomlForm(files.open(path, keys, settings), settings) {}
  /// Form of a table that nothing else reads.
  /// @param settings  the last of those that the table was made with
  TomlForm(TomlTable table, const KeySettings& settings);

  /// With the numbers set last.
  const TomlTable& table() const { return table_; }
  /// Place of a key, one text for all its names: "body[2].com[1]"; for a key
  /// left to another file, the part in this one.
  const std::string& place(std::size_t key) const;
  /// Gives a key its number or factor. Keys that share numbers, as com and
  /// com[1], are all set, in order.
  void set(std::size_t key, double number);

 private:
  struct Numbers {
    std::vector<detail::NumberNode> nodes;
    bool is_factor;
    bool is_first;  ///< none before it has one of these
  };
  /// Numbers, or the setting of a key that is left to another file.
  using Key = std::variant<Numbers, KeySetting*>;
  Key key_at(const detail::KeyPlace& place, const KeySetting& setting);

  TomlTable table_;
  std::vector<Key> keys_;
};

}  // namespace contact
