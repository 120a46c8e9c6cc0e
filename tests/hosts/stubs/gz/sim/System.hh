// Declarations of our own of what recipes/gazebo.cpp uses of Gazebo.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gz::math {
struct Vector3d {
  double X() const;
  double Y() const;
  double Z() const;
};
}  // namespace gz::math

namespace gz::msgs {
struct Vector3d {
  double x() const;
  double y() const;
  double z() const;
};
struct Wrench {
  const Vector3d& force() const;
};
}  // namespace gz::msgs

namespace sdf {
class Element {
 public:
  template <class T>
  T Get(const std::string&) const;
};
class JointAxis {
 public:
  gz::math::Vector3d Xyz() const;
};
}  // namespace sdf

namespace gz::sim {

using Entity = std::uint64_t;
class EntityComponentManager {};
class EventManager {};
struct UpdateInfo {
  std::chrono::steady_clock::duration dt;
  bool paused;
};

class System {
 public:
  virtual ~System() = default;
};
class ISystemConfigure {
 public:
  virtual ~ISystemConfigure() = default;
  virtual void Configure(const Entity&,
                         const std::shared_ptr<const sdf::Element>&,
                         EntityComponentManager&, EventManager&) = 0;
};
class ISystemPreUpdate {
 public:
  virtual ~ISystemPreUpdate() = default;
  virtual void PreUpdate(const UpdateInfo&, EntityComponentManager&) = 0;
};

class Model {
 public:
  explicit Model(Entity);
  Entity JointByName(const EntityComponentManager&, const std::string&) const;
};
class Joint {
 public:
  explicit Joint(Entity = 0);
  void EnableVelocityCheck(EntityComponentManager&, bool = true) const;
  void EnableTransmittedWrenchCheck(EntityComponentManager&, bool = true) const;
  std::optional<std::vector<double>> Velocity(
      const EntityComponentManager&) const;
  std::optional<std::vector<msgs::Wrench>> TransmittedWrench(
      const EntityComponentManager&) const;
  std::optional<std::vector<sdf::JointAxis>> Axis(
      const EntityComponentManager&) const;
  void SetForce(EntityComponentManager&, const std::vector<double>&);
};

}  // namespace gz::sim
