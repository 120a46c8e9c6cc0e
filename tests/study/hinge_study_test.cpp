// hinge-study as a program: killed and repeated, in parts, one run again.
#include <gtest/gtest.h>
#include <hdf5.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace {

using contact::test::ProgramFolder;

const std::string balls =
    "name = 'balls'\njoint = 'j.toml'\nruns = 300\n"
    "load = { reaction_kN = 100, beta_deg = 60 }\n"
    "[[requirement]]\nquantity = 'M_t_N_m'\nat_most = 700\nsuccess = 0.99\n"
    "[[dispersion]]\nkey = 'friction.coefficient'\nkind = 'uniform'\n"
    "low = 0.05\nhigh = 0.15\n"
    "[[dispersion]]\nkey = 'load.reaction_N'\nrelative = true\n"
    "kind = 'normal'\nmean = 1\ndeviation = 0.05\nlow = 0.5\nhigh = 1.5\n";

class HingeStudy : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("j.toml",
                  "name = 'ball'\nkind = 'ball'\n"
                  "geometry = { radius_mm = 50, radial_clearance_um = 100 }\n"
                  "materials = { pair = '" CONTACT_DATA_DIR
                  "/materials/steel_steel.toml' }\n"
                  "friction = { coefficient = 0.1 }\n"
                  "pressure = { law = 'sqrt_tan' }\n");
    folder_.write("s.toml", balls);
  }
  // Standard output of a command that ends with this status.
  std::string run(const std::string& arguments, int status = 0) const {
    const auto result = folder_.run("hinge-study " + arguments);
    EXPECT_EQ(result.status, status) << result.err;
    return result.out;
  }
  // CSV, JSON and the table of a study.
  std::vector<std::string> results(const std::string& journal,
                                   const std::string& options = "") const {
    std::string text = run("s.toml --journal " + journal +
                           " --csv rows.csv --output all.json " + options);
    return {folder_.read("rows.csv"), folder_.read("all.json"), text};
  }

  ProgramFolder folder_;
};

TEST_F(HingeStudy, SameBytesInAnyThreadsAndParts) {
  const auto serial = results("a");
  EXPECT_EQ(std::ranges::count(serial[0], '\n'), 302);
  EXPECT_EQ(results("b", "--jobs 4"), serial);
  EXPECT_EQ(results("a"), serial);  // nothing is computed
  EXPECT_EQ(run("s.toml --rows 120:300 --journal p2 --jobs 2"), "");
  EXPECT_EQ(run("s.toml --rows 0:99 --journal p1"), "");
  // What no part has is computed.
  EXPECT_EQ(results("c", "--merge p1 p2"), serial);
  // More runs leave the first ones.
  const auto more = results("a", "--runs 400");
  EXPECT_TRUE(more[0].starts_with(serial[0]));
}

TEST_F(HingeStudy, KilledItGoesOnToTheSameBytes) {
  const auto serial = results("a");
  const std::string whole = folder_.read("a");
  for (const double part : {0.2, 0.7}) {
    // As a kill leaves it: rows that were done, and a part of one.
    folder_.write(
        "b", whole.substr(0, static_cast<std::size_t>(
                                 part * static_cast<double>(whole.size()))));
    EXPECT_EQ(results("b"), serial);
  }
  // Killed for real, again and again.
  for (int i = 0; i < 5; ++i) {
    folder_.run("timeout -s KILL 0.2 hinge-study s.toml --journal c --jobs 2");
  }
  EXPECT_EQ(results("c"), serial);
}

TEST_F(HingeStudy, OneRunAgainIsItsRow) {
  const auto rows = results("a")[0];
  std::istringstream stream(rows);
  std::string line;
  std::vector<std::string> lines;
  while (std::getline(stream, line)) lines.push_back(line);
  for (const int run_number : {0, 17, 300}) {
    const std::string again = run("s.toml --run " + std::to_string(run_number));
    std::string row = std::to_string(run_number);
    std::istringstream cells(again);
    std::getline(cells, line);
    EXPECT_EQ(line, "name,value");
    while (std::getline(cells, line)) row += line.substr(line.find(','));
    EXPECT_EQ(row + ",ok", lines[static_cast<std::size_t>(run_number) + 1]);
  }
}

TEST_F(HingeStudy, ChecksShowTheDrawsOfTheRows) {
  const auto rows = results("a")[0];
  std::istringstream draws(run("s.toml --check"));
  std::string line;
  std::getline(draws, line);
  EXPECT_EQ(line, "run,friction.coefficient,load.reaction_N");
  int count = 0;
  while (std::getline(draws, line)) {
    EXPECT_NE(rows.find('\n' + line + ','), rows.npos) << line;
    ++count;
  }
  EXPECT_EQ(count, 10);
}

TEST_F(HingeStudy, Hdf5HasTheSameNumbers) {
  const auto rows = results("a", "--hdf5 rows.h5")[0];
  const std::string name = (folder_.path() / "rows.h5").string();
  const hid_t file = H5Fopen(name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  std::vector<double> moments(301);
  const hid_t data = H5Dopen2(file, "quantities/M_t_N_m", H5P_DEFAULT);
  ASSERT_GE(data, 0);
  EXPECT_GE(H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                    moments.data()),
            0);
  H5Dclose(data);
  EXPECT_GT(H5Lexists(file, "inputs/load.reaction_N", H5P_DEFAULT), 0);
  H5Fclose(file);
  std::istringstream stream(rows);
  std::string line;
  std::getline(stream, line);
  for (const double moment : moments) {
    std::getline(stream, line);
    std::istringstream cells(line);
    std::string cell;
    for (int i = 0; i < 4; ++i) std::getline(cells, cell, ',');
    EXPECT_EQ(std::stod(cell), moment);
  }
}

TEST_F(HingeStudy, TheTableSaysWhatTheVerdictRestsOn) {
  const std::string text = results("a")[2];
  for (const char* words :
       {"300 runs (random, seed 1) and the nominal one; 0 failed",
        "| M_t_N_m at most 700 | 99 % | 10 % |", "What drives M_t_N_m",
        "The worst runs for M_t_N_m at most 700",
        "To repeat one: hinge-study "
        "s.toml --run "}) {
    EXPECT_NE(text.find(words), text.npos) << words << '\n' << text;
  }
}

TEST_F(HingeStudy, AnotherStudysJournalIsRefused) {
  results("a");
  const auto result =
      folder_.run("hinge-study s.toml --seed 2 --journal a --csv x.csv");
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.err,
            "hinge-study: a: the study of this journal must be the same, with "
            "the same files and seed; remove it or name another one with "
            "--journal\n");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "x.csv"));
}

// The history is that of the case with the draws of the run.
TEST_F(HingeStudy, HistoriesOfARunOfACase) {
  folder_.write("c.toml",
                "name = 's'\ncase = '" CONTACT_DATA_DIR
                "/cases/two_stage_turn.toml'\nruns = 3\n"
                "quantities = 'stage.at_release.*'\n"
                "[[dispersion]]\nkey = 'body[stage].mass_t'\nrelative = true\n"
                "kind = 'uniform'\nlow = 0.9\nhigh = 1.1\n");
  const std::string draw = run("c.toml --run 2 --history h.csv");
  const auto at = draw.find("mass_t,") + 7;
  const std::string factor = draw.substr(at, draw.find('\n', at) - at);
  const auto direct =
      folder_.run("hinge-separation " CONTACT_DATA_DIR
                  "/cases/two_stage_turn.toml --set 'body[stage].mass_t=*" +
                  factor + "' --history d.csv --output d.json");
  EXPECT_EQ(direct.status, 0) << direct.err;
  EXPECT_EQ(folder_.read("h.csv"), folder_.read("d.csv"));
}

}  // namespace
