#include "programs/fmu/resources.hpp"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "cli/joint/shipped.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/file_text.hpp"
#include "libcontact/c/contact.h"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/files/named_file.hpp"
#include "libcontact/files/toml_nodes.hpp"
#include "libcontact/joint/joint.hpp"
#include "separation/c/run.h"

namespace hinge_fmu {
namespace {

namespace fs = std::filesystem;

// Packs files. The keys of a file belong to the table that names it.
class Packer {
 public:
  explicit Packer(Resources& to) : to_(to) {}

  // The name that the file has in the FMU.
  std::string add(const fs::path& file, const std::string& name,
                  const std::string& path) {
    toml::table root = toml::parse(contact::detail::file_text(file));
    walk(root, file.parent_path(), path);
    std::ostringstream text;
    text << root << '\n';
    to_.files[name] = text.str();
    return name;
  }

 private:
  void walk(toml::table& table, const fs::path& folder,
            const std::string& path) {
    for (auto&& [key, node] : table) {
      const std::string name(key.str());
      if (node.is_string() && (name == "file" || name == "pair")) {
        const fs::path file = contact::detail::named_file(
            folder, name, *node.value<std::string>());
        const std::string packed =
            fmt::format("{}_{}", ++count_, file.filename().string());
        node.ref<std::string>() = add(file, packed, path);
      } else {
        look_at(node, folder,
                path.empty() ? name : fmt::format("{}.{}", path, name));
      }
    }
  }

  void look_at(toml::node& node, const fs::path& folder,
               const std::string& path) {
    if (node.is_number()) {
      // An infinite number (a rigid body) is kept.
      const double value = *node.value<double>();
      if (std::isfinite(value)) to_.keys.push_back({path, value});
    } else if (auto* const table = node.as_table()) {
      walk(*table, folder, path);
    } else if (auto* const array = node.as_array()) {
      const bool is_long = array->size() > 3;
      int i = 0;
      for (toml::node& element : *array) {
        ++i;
        if (element.is_array() || (is_long && element.is_number())) continue;
        look_at(element, folder, fmt::format("{}[{}]", path, i));
      }
    }
  }

  Resources& to_;
  int count_ = 0;
};

// Readers of joints and cases report errors of a file. Notes are printed here
// because a running FMU cannot print them.
void check_joint(const fs::path& file, Resources& all) {
  const contact::Joint joint{contact::read_joint(file)};
  all.notes = joint.contact().validity_notes();
}
void check_case(const fs::path& file, Resources& all) {
  contact_run* run = nullptr;
  if (contact_run_open(file.c_str(), nullptr, 0, &run) != CONTACT_OK) {
    throw contact::Error(contact_last_message());
  }
  all.end_time = contact_run_end_time(run);
  contact_run_free(run);
}

}  // namespace

Resources read_resources(const fs::path& file) {
  Resources all;
  // Text that is not TOML is reported as a faulty joint file.
  const std::string_view kind = cli::kind_of_file(file);
  all.is_joint = kind != "a case file";
  if (kind == "a study file") {
    cli::refuse_other_file("hinge-fmu", file, "a joint or case file");
  }
  (all.is_joint ? check_joint : check_case)(file, all);
  Packer(all).add(file, "model.toml", "");
  return all;
}

}  // namespace hinge_fmu
