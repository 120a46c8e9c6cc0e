// Command lines that the programs refuse, from tests/messages/options/*.txt:
// one message, exit status 2, and no file is made or changed.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "support/edited_file.hpp"
#include "support/program.hpp"

namespace contact::test::messages_test {
namespace {

// A file of cases has lines
//   file NAME TEXT   a file in the folder, \n for the ends of its lines,
//                    \t for tabs
//   $ PROGRAM ...    a command line, with "--output table.csv" unless it has
//                    another output or is hinge-separation's or -study's
//   MESSAGE          what it says behind "PROGRAM: "; "..." stands for any text
struct Case {
  std::string command;
  std::string message;
};

std::vector<Case> cases(const std::string& name, const ProgramFolder& folder) {
  std::vector<Case> all;
  for (const std::string& line :
       lines_of(messages_folder() / "options" / (name + ".txt"))) {
    if (line.empty() || line.starts_with('#')) continue;
    if (line.starts_with("$ ")) {
      all.push_back({line.substr(2), ""});
    } else if (line.starts_with("file ")) {
      const std::size_t end = line.find(' ', 5);
      std::string text = line.substr(end + 1);
      for (const auto& [code, c] : {std::pair{"\\n", "\n"}, {"\\t", "\t"}}) {
        for (std::size_t at; (at = text.find(code)) != text.npos;) {
          text.replace(at, 2, c);
        }
      }
      folder.write(line.substr(5, end - 5), text);
    } else {
      all.back().message = line;
    }
  }
  return all;
}

bool fits(std::string_view text, std::string_view form) {
  const std::size_t gap = form.find("...");
  if (gap == form.npos) return text == form;
  if (!text.starts_with(form.substr(0, gap))) return false;
  const std::string_view rest = form.substr(gap + 3);
  for (std::size_t at = gap; at <= text.size(); ++at) {
    if (fits(text.substr(at), rest)) return true;
  }
  return false;
}

// The files of a folder and their contents.
std::map<std::string, std::string> contents(const ProgramFolder& folder) {
  std::map<std::string, std::string> all;
  for (const std::string& name : folder.files()) all[name] = folder.read(name);
  return all;
}

class Messages : public testing::TestWithParam<std::string> {};

TEST_P(Messages, AreOneLineAndLeaveNoFile) {
  const ProgramFolder folder;
  const std::vector<Case> all = cases(GetParam(), folder);
  ASSERT_GT(all.size(), 10U);
  folder.write("table.csv", "old");
  const auto before = contents(folder);
  for (const auto& [command, message] : all) {
    const std::string program = command.substr(0, command.find(' '));
    const bool output =
        command.find("--output") != command.npos || command.ends_with(">&-") ||
        program == "hinge-separation" || program == "hinge-study";
    const ProgramResult result =
        folder.run(command + (output ? "" : " --output table.csv"));
    EXPECT_EQ(result.status, 2) << command;
    EXPECT_EQ(result.out, "") << command;
    ASSERT_FALSE(message.empty()) << command;
    EXPECT_TRUE(fits(result.err, program + ": " + message + '\n'))
        << command << '\n'
        << result.err << "instead of\n"
        << message;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1)
        << result.err;
    EXPECT_EQ(contents(folder), before) << command;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Messages,
                         testing::Values("table", "angle", "pressure", "joint",
                                         "separation", "output", "duty",
                                         "identify", "study", "fmu"),
                         [](const auto& name) { return name.param; });

// Every example in every program's --help runs as printed.
class HelpExamples : public testing::TestWithParam<const char*> {};

TEST_P(HelpExamples, Run) {
  const auto examples = help_examples(GetParam());
  EXPECT_GE(examples.size(), 3U);
  for (const std::string& example : examples) {
    const auto result = ProgramFolder().run(example);
    EXPECT_EQ(result.status, 0) << example << '\n' << result.err;
    EXPECT_TRUE(result.out.find('\n') != std::string::npos ||
                example.find("--output") != std::string::npos)
        << example;
  }
}

INSTANTIATE_TEST_SUITE_P(Programs, HelpExamples,
                         testing::Values("hinge-table", "hinge-angle",
                                         "hinge-joint", "hinge-pressure",
                                         "hinge-separation", "hinge-duty",
                                         "hinge-identify", "hinge-study",
                                         "hinge-fmu"));

}  // namespace
}  // namespace contact::test::messages_test
