// The program hinge-angle, run as its users run it.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "cli/number.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "libcontact/pressure/cosine.hpp"
#include "libcontact/pressure/exact.hpp"
#include "support/numbers.hpp"
#include "support/program.hpp"

namespace contact::test::hinge_angle_test {
namespace {

// Rows as numbers; an empty cell is NaN.
std::vector<std::vector<double>> numbers(const std::string& csv) {
  std::vector<std::vector<double>> table;
  auto rows = csv_rows(csv);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    auto& row = table.emplace_back();
    for (const std::string& cell : rows[i]) {
      row.push_back(cli::parse_number(cell).value_or(NAN));
    }
  }
  return table;
}

TEST(HingeAngle, PeakColumnsNameThePressure) {
  const ProgramFolder folder;
  const auto pair = ElasticPair::from_modulus_ratio(1, 0.3, 0.3);
  for (const std::string& name : pressure_law_names()) {
    const CsvTable table = folder.table(
        "hinge-angle --joint ball --modulus-ratio 1 --law exact --x 1 "
        "--pressure " +
        name);
    const double peak = table.at("p_peak_exact_by_" + name + "_over_nominal");
    const double half_angle = table.at("theta0_exact_deg") * degree;
    const auto law = make_pressure_law(name, JointKind::ball, pair);
    // theta0 comes back from degrees.
    EXPECT_NEAR(peak / (std::numbers::pi * law->peak(half_angle)), 1, 1e-13)
        << name;
  }
}

TEST(HingeAngle, DimensionlessRowsAreTheLibrarys) {
  const std::vector<std::string> laws = {"hertz", "arctan",    "tanh",
                                         "blend", "blend:0.3", "paper"};
  std::string header = "load_parameter,x";
  for (const std::string& law : laws) {
    header +=
        ",theta0_" + law + "_deg,p_peak_" + law + "_by_cosine_over_nominal";
  }
  for (const JointKind kind : kinds) {
    const ProgramResult result = ProgramFolder().run_well(
        "hinge-angle --modulus-ratio 0.5 --poisson1 0.25 --poisson2 0.3 "
        "--x 0,0.25:3:0.25,inf --law hertz,arctan,tanh,blend,blend:0.3,paper "
        "--pressure cosine --joint " +
        to_string(kind));
    EXPECT_EQ(first_line(result.out), header);
    const auto pair = ElasticPair::from_modulus_ratio(0.5, 0.25, 0.3);
    const CosinePressure pressure(kind);
    const double area = kind == JointKind::ball ? std::numbers::pi : 2;
    const auto rows = numbers(result.out);
    ASSERT_EQ(rows.size(), 14U);
    for (const auto& row : rows) {
      ASSERT_EQ(row.size(), 14U);
      EXPECT_EQ(row[0],
                contact::LoadScale::load_parameter_from_x(kind, row[1]));
      std::size_t column = 2;
      for (const std::string& name : laws) {
        const auto law = make_half_angle_law(name, kind, pair);
        const auto expected = law->half_angle(row[0]);
        const double half_angle = expected.half_angle;
        if (expected.status == Status::ok) {
          // The numbers read back as the same doubles.
          EXPECT_EQ(row[column], half_angle / degree) << name;
          EXPECT_EQ(row[column + 1], pressure.peak(half_angle) * area) << name;
        } else {
          EXPECT_TRUE(all_nan({row[column], row[column + 1]})) << name;
        }
        column += 2;
      }
    }
  }
}

TEST(HingeAngle, DimensionalRowsAreTheLibrarys) {
  for (const std::string file :
       {"joints/pin_joint.toml", "joints/hip_cocr_uhmwpe_infinite.toml"}) {
    const JointSpec joint =
        read_joint(std::string(CONTACT_DATA_DIR) + '/' + file);
    const ProgramResult result = ProgramFolder().run_well(
        "hinge-angle --law tanh --pressure cosine --load 0,100:1e6:log7 "
        "--joint data/" +
        file);
    EXPECT_EQ(first_line(result.out),
              "load_N,load_parameter,x,p_nominal_Pa,theta0_tanh_deg,"
              "p_peak_tanh_by_cosine_Pa");
    const auto law = make_half_angle_law(
        "tanh", joint.geometry.kind(), joint.pair(), joint.half_angle_options);
    const CosinePressure pressure(joint.geometry.kind());
    const auto rows = numbers(result.out);
    ASSERT_EQ(rows.size(), 8U);
    for (const auto& row : rows) {
      const double load = joint.geometry.load_from_force(row[0]);
      EXPECT_EQ(row[1], joint.load_scale().load_parameter(load));
      const double half_angle = law->half_angle(row[1]).half_angle;
      EXPECT_EQ(row[4], half_angle / degree);
      const double peak = row[0] == 0 ? 0
                                      : pressure.peak(half_angle) *
                                            joint.geometry.pressure_unit(load);
      // The order of multiplications is the program's own.
      EXPECT_NEAR(row[5], peak, 2e-15 * peak);
    }
  }
}

// Exact alone has them, back and forth.
TEST(HingeAngle, ApproachAndStiffness) {
  const ProgramFolder folder;
  const std::string hip = "hinge-angle --joint data/joints/hip_cocr_uhmwpe";
  const CsvTable there = folder.table(hip + ".toml --load 0,2000");
  EXPECT_EQ(there.text("approach_m"), "");
  const CsvTable back = folder.table(hip + ".toml --inverse --theta0 " +
                                     there.text(2, "theta0_exact_deg"));
  EXPECT_NEAR(back.at("approach_m") / there.at(2, "approach_m"), 1, 1e-9);
  EXPECT_EQ(first_line(folder
                           .run(hip + "_infinite.toml --load 2000 --law "
                                      "fitted,exact,hertz")
                           .out),
            "load_N,load_parameter,x,p_nominal_Pa,theta0_fitted_deg,"
            "p_peak_fitted_by_exact_Pa,theta0_exact_deg,"
            "p_peak_exact_by_exact_Pa,approach_m,stiffness_N_per_m,"
            "theta0_hertz_deg,p_peak_hertz_by_hertz_Pa");
}

TEST(HingeAngle, PaperExample1) {
  // Section 5.1 of the paper as recomputed: mu 0.5460, theta0 42.593 deg.
  const ProgramResult result = ProgramFolder().run(
      "hinge-angle --joint data/joints/paper_example_1.toml --load 2e5");
  EXPECT_EQ(result.err, "");
  const auto rows = numbers(result.out);
  EXPECT_NEAR(rows.at(0).at(1), 0.5460, 5e-5);
  EXPECT_NEAR(rows.at(0).at(4), 42.593, 5e-4);
}

TEST(HingeAngle, WaysToGiveAJointAgree) {
  const ProgramFolder folder;
  folder.write("joint.toml",
               "name = \"test\"\nkind = \"ball\"\ninner_body = \"body\"\n"
               "[geometry]\nradius_mm = 50\nradial_clearance_um = 25\n"
               "[materials]\npair = \"data/materials/steel_steel.toml\"\n");
  const std::string rest = " --load 1e3:1e6:log4 --law arctan";
  const std::string pair =
      "hinge-angle --joint ball --pair data/materials/steel_steel.toml ";
  const std::string expected =
      folder.run("hinge-angle --joint joint.toml" + rest).out;
  ASSERT_EQ(csv_rows(expected).size(), 5U);
  for (const char* lengths :
       {"--radius 50mm --clearance 25um", "--radius 0.05 --clearance 25e-6",
        "--radius 0.05m --clearance 0.025mm",
        "--diameter 100mm --clearance 25um",
        "--radius 50mm --diametral-clearance 50um",
        "--diameter 0.1 --diametral-clearance 0.05mm"}) {
    EXPECT_EQ(folder.run(pair + lengths + rest).out, expected) << lengths;
  }
  // The same materials without the geometry: the same angles over x.
  const CsvTable table(expected);
  const CsvTable over_x = folder.table(
      pair + "--law arctan --x " + table.text("x") + ',' + table.text(4, "x"));
  // cbrt and cube: a few roundings.
  const std::string theta0 = "theta0_arctan_deg";
  EXPECT_NEAR(over_x.at(theta0), table.at(theta0), 1e-13);
  EXPECT_NEAR(over_x.at(2, theta0), table.at(4, theta0), 1e-13);
}

// A fit, by options and from a file, gives the joint with its clearance, and a
// note.
TEST(HingeAngle, Fits) {
  const ProgramFolder folder;
  const std::string materials = "data/materials/steel_bronze.toml";
  const std::string load = " --load 1e5 --law fitted,exact";
  const std::string pin =
      "hinge-angle --joint pin --length 50mm --pair " + materials + load;
  const struct {
    std::string option, key, radial_um, said;
  } clearances[] = {
      {"", "", "14.75", "mean 29.5"},
      {" --fit-clearance minimum", "clearance = \"minimum\"\n", "4.5",
       "minimum 9"},
      {" --fit-clearance maximum", "clearance = \"maximum\"\n", "25",
       "maximum 50"},
  };
  for (const auto& [option, key, radial_um, said] : clearances) {
    const auto expected = folder.run(pin + " --diameter 49.983mm --clearance " +
                                     radial_um + "um");
    ASSERT_EQ(csv_rows(expected.out).size(), 2U);
    EXPECT_EQ(expected.err, "");
    folder.write("fit.toml",
                 "name = \"fit\"\nkind = \"pin\"\n[geometry]\n"
                 "diameter_mm = 50\nhole = \"H7\"\nshaft = \"g6\"\n"
                 "length_mm = 50\n" +
                     key + "[materials]\npair = \"" + materials + "\"\n");
    for (const std::string& command :
         {pin + " --diameter 50mm --hole H7 --shaft g6" + option,
          "hinge-angle --joint fit.toml" + load}) {
      const auto result = folder.run(command);
      EXPECT_EQ(result.out, expected.out) << command;
      EXPECT_EQ(result.err,
                "hinge-angle: note: fit H7/g6 at 50 mm: diametral clearance 9 "
                "to 50 um; " +
                    said + " um taken\n");
    }
  }
}

TEST(HingeAngle, LoadIsPrintedAsGiven) {
  const CsvTable table = ProgramFolder().table(
      "hinge-angle --joint data/joints/pin_joint.toml --load 0.1:2000:0.1");
  const std::vector<double>& loads = table["load_N"];
  ASSERT_EQ(loads.size(), 20000U);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    ASSERT_EQ(loads[i], static_cast<double>(i + 1) / 10);
  }
}

TEST(HingeAngle, LimitAngle) {
  const ProgramFolder folder;
  // Largest rounding of degrees to radians and back: 2 ulp. Rigid seat, rigid
  // pin: the formula's ends, printed to two decimals.
  for (const auto& [options, limit, tolerance] :
       {std::tuple{"1", 84.85, 3e-14},
        {"1 --limit-angle formula", 84.85, 3e-14},
        {"2 --limit-angle linear", 82.85, 3e-14},
        {"2 --limit-angle 91.5", 91.5, 3e-14},
        {"0", 92.53, 5e-3},
        {"inf", 80.33, 5e-3}}) {
    const CsvTable table =
        folder.table(std::string("hinge-angle --joint pin --x inf --law tanh "
                                 "--modulus-ratio ") +
                     options);
    EXPECT_NEAR(table.at("theta0_tanh_deg"), limit, tolerance) << options;
  }
}

TEST(HingeAngle, LoadedThroughTheBack) {
  const ProgramFolder folder;
  const auto loading = InnerLoading::back(20 * degree);
  const auto run = [&](JointKind kind, const std::string& options) {
    return folder
        .run_well("hinge-angle --modulus-ratio 0 --load-parameter 3 --joint " +
                  to_string(kind) + options)
        .out;
  };
  const auto pair = ElasticPair::from_modulus_ratio(0, 0.3, 0.3);
  for (const JointKind kind : kinds) {
    const CsvTable table(
        run(kind, " --law exact --loading back:20 --pressure exact"));
    const double half_angle =
        ExactLaw(kind, pair, loading).half_angle(3).half_angle;
    EXPECT_EQ(table.at("theta0_exact_back:20_deg"), half_angle / degree);
    EXPECT_EQ(table.at("p_peak_exact_back:20_by_exact_back:20_over_nominal"),
              ExactPressure(kind, pair, loading).peak(half_angle) *
                  (kind == JointKind::ball ? std::numbers::pi : 2));
  }
  // docs/explanation/conforming.md: 66.55 deg under a force at the
  // centre, 73.13 here.
  const auto ball = [&](const std::string& options) {
    return run(JointKind::ball, options);
  };
  const std::string centre = ball(" --law exact --loading centre");
  const std::string back = ball(" --law exact --loading back:20");
  EXPECT_EQ(centre, ball(" --law exact"));
  EXPECT_NEAR(CsvTable(centre).at("theta0_exact_deg"), 66.55, 5e-3);
  EXPECT_NEAR(CsvTable(back).at("theta0_exact_back:20_deg"), 73.13, 5e-3);
  // All laws are those that know the loading.
  EXPECT_EQ(ball(" --law all --loading back:20"), back);

  // A joint file has it too; the option comes before the file.
  const std::string file =
      "name = \"ball\"\nkind = \"ball\"\n"
      "[geometry]\nradius_mm = 50\nradial_clearance_um = 50\n"
      "[materials.inner]\nyoungs_modulus_GPa = 200\npoissons_ratio = 0.3\n"
      "[materials.outer]\nyoungs_modulus = inf\n"
      "[half_angle]\nlaw = \"exact\"\n";
  folder.write("centre.toml", file);
  folder.write("back.toml", file +
                                "[loading]\nkind = \"back\"\n"
                                "patch_half_angle_deg = 20\n");
  const auto of_file = [&](const std::string& options) {
    return folder.run("hinge-angle --load 1e6 --joint " + options).out;
  };
  EXPECT_TRUE(has_text(of_file("back.toml"), "theta0_exact_back:20_deg"));
  EXPECT_EQ(of_file("back.toml"), of_file("centre.toml --loading back:20"));
  EXPECT_EQ(of_file("centre.toml"), of_file("back.toml --loading centre"));
}

TEST(HingeAngle, HertzBeyondItsRange) {
  const ProgramFolder folder;
  const std::string command =
      "hinge-angle --joint ball --modulus-ratio 1 --x 0.5,1,1.0000001,2,3 "
      "--law hertz ";
  for (const char* jobs : {"", "--jobs 3"}) {
    const ProgramResult result = folder.run(command + jobs);
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err,
              "hinge-angle: warning: law hertz: no value for 3 of 5 rows, "
              "which are outside its range\n"
              "hinge-angle: warning: law hertz: half-angle 90 deg is beyond "
              "88.01 deg, the limit half-angle of this joint\n");
    const CsvTable table(result.out);
    EXPECT_EQ(table.text(2, "theta0_hertz_deg"), "90");
    EXPECT_EQ(table.text(3, "theta0_hertz_deg"), "");
    EXPECT_EQ(table.text(5, "theta0_hertz_deg"), "");
  }
  // A missing value beside a law with a value is no failure.
  folder.run_well(command + "--law tanh");
  const auto json =
      nlohmann::json::parse(folder.run(command + "--format json").out);
  EXPECT_EQ(json.at(1).at("theta0_hertz_deg"), 90);
  EXPECT_TRUE(json.at(2).at("theta0_hertz_deg").is_null());
  EXPECT_TRUE(json.at(2).at("p_peak_hertz_by_hertz_over_nominal").is_null());
}

TEST(HingeAngle, InverseGoesBack) {
  const ProgramFolder folder;
  for (const std::string joint :
       {"pin_joint", "spherical_plain_bearing_infinite"}) {
    const std::string start =
        "hinge-angle --joint data/joints/" + joint + ".toml ";
    for (const std::string law : {"hertz", "arctan", "tanh", "blend:0.4"}) {
      const CsvTable there =
          folder.table(start + "--x 0.1:0.9:0.1 --law " + law);
      std::string list;
      for (const auto& angle : there.texts("theta0_" + law + "_deg")) {
        list += (list.empty() ? "" : ",") + angle;
      }
      const CsvTable back =
          folder.table(start + "--inverse --theta0 " + list + " --law " + law);
      ASSERT_EQ(back.size(), 9U);
      for (const auto& [name, of_law] :
           {std::pair<std::string, std::string>{"load_N", "load_" + law + "_N"},
            {"load_parameter", "load_parameter_" + law},
            {"x", "x_" + law},
            {"p_nominal_Pa", "p_nominal_" + law + "_Pa"}}) {
        for (std::size_t row = 1; row <= 9; ++row) {
          // Errors of 1e-14 of a law and its inverse, times the slope of the
          // inverse: at most 10 for these x.
          const double value = there.at(row, name);
          EXPECT_NEAR(back.at(row, of_law), value, 1e-13 * value)
              << law << ' ' << name;
        }
      }
      const std::string by =
          "p_peak_" + law + (law == "hertz" ? "_by_hertz_Pa" : "_by_exact_Pa");
      EXPECT_NEAR(there.at(9, by), back.at(9, by), 1e-12 * there.at(9, by));
    }
  }
}

TEST(HingeAngle, InverseBeyondTheLimitHasNoValue) {
  const ProgramResult result = ProgramFolder().run(
      "hinge-angle --joint pin --modulus-ratio 1 --inverse --theta0 "
      "84,86 --law tanh");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(first_line(result.out),
            "theta0_deg,load_parameter_tanh,x_tanh,p_peak_tanh_by_exact_over_"
            "nominal");
  EXPECT_EQ(csv_rows(result.out)[2], (Texts{"86", "", "", ""}));
  EXPECT_TRUE(has_text(result.err, "law tanh: no value for 1 of 2 rows"));
}

TEST(HingeAngle, WarnsOncePerReason) {
  const ProgramResult result = ProgramFolder().run_well(
      "hinge-angle --joint ball --modulus-ratio 1 --poisson2 0.4 --x 0:1:0.1 "
      "--law arctan,tanh");
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 2);
  EXPECT_TRUE(has_text(result.err,
                       "warning: law arctan, tanh: the limit half-angle "
                       "is a formula for Poisson's ratio 0.3"));
}

TEST(HingeAngle, AllLaws) {
  const ProgramResult result = ProgramFolder().run_well(
      "hinge-angle --joint pin --modulus-ratio 1 --x 0.5 --law all");
  for (const std::string& name : half_angle_law_names()) {
    EXPECT_EQ(result.out.find("theta0_" + name + "_deg") != std::string::npos,
              name != "paper");
  }
}

TEST(HingeAngle, FittedUnlessNamed) {
  const ProgramFolder folder;
  const std::string command = "hinge-angle --modulus-ratio 3 --x 1 --joint ";
  for (const std::string joint : {"ball", "pin"}) {
    EXPECT_EQ(folder.run(command + joint).out.find("theta0_fitted_deg"),
              std::string("load_parameter,x,").size());
  }
  EXPECT_EQ(folder
                .run("hinge-angle --load 1e3 --joint "
                     "data/joints/pin_joint.toml")
                .err,
            "");
}

// Every number of the comparison, recomputed at the load that it names, and
// nothing worse anywhere else.
TEST(HingeAngle, CompareFindsTheLargestErrors) {
  for (const JointKind kind : kinds) {
    const ProgramResult result = ProgramFolder().run_well(
        "hinge-angle --compare --modulus-ratio 0.4 --poisson1 0.25 --poisson2 "
        "0.35 --load-parameter 0.01:20:log2 --joint " +
        to_string(kind));
    EXPECT_EQ(first_line(result.out),
              "law,error_percent,load_parameter,theta0_exact_deg,"
              "theta0_law_deg,cost_tanh,recommended");
    const auto rows = csv_rows(result.out);
    ASSERT_EQ(rows.size(), 7U);
    const auto pair = ElasticPair::from_modulus_ratio(0.4, 0.25, 0.35);
    const auto exact = make_half_angle_law("exact", kind, pair);
    int recommended = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const auto& row = rows[i];
      const auto law = make_half_angle_law(row[0], kind, pair);
      const auto error = [&](double load) {
        return 100 * std::abs(law->half_angle(load).half_angle /
                                  exact->half_angle(load).half_angle -
                              1);
      };
      const double load = std::stod(row[2]);
      const double largest = std::stod(row[1]);
      EXPECT_GE(load, 0.01 * (1 - 1e-15));
      EXPECT_LE(load, 20 * (1 + 1e-15));
      EXPECT_NEAR(exact->half_angle(load).half_angle / degree,
                  std::stod(row[3]), 1e-13);
      if (row[0] == "hertz") {
        EXPECT_EQ(row[1], "inf");
        EXPECT_EQ(row[4], "");
        EXPECT_GT(load, kind == JointKind::ball ? 1 : 0.25);
      } else {
        EXPECT_NEAR(error(load), largest, 1e-12 + 1e-9 * largest);
        // 400 steps in a range of 3.3 decades: the maximum of a curve as wide
        // as a decade is missed by 1e-3 of it at most.
        for (double other = 0.01; other < 20; other *= 1.003) {
          EXPECT_LE(error(other), 1.001 * largest + 1e-10) << row[0];
        }
      }
      if (row[6] == "yes") {
        ++recommended;
        EXPECT_EQ(row[0], "fitted");
      }
    }
    EXPECT_EQ(recommended, 1);
  }
}

// Cells of the rows below this header in a page of libcontact/docs.
std::vector<std::vector<std::string>> page_rows(const std::string& page_name,
                                                const std::string& header) {
  std::ifstream page(std::string(CONTACT_DATA_DIR) + "/../libcontact/docs/" +
                     page_name);
  std::string line;
  while (std::getline(page, line) && !line.starts_with(header)) {
  }
  std::getline(page, line);  // the rule
  std::vector<std::vector<std::string>> rows;
  while (std::getline(page, line) && line.starts_with("| ")) {
    auto& cells = rows.emplace_back();
    std::istringstream text(line.substr(1));
    for (std::string cell; std::getline(text, cell, '|');) {
      cells.push_back(cell.substr(1, cell.size() - 2));
    }
  }
  return rows;
}

TEST(HingeAngle, CostsAreThoseOfThePage) {
  const auto rows = page_rows("reference/speed.md", "| | hertz | arctan");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    const CsvTable table = ProgramFolder().table(
        "hinge-angle --compare --modulus-ratio 1 --law "
        "hertz,arctan,tanh,blend:0.5,fitted,exact --joint " +
        std::string(row[0] == "pin" ? "pin" : "ball"));
    ASSERT_EQ(row.size(), 1 + table.size());
    for (std::size_t law = 1; law <= table.size(); ++law) {
      EXPECT_NEAR(table.at(law, "cost_tanh"), std::stod(row[law]), 0.5)
          << row[0] << ", law " << law;
    }
  }
}

// The first table of "How good are the formulas" in
// docs/explanation/half_angle.md.
TEST(HingeAngle, DocumentedErrorsAreMeasured) {
  const ProgramFolder folder;
  int rows = 0;
  for (const auto& cells :
       page_rows("explanation/half_angle.md", "| Ebar | pin:")) {
    ASSERT_EQ(cells.size(), 9U);
    for (int joint = 0; joint < 2; ++joint) {
      const CsvTable table = folder.table(
          std::string("hinge-angle --compare --law "
                      "arctan,tanh,blend:0.5,fitted --joint ") +
          (joint == 0 ? "pin" : "ball") + " --modulus-ratio " + cells[0]);
      ASSERT_EQ(table.size(), 4U);
      for (std::size_t law = 1; law <= 4; ++law) {
        const double printed = std::stod(cells[4 * joint + law]);
        // Half of the last of two digits; one decimal from 1 on.
        EXPECT_NEAR(table.at(law, "error_percent"), printed,
                    std::max(1e-6, printed < 1 ? 0.051 * printed : 0.051))
            << cells[0];
      }
    }
    ++rows;
  }
  EXPECT_EQ(rows, 9);
}

TEST(HingeAngle, CompareRecommendsTheCheapestWithinTheTolerance) {
  const ProgramFolder folder;
  // arctan is a little cheaper than the blend.
  for (const auto& [options, law] :
       {std::pair{"pin", "fitted"},
        {"ball --poisson1 0.4", "fitted"},
        {"ball --tolerance 0.001", "exact"},
        {"ball --tolerance 0.001 --law tanh,fitted", ""},
        {"pin --tolerance 10 --law arctan,blend", "arctan"},
        {"pin --tolerance 2 --law arctan,blend", "blend"}}) {
    const CsvTable table = folder.table(
        std::string("hinge-angle --compare --modulus-ratio 1 --joint ") +
        options);
    const auto yes = table.texts("recommended");
    const auto found = std::find(yes.begin(), yes.end(), "yes") - yes.begin();
    EXPECT_EQ(static_cast<std::size_t>(found) == yes.size()
                  ? ""
                  : table.texts("law")[found],
              law)
        << options;
  }
  // A joint with its geometry has the load as well.
  const CsvTable table = folder.table(
      "hinge-angle --compare --load 1e5 --joint data/joints/pin_joint.toml");
  EXPECT_EQ(table.names()[2], "load_N");
  EXPECT_NEAR(table.at("load_N"), 1e5, 1e-9);
}

TEST(HingeAngle, JobsDoNotChangeTheOutput) {
  const ProgramFolder folder;
  const std::string command =
      "hinge-angle --joint ball --modulus-ratio 1 --x 0:2:0.0005 --law all "
      "--format json ";
  const ProgramResult one = folder.run(command);
  EXPECT_EQ(nlohmann::json::parse(one.out).size(), 4001U);
  EXPECT_EQ(one.out, folder.run(command + "--jobs 4").out);
}

TEST(HingeAngle, Plots) {
  const ProgramFolder folder;
  if (!folder.has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  folder.run_well(
      "hinge-angle --joint data/joints/hip_cocr_uhmwpe_infinite.toml --load "
      "10:5000:log50 --law hertz,arctan,tanh --plot hip.svg --output hip.csv");
  EXPECT_EQ(folder.files(), (Texts{"hip.csv", "hip.svg"}));
  const std::string picture = folder.read("hip.svg");
  for (const char* text : {"hertz", "arctan", "tanh", "normal force Rₙ, N",
                           "half-angle of the contact θ₀, deg", "</svg>"}) {
    EXPECT_TRUE(has_text(picture, text)) << text;
  }
  folder.run_well(
      "hinge-angle --joint pin --modulus-ratio 1 "
      "--inverse --theta0 1:80:1 --law tanh --plot back.png");
  EXPECT_EQ(folder.read("back.png").rfind("\x89PNG", 0), 0U);
  // With exact among several laws: the errors below.
  const ProgramResult errors = folder.run_well(
      "hinge-angle --joint ball --modulus-ratio 1 --x 0.1:10:log50 --law all "
      "--plot errors.svg --output errors.csv");
  const std::string both = folder.read("errors.svg");
  for (const char* text : {"exact", "fitted", "error, %", "</svg>"}) {
    EXPECT_TRUE(has_text(both, text)) << text;
  }
  EXPECT_FALSE(has_text(picture, "error, %"));
}

// The columns of preload equal hinge-joint's, without load too.
TEST(HingeAngle, WithoutClearanceHasThatOfPreload) {
  const ProgramFolder folder;
  const std::string pressed = " --joint data/joints/lined_bush_pressed.toml ";
  const CsvTable table =
      folder.table("hinge-angle" + pressed + "--load 0,1kN,6kN");
  EXPECT_EQ(table.texts("contact_state"),
            (Texts{"closed", "closed", "lifted"}));
  EXPECT_EQ(table.text("theta0_exact_deg"), "180");
  EXPECT_EQ(table.text("p_peak_exact_by_exact_Pa"), table.text("p_0_Pa"));
  const CsvTable of_joint =
      folder.table("hinge-joint" + pressed + "--normal-force 0,1kN,6kN");
  for (const std::string name : {"contact_state", "p_0_Pa", "R_lift_off_N",
                                 "M_0_N_m", "sum_p_N", "shift_m"}) {
    EXPECT_EQ(table.texts(name), of_joint.texts(name)) << name;
  }
  // One with a clearance beside it has the columns too.
  const CsvTable both =
      folder.table("hinge-angle" + pressed +
                   "--joint data/joints/pin_joint.toml --law exact --load 1kN");
  EXPECT_EQ(both.texts("contact_state"), (Texts{"closed", "clearance"}));
  EXPECT_EQ(both.text(2, "R_lift_off_N"), "");
}

// theta0 is the limit at every load, and there is nothing to break away.
TEST(HingeAngle, OfClearanceZeroIsTheLimit) {
  const ProgramFolder folder;
  const std::string pin =
      "hinge-angle --joint pin --pair data/materials/steel_bronze.toml "
      "--radius 25mm --clearance 0 --law exact ";
  const CsvTable table = folder.table(pin + "--load 0,5e5,1e6");
  const auto half_angles = table.texts("theta0_exact_deg");
  EXPECT_EQ(half_angles[0], half_angles[2]);
  EXPECT_EQ(half_angles[1], half_angles[2]);
  EXPECT_EQ(table.text("contact_state"), "zero");
  for (const std::string name :
       {"p_0_Pa", "R_lift_off_N_per_m", "M_0_N_m_per_m"}) {
    EXPECT_EQ(table.text(2, name), "") << name;
  }
  EXPECT_NEAR(table.at(3, "sum_p_N_per_m") / table.at(2, "sum_p_N_per_m"), 2,
              1e-12);
  const ProgramResult inverse = folder.run(pin + "--inverse --theta0 30");
  EXPECT_EQ(inverse.status, 1);
  EXPECT_EQ(CsvTable(inverse.out).text("load_exact_N_per_m"), "");
  EXPECT_EQ(folder.run(pin + "--x 1").err,
            "hinge-angle: --x requires a clearance above 0; for a joint "
            "without one use --load\n");
}

// The numbers equal FinitePin's under a normal force; a level load gives the
// infinite pin.
TEST(HingeAngle, OfAPinThatEnds) {
  const ProgramFolder folder;
  const std::string file = "data/joints/relieved_bush.toml";
  const std::string run = "hinge-angle --joint " + file + " --load 1e4,1e5 ";
  const FinitePin pin(read_joint(folder.path() / file));
  const CsvTable tilted = folder.table(run + "--tilt 0.05 --twist 0.01");
  ASSERT_EQ(tilted.size(), 2u);
  const FinitePinState at =
      pin.under({1e4, 0}, degree * Eigen::Vector2d(0.05, 0.01));
  EXPECT_EQ(tilted.at(1, "z_low_m"), at.low);
  EXPECT_EQ(tilted.at(1, "z_high_m"), at.high);
  EXPECT_EQ(tilted.at(1, "z_theta0_max_m"), at.half_angle_place);
  // A degree and back.
  EXPECT_NEAR(tilted.at(1, "theta0_max_deg") * degree, at.largest_half_angle,
              1e-15);
  EXPECT_NEAR(tilted.at(1, "theta0_high_deg") * degree, at.end_half_angle[1],
              1e-15);
  const CsvTable placed = folder.table(run + "--load-at -1mm,0");
  ASSERT_EQ(placed.size(), 4u);
  EXPECT_LT(placed.at(1, "tilt_x_deg"), 0);
  const std::string straight = file + " --set relief.depth_um=1e-9 ";
  const CsvTable level =
      folder.table("hinge-angle --joint " + straight + "--load 1e5 --tilt 0");
  const std::string endless = folder
                                  .run_well("hinge-angle --joint " + straight +
                                            "--load 1e5 --law exact")
                                  .out;
  // The force law and the table of the law exact; a relief of 1e-15 m.
  EXPECT_NEAR(
      level.at("theta0_low_deg") / CsvTable(endless).at("theta0_exact_deg"), 1,
      1e-8);
}

}  // namespace
}  // namespace contact::test::hinge_angle_test
