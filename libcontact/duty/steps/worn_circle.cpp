#include "libcontact/duty/steps/worn_circle.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/linear/solve.hpp"
#include "libcontact/conforming/layer_compliance.hpp"

namespace contact::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

// C_n of both bodies, m/Pa. C_1 shifts the pin and nothing else; a pin in an
// infinite body has none, and any will do.
VectorXd compliances(const LayeredPair& pair, Index count) {
  using Side = LayerCompliance::Side;
  const double unit = 4 * pair.radius() / pair.surfaces().effective_modulus();
  const LayerCompliance inner(JointKind::pin, Side::inner, pair);
  const LayerCompliance outer(JointKind::pin, Side::outer, pair);
  VectorXd all(count);
  for (Index n = 0; n < count; ++n) {
    const int harmonic = static_cast<int>(n);
    all[n] = unit * (inner(harmonic).total + outer(harmonic).total);
  }
  if (std::isnan(all[1])) all[1] = all[2];
  return all;
}

}  // namespace

WornCircle::WornCircle(const LayeredPair& pair, int points)
    : radius_(pair.radius()),
      angle_(VectorXd::LinSpaced(points, 0, 2 * pi * (points - 1) / points)),
      lever_(points, 2),
      compliance_(points, points) {
  lever_ << angle_.array().cos(), angle_.array().sin();
  const Index last = size() / 2;
  const VectorXd c = compliances(pair, last + 1);
  mean_compliance_ = c[0];
  // u = mean over the points of p times this, at their distance; of the last
  // harmonic of an even number of points there is one of two.
  VectorXd share = 2 * c;
  share[0] /= 2;
  if (size() % 2 == 0) share[last] /= 2;
  const VectorXd harmonic = VectorXd::LinSpaced(last + 1, 0, double(last));
  VectorXd row(size());
  for (Index i = 0; i < size(); ++i) {
    row[i] = share.dot((harmonic * angle_[i]).array().cos().matrix()) /
             static_cast<double>(size());
  }
  for (Index i = 0; i < size(); ++i) {
    for (Index j = 0; j < size(); ++j) {
      compliance_(i, j) = row[std::abs(i - j)];
    }
  }
}

Index WornCircle::nearest(const Vector2d& load) const {
  const double turns = std::atan2(load.y(), load.x()) / (2 * pi);
  const Index i = std::lround(turns * static_cast<double>(size()));
  return (i + size()) % size();
}

WornCircle::Points WornCircle::first_points(const Vector2d& load,
                                            const VectorXd& gap,
                                            const Contact* last) const {
  Points points(static_cast<std::size_t>(size()));
  std::iota(points.begin(), points.end(), 0);
  if (last != nullptr && last->pressure[nearest(load)] > 0) {
    std::erase_if(points, [&](Index i) { return !(last->pressure[i] > 0); });
  } else if (!(gap.mean() < 0)) {  // in front
    const VectorXd cosine = lever_ * load.normalized();
    std::erase_if(points, [&](Index i) { return cosine[i] < std::sqrt(0.5); });
  }
  return points;
}

// Pressures and shift that carry the load if these points touch.
void WornCircle::balance(const Vector2d& load, const VectorXd& gap,
                         const CircleSprings& springs, const Points& touching,
                         Contact& contact) const {
  const double count = static_cast<double>(size());
  MatrixXd system = compliance_(touching, touching);
  system.array() += springs.mean / count;
  system.diagonal().array() += springs.local;
  factor_positive(system);
  // Fewer points than three cannot turn their force to the load's direction.
  const bool is_point = touching.size() < 3;
  MatrixXd lever = lever_(touching, Eigen::all);
  if (is_point) lever = lever * load.normalized();
  MatrixXd by_shift = lever;
  solve_factored(system, by_shift);
  VectorXd by_gap = gap(touching);
  solve_factored(system, by_gap);
  // P = 2 pi rho mean(p (cos, sin))
  VectorXd goal = load * count / (2 * pi * radius_);
  if (is_point) goal = goal.norm() * VectorXd::Ones(1);
  const MatrixXd stiffness = lever.transpose() * by_shift;
  const VectorXd shift =
      solve_symmetric(stiffness, goal + lever.transpose() * by_gap);
  contact.shift =
      is_point ? Vector2d(shift[0] * load.normalized()) : Vector2d(shift);
  contact.pressure = VectorXd::Zero(size());
  contact.pressure(touching) = by_shift * shift - by_gap;
}

WornCircle::Contact WornCircle::press(const Vector2d& load, const VectorXd& gap,
                                      const CircleSprings& springs,
                                      const Contact* last) const {
  constexpr int most = 100;
  const bool is_loaded = load.norm() > 0;
  const Vector2d towards = is_loaded ? load : Vector2d(1e-300, 0);
  Points touching = first_points(towards, gap, last);
  Contact contact;
  VectorXd open(size());
  for (int step = 0; step < most; ++step) {
    balance(towards, gap, springs, touching, contact);
    // Points that pull leave, points that overlap join.
    open = compliance_ * contact.pressure + gap - lever_ * contact.shift;
    open.array() += springs.mean * contact.pressure.mean();
    Points next;
    for (Index i = 0; i < size(); ++i) {
      const bool touches = contact.pressure[i] != 0;
      if (touches ? contact.pressure[i] > 0 : open[i] < 0) next.push_back(i);
    }
    if (next == touching) {
      contact.status = Status::ok;
      break;
    }
    touching = std::move(next);
    if (touching.empty() && is_loaded) touching = {nearest(load)};
    if (touching.empty()) {  // a gap all round
      contact.pressure = VectorXd::Zero(size());
      contact.status = Status::ok;
      return contact;
    }
  }
  contact.half_angle = half_arc(towards, contact.pressure, open);
  return contact;
}

// From the point of the load to the farthest on each side that touches, and on
// to where the gap begins, which grows as s^(3/2) there.
double WornCircle::half_arc(const Vector2d& load, const VectorXd& pressure,
                            const VectorXd& open) const {
  if ((pressure.array() > 0).all()) return pi;
  const Index middle = nearest(load);
  double sum = 0;
  for (const Index side : {Index{1}, Index{-1}}) {
    const auto at = [&](Index j) {
      return ((middle + side * j) % size() + size()) % size();
    };
    Index last = 0;
    for (Index j = 1; j < size() / 2; ++j) {
      if (pressure[at(j)] > 0) last = j;
    }
    const double near =
        std::cbrt(std::pow(std::max(open[at(last + 1)], 0.), 2));
    const double far = std::cbrt(std::pow(std::max(open[at(last + 2)], 0.), 2));
    const double begin = far > near ? near / (far - near) : 0;
    sum += static_cast<double>(last) + 1 - std::min(begin, 1.0);
  }
  return sum * pi / static_cast<double>(size());
}

WornCircle::Contact WornCircle::wear(const Vector2d& load, VectorXd& gap,
                                     const CircleSprings& growth,
                                     const Contact* last) const {
  static const double share = 1 - 1 / std::numbers::sqrt2;
  const CircleSprings stage{share * growth.local, share * growth.mean};
  const auto add = [&](const Contact& c, double part) {
    gap += part * growth.local * c.pressure;
    gap.array() += part * growth.mean * c.pressure.mean();
  };
  const Contact first = press(load, gap, stage, last);
  add(first, 1 - share);
  Contact second = press(load, gap, stage, &first);
  add(second, share);
  if (first.status != Status::ok) second.status = first.status;
  return second;
}

}  // namespace contact::detail
