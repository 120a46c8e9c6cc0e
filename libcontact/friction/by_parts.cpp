#include "libcontact/friction/by_parts.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/pressure/exact.hpp"

namespace contact::detail {
namespace {

/// Nodes of one piece. With 40 the rounding errors of a ShapedPressure's slopes
/// near the edge leave 5e-9 in place of 1e-10.
constexpr int usual_nodes = 56;
/// Nodes for a pressure under walls, with its 64 sines.
constexpr int walled_nodes = 128;

const GaussLegendre& rule_for(const PressureLaw& law) {
  static const GaussLegendre& usual = *new GaussLegendre(usual_nodes);
  static const GaussLegendre& walled = *new GaussLegendre(walled_nodes);
  const auto* exact = dynamic_cast<const ExactPressure*>(&law);
  return exact && exact->has_walls() ? walled : usual;
}

/// The nodes of up to three pieces of phi in [0, pi/2], x = sin(phi).
struct Nodes {
  using Numbers = std::array<double, 3 * walled_nodes>;
  std::size_t size = 0;
  Numbers x, weight, half_angle;

  /// @param b  tan(theta0/2)
  void add_piece(const GaussLegendre& gauss, double from, double to, double b) {
    for (Eigen::Index i = 0; i < gauss.node.size(); ++i, ++size) {
      // Both ends are approached like u^2.
      const double u = (1 + gauss.node(i)) / 2;
      const double phi = from + (to - from) * u * u * (3 - 2 * u);
      const double dx = std::cos(phi);
      x[size] = std::sin(phi);
      half_angle[size] = 2 * std::atan(b * dx);
      weight[size] = gauss.weight(i) * (to - from) * 3 * u * (1 - u) * dx;
    }
  }
};

}  // namespace

FrictionTriple coefficients_by_parts(const PressureLaw& law, double half_angle,
                                     SlipAxis axis, const CapKernel& kernel) {
  const double b = std::tan(half_angle / 2);
  const double pole = (1 + std::abs(axis.sin)) / axis.cos;
  const GaussLegendre& rule = rule_for(law);
  Nodes nodes;
  double from = 0;
  for (const double tangent : {pole, 1 / pole}) {
    if (!(tangent < b)) continue;
    const double to = std::acos(tangent / b);
    nodes.add_piece(rule, from, to, b);
    from = to;
  }
  nodes.add_piece(rule, from, std::numbers::pi / 2, b);

  const std::size_t size = nodes.size;
  Nodes::Numbers slope, sines, cosines, force, sliding, spinning;
  law.edge_slopes(half_angle, std::span(nodes.x).first(size),
                  std::span(slope).first(size));
  sines.fill(axis.sin);
  cosines.fill(axis.cos);
  FrictionBatchOutput area{};
  area.force_area = std::span(force).first(size);
  area.sliding_area = std::span(sliding).first(size);
  area.spinning_area = std::span(spinning).first(size);
  kernel.batch({std::span(nodes.half_angle).first(size),
                std::span(sines).first(size), std::span(cosines).first(size)},
               area, nullptr);
  FrictionTriple sum{0, 0, 0};
  for (std::size_t i = 0; i < size; ++i) {
    const double w = nodes.weight[i] * slope[i];
    sum.force += w * force[i];
    sum.sliding += w * sliding[i];
    sum.spinning += w * spinning[i];
  }
  return sum;
}

}  // namespace contact::detail
