#include "programs/fmu/shared_object.hpp"

#include <array>
#include <cstdio>
#include <regex>
#include <sstream>

#include "cli/stream/quoting.hpp"
#include "libcontact/base/error.hpp"

namespace hinge_fmu {
namespace {

namespace fs = std::filesystem;

// Output of the loader for a shared object: lines "NAME => PATH (ADDRESS)".
std::string said_by_loader(const fs::path& object) {
  const std::string command = "ldd " + cli::shell_word(object.string());
  std::FILE* const pipe = ::popen(command.c_str(), "r");
  if (!pipe) throw contact::Error("ldd: cannot be run");
  std::string text;
  std::array<char, 4096> block;
  while (const std::size_t size =
             std::fread(block.data(), 1, block.size(), pipe)) {
    text.append(block.data(), size);
  }
  if (::pclose(pipe) != 0) throw contact::Error("ldd: cannot be run");
  return text;
}

}  // namespace

std::string platform(int version) {
#if defined(__x86_64__)
  return version == 2 ? "linux64" : "x86_64-linux";
#else
  return "aarch64-linux";
#endif
}

fs::path shared_object(const std::string& name) {
  const fs::path bin = fs::read_symlink("/proc/self/exe").parent_path();
  for (const char* const folder : {"../lib", "../" CONTACT_LIBDIR}) {
    fs::path path = (bin / folder / name).lexically_normal();
    if (fs::exists(path)) return path;
  }
  throw contact::Error(name + " must be beside the program, in " +
                       (bin / ("../" CONTACT_LIBDIR)).string());
}

std::map<std::string, fs::path> carried_libraries(const fs::path& object) {
  static const std::regex line_of(R"(\s*(\S+) => (.*) \(0x.*\))");
  static const std::regex runtime(
      R"((libc|libm|libdl|librt|libpthread|libgcc_s|libstdc\+\+|lib.*san)\.so.*)");
  std::map<std::string, fs::path> all;
  std::istringstream lines(said_by_loader(object));
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with("=> not found")) {
      throw contact::Error(object.string() + " requires" + line);
    }
    if (!std::regex_match(line, match, line_of)) continue;
    const std::string name = match[1];
    if (!std::regex_match(name, runtime)) all[name] = match[2].str();
  }
  return all;
}

}  // namespace hinge_fmu
