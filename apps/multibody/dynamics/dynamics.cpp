#include "multibody/dynamics/dynamics.hpp"

#include <cassert>

#include "multibody/dynamics/kernel/dynamics_kernel.hpp"
#include "multibody/system/constants.hpp"

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

Dynamics::~Dynamics() = default;
Dynamics::Dynamics(Dynamics&&) noexcept = default;
Dynamics& Dynamics::operator=(Dynamics&&) noexcept = default;

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

void Dynamics::add_friction(std::span<const Vec3<double>> change) {
  assert(static_cast<int>(change.size()) == size());
  kernel_->add_friction(change.data());
}
void Dynamics::add_friction(const VectorRows& change) {
  kernel_->add_friction(change);
}

const CarrierAcceleration<double>& Dynamics::carrier() const {
  return kernel_->carrier();
}
Vec3<double> Dynamics::relative_acceleration(int body) const {
  return kernel_->relative_acceleration(body);
}
void Dynamics::relative_accelerations(std::span<Vec3<double>> to) const {
  assert(static_cast<int>(to.size()) == size());
  kernel_->relative_accelerations(to.data());
}
Vec3<double> Dynamics::angular_acceleration(int body) const {
  return kernel_->angular_acceleration(body);
}
void Dynamics::rates(const double* state, const Vec3<double>& gravity,
                     double* to) const {
  kernel_->rates(state, gravity, to);
}
void Dynamics::reactions(std::span<Reaction<double>> to) const {
  assert(static_cast<int>(to.size()) == size());
  kernel_->reactions(to.data());
}
void Dynamics::forces(const VectorRows& to) const { kernel_->forces(to); }
Mat3<double> Dynamics::axes(int body) const { return kernel_->axes(body); }

}  // namespace multibody
