// Keys that are drawn are looked up once: the same as to read the files with
// settings that say so.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "separation/case/force_law.hpp"
#include "study/model/joint_model.hpp"
#include "study/model/separation_model.hpp"
#include "study/plan/design.hpp"
#include "support/error_message.hpp"
#include "support/program.hpp"

namespace contact::test::draws_test {
namespace {

namespace fs = std::filesystem;

const std::string data = CONTACT_DATA_DIR;
const std::string soyuz = "case = '" + data + "/cases/soyuz.toml'";

struct Draw {
  std::string key;
  double number;
  bool relative = false;
  bool each = false;
};

class DrawnKeys : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    folder_.write(name, text);
    return folder_.path() / name;
  }
  study::Plan plan(const std::string& of,
                   const std::vector<Draw>& draws) const {
    std::string text = "name = 's'\nruns = 1\n" + of + '\n';
    for (const Draw& draw : draws) {
      text += "[[dispersion]]\nkey = '" + draw.key +
              "'\nrelative = " + (draw.relative ? "true" : "false") +
              "\neach = " + (draw.each ? "true" : "false") +
              "\nkind = 'uniform'\nlow = 0\nhigh = 1\n";
    }
    return study::read_plan(write("s.toml", text));
  }

  const ProgramFolder folder_;
};

// All numbers to the last bit, or the same message.
std::string text_of(const std::function<study::Result()>& run) {
  study::Result result;
  const std::string message = error_message([&] { result = run(); });
  std::string text = message + result.failure + '\n';
  for (const auto& [name, number] : result.numbers) {
    text += name + '=' + std::to_string(std::bit_cast<std::uint64_t>(number)) +
            '\n';
  }
  return text;
}

// Twice, so that nothing of the first time is left.
void expect_read_alike(const study::Plan& plan, const study::Model& model,
                       const std::vector<Draw>& draws,
                       const std::string& nominal) {
  KeySettings settings;
  std::vector<double> numbers;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    settings.push_back(plan.dispersions[i].setting(draws[i].number));
    numbers.push_back(draws[i].number);
  }
  const auto drawn = [&] {
    return text_of([&] { return model.run(numbers, {}, {}); });
  };
  const std::string anew = text_of([&] { return model.run(settings, {}, {}); });
  EXPECT_EQ(anew, drawn()) << draws[0].key;
  EXPECT_NE(anew, nominal) << draws[0].key;
  if (draws.size() == 1) return;
  EXPECT_EQ(anew, drawn()) << draws[0].key;
}

const std::string hinge = "body[booster].hinge.";
const std::string joint = hinge + "joint[1].";

const std::vector<std::vector<Draw>> case_draws = {
    {{"run.end_time_s", 2}},
    {{"run.relative_tolerance", 1e-7}},
    {{"gravity_m_per_s2[2]", -7}},
    {{"carrier.mass_kg", 95e3}},
    {{"carrier.com_m[1]", 18.1}},
    {{"carrier.principal_inertia_kg_m2", 1.01, true}},
    {{"carrier.direction[axis].vector[2]", 0.001}},
    {{"body[booster].mass_t", 4}},
    {{"body[1].mass_t", 1.01, true}},
    {{"body[booster].com_m[1]", 6.8}},
    {{"body[booster].com_m", 1.01, true}},
    {{"body[booster].principal_inertia_kg_m2[3]", 1.1e5}},
    {{"body[booster].pattern.first_deg", 3}},
    {{"body[booster].pattern.count", 4.5}},  // no such case
    {{"body[booster].shape[1].radius_m", 1.3}},
    {{hinge + "body_point_m[1]", 19.5}},
    {{hinge + "carrier_point_m[2]", 1.61}},
    {{hinge + "zero_rotation_deg[3]", -2.5}},
    {{joint + "geometry.radius_mm", 101}},
    {{joint + "geometry.relative_clearance", 1.1, true}},
    {{joint + "friction.coefficient", 0.13}},
    {{joint + "friction.adhesion_kPa", 21e3}},
    {{joint + "materials.inner.youngs_modulus_GPa", 190}},
    {{joint + "materials.outer.poissons_ratio", 0.9, true}},
    {{"body[booster].lock.body_point_m[2]", -1.1}},
    {{"event[1].time_s", 0.6}},
    {{"event[upper nodes break].angle_deg", 7}},
    {{"force[core engine].thrust_kN", 1.01, true}},
    {{"force[booster engine].decay_s", 0.5}},
    {{"force[booster engine].cutoff_delay_s", 0.1}},
    {{"force[excess thrust].point_m[2]", 0.1}},
    {{"force[nose valve].force_N", 1.1, true}},
    {{"force[nose valve].time_s[3]", 0.9}},
    {{"force[air].dynamic_pressure_Pa", 2500}},
    {{"force[air].normal", 1.1, true}},
    {{"body[booster].mass_t", -1}},  // no such case
    // They have numbers in common.
    {{"body[booster].com_m[1]", 6.5}, {"body[booster].com_m", 1.1, true}},
    {{"body[booster].com_m", 1.1, true}, {"body[booster].com_m[1]", 6.5}},
    {{"body[booster].com_m", 1.1, true},
     {"body[booster].com_m[1]", 1.01, true}},
};

TEST_F(DrawnKeys, OfACaseAreThoseOfReadingAnew) {
  // Until the noses are free.
  std::ifstream file(data + "/cases/soyuz.toml");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("end_time_s = 6", "end_time_s = 2.5");
  replace("../materials", data + "/materials");
  const std::string of = "case = '" + write("c.toml", text) + "'";
  std::string nominal;
  for (const std::vector<Draw>& draws : case_draws) {
    const study::Plan p = plan(of, draws);
    const study::SeparationModel model(p);
    if (nominal.empty()) {
      nominal = text_of([&] { return model.run(KeySettings{}, {}, {}); });
    }
    expect_read_alike(p, model, draws, nominal);
  }
}

// Numbers of a force with a pattern, and of the pattern.
TEST_F(DrawnKeys, OfAPatternOfForces) {
  const std::string text =
      "name = 'c'\nrun = { end_time_s = 0.2 }\n"
      "[carrier]\nname = 'a'\nmass_kg = 5\n"
      "principal_inertia_kg_m2 = [1, 1, 1]\n"
      "[[body]]\nname = 'b'\nmass_kg = 1\ncom_m = [0.1, 0, 0]\n"
      "principal_inertia_kg_m2 = [1, 1, 1]\n"
      "hinge = { kind = 'ball' }\n"
      "[[force]]\nname = 's'\nkind = 'thrust'\nbody = 'b'\n"
      "point_m = [1, 0.1, 0]\ndirection = [1, 0.3, 0.2]\n"
      "thrust_N = 5\nexhaust_speed_m_per_s = 10\npropellant_kg = 0.1\n"
      "pattern = { count = 3, axis = [1, 0, 0] }\n";
  const std::string of = "case = '" + write("c.toml", text) + "'";
  const std::vector<std::vector<Draw>> all = {
      {{"force[s].thrust_N", 6}},
      {{"force[s].pattern.first_deg", 6}},
      {{"force[s].pattern.axis[2]", 0.1}, {"force[s].propellant_kg", 0.05}},
      {{"force[s].propellant_kg", 0.5}}};  // no such case
  for (const std::vector<Draw>& draws : all) {
    const study::Plan p = plan(of, draws);
    const study::SeparationModel model(p);
    expect_read_alike(p, model, draws, text_of([&] {
                        return model.run(KeySettings{}, {}, {});
                      }));
  }
}

// Another number of bodies is another case.
TEST_F(DrawnKeys, ThatChangeTheBodiesReadTheCaseAnew) {
  const std::string text =
      "name = 'c'\nrun = { end_time_s = 0.2 }\n"
      "[carrier]\nname = 'a'\nmass_kg = 5\n"
      "principal_inertia_kg_m2 = [1, 1, 1]\n"
      "[[body]]\nname = 'b'\nmass_kg = 1\ncom_m = [0.5, 0, 0]\n"
      "principal_inertia_kg_m2 = [1, 1, 1]\n"
      "hinge = { kind = 'axis', axis = [0, 0, 1] }\n"
      "start = { rate_deg_per_s = 30 }\n"
      "pattern = { count = 3, axis = [1, 0, 0] }\n"
      "[[force]]\nname = 's'\nkind = 'spring'\nbody = 'b'\n"
      "point_m = [1, 0, 0]\ncarrier_point_m = [0, 1, 0]\n"
      "stiffness_N_per_m = 50\nfree_length_m = 0.5\n";
  const std::string of = "case = '" + write("c.toml", text) + "'";
  const Draw count{"body[b].pattern.count", 4};
  const std::vector<std::vector<Draw>> all = {
      {count},
      {{"body[b].start.rate_deg_per_s", 40}, count},
      {{"body[b].start.rate_rad_per_s", 1}},
      {{"body[b].hinge.axis[1]", 0.1}},
      {{"force[s].stiffness_N_per_m", 60}},
      {{"force[s].damping_N_s_per_m", 2}}};
  for (const std::vector<Draw>& draws : all) {
    const study::Plan p = plan(of, draws);
    const study::SeparationModel model(p);
    expect_read_alike(p, model, draws, text_of([&] {
                        return model.run(KeySettings{}, {}, {});
                      }));
  }
  const study::Plan p = plan(of, {count, {"body[b].mass_kg", 0, false, true}});
  const study::SeparationModel model(p);
  EXPECT_ERROR(
      model.case_of(std::vector<double>{4, 1, 1.1, 1.2}),
      "body[1].pattern.count requires no draws of other keys for each copy");
}

TEST_F(DrawnKeys, OfAJointAreThoseOfReadingAnew) {
  const std::string ball = "joint = '" + data +
                           "/joints/spherical_plain_bearing_infinite.toml'\n"
                           "load = { reaction_kN = 20, beta_deg = 60 }\n";
  for (const Draw& draw :
       std::vector<Draw>{{"geometry.radius_mm", 18},
                         {"geometry.radial_clearance_mm", 0.02},
                         {"geometry.radial_clearance_um", 1.1, true},
                         {"materials.outer.youngs_modulus_GPa", 3},
                         {"friction.coefficient", 0.1},
                         {"load.reaction_N", 21e3},
                         {"load.beta_deg", 1.1, true},
                         {"load.reaction_kN", -1}}) {
    const study::Plan p = plan(ball, {draw});
    const study::JointModel model(p);
    expect_read_alike(p, model, {draw}, text_of([&] {
                        return model.run(KeySettings{}, {}, {});
                      }));
  }
}

// Effect of a force on bodies that stand at the origin.
std::vector<double> effect_of(const separation::Case& c, std::size_t force) {
  const std::vector<multibody::BodyMotion> bodies(
      5, {{0, 0, 0}, {0, 0, 0}, Eigen::Matrix3d::Identity(), {0, 0, 0}});
  std::vector<multibody::BodyForce> forces(5);
  c.forces[force].law->add({c, c.forces[force].body, bodies, 0, 0, INFINITY},
                           forces);
  std::vector<double> all;
  for (const auto& f : forces) {
    for (const Eigen::Vector3d& v : {f.force, f.moment}) {
      all.insert(all.end(), v.begin(), v.end());
    }
  }
  return all;
}

// Each copy has the numbers of its draws, and so have all forces on it: a
// centre of mass moves where they act.
TEST_F(DrawnKeys, OfCopiesAreThoseOfACaseWithTheDrawsOfTheCopy) {
  const std::vector<std::vector<double>> numbers = {
      {6.8, 6.9, 7.0, 7.1}, {590, 600, 610, 620}, {95}};
  const study::Plan p =
      plan(soyuz, {{"body[booster].com_m[1]", 0, false, true},
                   {"force[booster engine].thrust_kN", 0, false, true},
                   {"carrier.mass_t", 0}});
  const study::SeparationModel model(p);
  const separation::Case c = model.case_of(
      std::vector<double>{6.8, 6.9, 7.0, 7.1, 590, 600, 610, 620, 95});
  for (std::size_t copy = 0; copy < 4; ++copy) {
    KeySettings settings;
    for (std::size_t i = 0; i < 3; ++i) {
      settings.push_back(
          p.dispersions[i].setting(numbers[i][i == 2 ? 0 : copy]));
    }
    const separation::Case of_copy = model.case_of(settings);
    EXPECT_EQ(c.carrier.mass, of_copy.carrier.mass);
    EXPECT_EQ(c.bodies[copy].rigid.com, of_copy.bodies[copy].rigid.com);
    EXPECT_EQ(c.bodies[copy].hinge.body_point,
              of_copy.bodies[copy].hinge.body_point);
    EXPECT_EQ(c.bodies[copy].lock->body_point,
              of_copy.bodies[copy].lock->body_point);
    for (std::size_t force = 0; force < c.forces.size(); ++force) {
      if (c.forces[force].body != static_cast<int>(copy) + 1) continue;
      EXPECT_EQ(effect_of(c, force), effect_of(of_copy, force))
          << c.forces[force].name << ' ' << copy;
    }
  }
}

// Laws that a case has in addition to the nominal one; laws with walls use
// tables.
std::size_t laws_made(const study::SeparationModel& model,
                      const separation::Case& c) {
  std::set<const void*> nominal;
  std::set<const void*> all;
  const auto add = [](const separation::Case& of, std::set<const void*>& to) {
    for (const separation::Body& body : of.bodies) {
      for (const separation::HingeJoint& one : body.hinge.joints) {
        to.insert(&one.contact().half_angle_law());
        to.insert(&one.contact().pressure_law());
      }
    }
  };
  add(model.case_of(KeySettings{}), nominal);
  add(c, all);
  std::erase_if(all, [&](const void* law) { return nominal.contains(law); });
  return all.size();
}

// Keys that change neither walls nor materials leave the laws as they are, and
// copies that are alike share those that are made.
TEST_F(DrawnKeys, MakeNoLawsButThoseTheyChange) {
  const std::string text =
      "name = 'c'\nrun = { end_time_s = 0.2 }\n"
      "[carrier]\nname = 'a'\nmass_kg = 5\n"
      "principal_inertia_kg_m2 = [1, 1, 1]\n"
      "[[body]]\nname = 'b'\nmass_kg = 1\ncom_m = [0.5, 0, 0]\n"
      "principal_inertia_kg_m2 = [1, 1, 1]\n"
      "pattern = { count = 3, axis = [1, 0, 0] }\n"
      "[body.hinge]\nkind = 'ball'\n"
      "[[body.hinge.joint]]\nname = 'lined'\nfile = '" +
      data + "/joints/spherical_plain_bearing.toml'\n";
  const std::string of = "case = '" + write("c.toml", text) + "'";
  const std::string in = "body[b].hinge.joint[1].";
  const auto made = [&](const std::string& key,
                        const std::vector<double>& numbers) {
    const study::Plan p = plan(of, {{key, 0, false, numbers.size() > 1}});
    const study::SeparationModel model(p);
    return laws_made(model, model.case_of(numbers));
  };
  EXPECT_EQ(made("carrier.mass_kg", {6}), 0u);
  EXPECT_EQ(made("body[b].mass_kg", {1, 2, 3}), 0u);
  EXPECT_EQ(made(in + "friction.coefficient", {0.05, 0.06, 0.07}), 0u);
  EXPECT_EQ(made(in + "geometry.radial_clearance_um", {10, 15, 20}), 0u);
  // Half-angle and pressure.
  EXPECT_EQ(made(in + "wall.layer[1].thickness_mm", {0.5}), 2u);
  EXPECT_EQ(made(in + "wall.layer[1].thickness_mm", {0.4, 0.5, 0.6}), 4u);
  EXPECT_EQ(made(in + "materials.outer.youngs_modulus_GPa", {3.5}), 2u);
}

}  // namespace
}  // namespace contact::test::draws_test
