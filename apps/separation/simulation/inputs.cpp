#include "separation/simulation/inputs.hpp"

#include <fmt/format.h>

#include "separation/simulation/case_forces.hpp"

namespace separation {
namespace {

using Kind = Input::Kind;

/// What a body may be given.
struct Place {
  Kind kind;
  const char* name;  // with the letter of the component
  int components;
};
constexpr Place places[] = {
    {Kind::force, "applied_force_{}_N", 3},
    {Kind::moment, "applied_moment_{}_N_m", 3},
    {Kind::hinge_moment, "applied_hinge_moment_N_m", 1},
};

bool takes(const Case& c, int body, Kind kind) {
  if (kind == Kind::hinge_moment) {
    return body > 0 &&
           c.bodies[body - 1].hinge.kind == multibody::HingeKind::axis;
  }
  return body > 0 || (!c.carrier.fixed && !c.options.carrier_drive);
}

}  // namespace

std::vector<Input> inputs_of(const Case& c) {
  std::vector<Input> inputs;
  for (int body = 0; body <= static_cast<int>(c.bodies.size()); ++body) {
    const std::string of = column_name(c.rigid_body(body).name) + '.';
    for (const Place& place : places) {
      if (!takes(c, body, place.kind)) continue;
      for (int i = 0; i < place.components; ++i) {
        inputs.push_back(
            {body, place.kind, i,
             of + fmt::format(fmt::runtime(place.name), "xyz"[i])});
      }
    }
  }
  return inputs;
}

GivenLoads::GivenLoads(const Case& c, const History& history) : case_(c) {
  const std::vector<Input> inputs =
      history.inputs.empty() ? std::vector<Input>() : inputs_of(c);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto& [body, kind, component, name] = inputs[i];
    const double value = history.inputs[i];
    if (value == 0) continue;
    if (kind == Kind::hinge_moment) {
      if (history.release_of(body, c) != History::not_yet) continue;
      loads_.push_back({body, kind, value * c.bodies[body - 1].hinge.axis});
    } else {
      loads_.push_back({body, kind, value * Eigen::Vector3d::Unit(component)});
    }
  }
}

void GivenLoads::add_forces(std::span<const multibody::BodyMotion> bodies,
                            std::span<multibody::BodyForce> forces) const {
  for (const auto& [body, kind, value] : loads_) {
    if (kind == Kind::hinge_moment) {
      const int on = case_.bodies[body - 1].hinge.on;
      const Eigen::Vector3d moment = bodies[on].rotation * value;
      forces[body].moment += moment;
      forces[on].moment -= moment;
      continue;
    }
    const Eigen::Vector3d load = bodies[body].rotation * value;
    (kind == Kind::force ? forces[body].force : forces[body].moment) += load;
  }
}

}  // namespace separation
