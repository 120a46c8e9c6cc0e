// A host's floating-point environment: what it traps, how it rounds and its
// flags are its own after every call, and change no number.
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "c/run_door.hpp"
#include "c/trapping_host.hpp"

namespace contact::test::float_environment_test {
namespace {

using contact::test::CJoint;
using contact::test::TrappingHost;

using Numbers = std::vector<double>;

const contact_slip slip = {{100, 300, 2000}, {.3, .2, 1}, {}};
const double unit[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

Numbers of(const contact_solution& s) { return {&s.residual, s.memory}; }

Numbers solved(const contact_joint* joint) {
  contact_solution s;
  contact_joint_solve(joint, &slip, nullptr, &s);
  Numbers all = of(s);
  double pv = 0;
  contact_rating_get(joint, &slip, &s, "pv_max", &pv);
  all.push_back(pv);
  contact_derivatives d = {};
  contact_joint_derivatives(joint, &slip, &s, &d);
  all.insert(all.end(), d.over_rate, d.over_rate + 9);
  return all;
}

Numbers at_rest(const contact_joint* joint) {
  const contact_hold hold = {{100, 300, 2000}, {.01, .02, .1}, {}};
  contact_rest rest;
  contact_joint_at_rest(joint, &hold, nullptr, &rest);
  Numbers all = of(rest.slip);
  all.push_back(rest.utilisation);
  return all;
}

Numbers stepped(const contact_joint* joint) {
  const contact_step_start start = {
      {100, 300, 2000}, {.3, .2, 1}, {.2, .2, .9}, {0, 0, 1}};
  contact_step step;
  contact_joint_step(joint, &start, unit, nullptr, &step);
  Numbers all = of(step.solution);
  all.insert(all.end(), step.moment, step.moment + 3);
  return all;
}

Numbers contact_of(const contact_joint* joint) {
  contact_patch patch = {};
  contact_joint_patch(joint, 2e3, &patch);
  contact_friction friction = {};
  contact_joint_friction(joint, patch.half_angle, .3, &friction);
  Numbers all = {patch.half_angle, patch.peak_pressure,
                 friction.coefficient[0]};
  all.resize(6);
  contact_joint_normal_force(joint, patch.half_angle, &all[3]);
  contact_joint_approach(joint, 2e3, &all[4], &all[5]);
  return all;
}

Numbers impact_of(const contact_joint* joint) {
  contact_play_options options = {};
  options.restitution = .7;
  options.reference_speed = .1;
  contact_play* play = nullptr;
  if (contact_play_make(joint, &options, &play) != CONTACT_OK) return {};
  contact_impact impact = {};
  contact_play_impact(play, 1, .1, &impact);
  contact_play_free(play);
  return {impact.restitution, impact.penetration};
}

constexpr std::pair<const char*, Numbers (*)(const contact_joint*)> doors[] = {
    {"solve", solved},
    {"at_rest", at_rest},
    {"step", stepped},
    {"contact", contact_of},
    {"impact", impact_of}};

/// Numbers of a call by a host that traps are those by any other.
template <class Call>
void expect_kept(const Call& call, const std::string& name) {
  const Numbers wanted = call();
  Numbers found;
  bool kept = false;
  {
    const TrappingHost host;
    found = call();
    kept = host.is_kept();
  }
  EXPECT_TRUE(kept) << name;
  ASSERT_EQ(found.size(), wanted.size()) << name;
  EXPECT_EQ(
      std::memcmp(found.data(), wanted.data(), found.size() * sizeof(double)),
      0)
      << name;
}

TEST(CFloatEnvironment, IsTheHostsAgainAfterEveryCall) {
  namespace fs = std::filesystem;
  int count = 0;
  for (const auto& entry : fs::directory_iterator(CONTACT_DATA_DIR "/joints")) {
    const std::string file = entry.path();
    expect_kept(
        [&] {
          contact_joint* joint = nullptr;
          contact_joint_read(file.c_str(), nullptr, 0, &joint);
          contact_joint_size size = {};
          contact_joint_get_size(joint, &size);
          contact_joint_free(joint);
          return Numbers{size.radius, size.effective_modulus};
        },
        file + ": read");
    const CJoint joint = contact::test::c_joint(file);
    for (const auto& [name, door] : doors) {
      expect_kept([&] { return door(joint.get()); }, file + ": " + name);
    }
    ++count;
  }
  EXPECT_GT(count, 10);
}

TEST(CFloatEnvironment, OfRunsIsTheHostsAgain) {
  for (const char* const name : {"two_stage_turn", "gimbal"}) {
    const std::string file =
        std::string(CONTACT_DATA_DIR "/cases/") + name + ".toml";
    expect_kept(
        [&] {
          contact_run* run = nullptr;
          contact_run_open(file.c_str(), nullptr, 0, &run);
          contact_run_advance(run, .05);
          Numbers all(contact_run_column_count(run));
          contact_run_values(run, all.data(), all.size());
          contact_run_free(run);
          return all;
        },
        file);
  }
}

}  // namespace
}  // namespace contact::test::float_environment_test
