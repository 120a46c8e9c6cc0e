#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/files/key_setting.hpp"
#include "libcontact/files/stranger.hpp"
#include "libcontact/files/toml_nodes.hpp"
#include "libcontact/files/toml_reader.hpp"

/// Data behind the handles of toml_reader.hpp.
namespace contact {

struct TomlTable::Parsed {
  std::shared_ptr<const KnownKeys> keys;
  toml::table root;
};

struct TomlTable::Cache {
  std::mutex mutex = {};
  std::map<std::string, Parsed> files = {};  // by their paths
};

struct TomlTable::File {
  std::string source;
  std::filesystem::path folder;
  std::shared_ptr<const KnownKeys> keys;
  toml::table root = {};
  // Cache for the files that this one names too; null if they are read anew.
  std::shared_ptr<Cache> cache = {};
  std::set<const toml::node*> read = {};
  // Settings by the table that names the file.
  std::map<const toml::table*, KeySettings> for_files = {};
  // Places of the settings, in order.
  std::vector<detail::KeyPlace> settings = {};
  // Sources of nodes that need no other name.
  std::set<std::string> origins = {};

  const std::string* origin(const toml::node& node) const {
    const auto& from = node.source().path;
    return from && origins.contains(*from) ? from.get() : nullptr;
  }
  // "FILE:LINE: ", or "FILE with KEY: " for a node that a setting has made.
  // Nodes that are copies of others have no line.
  std::string at(const toml::node& node) const {
    if (const auto* from = origin(node)) return *from + ": ";
    if (source.empty()) return "";
    if (const auto& setting = node.source().path) {
      return detail::message("{} with {}: ", source, *setting);
    }
    if (cache) return source + ": ";
    return detail::message("{}:{}: ", source, detail::line_of(node));
  }
  // "FILE:LINE: NAME = VALUE", or its origin.
  std::string subject(const toml::node& node, const std::string& name,
                      const toml::node& value) const {
    if (const auto* from = origin(node)) return *from;
    return at(node) + detail::named(name, value);
  }
  void refuse(detail::Stranger strange) const {
    strange.look_for(root, *keys, "");
    if (strange.node == nullptr) return;
    throw Error(at(*strange.node) + strange.complaint);
  }
};

}  // namespace contact
