// The order of rooms, read off the #include lines: a file includes only from
// its own room and from earlier ones. So no two rooms can include each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

// Folders with their subfolders, lowest first: the physics, then the programs,
// then the doors to other languages.
const std::vector<std::string> rooms = {
    "libcontact/base",
    "libcontact/pair",
    "libcontact/conforming",
    "libcontact/half_angle",
    "libcontact/pressure",
    "libcontact/friction",
    "libcontact/joint",
    "libcontact/duty",
    "libcontact/identify",
    "libcontact/tracking",
    "libcontact/files",
    "libcontact/reference",
    "apps/cli",
    "apps/table",
    "apps/angle",
    "apps/pressure",
    "apps/joint",
    "apps/duty",
    "apps/identify",
    "apps/multibody/system",
    "apps/multibody/dynamics",
    "apps/multibody/friction",
    "apps/multibody/motion",
    "apps/separation/case",
    "apps/separation/simulation",
    "apps/separation/clearance",
    "apps/separation/record",
    "apps/separation/output",
    "apps/separation/replay",
    "apps/separation",
    "apps/study",
    "libcontact/python",
    "libcontact/c",
};

const fs::path root = CONTACT_SOURCE_DIR;

struct Include {
  std::string from;  // paths in the repository
  std::string to;
};

bool is_below(const std::string& file, const std::string& folder) {
  return file.starts_with(folder + "/");
}

// Place of a file's room in the order; -1: in none.
int place(const std::string& file) {
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (is_below(file, rooms[i])) return static_cast<int>(i);
  }
  return -1;
}

std::vector<std::string> sources(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".hpp" || ending == ".cpp" || ending == ".h") {
      files.push_back(fs::relative(entry.path(), root).string());
    }
  }
  return files;
}

// What the programs and the library include of the repository. A file that is
// not there is one that the build makes.
std::vector<Include> includes() {
  static const std::regex line_of("^#include [<\"]([^>\"]+)[>\"]");
  std::vector<Include> all;
  for (const std::string folder : {"libcontact", "apps"}) {
    for (const std::string& file : sources(folder)) {
      std::ifstream stream(root / file);
      std::smatch match;
      for (std::string line; std::getline(stream, line);) {
        if (!std::regex_search(line, match, line_of)) continue;
        for (const std::string prefix : {"", "apps/"}) {
          const std::string to = prefix + match[1].str();
          if (fs::exists(root / to)) all.push_back({file, to});
        }
      }
    }
  }
  return all;
}

// The installed headers: the list in libcontact/CMakeLists.txt.
std::set<std::string> installed() {
  std::ifstream stream(CONTACT_PUBLIC_HEADERS);
  std::set<std::string> headers;
  for (std::string line; std::getline(stream, line);) {
    headers.insert("libcontact/" + line);
  }
  return headers;
}

// libcontact/STAGE.hpp: for users; our own files name what they need.
bool is_umbrella(const std::string& file) {
  return file.starts_with("libcontact/") &&
         std::count(file.begin(), file.end(), '/') == 1;
}

TEST(Rooms, IncludeOnlyLowerOnes) {
  const std::vector<Include> all = includes();
  ASSERT_GT(all.size(), 500u);  // some 1,000: the lines are being read
  for (const auto& [from, to] : all) {
    if (is_umbrella(from)) continue;
    EXPECT_FALSE(is_umbrella(to)) << from << " includes the umbrella " << to;
    if (is_umbrella(to)) continue;
    ASSERT_GE(place(from), 0) << from << " is in no room";
    ASSERT_GE(place(to), 0) << to << " is in no room";
    EXPECT_GE(place(from), place(to)) << from << " includes " << to;
  }
}

TEST(Rooms, ProgramsIncludeInstalledHeadersOnly) {
  const std::set<std::string> headers = installed();
  ASSERT_TRUE(headers.contains("libcontact/contact.hpp"));
  for (const auto& [from, to] : includes()) {
    if (!from.starts_with("apps/") || !to.starts_with("libcontact/")) continue;
    // hinge-table's method `quadrature` is the second library's.
    EXPECT_TRUE(headers.contains(to) || is_below(to, "libcontact/base") ||
                is_below(to, "libcontact/reference"))
        << from << " includes " << to << ", which is not installed";
  }
}

TEST(Rooms, InstalledHeadersIncludeInstalledHeadersOnly) {
  const std::set<std::string> headers = installed();
  for (const std::string& header : headers) {
    EXPECT_TRUE(fs::exists(root / header)) << header;
  }
  for (const auto& [from, to] : includes()) {
    if (!headers.contains(from)) continue;
    EXPECT_TRUE(headers.contains(to)) << from << " includes " << to;
  }
}

// base/simd.hpp refuses lanes that the compiler gets wrong.
TEST(Rooms, LanesHaveOneDoor) {
  for (const std::string folder : {"libcontact", "apps", "tests"}) {
    for (const std::string& file : sources(folder)) {
      if (file == "libcontact/base/simd.hpp") continue;
      std::ifstream stream(root / file);
      for (std::string line; std::getline(stream, line);) {
        EXPECT_FALSE(line.starts_with("#include <experimental/simd>")) << file;
      }
    }
  }
}

// More and a folder no longer shows what is in it.
TEST(Rooms, FoldersHaveAtMostThirtySources) {
  std::map<std::string, int> count;
  for (const std::string folder : {"libcontact", "apps", "tests"}) {
    for (const std::string& file : sources(folder)) {
      ++count[fs::path(file).parent_path().string()];
    }
  }
  for (const auto& [folder, files] : count) EXPECT_LE(files, 30) << folder;
}

}  // namespace
