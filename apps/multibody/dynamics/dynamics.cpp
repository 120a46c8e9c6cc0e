#include "multibody/dynamics/dynamics.hpp"

#include "multibody/dynamics/tree_kernel.hpp"

namespace multibody {
namespace {

// Wide lanes that few bodies cannot fill cost more than they gain (measured).
contact::InstructionSet useful(contact::InstructionSet set,
                               const SystemConstants& constants) {
  return constants.size() <= 1 ? contact::InstructionSet::baseline : set;
}

}  // namespace

Dynamics::Dynamics(const System& system, contact::InstructionSet set)
    : constants_(std::make_unique<SystemConstants>(system)) {
  if (system.is_star()) {
    kernel_ =
        detail::make_dynamics_kernel(*constants_, useful(set, *constants_));
  } else {
    auto tree = std::make_unique<detail::TreeKernel>(system, set);
    tree_ = tree.get();
    kernel_ = std::move(tree);
  }
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

void Dynamics::set_mass(const System& system, const BodyMass& mass) {
  assert(tree_);
  const Eigen::Matrix3d axes =
      mass.body == 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
                     : system.links()[mass.body - 1].axes;
  tree_->forest().set_mass(mass.body, mass.mass, axes.transpose() * mass.com,
                           axes.transpose() * mass.inertia * axes);
}

void Dynamics::fitting_moments(std::span<const Vec3<double>> moments,
                               std::span<const Eigen::Matrix3d> slopes,
                               std::span<Vec3<double>> to) {
  assert(tree_);
  tree_->fitting_moments(moments, slopes, to);
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
