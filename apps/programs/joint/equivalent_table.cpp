#include "programs/joint/equivalent_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/output.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/report.hpp"
#include "cli/sweep.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/identify/equivalent.hpp"
#include "libcontact/joint/presliding/stuck_joint.hpp"
#include "libcontact/load_law/load_law.hpp"

namespace hinge_joint {
namespace {

using contact::EquivalentFriction;
using contact::LeastWrong;

// f0 of the only joint.
double coefficient_of(const Setup& setup) {
  if (setup.joints.size() != 1) {
    cli::refuse_without("--equivalent",
                        "one joint, one law and one pressure law");
  }
  const auto* dry = std::get_if<contact::FrictionLaw>(
      &setup.joints[0].joint.contact().friction());
  if (dry == nullptr || dry->coefficient() == 0) {
    cli::refuse_without("--equivalent",
                        "dry friction with a coefficient above 0");
  }
  return dry->coefficient();
}

std::vector<contact::Joint::Slip> states_of(const Inputs& inputs) {
  std::vector<contact::Joint::Slip> states;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Input input = inputs[i];
    states.push_back({.reaction = input.force, .angular_velocity = input.turn});
  }
  return states;
}

std::vector<double> values_of(const cli::Sweep& sweep) {
  std::vector<double> values;
  for (std::size_t i = 0; i < sweep.size(); ++i) values.push_back(sweep[i]);
  return values;
}

// Adds the range of states for the errors.
void add_range(const Inputs& inputs, bool pin, cli::Report& to) {
  const auto add = [&](std::string_view least, std::string_view most,
                       const cli::Sweep& sweep, std::string_view meaning) {
    const auto [low, high] = std::ranges::minmax(values_of(sweep));
    to.add(least, low, meaning);
    to.add(most, high, meaning);
  };
  add("least_R_N", "largest_R_N", *inputs.forces(),
      "range of loads that errors are over");
  if (!pin) {
    add("least_b_deg", "largest_b_deg", *inputs.angles(),
        "range of angles between R and Dw");
  }
  to.add("states", inputs.size(), "in these ranges");
}

// Names of a radius, which differ for pins and balls.
struct RadiusNames {
  std::string_view radius;
  std::string_view with_preload;
  std::string_view meaning;
};
constexpr RadiusNames pin_names = {
    "pin_radius_m", "pin_radius_with_preload_m",
    "Adams and MotionSolve pin radius, DoorBench r_pin: M = mu Rp R"};
constexpr RadiusNames ball_names = {
    "ball_radius_m", "ball_radius_with_preload_m",
    "Adams and MotionSolve ball radius: M = mu Rb R"};

void add_numbers(const EquivalentFriction& e, double f0,
                 const RadiusNames& names, cli::Report& to) {
  const auto add = [&](std::string_view name, const LeastWrong& number,
                       double unit, std::string_view meaning) {
    to.add(name, number.value / unit, meaning, {number.largest_error});
  };
  to.add("mu", f0, "coefficient, static and dynamic, beside these radii");
  add(names.radius, e.arm, f0, names.meaning);
  add(names.with_preload, e.arm_with_preload, f0,
      "the same beside the next: M = T0 + mu R Rp or Rb");
  add("torque_preload_N_m", {e.preload, e.arm_with_preload.largest_error}, 1,
      "T0, friction torque preload");
  add("coefficient_per_axis_m", e.arm_per_axis, 1,
      "PhysX friction coefficient before 5.6: |M_i| <= c R about each axis");
  add("torque_per_axis_N_m", e.moment_per_axis, 1,
      "MuJoCo frictionloss, PhysX friction effort, Webots staticFriction, "
      "Drake: |M_i| <= T");
}

// Contacts whose centres do not shift have no stiction parameters.
void add_stiction(const contact::Joint& joint,
                  std::span<const contact::Joint::Slip> states,
                  cli::Report& to) {
  const LeastWrong way = equivalent_stiction(joint, states);
  if (std::isnan(way.value)) return;
  to.add("presliding_angle_rad",
         way.value / joint.contact().geometry().radius(),
         "LuGre, Dahl, MuJoCo dcmotor: sigma0 = M_s(R)/z_ss with this z_ss, an "
         "angle instead of a stiffness; metal within 21 %, lined seats 1.2 to "
         "4 times as much",
         {way.largest_error});
  to.add("stiction_deformation_m", way.value,
         "Adams and MotionSolve maximum stiction deformation; of the contact "
         "alone, smooth and dry, at a constant load: the shaft and housing "
         "beside it are of the same order or softer",
         {way.largest_error});
}

// Adds the stuck contact at the largest load.
void add_stuck(const Setup& setup, std::span<const contact::Joint::Slip> states,
               cli::Report& to) {
  const contact::Joint& joint = setup.joints[0].joint;
  const auto largest = std::ranges::max_element(
      states, {}, [](const auto& s) { return s.reaction.norm(); });
  const contact::JointSolution s = joint.solve(*largest);
  const contact::JointSpec& spec = setup.given[0].spec;
  const contact::StuckJoint stuck =
      stuck_joint(spec, joint.contact(), s.normal_force, s.half_angle);
  if (std::isnan(stuck.load_stiffness)) return;
  const auto add = [&](std::string_view name, double value,
                       std::string_view meaning) {
    if (!std::isnan(value)) to.add(name, value, meaning);
  };
  add("K_load_N_m_per_rad", stuck.load_stiffness,
      "of the stuck contact at largest_R_N, which stays: across the load");
  add("K_held_N_m_per_rad", stuck.held_stiffness,
      "the same with the centre held");
  add("K_spin_N_m_per_rad", stuck.spin_stiffness,
      "the same about the load; also sigma0 of LuGre for spinning");
  add("sigma0_N_m_per_rad", stuck.lugre_stiffness(),
      "plain LuGre and dcmotor at largest_R_N: turns as far at M_s/2");
  add("dahl_exponent", stuck.dahl_exponent(),
      "Dahl and elastoplastic LuGre beside sigma0 = K_load");
  add("breakaway_angle_rad", stuck.breakaway_angle(),
      "turn at which the joint slides at largest_R_N");
  for (const std::string& note : stuck_notes(spec, s.half_angle)) {
    cli::warn("hinge-joint", note);
  }
}

// Pins in unbounded holes and pins with interference have no bending arm,
// because their tilt is not known.
void add_bending(const Setup& setup, const Inputs& inputs, double arm,
                 cli::Report& to) {
  contact::JointSpec pin = setup.given[0].spec;
  pin.friction = setup.joints[0].joint.contact().friction();
  try {
    const LeastWrong bending = equivalent_bending_arm(
        pin, values_of(*inputs.forces()), pin.geometry.length(), arm);
    to.add("bending_arm_m", bending.value,
           "Adams and MotionSolve bending reaction arm: M = mu Rp (R + T/Rb), "
           "R up to the pin's length off its middle",
           {bending.largest_error});
  } catch (const contact::Error& error) {
    cli::warn("hinge-joint",
              fmt::format("bending_arm_m is left out: {}", error.what()));
  }
}

// For a clearance without adhesion one line fits every load.
void add_load_law(const contact::Joint& joint, cli::Report& to) {
  const contact::PinLoadLaw law = pin_load_law(joint, 1);
  if (law.form != contact::PinLoadLaw::Form::clearance) return;
  to.add("load_law_R0_N", law.scale,
         "load law, at every load: M = rho mu N (c0 + c1 u + c2 u^2 + c3 u^3), "
         "u = N/(N + R0), N = R/sqrt(1 + mu^2)",
         {law.error});
  for (std::size_t i = 0; i < law.numbers.size(); ++i) {
    to.add(fmt::format("load_law_c{}", i), law.numbers[i], "", {law.error});
  }
}

}  // namespace

cli::ExitStatus write_equivalent(const Setup& setup, const Inputs& inputs,
                                 const cli::OutputOptions& options) {
  const double f0 = coefficient_of(setup);
  const contact::Joint& joint = setup.joints[0].joint;
  const bool pin = joint.is_pin();
  const auto states = states_of(inputs);
  const EquivalentFriction e = equivalent_friction(joint, states);
  cli::Report report({{"largest_error"}});
  add_range(inputs, pin, report);
  add_numbers(e, f0, pin ? pin_names : ball_names, report);
  add_stiction(joint, states, report);
  add_stuck(setup, states, report);
  if (pin) {
    add_load_law(joint, report);
    add_bending(setup, inputs, e.arm.value, report);
  }
  cli::Output output(options.output);
  report.write(output, options.titled(shared_title(setup.given, "")));
  output.commit();
  return cli::all_good;
}

cli::ExitStatus write_kernel(const Options& options, const Setup& setup) {
  if (setup.joints.size() != 1) {
    cli::refuse_without("--kernel", "one joint, one law and one pressure law");
  }
  contact::LoadLawOptions kernel = options.kernel;
  kernel.joint = setup.given[0].spec.name;
  if (!options.reaction.empty()) {
    const cli::Sweep loads("--reaction", options.reaction, allowed_force,
                           contact::Dimension::force);
    double low = loads[0];
    double high = loads[0];
    for (std::size_t i = 1; i < loads.size(); ++i) {
      low = std::min(low, loads[i]);
      high = std::max(high, loads[i]);
    }
    kernel.loads = {low, high};
  }
  const contact::LoadLawText law = load_law_text(setup.joints[0].joint, kernel);
  warn_of_validity("hinge-joint", setup.given);
  cli::Output output(options.output.output);
  output.write(law.text);
  output.commit();
  return cli::all_good;
}

}  // namespace hinge_joint
