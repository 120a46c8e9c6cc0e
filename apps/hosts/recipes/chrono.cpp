// Friction in a revolute joint of Chrono, as the torque of a rotational
// actuator between the same bodies.
//
//     auto rsda = chrono_types::make_shared<chrono::ChLinkRSDA>();
//     rsda->Initialize(body, carrier, frame);  // that of the joint
//     rsda->RegisterTorqueFunctor(
//         chrono_types::make_shared<HingeFriction>(revolute, "pin.toml",
//                                                  inertia, step));
//     system.AddLink(rsda);
//
// For the timestepper EULER_IMPLICIT_LINEARIZED, which asks once in a step.
#include <chrono/physics/ChLinkLock.h>
#include <chrono/physics/ChLinkRSDA.h>

#include <memory>

#include "hosts/recipes/held_hinge.hpp"

namespace contact_hosts::chrono_recipe {

class HingeFriction final : public chrono::ChLinkRSDA::TorqueFunctor {
 public:
  /// @param joint    whose second body is the actuator's
  /// @param inertia  of all that turns about the axis, kg m^2
  HingeFriction(std::shared_ptr<chrono::ChLinkLockRevolute> joint,
                const std::string& file, double inertia, double step)
      : joint_(std::move(joint)),
        hinge_(file),
        inertia_(inertia),
        step_(step) {}

  double evaluate(double time, double, double, double rate,
                  const chrono::ChLinkRSDA&) override {
    // A second question at one time is the same question.
    if (time != time_) {
      time_ = time;
      const chrono::ChVector3d f = joint_->GetReaction2().force;
      torque_ = hinge_.torque({f.x(), f.y(), f.z()}, Eigen::Vector3d::UnitZ(),
                              rate, inertia_, step_);
    }
    return torque_;
  }

 private:
  std::shared_ptr<chrono::ChLinkLockRevolute> joint_;
  HeldHinge hinge_;
  double inertia_, step_, time_ = -1, torque_ = 0;
};

}  // namespace contact_hosts::chrono_recipe
