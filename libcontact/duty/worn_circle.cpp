#include "libcontact/duty/worn_circle.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>
#include <numeric>

#include "libcontact/conforming/layer_compliance.hpp"

namespace contact::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double pi = std::numbers::pi;

// C_n of both bodies, m/Pa. That of n = 1 shifts the pin and nothing else; a
// pin in an infinite body has none.
VectorXd compliances(const LayeredPair& pair, Index count) {
  using Side = LayerCompliance::Side;
  const double unit = 4 * pair.radius() / pair.surfaces().effective_modulus();
  const LayerCompliance inner(JointKind::pin, Side::inner, pair);
  const LayerCompliance outer(JointKind::pin, Side::outer, pair);
  VectorXd all(count);
  for (Index n = 0; n < count; ++n) {
    const int harmonic = static_cast<int>(n);
    const double c = inner(harmonic).total + outer(harmonic).total;
    all[n] = std::isnan(c) ? 0 : unit * c;
  }
  return all;
}

std::vector<Index> first_points(Index count) {
  std::vector<Index> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace

WornCircle::WornCircle(const LayeredPair& pair, int intervals)
    : radius_(pair.radius()),
      angle_(VectorXd::LinSpaced(intervals + 1, 0, pi)),
      cosine_(angle_.array().cos()),
      weight_(VectorXd::Constant(intervals + 1, 1.0 / intervals)) {
  weight_[0] /= 2;
  weight_[intervals] /= 2;
  const VectorXd c = compliances(pair, size());
  mean_compliance_ = c[0];
  // p_n = 2 mean(p cos nt), but the last one, which the points see as itself
  // and its mirror image.
  MatrixXd harmonics(size(), size());
  for (Index n = 0; n < size(); ++n) {
    harmonics.col(n) = (static_cast<double>(n) * angle_).array().cos();
  }
  VectorXd share = 2 * c;
  share[0] /= 2;
  share[intervals] /= 2;
  compliance_ = harmonics * share.asDiagonal() * harmonics.transpose();
}

WornCircle::Contact WornCircle::press(double load, const VectorXd& gap,
                                      const CircleSprings& springs,
                                      const Contact* last) const {
  // P = pi rho p_1, p_1 = 2 mean(p cos t)
  const double first = load / (2 * pi * radius_);
  constexpr int most = 100;
  // All round, or in front.
  std::vector<Index> touching =
      first_points(mean(gap) < 0 ? size() : size() / 4);
  if (last != nullptr) {
    std::erase_if(touching, [&](Index i) { return !(last->pressure[i] > 0); });
  }
  Contact contact;
  VectorXd yielding(size());
  for (int step = 0; step < most; ++step) {
    const VectorXd w = weight_(touching);
    MatrixXd system = compliance_(touching, touching);
    system.array() += springs.mean;
    system = (w.asDiagonal() * system * w.asDiagonal()).eval();
    system.diagonal() += springs.local * w;
    const Eigen::LLT<MatrixXd> solver(system);
    const VectorXd cosine = w.cwiseProduct(cosine_(touching));
    const VectorXd by_shift = solver.solve(cosine);
    const VectorXd by_gap = solver.solve(w.cwiseProduct(gap(touching)));
    contact.shift = (first + cosine.dot(by_gap)) / cosine.dot(by_shift);
    contact.pressure = VectorXd::Zero(size());
    contact.pressure(touching) = contact.shift * by_shift - by_gap;
    // Those that pull leave, those that overlap join.
    yielding = compliance_ * weight_.cwiseProduct(contact.pressure) + gap -
               contact.shift * cosine_;
    yielding.array() += springs.mean * mean(contact.pressure);
    std::vector<Index> next;
    for (Index i = 0; i < size(); ++i) {
      const bool touches = contact.pressure[i] != 0;
      if (touches ? contact.pressure[i] > 0 : yielding[i] < 0) {
        next.push_back(i);
      }
    }
    if (next == touching) {
      contact.status = Status::ok;
      break;
    }
    touching = std::move(next);
    if (touching.empty() && load > 0) touching = {0};
    if (touching.empty()) {  // a gap all round
      contact.pressure = VectorXd::Zero(size());
      contact.status = Status::ok;
      return contact;
    }
  }
  const double spacing = pi / static_cast<double>(size() - 1);
  contact.half_angle =
      std::min(pi, (static_cast<double>(touching.size()) - 0.5) * spacing);
  if (static_cast<Index>(touching.size()) == size()) contact.half_angle = pi;
  return contact;
}

WornCircle::Contact WornCircle::wear(double load, VectorXd& gap,
                                     const CircleSprings& growth,
                                     const Contact* last) const {
  static const double share = 1 - 1 / std::numbers::sqrt2;
  const CircleSprings stage{share * growth.local, share * growth.mean};
  const auto add = [&](const Contact& c, double part) {
    gap += part * growth.local * c.pressure;
    gap.array() += part * growth.mean * mean(c.pressure);
  };
  const Contact first = press(load, gap, stage, last);
  add(first, 1 - share);
  Contact second = press(load, gap, stage, &first);
  add(second, share);
  if (first.status != Status::ok) second.status = first.status;
  return second;
}

}  // namespace contact::detail
