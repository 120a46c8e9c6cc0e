#include "support/program.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "libcontact/base/error.hpp"

namespace contact::test {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

fs::path new_folder() {
  std::string name = fs::temp_directory_path() / "contact_test_XXXXXX";
  if (mkdtemp(name.data()) == nullptr) throw Error("cannot create " + name);
  return name;
}

}  // namespace

ProgramFolder::ProgramFolder() : path_(new_folder()), streams_(new_folder()) {
  fs::create_directory_symlink(CONTACT_DATA_DIR, path_ / "data");
}

ProgramFolder::~ProgramFolder() {
  fs::remove_all(path_);
  fs::remove_all(streams_);
}

ProgramResult ProgramFolder::run(const std::string& command) const {
  const std::string line = "cd '" + path_.native() + "' && PATH='" +
                           CONTACT_BIN_DIR "':\"$PATH\" && { " + command +
                           "\n} >'" + (streams_ / "out").native() + "' 2>'" +
                           (streams_ / "err").native() + "'";
  const int status = std::system(line.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          contents(streams_ / "out"), contents(streams_ / "err")};
}

ProgramResult ProgramFolder::run_well(const std::string& command) const {
  ProgramResult result = run(command);
  EXPECT_EQ(result.status, 0) << command << '\n' << result.err;
  return result;
}

void ProgramFolder::run_ill(const std::string& command, int status,
                            const std::string& said) const {
  const ProgramResult result = run(command);
  EXPECT_EQ(result.status, status) << command;
  EXPECT_EQ(result.err, said) << command;
}

void ProgramFolder::write(const std::string& name,
                          std::string_view text) const {
  std::ofstream(path_ / name) << text;
}

std::string ProgramFolder::read(const std::string& name) const {
  return contents(path_ / name);
}

bool ProgramFolder::has(const std::string& name) const {
  return fs::exists(path_ / name);
}

bool ProgramFolder::has_page_libraries() const {
  const std::string scripts = "ls /usr/share/javascript/";
  return run(scripts + "three/three.min.js").status == 0 &&
         run(scripts + "dygraphs/dygraph.min.js").status == 0;
}

std::vector<std::string> ProgramFolder::files() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path_)) {
    if (entry.path().filename() != "data") {
      names.push_back(entry.path().filename());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> help_examples(const std::string& program) {
  std::istringstream help(ProgramFolder().run(program + " --help-all").out);
  std::vector<std::string> examples;
  std::string line;
  while (std::getline(help, line) && line != "Examples:") {
  }
  while (std::getline(help, line) && line.starts_with("  ")) {
    examples.push_back(line.substr(2));
  }
  return examples;
}

std::vector<std::vector<std::string>> csv_rows(std::string_view text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    auto& row = rows.emplace_back();
    row.emplace_back();
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') quoted = !quoted;
      if (c == ',' && !quoted) {
        row.emplace_back();
      } else {
        row.back() += c;
      }
    }
  }
  return rows;
}

std::vector<std::string> csv_column(
    const std::vector<std::vector<std::string>>& rows, std::string_view name) {
  if (rows.empty()) throw Error("no header");
  const auto& header = rows.front();
  const auto found = std::find(header.begin(), header.end(), name);
  if (found == header.end()) throw Error("no column " + std::string(name));
  std::vector<std::string> column;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    column.push_back(rows[i].at(found - header.begin()));
  }
  return column;
}

const std::vector<double>& CsvTable::operator[](
    const std::string& column) const {
  auto& numbers = numbers_[column];
  if (!numbers.empty()) return numbers;
  for (const std::string& cell : texts(column)) {
    char* end = nullptr;
    const double number = std::strtod(cell.c_str(), &end);
    numbers.push_back(cell.empty() || *end != '\0' ? NAN : number);
  }
  return numbers;
}

std::size_t CsvTable::row_of(const std::string& quantity) const {
  const auto names = texts("quantity");
  const auto found = std::find(names.begin(), names.end(), quantity);
  if (found == names.end()) throw Error("no quantity " + quantity);
  return static_cast<std::size_t>(found - names.begin()) + 1;
}

}  // namespace contact::test
