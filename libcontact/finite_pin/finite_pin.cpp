#include "libcontact/finite_pin/finite_pin.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

#include "libcontact/base/complaint.hpp"
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

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// For 1e-9 of the sums, ends of contact included.
constexpr int nodes = 40;

JointSpec with_exact_laws(JointSpec joint) {
  const auto refuse = [](const std::string& needed) {
    throw Error(detail::needs("a pin of finite length", needed));
  };
  if (joint.geometry.kind() != JointKind::pin) refuse("kind = pin");
  if (joint.friction && !std::holds_alternative<FrictionLaw>(*joint.friction)) {
    refuse("dry friction: a coefficient and an adhesion");
  }
  joint.half_angle_law = joint.pressure_law = "exact";
  return joint;
}

}  // namespace

/// A piece of contact along z, within one of the relief's.
struct FinitePin::Interval {
  double from, to;
  const Relief::Piece* piece;
};

FinitePin::FinitePin(const JointSpec& joint)
    : joint_(with_exact_laws(joint)),
      law_(joint_),
      pressure_(joint_.make_pressure_law()),
      pieces_(joint.relief.pieces(joint.geometry.length())),
      clearance_(joint.geometry.radial_clearance()),
      half_length_(joint.geometry.length() / 2) {}

// The exact law belongs to any clearance e: F = E e l f(delta/e).
FinitePin::Slice FinitePin::slice(const Vector4d& place, double z,
                                  const Relief::Piece& piece) const noexcept {
  const Vector2d d = place.head<2>() + z * place.tail<2>();
  const double e = clearance_ + piece.at(z);
  const double scale = e / clearance_;
  const double length = 2 * half_length_;
  const double distance = d.norm();
  const ForceState law = law_.at((distance - e) / scale);
  const double force = law.force * scale / length;
  const double peak = force > 0 ? pressure_->peak(law.half_angle) *
                                      joint_.geometry.pressure_unit(force)
                                : force;
  return {d / distance,
          distance,
          force,
          law.slope / length,
          law.energy * scale * scale / length,
          law.half_angle,
          law.force_ratio,
          peak};
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
  static const detail::GaussLegendre rule(nodes);
  const double rho = joint_.geometry.radius();
  Sums sums;
  if (!place.allFinite()) {
    sums.load.setConstant(nan);
    sums.peak = nan;
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
      if (!(s.peak <= sums.peak)) {
        sums.peak = s.peak;
        sums.peak_place = z;
      }
    }
  }
  sums.stiffness.bottomLeftCorner<2, 2>() =
      sums.stiffness.topRightCorner<2, 2>();
  return sums;
}

FinitePinState FinitePin::state(const Vector4d& place,
                                const Sums& all) const noexcept {
  FinitePinState s{.shift = place.head<2>(),
                   .tilt = place.tail<2>(),
                   .force = all.load.head<2>(),
                   .force_moment = all.load.tail<2>(),
                   .energy = all.energy,
                   .stiffness = all.stiffness,
                   .low = nan,
                   .high = nan,
                   .peak_pressure = all.peak,
                   .peak_place = all.peak_place,
                   .largest_half_angle = 0,
                   .half_angle_place = nan,
                   .end_pressure = {},
                   .end_half_angle = {},
                   .pressure_moment = all.pressure_moment,
                   .area_tangent = all.area.head<2>(),
                   .area_tangent_moment = all.area.tail<2>(),
                   .area_moment = all.area_moment};
  if (!all.load.allFinite()) s.status = Status::out_of_range;
  for (const Interval& interval : intervals(place)) {
    const auto& [from, to, piece] = interval;
    // Intervals of adjacent relief pieces that meet are one.
    if (s.pieces == 0) s.low = from;
    if (s.pieces == 0 || from > s.high) ++s.pieces;
    s.high = to;
    for (const double z : summits(place, interval)) {
      const double half_angle = slice(place, z, *piece).half_angle;
      if (half_angle > s.largest_half_angle) {
        s.largest_half_angle = half_angle;
        s.half_angle_place = z;
      }
    }
    // Clang 14 captures no structured binding by itself.
    const auto depth = [this, &place, &relief = *piece](double z) {
      return -slice(place, z, relief).peak;
    };
    for (const double end : {from, to}) {
      if (-depth(end) > s.peak_pressure) {
        s.peak_pressure = -depth(end);
        s.peak_place = end;
      }
    }
    if (!(all.peak_place > from && all.peak_place < to)) continue;
    constexpr int bits = 26;
    std::uintmax_t steps = 60;
    const double width = 0.1 * (to - from);
    const auto [z, least] = boost::math::tools::brent_find_minima(
        depth, std::max(from, all.peak_place - width),
        std::min(to, all.peak_place + width), bits, steps);
    if (-least > s.peak_pressure) {
      s.peak_pressure = -least;
      s.peak_place = z;
    }
  }
  for (const int end : {0, 1}) {
    const double z = end == 0 ? -half_length_ : half_length_;
    const Slice at =
        slice(place, z, end == 0 ? pieces_.front() : pieces_.back());
    s.end_pressure[end] = at.peak;
    s.end_half_angle[end] = at.half_angle;
  }
  return s;
}

FinitePinState FinitePin::at(const Vector2d& shift,
                             const Vector2d& tilt) const noexcept {
  const Vector4d place = (Vector4d() << shift, tilt).finished();
  return state(place, sums(place));
}

}  // namespace contact
