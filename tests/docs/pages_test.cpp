// Targets of the pages' references exist: files and headings that links name,
// and the names in the tables of the notation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "libcontact/half_angle/registry.hpp"
#include "libcontact/pair/stress_registry.hpp"
#include "libcontact/pressure/registry.hpp"
#include "libcontact/quantities/tables.hpp"

namespace contact::test::pages_test {
namespace {

namespace fs = std::filesystem;

const fs::path root = CONTACT_SOURCE_DIR;
const fs::path docs = root / "libcontact/docs";

std::string contents(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// Lines outside blocks of code and formulas.
std::vector<std::string> prose(const fs::path& page) {
  std::istringstream text(contents(page));
  std::vector<std::string> lines;
  bool is_code = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) {
      is_code = !is_code;
    } else if (!is_code && !line.starts_with("    ")) {
      lines.push_back(line);
    }
  }
  return lines;
}

/// Everything that a pattern's first group matches.
std::vector<std::string> matches(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator i(text.begin(), text.end(), regex), end; i != end;
       ++i) {
    found.push_back((*i)[1]);
  }
  return found;
}

/// How GitHub names the headings of a page, and the anchors of its tables.
std::set<std::string> anchors(const fs::path& page) {
  std::set<std::string> names;
  for (const std::string& line : prose(page)) {
    for (const std::string& id : matches(line, R"re(<a id="([\w-]+)")re")) {
      EXPECT_TRUE(names.insert(id).second) << page << ": two of " << id;
    }
    const std::size_t level = line.find_first_not_of('#');
    if (level == 0 || level == line.npos || line[level] != ' ') continue;
    std::string name;
    for (const unsigned char c : line.substr(level + 1)) {
      if (c == ' ') name += '-';
      if (std::isalnum(c) || c == '-' || c == '_') {
        name += static_cast<char>(std::tolower(c));
      }
    }
    EXPECT_TRUE(names.insert(name).second) << page << ": two of " << name;
  }
  return names;
}

std::vector<fs::path> pages() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(root)) {
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  }
  for (const char* folder : {"apps", "data", "libcontact"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() == ".md") found.push_back(entry.path());
    }
  }
  return found;
}

TEST(Pages, LinksLeadSomewhere) {
  int links = 0;
  for (const fs::path& page : pages()) {
    std::string text;
    for (const std::string& line : prose(page)) text += line + '\n';
    for (const std::string& link : matches(text, R"(\]\(([^)\s]+)\))")) {
      if (link.find("://") != link.npos) continue;
      ++links;
      const std::size_t hash = link.find('#');
      const fs::path file =
          hash == 0 ? page : page.parent_path() / link.substr(0, hash);
      ASSERT_TRUE(fs::exists(file)) << page << ": " << link;
      if (hash == link.npos) continue;
      EXPECT_TRUE(anchors(file).contains(link.substr(hash + 1)))
          << page << ": " << link;
    }
  }
  EXPECT_GT(links, 50);
}

// data/ledger.csv has the rows of the ledger's page, without its links.
TEST(Pages, LedgerIsThePages) {
  const std::regex link(R"(\[([^\]]*)\]\([^)]*\))");
  const std::string text = std::regex_replace(
      contents(root / "libcontact/docs/explanation/measured.md"), link, "$1");
  std::vector<std::string> page;
  std::istringstream lines(text.substr(text.find("| source")));
  for (std::string line; std::getline(lines, line) && !line.empty();) {
    if (!line.starts_with("| ---")) page.push_back(line);
  }
  std::vector<std::string> rows;
  std::istringstream csv(contents(root / "data/ledger.csv"));
  for (std::string row; std::getline(csv, row);) {
    row = std::regex_replace(row, std::regex("\",\""), " | ");
    rows.push_back("| " + row.substr(1, row.size() - 2) + " |");
  }
  EXPECT_GT(rows.size(), 20U);
  EXPECT_EQ(rows, page);
}

// A source is cited by the key of its row of references.md:
// "references.md#KEY", a link in pages and plain text in docstrings and data
// files.
TEST(Pages, CiteEverySourceAndNoOther) {
  std::set<std::string> cited;
  const auto look = [&](const fs::path& file) {
    const auto keys = matches(contents(file), R"(references\.md#([\w-]+))");
    cited.insert(keys.begin(), keys.end());
  };
  const std::set<std::string> kinds = {".md",   ".hpp", ".cpp", ".h",
                                       ".toml", ".csv", ".py",  ".in"};
  look(root / "README.md");
  for (const char* folder : {"apps", "data", "libcontact"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (kinds.contains(entry.path().extension())) look(entry.path());
    }
  }
  std::set<std::string> rows;
  for (const std::string& line : prose(docs / "reference/references.md")) {
    const auto key = matches(line, R"re(^\| <a id="([\w-]+)"></a>\1 \|)re");
    // The rows of a table without its header and the line below it.
    if (line.starts_with("| ") && !line.starts_with("| key")) {
      EXPECT_EQ(key.size(), 1u) << line;
    }
    rows.insert(key.begin(), key.end());
  }
  EXPECT_GT(rows.size(), 50u);
  EXPECT_EQ(cited, rows);
}

// "docs/FOLDER/PAGE.md" in comments and messages is a page.
TEST(Pages, ThatTheCodeNamesAreThere) {
  int count = 0;
  const std::set<std::string> kinds = {".hpp", ".cpp", ".h", ".py", ".txt"};
  for (const char* folder : {"apps", "libcontact"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (!kinds.contains(entry.path().extension())) continue;
      for (const std::string& page :
           matches(contents(entry.path()), R"(docs/([\w/-]+\.md))")) {
        ++count;
        EXPECT_TRUE(fs::exists(docs / page)) << entry << ": " << page;
      }
    }
  }
  EXPECT_GT(count, 50);
}

/// Number of words in a text; single punctuation marks do not count.
std::ptrdiff_t words(const std::string& text) {
  std::istringstream stream(text);
  return std::count_if(std::istream_iterator<std::string>(stream), {},
                       [](const std::string& word) {
                         return std::ranges::any_of(word, [](unsigned char c) {
                           return std::isalnum(c) || c > 127;
                         });
                       });
}

// For the README all words count, for pages only their prose.
TEST(Pages, ForUsersAreReadInFiveMinutes) {
  EXPECT_LE(words(contents(root / "README.md")), 900);
  for (const char* folder : {"tutorials", "how-to", "explanation"}) {
    for (const auto& entry : fs::directory_iterator(docs / folder)) {
      std::string text;
      for (const std::string& line : prose(entry)) {
        if (!line.starts_with("|")) text += line + '\n';
      }
      EXPECT_LE(words(text), 1200) << entry;
    }
  }
}

/// Commands in blocks of code, with the lines that continue them.
std::vector<std::string> commands(const fs::path& page) {
  std::istringstream text(contents(page));
  std::vector<std::string> lines;
  bool is_code = false;
  bool goes_on = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) is_code = !is_code;
    if (is_code && (goes_on || line.starts_with("$ "))) {
      lines.push_back(line);
      goes_on = line.ends_with('\\');
    }
  }
  return lines;
}

TEST(Pages, CommandsFitATerminal) {
  std::size_t count = 0;
  for (const fs::path& page : pages()) {
    for (const std::string& line : commands(page)) {
      ++count;
      EXPECT_LE(line.size(), 80U) << page << ": " << line;
    }
  }
  EXPECT_GT(count, 100U);
}

// They print what they show without filters, and end with a picture.
TEST(Pages, TutorialsEndWithAPicture) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(docs / "tutorials")) {
    if (entry.path().filename() == "index.md") continue;
    ++count;
    EXPECT_TRUE(prose(entry).back().starts_with("![")) << entry;
    for (const std::string& line : commands(entry)) {
      EXPECT_TRUE(matches(line, R"(\b(grep|awk|sed)\b)").empty()) << line;
    }
  }
  EXPECT_EQ(count, 5);
}

// A page is found by the index of its folder, and that by the index of all.
TEST(Pages, AreInAnIndex) {
  const auto expect_link = [](const fs::path& index, const std::string& link) {
    EXPECT_NE(contents(index).find("](" + link + ')'), std::string::npos)
        << index << " has no link to " << link;
  };
  for (const auto& folder : fs::directory_iterator(docs)) {
    if (!folder.is_directory()) continue;
    const fs::path index = folder.path() / "index.md";
    expect_link(docs / "index.md", folder.path().filename() / "index.md");
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path() == index) continue;
      expect_link(index, entry.path().filename());
    }
  }
}

TEST(Pages, HaveOneVersion) {
  const auto version = [](const char* file, const char* pattern) {
    const auto found = matches(contents(root / file), pattern);
    return found.empty() ? std::string(file) : found.front();
  };
  const std::string ours =
      version("CMakeLists.txt", R"(libcontact VERSION ([\d.]+))");
  EXPECT_EQ(version("CITATION.cff", R"(\nversion: ([\d.]+))"), ours);
  EXPECT_EQ(version("cmake/vcpkg/vcpkg.json", R"("version": "([\d.]+))"), ours);
  // The version in progress is above the last released one.
  const std::string newest = version("CHANGELOG.md", R"(\n## ([\w.]+))");
  if (newest == "Unreleased") {
    EXPECT_NE(version("CHANGELOG.md", R"(\n## (\d[\d.]*) - )"), ours);
  } else {
    EXPECT_EQ(newest, ours);
  }
  EXPECT_EQ(version("libcontact/c/status.h", R"(VERSION "([\d.]+))"), ours);
}

TEST(Pages, TimesOfTheReadmeAreMeasured) {
  const std::string measured = contents(docs / "reference/speed.md");
  int times = 0;
  for (const std::string& line : prose(root / "README.md")) {
    if (!std::regex_search(line, std::regex(R"(^\|.*\d [nm]s )"))) continue;
    ++times;
    EXPECT_NE(measured.find(line + '\n'), measured.npos) << line;
  }
  EXPECT_EQ(times, 4);
}

/// The names in each header of the library, functions with their "(".
std::vector<std::set<std::string>> headers() {
  std::vector<std::set<std::string>> found;
  for (const auto& entry :
       fs::recursive_directory_iterator(root / "libcontact")) {
    if (entry.path().extension() != ".hpp") continue;
    const std::string code =
        std::regex_replace(contents(entry.path()), std::regex("//[^\n]*"), "");
    const auto names = matches(code, R"((\w+\(?))");
    found.emplace_back(names.begin(), names.end());
  }
  return found;
}

// `Class::member()`: one header has both, and member is a function.
TEST(Notation, NamesAreInTheHeaders) {
  const auto known = headers();
  int count = 0;
  for (const std::string& line : prose(docs / "reference/notation.md")) {
    if (!line.starts_with("| ")) continue;
    for (const std::string& name : matches(line, "`([^`]+)`")) {
      ++count;
      const auto parts = matches(name, R"((\w+\(?))");
      EXPECT_TRUE(std::ranges::any_of(known, [&](const auto& header) {
        return std::ranges::all_of(
            parts, [&](const auto& part) { return header.contains(part); });
      })) << name;
    }
  }
  EXPECT_GT(count, 50);
}

/// Cells of a line of a table.
std::vector<std::string> cells(const std::string& line) {
  return matches(line, R"(\| ([^|]*?) ?(?=\|))");
}

/// A symbol in LaTeX or in ASCII as letters and digits: theta0 of \theta_0.
std::string plain(const std::string& symbol) {
  return std::regex_replace(symbol, std::regex(R"(\\text|[\\{}_])"), "");
}

// Columns of joints are called as here; what the code calls by the same name is
// in the same unit.
TEST(Notation, HasTheSymbolsOfColumns) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : prose(docs / "reference/notation.md")) {
    if (line.starts_with("| ")) rows.push_back(cells(line));
  }
  int units = 0;
  for (const auto& q : contact::solution_quantities()) {
    if (q.symbol.empty()) continue;
    const auto row = std::ranges::find_if(rows, [&](const auto& r) {
      const auto symbols = matches(plain(r[0]), R"((\w+))");
      return std::ranges::count(symbols, plain(std::string(q.symbol))) > 0;
    });
    EXPECT_NE(row, rows.end()) << q.symbol;
    for (const auto& r : rows) {
      const std::string name = "`JointSolution::" + std::string(q.key);
      if (r.size() < 4 || (r[2].find(name + '`') == r[2].npos &&
                           r[2].find(name + "()`") == r[2].npos)) {
        continue;
      }
      ++units;
      const std::string unit = contact::unit_text(q.dimension);
      EXPECT_EQ(r[3], unit.empty() ? "1" : unit) << q.key;
    }
  }
  EXPECT_GT(units, 10);
}

// Tables of laws have a row for each entry of the registries, in its words.
TEST(Docs, TablesOfLawsAreThoseOfTheRegistries) {
  const auto page = [](const std::string& name) {
    std::string text = contents(docs / name);
    std::erase(text, '`');
    return text;
  };
  const auto expect_row = [](const std::string& text, std::string_view first,
                             std::string_view second) {
    const std::string row =
        "\n| " + std::string(first) + " | " + std::string(second);
    EXPECT_NE(text.find(row), text.npos) << row;
  };
  const std::string half_angle = page("explanation/half_angle.md");
  for (const auto* law : contact::detail::half_angle_entries()) {
    expect_row(half_angle, law->about.name, law->about.meaning);
  }
  const std::string pressure = page("explanation/pressure.md");
  for (const auto* law : contact::detail::pressure_entries()) {
    expect_row(pressure, law->about.name, law->shape);
  }
  const std::string stress = page("how-to/friction_stress.md");
  for (const auto* law : contact::detail::stress_entries()) {
    expect_row(stress, '"' + std::string(law->name) + '"', law->meaning);
  }
}

}  // namespace
}  // namespace contact::test::pages_test
