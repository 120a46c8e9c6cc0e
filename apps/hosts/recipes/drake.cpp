// Friction in a revolute joint of a discrete MultibodyPlant of Drake.
//
//     auto* friction = builder.AddSystem<HingeFriction>(plant, joint,
//     "pin.toml"); builder.Connect(plant.get_state_output_port(),
//     friction->get_input_port(0));
//     builder.Connect(plant.get_reaction_forces_output_port(),
//                     friction->get_input_port(1));
//     builder.Connect(friction->get_output_port(),
//                     plant.get_applied_generalized_force_input_port());
//
// The reaction is that of the step before, kept as state: the plant's own
// depends on this friction.
#include <drake/multibody/plant/multibody_plant.h>
#include <drake/multibody/tree/revolute_joint.h>
#include <drake/systems/framework/leaf_system.h>

#include <Eigen/Cholesky>
#include <memory>
#include <vector>

#include "hosts/recipes/held_hinge.hpp"

namespace contact_hosts::drake_recipe {

using drake::Value;
using drake::multibody::MultibodyPlant;
using drake::multibody::RevoluteJoint;
using drake::multibody::SpatialForce;
using drake::systems::BasicVector;
using drake::systems::Context;
using drake::systems::DiscreteValues;
using drake::systems::EventStatus;

class HingeFriction final : public drake::systems::LeafSystem<double> {
 public:
  HingeFriction(const MultibodyPlant<double>& plant,
                const RevoluteJoint<double>& joint, const std::string& file)
      : plant_(plant),
        joint_(joint),
        hinge_(file),
        context_(plant.CreateDefaultContext()) {
    state_ = DeclareVectorInputPort("state", plant.num_multibody_states())
                 .get_index();
    reactions_ = DeclareAbstractInputPort(
                     "reactions", Value<std::vector<SpatialForce<double>>>())
                     .get_index();
    DeclareDiscreteState(3);
    DeclarePeriodicDiscreteUpdateEvent(plant.time_step(), 0,
                                       &HingeFriction::keep_reaction);
    DeclareVectorOutputPort("force", plant.num_velocities(),
                            &HingeFriction::friction,
                            {input_port_ticket(state_), xd_ticket()});
  }

 private:
  // The force on the child body, in the axes of the joint's child frame.
  EventStatus keep_reaction(const Context<double>& context,
                            DiscreteValues<double>* next) const {
    const auto& reactions =
        get_input_port(reactions_)
            .Eval<std::vector<SpatialForce<double>>>(context);
    next->set_value(reactions[joint_.ordinal()].translational());
    return EventStatus::Succeeded();
  }

  void friction(const Context<double>& context,
                BasicVector<double>* force) const {
    const Eigen::VectorXd state = get_input_port(state_).Eval(context);
    plant_.SetPositionsAndVelocities(context_.get(), state);
    Eigen::MatrixXd mass(plant_.num_velocities(), plant_.num_velocities());
    Eigen::VectorXd bias(plant_.num_velocities());
    plant_.CalcMassMatrix(*context_, &mass);
    plant_.CalcBiasTerm(*context_, &bias);
    const Eigen::VectorXd other =
        plant_.CalcGravityGeneralizedForces(*context_) - bias;
    const Eigen::LLT<Eigen::MatrixXd> factors(mass);
    const int i = joint_.velocity_start();
    const Eigen::VectorXd unit =
        Eigen::VectorXd::Unit(plant_.num_velocities(), i);
    const double step = plant_.time_step();
    const double rate = joint_.get_angular_rate(*context_);
    const double free = rate + step * factors.solve(other)[i];
    const double inertia = 1 / factors.solve(unit)[i];
    const Eigen::Vector3d reaction = context.get_discrete_state(0).value();
    force->SetFromVector(hinge_.torque(reaction, joint_.revolute_axis(), rate,
                                       free, inertia, step) *
                         unit);
  }

  const MultibodyPlant<double>& plant_;
  const RevoluteJoint<double>& joint_;
  mutable HeldHinge hinge_;  // remembers where to start from, no more
  std::unique_ptr<Context<double>> context_;
  drake::systems::InputPortIndex state_, reactions_;
};

}  // namespace contact_hosts::drake_recipe
