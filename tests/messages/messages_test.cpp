// What is said about files and names that are wrong: the messages stand in the
// .txt files of this folder.
//
// A section begins with what reads and the file it starts from, "joint
// ball.toml". "4| TEXT" edits it as EditedFile does, "| TEXT" adds a line
// below; edits right below the section's first line hold for all of it. "=
// MESSAGE" is what reading says then, "= fine" is nothing, and "~ MESSAGE" is
// how it begins.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "libcontact/files/joint_file.hpp"
#include "separation/case/case_reader.hpp"
#include "support/edited_file.hpp"
#include "support/error_message.hpp"

namespace {

namespace fs = std::filesystem;
using contact::test::EditedFile;
using contact::test::lines_of;

const std::map<std::string, std::function<void(const std::string&)>> readers = {
    {"joint", [](const auto& text) { contact::parse_joint(text, "j.toml"); }},
    {"pair",
     [](const auto& text) { contact::parse_material_pair(text, "p.toml"); }},
    {"case", [](const auto& text) { separation::parse_case(text, "c.toml"); }},
};

class Messages : public testing::TestWithParam<fs::path> {};

TEST_P(Messages, AreAsWritten) {
  std::string reader;
  EditedFile section, file;
  bool of_section = false;
  int messages = 0;
  int number = 0;
  for (const std::string& line : lines_of(GetParam())) {
    SCOPED_TRACE(GetParam().string() + ':' + std::to_string(++number));
    const auto bar = line.find_first_not_of("0123456789.+");
    if (line.empty()) {
      of_section = false;
    } else if (line.starts_with("= ") || line.starts_with("~ ")) {
      const std::string expected = line.substr(2);
      const std::string said = contact::test::error_message(
          [&] { readers.at(reader)(file.text()); });
      if (line[0] == '~') {
        EXPECT_TRUE(said.starts_with(expected)) << said;
      } else {
        EXPECT_EQ(said, expected == "fine" ? "(no error)" : expected);
      }
      EXPECT_EQ(said.find('\n'), said.npos);
      file = section;
      ++messages;
    } else if (bar != line.npos && line[bar] == '|') {
      file.edit(line.substr(0, bar),
                line.substr(std::min(bar + 2, line.size())));
      if (of_section) section = file;
    } else if (line[0] != '#') {
      const auto blank = line.find(' ');
      reader = line.substr(0, blank);
      ASSERT_TRUE(readers.contains(reader)) << line;
      section = file = EditedFile(line.substr(blank + 1));
      of_section = true;
    }
  }
  EXPECT_GT(messages, 0);
}

std::vector<fs::path> scripts() {
  std::vector<fs::path> found;
  for (const auto& entry :
       fs::directory_iterator(contact::test::messages_folder)) {
    if (entry.path().extension() == ".txt") found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

INSTANTIATE_TEST_SUITE_P(Files, Messages, testing::ValuesIn(scripts()),
                         [](const auto& test) {
                           return test.param.stem().string();
                         });

}  // namespace
