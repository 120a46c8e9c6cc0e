// The program hinge-pressure, run as its users run it.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "libcontact/pressure/exact.hpp"
#include "libcontact/seat/contact.hpp"
#include "support/program.hpp"

namespace contact::test::hinge_pressure_test {
namespace {

const std::string hip = "data/joints/hip_cocr_uhmwpe_infinite.toml";
const std::string pin = "data/joints/pin_joint.toml";

// Laws of --pressure all.
std::vector<std::string> all_names() {
  std::vector<std::string> names = pressure_law_names();
  std::erase(names, "worn");
  return names;
}

TEST(HingePressure, ProfileIsTheLibrarys) {
  const ProgramFolder folder;
  const ProgramResult result = folder.run_well(
      "hinge-pressure --law tanh --pressure all --points 6 --load 500,2000 "
      "--joint " +
      hip);
  EXPECT_EQ(first_line(result.out),
            "load_N,load_parameter,theta0_deg,theta_deg,p_cosine_Pa,"
            "p_sqrt_tan_Pa,p_sqrt_theta_Pa,p_mixture_Pa,p_exact_Pa");
  const JointSpec joint = read_joint(folder.path() / hip);
  const auto law = make_half_angle_law("tanh", joint.geometry.kind(),
                                       joint.pair(), joint.half_angle_options);
  const CsvTable table(result.out);
  const std::vector<double>& loads = table["load_N"];
  ASSERT_EQ(loads.size(), 12U);
  for (const std::string& name : all_names()) {
    const auto pressure =
        make_pressure_law(name, joint.geometry.kind(), joint.pair());
    const std::vector<double>& printed = table["p_" + name + "_Pa"];
    for (std::size_t i = 0; i < loads.size(); ++i) {
      const double theta0 =
          law->half_angle(joint.load_scale().load_parameter(loads[i]))
              .half_angle;
      const double unit = joint.geometry.pressure_unit(loads[i]);
      const double peak = unit * pressure->peak(theta0);
      // The column theta_deg is rounded: at the edge by 1e-16 of theta0, and
      // a root of that is 1e-8 of the peak.
      EXPECT_NEAR(
          printed[i],
          unit * pressure->pressure(table["theta_deg"][i] * degree, theta0),
          2e-8 * peak)
          << name << ' ' << i;
    }
    EXPECT_EQ(printed[5], 0) << name;
    EXPECT_GT(printed[6], printed[0]) << name;
  }
}

// The printed profile carries the printed load, by the trapezoidal rule.
TEST(HingePressure, ProfilesCarryTheLoad) {
  const ProgramFolder folder;
  for (const std::string& joint_file : {hip, pin}) {
    const JointSpec joint = read_joint(folder.path() / joint_file);
    const bool ball = joint.geometry.kind() == JointKind::ball;
    const double rho = joint.geometry.radius();
    const double load = ball ? 1500 : 1e5;
    const CsvTable table =
        folder.table("hinge-pressure --pressure all --points 4001 --load " +
                     std::to_string(load) + " --joint " + joint_file);
    const std::vector<double>& theta = table["theta_deg"];
    for (const std::string& name : all_names()) {
      const std::vector<double>& p = table["p_" + name + "_Pa"];
      double sum = 0;
      const auto integrand = [&](std::size_t i) {
        const double t = theta[i] * degree;
        const double ring = ball
                                ? 2 * std::numbers::pi * rho * rho * std::sin(t)
                                : 2 * rho * joint.geometry.length();
        return p[i] * std::cos(t) * ring;
      };
      for (std::size_t i = 1; i < theta.size(); ++i) {
        sum += (integrand(i) + integrand(i - 1)) / 2 *
               (theta[i] - theta[i - 1]) * degree;
      }
      // The trapezoidal rule at the edge, where the integrand over the load
      // is C sqrt(1 - theta/theta0), C about 3: 0.21 C n^-3/2 = 2.7e-6.
      EXPECT_NEAR(sum / load, 1, 4e-6) << name << ' ' << joint_file;
    }
  }
}

TEST(HingePressure, SummaryHasPeakMeanAreaAndSum) {
  const ProgramResult result = ProgramFolder().run_well(
      "hinge-pressure --summary --pressure all --load 2000 --joint " + hip);
  EXPECT_EQ(first_line(result.out),
            "load_N,load_parameter,theta0_deg,law,pressure,p_peak_Pa,p_mean_Pa,"
            "p_nominal_Pa,contact_area_m2,S,chi_0,sigma_Y_0,sigma_Z_90");
  const CsvTable table(result.out);
  EXPECT_EQ(table.texts("pressure"), all_names());
  const JointSpec joint =
      read_joint(std::filesystem::path(CONTACT_DATA_DIR).parent_path() / hip);
  const double half_angle = table.at("theta0_deg") * degree;
  for (std::size_t row = 1; row <= table.size(); ++row) {
    const double mean = table.at(row, "p_mean_Pa");
    // Rounding of four numbers.
    EXPECT_NEAR(mean * table.at(row, "contact_area_m2") / 2000,
                table.at(row, "S"), 4e-15);
    EXPECT_GT(table.at(row, "p_peak_Pa"), mean);
    const auto law =
        make_pressure_law(all_names()[row - 1], JointKind::ball, joint.pair());
    const auto coefficient = [&](SlipAxis axis) {
      return friction_integrals(*law, half_angle, axis).coefficient;
    };
    // theta0 comes back from degrees.
    EXPECT_NEAR(coefficient({1, 0}).spinning, table.at(row, "sigma_Z_90"),
                1e-14);
    EXPECT_NEAR(coefficient({0, 1}).force, table.at(row, "chi_0"), 1e-14);
  }
  // The cosine's peak is 11 to 33 % above the exact one.
  const double ratio = table.at(1, "p_peak_Pa") / table.at(5, "p_peak_Pa");
  EXPECT_GT(ratio, 1.1);
  EXPECT_LT(ratio, 1.34);
}

// By option and joint file; a ball up to 90 deg.
TEST(HingePressure, Worn) {
  const ProgramFolder folder;
  const auto run = [&](const std::string& options) {
    return folder.run("hinge-pressure --summary --load 1e5 " + options);
  };
  const ProgramResult by_option = run("--pressure worn --joint " + pin);
  EXPECT_EQ(by_option.status, 0) << by_option.err;
  const CsvTable table(by_option.out);
  const double theta0 = table.at("theta0_deg") * degree;
  const double s = std::sin(theta0);
  EXPECT_NEAR(table.at("S"), 2 * s / (theta0 + s * std::cos(theta0)), 1e-14);
  folder.run("sed s=../materials=data/materials= " + pin +
             " >worn.toml; printf '\\n[pressure]\\nlaw = \"worn\"\\n' "
             ">> worn.toml");
  const ProgramResult by_file = run("--joint worn.toml");
  EXPECT_EQ(by_file.out, by_option.out) << by_file.err;
  const ProgramResult wide = folder.run(
      "hinge-pressure --joint ball --modulus-ratio 1 --load-parameter 100 "
      "--law tanh --limit-angle 120 --summary --pressure worn");
  EXPECT_EQ(wide.status, 1);
  EXPECT_EQ(CsvTable(wide.out).texts("S"), Texts{""});
  EXPECT_TRUE(has_text(wide.err,
                       "pressure worn: none for 1 of 1 loads, whose "
                       "half-angle is above 90 deg"));
}

TEST(HingePressure, DimensionlessPinAndJson) {
  const ProgramResult result = ProgramFolder().run_well(
      "hinge-pressure --joint pin --modulus-ratio 1 --load-parameter 0.5 "
      "--law exact --pressure exact,cosine --points 3 --format json");
  const auto rows = nlohmann::json::parse(result.out);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_FALSE(rows[0].contains("load_N_per_m"));
  EXPECT_EQ(rows[0]["load_parameter"], 0.5);
  // Persson's closed form at the centre: p rho/P = 2 b/(pi s1)
  // + ln((s1 + b)/(s1 - b))/(2 pi b^2 (1 + b^2)), s1 = sqrt(1 + b^2).
  const double theta0 = rows[0]["theta0_deg"].get<double>() * degree;
  const double b = std::tan(theta0 / 2);
  const double s1 = std::sqrt(1 + b * b);
  const double expected = 2 * b / (std::numbers::pi * s1) +
                          std::log((s1 + b) / (s1 - b)) /
                              (2 * std::numbers::pi * b * b * (1 + b * b));
  EXPECT_NEAR(rows[0]["p_exact_over_nominal"], 2 * expected, 2e-9);
}

TEST(HingePressure, LoadedThroughTheBack) {
  const ProgramFolder folder;
  const std::string command =
      "hinge-pressure --joint pin --modulus-ratio 1 --load-parameter 0.5 "
      "--law exact --loading back:30 --pressure all ";
  const ProgramResult profile = folder.run_well(command + "--points 3");
  EXPECT_EQ(first_line(profile.out),
            "load_parameter,theta0_deg,loading,theta_deg,p_cosine_over_nominal,"
            "p_sqrt_tan_over_nominal,p_sqrt_theta_over_nominal,"
            "p_exact_back:30_over_nominal");
  const CsvTable table(profile.out);
  EXPECT_EQ(table.text("loading"), "back:30");
  const auto loading = InnerLoading::back(30 * degree);
  const auto pair = ElasticPair::from_modulus_ratio(1, 0.3, 0.3);
  const JointKind kind = JointKind::pin;
  const double half_angle =
      ExactLaw(kind, pair, loading).half_angle(0.5).half_angle;
  EXPECT_EQ(table.at("theta0_deg"), half_angle / degree);
  EXPECT_EQ(table.at("p_exact_back:30_over_nominal"),
            2 * ExactPressure(kind, pair, loading).peak(half_angle));
  const CsvTable summary = folder.table(command + "--summary");
  EXPECT_EQ(summary.text(4, "law"), "exact_back:30");
  EXPECT_EQ(summary.text(4, "pressure"), "exact_back:30");
  EXPECT_EQ(summary.text("pressure"), "cosine");
}

// A hip in 8 mm of polyethylene at 2 kN: numbers of an independent solution, to
// four digits. All pressure laws are those that know walls.
TEST(HingePressure, FiniteWalls) {
  const ProgramFolder folder;
  const CsvTable table = folder.table(
      "hinge-pressure --joint data/joints/hip_cocr_uhmwpe.toml --load "
      "2000 --summary");
  ASSERT_EQ(table.size(), 1U);
  EXPECT_EQ(table.text("law"), "exact");
  EXPECT_EQ(table.text("pressure"), "exact");
  for (const auto& [column, value, half_unit] :
       {std::tuple{"theta0_deg", 43.47, 5e-3},
        {"p_peak_Pa", 11.33e6, 5e3},
        {"S", 1.115, 5e-4},
        {"chi_0", 1.0540, 5e-5},
        {"sigma_Y_0", 1.0588, 5e-5},
        {"sigma_Z_90", 0.4539, 5e-5}}) {
    EXPECT_NEAR(table.at(column), value, half_unit) << column;
  }
}

// Laws with other half-angles, and joints without a size, have none.
TEST(HingePressure, NoApproach) {
  const ProgramFolder folder;
  for (const std::string& options :
       {"--joint " + hip + " --load 2000 --law fitted",
        std::string("--joint ball --modulus-ratio 1 --x 1 --law exact")}) {
    EXPECT_FALSE(has_text(
        folder.run_well("hinge-pressure --summary --pressure exact " + options)
            .out,
        "approach"));
  }
}

TEST(HingePressure, LongSweepsTakeNoMemory) {
  // 1e8 loads at 32 bytes would be 3 GB; the table itself goes to a reader
  // that has enough after some lines.
  const ProgramResult result = ProgramFolder().run(
      "hinge-pressure --joint pin --modulus-ratio 1 --x 1:1e8:1 "
      "--pressure cosine --summary | head -3");
  EXPECT_EQ(csv_rows(result.out).size(), 3U) << result.err;
  // Resident memory: a sanitizer reserves addresses for more than there is.
  rusage programs{};
  ASSERT_EQ(getrusage(RUSAGE_CHILDREN, &programs), 0);
  EXPECT_LT(programs.ru_maxrss, 500'000);  // kB
}

TEST(HingePressure, UnloadedJointsHaveNoPressure) {
  const CsvTable table =
      ProgramFolder().table("hinge-pressure --summary --load 0 --joint " + pin);
  for (const double p : table["p_peak_Pa"]) EXPECT_EQ(p, 0);
}

TEST(HingePressure, LoadsWithoutHalfAngleAreEmptyAndSaidSo) {
  const ProgramResult result = ProgramFolder().run(
      "hinge-pressure --joint ball --modulus-ratio 1 --x 0.5,2 --law hertz "
      "--summary --pressure cosine");
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(
      has_text(result.err, "law hertz: no half-angle for 1 of 2 loads"));
  EXPECT_TRUE(std::isnan(CsvTable(result.out).at(2, "p_peak_over_nominal")));
}

TEST(HingePressure, HalfAnglesThatHaveNotConvergedAreSaidSo) {
  // An incompressible ball in a rigid seat closes up, beyond the solver.
  const ProgramResult result = ProgramFolder().run(
      "hinge-pressure --joint ball --modulus-ratio 0 --poisson1 0.5 "
      "--x 1e6 --law exact --summary --pressure cosine");
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(has_text(result.err, "1 of 1 half-angles have not converged"));
}

// The numbers equal SeatContact's; without confinement there is a note.
TEST(HingePressure, ConfinesToASeatThatEnds) {
  const ProgramFolder folder;
  const std::string file = "data/joints/spherical_plain_bearing_ge50.toml";
  const std::string run = "hinge-pressure --joint " + file + " --load ";
  const CsvTable table = folder.table(run + "1kN,100kN --direction 90,70");
  ASSERT_EQ(table.size(), 4u);
  const JointSpec joint = read_joint(folder.path() / file);
  const SeatContact seat(joint, *joint.geometry.seat());
  for (std::size_t row = 1; row <= table.size(); ++row) {
    const double at = table.at(row, "direction_deg") * degree;
    const SeatState s =
        seat.under(table.at(row, "load_N") *
                   Eigen::Vector3d(std::sin(at), 0, std::cos(at)));
    EXPECT_EQ(table.at(row, "p_peak_Pa"), s.peak_pressure);
    EXPECT_EQ(table.at(row, "S"), s.force_ratio);
    EXPECT_EQ(table.at(row, "free"), s.is_free ? 1 : 0);
  }
  const CsvTable rounded =
      folder.table(run + "100kN --direction 70 --set seat.edge_radius_mm=0.5");
  const double intensity = table.at(4, "K_low");
  ASSERT_GT(intensity, 0);
  EXPECT_EQ(rounded.at(1, "K_low"), intensity);
  EXPECT_EQ(rounded.at(1, "p_rim_low_Pa"),
            seat.rounded_rim(intensity, 0.5e-3).peak_pressure);
  // Without end the same load presses less (docs/explanation/seats.md).
  const auto open = folder.run_well(run + "100kN --summary");
  EXPECT_TRUE(has_text(open.err, "where a contact in the middle of the seat"));
  EXPECT_TRUE(has_text(
      folder
          .run("hinge-pressure --joint data/joints/wheel_ball.toml --load 1 "
               "--direction 3")
          .err,
      "--direction requires a joint with a [seat]"));
}

// The numbers equal FinitePin's under a normal force.
TEST(HingePressure, MapsAPinThatEnds) {
  const ProgramFolder folder;
  const std::string file = "data/joints/relieved_bush.toml";
  const std::string run = "hinge-pressure --joint " + file + " --load ";
  const FinitePin bush(read_joint(folder.path() / file));
  const CsvTable rows = folder.table(run + "1e4,1e5 --tilt 0.05 --twist -0.02");
  ASSERT_EQ(rows.size(), 2u);
  const Eigen::Vector2d tilt = degree * Eigen::Vector2d(0.05, -0.02);
  const FinitePinState at = bush.under({1e5, 0}, tilt);
  EXPECT_EQ(rows.at(2, "p_peak_Pa"), at.peak_pressure);
  EXPECT_EQ(rows.at(2, "G_x_N_m"), at.force_moment.x());
  EXPECT_EQ(rows.at(2, "z_theta0_max_m"), at.half_angle_place);
  const CsvTable map =
      folder.table(run + "1e5 --tilt 0.05 --twist -0.02 --points 41");
  ASSERT_EQ(map.size(), 41u * 41);
  // Midpoints of the map add up to the load, with the error of 40 steps for a
  // pressure that falls like a root at its edge.
  const double dtheta =
      (map.at(2, "theta_deg") - map.at(1, "theta_deg")) * degree;
  const double dz = map.at(42, "z_m") - map.at(1, "z_m");
  double load = 0;
  for (std::size_t row = 1; row <= map.size(); ++row) {
    const double theta = map.at(row, "theta_deg") * degree;
    const double z = map.at(row, "z_m");
    const double p = map.at(row, "p_Pa");
    EXPECT_NEAR(p, bush.pressure(at, z, theta), 1e-9 * at.peak_pressure);
    const double share = std::abs(z) > 0.0249 ? 0.5 : 1;
    load += share * p * std::cos(theta) * 0.02 * dtheta * dz;
  }
  EXPECT_NEAR(load / 1e5, 1, 2e-3);
  // A load at a place has its moment.
  const CsvTable placed = folder.table(run + "1e5 --load-at 2mm");
  EXPECT_NEAR(placed.at("G_x_N_m"), 200, 1e-8 * 1e5 * 0.025);
  EXPECT_EQ(placed.at("load_at_m"), 0.002);
  folder.run_ill(run + "1e5 --tilt 9", 1,
                 "hinge-pressure: warning: the load needs a half-angle along "
                 "the pin beyond 80 deg, or beyond the limit of the pair\n"
                 "hinge-pressure: warning: rows without a value: 1, rows that "
                 "have not converged: 0\n");
}

// A joint that is pressed together has a pressure without load.
TEST(HingePressure, OfInterferenceIsThereWithoutLoad) {
  const ProgramFolder folder;
  const std::string pressed =
      "hinge-pressure --joint data/joints/lined_bush_pressed.toml --load "
      "0,6kN ";
  const CsvTable table = folder.table(pressed + "--summary");
  EXPECT_EQ(table.texts("contact_state"), (Texts{"closed", "lifted"}));
  const std::string p0 = table.text("p_0_Pa");
  EXPECT_EQ(table.text("p_peak_Pa"), p0);
  EXPECT_EQ(table.text("p_mean_Pa"), p0);
  EXPECT_EQ(table.text("S"), "");
  EXPECT_NEAR(table.at(2, "sum_p_N") / (6000 * table.at(2, "S")), 1, 1e-12);
  const CsvTable profile = folder.table(pressed + "--points 3");
  for (int row = 1; row <= 3; ++row) {
    EXPECT_EQ(profile.text(row, "p_exact_Pa"), p0);
  }
}

// A liner has a peak of 56 MPa with its true 0.3 mm; as an unbounded body 32
// MPa.
TEST(HingePressure, WarnsOfALinerWithoutAWall) {
  const ProgramFolder folder;
  const std::string bush =
      "hinge-pressure --joint pin --pair data/materials/steel_ptfe_liner.toml "
      "--diameter 20mm --clearance 20um --length 20mm --load 10kN "
      "--summary --pressure exact --law exact";
  const std::string warning =
      "the outer body, woven PTFE liner, is a liner, but modelled as "
      "unbounded: ";
  EXPECT_TRUE(has_text(folder.run_well(bush).err, warning));
  const std::string wall =
      " --wall 0.3mm --backing data/backings/carbon_steel.toml";
  EXPECT_FALSE(has_text(folder.run_well(bush + wall).err, warning));
  const auto peak = [&](const std::string& options) {
    return CsvTable(folder.run_well(bush + options).out).at("p_peak_Pa");
  };
  EXPECT_GT(peak(wall), 1.5 * peak(""));
}

}  // namespace
}  // namespace contact::test::hinge_pressure_test
