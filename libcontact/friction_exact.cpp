#include "libcontact/friction_exact.hpp"

#include "libcontact/detail/cap_kernel.hpp"
#include "libcontact/detail/cap_point.hpp"
#include "libcontact/detail/cap_rule.hpp"

namespace contact {

FrictionIntegrals exact_friction_integrals(double half_angle, SlipAxis axis) {
  static const detail::CapKernel& kernel =
      detail::cap_kernel(best_instruction_set());
  const detail::PreparedCap cap = detail::prepare(half_angle, axis);
  return detail::assemble(cap, kernel.one(cap.point, detail::cap_rule(cap.rule),
                                          cap.pole_inside, cap.range));
}

}  // namespace contact
