#include "multibody/dynamics/dynamics.hpp"

namespace multibody {
namespace {

// Lanes that few bodies cannot fill cost more than they bring (measured).
contact::InstructionSet useful(contact::InstructionSet set,
                               const SystemConstants& constants) {
  return constants.size() <= 1 ? contact::InstructionSet::baseline : set;
}

}  // namespace

Dynamics::Dynamics(const System& system, contact::InstructionSet set)
    : constants_(std::make_unique<SystemConstants>(system)),
      kernel_(
          detail::make_dynamics_kernel(*constants_, useful(set, *constants_))) {
  for (const Link& link : system.links()) {
    kinds_.push_back(link.kind);
    modes_.push_back(link.kind == HingeKind::none ? JointMode::released
                                                  : JointMode::turning);
  }
  layout_ = StateLayout(kinds_, modes_);
}

void Dynamics::set_mode(int body, JointMode mode) {
  assert(kinds_[body] != HingeKind::none || mode == JointMode::released);
  modes_[body] = mode;
  layout_ = StateLayout(kinds_, modes_);
  kernel_->set_mode(body, mode);
}

void Dynamics::evaluate(const double* state,
                        const ActiveForces<double>& forces) {
  assert(static_cast<int>(forces.bodies.size()) == size());
  assert(constants_->carrier_mass() > 0);
  kernel_->evaluate(state, forces.carrier, forces.bodies.data());
}

void Dynamics::evaluate_prescribed(const double* state,
                                   const ActiveForces<double>& forces,
                                   const CarrierAcceleration<double>& carrier) {
  assert(static_cast<int>(forces.bodies.size()) == size());
  kernel_->evaluate_prescribed(state, forces.bodies.data(), carrier);
}

}  // namespace multibody
