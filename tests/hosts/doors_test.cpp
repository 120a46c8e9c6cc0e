// The same joint file gives the same moment at every door.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cstdlib>
#include <fstream>
#include <limits>

#include "hosts/doors.hpp"
#include "hosts/fmu_importer.hpp"
#include "hosts/joint_handle.hpp"
#include "libcontact/files.hpp"

namespace contact::test::doors_test {
namespace {

using Eigen::Vector3d;
using Moments = std::vector<Vector3d>;
using Rows = std::vector<DoorRow>;

Vector3d vector(const Three& v) { return Vector3d(v.data()); }

Moments by_cpp(const std::string& file, const Rows& rows) {
  const Joint joint(read_joint(file));
  Moments all;
  for (const DoorRow& r : rows) {
    all.push_back(joint
                      .solve({.reaction = vector(r.reaction),
                              .angular_velocity = vector(r.rate),
                              .axis = vector(r.axis)})
                      .friction_moment);
  }
  return all;
}

Moments by_c(const std::string& file, const Rows& rows) {
  contact_joint* joint = nullptr;
  contact_hosts::must(contact_joint_read(file.c_str(), nullptr, 0, &joint));
  Moments all;
  for (const DoorRow& r : rows) {
    contact_slip slip;
    std::ranges::copy(r.reaction, slip.reaction);
    std::ranges::copy(r.rate, slip.angular_velocity);
    std::ranges::copy(r.axis, slip.axis);
    contact_solution s;
    contact_hosts::must(contact_joint_solve(joint, &slip, nullptr, &s));
    all.emplace_back(s.friction_moment);
  }
  contact_joint_free(joint);
  return all;
}

// Tests may run side by side.
fs::path work(const std::string& name) {
  const fs::path folder =
      fs::path(testing::TempDir()) / "contact_doors" /
      testing::UnitTest::GetInstance()->current_test_info()->name();
  fs::create_directories(folder);
  return folder / name;
}

void run(const std::string& command) {
  if (std::system(command.c_str()) != 0) throw std::runtime_error(command);
}

Moments by_fmu(const std::string& file, const Rows& rows, int version,
               FmuInstance::Use use) {
  const fs::path zip = work("it.fmu");
  run(std::string(CONTACT_PROGRAMS "/hinge-fmu '") + file + "' --fmi " +
      std::to_string(version) + " --output '" + zip.string() + "'");
  const Fmu fmu(zip, work("unzipped"));
  const FmuInstance it(fmu, use);
  it.enter();
  Moments all;
  for (const DoorRow& r : rows) {
    it.set("reaction", vector(r.reaction));
    it.set("rate", vector(r.rate));
    it.set("axis", vector(r.axis));
    all.push_back(it.vector("moment"));
  }
  return all;
}

#ifdef CONTACT_PYTHON
Moments by_python(const std::string& file, const Rows& rows) {
  const fs::path in = work("in.txt");
  const fs::path out = work("out.txt");
  std::ofstream text(in);
  text.precision(std::numeric_limits<double>::max_digits10);
  for (const DoorRow& r : rows) {
    for (const Three& v : {r.reaction, r.rate, r.axis}) {
      text << v[0] << ' ' << v[1] << ' ' << v[2] << ' ';
    }
    text << '\n';
  }
  text.close();
  run(std::string(CONTACT_PYTHON
                  " -c '"
                  "import sys, libcontact, numpy as np\n"
                  "joint = libcontact.Joint.from_file(sys.argv[1])\n"
                  "R, w, axis = np.loadtxt(sys.argv[2]).reshape(-1, 3, 3)"
                  ".swapaxes(0, 1)\n"
                  "axis = axis if axis.any() else None\n"
                  "M = joint.solve(R, w, axis=axis).friction_moment\n"
                  "np.savetxt(sys.argv[3], M, fmt=\"%.17g\")' '") +
      file + "' '" + in.string() + "' '" + out.string() + "'");
  std::ifstream said(out);
  Moments all;
  for (Vector3d m; said >> m.x() >> m.y() >> m.z();) all.push_back(m);
  return all;
}
#endif

// Random states with the moments of C++, for machines without a simulator.
Rows drawn_rows(const std::string& file, bool pin, int count) {
  std::srand(1);
  Rows rows(count);
  for (DoorRow& r : rows) {
    const Vector3d axis =
        pin ? Vector3d(0.36, 0.48, 0.8) : Vector3d(Vector3d::Zero());
    const Vector3d rate = Vector3d::Random();
    Vector3d::Map(r.reaction.data()) = 1000 * Vector3d::Random();
    Vector3d::Map(r.axis.data()) = axis;
    Vector3d::Map(r.rate.data()) = pin ? Vector3d(rate.x() * axis) : rate;
  }
  const Moments moments = by_cpp(file, rows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Vector3d::Map(rows[i].moment.data()) = moments[i];
  }
  return rows;
}

void expect_same(const Moments& moments, const Rows& rows, const char* door,
                 const char* states) {
  ASSERT_EQ(moments.size(), rows.size()) << door;
  double worst = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Vector3d wanted = vector(rows[i].moment);
    ASSERT_GT(wanted.norm(), 0);
    worst = std::max(worst, (moments[i] - wanted).norm() / wanted.norm());
  }
  EXPECT_LT(worst, 1e-12) << door << " at the states of " << states;
  testing::Test::RecordProperty(std::string(states) + " " + door,
                                std::to_string(worst * 1e15) + "e-15");
}

class Doors : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(BallAndPin, Doors, testing::Bool());

TEST_P(Doors, GiveTheSameMoment) {
  const bool pin = GetParam();
  const std::string file =
      std::string(CONTACT_HOST_TESTS) + (pin ? "pin.toml" : "ball.toml");
  constexpr int count = 1000;
  std::vector<std::pair<const char*, Rows>> all = {
      {"none", drawn_rows(file, pin, count)}};
#ifdef CONTACT_HAS_mujoco
  all.emplace_back("MuJoCo", mujoco_rows(file, pin, count));
#endif
#ifdef CONTACT_HAS_simbody
  all.emplace_back("Simbody", simbody_rows(file, pin, count));
#endif
  for (const auto& [states, rows] : all) {
    expect_same(by_cpp(file, rows), rows, "C++", states);
    expect_same(by_c(file, rows), rows, "C", states);
    expect_same(by_fmu(file, rows, 2, FmuInstance::steps), rows, "FMI 2.0 CS",
                states);
    expect_same(by_fmu(file, rows, 2, FmuInstance::exchange), rows,
                "FMI 2.0 ME", states);
    expect_same(by_fmu(file, rows, 3, FmuInstance::steps), rows, "FMI 3.0",
                states);
#ifdef CONTACT_PYTHON
    expect_same(by_python(file, rows), rows, "Python", states);
#endif
  }
}

}  // namespace
}  // namespace contact::test::doors_test
