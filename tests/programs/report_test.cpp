// Terminal output: reports, colours, notes. script(1) gives the programs one.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "cli/stream/quoting.hpp"
#include "cli/stream/terminal_report.hpp"
#include "cli/stream/verdict.hpp"
#include "support/program.hpp"

namespace contact::test::report_test {
namespace {

using cli::shown_unit;

// Standard output and error of a command on a terminal, without the carriage
// returns that it adds.
std::string on_terminal(const ProgramFolder& folder,
                        const std::string& command) {
  std::string text =
      folder.run("script -qec \"" + command + "\" /dev/null </dev/null").out;
  std::erase(text, '\r');
  return text;
}

std::size_t lines_of(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

const std::string bush =
    "hinge-joint --joint data/joints/lined_bush_pressed.toml --reaction 10kN";

TEST(ShownUnit, IsTheColumnsAndItsPrefixLeavesOneToAThousand) {
  const auto shown = [](std::string_view column, double value) {
    const cli::ShownUnit unit = shown_unit(column).scaled(value);
    return unit.stem + ' ' + unit.text(value) + ' ' + unit.symbol;
  };
  EXPECT_EQ(shown("p_peak_Pa", 40531983.87547975), "p_peak 40.53 MPa");
  EXPECT_EQ(shown("M_t_N_m", 10.785654177952162), "M_t 10.79 N m");
  EXPECT_EQ(shown("M_t_N_m", 8), "M_t 8 N m");
  EXPECT_EQ(shown("shift_m", 1.7167675155850423e-05), "shift 17.17 µm");
  EXPECT_EQ(shown("theta0_deg", 100.64545841538), "theta0 100.6 °");
  EXPECT_EQ(shown("contact_area_m2", 5.269783879586214e-4),
            "contact_area 527.0 mm^2");
  EXPECT_EQ(shown("stiffness_N_per_m", 475899034.56), "stiffness 475.9 MN/m");
  // Both sides of a prefix: 999.96 would be printed as 1000.
  EXPECT_EQ(shown("R_N", 999.94), "R 999.9 N");
  EXPECT_EQ(shown("R_N", 999.96), "R 1.000 kN");
  EXPECT_EQ(shown("R_N", 0), "R 0 N");
  EXPECT_EQ(shown("R_N", -2500), "R -2.5 kN");
  EXPECT_EQ(shown("x_m", HUGE_VAL), "x inf m");
  // No units: a law's part, a coefficient, a count.
  EXPECT_EQ(shown("f_M", 0.10785654), "f_M 0.1079 ");
  EXPECT_EQ(shown("sigma_Z", 0.30000000000000004), "sigma_Z 0.3000 ");
  EXPECT_EQ(shown("evaluations", 1234567), "evaluations 1234567 ");
  // As given, in its own unit.
  EXPECT_EQ(shown("geometry.radius_mm", 16000), "geometry.radius 16000 mm");
  // A unit that no key has, and what rounding leaves.
  EXPECT_EQ(shown("K_load_N_m_per_rad", 96710), "K_load 96710 N m/rad");
  EXPECT_EQ(shown("drift_J", 9.379e-13), "drift 9.379e-13 J");
  EXPECT_EQ(shown("pv_max_W_per_m2", 1.667e6), "pv_max 1.667 MPa m/s");
  EXPECT_EQ(shown("x_N", 5e-10), "x 5e-10 N");
}

TEST(ShownUnit, IsOfTheWholeNameAndNotOfALetterInIt) {
  const auto shown = [](std::string_view column) {
    const cli::ShownUnit unit = shown_unit(column);
    return unit.stem + ": " + unit.symbol;
  };
  // Only power over area is PV.
  EXPECT_EQ(shown("pv_integral_J"), "pv_integral: J");
  EXPECT_EQ(shown("pv_total_W"), "pv_total: W");
  EXPECT_EQ(shown("q_max_W_per_m2"), "q_max: W/m^2");
  EXPECT_EQ(shown("pv_nominal_W_per_m2"), "pv_nominal: Pa m/s");
  // Products that no key has.
  EXPECT_EQ(shown("largest_pv_integral_carrier_Pa_m"),
            "largest_pv_integral_carrier: Pa m");
  EXPECT_EQ(shown("latch_impulse_N_m_s"), "latch_impulse: N m s");
  EXPECT_EQ(shown("k_seat_mm3_per_N_m"), "k_seat: mm^3/(N m)");
  EXPECT_EQ(shown("geometry.radial_clearance_um"),
            "geometry.radial_clearance: µm");
}

TEST(TerminalReport, OfOneRowHasTheAnswerBesideTheTextbooks) {
  const ProgramFolder folder;
  const std::string text = on_terminal(folder, bush);
  const CsvTable csv = folder.table(bush);
  EXPECT_TRUE(has_text(text, "friction torque")) << text;
  const double more = 100 * (csv.at("M_t_N_m") / csv.at("M_textbook_N_m") - 1);
  EXPECT_NEAR(more, 34.82, 0.01);
  EXPECT_TRUE(has_text(text, "10.79 N m   textbook f0 R r 8 N m (+34.8 %)"))
      << text;
  for (const char* part :
       {"100.6°", "40.53 MPa", "nominal 33.33 MPa", "lifts off at 2.838 kN",
        "0.1079", "4.540 N m", "more: --all, --plot FILE, --format csv"}) {
    EXPECT_TRUE(has_text(text, part)) << part << '\n' << text;
  }
  EXPECT_GE(lines_of(text), 8U) << text;
  EXPECT_LE(lines_of(text), 16U) << text;
  // The same in a pipe on request, without the further commands.
  const std::string piped = folder.run_well(bush + " --format report").out;
  EXPECT_TRUE(has_text(text, piped.substr(0, piped.size() - 1))) << piped;
  EXPECT_FALSE(has_text(piped, "more:"));
  // All that CSV has, and is not empty, is there with --all.
  const std::string all = folder.run_well(bush + " --format report --all").out;
  std::size_t full = 0;
  for (const std::string& name : csv.names()) full += !csv.text(name).empty();
  EXPECT_EQ(lines_of(all), full + 2) << all;
}

TEST(TerminalReport, OfSeveralRowsIsATableOfWhatMatters) {
  const ProgramFolder folder;
  const std::string text = folder
                               .run_well(
                                   "hinge-joint --joint "
                                   "data/joints/pin_joint.toml --reaction "
                                   "1kN,2kN --set geometry.length_mm=30,50 "
                                   "--format report")
                               .out;
  const std::string head = text.substr(0, text.find("\n  ", 60));
  for (const char* name : {"geometry.length, mm", "R, kN", "M_t, N m",
                           "theta0, °", "p_peak, MPa"}) {
    EXPECT_TRUE(has_text(text, name)) << name << '\n' << text;
  }
  EXPECT_FALSE(has_text(text, "residual")) << text;
  EXPECT_EQ(std::ranges::count(text, '\n'), 5 + 2) << text;
}

// The lines of a command's report in a pipe.
std::string report_of(const ProgramFolder& folder, const std::string& command) {
  return folder.run_well(command + " --format report").out;
}

// The first line that begins with these words; "" if there is none.
std::string line_of(const std::string& text, const std::string& words) {
  const auto at = text.find("\n  " + words);
  if (at == text.npos) return "";
  return text.substr(at + 1, text.find('\n', at + 1) - at - 1);
}

// The report on rows whose cells each end a line.
std::string report_of(cli::TerminalReport report, std::string_view cells) {
  std::string text = report.add(cells);
  text += report.rest();
  return text;
}

const std::string pin = "data/joints/pin_joint.toml";
const std::string cycle =
    "hinge-duty --joint " + pin + " --cycle data/duty/pin_cycle.csv";

TEST(TerminalReport, OfChosenColumnsHasEachOfThem) {
  const ProgramFolder folder;
  const std::string joint = "hinge-joint --joint " + pin +
                            " --columns p_nominal_Pa,M_t_N_m,evaluations,R_N";
  // A table keeps their order.
  EXPECT_EQ(report_of(folder, joint + " --reaction 10kN,20kN"),
            "pin joint, 40 mm steel pin in bronze\n\n"
            "  p_nominal, MPa  M_t, N m  evaluations  R, kN\n"
            "               5     20.09            4     10\n"
            "              10     40.53            4     20\n");
  const std::string one = report_of(folder, joint + " --reaction 10kN");
  EXPECT_EQ(line_of(one, "p nominal"), "  p nominal        5 MPa");
  EXPECT_EQ(line_of(one, "friction torque"), "  friction torque  20.09 N m");
  EXPECT_EQ(lines_of(one), 2 + 4) << one;
  // One without a value too.
  EXPECT_EQ(
      report_of(cli::TerminalReport({"R_N", "R_lift_off_N"}, {.chosen = true}),
                "1000\n\n"),
      "  reaction    1 kN\n"
      "  R lift off  -\n");
}

TEST(TerminalReport, HasNumbersBesideAValueInTheirOwnUnits) {
  const ProgramFolder folder;
  const std::string command =
      "hinge-joint --joint " + pin + " --reaction 1kN:10kN:1kN --equivalent";
  const std::string line =
      line_of(report_of(folder, command), "torque per axis");
  const CsvTable csv = folder.table(command);
  const double error =
      csv.at(csv.row_of("torque_per_axis_N_m"), "largest_error");
  // Relative errors have none, errors of the value have the value's.
  EXPECT_TRUE(line.ends_with(fmt::format("N m  {:>13.4f}", error))) << line;
  const std::string duty =
      report_of(folder, cycle + " --columns quantity,value,at_time_s,x");
  EXPECT_TRUE(has_text(duty, "at_time, s")) << duty;
  EXPECT_TRUE(has_text(line_of(duty, "largest theta0"), "26.94°      0.3625"))
      << duty;
  const std::string fit =
      report_of(folder,
                "hinge-identify --joint data/duty/torque_rig.toml --data "
                "data/duty/torque_rig.csv");
  EXPECT_TRUE(has_text(line_of(fit, "A "), "kPa       6.340 kPa")) << fit;
  // Lines without a value are left out.
  EXPECT_FALSE(has_text(fit, "rate trend")) << fit;
}

TEST(TerminalReport, HasResultsThatAnOptionAskedFor) {
  const ProgramFolder folder;
  const std::string plain = report_of(folder, cycle);
  EXPECT_FALSE(has_text(plain, "wear")) << plain;
  const std::string measured = report_of(
      folder,
      cycle +
          " --measured-volume 2 --measured-error 0.1 --measured-cycles 1e4");
  EXPECT_TRUE(has_text(measured, "measured wear coefficient k")) << measured;
  EXPECT_TRUE(has_text(measured, "standard error")) << measured;
  const std::string worn =
      report_of(folder, cycle + " --wear-seat 1e-7 --cycles 1e4");
  for (const char* part :
       {"wear of a cycle (seat)", "deepest wear of a cycle", "cycles 10000",
        "half-angle after them", "peak pressure after them"}) {
    EXPECT_TRUE(has_text(worn, part)) << part << '\n' << worn;
  }
  // In a table of joints too, whatever else there is no room for.
  const std::string table = report_of(
      folder, cycle + " --wear-seat 1e-7 --set geometry.length_mm=40,50");
  EXPECT_TRUE(has_text(table, "mm^3")) << table;
}

TEST(TerminalReport, BreaksTheHeadsOfATableThatIsTooWide) {
  const cli::TerminalReport report(
      {"geometry.radial_clearance_um", "largest_M_t_N_m", "residual",
       "effective_sliding_distance_m", "largest_pv_max_W_per_m2"},
      {.chosen = true});
  EXPECT_EQ(report_of(report,
                      "20\n66.7\n1e-20\n0.044\n1.26e6\n"
                      "40\n65.25\n0\n0.044\n1.667e6\n"),
            "   geometry.                      effective_\n"
            "     radial_                        sliding_  largest_\n"
            "  clearance,  largest_             distance,   pv_max,\n"
            "          µm  M_t, N m  residual          mm   MPa m/s\n"
            "          20      66.7     1e-20          44      1.26\n"
            "          40     65.25         0          44     1.667\n");
}

TEST(TerminalReport, LeavesOutWhatMattersLeast) {
  const cli::TerminalReport report(
      {"key_of_a_joint", "energy_J", "a_number_without_importance",
       "largest_M_t_N_m", "largest_theta0_deg", "theta0_fitted_deg",
       "p_peak_exact_by_exact_Pa", "load_N", "largest_p_peak_Pa",
       "largest_pv_max_W_per_m2", "volume_seat_mm3"},
      {});
  std::string cells;
  for (int i = 0; i < 22; ++i) cells += fmt::format("1.23456{}\n", i);
  const std::string text = report_of(report, cells);
  // Differences of joints and numbers asked for stay.
  for (const char* part : {"key_of_", "volume_", "load, N"}) {
    EXPECT_TRUE(has_text(text, part)) << part << '\n' << text;
  }
  EXPECT_FALSE(has_text(text, "energy")) << text;
  EXPECT_FALSE(has_text(text, "importance")) << text;
}

TEST(TerminalReport, OfASeparationIsShortAndNamesItsPairs) {
  const ProgramFolder folder;
  const std::string soyuz = "hinge-separation data/cases/soyuz.toml";
  const std::string text = report_of(folder, soyuz);
  EXPECT_LE(lines_of(text), 25U) << text;
  for (const char* part :
       {"upper nodes break: upper node breaks", "4 bodies", "booster 3",
        "486.6", "139.8 mm", "of core and booster 3", "largest energy"}) {
    EXPECT_TRUE(has_text(text, part)) << part << '\n' << text;
  }
  const std::string all = report_of(folder, soyuz + " --all");
  EXPECT_GE(lines_of(all), 70U) << all;
  EXPECT_TRUE(has_text(line_of(all, "core and booster 3"), "139.8 mm")) << all;
  // Those that the case asks for.
  const std::string stages =
      report_of(folder, "hinge-separation data/cases/two_stages.toml");
  EXPECT_TRUE(has_text(stages, "upper at end")) << stages;
  EXPECT_TRUE(has_text(stages, "0.2053")) << stages;
}

TEST(TerminalReport, OnlyWhereNothingElseIsAskedFor) {
  const ProgramFolder folder;
  const auto is_report = [&](const std::string& options) {
    return has_text(on_terminal(folder, bush + options), "friction torque");
  };
  EXPECT_TRUE(is_report(""));
  EXPECT_FALSE(is_report(" --format csv"));
  EXPECT_FALSE(is_report(" --format json"));
  EXPECT_FALSE(is_report(" --separator tab"));
  EXPECT_FALSE(is_report(" --decimal-comma"));
  EXPECT_FALSE(is_report(" --output -"));
  EXPECT_FALSE(is_report(" | cat"));
  EXPECT_FALSE(is_report(" --output o.csv"));
  EXPECT_EQ(folder.read("o.csv"), folder.run_well(bush).out);
}

TEST(TerminalReport, ColoursVerdictsWhereTheyAreWanted) {
  const ProgramFolder folder;
  const std::string rest =
      "hinge-joint --joint data/joints/pin_joint.toml --reaction-xyz 1000,0,0 "
      "--moment-xyz 0,0,1";
  const auto has_colour = [&](const std::string& command) {
    const std::string text = on_terminal(folder, command);
    EXPECT_TRUE(has_text(text, "holds")) << text;
    return has_text(text, "\033[32mholds\033[0m");
  };
  EXPECT_TRUE(has_colour(rest));
  EXPECT_TRUE(has_colour("NO_COLOR= " + rest));
  EXPECT_FALSE(has_colour("NO_COLOR=1 " + rest));
  EXPECT_TRUE(has_colour("NO_COLOR=1 " + rest + " --color always"));
  EXPECT_FALSE(has_colour(rest + " --color never"));
  EXPECT_FALSE(
      has_text(folder.run_well(rest + " --format report").out, "\033"));
  EXPECT_TRUE(has_text(
      folder.run_well(rest + " --format report --color always").out, "\033"));
  // Names in files speak to no terminal.
  folder.write("j.toml",
               "name = \"\\u001b[31m\"\nkind = \"pin\"\n[geometry]\n"
               "radius_mm = 20\nradial_clearance_um = 40\n"
               "length_mm = 50\n[materials]\npair = "
               "\"data/materials/steel_bronze.toml\"\n[friction]\n"
               "coefficient = 0.1\n");
  EXPECT_FALSE(
      has_text(on_terminal(folder, "hinge-joint --joint j.toml --reaction 1kN"),
               "\033"));
}

TEST(TerminalReport, OfAStudyBeginsWithItsVerdictInWords) {
  const ProgramFolder folder;
  const std::string study =
      "hinge-study data/studies/lined_bearing.toml --runs 20 --journal s.j";
  const std::string text = on_terminal(folder, study + " 2>/dev/null");
  EXPECT_TRUE(has_text(text, "Open: whether")) << text;
  EXPECT_TRUE(has_text(text, "at most 40 N m")) << text;
  EXPECT_FALSE(has_text(text, "|")) << text;
  EXPECT_FALSE(has_text(text, "M_t_N_m")) << text;
  // What is too wide for a page is left out, and is there with --all.
  EXPECT_TRUE(has_text(text, "deviation        5 %       95 %")) << text;
  EXPECT_TRUE(has_text(folder.run_well(study + " --format report --all").out,
                       "largest  missing"));
  // In a pipe the same Markdown as ever.
  EXPECT_TRUE(has_text(folder.run_well(study).out, "| M_t_N_m at most 40 |"));
}

TEST(Verdict, OfATableIsColoured) {
  EXPECT_EQ(cli::with_coloured_verdicts("| a |     met |\n| b | not met |\n"),
            "| a |\033[32m     met \033[0m|\n| b |\033[31m not met "
            "\033[0m|\n");
  EXPECT_EQ(cli::with_coloured_verdicts("| metal | x |\n"), "| metal | x |\n");
}

TEST(TerminalReport, QuietLeavesNotesOutAndNoWarnings) {
  const ProgramFolder folder;
  const std::string fit =
      "hinge-angle --joint pin --pair data/materials/steel_bronze.toml "
      "--diameter 20mm --hole H7 --shaft f7 --load 1kN/m";
  EXPECT_TRUE(has_text(folder.run_well(fit).err, "note: "));
  EXPECT_FALSE(has_text(folder.run_well(fit + " --quiet").err, "note: "));
  EXPECT_TRUE(has_text(folder.run_well(bush + " --quiet").err, "warning: "));
}

TEST(TerminalReport, QuietLeavesProgressOut) {
  const ProgramFolder folder;
  // Some seconds of wear step by step.
  const std::string wear = cycle + " --wear-seat 1e-7 --cycles 2e5 --blocks b";
  EXPECT_TRUE(has_text(on_terminal(folder, wear), "% of the cycles"));
  EXPECT_FALSE(
      has_text(on_terminal(folder, wear + " --quiet"), "% of the cycles"));
}

class Reports : public testing::TestWithParam<const char*> {};

TEST_P(Reports, OfEveryProgramFitATerminal) {
  const ProgramFolder folder;
  const std::string text =
      on_terminal(folder, std::string(GetParam()) + " 2>/dev/null");
  EXPECT_GE(lines_of(text), 3U) << text;
  EXPECT_LE(lines_of(text), 40U) << text;
  EXPECT_FALSE(has_text(text, "\"")) << text;
  for (std::istringstream lines(text); lines;) {
    std::string line;
    std::getline(lines, line);
    EXPECT_LE(cli::terminal_width(line), cli::TerminalReport::widest_table)
        << line;
  }
  // No number of more than four digits but whole ones.
  EXPECT_FALSE(has_text(text, "0000000")) << text;
}

INSTANTIATE_TEST_SUITE_P(
    Of, Reports,
    testing::Values(
        "hinge-joint --joint data/joints/pin_joint.toml --reaction 10kN",
        "hinge-angle --joint data/joints/pin_joint.toml --load 1kN:9kN:2kN",
        "hinge-pressure --joint data/joints/pin_joint.toml --load 10kN",
        "hinge-table --theta0 20:80:20 --alpha 0:90:30",
        "hinge-table --theta0 20:80:20 --alpha 0:90:30 --quantity sigma_Z",
        "hinge-duty --joint data/joints/pin_joint.toml --cycle "
        "data/duty/pin_cycle.csv",
        "hinge-duty --joint data/joints/pin_joint.toml --cycle "
        "data/duty/pin_cycle.csv --set geometry.radial_clearance_um=20,40",
        "hinge-identify --joint data/duty/torque_rig.toml --data "
        "data/duty/torque_rig.csv",
        "hinge-angle --joint data/joints/pin_joint.toml --load 1kN --law all",
        "hinge-separation data/cases/solar_array.toml",
        "hinge-separation data/cases/door.toml",
        "hinge-study data/studies/lined_bearing.toml --check"));

}  // namespace
}  // namespace contact::test::report_test
