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

using detail::AreaSums;
using detail::CapKernel;
using detail::CapRule;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A Gauss rule for a piece of the contact, y the distance from its end at the
/// pole: y = y(u), u in [0, 1]. The size by measurement.
struct PieceRule {
  static constexpr int size = 24;
  static_assert(size % CapRule::lanes == 0);
  using Array = std::array<double, size>;
  Array y;
  Array weight;

  template <class Map, class Derivative>
  PieceRule(Map map, Derivative derivative) {
    const detail::GaussLegendre gauss(size);
    for (int i = 0; i < size; ++i) {
      const double u = (1 + gauss.node(i)) / 2;
      y[i] = map(u);
      weight[i] = derivative(u) * gauss.weight(i) / 2;
    }
  }
};

/// How the integrals behave at a piece's ends decides its rule.
struct PieceRules {
  /// y^2 ln y at one end.
  PieceRule one_pole{[](double u) { return u * u; },
                     [](double u) { return 2 * u; }};
  /// y^2 ln y at both ends.
  PieceRule two_poles{[](double u) { return u * u * (3 - 2 * u); },
                      [](double u) { return 6 * u * (1 - u); }};
};

const PieceRules& piece_rules() {
  static const PieceRules rules;
  return rules;
}

/// The contacts over which one integral by parts is summed up, piece by piece.
class Stack {
 public:
  Stack(const PressureLaw& law, double half_angle)
      : law_(law),
        half_angle_(half_angle),
        tangent_(std::tan(half_angle / 2)) {}

  /// From x = start on to the centre; `rest` is 1 - start.
  void add_inner(double start, double rest, const PieceRule& rule) {
    for (int i = 0; i < rule.size; ++i) {
      const double left = rest * (1 - rule.y[i]);  // 1 - x
      const double x = start + rest * rule.y[i];
      set(i, x, std::sqrt(left * (1 + x)), rest * rule.weight[i]);
    }
  }
  /// From phi = start towards the edge, by an angle.
  void add_outer(double start, double angle, const PieceRule& rule) {
    for (int i = 0; i < rule.size; ++i) {
      const double phi = start - angle * rule.y[i];
      const double s = std::cos(phi);
      set(i, std::sin(phi), s, angle * rule.weight[i] * s);
    }
  }
  /// Adds the piece to the sums.
  void take(const CapKernel& kernel, SlipAxis axis, bool pole_inside,
            AreaSums<double>& sums) {
    PieceRule::Array slope;
    law_.edge_slopes(half_angle_, x_, slope);
    for (int i = 0; i < PieceRule::size; ++i) weight_[i] *= slope[i];
    const AreaSums<double> piece =
        kernel.areas({PieceRule::size, sine_.data(), cosine_.data(),
                      weight_.data(), pole_inside},
                     axis.sin, axis.cos);
    sums.force += piece.force;
    sums.sliding += piece.sliding;
    sums.spinning += piece.spinning;
  }

 private:
  void set(int i, double x, double s, double weight) {
    x_[i] = x;
    weight_[i] = weight;
    const double tangent = tangent_ * s;
    const double inverse = 1 / (1 + tangent * tangent);
    sine_[i] = 2 * tangent * inverse;
    cosine_[i] = (1 - tangent) * (1 + tangent) * inverse;
  }

  const PressureLaw& law_;
  double half_angle_;
  double tangent_;  // b = tan(theta0/2)
  PieceRule::Array x_, sine_, cosine_, weight_;
};

/// I[p], J[p], K[p] of a contact beyond the hemisphere, for the pressure that
/// carries the force 1.
AreaSums<double> by_parts(const PressureLaw& law, double half_angle,
                          SlipAxis axis, const CapKernel& kernel) {
  const PieceRules& rules = piece_rules();
  AreaSums<double> sums;
  Stack stack(law, half_angle);
  // s at the two poles: T0 and 180 deg - T0.
  const double b = std::tan(half_angle / 2);
  const double sum = 1 + std::abs(axis.sin);
  const double first = axis.cos / (sum * b);
  const double second = sum / (axis.cos * b);
  const double first_x = std::sqrt((1 - first) * (1 + first));
  const double first_phi = std::acos(first);
  if (first > 0) {
    stack.add_inner(first_x, first * first / (1 + first_x), rules.one_pole);
    stack.take(kernel, axis, false, sums);
  }
  if (!(second < 1)) {
    stack.add_outer(first_phi, first_phi, rules.one_pole);
    stack.take(kernel, axis, true, sums);
    return sums;
  }
  const double second_phi = std::acos(second);
  if (second > first) {
    stack.add_outer(first_phi, first_phi - second_phi, rules.two_poles);
    stack.take(kernel, axis, true, sums);
  }
  stack.add_outer(second_phi, second_phi, rules.one_pole);
  stack.take(kernel, axis, false, sums);
  return sums;
}

/// The same for a contact within the hemisphere; `cosine` are the coefficients
/// of the cosine pressure.
FrictionTriple by_arcs(const PressureLaw& law, double half_angle, SlipAxis axis,
                       const CapKernel& kernel, const FrictionTriple& cosine) {
  const PressureExpansion p = law.expansion(half_angle);
  const auto cap = detail::prepare(half_angle, axis.sin, axis.cos);
  const AreaSums<double> root =
      kernel.root_pressure(cap.point, cap.pole_inside, p.coefficients());
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
  FrictionTriple& c = r.coefficient;
  if (std::isnan(peak)) {
    c = {nan, nan, nan};
  } else if (half_angle > std::numbers::pi / 2) {
    const AreaSums<double> sums = by_parts(law, half_angle, axis, kernel);
    c = {sums.force, sums.sliding, sums.spinning};
  } else {
    c = by_arcs(law, half_angle, axis, kernel, c);
  }
  set_scale(peak, r);
}

/// ∬ p sin^2 t dS for the pressure that carries the force 1, by parts.
double second_moment(const PressureLaw& law, double half_angle) {
  static const PieceRule rule([](double u) { return u; },
                              [](double) { return 1; });
  PieceRule::Array slope;
  law.edge_slopes(half_angle, rule.y, slope);
  const double b = std::tan(half_angle / 2);
  double sum = 0;
  for (int i = 0; i < rule.size; ++i) {
    const double x = rule.y[i];
    const double tangent2 = b * b * (1 - x) * (1 + x);
    const double u = 2 * tangent2 / (1 + tangent2);  // 1 - cos t
    sum += rule.weight[i] * slope[i] * u * u * (1 - u / 3);
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
