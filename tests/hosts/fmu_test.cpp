// FMUs of joints and cases, tested by an importer independent of libcontact.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdio>
#include <cstdlib>

#include "c/trapping_host.hpp"
#include "hosts/fmu_importer.hpp"
#include "hosts/joint_handle.hpp"
#include "separation/c/run.h"

namespace contact::test::fmu_test {
namespace {

using contact_hosts::must;
using Eigen::Matrix3d;
using Eigen::Vector3d;

const std::string folder = CONTACT_HOST_TESTS;
const std::string cases = CONTACT_SOURCE_DIR "/data/cases/";

// Tests may run side by side.
fs::path work() {
  return fs::path(testing::TempDir()) /
         ("contact_fmu_" +
          std::string(
              testing::UnitTest::GetInstance()->current_test_info()->name()));
}

/// FMU of a file, by the program.
std::unique_ptr<Fmu> fmu_of(const std::string& file, int version = 2) {
  fs::create_directories(work());
  const fs::path fmu = work() / "it.fmu";
  const std::string command = CONTACT_PROGRAMS "/hinge-fmu '" + file +
                              "' --fmi " + std::to_string(version) +
                              " --output '" + fmu.string() + "'";
  if (std::system(command.c_str()) != 0) throw std::runtime_error(command);
  return std::make_unique<Fmu>(
      fmu, work() / ("un zipped " + std::to_string(version)));
}

class Versions : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Fmi, Versions, testing::Values(2, 3));

// Every system has the C and C++ runtime; all else is inside.
TEST_P(Versions, CarryWhatTheyNeed) {
  for (const std::string& file : {folder + "ball.toml", cases + "soyuz.toml"}) {
    const auto fmu = fmu_of(file, GetParam());
    std::FILE* const pipe =
        popen(("ldd '" + fmu->binary().string() + "'").c_str(), "r");
    int inside = 0;
    for (char line[1000]; std::fgets(line, sizeof line, pipe);) {
      const std::string text = line;
      const bool is_inside =
          text.find(fmu->binary().parent_path().string()) != std::string::npos;
      inside += is_inside;
      bool is_runtime = false;
      for (const char* const name :
           {"linux-vdso", "ld-linux", "libc.so", "libm.so", "libgcc_s",
            "libstdc++", "san.so"}) {
        is_runtime = is_runtime || text.find(name) != std::string::npos;
      }
      EXPECT_TRUE(is_inside || is_runtime) << text;
    }
    pclose(pipe);
    EXPECT_EQ(inside > 0, file != folder + "ball.toml") << file;
  }
}

// A name that XML has to write otherwise; equal files make equal FMUs.
TEST_P(Versions, AreNamedAfterTheirFile) {
  const std::string name = "a & b \"<c>\"";
  fs::create_directories(work());
  const std::string file = work() / (name + ".toml");
  fs::copy(folder + "ball.toml", file, fs::copy_options::overwrite_existing);
  const auto bytes = [&] {
    const auto fmu = fmu_of(file, GetParam());
    EXPECT_EQ(fmu->description().attributes.at("modelName"), name);
    std::ifstream zip(work() / "it.fmu");
    return std::string(std::istreambuf_iterator<char>(zip), {});
  };
  const std::string first = bytes();
  EXPECT_GT(first.size(), 1000u);
  EXPECT_TRUE(bytes() == first);
}

// A contact outside the limits is reported at the end of the simulation.
TEST_P(Versions, SayWhereTheyLeaveTheModel) {
  const auto fmu = fmu_of(folder + "ball.toml", GetParam());
  const FmuInstance it(*fmu);
  it.enter();
  const auto said = [&](double load) {
    messages().clear();
    it.set("rate", Vector3d(0, 0, 1));
    it.set("reaction", Vector3d(load, 0, 0));
    EXPECT_GT(it.get("peak_pressure"), 0);
    EXPECT_EQ(it.call("Terminate"), 0);
    return messages();
  };
  // The joint's own note is there always.
  const auto before = said(100);
  ASSERT_EQ(before.size(), 1u);
  EXPECT_NE(before[0].find("limit half-angle is for pins"), std::string::npos);
  const auto notes = said(1e8);
  ASSERT_GT(notes.size(), 1u);
  EXPECT_EQ(notes[0], before[0]);
  EXPECT_NE(notes[1].find("linear elasticity does not hold"), std::string::npos)
      << notes[1];
}

// A head at the rim of its cup: the state has no grid of it, and repeats it to
// the last bit.
TEST_P(Versions, AreInTheirSeat) {
  const auto fmu =
      fmu_of(CONTACT_SOURCE_DIR "/data/joints/hip_cup.toml", GetParam());
  const FmuInstance it(*fmu);
  it.enter();
  it.start();
  it.set("rate", Vector3d(1, 0, 0));
  it.set("reaction", Vector3d(0, 1000, 3000));
  // As of hinge-joint --reaction-xyz.
  EXPECT_NEAR(it.get("peak_pressure"), 30542236.4, 0.05);
  EXPECT_TRUE(std::isnan(it.get("half_angle")));
  const Vector3d moment = it.vector("moment");
  void* state = nullptr;
  ASSERT_EQ(it.call("GetFMUstate", &state), 0);
  it.set("reaction", Vector3d(0, 1010, 3000));
  const Vector3d next = it.vector("moment");
  EXPECT_NE(next, moment);
  ASSERT_EQ(it.call("SetFMUstate", state), 0);
  EXPECT_EQ(it.vector("moment"), moment);
  it.set("reaction", Vector3d(0, 1010, 3000));
  EXPECT_EQ(it.vector("moment"), next);
  it.call("FreeFMUstate", &state);
  it.set("reaction", Vector3d(0, 2000, 0));
  EXPECT_EQ(it.step(0, 1), 2);
  EXPECT_NE(last_message().find("the load points 135 deg from the seat's axis"),
            std::string::npos)
      << last_message();
  it.set("reaction", Vector3d(0, 1000, 3000));
  messages().clear();
  EXPECT_EQ(it.call("Terminate"), 0);
  bool is_said = false;
  for (const std::string& note : messages()) {
    is_said = is_said || note.find("the contact is at its upper rim") == 0;
  }
  EXPECT_TRUE(is_said);
}

// All outputs of steps and of friction equal the results of C.
TEST_P(Versions, AnswerAsC) {
  const auto fmu = fmu_of(folder + "ball.toml", GetParam());
  contact_joint* joint = nullptr;
  must(contact_joint_read((folder + "ball.toml").c_str(), nullptr, 0, &joint));
  const FmuInstance it(*fmu);
  it.set("wear_coefficient", 1e-15);
  it.enter();
  std::srand(1);
  const Vector3d zero = Vector3d::Zero();
  for (int i = 0; i < 1000; ++i) {
    const bool steps = i % 2 == 0;
    const Vector3d rate = i % 3 ? Vector3d(Vector3d::Random()) : zero;
    const Vector3d reaction = 1000 * Vector3d::Random();
    const Vector3d free = rate + 0.1 * Vector3d::Random();
    const Matrix3d root = Matrix3d::Random();
    const Matrix3d inertia = root * root.transpose() + Matrix3d::Identity();
    it.set("rate", rate);
    it.set("reaction", reaction);
    it.set("free_rate", free);
    for (int row = 0; row < 3; ++row) {
      it.set(std::string("inertia_") + "xyz"[row],
             steps ? Vector3d(inertia.row(row)) : zero);
    }
    contact_step wanted{};
    contact_slip slip{};
    Vector3d::Map(slip.reaction) = reaction;
    Vector3d::Map(slip.angular_velocity) = rate;
    if (steps) {
      contact_step_start start{};
      Vector3d::Map(start.reaction) = reaction;
      Vector3d::Map(start.angular_velocity) = rate;
      Vector3d::Map(start.free) = free;
      must(contact_joint_step(joint, &start, inertia.data(), nullptr, &wanted));
      Vector3d::Map(slip.angular_velocity) = Vector3d(wanted.angular_velocity);
    } else {
      must(contact_joint_solve(joint, &slip, nullptr, &wanted.solution));
      Vector3d::Map(wanted.moment) = Vector3d(wanted.solution.friction_moment);
      Vector3d::Map(wanted.angular_velocity) = rate;
    }
    const Vector3d moment(wanted.moment);
    const Vector3d next(wanted.angular_velocity);
    EXPECT_LE((it.vector("moment") - moment).norm(), 1e-12 * moment.norm());
    EXPECT_LE((it.vector("next_rate") - next).norm(), 1e-12 * free.norm());
    EXPECT_EQ(it.flag("holds"), wanted.holds != 0);
    EXPECT_NEAR(it.get("half_angle"), wanted.solution.half_angle, 1e-13);
    const double peak = wanted.solution.peak_pressure;
    EXPECT_NEAR(it.get("peak_pressure"), peak, 1e-12 * peak);
    EXPECT_NEAR(it.get("heat"), -moment.dot(next), 1e-12);
    double pv = 0;
    if (!next.isZero(0)) {
      must(contact_rating_get(joint, &slip, &wanted.solution, "pv_total", &pv));
    }
    EXPECT_NEAR(it.get("wear_rate"), 1e-15 * pv, 1e-27 * pv);
  }
  contact_joint_free(joint);
}

// Outputs that are one step late change with DoStep alone.
TEST_P(Versions, AreOneStepLateAtChoice) {
  const auto fmu = fmu_of(folder + "pin.toml", GetParam());
  const Vector3d rate(0, 0, 1);
  Vector3d moments[2];
  for (const bool late : {false, true}) {
    const FmuInstance it(*fmu);
    it.set_flag("one_step_late", late);
    it.enter();
    it.set("axis", rate);
    it.set("rate", rate);
    it.set("reaction", Vector3d(1000, 0, 0));
    it.start();
    const Vector3d first = it.vector("moment");
    EXPECT_LT(first.z(), 0);
    it.set("reaction", Vector3d(2000, 0, 0));
    EXPECT_EQ(it.vector("moment") == first, late);
    it.step(0, 0.1);
    moments[late] = it.vector("moment");
    EXPECT_LT(moments[late].z(), 1.9 * first.z());
  }
  EXPECT_EQ(moments[0], moments[1]);
}

TEST_P(Versions, SaveAndGoOn) {
  const auto fmu = fmu_of(folder + "ball.toml", GetParam());
  const FmuInstance first(*fmu);
  first.set("friction.coefficient", 0.3);
  ASSERT_EQ(first.enter(), 0);
  first.set("reaction", Vector3d(100, 200, 900));
  first.set("rate", Vector3d(1, -0.3, 0.2));
  ASSERT_EQ(first.start(), 0);
  ASSERT_EQ(first.step(0, 0.1), 0);
  void* state = nullptr;
  ASSERT_EQ(first.call("GetFMUstate", &state), 0);
  std::size_t size = 0;
  ASSERT_EQ(first.call("SerializedFMUstateSize", state, &size), 0);
  std::string bytes(size, '\0');
  ASSERT_EQ(first.call("SerializeFMUstate", state, bytes.data(), size), 0);
  const Vector3d moment = first.vector("moment");

  // Another instance, with other parameters, continues in its place.
  const FmuInstance second(*fmu);
  void* read = nullptr;
  ASSERT_EQ(second.call("DeSerializeFMUstate", bytes.data(), size, &read), 0);
  ASSERT_EQ(second.call("SetFMUstate", read), 0);
  EXPECT_EQ(second.vector("moment"), moment);
  EXPECT_EQ(second.get("time"), 0.1);
  for (const FmuInstance* it : {&first, &second}) {
    it->set("rate", Vector3d(0.2, 0.4, 1));
  }
  EXPECT_EQ(first.vector("moment"), second.vector("moment"));
  // And the first goes back.
  ASSERT_EQ(first.call("SetFMUstate", state), 0);
  EXPECT_EQ(first.vector("moment"), moment);
  for (void** it : {&state, &read}) {
    first.call("FreeFMUstate", it);
    EXPECT_EQ(*it, nullptr);
  }
}

// The history of a case, with a parameter of a file that it names; what runs
// from C give to the last bit.
TEST_P(Versions, RunACase) {
  const auto fmu = fmu_of(cases + "flywheels.toml", GetParam());
  const char* const key =
      "body[1].hinge.joint[1].materials.inner.youngs_modulus_GPa";
  const FmuInstance it(*fmu);
  ASSERT_EQ(it.set(key, 190), 0);
  ASSERT_EQ(it.enter(5), 0);
  ASSERT_EQ(it.start(), 0);
  const contact_setting setting = {key, "190"};
  contact_run* run = nullptr;
  must(contact_run_open((cases + "flywheels.toml").c_str(), &setting, 1, &run));
  const std::size_t count = contact_run_column_count(run);
  std::vector<double> wanted(count);
  std::vector<double> values(count);
  std::vector<unsigned> references;
  for (std::size_t i = 0; i < count; ++i) {
    references.push_back(fmu->reference(contact_run_column(run, i)));
  }
  // A load from outside, held over each step.
  const char* const load = "wheel_y.applied_hinge_moment_N_m";
  EXPECT_EQ(fmu->causality(load), "input");
  std::vector<double> loads(contact_run_input_count(run));
  std::size_t place;
  must(contact_run_find_input(run, load, &place));
  const auto step_on = [&](int step) {
    EXPECT_EQ(it.set(load, 0.1 * step), 0);
    EXPECT_EQ(it.step(5 + step, 1), 0);
  };
  void* state = nullptr;
  for (int step = 0; step < 8; ++step) {
    step_on(step);
    loads[place] = 0.1 * step;
    must(contact_run_set_inputs(run, loads.data(), loads.size()));
    must(contact_run_advance(run, step + 1));
    if (step == 3) {
      it.call("GetFMUstate", &state);
      void* bytes;
      std::size_t size;
      must(contact_run_save(run, &bytes, &size));
      contact_free(bytes);
    }
    must(contact_run_values(run, wanted.data(), count));
    it.call("GetReal", references.data(), count, values.data(), count);
    for (std::size_t i = 0; i < count; ++i) {
      if (std::isnan(wanted[i])) continue;
      EXPECT_EQ(values[i], wanted[i]) << contact_run_column(run, i);
    }
  }
  const double end = it.get("wheel_x.angle_deg");
  it.call("SetFMUstate", state);
  EXPECT_NE(it.get("wheel_x.angle_deg"), end);
  EXPECT_EQ(it.get("time"), 9);
  for (int step = 4; step < 8; ++step) step_on(step);
  EXPECT_EQ(it.get("wheel_x.angle_deg"), end);
  it.call("FreeFMUstate", &state);
  contact_run_free(run);
  // Beyond its end it returns a discard, so that a host may try another step.
  EXPECT_EQ(it.step(13, 1e3), 2);
  EXPECT_EQ(last_message(), "the case ends at 40.000000 s");
}

// Bodies on bodies, which separate in part: bit-identical to C.
TEST_P(Versions, RunATree) {
  const std::string file = cases + "fairing_on_stage.toml";
  const auto fmu = fmu_of(file, GetParam());
  const FmuInstance it(*fmu);
  ASSERT_EQ(it.enter(0), 0);
  ASSERT_EQ(it.start(), 0);
  contact_run* run = nullptr;
  must(contact_run_open(file.c_str(), nullptr, 0, &run));
  std::vector<double> wanted(contact_run_column_count(run));
  for (int step = 0; step < 10; ++step) {
    ASSERT_EQ(it.step(0.5 * step, 0.5), 0);
    must(contact_run_advance(run, 0.5 * (step + 1)));
    must(contact_run_values(run, wanted.data(), wanted.size()));
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (std::isnan(wanted[i])) continue;
      const char* const column = contact_run_column(run, i);
      EXPECT_EQ(it.get(column), wanted[i]) << column;
    }
  }
  contact_run_free(run);
}

// Traps and rounding modes of the host have no effect, and are preserved.
TEST_P(Versions, KeepTheFloatEnvironmentOfTheirHost) {
  for (const auto& [file, output] :
       {std::pair{folder + "ball.toml", "peak_pressure"},
        {cases + "two_stage_turn.toml", "stage.angle_deg"}}) {
    const auto fmu = fmu_of(file, GetParam());
    const auto answer = [&fmu, &output = output] {
      const FmuInstance it(*fmu);
      if (output == std::string("peak_pressure")) {
        it.set("reaction", Vector3d(100, 300, 2000));
        it.set("rate", Vector3d(.3, .2, 1));
      }
      it.enter();
      it.start();
      EXPECT_EQ(it.step(0, .01), 0) << last_message();
      return it.get(output);
    };
    const double wanted = answer();
    double found = 0;
    bool is_kept = false;
    {
      const TrappingHost host;
      found = answer();
      is_kept = host.is_kept();
    }
    EXPECT_TRUE(is_kept) << file;
    EXPECT_EQ(found, wanted) << file;
    EXPECT_NE(found, 0) << file;
  }
}

TEST_P(Versions, StepForwardOnly) {
  const double nan = std::nan("");
  for (const std::string& file :
       {folder + "ball.toml", cases + "two_stage_turn.toml"}) {
    const auto fmu = fmu_of(file, GetParam());
    const FmuInstance it(*fmu);
    it.enter();
    it.start();
    for (const auto& [time, length] :
         {std::pair(0., -1.), {0., nan}, {nan, .1}, {0., INFINITY}}) {
      EXPECT_EQ(it.step(time, length), 3) << file << ' ' << length;
      EXPECT_NE(last_message().find("must have a length of 0 or more"),
                std::string::npos)
          << last_message();
    }
    EXPECT_EQ(it.step(0, .01), 0) << last_message();
  }
}

TEST_P(Versions, SayWhatIsWrong) {
  const auto fmu = fmu_of(folder + "pin.toml", GetParam());
  const FmuInstance it(*fmu);
  EXPECT_EQ(it.set("moment_x", 1), 3);
  EXPECT_EQ(last_message(), "moment_x must be left to the FMU");
  EXPECT_EQ(it.set("geometry.radius_mm", -1), 0);
  EXPECT_EQ(it.enter(), 3);
  EXPECT_NE(last_message().find("geometry.radius_mm = -1 must be"),
            std::string::npos)
      << last_message();
  EXPECT_EQ(it.set("geometry.radius_mm", 21), 0);
  EXPECT_EQ(it.enter(), 0);
  EXPECT_EQ(it.set("geometry.radius_mm", 20), 3);
  EXPECT_EQ(last_message(),
            "geometry.radius_mm must be set before the initialization");
  it.set("rate", Vector3d(0, 0, std::nan("")));
  EXPECT_EQ(it.step(0, 1), 2);  // no value: others may have one
  EXPECT_EQ(it.set_flag("reaction_x", true), 3);
  EXPECT_EQ(last_message(),
            "value reference 3 must be that of a variable of this type");
  void* const none = nullptr;
  EXPECT_EQ(it.call("SetFMUstate", none), 3);
  EXPECT_EQ(last_message(), "state must be other than null");
  std::size_t size = 0;
  EXPECT_EQ(it.call("SerializedFMUstateSize", none, &size), 3);
  EXPECT_EQ(it.call("Reset"), 0);
  EXPECT_EQ(it.get("geometry.radius_mm"), 20);
  // Files of another FMU, as those that somebody has edited are.
  std::ofstream(fs::path(fmu->resources()) / "keys.txt") << "{another}\n";
  EXPECT_THROW(const FmuInstance other(*fmu), std::runtime_error);
  EXPECT_EQ(last_message(),
            "guid, or instantiation token, must be that of "
            "modelDescription.xml");
}

/// The pendulum of docs/how-to/simulator.md.
struct Pendulum {
  static constexpr double mass = 5;
  Vector3d weight{0, 0, -9.81 * mass};
  Eigen::Quaterniond attitude{Eigen::AngleAxisd(1.0, Vector3d::UnitX())};
  Vector3d rate{0, 1, 0.5};
  Vector3d reaction = -weight;

  Vector3d centre() const { return attitude * Vector3d(0, 0, -0.4); }
  Matrix3d inertia() const {
    const Matrix3d axes = attitude.toRotationMatrix();
    return axes * Vector3d(0.9, 0.9, 0.02).asDiagonal() * axes.transpose();
  }
  Vector3d torque() const {
    return centre().cross(weight) - rate.cross(inertia() * rate);
  }
  Vector3d reaction_at(const Vector3d& acceleration) const {
    const Vector3d c = centre();
    return mass * (acceleration.cross(c) + rate.cross(rate.cross(c))) - weight;
  }
  void turn(const Vector3d& angle) {
    const Vector3d half = angle / 2;
    attitude = Eigen::Quaterniond(1, half.x(), half.y(), half.z()) * attitude;
    attitude.normalize();
  }
};

/// Rest of a pendulum.
struct Rest {
  double time = 60;  ///< when it rests, s; 60: never
  double creep = 0;  ///< angle between then and a minute later, rad
  double speed = 0;  ///< largest in this minute, rad/s
};
Rest rest_by_steps(const Fmu& fmu, double dt, bool late, int fits) {
  const FmuInstance it(fmu);
  it.set_flag("one_step_late", late);
  EXPECT_EQ(it.enter(), 0);
  EXPECT_EQ(it.start(), 0) << last_message();
  Pendulum p;
  Rest rest;
  Eigen::Quaterniond then = p.attitude;
  const auto steps_of = [dt](double time) { return std::lround(time / dt); };
  long end = steps_of(120);
  for (long i = 0; i < end; ++i) {
    const Matrix3d w = p.inertia() / dt;
    const Vector3d free = p.rate + w.inverse() * p.torque();
    it.set("rate", p.rate);
    it.set("free_rate", free);
    for (int row = 0; row < 3; ++row) {
      it.set(std::string("inertia_") + "xyz"[row], Vector3d(w.row(row)));
    }
    Vector3d next;
    for (int fit = 0; fit < fits; ++fit) {
      it.set("reaction", p.reaction);
      next = late ? Vector3d(free + w.inverse() * it.vector("moment"))
                  : it.vector("next_rate");
      p.reaction = p.reaction_at((next - p.rate) / dt);
    }
    const bool rests = it.flag("holds") && p.rate.isZero(0) && next.isZero(0);
    EXPECT_EQ(it.step(dt * double(i), dt), 0) << last_message() << i;
    if (rest.time == 60 && (rests || i == steps_of(60))) {
      rest.time = dt * double(i);
      then = p.attitude;
      end = i + steps_of(60);
    }
    p.rate = next;
    p.turn(dt * p.rate);
    if (dt * double(i) > rest.time) {
      rest.speed = std::max(rest.speed, next.norm());
    }
  }
  rest.creep = then.angularDistance(p.attitude);
  return rest;
}

// The page's program rests at 43.61 s. Reactions that fit the friction change
// that in the first order of the step, as the step itself does; friction that
// belongs to the inputs of the step before never lets it rest.
TEST(FmuSteps, PendulumRestsAsThePageSays) {
  const auto fmu = fmu_of(folder + "ball.toml");
  const Rest direct = rest_by_steps(*fmu, 1e-3, false, 1);
  EXPECT_NEAR(direct.time, 43.608, 1e-6);
  EXPECT_EQ(direct.creep, 0);
  const Rest fitted = rest_by_steps(*fmu, 1e-3, false, 4);
  EXPECT_NEAR(fitted.time, 43.471, 1e-6);
  EXPECT_EQ(fitted.creep, 0);
  const Rest late = rest_by_steps(*fmu, 1e-3, true, 1);
  EXPECT_EQ(late.time, 60);
  EXPECT_GT(late.speed, 1e-4);
  EXPECT_LT(late.speed, 1e-3);
  // It trembles by rounding: 3e-7 rad with AVX-512, 1.3e-5 with AVX2.
  EXPECT_LT(late.creep, 1e-4);
}

/// The pendulum by model exchange: Runge-Kutta steps, and events located in
/// them by halving.
class Exchange {
 public:
  Exchange(const FmuInstance& it, const Pendulum& p) : it_(it), p_(p) {}

  // Acceleration under the reaction that it causes.
  Vector3d acceleration(Pendulum& p) const {
    it_.set("rate", p.rate);
    const Matrix3d inverse = p.inertia().inverse();
    if (it_.flag("holds")) {
      p.reaction = p.reaction_at(Vector3d::Zero());
      it_.set("reaction", p.reaction);
      it_.set("held_moment", -p.torque());
      return Vector3d::Zero();
    }
    Vector3d a;
    for (int i = 0; i < 20; ++i) {
      it_.set("reaction", p.reaction);
      a = inverse * (p.torque() + it_.vector("moment"));
      const Vector3d before = p.reaction;
      p.reaction = p.reaction_at(a);
      if ((p.reaction - before).norm() < 1e-12 * before.norm()) break;
    }
    return a;
  }
  Pendulum stepped(double dt) const {
    const auto moved = [&](const Vector3d& angle, const Vector3d& change) {
      Pendulum p = p_;
      p.turn(angle);
      p.rate += change;
      return p;
    };
    Pendulum p = p_;
    const Vector3d w1 = p.rate, a1 = acceleration(p);
    Pendulum q = moved(dt / 2 * w1, dt / 2 * a1);
    const Vector3d w2 = q.rate, a2 = acceleration(q);
    q = moved(dt / 2 * w2, dt / 2 * a2);
    const Vector3d w3 = q.rate, a3 = acceleration(q);
    q = moved(dt * w3, dt * a3);
    const Vector3d w4 = q.rate, a4 = acceleration(q);
    q = moved(dt / 6 * (w1 + 2 * w2 + 2 * w3 + w4),
              dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4));
    acceleration(q);
    return q;
  }
  std::array<double, 2> indicators() const {
    std::array<double, 2> z;
    it_.call("GetEventIndicators", z.data(), std::size_t{2});
    return z;
  }
  void event() {
    struct {
      int again, end, nominals, values, has_time;
      double time;
    } info;
    do {
      acceleration(p_);
      ASSERT_EQ(it_.call("NewDiscreteStates", &info), 0) << last_message();
      if (it_.flag("holds")) p_.rate.setZero();
    } while (info.again);
    acceleration(p_);
  }
  // One step, or up to the first event in it; the time it took.
  double advance(double dt) {
    // The time to a stop, near which rates turn.
    const double size = acceleration(p_).norm();
    if (size > 0) dt = std::min(dt, 0.2 * p_.rate.norm() / size + 1e-9);
    const auto z = indicators();
    const auto passes = [&](const std::array<double, 2>& now) {
      return (z[0] > 0) != (now[0] > 0) || (z[1] > 0) != (now[1] > 0);
    };
    Pendulum next = stepped(dt);
    const bool is_event = passes(indicators());
    if (is_event) {
      double before = 0;
      while (dt - before > 1e-12) {
        const double middle = (before + dt) / 2;
        next = stepped(middle);
        (passes(indicators()) ? dt : before) = middle;
      }
      next = stepped(dt);
    }
    p_ = next;
    int asks = 0;
    int ends = 0;
    it_.call("CompletedIntegratorStep", 1, &asks, &ends);
    if (is_event || asks) event();
    return dt;
  }
  const Pendulum& pendulum() const { return p_; }

 private:
  const FmuInstance& it_;
  Pendulum p_;
};

// The limit of smaller steps of the page's program is 44.37 s, 0.02 s
// uncertain.
TEST(FmuExchange, PendulumRestsAndLetsGo) {
  const auto fmu = fmu_of(folder + "ball.toml");
  const FmuInstance it(*fmu, FmuInstance::exchange);
  ASSERT_EQ(it.enter(), 0);
  ASSERT_EQ(it.start(), 0);
  Exchange motion(it, Pendulum());
  motion.event();
  double time = 0;
  while (time < 60 && !it.flag("holds")) time += motion.advance(0.01);
  EXPECT_NEAR(time, 44.374, 1e-3);
  const Pendulum rests = motion.pendulum();
  for (int i = 0; i < 100; ++i) motion.advance(0.01);
  EXPECT_EQ(motion.pendulum().attitude.coeffs(), rests.attitude.coeffs());
  EXPECT_LT(it.get("utilisation"), 1);
  EXPECT_GT(it.get("utilisation"), 0);
  // Pushed beyond its limit it slides; pushed less it holds.
  const Vector3d held = -rests.torque();
  for (const double share : {1 - 1e-6, 1 + 1e-6}) {
    const FmuInstance other(*fmu, FmuInstance::exchange);
    other.enter();
    other.start();
    other.set("reaction", rests.reaction);
    struct {
      int again, end, nominals, values, has_time;
      double time;
    } info;
    ASSERT_EQ(other.call("NewDiscreteStates", &info), 0);
    EXPECT_TRUE(info.again && other.flag("holds"));
    other.set("held_moment", share / it.get("utilisation") * held);
    ASSERT_EQ(other.call("NewDiscreteStates", &info), 0);
    EXPECT_EQ(other.flag("holds"), share < 1);
    EXPECT_EQ(info.again != 0, share > 1);
    if (share < 1) continue;
    // The moment at the onset opposes the driving moment.
    EXPECT_LT(
        (other.vector("moment") - share / it.get("utilisation") * held / share)
            .norm(),
        1e-5 * held.norm() / it.get("utilisation"));
  }
}

// A viscous joint holds nothing.
TEST(FmuExchange, ViscousJointNeverRests) {
  fs::create_directories(work());
  const std::string file = work() / "viscous.toml";
  std::ifstream dry(folder + "pin.toml");
  std::string text(std::istreambuf_iterator<char>(dry), {});
  const std::string friction = "coefficient = 0.15";
  text.replace(text.find(friction), friction.size(), "viscous_constant = 1e6");
  std::ofstream(file) << text;
  const auto fmu = fmu_of(file);
  const FmuInstance it(*fmu, FmuInstance::exchange);
  it.enter();
  it.start();
  it.set("reaction", Vector3d(1000, 0, 0));
  it.set("axis", Vector3d(0, 0, 1));
  double last = 0;
  for (const double rate : {-1.0, 0.0, 1.0}) {
    it.set("rate", Vector3d(0, 0, rate));
    int info[8];
    ASSERT_EQ(it.call("NewDiscreteStates", info), 0);
    EXPECT_EQ(info[0], 0);
    EXPECT_FALSE(it.flag("holds"));
    double z[2];
    it.call("GetEventIndicators", z, std::size_t{2});
    EXPECT_GT(z[0], 0);
    EXPECT_LT(z[1], 0);
    const double moment = it.get("moment_z");
    EXPECT_EQ(moment > 0 ? -1 : moment < 0, rate);
    EXPECT_EQ(moment, rate > 0 ? -last : moment);
    last = rate < 0 ? moment : last;
  }
}

}  // namespace
}  // namespace contact::test::fmu_test
