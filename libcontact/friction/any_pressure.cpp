#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/base/instruction_set.hpp"
#include "libcontact/friction/by_parts.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/friction/harmonics.hpp"
#include "libcontact/friction/kernel/exact_call.hpp"
#include "libcontact/friction/kernel/expansion_table.hpp"
#include "libcontact/friction/models.hpp"
#include "libcontact/pressure/expansion.hpp"

namespace contact {
namespace {

using detail::CapKernel;
using detail::PressureSums;

using detail::nan;

/// Contacts of this size or less are small beside every slip axis angle but
/// 90 deg itself; the integrals of smaller ones underflow.
constexpr double smallest_half_angle = 1e-140;

/// The pressure-weighted integrals from the coefficients.
void set_scale(double at_centre, FrictionIntegrals& r) {
  const FrictionTriple& c = r.coefficient;
  r.normal = 1 / at_centre;
  r.pressure = {c.force / at_centre, c.sliding / at_centre,
                c.spinning / at_centre};
}

/// Pressure at the edge, pressure units. Laws without an expansion say it.
double edge_pressure(const PressureLaw& law, const PressureExpansion& p,
                     double half_angle) {
  return p.is_empty() ? law.pressure(half_angle, half_angle) : p.edge_pressure;
}

using Harmonics = std::array<double, detail::max_pressure_harmonics>;

/// One point.
FrictionIntegrals one_point(const PressureLaw& law, double half_angle,
                            SlipAxis axis, const CapKernel& kernel) {
  const auto cap = detail::prepare(half_angle, axis.sin, axis.cos);
  FrictionIntegrals r = detail::exact_point(kernel, cap);
  if (half_angle > law.largest_half_angle()) {
    Harmonics harmonics;
    if (detail::harmonics_of(law, half_angle, harmonics)) {
      r.coefficient = detail::coefficients_by_harmonics(harmonics, axis);
      set_scale(law.peak(half_angle), r);
      return r;
    }
  }
  const PressureExpansion p = detail::expansion_of(law, half_angle);
  if (p.is_cosine()) return r;
  if (half_angle >= 0 && half_angle <= smallest_half_angle) {
    r.normal = 0;
    r.pressure = {0, 0, 0};
    return r;
  }
  if (p.is_empty()) {
    const double edge = edge_pressure(law, p, half_angle);
    const FrictionTriple inside =
        detail::coefficients_by_parts(law, half_angle, axis, kernel);
    r.coefficient = {inside.force + edge * r.area.force,
                     inside.sliding + edge * r.area.sliding,
                     inside.spinning + edge * r.area.spinning};
    set_scale(law.pressure(0, half_angle), r);
    return r;
  }
  const auto& [s, abs_c, sa, q, k, m] = cap.point;
  const double c = cap.beyond_hemisphere ? -abs_c : abs_c;
  // At the centre: x = 1; 1 - c over the cosine pressure's I_n.
  const double one_minus_c = c < 0 ? 1 - c : s * s / (1 + c);
  const double share = p.cosine_share;
  double at_centre = share == 0 ? 0 : share * (one_minus_c / r.normal);
  for (int i = 0; i < std::min(p.size, p.powers); ++i) {
    at_centre += p.coefficient[i];
  }
  at_centre += p.edge_pressure;
  const PressureSums<double> root =
      kernel.root_pressure({s, c, sa, q, k, m}, cap.pole_inside, p);
  FrictionTriple& f = r.coefficient;
  if (share == 0) f = {0, 0, 0};
  const double edge = p.edge_pressure;
  f = {root.force + share * f.force + edge * r.area.force,
       root.sliding + share * f.sliding + edge * r.area.sliding,
       root.spinning + share * f.spinning + edge * r.area.spinning};
  set_scale(at_centre, r);
  return r;
}

/// Tables cost more than they save if fewer points want them.
constexpr std::size_t fewest_for_a_table = 100;

void store(const FrictionIntegrals& r, std::size_t i,
           const FrictionBatchOutput& out) {
  const auto to = [i](std::span<double> column, double value) {
    if (!column.empty()) column[i] = value;
  };
  to(out.normal, r.normal);
  to(out.force_pressure, r.pressure.force);
  to(out.sliding_pressure, r.pressure.sliding);
  to(out.spinning_pressure, r.pressure.spinning);
  to(out.force_area, r.area.force);
  to(out.sliding_area, r.area.sliding);
  to(out.spinning_area, r.area.spinning);
  to(out.force, r.coefficient.force);
  to(out.sliding, r.coefficient.sliding);
  to(out.spinning, r.coefficient.spinning);
}

/// ∬ p sin^2 t dS for the pressure that carries the force 1, by parts.
double second_moment(const PressureLaw& law, double half_angle) {
  // x = u^2 for the logarithm of an exact pressure; as many nodes as the 64
  // sines of thin walls need.
  constexpr int size = 128;
  static const detail::GaussLegendre& gauss = *new detail::GaussLegendre(size);
  std::array<double, size> x, slope;
  for (int i = 0; i < size; ++i) {
    const double u = (1 + gauss.node(i)) / 2;
    x[i] = u * u;
  }
  law.edge_slopes(half_angle, x, slope);
  const double b = std::tan(half_angle / 2);
  double sum = 0;
  for (int i = 0; i < size; ++i) {
    const double tangent2 = b * b * (1 - x[i]) * (1 + x[i]);
    const double u = 2 * tangent2 / (1 + tangent2);  // 1 - cos t
    sum += gauss.weight(i) * std::sqrt(x[i]) * slope[i] * u * u * (1 - u / 3);
  }
  return 2 * std::numbers::pi * sum;
}

}  // namespace

FrictionIntegrals viscous_friction_integrals(const PressureLaw& law,
                                             double half_angle, SlipAxis axis) {
  FrictionIntegrals r = viscous_friction_integrals(half_angle, axis);
  if (half_angle > law.largest_half_angle()) {
    std::array<double, 3> harmonics;
    if (detail::harmonics_of(law, half_angle, harmonics)) {
      r.coefficient = detail::viscous_by_harmonics(harmonics, axis);
      set_scale(law.peak(half_angle), r);
      return r;
    }
  }
  const PressureExpansion p = detail::expansion_of(law, half_angle);
  if (half_angle <= smallest_half_angle || p.is_cosine()) return r;
  const double at_centre = law.pressure(0, half_angle);
  const double h = std::sin(half_angle / 2);
  const double m = second_moment(law, half_angle) +
                   edge_pressure(law, p, half_angle) * 8 * std::numbers::pi /
                       3 * (3 - 2 * h * h) * std::pow(h, 4);
  FrictionTriple& c = r.coefficient;
  c = {axis.cos, (law.force_ratio(half_angle) - m / 2) * axis.cos,
       m * axis.sin};
  if (std::isnan(at_centre)) c.force = nan;
  set_scale(at_centre, r);
  return r;
}

FrictionIntegrals friction_integrals(const PressureLaw& law, double half_angle,
                                     SlipAxis axis) {
  return one_point(law, half_angle, axis,
                   detail::cap_kernel(instruction_set()));
}

void friction_integrals(const PressureLaw& law, const FrictionBatchInput& in,
                        const FrictionBatchOutput& out) {
  detail::check_batch(in, out);
  const CapKernel& kernel = detail::cap_kernel(instruction_set());
  const PressureExpansion form = detail::expansion_form(law);
  if (form.is_cosine()) return kernel.batch(in, out, nullptr);

  // The half-angles that a table serves.
  const double largest = std::min(detail::ExpansionTable::largest_half_angle,
                                  law.largest_half_angle());
  const auto is_tabulated = [largest](double half_angle) {
    return half_angle > smallest_half_angle && half_angle <= largest;
  };
  double lower = largest;
  double upper = 0;
  std::size_t count = 0;
  for (const double half_angle : in.half_angle) {
    if (!is_tabulated(half_angle)) continue;
    lower = std::min(lower, half_angle);
    upper = std::max(upper, half_angle);
    ++count;
  }
  const bool use_table = count >= fewest_for_a_table && !form.is_empty() &&
                         form.edge_pressure == 0;
  if (use_table) {
    const detail::ExpansionTable table(law, lower, upper);
    kernel.batch(in, out, &table);
  }
  for (std::size_t i = 0; i < in.half_angle.size(); ++i) {
    if (use_table && is_tabulated(in.half_angle[i])) continue;
    store(one_point(law, in.half_angle[i], {in.axis_sin[i], in.axis_cos[i]},
                    kernel),
          i, out);
  }
}

}  // namespace contact
