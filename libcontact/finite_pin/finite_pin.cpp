#include "libcontact/finite_pin/finite_pin.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/finite_pin/sums.hpp"
#include "libcontact/finite_pin/zeros.hpp"

namespace contact {
namespace {

using detail::turned;
using detail::zeros;
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector4d;

using detail::nan;

// For 1e-9 of the sums, ends of contact included.
constexpr int nodes = 40;

JointSpec with_exact_laws(JointSpec joint) {
  const std::string why = FinitePin::refusal(joint);
  if (!why.empty()) throw Error(why);
  joint.half_angle_law = joint.pressure_law = "exact";
  return joint;
}

}  // namespace

std::string FinitePin::refusal(const JointSpec& joint, std::string asker) {
  const auto needs = [](const std::string& needed) {
    return detail::needs("a pin of finite length", needed);
  };
  if (joint.geometry.kind() != JointKind::pin) return needs("kind = pin");
  if (joint.friction && !std::holds_alternative<FrictionLaw>(*joint.friction)) {
    return needs("dry friction: a coefficient and an adhesion");
  }
  return ForceLaw::refusal(joint, std::move(asker));
}

FinitePin::FinitePin(const JointSpec& joint)
    : joint_(with_exact_laws(joint)),
      law_(joint_),
      pressure_(joint_.make_pressure_law()),
      pieces_(joint.relief.pieces(joint.geometry.length())),
      clearance_(joint.geometry.radial_clearance()),
      half_length_(joint.geometry.length() / 2),
      peaks_(std::make_shared<const Peaks>(*pressure_, law_)) {}

// The exact law belongs to any clearance e: F = E e l f(delta/e). The peak
// pressure dominates the cost, so it is computed on request.
FinitePin::Slice FinitePin::slice(const Vector4d& place, double z,
                                  const Relief::Piece& piece) const noexcept {
  const Vector2d d = place.head<2>() + z * place.tail<2>();
  const double e = clearance_ + piece.at(z);
  const double scale = e / clearance_;
  const double length = 2 * half_length_;
  const double distance = d.norm();
  const ForceState law = law_.at((distance - e) / scale);
  const double force = law.force * scale / length;
  return {d / distance,
          distance,
          force,
          law.slope / length,
          law.energy * scale * scale / length,
          law.half_angle,
          law.force_ratio,
          nan};
}

// Polynomials in x = (z - centre)/(l/2): the square of the distance, and e.
struct FinitePin::Polynomials {
  std::array<double, 3> distance2;
  double relief;  ///< e = eps + relief x^2
};

FinitePin::Polynomials FinitePin::polynomials(
    const Vector4d& place, const Relief::Piece& piece) const noexcept {
  const Vector2d a = place.head<2>() + piece.centre * place.tail<2>();
  const Vector2d psi = half_length_ * place.tail<2>();
  return {{a.squaredNorm(), 2 * a.dot(psi), psi.squaredNorm()},
          piece.curvature * half_length_ * half_length_};
}

// Intervals with |a + psi z| > e(z), from zeros of a polynomial in z over l/2.
std::vector<FinitePin::Interval> FinitePin::intervals(
    const Vector4d& place) const noexcept {
  std::vector<Interval> found;
  for (const Relief::Piece& piece : pieces_) {
    if (!(piece.to > piece.from)) continue;
    const auto [d2, relief] = polynomials(place, piece);
    std::vector<double> polynomial = {d2[0] - clearance_ * clearance_, d2[1],
                                      d2[2] - 2 * clearance_ * relief};
    if (relief > 0) {
      polynomial.push_back(0);
      polynomial.push_back(-relief * relief);
    }
    const auto over = [&](double z) {
      return (z - piece.centre) / half_length_;
    };
    std::vector<double> ends = {piece.from};
    for (const double x : zeros(polynomial, over(piece.from), over(piece.to))) {
      ends.push_back(piece.centre + half_length_ * x);
    }
    ends.push_back(piece.to);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const double z = (ends[i] + ends[i + 1]) / 2;
      const double d = (place.head<2>() + z * place.tail<2>()).norm();
      if (d > clearance_ + piece.at(z)) {
        found.push_back({ends[i], ends[i + 1], &piece});
      }
    }
  }
  return found;
}

// Places where |a + psi z|/e, with which theta0 grows, may be largest: ends,
// and zeros of (d^2)' e - 2 d^2 e'.
std::vector<double> FinitePin::summits(
    const Vector4d& place, const Interval& interval) const noexcept {
  const Relief::Piece& piece = *interval.piece;
  const auto [d2, relief] = polynomials(place, piece);
  const std::vector<double> slope = {
      d2[1] * clearance_, 2 * d2[2] * clearance_ - 4 * relief * d2[0],
      -3 * relief * d2[1], -2 * relief * d2[2]};
  const auto over = [&](double z) { return (z - piece.centre) / half_length_; };
  std::vector<double> found = {interval.from, interval.to};
  for (const double x : zeros(slope, over(interval.from), over(interval.to))) {
    found.push_back(piece.centre + half_length_ * x);
  }
  return found;
}

// Substituted so that contact may end at both ends of an interval.
FinitePin::Sums FinitePin::sums(const Vector4d& place) const noexcept {
  static const detail::GaussLegendre& rule = *new detail::GaussLegendre(nodes);
  const double rho = joint_.geometry.radius();
  Sums sums;
  if (!place.allFinite()) {
    sums.load.setConstant(nan);
    return sums;
  }
  for (const auto& [from, to, piece] : intervals(place)) {
    for (int i = 0; i < nodes; ++i) {
      const double u = (1 + rule.node(i)) / 2;
      const double z = from + (to - from) * u * u * u * (10 - u * (15 - 6 * u));
      const double weight =
          rule.weight(i) / 2 * (to - from) * 30 * u * u * (1 - u) * (1 - u);
      const Slice s = slice(place, z, *piece);
      const Vector2d force = weight * s.force * s.direction;
      sums.load.head<2>() += force;
      sums.load.tail<2>() += z * force;
      sums.energy += weight * s.energy;
      const Matrix2d along = s.direction * s.direction.transpose();
      const Matrix2d k =
          weight * (s.slope * along +
                    s.force / s.distance * (Matrix2d::Identity() - along));
      sums.stiffness.topLeftCorner<2, 2>() += k;
      sums.stiffness.topRightCorner<2, 2>() += z * k;
      sums.stiffness.bottomRightCorner<2, 2>() += z * z * k;
      sums.pressure_moment += weight * rho * s.force * s.force_ratio;
      const Vector2d tangent =
          weight * 2 * rho * std::sin(s.half_angle) * turned(s.direction);
      sums.area.head<2>() += tangent;
      sums.area.tail<2>() += z * tangent;
      sums.area_moment += weight * 2 * rho * rho * s.half_angle;
    }
  }
  sums.stiffness.bottomLeftCorner<2, 2>() =
      sums.stiffness.topRightCorner<2, 2>();
  return sums;
}

FinitePinState FinitePin::at(const Vector2d& shift,
                             const Vector2d& tilt) const noexcept {
  const Vector4d place = (Vector4d() << shift, tilt).finished();
  return state(place, sums(place));
}

}  // namespace contact
