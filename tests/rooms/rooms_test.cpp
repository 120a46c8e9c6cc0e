// The order of rooms, read off the #include lines: a file includes only from
// its own room and from earlier ones. So no two rooms can include each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace contact::test::rooms_test {
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
    "libcontact/tools/friction_rules",
    "libcontact/joint",
    "libcontact/seat",
    "libcontact/play",
    "libcontact/finite_pin",
    "libcontact/duty",
    "libcontact/models",
    "libcontact/identify",
    "libcontact/load_law",
    "libcontact/quantities",
    "libcontact/files",
    "libcontact/tools/reference",
    "libcontact/c",
    "apps/cli",
    "apps/multibody/system",
    "apps/multibody/dynamics",
    "apps/multibody/tracking",
    "apps/multibody/friction",
    "apps/multibody/motion",
    "apps/separation/case",
    "apps/separation/forces",
    "apps/separation/clearance",
    "apps/separation/simulation",
    "apps/separation/results",
    "apps/separation/c",
    "apps/study",
    "apps/programs/table",
    "apps/programs/angle",
    "apps/programs/pressure",
    "apps/programs/joint",
    "apps/programs/duty",
    "apps/programs/identify",
    "apps/programs/separation/output",
    "apps/programs/separation/replay",
    "apps/programs/separation",
    "apps/programs/study",
    "apps/page",
    "apps/npm",
    "apps/hosts",
    "apps/programs/fmu",
    "apps/python",
};

// Folders and headers that the repository's own programs may include in
// addition to the installed ones: hinge-table compares the routes of the
// friction integrals, hinge-angle prints Hertz' peak, hinge-joint traces the
// paper's loop, the multibody library tracks joints by the kernels, cases and
// studies are TOML files too, hinge-fmu reads files as an FMU does. The texts
// on laws are in their registries.
const std::vector<std::string> for_programs = {
    "libcontact/base",
    "libcontact/friction/elliptic",
    "libcontact/friction/models.hpp",
    "libcontact/half_angle/registry.hpp",
    "libcontact/pressure/registry.hpp",
    "libcontact/pressure/hertz.hpp",
    "libcontact/joint/fixed_point.hpp",
    "libcontact/friction/kernel/cap_kernel.hpp",
    "libcontact/pressure/expansion.hpp",
    "libcontact/joint/slip",
    "libcontact/files",
    "libcontact/c",
    "libcontact/tools/reference"};

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

// Includes of the programs and the library within the repository. A file that
// is not there is one that the build makes.
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
    if (is_below(from, "apps/separation/c"))
      continue;                          // stands on libcontact/c
    if (is_below(from, "apps/hosts")) {  // on nothing else
      EXPECT_TRUE(is_below(to, "libcontact/c")) << from << " includes " << to;
      continue;
    }
    const bool is_inside =
        std::ranges::any_of(for_programs, [&file = to](const auto& one) {
          return file == one || is_below(file, one);
        });
    EXPECT_TRUE(headers.contains(to) || is_inside)
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

// contact.hpp includes all stages, files.hpp the library contact::files; other
// headers would not be reachable.
TEST(PublicFace, IsWhatTheUmbrellasReach) {
  std::set<std::string> reached = {"libcontact/contact.hpp",
                                   "libcontact/files.hpp"};
  const std::vector<Include> all = includes();
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (const auto& [from, to] : all) {
      if (reached.contains(from)) reached.insert(to);
    }
  }
  EXPECT_EQ(reached, installed());
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Names that a header declares at namespace scope, except in namespace detail:
// with the project's formatting they begin in the first column.
std::vector<std::string> public_names(const std::string& header) {
  static const std::regex declared(
      "^(?:(?:class|struct|enum class) (\\w+)\\b(?!;)|using (\\w+) =|"
      "inline constexpr [^=]*?(\\w+) (?:=|\\{)|inline constexpr [^=]* "
      "(\\w+)\\{|(?!#|namespace|template|friend)[A-Za-z][^;={]*?(\\w+)\\()");
  std::vector<std::string> names;
  std::ifstream stream(root / header);
  bool detail = false;
  std::smatch match;
  for (std::string line; std::getline(stream, line);) {
    if (line == "namespace detail {") detail = true;
    if (line.starts_with("}")) detail = false;
    if (detail || !std::regex_search(line, match, declared)) continue;
    const auto name = std::find_if(match.begin() + 1, match.end(),
                                   [](const auto& m) { return m.matched; });
    if (std::ranges::find(names, name->str()) == names.end()) {
      names.push_back(name->str());
    }
  }
  return names;
}

// A name that becomes public is seen in the diff of public_names.txt.
TEST(PublicFace, IsTheOneThatIsWrittenDown) {
  std::string text;
  int count = 0;
  for (const std::string& header : installed()) {
    text += header + ':';
    for (const std::string& name : public_names(header)) {
      text += ' ' + name;
      ++count;
    }
    text += '\n';
  }
  text += std::to_string(installed().size()) + " headers, " +
          std::to_string(count) + " names\n";
  EXPECT_EQ(text_of(root / "tests/rooms/public_names.txt"), text)
      << "tests/rooms/public_names.txt must be:\n"
      << text;
}

bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

// True if the text contains this word as a whole.
bool has_word(const std::string& text, const std::string& word) {
  for (std::size_t at = text.find(word); at != std::string::npos;
       at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool goes_on = is_letter(word.back()) && is_letter(text[end]);
    if (!goes_on && !(at > 0 && is_letter(word[0]) && is_letter(text[at - 1])))
      return true;
  }
  return false;
}

// gone_names.txt: a name, a tab, what to write instead.
TEST(Rooms, NoFileHasANameThatIsGone) {
  std::map<std::string, std::string> gone;
  std::ifstream stream(root / "tests/rooms/gone_names.txt");
  for (std::string line; std::getline(stream, line);) {
    const std::size_t tab = line.find('\t');
    ASSERT_NE(tab, std::string::npos) << line;
    gone.emplace(line.substr(0, tab), line.substr(tab + 1));
  }
  ASSERT_FALSE(gone.empty());
  // The tables of gone names that users see, and this one.
  const std::set<std::string> may = {"apps/cli/gone.hpp",
                                     "apps/python/libcontact/__init__.py",
                                     "tests/rooms/gone_names.txt"};
  for (const std::string folder :
       {"libcontact", "apps", "tests", "scripts", "data", "plots"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string file = fs::relative(entry.path(), root).string();
      if (!entry.is_regular_file() || may.contains(file)) continue;
      const std::string text = text_of(entry.path());
      for (const auto& [name, instead] : gone) {
        EXPECT_FALSE(has_word(text, name))
            << file << " has " << name << ": write " << instead;
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
}  // namespace contact::test::rooms_test
