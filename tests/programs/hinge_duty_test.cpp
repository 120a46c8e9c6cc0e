// The program hinge-duty, run as its users run it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.hpp"
#include "support/reference_table.hpp"

namespace contact::test::hinge_duty_test {
namespace {

using testing::HasSubstr;

const std::string data = "data/reference/duty/";
const std::string hip = "hinge-duty --joint " + data +
                        "cycle_hip.toml --cycle " + data +
                        "cycle_hip_in.csv --euler zxy ";
const std::string pin = "hinge-duty --joint " + data +
                        "cycle_pin.toml --cycle " + data + "cycle_pin_in.csv ";

double value(const std::string& summary, const std::string& quantity) {
  return CsvTable(summary).value(quantity);
}

class HingeDuty : public testing::Test {
 protected:
  std::string out(const std::string& command) const {
    return folder_.run_well(command).out;
  }
  const ProgramFolder folder_;
};

// Instants of all Gauss points, kept, were 4.6 kB a row.
TEST_F(HingeDuty, LongCyclesTakeLittleMemory) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "a sanitizer keeps what is freed";
#endif
  std::string rows =
      "time_s,R_x_N,R_y_N,R_z_N,w_x_rad_per_s,w_y_rad_per_s,w_z_rad_per_s\n";
  constexpr int count = 30'000;
  for (int i = 0; i < count; ++i) {
    const double turn = 2 * std::numbers::pi * i / 100;
    rows += fmt::format("{},{},0,{},0,{},1\n", i * 0.01, 200 * std::sin(turn),
                        -1500 - 800 * std::cos(turn), 2 + std::sin(turn));
  }
  folder_.write("long.csv", rows);
  const double energy = value(
      out("hinge-duty --joint " + data + "cycle_hip.toml --cycle long.csv"),
      "energy_J");
  EXPECT_GT(energy, 0);
  rusage programs{};
  ASSERT_EQ(getrusage(RUSAGE_CHILDREN, &programs), 0);
  // kB: the program without a cycle, and 500 bytes a row.
  EXPECT_LT(programs.ru_maxrss, 12'000 + count / 2);
}

// Options and columns of the file say how a pin that ends lies; files along it
// are AlongPin's.
TEST_F(HingeDuty, PinThatEnds) {
  const std::string joint = "data/joints/relieved_bush.toml";
  const std::string run = "hinge-duty --joint " + joint + " --cycle ";
  const std::string cycle = "data/duty/pin_cycle.csv ";
  const std::string text =
      out(run + cycle +
          "--load-at 2mm --states states.csv --along along.csv "
          "--along-map map.csv --wear-seat 1e-6");
  const CsvTable states(folder_.read("states.csv"));
  const CsvTable along(folder_.read("along.csv"));
  const CsvTable map(folder_.read("map.csv"));
  ASSERT_EQ(states.size(), 80u);
  ASSERT_EQ(along.size(), 101u);
  const double largest = value(text, "largest_pv_max_W_per_m2");
  // Between the rows and places it is a little larger.
  for (const CsvTable* table : {&states, &along}) {
    const double of_rows =
        *std::ranges::max_element((*table)["pv_max_W_per_m2"]);
    EXPECT_NEAR(of_rows / largest, 1, 2e-3);
    EXPECT_LE(of_rows, largest);
  }
  // Trapezoids along the pin, whose contact ends between its ends.
  double sum = 0;
  for (const double pv : along["pv_integral_J_per_m"]) sum += pv * 0.05 / 100;
  EXPECT_NEAR(sum / value(text, "pv_integral_J"), 1, 1e-3);
  const auto bodies = map.texts("body");
  const auto depths = map.texts("depth_mm");
  const auto pv = map["pv_integral_Pa_m"];
  for (const std::string body : {"carrier", "body"}) {
    double volume = 0;
    for (std::size_t i = 0; i < pv.size(); ++i) {
      if (bodies[i] != body) continue;
      volume += pv[i] * 2 * std::numbers::pi * 0.02 / 180 * 0.05 / 40;
      if (depths[i].empty()) continue;
      // k = 1e-6 mm^3/(N m), mm.
      EXPECT_NEAR(std::stod(depths[i]) / pv[i], 1e-12, 1e-24);
    }
    EXPECT_NEAR(volume / value(text, "pv_integral_J"), 1, 1e-2);
  }
  for (const double theta0 : states["theta0_max_deg"]) {
    EXPECT_LE(theta0, value(text, "largest_theta0_deg"));
  }
  EXPECT_NEAR(value(text, "volume_seat_mm3"),
              1e-6 * value(text, "pv_integral_J"), 1e-15 * 1e6);
}

// Columns of the cycle say how the pin lies, as the options do where they may.
TEST_F(HingeDuty, LieOfAPinInColumns) {
  const std::string run =
      "hinge-duty --joint data/joints/relieved_bush.toml --cycle ";
  const auto with_column = [&](const std::string& name,
                               const std::string& value) {
    std::istringstream lines(folder_.read("data/duty/pin_cycle.csv"));
    std::string text;
    bool is_head = true;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with('#')) continue;
      text += line + ',' + (is_head ? name : value) + '\n';
      is_head = false;
    }
    folder_.write("cycle.csv", text);
    return out(run + "cycle.csv");
  };
  const std::string largest = "largest_pv_max_W_per_m2";
  const std::string placed = with_column("load_at_m", "0.002");
  const std::string option = out(run + "data/duty/pin_cycle.csv --load-at 2mm");
  EXPECT_NEAR(value(placed, largest) / value(option, largest), 1, 1e-9);
  // A tilt that stays with the carrier, unlike the option's.
  const std::string tilted = with_column("tilt_y_deg", "0.03");
  const std::string level = out(run + "data/duty/pin_cycle.csv --tilt 0");
  EXPECT_GT(value(tilted, largest), 1.1 * value(level, largest));
  EXPECT_NE(value(tilted, largest),
            value(out(run + "data/duty/pin_cycle.csv --tilt 0.03"), largest));
}

// The seat confines a ball: the summary follows the rows.
TEST_F(HingeDuty, InSeat) {
  const std::string run =
      "hinge-duty --joint data/joints/hip_cup.toml --cycle "
      "data/duty/hip_cycle.csv --euler zxy ";
  const std::string text = out(run + "--states states.csv");
  const CsvTable rows(folder_.read("states.csv"));
  ASSERT_EQ(rows.size(), 100u);
  double at_rim = 0, pv = 0;
  for (const double k : rows["K_high"]) at_rim += k > 0 ? 0.01 : 0;
  for (const double watts : rows["pv_total_W"]) pv += 0.01 * watts;
  EXPECT_EQ(value(text, "largest_p_peak_Pa"),
            *std::ranges::max_element(rows["p_peak_Pa"]));
  EXPECT_EQ(value(text, "largest_pv_max_W_per_m2"),
            *std::ranges::max_element(rows["pv_max_W_per_m2"]));
  EXPECT_NEAR(value(text, "rim_share"), at_rim, 1e-9);
  EXPECT_NEAR(value(text, "pv_integral_J") / pv, 1, 1e-12);
  EXPECT_EQ(value(text, "least_gap_m"), 0);
  EXPECT_TRUE(std::isnan(value(text, "largest_theta0_deg")));
  EXPECT_TRUE(std::isnan(value(text, "contact_spread_deg")));
  // Confined, the same load presses harder; the work is nearly the same.
  const std::string endless = out(run + "--without-seat");
  EXPECT_GT(value(text, "largest_pv_max_W_per_m2"),
            value(endless, "largest_pv_max_W_per_m2"));
  for (const char* sum : {"energy_J", "pv_integral_J", "mean_M_t_N_m"}) {
    EXPECT_NEAR(value(text, sum) / value(endless, sum), 1, 0.03) << sum;
    EXPECT_NE(value(text, sum), value(endless, sum)) << sum;
  }
  EXPECT_FALSE(has_text(endless, "rim_share"));
  const ProgramResult other =
      folder_.run(run + "--seat-table data/joints/hip_cup.toml");
  EXPECT_EQ(other.status, 2);
  EXPECT_TRUE(has_text(other.err,
                       "--seat-table data/joints/hip_cup.toml: not a table "
                       "of a seat"));
}

// The joint wears in: --blocks ends with the numbers of the summary.
TEST_F(HingeDuty, Cycles) {
  const std::string text =
      out(hip + "--wear-seat 1e-6 --cycles 5e6 --blocks blocks.csv");
  const CsvTable blocks(folder_.read("blocks.csv"));
  ASSERT_GE(blocks.size(), 20u);
  for (const std::string& name : blocks.names()) {
    // For pins, and for stationary loads.
    if (name == "clearance_mm" || name == "worn_share") {
      EXPECT_EQ(blocks.text(blocks.size(), name), "");
      continue;
    }
    EXPECT_EQ(blocks.at(blocks.size(), name), value(text, "worn_" + name));
  }
  EXPECT_EQ(value(text, "worn_cycles"), 5e6);
  // The first cycle equals the unworn joint's, except for its laws.
  EXPECT_NEAR(blocks.at(blocks.names()[7]) / value(text, "energy_J"), 1, 0.01);
  // The contact grows, and with it the moment and the volume of a cycle.
  EXPECT_GT(value(text, "worn_volume_seat_mm3"),
            5e6 * value(text, "volume_seat_mm3"));
  EXPECT_GT(value(text, "worn_theta0_deg"), 70);
}

// A pin that swings by 10 deg to each side: four times 10 deg of the rim, in
// enough rows. The moment about Z lies between the rows; except for friction
// the contact stays at its place in the seat.
TEST_F(HingeDuty, PathAndSpread) {
  std::string rows = "time_s,R_x_N,R_y_N,R_z_N,angle_deg\n";
  for (int i = 0; i < 200; ++i) {
    const double phase = 2 * std::numbers::pi * i / 200;
    rows += std::to_string(0.01 * i) + ",0,-4e4,0," +
            std::to_string(10 * std::sin(phase)) + '\n';
  }
  folder_.write("swing.csv", rows);
  const std::string text =
      out("hinge-duty --joint data/joints/pin_joint.toml --cycle swing.csv "
          "--force-in body");
  const double path = 4 * 10 * std::numbers::pi / 180 * 0.02;
  // Angles of six digits.
  EXPECT_NEAR(value(text, "sliding_path_m") / path, 1, 1e-6);
  EXPECT_GT(value(text, "effective_sliding_distance_m"), path);
  EXPECT_NEAR(value(text, "contact_spread_deg"),
              std::atan(0.1) * 180 / std::numbers::pi, 1e-6);
}

// Half the cycles, and the other half from the seat that they left.
TEST_F(HingeDuty, WornSeats) {
  const std::string run =
      "hinge-duty --joint data/joints/pin_joint.toml --cycle "
      "data/duty/pin_cycle.csv --grid 10 --wear-seat 2e-7 ";
  const std::string whole = out(run + "--cycles 2e4 --worn-out whole.toml");
  out(run + "--cycles 1e4 --worn-out half.toml");
  const std::string rest =
      out(run + "--cycles 1e4 --worn half.toml --worn-out rest.toml");
  EXPECT_TRUE(has_text(folder_.read("half.toml"), "cycles = 10000"));
  EXPECT_TRUE(has_text(folder_.read("rest.toml"), "cycles = 20000"));
  // Other steps.
  for (const char* quantity :
       {"worn_volume_seat_mm3", "worn_penetration_mm", "worn_mean_M_t_N_m"}) {
    EXPECT_NEAR(value(rest, quantity) / value(whole, quantity), 1, 3e-3)
        << quantity;
  }
}

// The shipped cycle turns its load over the bush, which --cycles says.
TEST_F(HingeDuty, WearNotes) {
  const std::string pin_joint =
      "hinge-duty --joint data/joints/pin_joint.toml --cycle "
      "data/duty/pin_cycle.csv --grid 10 ";
  const auto said = [&](const std::string& options) {
    return folder_.run(pin_joint + options).err;
  };
  EXPECT_EQ(said("--wear-seat 2e-7"), "");
  EXPECT_TRUE(has_text(said("--wear-seat 2e-7 --cycles 1e4"),
                       "--cycles: the contact is worn step by step"));
  const std::string much = said("--wear-seat 100 --wear-inner 5e-11");
  EXPECT_TRUE(
      has_text(much, "--wear-seat: the wear coefficient 100 mm^3/(N m)"));
  EXPECT_TRUE(
      has_text(much, "--wear-inner: the wear coefficient 5e-11 mm^3/(N m)"));
  EXPECT_TRUE(has_text(much, "--wear-seat: one cycle: wear "));
  EXPECT_TRUE(has_text(said("--wear-seat 1 --cycles 1e15"),
                       "must be at most 20 mm, the radius"));
}

// Interference wears without load too: a distance under p has no value, and
// debris stays where the contact is closed.
TEST_F(HingeDuty, InterferenceKeepsItsDebris) {
  folder_.write("cycle.csv",
                "time_s,R_x_N,R_y_N,R_z_N,w_x_rad_per_s,w_y_rad_per_s,"
                "w_z_rad_per_s\n0,0,0,0,0,0,1\n1,2000,0,0,0,0,1\n"
                "2,6000,0,0,0,0,-1\n3,2000,0,0,0,0,-1\n");
  const ProgramResult result = folder_.run(
      "hinge-duty --joint data/joints/lined_bush_pressed.toml --cycle "
      "cycle.csv");
  EXPECT_EQ(result.status, 0);
  EXPECT_TRUE(has_text(result.err,
                       "the contact is closed all round up to 2838 N: wear "
                       "debris cannot leave"))
      << result.err;
  // All friction is f0 p.
  EXPECT_NEAR(value(result.out, "energy_J") /
                  (0.08 * value(result.out, "pv_integral_J")),
              1, 1e-9);
  EXPECT_TRUE(std::isnan(value(result.out, "effective_sliding_distance_m")));
}

// One row is a steady turn: the energy of a period is the power times it.
TEST_F(HingeDuty, OneRowIsASteadyTurn) {
  folder_.write("one.csv",
                "time_s,R_x_N,R_y_N,R_z_N,w_x_rad_per_s,w_y_rad_per_s,"
                "w_z_rad_per_s\n0,0,-5000,0,0,0,2\n");
  const std::string joint = " --joint data/joints/pin_joint.toml ";
  const std::string run = "hinge-duty" + joint + "--cycle one.csv";
  const double power =
      CsvTable(out("hinge-joint" + joint + "--reaction 5000 --rate 2"))
          .at("power_W");
  EXPECT_NEAR(value(out(run + " --period 3s"), "energy_J") / (-3 * power), 1,
              1e-12);
  folder_.run_ill(run, 2,
                  "hinge-duty: one.csv: a cycle of one row requires --period, "
                  "the time from the first row to its return\n");
  folder_.write("angle.csv", "time_s,R_x_N,R_y_N,R_z_N,a_deg\n0,0,-5000,0,2\n");
  folder_.run_ill(
      "hinge-duty" + joint + "--cycle angle.csv --period 3s", 2,
      "hinge-duty: angle.csv: 1 row must be 4 or more, or alike and "
      "with angular velocities: a steady turn\n");
}

// A row for 0 and for 100 % of the cycle is the same row.
TEST_F(HingeDuty, LastRowThatRepeatsTheFirst) {
  const std::string source = "data/duty/pin_cycle.csv";
  const std::string run =
      "hinge-duty --joint data/joints/pin_joint.toml --cycle ";
  const std::string once = out(run + source);
  const std::string rows = folder_.read(source);
  const std::size_t values = rows.find("\n0.0,") + 4;
  ASSERT_GT(values, 4u);
  folder_.write("cycle.csv",
                rows + "2.0" +
                    rows.substr(values, rows.find('\n', values) - values) +
                    '\n');
  const ProgramResult twice = folder_.run(run + "cycle.csv");
  EXPECT_EQ(twice.out, once);
  EXPECT_EQ(twice.err,
            "hinge-duty: warning: cycle.csv: the last row repeats the first "
            "and is left out: the period is 2 s; give a longer period if it is "
            "a separate row\n");
  EXPECT_EQ(folder_.run(run + "cycle.csv --period 2s").out, once);
  const ProgramResult longer = folder_.run(run + "cycle.csv --period 2.025s");
  EXPECT_EQ(longer.err, "");
  EXPECT_DOUBLE_EQ(value(longer.out, "period_s"), 2.025);
}

// Friction of the options and of laws of pressure and speed.
TEST_F(HingeDuty, Friction) {
  const std::string own = out(pin);
  const std::string half = out(pin + "--friction 0.05");
  EXPECT_GT(value(own, "energy_J"), value(half, "energy_J"));
  const std::string stribeck =
      "hinge-duty --joint data/duty/stribeck_pin.toml --cycle " + data +
      "cycle_pin_in.csv ";
  const double least = value(out(stribeck + "--friction 0.05"), "energy_J");
  const double most = value(out(stribeck + "--friction 0.15"), "energy_J");
  const double energy = value(out(stribeck), "energy_J");
  EXPECT_GT(energy, least);
  EXPECT_LT(energy, most);
}

// Accuracies as in tests/duty/joint_cycle_test.cpp.
TEST_F(HingeDuty, Summary) {
  const ReferenceTable table("duty/cycle_hip_summary.csv");
  const std::string text = out(hip + "--wear-seat 1e-6 --wear-inner 1e-9");
  const auto check = [&](const char* mine, const std::string& other,
                         double tolerance) {
    for (const ReferenceTable::Row row : table) {
      if (row.text("quantity") != other) continue;
      EXPECT_NEAR(value(text, mine) / row.value("value"), 1, tolerance) << mine;
      return;
    }
    ADD_FAILURE() << other;
  };
  check("period_s", "period_s", 1e-15);
  for (const char* same :
       {"energy_J", "mean_heat_W", "volume_seat_mm3", "volume_inner_mm3"}) {
    check(same, same, 1e-9);
  }
  check("effective_sliding_distance_m", "sliding_distance_m", 1e-9);
  check("mean_M_t_N_m", "mean_moment_N_m", 1e-9);
  check("largest_M_t_N_m", "max_moment_N_m", 1e-8);
  // Values at the rows are less, by up to some thousandths.
  check("least_M_t_x_N_m", "M_x_min_at_samples_N_m", 5e-3);
  check("largest_M_t_z_N_m", "M_z_max_at_samples_N_m", 5e-3);
  check("largest_pv_max_W_per_m2", "pv_max_W_per_m2", 1e-8);
  check("largest_theta0_deg", "theta0_max_deg", 1e-8);
  check("least_theta0_deg", "theta0_min_deg", 1e-8);
  check("largest_depth_carrier_mm", "max_depth_carrier_mm", 1e-5);
  check("largest_depth_body_mm", "max_depth_body_mm", 1e-5);
  EXPECT_LT(std::abs(value(text, "volume_defect_carrier")), 2. / 2000);
  EXPECT_LT(std::abs(value(text, "volume_defect_body")), 2. / 2000);
}

// Its warnings are of the largest contact of the cycle, as the summary has it.
TEST_F(HingeDuty, ContactsThatLeaveTheTheory) {
  const std::string hip_gait =
      "hinge-duty --joint data/joints/hip_cocr_uhmwpe.toml --cycle "
      "data/duty/hip_cycle.csv --euler zxy ";
  const auto said = [&](const std::string& options) {
    return folder_.run_well(hip_gait + options).err;
  };
  EXPECT_EQ(said(""), "");
  EXPECT_EQ(said("--set materials.outer.limit_pressure_MPa=5"),
            "hinge-duty: warning: peak pressure 14.67 MPa is above 5 MPa, the "
            "limit pressure of the outer body, UHMWPE\n");
  EXPECT_EQ(said("--set materials.outer.youngs_modulus_GPa=0.1"),
            "hinge-duty: warning: peak pressure 8.424 MPa is above 5 MPa, 5 % "
            "of the smaller Young's modulus: linear elasticity does not "
            "hold\n");
  // Half-angles of a law that does not know where they end.
  const std::string wide =
      "hinge-duty --joint " + data + "cycle_hip.toml --cycle " + data +
      "cycle_hip_in.csv --euler zxy --law tanh --limit-angle 130 --set "
      "geometry.radial_clearance_um=0.5";
  EXPECT_TRUE(has_text(folder_.run(wide).err,
                       " deg, the limit half-angle of this joint\n"));
}

// The k of a measured volume makes this volume.
TEST_F(HingeDuty, MeasuredWear) {
  const std::string text = out(
      hip + "--measured-volume 30 --measured-error 2 --measured-cycles 1e6");
  const double k = value(text, "k_measured_mm3_per_N_m");
  EXPECT_NEAR(value(text, "k_measured_error_mm3_per_N_m"), k / 15, 1e-13 * k);
  const std::string back =
      out(hip + "--wear-seat " + std::to_string(k * 1e6) + "e-6");
  EXPECT_NEAR(1e6 * value(back, "volume_seat_mm3"), 30, 1e-4);  // 6 digits
  EXPECT_FALSE(has_text(out(hip + "--measured-volume 30 --measured-cycles 1e6"),
                        "error_mm3"));
}

TEST_F(HingeDuty, MapAndStates) {
  out(pin + "--wear-seat 2e-7 --map map.csv --grid 360 --states states.csv");
  const CsvTable map(folder_.read("map.csv"));
  const ReferenceTable expected("duty/cycle_pin_map.csv");
  const auto body = map.texts("body");
  const auto depth = map.texts("depth_mm");
  int found = 0;
  for (const ReferenceTable::Row row : expected) {
    for (std::size_t i = 0; i < body.size(); ++i) {
      if (body[i] != row.text("body") ||
          std::abs(map["beta_deg"][i] - row.value("beta_deg")) > 1e-9) {
        continue;
      }
      ++found;
      EXPECT_NEAR(map["pv_integral_Pa_m"][i], row.value("pv_integral_Pa_m"),
                  1e2);  // 1e-4 of the largest
      // The body has the seat; the carrier's k was not given.
      EXPECT_EQ(depth[i].empty(), body[i] == "carrier");
    }
  }
  EXPECT_EQ(found, 20);  // points that wear
  EXPECT_EQ(CsvTable(folder_.read("states.csv")).size(),
            ReferenceTable("duty/cycle_pin_states.csv").size());
}

// Without a k there are no volumes, and without a map no wear.
TEST_F(HingeDuty, NoWearUnlessAsked) {
  const std::string text = out(hip);
  EXPECT_FALSE(has_text(text, "volume_"));
  EXPECT_FALSE(has_text(text, "depth_"));
}

// Its states are a cycle of rates with the same heat.
TEST_F(HingeDuty, RatesOfItsStates) {
  const double energy = value(out(hip + "--states states.csv"), "energy_J");
  const std::string again =
      out("hinge-duty --joint " + data + "cycle_hip.toml --cycle states.csv");
  // A spline of rates is not the derivative of a spline of angles.
  EXPECT_NEAR(value(again, "energy_J") / energy, 1, 1e-5);
  EXPECT_LT(value(again, "closure_deg"), 1e-3);
  // The opposite force on the other body is the same.
  folder_.write("c.csv", folder_.read("states.csv"));
  EXPECT_EQ(out("hinge-duty --joint " + data +
                "cycle_hip.toml --cycle c.csv --force-in carrier "
                "--force-on body"),
            again);
}

// Several joints have a row each, with the numbers of each alone; the
// differences come first, and the files beside the table have the rows of all.
TEST_F(HingeDuty, SeveralJoints) {
  const std::string run =
      "hinge-duty --joint data/joints/hip_cocr_uhmwpe.toml --cycle "
      "data/duty/hip_cycle.csv --euler zxy --wear-seat 1e-6 --cycles 1e4 "
      "--grid 50 ";
  const std::string files =
      " --states states.csv --blocks blocks.csv --map map.csv";
  const auto all = csv_rows(out(run +
                                "--set geometry.radius_mm=14,18 --set "
                                "'wall.layer[1].thickness_mm=5,12'" +
                                files));
  ASSERT_EQ(all.size(), 1 + 4u);
  const std::vector<std::string> names = {"states.csv", "blocks.csv",
                                          "map.csv"};
  std::vector<std::string> together;
  for (const auto& name : names) together.push_back(folder_.read(name));
  std::vector<std::string> joined(names.size());
  std::size_t row = 0;
  for (const std::string radius : {"14", "18"}) {
    for (const std::string thickness : {"5", "12"}) {
      const auto one = csv_rows(
          out(run + "--set geometry.radius_mm=" + radius +
              " --set 'wall.layer[1].thickness_mm=" + thickness + "'" + files));
      ++row;
      EXPECT_EQ(csv_column(all, "geometry.radius_mm")[row - 1], radius);
      EXPECT_EQ(csv_column(all, "wall.layer[1].thickness_mm")[row - 1],
                thickness);
      std::size_t cells = 2;
      for (std::size_t i = 1; i < one.size(); ++i) {
        // A quantity that a ball has not, has a column nevertheless.
        cells += one[i][1].empty() && one[i][2].empty() ? 1 : 0;
        for (std::size_t j = 1; j + 1 < one[0].size(); ++j) {
          if (one[i][j].empty()) continue;
          const std::string column =
              one[i][0] + (j == 1 ? "" : '_' + one[0][j]);
          EXPECT_EQ(csv_column(all, column)[row - 1], one[i][j]) << column;
          ++cells;
        }
      }
      EXPECT_EQ(all[0].size(), cells);
      for (std::size_t i = 0; i < names.size(); ++i) {
        const auto rows = csv_rows(folder_.read(names[i]));
        for (std::size_t k = joined[i].empty() ? 0 : 1; k < rows.size(); ++k) {
          for (const std::string& cell : rows[k]) joined[i] += cell + ',';
          joined[i].back() = '\n';
        }
      }
    }
  }
  EXPECT_EQ(joined, together);
}

// Whatever the table's format is.
TEST_F(HingeDuty, FilesBesideTheTableAreCsv) {
  const std::string run = pin +
                          "--wear-seat 2e-7 --cycles 10 --states s.csv "
                          "--map m.csv --blocks b.csv --grid 50 ";
  const auto files = [&] {
    return folder_.read("s.csv") + folder_.read("m.csv") +
           folder_.read("b.csv");
  };
  out(run);
  const std::string csv = files();
  for (const char* format : {"json", "markdown", "latex"}) {
    out(run + "--columns quantity --format " + format);
    EXPECT_EQ(files(), csv) << format;
  }
}

// A table of OpenSim, in degrees or not, is the CSV file with the same numbers.
TEST_F(HingeDuty, OpenSim) {
  const std::string joint =
      "hinge-duty --joint data/joints/hip_cocr_uhmwpe.toml --euler zxy ";
  const std::string f = "hip_on_leg_in_pelvis_f";
  const std::string columns = "--force-columns " + f + "x," + f + "y," + f +
                              "z --angle-columns hip_flexion_r,"
                              "hip_adduction_r,hip_rotation_r --cycle ";
  const std::string expected = out(joint + "--cycle data/duty/hip_cycle.csv");
  EXPECT_EQ(out(joint + columns + "data/duty/hip_cycle.sto"), expected);
  out("awk -F'\\t' -v OFS='\\t' -v CONVFMT=%.17g '/^inDegrees/ {next} NF > 1 "
      "&& "
      "$1 != \"time\" {for (i = 5; i <= 7; ++i) $i *= atan2(0, -1)/180} "
      "{print}' data/duty/hip_cycle.sto > radians.mot");
  EXPECT_NEAR(value(out(joint + columns + "radians.mot 2> said"), "energy_J") /
                  value(expected, "energy_J"),
              1, 1e-14);
  EXPECT_THAT(folder_.read("said"),
              HasSubstr("radians.mot: no inDegrees in its header: angles are "
                        "read as radians"));
}

// Keys of OpenSim's heads in any case; degrees without the key are noted.
TEST_F(HingeDuty, OpenSimKeysInAnyCase) {
  const std::string f = "hip_on_leg_in_pelvis_f";
  const std::string run =
      "hinge-duty --joint data/joints/hip_cocr_uhmwpe.toml --euler zxy "
      "--force-columns " +
      f + "x," + f + "y," + f +
      "z --angle-columns hip_flexion_r,hip_adduction_r,hip_rotation_r --cycle ";
  const std::string expected = out(run + "data/duty/hip_cycle.sto");
  for (const char* key : {"InDegrees=YES", "indegrees=yes", " inDegrees = Yes ",
                          "INDEGREES=yes"}) {
    out("sed 's/^inDegrees=yes/" + std::string(key) +
        "/' data/duty/hip_cycle.sto > key.sto");
    EXPECT_EQ(out(run + "key.sto"), expected) << key;
  }
  out("grep -v '^inDegrees' data/duty/hip_cycle.sto > none.sto");
  out(run + "none.sto 2> said");
  EXPECT_THAT(folder_.read("said"), HasSubstr("no inDegrees in its header"));
  EXPECT_THAT(folder_.read("said"),
              HasSubstr("are these degrees read as radians"));
}

TEST_F(HingeDuty, Picture) {
  out(pin + "--plot pin.svg");
  const std::string picture = folder_.read("pin.svg");
  EXPECT_TRUE(has_text(picture, "p v"));
  EXPECT_TRUE(has_text(picture, "time, s"));
}

// The map of a ball is two images with the visible axes, the seat's from its
// back; the map of a pin is two curves; there is one k, the seat's.
TEST_F(HingeDuty, MapPicture) {
  const std::string text = out(hip + "--wear-seat 1e-6 --map-plot hip.svg");
  const std::string ball = folder_.read("hip.svg");
  EXPECT_TRUE(has_text(
      ball, fmt::format("seat (carrier): {:.3g} µm",
                        1e9 * value(text, "largest_depth_carrier_mm"))));
  EXPECT_TRUE(has_text(ball, "inner (body)<"));
  EXPECT_TRUE(has_text(ball, ">Y<"));
  EXPECT_FALSE(has_text(ball, "−Y"));
  EXPECT_TRUE(has_text(ball, "<image"));
  EXPECT_NE(ball.find("<image", ball.find("<image") + 1), ball.npos);
  out(pin + "--wear-seat 2e-7 --map-plot pin.svg");
  const std::string curves = folder_.read("pin.svg");
  EXPECT_TRUE(has_text(curves, "seat (body)"));
  EXPECT_TRUE(has_text(curves, "inner (carrier)"));
  EXPECT_FALSE(has_text(curves, "<image"));
}

}  // namespace
}  // namespace contact::test::hinge_duty_test
