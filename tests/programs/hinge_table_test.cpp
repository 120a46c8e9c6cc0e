// The program hinge-table, run as its users run it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/number.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/friction/elliptic/friction.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/friction/models.hpp"
#include "libcontact/pressure/exact.hpp"
#include "libcontact/pressure/factory.hpp"
#include "libcontact/tools/reference/quadrature.hpp"
#include "programs/table/run.hpp"
#include "support/accuracy_report.hpp"
#include "support/friction_reference.hpp"
#include "support/program.hpp"

namespace contact::test::hinge_table_test {
namespace {

constexpr const char* header =
    "theta0_deg,alpha_deg,I_normal_cosine,I_p_cosine,J_p_cosine,K_p_cosine,"
    "I_a,J_a,K_a,chi_cosine,sigma_Y_cosine,sigma_Z_cosine";

// The library's values of a row, in the order of the columns.
std::vector<double> row_of(double theta0_deg, double alpha_deg,
                           const FrictionIntegrals& values) {
  std::vector<double> row = {theta0_deg, alpha_deg, values.normal};
  for (const auto& triple :
       {values.pressure, values.area, values.coefficient}) {
    row.insert(row.end(), {triple.force, triple.sliding, triple.spinning});
  }
  return row;
}
std::vector<double> library_row(double theta0_deg, double alpha_deg) {
  return row_of(
      theta0_deg, alpha_deg,
      contact::friction_integrals(theta0_deg * contact::degree,
                                  contact::SlipAxis::from_degrees(alpha_deg)));
}

TEST(HingeTable, GridHasTheLibrarysValuesToTheLastDigit) {
  const ProgramResult result = ProgramFolder().run_well(
      "hinge-table --theta0 0:120:15 --alpha -90:90:22.5");
  EXPECT_EQ(result.err, "");
  const auto rows = csv_rows(result.out);
  EXPECT_EQ(first_line(result.out), header);
  ASSERT_EQ(rows.size(), 1U + 9 * 9);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::size_t step = (i - 1) / 9;
    const double theta0_deg = 15.0 * static_cast<double>(step);
    const double alpha_deg = -90 + 22.5 * static_cast<double>((i - 1) % 9);
    const auto expected = library_row(theta0_deg, alpha_deg);
    ASSERT_EQ(rows[i].size(), expected.size());
    for (std::size_t j = 0; j < expected.size(); ++j) {
      // Errors that the batch (in the program) and the single call state:
      // 1.7e-15 and 1.6e-15.
      const double value = cli::parse_number(rows[i][j]).value();
      EXPECT_LE(relative_error(value, expected[j]), 3.3e-15)
          << "row " << i << " column " << j;
    }
  }
}

TEST(HingeTable, EveryMethodIsTheLibrarys) {
  using Function = FrictionIntegrals (*)(double, SlipAxis);
  const std::vector<std::pair<std::string, Function>> methods = {
      {"elliptic", elliptic_friction_integrals},
      {"planar", planar_friction_integrals},
      {"viscous", viscous_friction_integrals},
      {"cosine", cosine_friction_integrals},
      {"quadrature", [](double half_angle, SlipAxis axis) {
         return reference::quadrature_friction_integrals(half_angle, axis, 1e-6)
             .value;
       }}};
  const ProgramFolder folder;
  for (const auto& [name, function] : methods) {
    const ProgramResult result = folder.run_well(
        "hinge-table --theta0 0,20,95 --alpha -90:90:30 --method " + name +
        (name == "quadrature" ? " --tolerance 1e-6" : ""));
    const auto rows = csv_rows(result.out);
    ASSERT_EQ(rows.size(), 22U);
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const double theta0_deg = std::stod(rows[i][0]);
      const double alpha_deg = std::stod(rows[i][1]);
      const auto expected = row_of(
          theta0_deg, alpha_deg,
          function(theta0_deg * degree, SlipAxis::from_degrees(alpha_deg)));
      for (std::size_t j = 0; j < expected.size(); ++j) {
        EXPECT_EQ(cli::parse_number(rows[i][j]), expected[j])
            << name << " row " << i << " column " << j;
      }
    }
  }
}

TEST(HingeTable, SaysWhichPointsMissTheTolerance) {
  // K is a small difference here: the quadrature loses its digits.
  const ProgramResult result = ProgramFolder().run(
      "hinge-table --theta0 0.01,45 --alpha 0.1 --method quadrature");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err,
            "hinge-table: warning: points that missed the tolerance: 1; their "
            "rows contain the best values found\n");
  EXPECT_EQ(csv_rows(result.out).size(), 3U);
}

// A method that is wrong at 30 deg: what a kernel that its compiler has spoilt
// did to whole tables, with status 0.
TEST(HingeTable, APointThatIsNotFiniteIsAnErrorInItsPlace) {
  const ProgramFolder folder;
  const hinge_table::Method method{
      [](const hinge_table::Points& points,
         const hinge_table::Columns& columns) {
        for (std::size_t i = 0; i < points.half_angle.size(); ++i) {
          for (const auto& column : columns) column[i] = 0.5;
          if (std::abs(points.half_angle[i] - 30 * degree) < 1e-9) {
            columns[8][i] = std::nan("");
          }
        }
        return std::size_t{0};
      },
      "cosine", 120 * degree};
  const auto run = [&](hinge_table::Options options) {
    options.output.output = (folder.path() / "table.csv").string();
    testing::internal::CaptureStderr();
    EXPECT_EQ(hinge_table::run(options, method, ""), cli::some_bad);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "hinge-table: warning: points whose numbers are not finite: 1; "
              "the table shows ERROR\n");
    return folder.read("table.csv");
  };
  hinge_table::Options options;
  options.theta0 = "20,30";
  options.alpha = "10";
  const CsvTable table(run(options));
  EXPECT_EQ(table.texts("sigma_Y_cosine"), (Texts{"0.5", "ERROR"}));
  EXPECT_EQ(table.texts("sigma_Z_cosine"), (Texts{"0.5", "0.5"}));
  options.output.format = cli::Format::markdown;
  options.quantity = "sigma_Y";
  EXPECT_TRUE(has_text(run(options), "|  ERROR |"));
}

// The largest errors of the paper's approximations, at 34.8 and 74.6 deg.
TEST(HingeTable, EllipticIntegralsAndThePapersApproximations) {
  const ProgramFolder folder;
  const CsvTable exact =
      folder.table("hinge-table --theta0 0,30 --quantity K,E");
  EXPECT_NEAR(exact.at(1, "K"), detail::pi / 2, 1e-15);
  EXPECT_NEAR(exact.at(2, "K"), 1.6857503548125961, 1e-14);
  EXPECT_NEAR(exact.at(2, "E"), 1.4674622093394272, 1e-14);
  const CsvTable table = folder.table(
      "hinge-table --theta0 1:89:0.05 --quantity K,E --method chebyshev");
  double k = 0, e = 0;
  for (std::size_t row = 1; row <= table.size(); ++row) {
    k = std::max(k, std::abs(table.at(row, "K_error_percent")));
    e = std::max(e, std::abs(table.at(row, "E_error_percent")));
  }
  EXPECT_NEAR(k, 0.108, 5e-4);
  EXPECT_NEAR(e, 0.269, 5e-4);
}

// The gains that the paper prints for 4 and 6 bodies, of two digits, two of
// them a unit of the last one off: balls, then axes, of sections 1.3 and 4.
TEST(HingeTable, OperationsHaveThePapersGains) {
  const CsvTable table =
      ProgramFolder().table("hinge-table --quantity operations --bodies 4,6");
  ASSERT_EQ(table.size(), 12u);
  const auto expect_gains = [&](std::size_t row, double four, double six) {
    EXPECT_NEAR(table.at(row, "gain_paper"), four, 0.08);
    EXPECT_NEAR(table.at(row + 1, "gain_paper"), six, 0.08);
  };
  expect_gains(1, 1.3, 2);
  expect_gains(3, 2.2, 4);
  expect_gains(7, 2.1, 3.4);
  expect_gains(9, 4.9, 9.4);
  // By hand: 6 balls have 18 unknowns, whose factor takes 2109 operations.
  EXPECT_EQ(table.at(4, "N_at_once"), 3171);
  EXPECT_EQ(table.at(6, "N_at_once"), 3171 - 2109);
  for (std::size_t row = 1; row <= table.size(); ++row) {
    EXPECT_EQ(table.at(row, "gain_ours"),
              table.at(row, "N_at_once") / table.at(row, "N_ours"));
    EXPECT_LT(table.at(row, "N_ours"), table.at(row, "N_paper"));
  }
}

TEST(HingeTable, PointsOfTheReferenceTable) {
  // The table's own columns ride along and are compared in place.
  const CsvTable table = ProgramFolder().table(
      "hinge-table --points data/reference/friction_integrals.csv");
  ASSERT_EQ(table.size(), friction_reference().size());
  for (const char* name : {"I_p", "J_p", "K_p", "I_a", "J_a", "K_a", "chi",
                           "sigma_Y", "sigma_Z"}) {
    // The reference's columns do not say so.
    const bool by_pressure = !std::string_view(name).ends_with("_a");
    const std::string computed =
        std::string(name) + (by_pressure ? "_cosine" : "");
    const std::string expected = std::string(name) + (by_pressure ? "" : "_in");
    // The bar of the exact method on its reference data.
    AccuracyReport report(name, 1e-14);
    for (std::size_t row = 1; row <= table.size(); ++row) {
      report.add(table.at(row, computed), table.at(row, expected),
                 std::to_string(row));
    }
  }
}

TEST(HingeTable, ColumnsRideAlongUnchanged) {
  const ProgramFolder folder;
  folder.write("points.csv",
               "# made by hand\n"
               "note,alpha_deg,chi_cosine,\"theta0_deg\",mass\r\n"
               "\"a, \"\"b\"\"\",30,x,45,1.50\r\n"
               "\n"
               " plain ,\"+6e1\",, 20,007\n");
  const ProgramResult result =
      folder.run_well("hinge-table --points points.csv");
  std::string expected = std::string(header) + ",note,chi_cosine_in,mass\n";
  const auto add = [&](double theta0_deg, double alpha_deg,
                       const std::string& rest) {
    for (const double value : library_row(theta0_deg, alpha_deg)) {
      expected += cli::number_text(value) + ',';
    }
    expected += rest + '\n';
  };
  add(45, 30, "\"a, \"\"b\"\"\",x,1.50");
  add(20, 60, " plain ,,007");
  // Numbers may differ in their last digits between batch and single call,
  // so compare all else character by character.
  const auto rows = csv_rows(result.out);
  const auto wanted = csv_rows(expected);
  ASSERT_EQ(rows.size(), wanted.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), wanted[i].size());
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      if (i > 0 && j >= 2 && j < 12) {
        EXPECT_NEAR(std::stod(rows[i][j]), std::stod(wanted[i][j]), 1e-14);
      } else {
        EXPECT_EQ(rows[i][j], wanted[i][j]);
      }
    }
  }
}

TEST(HingeTable, BadLinesAreAnsweredInTheirPlace) {
  const ProgramFolder folder;
  folder.write("points.csv",
               "theta0_deg,alpha_deg,note\n"
               "10,20,good\n"
               "121,20,theta0\n"
               "10,-91,alpha\n"
               "ten,20,text\n"
               ",20,empty\n"
               "nan,20,nan\n"
               "10,inf,inf\n"
               "10,20\n"
               "10,20,\"open\n"
               "10,20,\"closed\"x\n"
               "20,30,good");
  for (const char* jobs : {"1", "3"}) {
    const ProgramResult result = folder.run(
        std::string("hinge-table --points - --jobs ") + jobs + " < points.csv");
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(
        result.err,
        "ERROR: line 3: theta0_deg = 121 must be 0 to 120 deg\n"
        "ERROR: line 4: alpha_deg = -91 must be -90 to 90 deg\n"
        "ERROR: line 5: theta0_deg = ten must be a number, 0 to 120 deg\n"
        "ERROR: line 6: theta0_deg = (empty) must be a number, 0 to 120 deg\n"
        "ERROR: line 7: theta0_deg = nan must be 0 to 120 deg\n"
        "ERROR: line 8: alpha_deg = inf must be -90 to 90 deg\n"
        "ERROR: line 9: 2 fields where the header has 3\n"
        "ERROR: line 10: a quote is left open\n"
        "ERROR: line 11: text after a closing quote\n");
    const auto rows = csv_rows(result.out);
    ASSERT_EQ(rows.size(), 12U);
    const std::vector<std::string> notes = {
        "theta0", "alpha", "text", "empty", "nan", "inf", "", "", ""};
    for (std::size_t i = 0; i < notes.size(); ++i) {
      std::vector<std::string> expected(13);
      expected.front() = "ERROR";
      expected.back() = notes[i];
      EXPECT_EQ(rows[i + 2], expected);
    }
    EXPECT_EQ(rows[1].back(), "good");
    EXPECT_EQ(rows[11].back(), "good");
    EXPECT_EQ(rows[11].front(), "20");
  }
}

// Blanks too: what is behind them is not looked at.
TEST(HingeTable, LinesThatAreTooLongAreAnsweredInTheirPlace) {
  const ProgramFolder folder;
  for (const char fill : {'1', ' '}) {
    for (const std::size_t size : {1'000'001, 2'500'000}) {
      folder.write("points.csv", "theta0_deg,alpha_deg,note\n10,20,a\n" +
                                     std::string(size, fill) +
                                     "30,40,b\n20,30,c\n");
      for (const char* jobs : {"1", "3"}) {
        const ProgramResult result = folder.run(
            std::string("hinge-table --points points.csv --jobs ") + jobs);
        EXPECT_EQ(result.status, 1);
        EXPECT_EQ(result.err,
                  "ERROR: line 3: longer than 1000000 characters\n");
        const CsvTable table(result.out);
        EXPECT_EQ(table.texts("theta0_deg"), (Texts{"10", "ERROR", "20"}));
        EXPECT_EQ(table.texts("note"), (Texts{"a", "", "c"}));
      }
    }
  }
  folder.write("header.csv", std::string(1'000'001, 'x') + "\n1,2\n");
  folder.run_ill("hinge-table --points header.csv", 2,
                 "hinge-table: header.csv, line 1: longer than 1000000 "
                 "characters\n");
}

TEST(HingeTable, ManyPointsInOrderByAnyNumberOfJobs) {
  const ProgramFolder folder;
  std::string points = "theta0_deg,alpha_deg,n\n";
  for (int i = 0; i < 20000; ++i) {
    points += std::to_string(i % 120) + ',' + std::to_string(i % 90) + ',' +
              std::to_string(i) + '\n';
  }
  folder.write("points.csv", points);
  const ProgramResult one = folder.run("hinge-table --points points.csv");
  const ProgramResult four =
      folder.run("hinge-table --points points.csv --jobs 4");
  EXPECT_EQ(one.status, 0);
  EXPECT_EQ(one.out, four.out);
  const auto numbers = csv_column(csv_rows(one.out), "n");
  ASSERT_EQ(numbers.size(), 20000U);
  for (int i = 0; i < 20000; ++i) ASSERT_EQ(numbers[i], std::to_string(i));

  const std::string grid = "hinge-table --theta0 0:100:1 --alpha 0:90:0.5 ";
  EXPECT_EQ(folder.run(grid).out, folder.run(grid + "--jobs 3").out);
}

// Bytes of a file or its name do not get to the terminal as they are.
TEST(HingeTable, MessagesHaveNoRawBytes) {
  const ProgramFolder folder;
  folder.write("p.csv", "theta0_deg,alpha_deg\n\x1b[2J\xff,1\n");
  EXPECT_EQ(folder.run("hinge-table --points p.csv").err,
            "ERROR: line 2: theta0_deg = \\x1b[2J\\xff must be a number, 0 to "
            "120 deg\n");
  EXPECT_EQ(folder.run("hinge-table --points $(printf '\\233.csv')").err,
            "hinge-table: cannot open \\x9b.csv: No such file or directory\n");
}

TEST(HingeTable, OutputThatCannotBeWritten) {
  const ProgramFolder folder;
  const ProgramResult full = folder.run(
      "hinge-table --theta0 0:95:1 --alpha 0:90:1 --output /dev/full");
  EXPECT_EQ(full.status, 2);
  EXPECT_TRUE(has_text(full.err, "No space left"));
}

TEST(HingeTable, InterruptedRunLeavesNoFile) {
  const ProgramFolder folder;
  const ProgramResult result = folder.run(
      "hinge-table --theta0 0:120:0.001 --alpha 0:90:0.001 --output table.csv "
      "& program=$!\n"
      "while ! ls .table.csv.* >/dev/null 2>&1; do sleep 0.01; done\n"
      "kill -TERM $program; wait $program");
  EXPECT_EQ(result.status, 128 + 15);
  EXPECT_TRUE(folder.files().empty());
}

TEST(HingeTable, JsonParses) {
  const ProgramFolder folder;
  folder.write("points.csv",
               "theta0_deg,alpha_deg,note\n"
               "45,30,\"quote \"\" and \xC3\xA4 and \xFF\"\n"
               "200,30,bad\n");
  const ProgramResult result =
      folder.run("hinge-table --points points.csv --format json");
  EXPECT_EQ(result.status, 1);
  const auto json = nlohmann::ordered_json::parse(result.out);
  ASSERT_EQ(json.size(), 2U);
  std::string names;
  for (const auto& [name, value] : json[0].items()) names += name + ',';
  EXPECT_EQ(names, std::string(header) + ",note,");
  EXPECT_NEAR(json[0]["chi_cosine"], library_row(45, 30)[9], 1e-15);
  EXPECT_EQ(json[0]["note"], "quote \" and \xC3\xA4 and \xEF\xBF\xBD");
  EXPECT_EQ(json[1]["theta0_deg"], "ERROR");
  EXPECT_TRUE(json[1]["chi_cosine"].is_null());
}

TEST(HingeTable, TwoWayTables) {
  const ProgramFolder folder;
  const std::string grid =
      "hinge-table --theta0 45,90 --alpha 0,90 --quantity sigma_Z ";
  EXPECT_EQ(folder.run(grid + "--format markdown").out,
            "| sigma_Z_cosine: theta0_deg, alpha_deg |      0 |     90 |\n"
            "| ------------------------------------: | -----: | -----: |\n"
            "|                                    45 |  0.000 | 0.4379 |\n"
            "|                                    90 |  0.000 |  1.000 |\n");
  EXPECT_EQ(
      folder.run(grid + "--format latex").out,
      "\\begin{tabular}{rrr}\n\\hline\n"
      "sigma\\_Z\\_cosine: theta0\\_deg, alpha\\_deg & 0 & 90 \\\\\n\\hline\n"
      "45 & $0.000$ & $0.4379$ \\\\\n"
      "90 & $0.000$ & $1.000$ \\\\\n"
      "\\hline\n\\end{tabular}\n");
}

TEST(HingeTable, Plots) {
  const ProgramFolder folder;
  if (!folder.has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  const ProgramResult result = folder.run_well(
      "for kind in svg png pdf; do\n"
      "hinge-table --theta0 5:95:15 --alpha 0:90:1 --plot \"it's.$kind\" "
      ">table.csv || exit 1\ndone");
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(folder.files(),
            (Texts{"it's.pdf", "it's.png", "it's.svg", "table.csv"}));
  EXPECT_TRUE(has_text(folder.read("it's.svg"), "</svg>"));
  EXPECT_EQ(folder.read("it's.png").rfind("\x89PNG", 0), 0U);
  EXPECT_EQ(folder.read("it's.pdf").rfind("%PDF", 0), 0U);
}

TEST(HingeTable, SaysSoWithoutGnuplot) {
  const ProgramFolder folder;
  // A PATH on which only the program is found.
  const ProgramResult result = folder.run(
      "ln -s \"$(command -v hinge-table)\" hinge-table; PATH=.; "
      "hinge-table --theta0 45 --alpha 0,30 --plot a.svg --output table.csv");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(
      result.err,
      "hinge-table: warning: no picture a.svg: gnuplot is not installed\n");
  EXPECT_EQ(csv_rows(folder.read("table.csv")).size(), 3U);
}

TEST(HingeTable, OtherPressures) {
  const ProgramFolder folder;
  const auto pair = ElasticPair::from_modulus_ratio(7, 0.3, 0.4);
  const std::string grid = "hinge-table --theta0 20,100 --alpha 30,90 ";
  const std::string materials = "--modulus-ratio 7 --poisson2 0.4 ";
  for (const std::string& name : pressure_law_names()) {
    const auto law = make_pressure_law(name, JointKind::ball, pair);
    const bool by_materials = name == "mixture" || name == "exact";
    // The worn pressure ends at 90 deg.
    const std::string widest = name == "worn" ? "90" : "100";
    const CsvTable table =
        folder.table("hinge-table --theta0 20," + widest + " --alpha 30,90 " +
                     (by_materials ? materials : "") + "--pressure " + name);
    // Every column that depends on the pressure has its name.
    const std::string end = "_" + name;
    ASSERT_EQ(table["K_a"].size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto expected =
          friction_integrals(*law, (i < 2 ? 20 : std::stod(widest)) * degree,
                             SlipAxis::from_degrees(i % 2 == 0 ? 30 : 90));
      // The batch's last digits differ from the scalar call's.
      EXPECT_NEAR(table["chi" + end][i], expected.coefficient.force, 1e-14);
      EXPECT_NEAR(table["K_p" + end][i], expected.pressure.spinning, 1e-14);
      EXPECT_NEAR(table["I_normal" + end][i], expected.normal, 1e-14);
    }
  }
  // A joint file brings materials and pressure.
  const auto of_file = folder.run_well(
      grid +
      "--joint data/joints/hip_cocr_uhmwpe_infinite.toml --pressure exact");
  EXPECT_TRUE(has_text(of_file.out, "sigma_Z_exact"));
  const auto two_way =
      folder.run(grid + "--pressure sqrt_tan --format markdown");
  EXPECT_TRUE(has_text(two_way.out, "chi_sqrt_tan: theta0_deg"));
  const CsvTable definition(
      folder
          .run("hinge-table --theta0 20 --alpha 30 --pressure exact --method "
               "quadrature " +
               materials)
          .out);
  EXPECT_NEAR(
      definition.at("chi_exact"),
      folder.table(grid + materials + "--pressure exact").at("chi_exact"),
      4e-9);
}

// A ball in a liner, and one that is pressed from behind.
TEST(HingeTable, ExactPressuresOfOtherJoints) {
  const ProgramFolder folder;
  const auto expect_spinning = [&](const std::string& options,
                                   const std::string& column,
                                   const ExactPressure& law) {
    // The batch's last digits differ from the scalar call's.
    EXPECT_NEAR(
        folder.table("hinge-table --theta0 60 --alpha 90 " + options)
            .at(column),
        friction_integrals(law, 60 * degree, {1, 0}).coefficient.spinning,
        1e-14);
  };
  const std::string joint = "data/joints/hip_cocr_uhmwpe.toml";
  const JointSpec hip = read_joint(folder.path() / joint);
  const auto ball = JointKind::ball;
  expect_spinning("--joint " + joint, "sigma_Z_exact",
                  {ball, hip.conditions().walls.value()});
  expect_spinning("--pressure exact --modulus-ratio 7 --loading back:15",
                  "sigma_Z_exact_back:15",
                  {ball, ElasticPair::from_modulus_ratio(7, 0.3, 0.3),
                   InnerLoading::back(15 * degree)});
  // A patch of 80 deg leaves the contact no more than 100 deg.
  const ProgramResult beyond = folder.run(
      "hinge-table --theta0 60,110 --alpha 0,90 --pressure exact "
      "--modulus-ratio 7 --loading back:80");
  EXPECT_EQ(beyond.status, 1);
  EXPECT_TRUE(has_text(beyond.err,
                       "points without a value: 2; the pressure "
                       "exact_back:80 ends at "));
  EXPECT_EQ(CsvTable(beyond.out).text(3, "chi_exact_back:80"), "");
}

TEST(HingeTable, Version) {
  const ProgramResult result =
      ProgramFolder().run_well("hinge-table --version");
  EXPECT_EQ(result.out.rfind("hinge-table (libcontact) ", 0), 0U);
}

}  // namespace
}  // namespace contact::test::hinge_table_test
