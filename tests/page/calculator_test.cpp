// Compares the calculator of the page with hinge-joint and hinge-pressure,
// called as their users call them.
#include "page/answer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "libcontact/base/file_text.hpp"
#include "support/program.hpp"

namespace contact::test::calculator_test {
namespace {

using Json = nlohmann::json;

const std::filesystem::path data = CONTACT_DATA_DIR;

std::vector<std::string> shipped_joints() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(data / "joints"))
    names.push_back(entry.path().stem().string());
  return names;
}

std::string text_of(const std::string& joint) {
  return detail::file_text(data / "joints" / (joint + ".toml"));
}

bool is_pin(const std::string& text) {
  return text.find("kind = \"pin\"") != text.npos &&
         text.find("kind = \"pin\"") < text.find("[geometry]");
}

std::string state(bool pin, const std::string& load = "reaction_kN = 10") {
  return load + "\nrate_deg_per_s = 7\n" + (pin ? "" : "beta_deg = 60\n");
}

class EveryJoint : public testing::TestWithParam<std::string> {
 protected:
  const std::string text_ = text_of(GetParam());
  const bool pin_ = is_pin(text_);
  const ProgramFolder folder_;
  const Json answer_ =
      Json::parse(page::Calculator(data).answer(text_, state(pin_)));

  ProgramResult run(const std::string& command) const {
    return folder_.run(command + " --format json --joint data/joints/" +
                       GetParam() + ".toml");
  }
  // The page leaves rims and reliefs out, with a warning.
  std::string without(const std::string& part) const {
    return text_.find("\n[" + part + "]") == text_.npos ? ""
                                                        : " --without-" + part;
  }
};
INSTANTIATE_TEST_SUITE_P(Page, EveryJoint, testing::ValuesIn(shipped_joints()),
                         [](const auto& each) { return each.param; });

TEST_P(EveryJoint, HasTheNumbersOfHingeJointToTheLastBit) {
  const ProgramResult result =
      run(std::string("hinge-joint --reaction 10kN --rate 7deg_per_s --pv ") +
          (pin_ ? "" : "--beta 60") + without("seat") + without("relief"));
  Json row = Json::parse(result.out)[0];
  for (const Json& number : answer_["numbers"]) {
    const std::string name = number["name"];
    ASSERT_TRUE(row.contains(name)) << name;
    EXPECT_EQ(row[name], number["value"]) << name;
    row.erase(name);
  }
  for (const auto& [name, word] : answer_["words"].items()) {
    if (name == "contact_state" && !row.contains(name)) continue;
    EXPECT_EQ(row[name], word);
    row.erase(name);
  }
  EXPECT_TRUE(row.empty()) << row;
  // Its warnings, which name the law if there are several.
  std::set<std::string> unsaid = answer_["warnings"];
  std::istringstream said(result.err);
  for (std::string line; std::getline(said, line);) {
    const std::string mark = "hinge-joint: warning: ";
    if (!line.starts_with(mark)) continue;
    EXPECT_EQ(std::erase_if(unsaid,
                            [&](const std::string& text) {
                              return line.ends_with(text);
                            }),
              1U)
        << line;
  }
  EXPECT_TRUE(unsaid.empty()) << *unsaid.begin();
}

TEST_P(EveryJoint, HasThePressureOfHingePressure) {
  std::map<std::string, double> number;
  for (const Json& each : answer_["numbers"]) {
    if (!each["value"].is_null()) number[each["name"]] = each["value"];
  }
  const Json rows = Json::parse(run("hinge-pressure --points 101 --load " +
                                    Json(number.at("R_n_N")).dump())
                                    .out);
  const Json& p = answer_["pressure"]["p_Pa"];
  ASSERT_EQ(rows.size(), p.size());
  const std::string law = answer_["words"]["pressure"];
  for (std::size_t i = 0; i < p.size(); ++i) {
    // At the edge, where it falls as a root, a rounding of theta0 is 1e-8.
    const double tolerance = i + 1 < p.size() ? 1e-12 : 1e-7;
    EXPECT_NEAR(rows[i]["p_" + law + "_Pa"], p[i],
                tolerance * number.at("p_peak_Pa"))
        << i;
  }
}

TEST_P(EveryJoint, HasCurvesThroughItsState) {
  page::Calculator calculator(data);
  const auto curves_at = [&](const std::string& load) {
    return Json::parse(calculator.curves(text_, state(pin_, load)));
  };
  // 1 kN is a point of the curves, and 2 kN is of the same decades.
  const Json curves = curves_at("reaction_kN = 1");
  EXPECT_EQ(curves, curves_at("reaction_kN = 2"));
  EXPECT_NE(curves, curves_at("reaction_kN = 20"));
  const Json at =
      Json::parse(calculator.answer(text_, state(pin_, "reaction_kN = 1")));
  const Json& loads = curves["R_N"];
  const auto here = std::find(loads.begin(), loads.end(), Json(1000.0));
  ASSERT_NE(here, loads.end());
  int compared = 0;
  for (const Json& number : at["numbers"]) {
    const std::string name = number["name"];
    if (!curves.contains(name)) continue;
    EXPECT_EQ(curves[name][here - loads.begin()], number["value"]) << name;
    compared += name != "R_N";
  }
  EXPECT_GE(compared, 6);
}

std::string error_of(const std::string& joint, const std::string& of_state) {
  const Json answer =
      Json::parse(page::Calculator(data).answer(joint, of_state));
  return answer.value("error", "no error");
}

TEST(Page, RefusalsNameTheKeyAndNoPlace) {
  std::string joint = text_of("pin_joint");
  EXPECT_EQ(error_of(joint, state(true, "reaction_kN = -1")),
            "reaction_kN = -1 must be 0 to 1e+97 kN");
  EXPECT_EQ(error_of(joint, state(true, "reaction_kN = nan")),
            "reaction_kN = nan must be 0 to 1e+97 kN");
  EXPECT_EQ(error_of(joint, state(true, "reaction_kN = \"<b>\"")),
            "reaction_kN = \"<b>\" must be a number");
  EXPECT_EQ(error_of(joint, state(false)),
            "beta_deg = 60 must be left out: it has no effect here");
  EXPECT_EQ(error_of("", ""), "the file requires name");
  joint.replace(joint.find("radius_mm = 20"), 14, "radius_mm = -2");
  EXPECT_EQ(error_of(joint, state(true)),
            "geometry.radius_mm = -2 must be above 0");
}

TEST(Page, TextbookMomentIsCoefficientTimesLoadTimesRadius) {
  const Json answer = Json::parse(
      page::Calculator(data).answer(text_of("pin_joint"), state(true)));
  for (const Json& number : answer["numbers"]) {
    if (number["name"] == "M_textbook_N_m") {
      EXPECT_NEAR(number["value"], 0.1 * 10e3 * 0.02, 1e-14);
    }
  }
}

TEST(Page, FileOfAJointThatNamesAnotherStandsAlone) {
  page::Calculator calculator(data);
  const Json answer =
      Json::parse(calculator.answer(text_of("gimbal_ball"), state(false)));
  const std::string file = answer["same"]["file"];
  EXPECT_EQ(file.find("pair ="), file.npos);
  const Json again = Json::parse(calculator.answer(file, state(false)));
  EXPECT_EQ(again["numbers"], answer["numbers"]);
}

class SameNumbers : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Page, SameNumbers,
                         testing::Values("wheel_ball", "hip_cup",
                                         "relieved_bush"),
                         [](const auto& each) { return each.param; });

TEST_P(SameNumbers, OfTheCommandLine) {
  const ProgramFolder folder;
  const std::string joint = text_of(GetParam());
  const Json answer =
      Json::parse(page::Calculator(data).answer(joint, state(is_pin(joint))));
  folder.write("joint.toml", answer["same"]["file"].get<std::string>());
  const std::string command = answer["same"]["command"];
  const CsvTable table(folder.run_well(command).out);
  for (const Json& number : answer["numbers"]) {
    const std::string name = number["name"];
    EXPECT_EQ(table.value(name), number["value"]) << name;
  }
}

TEST(Page, ChoicesAreThoseOfTheLibrary) {
  const Json choices = Json::parse(page::choices());
  EXPECT_EQ(choices["presets"][0]["name"], "steel_steel_greased");
  EXPECT_EQ(choices["units"]["length"][1]["ending"], "mm");
}

}  // namespace
}  // namespace contact::test::calculator_test
