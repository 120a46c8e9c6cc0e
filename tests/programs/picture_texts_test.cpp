// Every picture that help, pages and the demonstration show, and those that
// readers found cut: no text leaves the canvas, none lies over another one.
// Sizes of texts are those by which pictures are laid out.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include "cli/picture/text_size.hpp"
#include "support/program.hpp"

namespace contact::test::picture_texts_test {
namespace {

// A text of an SVG that gnuplot has drawn, dots from the left and the top.
struct Text {
  std::string text;
  double left;
  double right;
  double top;
  double bottom;

  bool overlaps(const Text& other) const {
    constexpr double rounding = 0.01;
    return std::min(right, other.right) - std::max(left, other.left) >
               rounding &&
           std::min(bottom, other.bottom) - std::max(top, other.top) > rounding;
  }
};

struct Drawing {
  double width;
  double height;
  std::vector<Text> texts;
};

std::string unescaped(std::string text) {
  for (const auto& [code, c] :
       {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}}) {
    for (std::size_t i = 0; (i = text.find(code, i)) != text.npos; ++i) {
      text.replace(i, std::string(code).size(), c);
    }
  }
  return text;
}

Drawing drawing_of(const std::string& svg) {
  std::smatch size;
  EXPECT_TRUE(std::regex_search(
      svg, size, std::regex(R"(viewBox="0 0 ([\d.]+) ([\d.]+)\")")));
  Drawing drawing{std::stod(size[1]), std::stod(size[2]), {}};
  static const std::regex text_form(
      R"re(translate\(([\d.-]+),([\d.-]+)\)( rotate\(270\))?"[^>]*)re"
      R"re(font-size="([\d.]+)"[^>]*text-anchor="(\w+)">\s*<text>)re"
      R"re((?:<tspan[^>]*>)?([^<]*))re");
  for (auto i = std::sregex_iterator(svg.begin(), svg.end(), text_form);
       i != std::sregex_iterator(); ++i) {
    const std::smatch& m = *i;
    const std::string text = unescaped(m[6]);
    if (text.find_first_not_of(' ') == text.npos) continue;
    const double font = std::stod(m[4]);
    const double width = font * cli::text_width(text);
    // From the anchor along the line, and up from its base.
    const double begin = m[5] == "start"    ? 0
                         : m[5] == "middle" ? -width / 2
                                            : -width;
    const double up = 0.73 * font;    // digits and capitals
    const double down = 0.02 * font;  // descenders may touch
    const double x = std::stod(m[1]);
    const double y = std::stod(m[2]);
    drawing.texts.push_back(
        m[3].matched
            ? Text{text, x - up, x + down, y - begin - width, y - begin}
            : Text{text, x + begin, x + begin + width, y - up, y + down});
  }
  return drawing;
}

void expect_readable(const std::string& svg, const std::string& of) {
  const Drawing drawing = drawing_of(svg);
  EXPECT_GE(drawing.texts.size(), 4u) << of;
  for (std::size_t i = 0; i < drawing.texts.size(); ++i) {
    const Text& text = drawing.texts[i];
    EXPECT_TRUE(text.left >= 0 && text.right <= drawing.width &&
                text.top >= 0 && text.bottom <= drawing.height)
        << of << ": \"" << text.text << "\" leaves the canvas: " << text.left
        << " to " << text.right << ", " << text.top << " to " << text.bottom;
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(text.overlaps(drawing.texts[j]))
          << of << ": \"" << text.text << "\" over \"" << drawing.texts[j].text
          << '"';
    }
  }
}

// Runs it and looks at all pictures that it leaves.
void expect_good_pictures(const std::string& command) {
  const ProgramFolder folder;
  if (!folder.has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  folder.run_well(command + " >table");
  int pictures = 0;
  for (const std::string& file : folder.files()) {
    if (!file.ends_with(".svg")) continue;
    ++pictures;
    expect_readable(folder.read(file), command + ", " + file);
  }
  EXPECT_GT(pictures, 0) << command;
}

class HelpPictures : public testing::TestWithParam<const char*> {};

TEST_P(HelpPictures, AreReadable) {
  for (const std::string& example : help_examples(GetParam())) {
    if (example.find(".svg") != example.npos) expect_good_pictures(example);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, HelpPictures,
                         testing::Values("hinge-angle", "hinge-joint",
                                         "hinge-pressure", "hinge-duty"));

struct Picture {
  const char* name;
  std::string command;
};

class Pictures : public testing::TestWithParam<Picture> {};

TEST_P(Pictures, AreReadable) { expect_good_pictures(GetParam().command); }

const std::string hip = "--joint data/joints/hip_cocr_uhmwpe.toml ";
const std::string open_hip =
    "--joint data/joints/hip_cocr_uhmwpe_infinite.toml ";
const std::string pin = "--joint data/joints/pin_joint.toml ";
const std::string nine =
    "--set 'wall.layer[1].thickness_mm=5,8,12' --set "
    "geometry.radius_mm=14,16,18 ";
const std::string eight =
    "--set 'wall.layer[1].thickness_mm=5,12' --set "
    "geometry.radius_mm=14,16,18,20 ";
const std::string hip_cycle = "--cycle data/duty/hip_cycle.csv --euler zxy ";

INSTANTIATE_TEST_SUITE_P(
    Of, Pictures,
    testing::Values(
        Picture{"identification",
                "hinge-identify --joint data/duty/torque_rig.toml --data "
                "data/duty/torque_rig.csv --plot p.svg"},
        Picture{"pin_contact", "hinge-joint " + pin +
                                   "--reaction 20kN --rate 0.4 --map p.svg"},
        Picture{"ball_contact",
                "hinge-joint " + hip +
                    "--reaction 2000 --beta 50 --rate 2 --map p.svg"},
        Picture{"spinning_contact",
                "hinge-joint " + hip +
                    "--reaction 2000 --beta 0 --rate 0.02 --map p.svg"},
        Picture{"small_moments",
                "printf 'time_s,R_x_N,R_y_N,R_z_N,angle_deg\n0,1,0,0,0\n"
                "0.25,1.5,0,0,1\n0.5,1,0,0,0\n0.75,1.5,0,0,-1\n' | hinge-duty "
                "--joint data/joints/wheel_pin.toml --cycle - --plot p.svg"},
        Picture{"long_title", "hinge-joint " + hip +
                                  "--reaction 10:5000:log20 --beta 30,60,90 "
                                  "--plot p.svg"},
        Picture{"nine_half_angles", "hinge-angle " + hip + nine +
                                        "--load 100:3000:100 --plot p.svg"},
        Picture{"nine_pressures",
                "hinge-pressure " + hip + nine + "--load 1000 --plot p.svg"},
        Picture{"pressures_in_a_seat",
                "hinge-pressure data/joints/hip_cup.toml --load 1kN,2kN "
                "--direction 0:80:20 --plot p.svg"},
        Picture{"pressures_along_a_pin",
                "hinge-pressure data/joints/relieved_bush.toml --load 10kN "
                "--tilt 0:0.1:0.02 --plot p.svg"},
        Picture{"eight_moments", "hinge-joint " + hip + eight +
                                     "--reaction 100:3000:100 --beta 60 "
                                     "--plot p.svg"},
        Picture{"logarithmic_loads",
                "hinge-angle " + pin + "--load 10kN:300kN:log20 --plot p.svg"},
        Picture{"long_loads",
                "hinge-angle " + pin + "--load 10kN:300kN:1kN --plot p.svg"},
        Picture{"all_laws", "hinge-angle " + open_hip +
                                "--load 1:5000:log100 --law all --plot p.svg"},
        Picture{"pin_wear",
                "hinge-duty " + pin +
                    "--cycle data/duty/pin_cycle.csv --wear-seat 2e-7 "
                    "--wear-inner 5e-8 --map-plot p.svg --plot q.svg"},
        Picture{"hip_wear", "hinge-duty " + hip + hip_cycle +
                                "--wear-seat 1e-6 --wear-inner 1e-9 "
                                "--map-plot p.svg --plot q.svg"},
        Picture{"force_law", "hinge-angle " + hip + "--force-law --plot p.svg"},
        Picture{"force_laws", "hinge-angle " + open_hip +
                                  "--force-law --compare --plot p.svg"},
        Picture{"inverse", "hinge-angle " + pin +
                               "--inverse --theta0 1:80:1 --law all --plot "
                               "p.svg"},
        Picture{"coefficients",
                "hinge-table --theta0 10:90:10 --alpha 0:90:1 --quantity "
                "sigma_Z --plot p.svg"},
        Picture{"points",
                "printf 'time_s,R_N,b_deg\n0,100,90\n1,2000,80\n"
                "2,500,60\n' | hinge-joint " +
                    hip + "--points - --plot p.svg"},
        Picture{"paper_moment",
                "hinge-joint --joint data/joints/paper_example_2.toml --beta "
                "30,60,90 --reaction 1e4:2e6:1e4 --plot p.svg"},
        Picture{"all_pressures", "hinge-pressure " + open_hip +
                                     "--load 2000 --pressure all --plot p.svg"},
        Picture{"boosters",
                "hinge-separation data/cases/soyuz.toml --plot "
                "p.svg"},
        Picture{"platform",
                "hinge-separation data/cases/platform.toml --plot p.svg"},
        Picture{"flywheels",
                "hinge-separation data/cases/flywheels.toml --plot p.svg"},
        Picture{"study_of_boosters",
                "hinge-study data/studies/soyuz.toml --runs 20 --plot p.svg"},
        Picture{"study_of_a_bearing",
                "hinge-study data/studies/lined_bearing.toml --runs 60 --plot "
                "p.svg"},
        Picture{"study_of_a_hip",
                "hinge-study data/studies/hip.toml --runs 96 --plot p.svg"}),
    [](const auto& of) { return of.param.name; });

// The measured sizes themselves, against DejaVu Sans as a browser has them.
TEST(TextSize, IsThatOfTheFont) {
  EXPECT_DOUBLE_EQ(cli::text_width("0123456789"), 6.36);
  EXPECT_NEAR(cli::text_width("peak pressure, MPa"), 9.838, 1e-9);
  EXPECT_GE(cli::text_width("θ₀"), 0.612 + 0.401);
  EXPECT_EQ(cli::text_width("\xE6\xB8\xAC"), 1);
}

TEST(TextSize, LinesAreBrokenAtCommasOrBlanks) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(cli::wrapped("one two, three", 100), (Lines{"one two, three"}));
  EXPECT_EQ(cli::wrapped("one two, three", 6), (Lines{"one two,", "three"}));
  EXPECT_EQ(cli::wrapped("one two, three", 3), (Lines{"one", "two,", "three"}));
  EXPECT_EQ(cli::wrapped("unbroken", 1), (Lines{"unbroken"}));
}

}  // namespace
}  // namespace contact::test::picture_texts_test
