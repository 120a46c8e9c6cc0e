#include "libcontact/friction/exact.hpp"

#include "libcontact/base/error.hpp"
#include "libcontact/friction/batch.hpp"
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

void check_batch(const FrictionBatchInput& in, const FrictionBatchOutput& out,
                 InstructionSet set) {
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
  if (!is_supported(set)) {
    throw Error(
        std::string("friction integrals: this machine or build lacks ") +
        name(set));
  }
}

}  // namespace detail

FrictionIntegrals exact_friction_integrals(double half_angle, SlipAxis axis,
                                           InstructionSet set) {
  using namespace detail;
  return exact_point(cap_kernel(set), prepare(half_angle, axis.sin, axis.cos));
}

void exact_friction_integrals(const FrictionBatchInput& in,
                              const FrictionBatchOutput& out,
                              InstructionSet set) {
  detail::check_batch(in, out, set);
  detail::cap_kernel(set).batch(in, out, nullptr);
}

}  // namespace contact
