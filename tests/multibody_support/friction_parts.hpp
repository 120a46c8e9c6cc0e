#pragma once

#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "libcontact/half_angle/factory.hpp"
#include "libcontact/joint/group.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/cosine.hpp"

/// Joints of steel for tests of motions.
namespace multibody::test {

inline contact::ElasticPair steel_pair() {
  return contact::ElasticPair({2e11, 0.3}, {2e11, 0.3});
}

using LawPointer = std::shared_ptr<const contact::HalfAngleLaw>;

inline LawPointer tanh_law(contact::JointKind kind) {
  return contact::make_half_angle_law("tanh", kind, steel_pair());
}

/// The law tanh up to a load, NaN above it.
class EndingLaw final : public contact::HalfAngleLaw {
 public:
  EndingLaw(contact::JointKind kind, double end)
      : HalfAngleLaw(kind), law_(tanh_law(kind)), end_(end) {}
  std::string name() const override { return "ending"; }
  contact::HalfAngleResult half_angle(double load) const noexcept override {
    if (load <= end_) return law_->half_angle(load);
    return {std::numeric_limits<double>::quiet_NaN(),
            contact::Status::out_of_range};
  }
  contact::LoadParameterResult load_parameter(
      double half_angle) const noexcept override {
    return law_->load_parameter(half_angle);
  }
  double limit_half_angle() const noexcept override {
    return law_->limit_half_angle();
  }
  std::vector<std::string> validity_notes(
      const contact::ElasticPair&) const override {
    return {};
  }

 private:
  LawPointer law_;
  double end_;
};

inline contact::Joint ball_joint(
    const contact::FrictionModel& friction, double radius = 0.05,
    LawPointer law = tanh_law(contact::JointKind::ball)) {
  return contact::Joint(
      {contact::JointGeometry::ball(radius, 1e-3 * radius), steel_pair(),
       friction, std::move(law),
       std::make_unique<contact::CosinePressure>(contact::JointKind::ball)});
}

inline contact::Joint pin_joint(
    const contact::FrictionModel& friction, double radius = 0.05,
    LawPointer law = tanh_law(contact::JointKind::pin)) {
  return contact::Joint(
      {contact::JointGeometry::pin(radius, 1e-3 * radius, 0.1), steel_pair(),
       friction, std::move(law),
       std::make_unique<contact::CosinePressure>(contact::JointKind::pin)});
}

/// Largest moment about z that a joint holds at rest.
inline double moment_limit(const contact::Joint& joint,
                           const Eigen::Vector3d& reaction) {
  return joint.at_rest({reaction, Eigen::Vector3d::UnitZ()})
      .slip.friction_moment.z();
}

/// A ball and a pin, `distance` apart about the hinge's centre.
inline contact::JointGroup ball_and_pin(const contact::FrictionModel& friction,
                                        double distance) {
  std::vector<contact::JointGroup::Member> joints;
  joints.push_back({ball_joint(friction, 0.02), -distance / 2});
  joints.push_back({pin_joint(friction, 0.02), distance / 2});
  return contact::JointGroup(std::move(joints));
}

}  // namespace multibody::test
