#include "multibody/system/constants.hpp"

#include "libcontact/base/linear/parts.hpp"
#include "multibody/system/eigen_conversion.hpp"
#include "multibody/system/hinges/kinds.hpp"

namespace multibody {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

HeldConstants<double> held_constants(const Link& link) {
  return {link.mass,
          sym3(link.inertia),
          vec3(Vector3d(link.arm *
                        Vector3d::Unit(hinge_traits(link.kind).arm_axis))),
          vec3(link.hinge),
          mat3(link.axes_to_carrier_zero),
          link.pole_offset};
}

FreeConstants<double> free_constants(const Link& link) {
  const auto [values, v] = contact::detail::symmetric_parts(link.inertia);
  // A direction without inertia has no rotation to speak of: it rests.
  const double largest = values[2];
  Vector3d inverse;
  for (int i = 0; i < 3; ++i) {
    const double moment = values[i];
    inverse[i] = moment > 1e-14 * largest ? 1 / moment : 0;
  }
  return {1 / link.mass, sym3(link.inertia),
          sym3(v * inverse.asDiagonal() * v.transpose())};
}

template <class Constants>
std::vector<double> numbers_of(const Constants& constants) {
  std::vector<double> numbers(sizeof(constants) / sizeof(double));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = number_of(constants, i);
  }
  return numbers;
}

}  // namespace

SystemConstants::SystemConstants(const System& system)
    : carrier_mass_(system.carrier().mass),
      carrier_inertia_(sym3(system.carrier().inertia)) {
  bodies_.reserve(system.links().size());
  for (const Link& link : system.links()) {
    LinkConstants& body = bodies_.emplace_back();
    body.kind = link.kind;
    body.held = held_constants(link);
    body.free = free_constants(link);
    body.turning = with_hinge(link.kind, [&](auto hinge) {
      return numbers_of(hinge.constants(link));
    });
  }
}

int SystemConstants::size() const { return static_cast<int>(bodies_.size()); }
double SystemConstants::carrier_mass() const { return carrier_mass_; }
const Sym3<double>& SystemConstants::carrier_inertia() const {
  return carrier_inertia_;
}
HingeKind SystemConstants::kind(int body) const { return bodies_[body].kind; }
const double* SystemConstants::turning(int body) const {
  return bodies_[body].turning.data();
}
const HeldConstants<double>& SystemConstants::held(int body) const {
  return bodies_[body].held;
}
const FreeConstants<double>& SystemConstants::free(int body) const {
  return bodies_[body].free;
}

}  // namespace multibody
