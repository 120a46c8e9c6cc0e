// Options that programs share: numbers with units, columns and separators of
// tables, walls, several joints in one run.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "cli/joint/key_settings.hpp"
#include "libcontact/files/joint_file.hpp"
#include "support/program.hpp"

namespace contact::test::options_test {
namespace {

using namespace std::string_literals;

// Numbers with units at the command line are those without.
struct Same {
  std::string run;
  std::string with;
  std::string without;
};
std::ostream& operator<<(std::ostream& to, const Same& same) {
  return to << same.run << same.with;
}

const std::string hip = " --joint data/joints/hip_cocr_uhmwpe_infinite.toml ";
const std::string pair = " --pair data/materials/steel_bronze.toml ";
const std::string ball = pair + "--joint ball --clearance 50um --radius ";

// Before anything is computed.
TEST(InstructionSet, IsThatOfTheProcess) {
  const ProgramFolder folder;
  for (const std::string run :
       {"hinge-table --theta0 30 --alpha 30",
        "hinge-angle --joint ball --modulus-ratio 1 --x 1",
        "hinge-separation data/cases/slosh.toml --end-time 0.1"}) {
    const auto refused = folder.run("CONTACT_INSTRUCTION_SET=sse9 " + run);
    EXPECT_EQ(refused.status, 2) << run;
    EXPECT_TRUE(refused.err.starts_with(
        run.substr(0, run.find(' ')) +
        ": CONTACT_INSTRUCTION_SET = sse9 must be baseline"))
        << refused.err;
    EXPECT_EQ(refused.out, "");
    folder.run_well("CONTACT_INSTRUCTION_SET=baseline " + run);
  }
}

// All three in mm by mistake: a ball of 28 m, with a note.
TEST(LengthOptions, MetresThatAreHardlyMeant) {
  const ProgramFolder folder;
  const std::string angle =
      "hinge-angle --joint ball --pair data/materials/cocr_uhmwpe.toml "
      "--backing rigid --load 2000 ";
  const auto said = [&](const std::string& size) {
    return folder.run_well(angle + size).err;
  };
  EXPECT_EQ(said("--diameter 28 --clearance 0.1 --wall 8"),
            "hinge-angle: note: --diameter 28 is 28 m; 28mm is 28 mm\n"
            "hinge-angle: note: --wall 8 is 8 m; 8mm is 8 mm\n");
  EXPECT_EQ(said("--radius 14 --clearance 1e-3 --wall 1"),
            "hinge-angle: note: --radius 14 is 14 m; 14mm is 14 mm\n");
  EXPECT_EQ(said("--diameter 28mm --clearance 0.1mm --wall 8mm"), "");
  EXPECT_EQ(said("--diameter 2 --clearance 1e-3 --wall 0.5"), "");
  EXPECT_EQ(said("--diameter 28m --clearance 0.1 --wall 8m"), "");
}

TEST(NumberOptions, ThousandsThatAreLists) {
  const ProgramFolder folder;
  const auto said = [&](const std::string& program, const std::string& loads) {
    return folder
        .run_well(program + loads +
                  " --joint data/joints/hip_cocr_uhmwpe.toml ")
        .err;
  };
  const std::string angle = "hinge-angle --load ";
  const std::string joint = "hinge-joint --beta 90 --reaction ";
  for (const char* loads : {"2,500", "1,500", "12,500"}) {
    EXPECT_TRUE(has_text(said(angle, loads),
                         std::string("hinge-angle: note: --load ") + loads +
                             " is read as a list of numbers: write thousands "
                             "without commas, decimals with a point\n"));
  }
  EXPECT_TRUE(has_text(said(joint, "2,500"), "note: --reaction 2,500 is"));
  EXPECT_TRUE(has_text(said(joint, "0,5kN"), "note: --reaction 0,5kN is"));
  for (const char* loads :
       {"100,000", "1,000,000", "2,000", "0,05", "0,05kN"}) {
    folder.run_ill(
        angle + loads + " --joint data/joints/hip_cocr_uhmwpe.toml", 2,
        std::string("hinge-angle: --load ") + loads +
            " must be a list of numbers without leading zeros: write thousands "
            "without commas, decimals with a point\n");
  }
  for (const char* loads :
       {"500,2000", "100,200,300", "100,200", "2,5", "1,20,300", "0,500"}) {
    EXPECT_EQ(said(angle, loads), "") << loads;
  }
}

class UnitOptions : public testing::TestWithParam<Same> {};

TEST_P(UnitOptions, AreTheSameNumbers) {
  const auto& [run, with, without] = GetParam();
  const ProgramFolder folder;
  EXPECT_EQ(folder.run_well(run + with).out, folder.run_well(run + without).out)
      << run << with;
}

const std::string duty =
    "hinge-duty --joint data/reference/duty/cycle_hip.toml --cycle "
    "data/reference/duty/cycle_hip_in.csv --euler zxy ";
const std::string rig =
    "hinge-identify --joint data/duty/torque_rig.toml --data "
    "data/duty/torque_rig.csv ";

INSTANTIATE_TEST_SUITE_P(
    OfPrograms, UnitOptions,
    testing::Values(
        Same{"hinge-angle --load ", "0.1kN:2kN:log3" + hip,
             "100:2000:log3" + hip},
        Same{"hinge-angle --inverse --theta0 ", "0:40deg:20deg" + hip,
             "0:40:20" + hip},
        Same{"hinge-angle --load 1e4 ", ball + "5cm", ball + "0.05"},
        Same{"hinge-angle --load 1e4 ", ball + "2in", ball + "50.8mm"},
        Same{"hinge-angle --law tanh --load 2000 --limit-angle ",
             "1.5707963267948966rad" + hip, "90" + hip},
        Same{"hinge-angle --law exact --load 2000 --loading ",
             "back:30deg" + hip, "back:30" + hip},
        Same{"hinge-pressure --summary --load ", "2kN" + hip, "2000" + hip},
        Same{"hinge-joint" + hip, "--reaction 2kN --beta 30deg --rate 60rpm",
             "--reaction 2000 --beta 30 --rate 6.283185307179586"},
        Same{"hinge-joint" + hip, "--normal-force 2kN --alpha 30deg",
             "--normal-force 2000 --alpha 30"},
        Same{"hinge-joint" + hip, "--reaction-xyz 1kN,20N,0 --rate-xyz 0,0,1",
             "--reaction-xyz 1000,20,0 --rate-xyz 0,0,1"},
        Same{"hinge-joint" + hip,
             "--reaction-xyz 1e3,20,0 --moment-xyz 0,2N*m,500N_mm",
             "--reaction-xyz 1e3,20,0 --moment-xyz 0,2,0.5"},
        Same{"hinge-joint --reaction 1e3 --beta 90" + hip + "--friction 0.1 ",
             "--adhesion 0.5kPa", "--adhesion 500"},
        Same{"hinge-joint --reaction 1e3 --beta 90" + hip,
             "--viscous 2MPa*s/m,0.1s/m", "--viscous 2e6,0.1"},
        Same{"hinge-joint --reaction 1e3 --friction 0.1 --joint pin --radius "
             "25mm --clearance 25um --backing rigid" +
                 pair,
             "--length 3cm --wall 0.5cm", "--length 0.03 --wall 5mm"},
        Same{duty, "--period 1000ms", "--period 1"},
        Same{duty, "--friction 0.1 --adhesion 0.5kPa",
             "--friction 0.1 --adhesion 500"},
        Same{duty, "--viscous 2MPa*s/m,0.1s/m", "--viscous 2e6,0.1"},
        Same{rig + "--fit f0 ", "--adhesion 1MPa", "--adhesion 1e6"},
        Same{"hinge-table ", "--theta0 30deg --alpha 45deg",
             "--theta0 30 --alpha 45"},
        Same{"hinge-separation data/cases/flywheels.toml "
             "--checkpoint c.cbor ",
             "--checkpoint-every 20000ms --time-limit 1e6ms",
             "--checkpoint-every 20"}));

// --columns, --separator and --decimal-comma in every program, and printed
// tables that fit on a page.
struct Run {
  std::string command;
  std::vector<std::string> columns;  ///< not in their order
};
std::ostream& operator<<(std::ostream& to, const Run& run) {
  return to << run.command;
}

const std::vector<Run> runs = {
    {"hinge-angle --load 100:2000:log3" + hip, {"theta0_fitted_deg", "load_N"}},
    {"hinge-angle --compare --load 100:2000:log3" + hip,
     {"recommended", "law"}},
    {"hinge-pressure --load 2000 --points 3" + hip,
     {"theta_deg", "p_exact_Pa", "load_N"}},
    {"hinge-table --theta0 10,20 --alpha 0,30", {"chi_cosine", "theta0_deg"}},
    {"printf 'theta0_deg,alpha_deg,t\\n40,15,0.5\\n' | hinge-table --points -",
     {"t", "chi_cosine"}},
    {"hinge-joint --reaction 1,2 --beta 30" + hip,
     {"theta0_deg", "state", "R_N"}},
    {"hinge-joint --joint data/joints/paper_example_1.toml --reaction 2.63e5 "
     "--beta 67.6 --trace",
     {"theta0_deg", "step"}},
    {"hinge-separation data/cases/flywheels.toml --output out.json --history -",
     {"energy.balance_J", "wheel_x.mode", "time_s"}},
};

std::string joined(const std::vector<std::string>& words, char separator) {
  std::string text;
  for (const std::string& word : words) text += word + separator;
  text.pop_back();
  return text;
}

class TableOptions : public testing::TestWithParam<Run> {
 protected:
  std::string out(const std::string& options) const {
    return folder_.run_well(GetParam().command + options).out;
  }
  const ProgramFolder folder_;
};

TEST_P(TableOptions, ColumnsAsTheyAreAskedFor) {
  const auto& columns = GetParam().columns;
  const auto all = csv_rows(out(""));
  const auto some = csv_rows(out(" --columns " + joined(columns, ',')));
  ASSERT_EQ(some.size(), all.size());
  EXPECT_EQ(some[0], columns);
  for (const std::string& column : columns) {
    EXPECT_EQ(csv_column(some, column), csv_column(all, column)) << column;
  }
}

// The same characters except these two; none of the cells has a comma.
TEST_P(TableOptions, DecimalCommas) {
  std::string expected = out("");
  std::ranges::replace(expected, ',', ';');
  std::istringstream lines(expected);
  std::string header;
  std::getline(lines, header);
  std::string body = expected.substr(header.size());
  std::ranges::replace(body, '.', ',');
  EXPECT_EQ(out(" --decimal-comma"), header + body);
}

TEST_P(TableOptions, Separator) {
  std::string expected = out("");
  std::ranges::replace(expected, ',', '\t');
  EXPECT_EQ(out(" --separator tab"), expected);
}

INSTANTIATE_TEST_SUITE_P(Of, TableOptions, testing::ValuesIn(runs));

std::size_t widest_line(const std::string& text) {
  std::istringstream lines(text);
  std::size_t widest = 0;
  for (std::string line; std::getline(lines, line);) {
    widest = std::max(widest, line.size());
  }
  return widest;
}

TEST(PrintedTables, FitOnAPage) {
  const ProgramFolder folder;
  for (const std::string& run :
       {"hinge-joint --beta 30 --reaction 10:1000:log20" + hip,
        "hinge-table --theta0 5:90:5 --alpha 0:90:5"s,
        "hinge-angle --joint ball --modulus-ratio 1 --x 0.1:1:0.1 --law all"s,
        "hinge-pressure --joint ball --modulus-ratio 1 --x 1 --summary"s}) {
    const auto result = folder.run_well(run + " --format markdown");
    EXPECT_GT(widest_line(result.out), 20U) << run;
    EXPECT_LE(widest_line(result.out), 100U) << run << result.out;
  }
}

TEST(Help, HasAShortName) {
  const ProgramFolder folder;
  for (const std::string program :
       {"hinge-angle", "hinge-pressure", "hinge-table", "hinge-joint",
        "hinge-duty", "hinge-identify", "hinge-separation"}) {
    const auto result = folder.run_well(program + " -h");
    EXPECT_EQ(result.out, folder.run(program + " --help").out);
  }
}

// A column of an HDF5 history that is not requested is not written.
TEST(Columns, OfAHistoryInHdf5) {
  const ProgramFolder folder;
  const std::string run =
      "hinge-separation data/cases/flywheels.toml --history h.h5 --output o";
  folder.run_well(run);
  const std::string all = folder.read("h.h5");
  folder.run_well(run + " --columns time_s,wheel_x.mode");
  const std::string some = folder.read("h.h5");
  for (const char* kept : {"time_s", "mode"}) {
    EXPECT_TRUE(has_text(some, kept)) << kept;
  }
  for (const char* gone : {"balance_J", "angle_deg"}) {
    EXPECT_TRUE(has_text(all, gone)) << gone;
    EXPECT_FALSE(has_text(some, gone)) << gone;
  }
}

// --wall and --backing: the same joint as by a file with [wall].
class WallOptions : public testing::Test {
 protected:
  std::string out(const std::string& command) const {
    return folder_.run_well(command).out;
  }
  // Value of `column` in the first row.
  double value(const std::string& command, const std::string& column) const {
    return std::stod(csv_column(csv_rows(out(command)), column).at(0));
  }

  const ProgramFolder folder_;
  const std::string hip_file_ = "data/joints/hip_cocr_uhmwpe.toml ";
  const std::string hip_pair_ = "ball --pair data/materials/cocr_uhmwpe.toml ";
  const std::string hip_ = hip_pair_ +
                           "--radius 14mm --clearance 100um --wall 8mm "
                           "--backing rigid ";
};

TEST_F(WallOptions, RigidShell) {
  for (const std::string program :
       {"hinge-angle --load 100,2000 --joint ",
        "hinge-angle --inverse --theta0 20,40 --joint ",
        "hinge-pressure --load 2000 --points 5 --joint ",
        "hinge-pressure --load 2000 --summary --joint "}) {
    const std::string expected = out(program + hip_file_);
    EXPECT_TRUE(has_text(expected, "exact")) << program;
    EXPECT_EQ(out(program + hip_), expected) << program;
  }
  const std::string state = "hinge-joint --reaction 2000 --beta 30,90 --joint ";
  EXPECT_EQ(out(state + hip_ + "--inner-body body"), out(state + hip_file_));
}

TEST_F(WallOptions, MaterialOfAFile) {
  const std::string load = "hinge-angle --load 1e3,1e5 --joint ";
  EXPECT_EQ(out(load + "ball --pair data/materials/steel_ptfe_liner.toml "
                       "--radius 17.5mm --clearance 15um --wall 0.4mm "
                       "--backing data/backings/carbon_steel.toml"),
            out(load + "data/joints/spherical_plain_bearing.toml"));
}

TEST_F(WallOptions, HeldPin) {
  folder_.write("held.toml",
                "name = \"bush\"\nkind = \"pin\"\n[geometry]\n"
                "radius_mm = 25\nradial_clearance_um = 25\nlength_mm = 30\n"
                "[materials]\npair = \"data/materials/steel_bronze.toml\"\n"
                "[wall]\nbacking = \"held\"\n"
                "[[wall.layer]]\nthickness_mm = 5\n");
  const std::string pin =
      "pin --pair data/materials/steel_bronze.toml --radius 25mm "
      "--clearance 25um --wall 5mm --backing held ";
  const std::string summary = "hinge-pressure --summary --load 6e4 --joint ";
  EXPECT_EQ(out(summary + pin + "--length 30mm"), out(summary + "held.toml"));
  const std::string state =
      "hinge-joint --friction 0.1 --reaction 1e4 --joint ";
  EXPECT_EQ(out(state + pin + "--length 30mm"), out(state + "held.toml"));
}

// Without a size the thickness is over the radius.
TEST_F(WallOptions, Dimensionless) {
  const std::string relative = "--wall 0.5714285714285714 --backing rigid";
  const std::string x = "hinge-angle --x 1 --joint ";
  const double expected = value(x + hip_file_, "theta0_exact_deg");
  // 8/14 is rounded twice, the solutions are of 1e-12.
  EXPECT_NEAR(value(x + hip_pair_ + relative, "theta0_exact_deg"), expected,
              1e-9);
  // The constants of cocr_uhmwpe.toml.
  EXPECT_NEAR(value(x + "ball --modulus-ratio 230 --poisson2 0.4 " + relative,
                    "theta0_exact_deg"),
              expected, 1e-9);
  const std::string table = "hinge-table --theta0 60 --alpha 90 --joint ";
  EXPECT_NEAR(value(table + hip_pair_ + relative, "sigma_Z_exact"),
              value(table + hip_file_, "sigma_Z_exact"), 1e-10);
  // A thick wall is as good as none.
  EXPECT_NEAR(
      value(x + "ball --modulus-ratio 2 --wall 1e5 --backing held",
            "theta0_exact_deg"),
      value(x + "ball --modulus-ratio 2 --law exact", "theta0_exact_deg"),
      1e-6);
}

// Several joints in one run: --set KEY=VALUES and several --joint.
using Rows = std::vector<std::vector<std::string>>;

class ComparedJoints : public testing::Test {
 protected:
  Rows rows(const std::string& command) const {
    return csv_rows(folder_.run_well(command).out);
  }
  // Without the first cells of each row, and without the header.
  static Rows without(Rows rows, std::ptrdiff_t cells) {
    rows.erase(rows.begin());
    for (auto& row : rows) row.erase(row.begin(), row.begin() + cells);
    return rows;
  }

  ProgramFolder folder_;
  const std::string hip_ =
      " --joint data/joints/hip_cocr_uhmwpe_infinite.toml ";
};

// Every key in its own unit, in the place of the file's; the rows equal the
// rows of such files.
TEST_F(ComparedJoints, RowsAreThoseOfTheirFiles) {
  std::string text = folder_.read("data/joints/hip_cocr_uhmwpe_infinite.toml");
  const std::string in_file = "radial_clearance_um = 100";
  ASSERT_TRUE(has_text(text, in_file));
  text.replace(text.find(in_file), in_file.size(),
               "radial_clearance_mm = 0.05");
  text.replace(text.find("../materials"), 12, "data/materials");
  folder_.write("other.toml", text);
  const std::string set = "--set geometry.radial_clearance_mm=0.05,0.1";
  for (const std::string program :
       {"hinge-angle --load 100:1000:log3", "hinge-pressure --load 10,20",
        "hinge-joint --friction 0.1 --reaction 100,200 --beta 90"}) {
    const Rows both = rows(program + hip_ + set);
    EXPECT_EQ(both[0][0], "geometry.radial_clearance_mm");
    Rows expected = without(rows(program + " --joint other.toml"), 0);
    const Rows second = without(rows(program + hip_), 0);
    if (program.starts_with("hinge-joint")) {  // joints run fastest
      expected = {expected[0], second[0], expected[1], second[1]};
    } else {
      expected.insert(expected.end(), second.begin(), second.end());
    }
    EXPECT_EQ(without(both, 1), expected) << program;
    const std::string files =
        " --joint other.toml --joint data/joints/hip_cocr_uhmwpe_infinite.toml";
    const Rows named = rows(program + files);
    EXPECT_EQ(named[0][0], "joint");
    EXPECT_EQ(named[1][0], "other");
    EXPECT_EQ(without(named, 1), expected) << program;
  }
}

TEST_F(ComparedJoints, AllCombinationsTheLastKeyFastest) {
  const Rows all = rows(
      "hinge-angle --x 1 --joint data/joints/hip_cocr_uhmwpe.toml "
      "--set 'wall.layer[1].thickness_mm=4:8:4' "
      "--set wall.backing=rigid,held");
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(csv_column(all, "wall.layer[1].thickness_mm"),
            (Texts{"4", "4", "8", "8"}));
  EXPECT_EQ(csv_column(all, "wall.backing"),
            (Texts{"rigid", "held", "rigid", "held"}));
  const auto theta0 = csv_column(all, "theta0_exact_deg");
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(theta0[i], theta0[j]);
  }
}

TEST_F(ComparedJoints, PicturesNameThem) {
  if (!folder_.has_gnuplot()) GTEST_SKIP();
  for (const std::string program :
       {"hinge-angle --load 100:1000:log3",
        "hinge-pressure --load 1000 "
        "--pressure exact",
        "hinge-joint --friction 0.1 --reaction 100:1000:100 --beta 90"}) {
    rows(program + hip_ +
         "--set geometry.radial_clearance_um=50,100 --plot p.svg");
    const std::string picture = folder_.read("p.svg");
    for (const char* value : {"50", "100"}) {
      EXPECT_TRUE(
          has_text(picture, "radial clearance " + std::string(value) + " µm"))
          << program;
    }
  }
}

TEST(KeySettings, TablesAreMadeAndTextsNeedNoQuotes) {
  const auto settings = cli::key_settings(
      {"half_angle.law=tanh", "half_angle.limit_half_angle_deg=80,85",
       "name=a 'b' \"c\""});
  ASSERT_EQ(settings.size(), 2u);
  const auto joint = read_joint(
      std::string(CONTACT_DATA_DIR) + "/joints/wheel_ball.toml", settings[1]);
  EXPECT_EQ(joint.half_angle_law, "tanh");
  EXPECT_DOUBLE_EQ(*joint.half_angle_options.limit_half_angle / 85 * 180,
                   3.14159265358979323846);
  EXPECT_EQ(joint.name, "a 'b' \"c\"");
}

}  // namespace
}  // namespace contact::test::options_test
