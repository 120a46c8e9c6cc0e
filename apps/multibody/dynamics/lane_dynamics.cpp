#include "multibody/dynamics/lane_dynamics.hpp"

#include <fmt/format.h>

#include <cassert>

#include "libcontact/base/error.hpp"
#include "multibody/dynamics/kernel/lane_kernel.hpp"
#include "multibody/system/constants.hpp"

namespace multibody {

LaneDynamics::LaneDynamics(const System& system, contact::InstructionSet set) {
  initialise({&system, 1}, set);
}

LaneDynamics::LaneDynamics(std::span<const System> systems,
                           contact::InstructionSet set) {
  const std::size_t lanes = detail::lane_width(set);
  if (systems.size() != lanes) {
    throw contact::Error(fmt::format(
        "lanes: {} systems, allowed is one for each of the {} lanes",
        systems.size(), lanes));
  }
  for (const System& system : systems) {
    bool same = system.size() == systems[0].size();
    for (int i = 0; same && i < system.size(); ++i) {
      same = system.links()[i].kind == systems[0].links()[i].kind;
    }
    if (!same) {
      throw contact::Error(
          "lanes: systems differ in their loads, allowed are differences in "
          "numbers");
    }
  }
  initialise(systems, set);
}

void LaneDynamics::initialise(std::span<const System> systems,
                              contact::InstructionSet set) {
  lanes_ = detail::lane_width(set);
  std::vector<const SystemConstants*> pointers;
  for (const System& system : systems) {
    constants_.push_back(std::make_unique<SystemConstants>(system));
    pointers.push_back(constants_.back().get());
  }
  kernel_ = detail::make_lane_kernel(pointers.data(), systems.size() == 1, set);
  for (const Link& link : systems[0].links()) {
    kinds_.push_back(link.kind);
    modes_.push_back(link.kind == JointKind::none ? JointMode::released
                                                  : JointMode::turning);
  }
  layout_ = StateLayout(kinds_, modes_);
}

LaneDynamics::~LaneDynamics() = default;
LaneDynamics::LaneDynamics(LaneDynamics&&) noexcept = default;
LaneDynamics& LaneDynamics::operator=(LaneDynamics&&) noexcept = default;

int LaneDynamics::lanes(contact::InstructionSet set) {
  return detail::lane_width(set);
}

void LaneDynamics::set_mode(int load, JointMode mode) {
  assert(kinds_[load] != JointKind::none || mode == JointMode::released);
  modes_[load] = mode;
  layout_ = StateLayout(kinds_, modes_);
  kernel_->set_mode(load, mode);
}

void LaneDynamics::evaluate(const double* state, const double* loading) {
  kernel_->evaluate(state, loading);
}
void LaneDynamics::add_friction(const double* change) {
  kernel_->add_friction(change);
}
void LaneDynamics::accelerations(double* to) const {
  kernel_->accelerations(to);
}
void LaneDynamics::reactions(double* to) const { kernel_->reactions(to); }
void LaneDynamics::rates(const double* state, const double* gravity,
                         double* to) const {
  kernel_->rates(state, gravity, to);
}

}  // namespace multibody
