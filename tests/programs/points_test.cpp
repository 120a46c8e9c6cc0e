// Files of points as duty cycles: answered line by line, summarised, drawn.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "cli/number.hpp"
#include "support/program.hpp"

namespace contact::test::points_test {
namespace {

using namespace std::string_literals;

const std::string joint =
    "hinge-joint --joint data/joints/paper_example_1.toml ";

// The program at the other end of two pipes writes a line and waits for the
// answer; the header comes with the first line, as from a program that writes
// whole buffers. 20 s are long against the time of a row.
TEST(Points, AreAnsweredLineByLine) {
  const ProgramFolder folder;
  folder.write("dialogue.sh",
               "coproc P { $1 --points -; }\n"
               "ask() { printf \"$1\" >&${P[1]}; }\n"
               "hear() { read -t 20 -r line <&${P[0]} && echo \"$line\"; }\n"
               "ask \"$2\\n1$3\\n\" && hear && hear && ask \"2$3\\n\" && hear "
               "&& ask \"3$3\" && ask \"\\n4$3\\n\" && hear && hear\n"
               "status=$?\nkill $P_PID 2>/dev/null\nexit $status\n");
  const std::string header_and_line[2][3] = {
      {joint + "--jobs 1", "R_N,b_deg,name", "e5,90,R"},
      {"hinge-table --jobs 2", "theta0_deg,alpha_deg,name", "0,20,x"}};
  for (const auto& [program, header, line] : header_and_line) {
    std::string points = header + '\n';
    for (const char* row : {"1", "2", "3", "4"}) points += row + line + '\n';
    folder.write("points.csv", points);
    const ProgramResult dialogue = folder.run_well(
        "bash dialogue.sh '" + program + "' " + header + ' ' + line);
    EXPECT_EQ(dialogue.out, folder.run(program + " --points points.csv").out);
  }
}

// A value of --summary.
std::string value(const ProgramResult& summary, const std::string& quantity,
                  const std::string& column = "value") {
  const CsvTable table(summary.out);
  return table.text(table.row_of(quantity), column);
}
double number(const ProgramResult& summary, const std::string& quantity) {
  return CsvTable(summary.out).value(quantity);
}

// Peaks and means follow the rows; the time is uneven.
TEST(Points, SummaryIsThatOfTheRows) {
  const ProgramFolder folder;
  const std::vector<double> time = {0, 0.5, 0.75, 1.75};
  folder.write("cycle.csv",
               "R_N,note,b_deg,t\n1e5,a,90,0\n3e5,b,80,0.5\n2e5,c,20,.75\n"
               "1e5,d,90,\"1.75\"\n");
  const std::string run = joint + "--rate 2 --points cycle.csv ";
  const ProgramResult summary = folder.run_well(run + "--summary");
  const CsvTable rows = folder.table(run);
  EXPECT_EQ(value(summary, "law"), rows.text("law"));
  EXPECT_EQ(value(summary, "pressure"), rows.text("pressure"));
  EXPECT_EQ(value(summary, "states"), "4");
  EXPECT_EQ(value(summary, "left_out"), "0");
  EXPECT_EQ(value(summary, "duration_s"), "1.75");
  for (const std::string name : {"R_N", "R_n_N", "M_t_N_m", "f_M", "p_peak_Pa",
                                 "theta0_deg", "power_W"}) {
    const std::vector<double>& values = rows[name];
    const auto larger = [](double a, double b) {
      return std::abs(a) < std::abs(b);
    };
    const auto peak = std::ranges::max_element(values, larger);
    EXPECT_EQ(number(summary, "largest_" + name), *peak);
    const auto at = peak - values.begin();
    EXPECT_EQ(value(summary, "largest_" + name, "at_state"),
              std::to_string(at + 1));
    EXPECT_EQ(value(summary, "largest_" + name, "at_time_s"),
              cli::number_text(time[at]));
    double integral = 0;
    for (std::size_t i = 1; i < 4; ++i) {
      integral += (values[i - 1] + values[i]) / 2 * (time[i] - time[i - 1]);
    }
    // Rounding of three terms.
    EXPECT_NEAR(number(summary, "mean_" + name), integral / 1.75,
                1e-15 * std::abs(integral));
    if (name != "power_W") continue;
    EXPECT_LT(integral, 0);
    EXPECT_NEAR(number(summary, "dissipated_energy_J"), -integral,
                -1e-15 * integral);
  }
}

// A pin turns to and fro under a constant load: |M_t| is constant, and the work
// of a cycle is M_t times the way, 4 times the amplitude.
TEST(Points, DissipatedEnergyOfAPin) {
  const ProgramFolder folder;
  constexpr int steps = 400;
  std::string points =
      "time_ms,R_x_N,R_y_N,R_z_N,w_x_rad_per_s,"
      "w_y_rad_per_s,w_z_rad_per_s\n";
  for (int i = 0; i <= steps; ++i) {
    points += fmt::format("{},1000,0,0,0,0,{}\n", 2000. * i / steps,
                          std::cos(2 * std::numbers::pi * i / steps));
  }
  folder.write("cycle.csv", points);
  const ProgramResult summary = folder.run_well(
      "hinge-joint --joint data/joints/pin_joint.toml --summary --points "
      "cycle.csv");
  // The amplitude is 2 s/(2 pi). Of a rectified cosine the trapezoidal rule
  // misses h^2/12 (f'(end) - f'(begin)) in each half: relatively
  // (2 pi/steps)^2/12.
  const double way = 4 / std::numbers::pi;
  EXPECT_NEAR(number(summary, "dissipated_energy_J"),
              number(summary, "largest_M_t_N_m") * way,
              number(summary, "largest_M_t_N_m") * way * 2.1e-5);
}

// Bad lines, states without a solution, and a time that cannot be one.
TEST(Points, WhatIsLeftOutIsSaid) {
  const ProgramFolder folder;
  const std::string run =
      "hinge-joint --joint data/joints/pin_joint.toml --summary --points ";
  folder.write("points.csv", "R_N,time_s\n1e3,0\nx,1\n1e99,2\n2e3,3\n");
  const ProgramResult summary = folder.run(run + "points.csv --law hertz");
  EXPECT_EQ(summary.status, 1);
  EXPECT_EQ(value(summary, "states"), "2");
  EXPECT_EQ(value(summary, "left_out"), "2");
  EXPECT_EQ(number(summary, "mean_R_N"), 1500);
  EXPECT_EQ(value(summary, "largest_R_N", "at_state"), "4");
  EXPECT_TRUE(has_text(summary.err, "ERROR: line 3: R_N = x must be"));
  EXPECT_TRUE(has_text(summary.err, "rows without a value: 1;"));

  for (const std::string time : {"0.5", "x"}) {
    folder.write("back.csv", "R_N,time_s\n1e3,0\n2e3,1\n1e3," + time + "\n");
    const ProgramResult back = folder.run_well(run + "back.csv");
    EXPECT_TRUE(has_text(
        back.err,
        "hinge-joint: warning: time_s of state 3 must be a number that is not "
        "below the one before it; the time is left out\n"));
    EXPECT_FALSE(has_text(back.out, "at_time_s"));
    EXPECT_FALSE(has_text(back.out, "dissipated"));
    EXPECT_NEAR(number(back, "mean_R_N"), 4000. / 3, 1e-12);
  }
}

TEST(Points, SummaryAtRest) {
  const ProgramFolder folder;
  folder.write("rest.csv",
               "time,R_x_N,R_y_N,R_z_N,M_x_N_m,M_y_N_m,M_z_N_m\n"
               "0,1e5,2e4,0,300,0,500\n1,1e5,2e4,0,600,0,1000\n");
  const std::string run = joint + "--points rest.csv ";
  const ProgramResult summary = folder.run(run + "--summary");
  EXPECT_EQ(value(summary, "largest_utilisation"),
            folder.table(run).text(2, "utilisation"));
  EXPECT_FALSE(has_text(summary.out, "power"));
  EXPECT_FALSE(has_text(summary.out, "dissipated"));
}

TEST(Points, AreDrawn) {
  const ProgramFolder folder;
  if (!folder.has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  // Enough points to be thinned out, and one peak that must not get lost.
  std::string points = "t_s,R_N,b_deg\n";
  for (int i = 0; i < 5000; ++i) {
    points += fmt::format("{},{},60\n", i, i == 3333 ? 9000 : 1000);
  }
  folder.write("points.csv", points);
  const auto drawn = [&](const std::string& options) {
    folder.run_well(joint + options + " --plot p.svg --output t.csv");
    return folder.read("p.svg");
  };
  const auto has = [](const std::string& svg, const std::string& text) {
    return svg.find("<text>" + text + "<") != std::string::npos;
  };
  const std::string svg = drawn("--points points.csv");
  EXPECT_EQ(csv_rows(folder.read("t.csv")).size(), 5001U);
  EXPECT_LT(svg.size(), 200000U);
  for (const char* text : {"time, s", "Mₜ, N m", "R, N", "peak p, MPa"}) {
    EXPECT_TRUE(has(svg, text)) << text;
  }
  EXPECT_TRUE(has(svg, "8000"));  // on the axis of R
  folder.write("contact.csv", "R_n_N,a_deg\n1e5,20\n2e5,20\n");
  const std::string contact = drawn("--summary --points contact.csv");
  EXPECT_TRUE(has_text(folder.read("t.csv"), "largest_R_n_N,2e+05,2,"));
  EXPECT_TRUE(has(contact, "state"));
  EXPECT_TRUE(has(contact, "Rₙ, kN"));

  folder.write("bad.csv", "R_N,b_deg\nx,20\n");
  const ProgramResult bad =
      folder.run(joint + "--points bad.csv --plot bad.svg");
  EXPECT_EQ(bad.status, 1);
  EXPECT_TRUE(
      has_text(bad.err, "no picture bad.svg: no state has a solution\n"));
}

// Tables of programs are read to the same numbers, whichever form it has, with
// the options that wrote it and without: states, cycles and measurements.
class OwnOutput : public testing::TestWithParam<const char*> {};

TEST_P(OwnOutput, IsReadBack) {
  const std::string form = GetParam();
  const ProgramFolder folder;
  const std::string pin = " --joint data/joints/wheel_pin.toml ";
  const std::string rig = " --joint data/duty/torque_rig.toml ";
  const std::string duty = "hinge-duty" + pin + "--force-in body --cycle ";
  const auto write = [&](const std::string& ending,
                         const std::string& options) {
    folder.run_well(duty + "data/duty/pin_swing.csv --states st" + ending +
                    " --output all" + ending + options);
    folder.run_well("hinge-joint --friction 0.1" + rig +
                    "--points data/duty/torque_rig.csv --columns "
                    "R_N,b_deg,torque_N_m,sigma_N_m --output m" +
                    ending + options);
  };
  write(".csv", "");
  write(".txt", form);
  EXPECT_NE(folder.read("st.csv"), folder.read("st.txt"));
  for (const auto& [program, file] :
       {std::pair("hinge-joint" + pin + "--points ", std::string("st")),
        {duty, "st"},
        {"hinge-identify" + rig + "--data ", "m"}}) {
    const std::string expected = folder.run_well(program + file + ".csv").out;
    EXPECT_EQ(folder.run_well(program + file + ".txt").out, expected);
    EXPECT_EQ(folder.run_well(program + file + ".txt" + form).out,
              folder.run_well(program + file + ".csv" + form).out);
  }
}

INSTANTIATE_TEST_SUITE_P(Forms, OwnOutput,
                         testing::Values(" --separator ';'", " --separator tab",
                                         " --separator '|'", " --decimal-comma",
                                         " --decimal-comma --separator tab",
                                         " --decimal-comma --separator '|'"));

// Files as spreadsheets and other programs save them.
TEST(Points, FilesOfOtherPrograms) {
  const ProgramFolder folder;
  const std::string rows = "1000.5,90\n1250,60\n";
  folder.write("plain.csv", "R_N,b_deg\n" + rows);
  const std::string points = joint + "--columns R_N,b_deg,M_t_N_m --points ";
  const std::string expected = folder.run_well(points + "plain.csv").out;
  std::string utf16 = "\xFF\xFE";
  for (const char c : "R_N;b_deg\r\n1000,5;90\r\n1250;60\r\n"s) {
    utf16 += {c, '\0'};
  }
  for (const std::string& text :
       {utf16, "\xEF\xBB\xBFR_N;b_deg\r1000,5;90\r1250;60\r"s,
        "sep=|\nR_N|b_deg\n1000.5|90\n1250|60\n"s,
        "% rig 7\n% June\n\nr_n,B_DEG\n" + rows, "# R_N,b_deg\n" + rows,
        "R_N\tb_deg\n1000,5\t90\n1250\t60\n"s,
        "R_N;b_deg\n\"1000,5\";90\n1,250e3;60\n"s,
        "\"left, old, of 7\";R_N;b_deg\na;1000,5;90\nb;1250;60\n"s}) {
    folder.write("other.csv", text);
    EXPECT_EQ(folder.run_well(points + "other.csv").out, expected) << text;
  }
  // The first column's name begins with the mark of a comment.
  folder.write("cycle.csv", "%cycle,R_N,b_deg\n0,1000.5,90\n");
  EXPECT_EQ(CsvTable(folder.run_well(joint + "--points cycle.csv").out)
                .texts("%cycle"),
            Texts{"0"});
  // Each row keeps its own.
  folder.write("rows.csv",
               "R_N,run,b_deg,place\n1,a,90,x\n2,b,60,y\n3,c,90,z\n");
  const CsvTable kept(folder.run_well(joint + "--points rows.csv").out);
  EXPECT_EQ(kept.texts("run"), (Texts{"a", "b", "c"}));
  EXPECT_EQ(kept.texts("place"), (Texts{"x", "y", "z"}));
}

// A comma that may separate thousands is not interpreted, nor a decimal comma
// if commas separate fields.
TEST(Points, OpenCommasAreRefused) {
  const ProgramFolder folder;
  const auto said = [&](const std::string& text,
                        const std::string& options = "") {
    folder.write("open.csv", text);
    return folder.run(joint + "--columns R_N --points open.csv" + options).err;
  };
  EXPECT_EQ(said("R_N;b_deg\n1,250;90\n"),
            "ERROR: line 2: R_N = 1,250 requires a decimal point, or "
            "--decimal-comma: it may be 1250\n");
  EXPECT_EQ(said("R_N;b_deg\n1,250;90\n", " --decimal-comma"), "");
  EXPECT_EQ(said("R_N;b_deg\n1,250;90\n2,5;90\n"), "");
  EXPECT_EQ(said("R_N;b_deg\n1,2500;90\n"), "");
  EXPECT_EQ(said("R_N;b_deg\n0,250;90\n"), "");
  EXPECT_EQ(said("R_N;b_deg\n1.250;90\n2,5;90\n"),
            "ERROR: line 2: R_N = 1.250 requires a decimal comma, which this "
            "file has: it may be 1250\n");
  EXPECT_EQ(said("R_N,b_deg\n\"1,5\",90\n"),
            "ERROR: line 2: R_N = \"1,5\" must be a number, 0 to 1e+100 N; "
            "where commas separate, decimals have a point\n");
  EXPECT_EQ(said("R_N,b_deg\n1,5,90\n"),
            "ERROR: line 2: 3 fields where the header has 2; where commas "
            "separate, decimals have a point\n");
}

}  // namespace
}  // namespace contact::test::points_test
