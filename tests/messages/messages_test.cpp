// Messages for bad files and names, listed in the .txt files of this folder.
//
// The first line of a section names the reader and the file to start from:
// "joint ball.toml". "4| TEXT" edits the file as EditedFile does, "| TEXT" adds
// a line below; edits right below the first line hold for the whole section. "=
// MESSAGE" gives the expected message, "= fine" expects none, and "~ MESSAGE"
// gives the beginning of the message.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "libcontact/files/joint_file.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/half_angle/paper_laws.hpp"
#include "libcontact/pressure/factory.hpp"
#include "separation/case/case_reader.hpp"
#include "support/edited_file.hpp"
#include "support/error_message.hpp"

namespace contact::test::messages_test {
namespace {

namespace fs = std::filesystem;

const auto soft_seat = ElasticPair::from_modulus_ratio(3, 0.3, 0.3);

// Words of a constructor's line.
struct Arguments {
  std::vector<std::string> words;

  Arguments(const std::string& text) {
    std::istringstream stream(text);
    for (std::string word; stream >> word;) words.push_back(word);
  }
  std::string word(std::size_t i) const {
    return i < words.size() ? words[i] : "";
  }
  double operator[](std::size_t i) const { return std::stod(words.at(i)); }
};

std::unique_ptr<HalfAngleLaw> law(const std::string& name,
                                  const HalfAngleOptions& options = {}) {
  return make_half_angle_law(name, JointKind::ball, soft_seat, options);
}

using Call = std::function<void(const std::string&)>;
using A = Arguments;

const std::map<std::string, Call> constructors = {
    {"elastic_pair",
     [](const A& a) {
       ElasticPair({a[0], a[1], a.word(4)}, {a[2], a[3]});
     }},
    {"modulus_ratio",
     [](const A& a) { ElasticPair::from_modulus_ratio(a[0], a[1], a[2]); }},
    {"ball", [](const A& a) { JointGeometry::ball(a[0], a[1]); }},
    {"pin", [](const A& a) { JointGeometry::pin(a[0], a[1], a[2]); }},
    {"fit", [](const A& a) { Fit(a.word(0), a.word(1), a[2]); }},
    {"friction_law", [](const A& a) { FrictionLaw(a[0], a[1]); }},
    {"patch", [](const A& a) { InnerLoading::back(a[0]); }},
    {"limit", [](const A& a) { LimitHalfAngle::given(a[0]); }},
    {"arctan_limit", [](const A& a) { LimitHalfAngle::arctan_formula(a[0]); }},
    {"linear_limit", [](const A& a) { LimitHalfAngle::linear_formula(a[0]); }},
    {"slope", [](const A& a) { law("tanh", {.initial_slope = a[0]}); }},
    {"linear_law", [](const A& a) { law(a.word(0), {.linear_limit = true}); }},
    {"half_angle_law", [](const A& a) { law(a.word(0)); }},
    {"pressure_law",
     [](const A& a) {
       make_pressure_law(a.word(0), JointKind::ball, soft_seat);
     }},
};

const std::map<std::string, Call> readers = {
    {"joint", [](const auto& text) { parse_joint(text, "j.toml"); }},
    {"pair", [](const auto& text) { parse_material_pair(text, "p.toml"); }},
    {"case", [](const auto& text) { separation::parse_case(text, "c.toml"); }},
};

class Messages : public testing::TestWithParam<fs::path> {};

TEST_P(Messages, AreAsWritten) {
  Call call;
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
      const std::string said = error_message([&] { call(file.text()); });
      if (line[0] == '~') {
        EXPECT_TRUE(said.starts_with(expected)) << said;
      } else {
        EXPECT_EQ(said, expected == "fine" ? "(no error)" : expected);
      }
      EXPECT_FALSE(has_text(said, "\n"));
      file = section;
      ++messages;
    } else if (line.starts_with("> ")) {
      const auto blank = std::min(line.find(' ', 2), line.size());
      call = constructors.at(line.substr(2, blank - 2));
      file = EditedFile().edit("+", line.substr(blank));
    } else if (bar != line.npos && line[bar] == '|') {
      file.edit(line.substr(0, bar),
                line.substr(std::min(bar + 2, line.size())));
      if (of_section) section = file;
    } else if (line[0] != '#') {
      const auto blank = line.find(' ');
      call = readers.at(line.substr(0, blank));
      section = file = EditedFile(line.substr(blank + 1));
      of_section = true;
    }
  }
  EXPECT_GT(messages, 0);
}

std::vector<fs::path> scripts() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(messages_folder())) {
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
}  // namespace contact::test::messages_test
