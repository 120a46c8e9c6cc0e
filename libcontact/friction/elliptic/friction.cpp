#include "libcontact/friction/elliptic/friction.hpp"

#include "libcontact/friction/elliptic/friction_real.hpp"

namespace contact {

FrictionIntegrals elliptic_friction_integrals(double half_angle,
                                              SlipAxis axis) {
  return elliptic_friction_integrals<double>(half_angle, axis.sin, axis.cos);
}

double slip_speed_integral(double half_angle, SlipAxis axis) {
  return slip_speed_integral<double>(half_angle, axis.sin, axis.cos);
}

}  // namespace contact
