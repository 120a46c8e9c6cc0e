#include "programs/fmu/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "cli/output.hpp"
#include "cli/output_names.hpp"
#include "cli/program.hpp"
#include "cli/refuse.hpp"
#include "hosts/fmu/model.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/file_text.hpp"
#include "libcontact/version.hpp"
#include "programs/fmu/archive.hpp"
#include "programs/fmu/description.hpp"
#include "programs/fmu/resources.hpp"
#include "programs/fmu/shared_object.hpp"

namespace hinge_fmu {
namespace {

namespace fs = std::filesystem;

// Defers signals until its end.
class LaterSignals {
 public:
  LaterSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
  }
  ~LaterSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  LaterSignals(const LaterSignals&) = delete;
  LaterSignals& operator=(const LaterSignals&) = delete;

 private:
  sigset_t before_;
};

// A temporary folder, removed at the end of the program or by a signal.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "hinge-fmu-XXXXXX");
    if (!mkdtemp(name.data())) throw contact::Error(name + ": cannot be made");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  LaterSignals later_;
  fs::path path_;
};

// Text by which hosts identify an FMU: depends on its content only (FNV-1a).
std::string token_of(const Resources& resources) {
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&hash](std::string_view text) {
    for (const char c : text) {
      hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    }
  };
  add(contact::version);
  for (const auto& [name, text] : resources.files) {
    add(name);
    add(text);
  }
  return fmt::format("{{libcontact-{:016x}}}", hash);
}

// Writes the parameters in the form read by the FMU (hosts/fmu/model.hpp).
void add_keys(Resources& resources) {
  std::string text = token_of(resources) + '\n';
  for (const auto& [name, value] : resources.keys) {
    text += fmt::format("{} {}\n", value, name);
  }
  resources.files[fs::path(contact_hosts::fmu::keys_file).filename()] = text;
}

std::string output_of(const Options& o) {
  return o.output.empty() ? fs::path(o.file).stem().string() + ".fmu"
                          : o.output;
}

// "joint pin: 5 inputs, 20 outputs, 12 parameters"
std::string content_of(const contact_hosts::fmu::Model& model,
                       std::string_view kind, std::string_view name) {
  using contact_hosts::fmu::Role;
  const auto count = [&](Role role) {
    return std::ranges::count(model.variables(), role,
                              &contact_hosts::fmu::Variable::role);
  };
  return fmt::format("{} {}: {} inputs, {} outputs, {} parameters", kind, name,
                     count(Role::input), count(Role::output),
                     count(Role::parameter));
}

// @param content  becomes what is inside, as text
std::string zipped(const Options& o, const Resources& resources,
                   std::string& content) {
  const TemporaryFolder folder;
  for (const auto& [name, text] : resources.files) {
    std::ofstream(folder.path() / name) << text;
  }
  const bool is_joint = resources.is_joint;
  const auto model = is_joint ? contact_hosts::fmu::joint_model(folder.path())
                              : contact_hosts::fmu::case_model(folder.path());
  const std::string kind = is_joint ? "joint" : "case";
  const Description description = {
      fs::path(o.file).stem(),    "contact_" + kind, model->token(), o.version,
      is_joint && o.version == 2, resources.end_time};
  content = content_of(*model, kind, description.name);
  const fs::path zip = folder.path() / "fmu.zip";
  Archive archive(zip);
  archive.add("modelDescription.xml", description.text(*model));
  for (const auto& [name, text] : resources.files) {
    archive.add("resources/" + name, text);
  }
  const std::string binaries = "binaries/" + platform(o.version) + '/';
  const fs::path object = shared_object("libcontact_fmu_" + kind + ".so");
  archive.add(binaries + description.identifier + ".so",
              contact::detail::file_text(object));
  for (const auto& [name, path] : carried_libraries(object)) {
    archive.add(binaries + name, contact::detail::file_text(path));
  }
  archive.close();
  return contact::detail::file_text(zip);
}

}  // namespace

cli::ExitStatus run(const Options& options) {
  const std::string name = output_of(options);
  cli::OutputNames().add("--output", name);
  Resources resources = read_resources(options.file);
  add_keys(resources);
  cli::Output output(name);
  std::string content;
  output.write(zipped(options, resources, content));
  output.commit();
  cli::note("hinge-fmu", fmt::format("wrote {}: {}", name, content));
  for (const std::string& note : resources.notes) cli::warn("hinge-fmu", note);
  return cli::all_good;
}

}  // namespace hinge_fmu
