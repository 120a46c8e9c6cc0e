// A study as a function of its file and the run's number.
#include "study/study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/joint/presliding/stiction.hpp"
#include "programs/study/findings/findings.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/case/force_law.hpp"
#include "study/model/separation_model.hpp"
#include "study/rows/journal.hpp"
#include "study/workers.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/program.hpp"

namespace contact::test::study_test {
namespace {

namespace fs = std::filesystem;
using study::Journal;
using study::Row;
using study::Study;

// To the last bit, NaN too.
void expect_same(const Row& a, const Row& b) {
  EXPECT_EQ(a.run, b.run);
  EXPECT_EQ(a.failure, b.failure);
  ASSERT_EQ(a.numbers.size(), b.numbers.size());
  EXPECT_EQ(std::memcmp(a.numbers.data(), b.numbers.data(),
                        a.numbers.size() * sizeof(double)),
            0);
}

const std::string joint_text =
    "name = 'ball'\nkind = 'ball'\n"
    "geometry = { radius_mm = 50, radial_clearance_um = 100 }\n"
    "materials = { pair = '" CONTACT_DATA_DIR
    "/materials/steel_steel.toml' }\n"
    "friction = { coefficient = 0.1 }\nhalf_angle = { law = 'fitted' }\n"
    "pressure = { law = 'sqrt_tan' }\n";

const std::string ball_text =
    "name = 'balls'\njoint = 'j.toml'\nruns = 40\nquantities = ['R_n_N']\n"
    "load = { reaction_kN = 100, beta_deg = 60 }\n"
    "[[requirement]]\nquantity = 'M_t_N_m'\nat_most = 500\nsuccess = 0.9\n"
    "[[dispersion]]\nkey = 'friction.coefficient'\nkind = 'uniform'\n"
    "low = 0.05\nhigh = 0.15\n"
    "[[dispersion]]\nkey = 'load.reaction_N'\nkind = 'normal'\nmean = 100000\n"
    "deviation = 5000\nlow = 50000\n";

class StudyFolder : public testing::Test {
 protected:
  StudyFolder() { write("j.toml", joint_text); }

  std::string write(const std::string& name, const std::string& text) const {
    folder_.write(name, text);
    return path(name);
  }
  std::string ball(const std::string& from = "", const std::string& to = "") {
    std::string text = ball_text;
    if (!from.empty()) text.replace(text.find(from), from.size(), to);
    return write("s.toml", text);
  }
  std::string path(const std::string& name) const {
    return folder_.path() / name;
  }
  // A study of the arm, c.toml, with further lines of its file.
  std::string arm(const std::string& more) const {
    return write("s.toml", "name = 's'\ncase = 'c.toml'\nruns = 10\n" + more);
  }
  // The same of its largest reaction.
  std::string arm_reaction(const std::string& more) const {
    return arm("quantities = 'arm.peak_reaction_N'\n" + more);
  }
  // The message about a study, without the name of its file.
  static std::string message_of(const std::string& file) {
    const std::string text = error_message([&] { const Study study(file); });
    return text.starts_with(file) ? text.substr(file.size()) : text;
  }

  const ProgramFolder folder_;
};

using BallStudy = StudyFolder;

// By the library itself, with the draws that the columns show.
TEST_F(BallStudy, RowsAreWhatTheJointSays) {
  const Study study(ball());
  ASSERT_EQ(study.columns(), (Texts{"friction.coefficient", "load.reaction_N",
                                    "M_t_N_m", "R_n_N", "p_peak_over_limit"}));
  JointSpec spec = read_joint(path("j.toml"));
  for (const std::uint64_t run : {1, 7, 40}) {
    const Row row = study.row(run);
    EXPECT_TRUE(row.failure.empty());
    spec.friction = FrictionLaw(row.numbers[0]);
    const double b = std::numbers::pi / 3;
    const auto solution =
        Joint(spec.contact())
            .solve(
                {row.numbers[1] * Eigen::Vector3d(std::sin(b), 0, std::cos(b)),
                 {0, 0, 1}});
    // The angle is read from degrees.
    EXPECT_NEAR(row.numbers[2] / solution.friction_moment.norm(), 1, 1e-13);
    EXPECT_NEAR(row.numbers[3] / solution.normal_force, 1, 1e-13);
    const double limit = 0.05 * spec.pair().inner().youngs_modulus;
    EXPECT_NEAR(row.numbers[4] / (solution.peak_pressure / limit), 1, 1e-13);
  }
}

// Whatever changes a row, so that no journal goes on with rows of another
// study.
TEST_F(BallStudy, IdentitiesDifferWithWhatRowsDependOn) {
  std::set<std::string> identities = {Study(ball()).identity()};
  const std::pair<const char*, const char*> changes[] = {
      {"high = 0.15", "high = 0.16"},
      {"deviation = 5000", "deviation = 5001"},
      {"kind = 'uniform'", "kind = 'uniform'\nrelative = true"},
      {"runs = 40", "runs = 40\nseed = 2"},
      {"runs = 40", "runs = 40\nsampling = 'latin_hypercube'"},
      {"runs = 40", "runs = 41\nsampling = 'latin_hypercube'"},
      {"runs = 40", "runs = 40\nsampling = 'sobol'"},
      {"reaction_kN = 100", "reaction_kN = 101"},
      {"'R_n_N'", "'Abar'"}};
  for (const auto& [from, to] : changes) {
    EXPECT_TRUE(identities.insert(Study(ball(from, to)).identity()).second)
        << to;
  }
  write("j.toml", joint_text + "inner_body = 'body'\n");
  EXPECT_TRUE(identities.insert(Study(ball()).identity()).second);
  write("j.toml", joint_text + "# as it was\n");
  for (const auto& [from, to] :
       {std::pair{"runs = 40", "runs = 50"}, {"high = 0.15", "high = 15e-2"}}) {
    EXPECT_FALSE(identities.insert(Study(ball(from, to)).identity()).second)
        << to;
  }
}

TEST_F(BallStudy, RunZeroIsNominal) {
  const Study study(ball());
  const Row row = study.row(0);
  EXPECT_TRUE(std::isnan(row.numbers[0]));
  EXPECT_EQ(row.numbers[2], study.nominal().at("M_t_N_m"));
}

TEST_F(BallStudy, AnyThreadAndOrderGiveTheSameRows) {
  const Study study(ball());
  std::vector<Row> rows(41);
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([&, t] {
        for (int run = 40 - t; run >= 0; run -= 4) {
          rows[run] = study.row(static_cast<std::uint64_t>(run));
        }
      });
    }
  }
  const Study again(ball());
  for (std::uint64_t run = 0; run <= 40; ++run) {
    expect_same(rows[run], again.row(run));
  }
}

TEST_F(BallStudy, WhatDoesNotFitIsNamed) {
  const auto message = [&](const std::string& from, const std::string& to) {
    const std::string name = ball(from, to);
    std::string text = error_message([&] { const Study study(name); });
    for (const std::string& file : {name, path("j.toml")}) {
      for (auto at = text.find(file); at != text.npos; at = text.find(file)) {
        text.replace(at, file.size(), fs::path(file).filename().string());
      }
    }
    return text;
  };
  const std::tuple<const char*, const char*, const char*> changes[] = {
      {"quantity = 'M_t_N_m'", "quantity = 'M_t'",
       "s.toml:7: requirement[1].quantity = \"M_t\": unknown quantity "
       "\"M_t\"; --quantities lists those of the nominal run"},
      {"quantity = 'M_t_N_m'", "quantity = 'M_t_Nm'",
       "s.toml:7: requirement[1].quantity = \"M_t_Nm\": unknown quantity "
       "\"M_t_Nm\": did you mean \"M_t_N_m\"?; --quantities lists those "
       "of the nominal run"},
      {"low = 0.05\n", "low = -0.01\n",
       "s.toml:11: dispersion[1].key = \"friction.coefficient\": j.toml "
       "with friction.coefficient = -0.01: friction.coefficient = -0.01 "
       "must be 0 or above"},
      {"key = 'friction.coefficient'", "key = 'friction.coef'",
       "s.toml:11: dispersion[1].key = \"friction.coef\": j.toml with "
       "friction.coef = 0.05: unknown key \"friction.coef\" (coefficient, "
       "preset, preset_share, adhesion, viscous_constant, "
       "viscous_pressure_slope, law, "
       "static_coefficient, dynamic_coefficient, stribeck_velocity, "
       "reference_pressure, exponent, pressures, speeds_over_pressure, "
       "coefficients, curve)"},
      {"quantity = 'M_t_N_m'", "quantity = '*'",
       "s.toml:7: requirement[1].quantity = \"*\" must be a name of one "
       "kind of number, not of Abar and M_t_N_m"},
      {"load.reaction_N", "load.reaction_kN", "(no error)"},
      {"kind = 'uniform'\n", "kind = 'uniform'\neach = true\n",
       "s.toml:13: dispersion[1].each = true requires a case with bodies "
       "that have a pattern"}};
  for (const auto& [from, to, said] : changes)
    EXPECT_EQ(message(from, to), said);
}

// Dry friction does not know how fast it slides.
TEST_F(BallStudy, KeysWithoutEffectAreNamed) {
  const std::vector<double> any(3, 0.0);
  EXPECT_EQ(Study(ball()).idle_keys(any), Texts{});
  const std::string key = "load.rate_rad_per_s";
  const std::string file =
      ball("[[dispersion]]", "[[dispersion]]\nkey = '" + key +
                                 "'\nkind = 'uniform'\nlow = 1\n"
                                 "high = 2\n[[dispersion]]");
  EXPECT_EQ(Study(file).idle_keys(any), Texts{key});
}

// A run that fails is a row with its reason and a miss.
TEST_F(BallStudy, FailedRunsAreMisses) {
  // A half-angle of 90 deg and more is beyond Hertz's law.
  std::string joint = joint_text;
  joint.replace(joint.find("'fitted'"), 8, "'hertz'");
  write("j.toml", joint);
  const Study study(
      ball("kind = 'normal'\nmean = 100000\ndeviation = 5000\n"
           "low = 50000\n",
           "kind = 'list'\nvalues = [1e5, 1e9]\n"));
  std::size_t failed = 0;
  Journal journal(path("j"), study.identity(), study.columns(),
                  Journal::Use::write);
  for (std::uint64_t run = 0; run <= study.runs(); ++run) {
    const Row row = study.row(run);
    journal.append(row);
    if (row.failure.empty()) continue;
    ++failed;
    EXPECT_EQ(row.failure,
              "the half-angle law or the pressure law has no value under this "
              "load");
    EXPECT_TRUE(std::isnan(row.numbers[2]));
  }
  EXPECT_GT(failed, 10u);
  const auto findings = study::find(study, journal);
  EXPECT_EQ(findings.failed, failed);
  EXPECT_GE(findings.requirements[0].misses, failed);
  EXPECT_EQ(findings.requirements[0].answer, study::Answer::not_met);
  // More than a tenth of them: the 90 % percentile is one of them.
  EXPECT_TRUE(std::isinf(findings.requirements[0].percentile.value));
}

class FailingRuns : public StudyFolder {
 protected:
  // Findings of 200 runs, `failing` of them failed, with one requirement.
  study::Findings findings(std::size_t failing, const std::string& limit,
                           const std::string& success) const {
    std::string text = ball_text.substr(0, ball_text.find("[[requirement]]"));
    text.replace(text.find("runs = 40"), 9, "runs = 200");
    const Study study(
        write("s.toml", text + "[[requirement]]\nquantity = 'R_n_N'\n" + limit +
                            "\nsuccess = " + success +
                            "\n[[dispersion]]\nkey = 'load.reaction_N'\n"
                            "kind = 'uniform'\nlow = 1e5\nhigh = 2e5\n"));
    Journal journal(path("j" + limit + success + std::to_string(failing)),
                    study.identity(), study.columns(), Journal::Use::write);
    for (std::uint64_t run = 0; run <= study.runs(); ++run) {
      Row row = study.row(run);
      if (run != 0 && run <= failing) {
        row.failure = "it failed";
        std::fill(row.numbers.begin() + 1, row.numbers.end(), std::nan(""));
      }
      journal.append(row);
    }
    return study::find(study, journal);
  }
};

TEST_F(FailingRuns, AreAtTheBadEndOfPercentiles) {
  const auto of = [&](std::size_t failing, const char* limit,
                      const char* success) {
    return findings(failing, limit, success).requirements[0];
  };
  const auto most = of(188, "at_most = 1e9", "0.5");
  EXPECT_EQ(most.missing, 188u);
  EXPECT_EQ(most.answer, study::Answer::not_met);
  EXPECT_EQ(most.percentile.value, infinity);
  EXPECT_EQ(most.percentile.low, infinity);
  EXPECT_EQ(most.percentile.high, infinity);
  const auto least = of(188, "at_least = 1", "0.5").percentile;
  EXPECT_EQ(least.value, -infinity);
  EXPECT_EQ(least.high, -infinity);
  // A few of them: the bounds are other order statistics of the rest.
  const auto none = of(0, "at_most = 1e9", "0.9").percentile;
  const auto few = of(5, "at_most = 1e9", "0.9").percentile;
  EXPECT_GT(few.value, none.value);
  EXPECT_GE(*few.low, *none.low);
  EXPECT_GT(*few.high, *none.high);
  EXPECT_LT(*few.high, infinity);
  // More than 10 % of all: there is an estimate, but no upper bound.
  const auto tenth = of(18, "at_most = 1e9", "0.9").percentile;
  EXPECT_LT(tenth.value, infinity);
  EXPECT_EQ(tenth.high, infinity);
}

// A run without the number may be at one end or the other.
TEST_F(FailingRuns, WidenPercentilesOfNumbersWithoutALimit) {
  const auto whole = findings(0, "at_most = 1e9", "0.9").quantities[0];
  EXPECT_EQ(whole.median.low, whole.median.high);
  const auto some = findings(30, "at_most = 1e9", "0.9").quantities[0];
  EXPECT_EQ(some.missing, 30u);
  EXPECT_EQ(some.p5.low, -infinity);
  EXPECT_LT(some.p5.high, infinity);
  EXPECT_GT(some.p95.low, -infinity);
  EXPECT_EQ(some.p95.high, infinity);
  EXPECT_LT(some.median.low, whole.median.low);
  EXPECT_GT(some.median.high, whole.median.high);
}

TEST_F(BallStudy, OnlyRandomRunsHaveAVerdict) {
  for (const char* sampling : {"random", "sobol", "latin_hypercube"}) {
    const Study study(ball(
        "runs = 40", std::string("runs = 40\nsampling = '") + sampling + "'"));
    Journal journal(path(sampling), study.identity(), study.columns(),
                    Journal::Use::write);
    std::vector<std::uint64_t> runs(41);
    for (std::size_t i = 0; i < runs.size(); ++i) runs[i] = i;
    study::compute(
        study, runs, 2, journal, [] { return ""; }, [] {});
    const auto findings = study::find(study, journal);
    EXPECT_EQ(findings.requirements[0].answer.has_value(),
              sampling == std::string("random"));
    EXPECT_EQ(findings.requirements[0].percentile.high.has_value(),
              sampling == std::string("random"));
  }
}

const std::string case_text = fs::path(CONTACT_DATA_DIR) / "cases/soyuz.toml";

// One draw for each copy: the case's bodies and forces equal a case that is
// read with the draw of its copy.
TEST_F(StudyFolder, CopiesHaveDrawsOfTheirOwn) {
  const std::string text =
      "name = 's'\ncase = '" + case_text +
      "'\nruns = 3\n[[dispersion]]\n"
      "key = 'force[booster engine].thrust_kN'\neach = true\nkind = 'uniform'\n"
      "low = 590\nhigh = 610\n"
      "[[dispersion]]\nkey = 'body[booster].mass_t'\neach = true\n"
      "kind = 'uniform'\nlow = 4\nhigh = 5\n"
      "[[dispersion]]\nkey = 'carrier.mass_t'\nkind = 'uniform'\nlow = 90\n"
      "high = 99\n";
  const Study study(write("s.toml", text));
  ASSERT_EQ(study.inputs(), 9u);
  EXPECT_EQ(study.design().source_label(2),
            "force[booster engine, booster 3].thrust_kN");
  EXPECT_EQ(study.design().source_label(5), "body[booster 2].mass_t");
  EXPECT_EQ(study.design().source_label(8), "carrier.mass_t");
  const auto draws = study.design().numbers(2);
  const separation::Case c = study.case_of(2);
  EXPECT_DOUBLE_EQ(c.carrier.mass, 1000 * draws[8]);
  for (std::size_t copy = 0; copy < 4; ++copy) {
    EXPECT_DOUBLE_EQ(c.bodies[copy].rigid.mass, 1000 * draws[4 + copy]);
    const separation::Force& force = c.forces[1 + copy];
    const std::vector<multibody::BodyMotion> bodies(
        5, {{0, 0, 0}, {0, 0, 0}, Eigen::Matrix3d::Identity(), {0, 0, 0}});
    std::vector<multibody::BodyForce> forces(5);
    force.law->add({c, force.body, bodies, 0, 0, INFINITY}, forces);
    EXPECT_NEAR(forces[force.body].force.norm(), 1000 * draws[copy], 1e-6);
  }
  EXPECT_EQ(error_message([&] {
              std::string wrong = text;
              wrong.replace(wrong.find("'carrier.mass_t'"), 16,
                            "'carrier.mass_t'\neach = true");
              const Study no(write("s.toml", wrong));
            }),
            path("s.toml") +
                ":18: dispersion[3].each = true requires a key of a body or "
                "force with a pattern, or of a force on such a body: "
                "body[NAME].KEY or force[NAME].KEY");
}

// Eight springs of one entry.
TEST_F(StudyFolder, ForcesOfAPatternHaveDrawsOfTheirOwn) {
  write("c.toml",
        "name = 'c'\nrun = { end_time_s = 0.2 }\n"
        "[carrier]\nname = 'a'\nmass_kg = 5\n"
        "principal_inertia_kg_m2 = [1, 1, 1]\n"
        "[[body]]\nname = 'b'\nmass_kg = 5\n"
        "principal_inertia_kg_m2 = [1, 1, 1]\n"
        "[[force]]\nname = 's'\nkind = 'pusher'\nbody = 'b'\n"
        "point_m = [0, 1, 0]\ncarrier_point_m = [0, 1, 0]\n"
        "direction = [1, 0, 0]\nfirst_force_N = 9\nstroke_m = 0.1\n"
        "pattern = { count = 8, axis = [1, 0, 0] }\n");
  const Study study(write("s.toml",
                          "name = 's'\ncase = 'c.toml'\nruns = 3\n"
                          "[[dispersion]]\nkey = 'force[s].first_force_N'\n"
                          "each = true\nkind = 'uniform'\nlow = 8\nhigh = 9\n"
                          "[[dispersion]]\nkey = 'body[b].mass_kg'\n"
                          "kind = 'uniform'\nlow = 4\nhigh = 5\n"));
  ASSERT_EQ(study.inputs(), 9u);
  EXPECT_EQ(study.design().source_label(7), "force[s, b, 8].first_force_N");
  const auto draws = study.design().numbers(1);
  const separation::Case c = study.case_of(1);
  ASSERT_EQ(c.forces.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    const std::vector<multibody::BodyMotion> bodies(
        2, {{0, 0, 0}, {0, 0, 0}, Eigen::Matrix3d::Identity(), {0, 0, 0}});
    std::vector<multibody::BodyForce> forces(2);
    c.forces[i].law->add({c, 1, bodies, 0, 0, INFINITY}, forces);
    EXPECT_NEAR(forces[1].force.x(), draws[i], 1e-12);
    EXPECT_NEAR(forces[1].moment.z(),
                -draws[i] * std::cos(std::numbers::pi / 4 * double(i)), 1e-12);
  }
}

TEST_F(StudyFolder, ADrivenCarriersMassHasNoEffect) {
  write("c.toml",
        "name = 'c'\nrun = { end_time_s = 0.2 }\n"
        "[carrier]\nname = 'a'\nmass_kg = 5\n"
        "principal_inertia_kg_m2 = [1, 1, 1]\n"
        "drive = { acceleration = [1, 0, 0] }\n"
        "[[body]]\nname = 'b'\nmass_kg = 1\ncom_m = [0.5, 0, 0]\n"
        "principal_inertia_kg_m2 = [1, 1, 1]\n"
        "hinge = { kind = 'axis', axis = [0, 0, 1] }\n"
        "start = { rate_deg_per_s = 30 }\n");
  const std::string text =
      "name = 's'\ncase = 'c.toml'\nruns = 3\n"
      "quantities = 'b.peak_reaction_N'\n"
      "[[dispersion]]\nkey = 'carrier.mass_kg'\nkind = 'uniform'\n"
      "low = 4\nhigh = 6\n"
      "[[dispersion]]\nkey = 'body[b].mass_kg'\nkind = 'uniform'\n"
      "low = 1\nhigh = 2\n";
  const Study study(write("s.toml", text));
  EXPECT_EQ(study.idle_keys({0, 0}), Texts{"carrier.mass_kg"});
}

// An arm on a spring, and another body that turns fast: its inertia changes the
// steps of the integrator, and by them the arm's last digits.
const std::string arm_case =
    "name = 'c'\nrun = { end_time_s = 1 }\n"
    "[carrier]\nname = 'a'\nmass_kg = 50\n"
    "principal_inertia_kg_m2 = [10, 10, 10]\n"
    "[[body]]\nname = 'arm'\nmass_kg = 1\ncom_m = [0.5, 0, 0]\n"
    "principal_inertia_kg_m2 = [1, 1, 1]\n"
    "hinge = { kind = 'axis', axis = [0, 0, 1] }\n"
    "start = { rate_deg_per_s = 30 }\n"
    "[[body]]\nname = 'other'\nmass_kg = 3\n"
    "principal_inertia_kg_m2 = [1, 2, 2.5]\n"
    "start = { position_m = [5, 0, 0], "
    "angular_velocity_deg_per_s = [1000, 2000, 30] }\n"
    "[[force]]\nname = 's'\nkind = 'spring'\nbody = 'arm'\n"
    "point_m = [1, 0, 0]\ncarrier_point_m = [0, 1, 0]\n"
    "stiffness_N_per_m = 50\nfree_length_m = 0.5\n"
    "[[event]]\nname = 'release'\nbodies = 'arm'\nangle_deg = 300\n"
    "breaks = 'hinge'\n";

std::string dispersion(const std::string& key, double low, double high) {
  return "[[dispersion]]\nkey = '" + key +
         "'\nkind = 'uniform'\nlow = " + std::to_string(low) +
         "\nhigh = " + std::to_string(high) + "\n";
}

TEST_F(StudyFolder, StepsThatBecomeOthersAreNoEffect) {
  write("c.toml", arm_case);
  const std::string inertia = "body[other].principal_inertia_kg_m2[2]";
  const Study study(arm_reaction(dispersion(inertia, 1.9, 2.1) +
                                 dispersion("body[arm].mass_kg", 0.9, 1.1)));
  ASSERT_EQ(study.idle_keys({0, 0}).size(), 0u);
  Journal journal(path("j"), study.identity(), study.columns(),
                  Journal::Use::write);
  for (std::uint64_t run = 0; run <= 10; ++run) journal.append(study.row(run));
  EXPECT_EQ(study::find(study, journal).idle, Texts{inertia});
}

// They take long, and a row has the numbers that the study names.
TEST_F(StudyFolder, TorqueMarginsAreComputedIfTheyAreAskedFor) {
  std::string text = arm_case;
  const std::string axis = "axis = [0, 0, 1]";
  text.insert(text.find(axis) + axis.size(),
              ", torque_margin = { to_deg = 90 }");
  write("c.toml", text);
  const study::Plan plan =
      study::read_plan(arm_reaction(dispersion("body[arm].mass_kg", 0.9, 1.1)));
  const study::SeparationModel model(plan);
  for (const bool margins : {true, false}) {
    const study::Result result =
        model.run(KeySettings{}, {.margins = margins}, {});
    EXPECT_EQ(result.failure, "");
    EXPECT_EQ(result.numbers.contains("arm.torque_margin_angle_deg"), margins);
  }
}

// A signal comes while a run is on its way: the run is no failure of the case.
TEST_F(StudyFolder, ARunThatIsStoppedIsNoRow) {
  write("c.toml", arm_case);
  const Study study(arm_reaction(dispersion("body[arm].mass_kg", 0.9, 1.1)));
  Journal journal(path("j"), study.identity(), study.columns(),
                  Journal::Use::write);
  int steps = 0;
  study.row(1, [&] {
    ++steps;
    return "";
  });
  int asked = 0;
  int done = 0;
  const auto stop = [&] { return ++asked > 5 * steps / 2 ? "a signal" : ""; };
  study::compute(study, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, 1, journal, stop,
                 [&] { ++done; });
  EXPECT_GT(done, 0);
  EXPECT_LT(done, 10);
  EXPECT_EQ(journal.size(), static_cast<std::size_t>(done));
  for (std::uint64_t run = 1; run <= 10; ++run) {
    if (!journal.has(run)) continue;
    EXPECT_EQ(journal.at(run).failure, "");
  }
}

// A pressed bush is judged by its numbers without load.
TEST_F(StudyFolder, InterferenceHasItsNumbers) {
  const std::string joint = CONTACT_DATA_DIR "/joints/lined_bush_pressed.toml";
  const Study pressed(
      write("s.toml",
            "name = 'bush'\njoint = '" + joint +
                "'\nruns = 2\nload = { reaction_kN = 6 }\nquantities = "
                "['M_0_N_m', 'R_lift_off_N', 'p_0_Pa', 'sum_p_N', 'shift_m']\n"
                "[[dispersion]]\nkey = 'friction.coefficient'\n"
                "kind = 'uniform'\nlow = 0.05\nhigh = 0.15\n"));
  const JointContact contact = read_joint(joint).contact();
  // Friction takes its part of the reaction.
  const double force = pressed.nominal().at("R_n_N");
  const double theta0 = contact.half_angle(force).half_angle;
  const std::map<std::string, double> expected = {
      {"M_0_N_m", contact.unloaded_moment(0)},
      {"R_lift_off_N", contact.lift_off_force()},
      {"p_0_Pa", contact.interference_pressure()},
      {"sum_p_N", contact.sum_of_pressures(force, theta0)},
      {"shift_m", contact.shift(force, theta0)}};
  for (const auto& [name, value] : expected) {
    ASSERT_TRUE(pressed.nominal().contains(name)) << name;
    EXPECT_NEAR(pressed.nominal().at(name) / value, 1, 1e-12) << name;
  }
}

// A clearance has how far it goes before it slides, by the law that knows D.
TEST_F(StudyFolder, ClearanceHasItsPresliding) {
  const auto nominal = [&](const std::string& law) {
    std::string text = joint_text;
    write("j.toml", text.replace(text.find("fitted"), 6, law));
    return Study(ball()).nominal();
  };
  const auto numbers = nominal("exact");
  JointSpec spec = read_joint(path("j.toml"));
  const JointContact contact = spec.contact();
  const double force = numbers.at("R_n_N");
  const double way = stiction_deformation(contact, force,
                                          contact.half_angle(force).half_angle);
  EXPECT_GT(way, 0);
  EXPECT_NEAR(numbers.at("stiction_deformation_m") / way, 1, 1e-12);
  EXPECT_NEAR(numbers.at("presliding_angle_deg") * degree *
                  spec.geometry.radius() / way,
              1, 1e-12);
  EXPECT_FALSE(nominal("fitted").contains("presliding_angle_deg"));
}

// It turns hard without any load; a joint with a clearance does not.
TEST_F(StudyFolder, InterferenceMayBeUnloaded) {
  const auto file = [&](const std::string& joint) {
    return write("s.toml", "name = 'bush'\njoint = '" CONTACT_DATA_DIR
                           "/joints/" +
                               joint +
                               ".toml'\nruns = 2\nload = { reaction_kN = 0 }\n"
                               "quantities = 'M_t_N_m'\n[[dispersion]]\n"
                               "key = 'friction.coefficient'\n"
                               "kind = 'uniform'\nlow = 0.05\nhigh = 0.15\n");
  };
  const Study pressed(file("lined_bush_pressed"));
  const JointContact contact =
      read_joint(CONTACT_DATA_DIR "/joints/lined_bush_pressed.toml").contact();
  EXPECT_NEAR(pressed.nominal().at("M_t_N_m") / contact.unloaded_moment(0), 1,
              1e-12);
  EXPECT_EQ(pressed.row(1).failure, "");
  const std::string text =
      error_message([&] { const Study open(file("pin_joint")); });
  EXPECT_TRUE(text.ends_with(
      ":4: load.reaction_kN = 0 must be above 0, as a joint without "
      "interference has no friction without load"))
      << text;
}

// Loads out of line with a ring reach a rim.
TEST_F(StudyFolder, JointsAreInTheirSeats) {
  const std::string file =
      CONTACT_DATA_DIR "/joints/spherical_plain_bearing_ge50.toml";
  const auto study = [&](const std::string& load) {
    return write("s.toml",
                 "name = 'ring'\njoint = '" + file +
                     "'\nruns = 4\n[load]\nreaction_kN = 1\nbeta_deg = 90\n" +
                     load +
                     "[[requirement]]\nquantity = 'p_peak_Pa'\n"
                     "at_most = 1e9\nsuccess = 0.9\n"
                     "[[dispersion]]\nkey = 'load.beta_deg'\n"
                     "kind = 'list'\nvalues = [90, 80]\n");
  };
  const JointSpec spec = read_joint(file);
  for (const bool without_seat : {false, true}) {
    const Study ring(study(without_seat ? "without_seat = true\n" : ""));
    const Joint joint(without_seat ? spec.without_seat() : spec);
    std::set<double> seen;
    for (const std::uint64_t run : {1, 2, 3, 4}) {
      const Row row = ring.row(run);
      EXPECT_EQ(row.failure, "");
      seen.insert(row.numbers[0]);
      const double b = row.numbers[0] * std::numbers::pi / 180;
      const JointSolution s = joint.solve(
          {1e3 * Eigen::Vector3d(std::sin(b), 0, std::cos(b)), {0, 0, 1}});
      EXPECT_NEAR(row.numbers[1] / s.peak_pressure, 1, 1e-12);
      EXPECT_EQ(std::isnan(s.half_angle), !without_seat && row.numbers[0] < 90);
    }
    EXPECT_EQ(seen.size(), 2u);
    EXPECT_EQ(ring.nominal().contains("K_low"), !without_seat);
  }
  const auto numbers = Study(study("")).nominal();
  EXPECT_EQ(numbers.at("free"), 1);
  EXPECT_GT(numbers.at("lower_gap_m"), 1e-3);
  EXPECT_GT(numbers.at("M_t_N_m"), 1);
  // The area of catalogues: 50 mm bore, ball of 66 mm, ring of 28 mm.
  EXPECT_NEAR(numbers.at("p_nominal_Pa") * spec.geometry.nominal_area() / 1e3,
              1, 1e-12);
}

// Seats about another axis than beta's, under vectors in their axes: as
// hinge-joint --reaction-xyz.
TEST_F(StudyFolder, LoadsAreVectorsInTheAxesOfTheSeat) {
  const auto study = [&](const std::string& reaction) {
    return write("s.toml",
                 "name = 'cup'\njoint = '" CONTACT_DATA_DIR
                 "/joints/hip_cup.toml'\nruns = 1\nload = { reaction_xyz_N = " +
                     reaction +
                     " }\nquantities = 'p_peak_Pa'\n[[dispersion]]\n"
                     "key = 'load.reaction_xyz_N[3]'\nkind = 'list'\n"
                     "values = [3000]\n");
  };
  const Study loaded(study("[0, 1000, 2500]"));
  const Joint cup(read_joint(CONTACT_DATA_DIR "/joints/hip_cup.toml"));
  EXPECT_NEAR(loaded.row(1).numbers[1] /
                  cup.solve({{0, 1000, 3000}, {0, 0, 1}}).peak_pressure,
              1, 1e-12);
  const std::string text =
      error_message([&] { const Study s(study("[0, 2000, 0]")); });
  EXPECT_TRUE(has_text(text, "the nominal run failed: the load points"))
      << text;
}

// Many contacts at rims are read from a table, the nominal one is not.
TEST_F(StudyFolder, ManyLoadsAtRimsMakeATable) {
  const auto study = [&](int runs) {
    return write("s.toml",
                 "name = 'cup'\njoint = '" CONTACT_DATA_DIR
                 "/joints/hip_cup.toml'\nruns = " +
                     std::to_string(runs) +
                     "\nload = { reaction_xyz_N = [0, 1000, 3000] }\n"
                     "quantities = ['p_peak_Pa', 'M_t_N_m', 'free']\n"
                     "[[dispersion]]\nkey = 'load.reaction_xyz_N[2]'\n"
                     "kind = 'uniform'\nlow = 800\nhigh = 1200\n");
  };
  const Study few(study(400));
  const Study many(study(600));
  EXPECT_NE(few.identity(), many.identity());
  // No time is said of so few: 400 of 30 to 60 ms in 16 threads.
  EXPECT_TRUE(has_text(few.forecast(100'000, 1),
                       "100 % of the runs reach a rim of the seat"));
  EXPECT_EQ(few.forecast(1, 16), "");
  EXPECT_TRUE(has_text(many.forecast(600, 1), "are read from a table"));
  expect_same(few.row(0), many.row(0));
  for (const std::uint64_t run : {1, 2, 3}) {
    const Row exact = few.row(run);
    const Row read = many.row(run);
    ASSERT_EQ(exact.numbers[0], read.numbers[0]);
    ASSERT_EQ(exact.numbers[3], 0);
    // RimTableOptions::accuracy is 1e-3 of the load; pressures of tables are
    // right to 1 % (seat/table_test.cpp).
    EXPECT_NEAR(read.numbers[1] / exact.numbers[1], 1, 1e-2);
    EXPECT_NEAR(read.numbers[2] / exact.numbers[2], 1, 1e-3);
    EXPECT_NE(read.numbers[2], exact.numbers[2]);
  }
}

// The share is over 48 times.
TEST_F(StudyFolder, LoadsThatSwingAreAtTheRimForAShare) {
  const std::string file =
      CONTACT_DATA_DIR "/joints/spherical_plain_bearing_ge50.toml";
  const auto numbers =
      Study(write("s.toml", "name = 'ring'\njoint = '" + file +
                                "'\nruns = 1\nload = { reaction_kN = 1, "
                                "swing_deg = 10 }\nquantities = 'rim_share'\n"
                                "[[dispersion]]\nkey = 'load.swing_deg'\n"
                                "kind = 'list'\nvalues = [10]\n"))
          .nominal();
  const Joint seat(read_joint(file));
  double at_rim = 0;
  double largest = 0;
  for (int i = 0; i < 48; ++i) {
    const double b =
        std::numbers::pi / 2 +
        std::numbers::pi / 18 * std::sin(2 * std::numbers::pi * i / 48);
    const JointSolution s = seat.solve(
        {1e3 * Eigen::Vector3d(std::sin(b), 0, std::cos(b)), {0, 0, 1}});
    const double intensity = seat.rims(s)->intensity();
    at_rim += intensity > 0 ? 1 : 0;
    largest = std::max(largest, intensity);
  }
  EXPECT_GT(at_rim, 5);
  EXPECT_LT(at_rim, 43);
  EXPECT_NEAR(numbers.at("rim_share"), at_rim / 48, 1e-9);
  EXPECT_NEAR(numbers.at("largest_K") / largest, 1, 1e-4);
  EXPECT_EQ(numbers.at("least_gap_m"), 0);
  EXPECT_GE(numbers.at("largest_p_peak_Pa"), numbers.at("p_peak_Pa"));
}

// A ring's contact so near to its rim that it has no largest pressure: it was
// 0, and the verdict on it "met".
TEST_F(StudyFolder, RequirementsOnPeaksThatAreNotThereFail) {
  const Study study(
      write("s.toml",
            "name = 'ring'\njoint = '" CONTACT_DATA_DIR
            "/joints/spherical_plain_bearing_ge50.toml'\nruns = 1\nload = { "
            "reaction_N = 100, beta_deg = 20 }\n[[requirement]]\n"
            "quantity = 'p_peak_Pa'\nat_most = 7e7\nsuccess = 0.5\n"
            "[[dispersion]]\nkey = 'load.reaction_N'\nkind = 'list'\n"
            "values = [100]\n"));
  const Row row = study.row(1);
  EXPECT_EQ(row.failure, "");
  const double value = study.value_of(0, row);
  EXPECT_TRUE(std::isnan(value)) << value;
  EXPECT_FALSE(study.plan().requirements[0].holds(value));
  EXPECT_EQ(std::ranges::count(study.warnings(),
                               "\"p_peak_Pa\" has no number: runs without it "
                               "miss their requirement"),
            1);
}

TEST_F(StudyFolder, LoadsThatLeaveTheSeatFail) {
  const auto study = [&](const char* beta) {
    return write(
        "s.toml",
        std::string("name = 'cup'\njoint = '" CONTACT_DATA_DIR
                    "/joints/spherical_plain_thrust_bearing.toml'\nruns = 1\n"
                    "load = { reaction_kN = 1, beta_deg = ") +
            beta +
            " }\nquantities = 'p_peak_Pa'\n[[dispersion]]\n"
            "key = 'load.reaction_kN'\nkind = 'list'\nvalues = [2]\n");
  };
  EXPECT_EQ(Study(study("170")).row(1).failure, "");
  EXPECT_TRUE(has_text(error_message([&] { const Study s(study("100")); }),
                       "the load points 80 deg from the seat's axis"));
}

TEST_F(StudyFolder, PinsThatEndHaveTheirNumbers) {
  const std::string file = CONTACT_DATA_DIR "/joints/relieved_bush.toml";
  const auto study = [&](const std::string& load) {
    return Study(write("s.toml", "name = 'bush'\njoint = '" + file +
                                     "'\nruns = 1\nload = { reaction_kN = 100"
                                     ", " +
                                     load +
                                     " }\nquantities = 'p_peak_Pa'\n"
                                     "[[dispersion]]\nkey = "
                                     "'load.reaction_N'\nkind = 'list'\n"
                                     "values = [1e5]\n"));
  };
  const FinitePin pin(read_joint(file));
  const double tilt = 0.02 * std::numbers::pi / 180;
  const std::pair<std::string, FinitePinSolution> loads[] = {
      {"beta_deg = 90", pin.solve({1e5, 0}, {0, 0}, 1)},
      {"slide_mm_per_s = 30, rate_rad_per_s = 2",
       pin.solve({1e5, 0}, {0, 0}, FinitePin::Motion{2, 0.03})},
      {"tilt_deg = 0.02, twist_deg = 0.02",
       pin.solve({1e5, 0}, {tilt, tilt}, 1)},
      {"load_at_mm = 3", pin.solve_at({1e5, 0}, 3e-3, 1)}};
  for (const auto& [load, s] : loads) {
    const auto numbers = study(load).nominal();
    EXPECT_NEAR(numbers.at("p_peak_Pa") / s.contact.peak_pressure, 1, 1e-9);
    // Tolerance against the 300 N m of a load at 3 mm.
    EXPECT_NEAR(numbers.at("G_x_N_m"), s.contact.force_moment.x(), 1e-6);
    EXPECT_NEAR(numbers.at("M_t_z_N_m") / s.moment.z(), 1, 1e-9);
    EXPECT_GT(numbers.at("p_peak_over_limit"), 0);
  }
}

TEST_F(StudyFolder, LoadsOfJointsThatEndAreChecked) {
  const auto message = [&](const std::string& joint, const std::string& load) {
    const std::string name = write(
        "s.toml", "name = 'n'\njoint = '" CONTACT_DATA_DIR "/joints/" + joint +
                      ".toml'\nruns = 1\nload = { reaction_kN = 1, " + load +
                      " }\nquantities = 'p_peak_Pa'\n[[dispersion]]\n"
                      "key = 'load.reaction_kN'\nkind = 'list'\n"
                      "values = [2]\n");
    const std::string text = error_message([&] { const Study study(name); });
    return text.substr(std::min(text.size(), name.size()));
  };
  const std::string hip = "hip_cocr_uhmwpe";
  const std::string bush = "relieved_bush";
  const std::string ring = "spherical_plain_bearing_ge50";
  for (const std::string value : {"true", "false"}) {
    EXPECT_EQ(message(ring, "in_seat = " + value),
              ":4: load.in_seat = " + value +
                  " must be left out: a joint with a [seat] is in it; "
                  "without_seat = true takes the endless one");
  }
  EXPECT_EQ(message(hip, "without_seat = true"),
            ":4: load.without_seat = true requires a joint with a [seat]");
  EXPECT_EQ(message("hip_cup", "beta_deg = 90"),
            ":4: load.reaction_kN = 1 requires a seat about z, which beta is "
            "counted from, or reaction_xyz or without_seat");
  EXPECT_EQ(message("hip_cup", "without_seat = true"), "");
  EXPECT_EQ(message(ring, "reaction_xyz_N = [1, 0, 0]"),
            ":4: load.reaction_kN = 1 must be left out beside reaction_xyz, "
            "which determines it");
  EXPECT_EQ(message(hip, "swing_deg = 1"),
            ":4: load.swing_deg = 1 requires a joint in a [seat]");
  EXPECT_EQ(message(ring, "without_seat = true, swing_deg = 1"),
            ":4: load.swing_deg = 1 requires a joint in a [seat]");
  EXPECT_EQ(message(hip, "tilt_deg = 1"),
            ":4: load.tilt_deg = 1 requires a pin");
  EXPECT_EQ(message(bush, "twist_deg = 1"),
            ":4: load.twist_deg = 1 requires tilt");
  EXPECT_EQ(message(bush, "tilt_deg = 11"),
            ":4: load.tilt_deg = 11 must be -10 to 10 deg");
  EXPECT_EQ(message(bush, "load_at_mm = 26"),
            ":4: load.load_at_mm = 26 must be -25 to 25 mm");
  EXPECT_EQ(message(bush, "load_at_mm = 1, beta_deg = 80"),
            ":4: load.beta_deg = 80 must be left out beside tilt, load_at "
            "and slide: the reaction is across the axis");
  EXPECT_EQ(
      message(bush, "load_at_mm = 1, tilt_deg = 0"),
      ":4: load.tilt_deg = 0 must be left out beside load_at, which finds it");
}

TEST_F(StudyFolder, OneKeyUnderTwoNamesIsRefused) {
  write("c.toml", arm_case);
  const auto message = [&](const std::string& one, const std::string& two) {
    return message_of(arm(dispersion(one, 1, 1.1) + dispersion(two, 1, 1.1)));
  };
  EXPECT_EQ(message("body[arm].mass_kg", "body[1].mass_kg"),
            ":10: dispersion[2].key = \"body[1].mass_kg\" must be another key "
            "than \"body[arm].mass_kg\": both names are of one key");
  EXPECT_EQ(message("body[1].mass_kg", "body[1].mass_t"),
            ":10: dispersion[2].key = \"body[1].mass_t\" must be another key "
            "than \"body[1].mass_kg\": both names are of one key");
  EXPECT_EQ(message("body[1].mass_kg", "body[2].mass_kg"), "(no error)");
}

// The names of a distance are in the order of the bodies, not of the file.
TEST_F(StudyFolder, TheNearestQuantityIsNamed) {
  write("c.toml", std::string(arm_case) +
                      "[[body]]\nname = 'tip'\nmass_kg = 1\n"
                      "start = { position_m = [9, 0, 0] }\n"
                      "[[body.shape]]\nkind = 'box'\nsize_m = [1, 1, 1]\n"
                      "[[body]]\nname = 'cone'\nmass_kg = 1\n"
                      "start = { position_m = [0, 9, 0] }\n"
                      "[[body.shape]]\nkind = 'box'\nsize_m = [1, 1, 1]\n"
                      "[[clearance]]\na = 'cone'\nb = 'tip'\n");
  for (const auto& [name, meant] :
       {std::pair{"clearance.cone.tip.smallest_m",
                  "clearance.tip.cone.smallest_m"},
        {"smallest_m", "clearance.smallest_m"},
        {"arm.peak_reacton_N", "arm.peak_reaction_N"},
        {"peak_reaction_N", "arm.peak_reaction_N"}}) {
    EXPECT_TRUE(has_text(
        message_of(arm("[[requirement]]\nquantity = '" + std::string(name) +
                       "'\nat_most = 1\nsuccess = 0.9\n" +
                       dispersion("body[arm].mass_kg", 1, 1.1))),
        "did you mean \"" + std::string(meant) + "\"?"))
        << name;
  }
}

// A release or an event that the nominal run does not come to.
TEST_F(StudyFolder, WhatTheNominalRunDoesNotReachIsSaid) {
  write("c.toml", arm_case);
  const auto message = [&](const std::string& quantity) {
    return message_of(arm("[[requirement]]\nquantity = '" + quantity +
                          "'\nat_most = 1\nsuccess = 0.9\n" +
                          dispersion("body[arm].mass_kg", 1, 1.1)));
  };
  const std::string place = ":5: requirement[1].quantity = \"";
  for (const std::string name :
       {"arm.at_release.rate_deg_per_s", "*.at_release.rate_deg_per_s",
        "a*.at_release.velocity_m_per_s[*"}) {
    EXPECT_EQ(message(name),
              place + name + "\": arm is not released in the nominal run");
  }
  EXPECT_EQ(message("event.release.arm.time_s"),
            place +
                "event.release.arm.time_s\": event \"release\" does not "
                "occur for arm in the nominal run");
  EXPECT_TRUE(
      has_text(message("other.at_release.rate_deg_per_s"), "unknown quantity"));
  EXPECT_EQ(message("*"),
            place +
                "*\" must be a name of one kind of number, not of "
                "arm.peak_reaction_N and arm.peak_reaction_time_s");
  EXPECT_EQ(message("arm.*_N"), "(no error)");
}

}  // namespace
}  // namespace contact::test::study_test
