#include "libcontact/seat/side_face_reach.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/base/linear/solve.hpp"

namespace contact::detail {

SideFaceReach::SideFaceReach(const LayeredPair& pair, const SeatZone& zone,
                             const Stiffness& stiffness)
    : unit_(4 / (pair.surfaces().effective_modulus() * pair.radius())),
      compliance_(pair, zone, 24, 10),
      from_(zone.from()),
      step_(zone.width() / 32),
      largest_(33) {
  for (int i = 0; i < largest_.size(); ++i) {
    const double direction = from_ + i * step_;
    double low = 0, high = zone.margin(direction, 0);
    while (high - low > 2e-3) {
      const double middle = (low + high) / 2;
      const double rest = more(direction, middle).rest * stiffness(middle);
      (rest < largest_rest ? low : high) = middle;
    }
    largest_(i) = low;
  }
}

double SideFaceReach::half_angle(double direction) const {
  const double place = (direction - from_) / step_;
  const auto i =
      std::clamp(static_cast<int>(place), 0, int(largest_.size()) - 2);
  const double part = std::clamp(place - i, 0.0, 1.0);
  return (1 - part) * largest_(i) + part * largest_(i + 1);
}

SideFaceReach::More SideFaceReach::more(double direction,
                                        double half_angle) const {
  constexpr int rings = 8, turns = 24;
  static const GaussLegendre& rule = *new GaussLegendre(rings);
  const Eigen::Vector2d along(std::sin(direction), std::cos(direction));
  const Eigen::Vector2d across(along.y(), -along.x());
  const double size = std::sin(half_angle / 2);
  std::vector<SideFaceCompliance::Point> points;
  Eigen::MatrixX2d place(rings * turns, 2);
  Eigen::VectorXd force(rings * turns);
  double load = 0;
  for (int i = 0; i < rings; ++i) {
    // Hertz' p = cos of this, at x: sin(x/2) = size sin.
    const double angle = pi / 4 * (1 + rule.node(i));
    const double x = 2 * std::asin(size * std::sin(angle));
    const double ring = pi * pi * rule.weight(i) * size * size *
                        std::sin(2 * angle) * std::cos(angle);
    load += ring * std::cos(x);
    for (int j = 0; j < turns; ++j) {
      const double turn = pi * (j + 0.5) / turns;
      const Eigen::Vector2d in =
          std::cos(x) * along + std::cos(turn) * std::sin(x) * across;
      const double out = std::sin(turn) * std::sin(x);
      const int k = i * turns + j;
      place.row(k) = in.transpose();
      force(k) = ring / turns;
      points.push_back({std::atan2(std::hypot(in.x(), out), in.y()),
                        std::atan2(out, in.x()), force(k)});
    }
  }
  const Eigen::VectorXd du = compliance_.under(points);
  const Eigen::VectorXd root = force.cwiseSqrt();
  const Eigen::MatrixX2d weighted = root.asDiagonal() * place;
  const Eigen::VectorXd goal = root.asDiagonal() * du;
  const Eigen::Vector2d shift = solve_least_squares(weighted, goal);
  const double rest = (goal - weighted * shift).norm() / root.norm();
  return {unit_ / load * shift, unit_ / load * rest};
}

}  // namespace contact::detail
