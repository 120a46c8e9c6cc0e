// --columns, --separator and --decimal-comma in every program, and printed
// tables that fit on a page.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace contact::test {
namespace {

struct Run {
  std::string command;
  std::vector<std::string> columns;  ///< not in their order
};
std::ostream& operator<<(std::ostream& to, const Run& run) {
  return to << run.command;
}

const std::vector<Run> runs = {
    {"hinge-angle --joint data/joints/hip_cocr_uhmwpe_infinite.toml --load "
     "100:2000:log3",
     {"theta0_fitted_deg", "load_N"}},
    {"hinge-angle --compare --joint data/joints/hip_cocr_uhmwpe_infinite.toml "
     "--load 100:2000:log3",
     {"recommended", "law"}},
    {"hinge-pressure --joint data/joints/hip_cocr_uhmwpe_infinite.toml --load "
     "2000 "
     "--points 3",
     {"theta_deg", "p_exact_Pa", "load_N"}},
    {"hinge-table --theta0 10,20 --alpha 0,30", {"chi_cosine", "theta0_deg"}},
    {"printf 'theta0_deg,alpha_deg,t\\n40,15,0.5\\n' | hinge-table --points -",
     {"t", "chi_cosine"}},
    {"hinge-joint --joint data/joints/hip_cocr_uhmwpe_infinite.toml --reaction "
     "1,2 "
     "--beta 30",
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

// The same characters but for these two: no cell of these has a comma.
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
  for (const std::string run :
       {"hinge-joint --joint data/joints/hip_cocr_uhmwpe_infinite.toml --beta "
        "30 "
        "--reaction 10:1000:log20",
        "hinge-table --theta0 5:90:5 --alpha 0:90:5",
        "hinge-angle --joint ball --modulus-ratio 1 --x 0.1:1:0.1 --law all",
        "hinge-pressure --joint ball --modulus-ratio 1 --x 1 --summary"}) {
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

// A column of a history in HDF5 that is not asked for is not there.
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

}  // namespace
}  // namespace contact::test
