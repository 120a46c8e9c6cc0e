#include "libcontact/base/error.hpp"
#include "libcontact/base/instruction_set.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/friction/kernel/exact_call.hpp"

namespace contact {
namespace detail {

FrictionIntegrals exact_point(const CapKernel& kernel,
                              const PreparedCap<double>& cap) {
  const CapRule& rule = cap_rules[cap_rule_index(cap.point.m)];
  const CapResult<double> r = assemble(
      cap,
      kernel.one(cap.point, rule, cap.pole_inside, arc_range(cap.point.c)));
  return {r.normal,
          {r.force_pressure, r.sliding_pressure, r.spinning_pressure},
          {r.force_area, r.sliding_area, r.spinning_area},
          {r.force, r.sliding, r.spinning}};
}

void check_batch(const FrictionBatchInput& in, const FrictionBatchOutput& out) {
  check_instruction_set();
  const std::size_t size = in.half_angle.size();
  if (in.axis_sin.size() != size || in.axis_cos.size() != size) {
    throw Error("friction integrals: input arrays differ in length");
  }
  for (const std::span<double> result :
       {out.normal, out.force_pressure, out.sliding_pressure,
        out.spinning_pressure, out.force_area, out.sliding_area,
        out.spinning_area, out.force, out.sliding, out.spinning}) {
    if (!result.empty() && result.size() != size) {
      throw Error(
          "friction integrals: an output array is neither empty nor as long "
          "as the input");
    }
  }
}

}  // namespace detail

FrictionIntegrals friction_integrals(double half_angle, SlipAxis axis) {
  using namespace detail;
  return exact_point(cap_kernel(instruction_set()),
                     prepare(half_angle, axis.sin, axis.cos));
}

void friction_integrals(const FrictionBatchInput& in,
                        const FrictionBatchOutput& out) {
  detail::check_batch(in, out);
  detail::cap_kernel(instruction_set()).batch(in, out, nullptr);
}

}  // namespace contact
