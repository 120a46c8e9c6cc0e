#pragma once

#include <cstddef>
#include <vector>

#include "multibody/system/linear3.hpp"
#include "multibody/system/system.hpp"

/// Constants during a motion, computed once per body; for bodies that turn in
/// their hinges see system/hinges. P is the type of the parameters: double, or
/// lanes if they differ between them.
namespace multibody {

/// A body that does not turn in its joint, link axes; r is the hinge (axis:
/// the foot) from the centre of mass.
template <class P>
struct HeldConstants {
  P mass;
  Sym3<P> inertia;
  Vec3<P> r;
  Vec3<P> hinge;
  Mat3<P> zero;  ///< axis only: as in AxisConstants
  P pole_offset;
};

/// A body without a hinge, link axes.
template <class P>
struct FreeConstants {
  P inverse_mass;
  Sym3<P> inertia;
  Sym3<P> inverse_inertia;  ///< 0 in directions without inertia
};

/// All constants of a system.
class SystemConstants {
 public:
  explicit SystemConstants(const System& system);

  int size() const;
  double carrier_mass() const;
  const Sym3<double>& carrier_inertia() const;
  HingeKind kind(int body) const;
  /// Constants of a body that turns in its hinge, as a row of numbers:
  /// Constants of the body's kind of hinge.
  const double* turning(int body) const;
  /// Constants of any body.
  const HeldConstants<double>& held(int body) const;
  const FreeConstants<double>& free(int body) const;

 private:
  struct LinkConstants {
    HingeKind kind;
    std::vector<double> turning;
    HeldConstants<double> held;
    FreeConstants<double> free;
  };
  double carrier_mass_;
  Sym3<double> carrier_inertia_;
  std::vector<LinkConstants> bodies_;
};

/// The constants of a body are a row of numbers of one type.
template <class Constants>
double number_of(const Constants& constants, std::size_t i) {
  return reinterpret_cast<const double*>(&constants)[i];
}
/// Sets them one by one: the i-th to number(i).
template <class P, template <class> class Constants, class F>
void set_numbers(Constants<P>& constants, F number) {
  static_assert(sizeof(constants) % sizeof(P) == 0);
  P* const to = reinterpret_cast<P*>(&constants);
  for (std::size_t i = 0; i < sizeof(constants) / sizeof(P); ++i) {
    to[i] = number(i);
  }
}

}  // namespace multibody
