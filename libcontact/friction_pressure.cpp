#include "libcontact/friction_pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "libcontact/detail/cap_kernel.hpp"
#include "libcontact/detail/cap_point.hpp"
#include "libcontact/detail/gauss_legendre.hpp"
#include "libcontact/error.hpp"
#include "libcontact/friction_exact.hpp"
#include "libcontact/friction_models.hpp"

// s = tan(theta/2)/tan(theta0/2) = cos(phi), x = sin(phi) the edge variable,
// T0 = 90 deg - |a| the colatitude of the pole (docs/friction.md).
namespace contact {
namespace {

using detail::CapKernel;
using detail::PressureSums;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The coefficients; `cosine` are those of the cosine pressure.
FrictionTriple coefficients(const PressureExpansion& p, double half_angle,
                            SlipAxis axis, const CapKernel& kernel,
                            const FrictionTriple& cosine) {
  const auto cap = detail::prepare(half_angle, axis.sin, axis.cos);
  const auto& [s, c, sa, q, k, m] = cap.point;
  const PressureSums<double> root = kernel.root_pressure(
      {s, cap.beyond_hemisphere ? -c : c, sa, q, k, m}, cap.pole_inside, p);
  const double share = p.cosine_share;
  if (share == 0) return {root.force, root.sliding, root.spinning};
  return {root.force + share * cosine.force,
          root.sliding + share * cosine.sliding,
          root.spinning + share * cosine.spinning};
}

bool is_cosine(const PressureLaw& law) {
  return dynamic_cast<const CosinePressure*>(&law) != nullptr;
}

/// Contacts of this size or less are small beside every slip axis angle but
/// 90 deg itself; the integrals of smaller ones underflow.
constexpr double smallest_half_angle = 1e-140;

/// The pressure-weighted integrals from the coefficients.
void set_scale(double peak, FrictionIntegrals& r) {
  const FrictionTriple& c = r.coefficient;
  r.normal = 1 / peak;
  r.pressure = {c.force / peak, c.sliding / peak, c.spinning / peak};
}

/// Replaces what depends on the pressure, given what does not.
void set_pressure_part(const PressureLaw& law, double half_angle, SlipAxis axis,
                       const CapKernel& kernel, FrictionIntegrals& r) {
  if (half_angle >= 0 && half_angle <= smallest_half_angle) {
    r.normal = 0;
    r.pressure = {0, 0, 0};
    return;
  }
  const double peak = law.peak(half_angle);
  r.coefficient = std::isnan(peak)
                      ? FrictionTriple{nan, nan, nan}
                      : coefficients(law.expansion(half_angle), half_angle,
                                     axis, kernel, r.coefficient);
  set_scale(peak, r);
}

/// ∬ p sin^2 t dS for the pressure that carries the force 1, by parts.
double second_moment(const PressureLaw& law, double half_angle) {
  constexpr int size = 24;
  static const detail::GaussLegendre gauss(size);
  std::array<double, size> x, slope;
  for (int i = 0; i < size; ++i) x[i] = (1 + gauss.node(i)) / 2;
  law.edge_slopes(half_angle, x, slope);
  const double b = std::tan(half_angle / 2);
  double sum = 0;
  for (int i = 0; i < size; ++i) {
    const double tangent2 = b * b * (1 - x[i]) * (1 + x[i]);
    const double u = 2 * tangent2 / (1 + tangent2);  // 1 - cos t
    sum += gauss.weight(i) / 2 * slope[i] * u * u * (1 - u / 3);
  }
  return 2 * std::numbers::pi * sum;
}

}  // namespace

FrictionIntegrals viscous_friction_integrals(const PressureLaw& law,
                                             double half_angle, SlipAxis axis) {
  FrictionIntegrals r = viscous_friction_integrals(half_angle, axis);
  if (is_cosine(law) || half_angle <= smallest_half_angle) return r;
  const double peak = law.peak(half_angle);
  const double m = second_moment(law, half_angle);
  FrictionTriple& c = r.coefficient;
  c = {axis.cos, (law.force_ratio(half_angle) - m / 2) * axis.cos,
       m * axis.sin};
  if (std::isnan(peak)) c.force = nan;
  set_scale(peak, r);
  return r;
}

FrictionIntegrals friction_integrals(const PressureLaw& law, double half_angle,
                                     SlipAxis axis) {
  static const CapKernel& kernel = detail::cap_kernel(best_instruction_set());
  FrictionIntegrals result = exact_friction_integrals(half_angle, axis);
  if (is_cosine(law)) return result;
  set_pressure_part(law, half_angle, axis, kernel, result);
  return result;
}

void friction_integrals(const PressureLaw& law, const FrictionBatchInput& in,
                        const FrictionBatchOutput& out, InstructionSet set) {
  // Checks its arguments too.
  exact_friction_integrals(in, out, set);
  if (is_cosine(law)) return;
  const CapKernel& kernel = detail::cap_kernel(set);
  const auto store = [](std::span<double> to, std::size_t i, double value) {
    if (!to.empty()) to[i] = value;
  };
  const auto read = [](std::span<double> from, std::size_t i) {
    return from.empty() ? 0 : from[i];
  };
  for (std::size_t i = 0; i < in.half_angle.size(); ++i) {
    FrictionIntegrals r{};
    r.coefficient = {read(out.force, i), read(out.sliding, i),
                     read(out.spinning, i)};
    set_pressure_part(law, in.half_angle[i], {in.axis_sin[i], in.axis_cos[i]},
                      kernel, r);
    store(out.normal, i, r.normal);
    store(out.force_pressure, i, r.pressure.force);
    store(out.sliding_pressure, i, r.pressure.sliding);
    store(out.spinning_pressure, i, r.pressure.spinning);
    store(out.force, i, r.coefficient.force);
    store(out.sliding, i, r.coefficient.sliding);
    store(out.spinning, i, r.coefficient.spinning);
  }
}

}  // namespace contact
