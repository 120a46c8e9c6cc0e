// Friction in a revolute joint of Gazebo (gz-sim 7 and later), as a plugin of
// its model:
//
//     <plugin filename="HingeFriction" name="contact_hosts::HingeFriction">
//       <joint>hip</joint> <file>pin.toml</file> <inertia>0.9</inertia>
//     </plugin>
//
// inertia: of all that turns about the axis, kg m^2.
#include <gz/plugin/Register.hh>
#include <gz/sim/Joint.hh>
#include <gz/sim/Model.hh>
#include <gz/sim/System.hh>
#include <memory>

#include "hosts/recipes/held_hinge.hpp"

namespace contact_hosts {

class HingeFriction final : public gz::sim::System,
                            public gz::sim::ISystemConfigure,
                            public gz::sim::ISystemPreUpdate {
 public:
  void Configure(const gz::sim::Entity& entity,
                 const std::shared_ptr<const sdf::Element>& sdf,
                 gz::sim::EntityComponentManager& ecm,
                 gz::sim::EventManager&) override {
    joint_ = gz::sim::Joint(gz::sim::Model(entity).JointByName(
        ecm, sdf->Get<std::string>("joint")));
    joint_.EnableVelocityCheck(ecm);
    joint_.EnableTransmittedWrenchCheck(ecm);
    hinge_ = std::make_unique<HeldHinge>(sdf->Get<std::string>("file"));
    inertia_ = sdf->Get<double>("inertia");
  }

  void PreUpdate(const gz::sim::UpdateInfo& info,
                 gz::sim::EntityComponentManager& ecm) override {
    const auto rate = joint_.Velocity(ecm);
    const auto wrench = joint_.TransmittedWrench(ecm);
    const auto axis = joint_.Axis(ecm);
    // None before the first step.
    if (info.paused || !rate || !wrench || !axis) return;
    const auto f = wrench->front().force();
    const auto z = axis->front().Xyz();
    const double step = std::chrono::duration<double>(info.dt).count();
    joint_.SetForce(
        ecm, {hinge_->torque({f.x(), f.y(), f.z()}, {z.X(), z.Y(), z.Z()},
                             rate->front(), inertia_, step)});
  }

 private:
  gz::sim::Joint joint_;
  std::unique_ptr<HeldHinge> hinge_;
  double inertia_ = 0;
};

}  // namespace contact_hosts

GZ_ADD_PLUGIN(contact_hosts::HingeFriction, gz::sim::System,
              contact_hosts::HingeFriction::ISystemConfigure,
              contact_hosts::HingeFriction::ISystemPreUpdate)
