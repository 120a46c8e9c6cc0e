// First attempts of users work, or give a hint; help and completion of shells.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <string_view>

#include "support/program.hpp"

namespace contact::test::typed_test {
namespace {

// Two commands that are one.
struct Alike {
  std::string typed;
  std::string meant;
};
std::ostream& operator<<(std::ostream& to, const Alike& alike) {
  return to << alike.typed;
}

class Typed : public testing::TestWithParam<Alike> {};

TEST_P(Typed, IsUnderstood) {
  const ProgramFolder folder;
  const std::string out = folder.run_well(GetParam().typed).out;
  EXPECT_FALSE(out.empty());
  EXPECT_EQ(out, folder.run_well(GetParam().meant).out);
}

const std::string pin = "data/joints/pin_joint.toml";
const std::string sized = " --joint pin --diameter 20mm --hole H7 --shaft f7 ";
const std::string bronze = " --pair data/materials/steel_bronze.toml ";

INSTANTIATE_TEST_SUITE_P(
    Rows, Typed,
    testing::Values(
        Alike{"hinge-joint " + pin + " --reaction 10kN",
              "hinge-joint --joint " + pin + " --reaction 10kN"},
        Alike{"hinge-joint " + pin + " --load 10kN",
              "hinge-joint " + pin + " --reaction 10kN"},
        Alike{"hinge-joint " + pin + " --load=10kN",
              "hinge-joint " + pin + " --reaction 10kN"},
        Alike{"hinge-pressure " + pin + " --reaction 10kN",
              "hinge-pressure " + pin + " --load 10kN"},
        Alike{"hinge-angle " + pin + " --reaction 10kN",
              "hinge-angle " + pin + " --load 10kN"},
        Alike{"hinge-angle pin_joint --load 10kN",
              "hinge-angle " + pin + " --load 10kN"},
        Alike{"hinge-angle --pair steel_bronze" + sized + "--load 1kN/m",
              "hinge-angle" + bronze + sized + "--load 1kN/m"},
        Alike{"hinge-pressure --joint ball --pair cocr_uhmwpe --diameter 28mm "
              "--clearance 50um --wall 8mm --backing carbon_steel --load 2kN",
              "hinge-pressure --joint ball --pair "
              "data/materials/cocr_uhmwpe.toml --diameter 28mm --clearance "
              "50um --wall 8mm --backing data/backings/carbon_steel.toml "
              "--load 2kN"},
        Alike{"hinge-joint --bearing GE50ES --load 100kN --beta 90",
              "hinge-joint --joint ball --pair data/materials/steel_steel.toml "
              "--bearing GE50ES --friction steel_steel_greased --reaction "
              "100kN --beta 90"},
        Alike{"hinge-joint --bearing GE50ES --load 100kN",
              "hinge-joint --bearing GE50ES --load 100kN --beta 90"},
        Alike{"hinge-joint --joint lined_bush_pressed --reaction 0",
              "hinge-joint data/joints/lined_bush_pressed.toml --load 0"},
        Alike{"hinge-joint --joint ball --pair steel_bronze --radius 10mm "
              "--interference 5um --friction 0.1 --reaction 0",
              "hinge-joint --joint ball --pair steel_bronze --radius 10mm "
              "--interference 5um --friction 0.1 --reaction 0 --beta 90"}));

// Rejected commands, and their messages.
struct Refused {
  std::string typed;
  std::string said;
};
std::ostream& operator<<(std::ostream& to, const Refused& refused) {
  return to << refused.typed;
}

class TypedWrong : public testing::TestWithParam<Refused> {};

TEST_P(TypedWrong, SaysWhatToType) {
  const ProgramFolder folder;
  folder.write("inline.toml", "requirement = [{ quantity = 'x' }]\n");
  folder.write("e.toml",
               "name = \"e\"\nkind = \"pin\"\n[geometry]\nradius_mm = 20\n"
               "radial_clearance_um = 40\nlength_mm = 50\n"
               "[materials.inner]\nE_GPa = 207\nnu = 0.29\n"
               "[materials.outer]\nyoungs_modulus_GPa = 111\n"
               "poissons_ratio = 0.349\n");
  folder.write("nu.toml",
               "name = \"e\"\nkind = \"pin\"\n[geometry]\nradius_mm = 20\n"
               "radial_clearance_um = 40\nlength_mm = 50\n"
               "[materials.inner]\nyoungs_modulus_GPa = 207\nnu = 0.29\n"
               "[materials.outer]\nyoungs_modulus_GPa = 111\n"
               "poissons_ratio = 0.349\n[friction]\ncoefficient = 0.1\n");
  folder.write("mu.toml",
               "name = \"e\"\nkind = \"pin\"\n[geometry]\nradius_mm = 20\n"
               "radial_clearance_um = 40\nlength_mm = 50\n"
               "[materials]\npair = \"data/materials/steel_bronze.toml\"\n"
               "[friction]\nmu = 0.1\n");
  const ProgramResult result = folder.run(GetParam().typed);
  EXPECT_EQ(result.status, 2);
  EXPECT_TRUE(has_text(result.err, GetParam().said)) << result.err;
  EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
}

INSTANTIATE_TEST_SUITE_P(
    Rows, TypedWrong,
    testing::Values(
        Refused{"hinge-angle --joint pin --pair steel_bronze --diameter 20 "
                "--hole H7 --shaft f7 --load 1kN/m",
                "20 is 20 m; 20mm is 20 mm"},
        Refused{"hinge-joint --joint bush --diameter 20mm --load 10kN",
                "--joint bush must be ball, pin or a .toml file"},
        Refused{"hinge-joint --joint hip_cop --load 10kN",
                "did you mean \"hip_cup\"?"},
        Refused{"hinge-angle --pair steel_brons" + sized + "--load 1kN/m",
                "unknown pair \"steel_brons\": did you mean \"steel_bronze\"?"},
        Refused{"hinge-joint " + pin +
                    " --friction steel_steel_grease --load "
                    "1kN",
                "did you mean \"steel_steel_greased\"?"},
        Refused{"hinge-angle --pair steel_bronze --wall 1mm --backing steel" +
                    sized + "--load 1kN/m",
                "did you mean \"carbon_steel\"?"},
        Refused{
            "hinge-joint " + pin + " --load 1kN --set geometry.clearance=20um",
            "its size is radial_clearance or diametral_clearance"},
        Refused{"hinge-pressure " + pin + " --load 1kN --tilt 1mrad",
                "--tilt requires a wall"},
        Refused{"hinge-joint " + pin + " --laod 100kN",
                "did you mean \"--load\"?"},
        Refused{"hinge-pressure " + pin + " --laod 100kN",
                "did you mean \"--load\"?"},
        Refused{"hinge-joint " + pin + " --mu 0.1 --load 1kN",
                "did you mean \"--friction\"?"},
        Refused{"hinge-joint " + pin + " --reaction",
                "--reaction requires a value"},
        Refused{"hinge-joint " + pin + " --load 1kN --columns M_t",
                "did you mean \"M_t_N_m\"?"},
        Refused{"hinge-joint " + pin + " --load 1kN --temperature 80C",
                "use --set temperature_C=80"},
        Refused{"hinge-joint " + pin + " --load 1kN --diameter 20mm",
                "use --set geometry.diameter_mm=20"},
        Refused{"hinge-joint " + pin + " --load 100,000", "thousands"},
        Refused{"hinge-joint " + pin +
                    " --load 1kN --rate 1:3:log3 --plot "
                    "a.svg",
                "one --rate"},
        Refused{"hinge-study " + pin, "is a joint file; hinge-study takes"},
        Refused{"hinge-separation " + pin,
                "is a joint file; hinge-separation takes"},
        // By its keys, however they are written.
        Refused{"hinge-separation inline.toml", "is a study file"},
        Refused{"hinge-study data/cases/door.toml",
                "is a case file; hinge-study takes a study file"},
        Refused{"hinge-separation data/studies/soyuz.toml",
                "is a study file; hinge-separation takes a case file"},
        Refused{"hinge-joint e.toml --load 1kN",
                "did you mean \"youngs_modulus_GPa\"?"},
        Refused{"hinge-joint nu.toml --load 1kN",
                "did you mean \"poissons_ratio\"?"},
        Refused{"hinge-joint mu.toml --load 1kN",
                "did you mean \"coefficient\"?"}));

// A Stribeck curve: rates run as the other sweeps do.
TEST(Rates, AreSwept) {
  const ProgramFolder folder;
  const std::string run = "hinge-joint " + pin + " --load 1kN,2kN --rate ";
  const CsvTable swept = folder.table(run + "0.001:3:log20");
  ASSERT_EQ(swept.size(), 40U);
  EXPECT_EQ(swept.at(1, "w_z_rad_per_s"), 0.001);
  EXPECT_EQ(swept.at(20, "w_z_rad_per_s"), 3);
  EXPECT_EQ(swept.at(21, "R_N"), 2000);
  const CsvTable one = folder.table(run + swept.text(7, "w_z_rad_per_s"));
  for (const std::string& name : one.names()) {
    EXPECT_EQ(swept.text(7, name), one.text(1, name)) << name;
    EXPECT_EQ(swept.text(27, name), one.text(2, name)) << name;
  }
}

class Help : public testing::TestWithParam<std::string> {};

TEST_P(Help, IsShortAndTheRestIsThere) {
  const ProgramFolder folder;
  const std::string text = folder.run_well(GetParam() + " --help").out;
  EXPECT_LE(std::ranges::count(text, '\n'), 40) << text;
  const std::string all = folder.run_well(GetParam() + " --help-all").out;
  std::size_t options = 0;
  for (std::size_t at = 0; (at = all.find("\n  --", at)) != all.npos;) {
    const std::size_t begin = at + 3;
    at = all.find_first_of(" \n,", begin);
    const std::string flag = all.substr(begin, at - begin);
    if (flag.starts_with("--help") || flag == "--version" || flag == "--man" ||
        flag == "--completion" || flag == "--schema") {
      continue;
    }
    ++options;
    EXPECT_TRUE(has_text(text, flag)) << flag;
    // Completion of shells and manual pages have the same rows.
    for (const std::string shell : {"bash", "zsh", "fish"}) {
      const std::string found =
          folder.run_well(GetParam() + " --completion " + shell).out;
      EXPECT_TRUE(
          has_text(found, shell == "fish" ? "-l " + flag.substr(2) : flag))
          << shell << ' ' << flag;
    }
  }
  EXPECT_GT(options, GetParam() == "hinge-fmu" ? 2U : 8U);
  EXPECT_FALSE(folder.run_well(GetParam() + " --help-columns").out.empty());
  EXPECT_TRUE(folder.run_well(GetParam() + " --man").out.starts_with(".TH"));
  folder.run_ill(
      GetParam() + " --completion tcsh", 2,
      GetParam() + ": unknown completion \"tcsh\" (bash, zsh, fish)\n");
  // A shell takes it.
  folder.run_well("bash -c 'eval \"$(" + GetParam() + " --completion bash)\"'");
}

INSTANTIATE_TEST_SUITE_P(Of, Help,
                         testing::Values("hinge-joint", "hinge-angle",
                                         "hinge-pressure", "hinge-table",
                                         "hinge-duty", "hinge-identify",
                                         "hinge-separation", "hinge-study"));

TEST(Completion, OfBashCompletesAnOptionAndAFile) {
  const ProgramFolder folder;
  const auto completed = [&](const std::string& words) {
    return folder
        .run_well(
            "bash -c 'eval \"$(hinge-joint --completion bash)\"; "
            "compopt() { :; }; COMP_WORDS=(hinge-joint " +
            words +
            "); COMP_CWORD=$((${#COMP_WORDS[@]}-1)); _hinge_joint; "
            "echo \"${COMPREPLY[@]}\"'")
        .out;
  };
  EXPECT_EQ(completed("--reaction-x"), "--reaction-xyz\n");
  EXPECT_EQ(completed("--format j"), "json\n");
  EXPECT_EQ(completed("--points data/joi"), "data/joints\n");
}

}  // namespace
}  // namespace contact::test::typed_test
