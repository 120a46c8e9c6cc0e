#include "libcontact/seat/patch.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/linear/solve.hpp"

namespace contact::detail {
namespace {

// Inside: pressures times the root of their longitude's weight, so that the
// operator is symmetric.
double dot(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.cwiseProduct(b).sum();
}

int columns_of(const Eigen::ArrayXXd& contact) {
  int columns = 0;
  for (int j = 0; j < contact.cols(); ++j) {
    if ((contact.col(j) > 0).any()) columns = j + 1;
  }
  return columns;
}

}  // namespace

SeatPatchSolver::SeatPatchSolver(const LayeredPair& pair,
                                 const SeatWindow& window, int cells, int order,
                                 double clearance,
                                 const SideFaceCompliance* side_face)
    : cells_(window, cells, pair.relative_thickness()),
      compliance_(pair, cells_, order, side_face),
      order_(order),
      clearance_(clearance),
      root_(Eigen::RowVectorXd::Ones(order + 1)),
      transform_(order + 1, order + 1) {
  root_(0) = root_(order) = std::sqrt(0.5);
  Eigen::RowVectorXd cosine(order + 1);
  for (int j = 0; j <= order; ++j) {
    cosine(j) = std::cos(longitude(j));
    for (int m = 0; m <= order; ++m) {
      transform_(j, m) = std::sqrt(2.0 / order) * root_(j) * root_(m) *
                         std::cos(pi * ((j * m) % (2 * order)) / order);
    }
  }
  lever_x_ = cells_.sine.matrix() * root_.cwiseProduct(cosine);
  lever_z_ = cells_.cosine.matrix() * root_;
  unit_ = cells_.unit.matrix() * root_;
}

double SeatPatchSolver::longitude(int j) const { return pi * j / order_; }

double SeatPatchSolver::longitude_weight(int j) const {
  return 2 * pi / order_ * root_(j) * root_(j);
}

SeatPatchSolver::Map SeatPatchSolver::gap_side(Eigen::Vector2d shift) const {
  return shift.x() * lever_x_ + shift.y() * lever_z_ - clearance_ * unit_;
}

double SeatPatchSolver::overlap(Eigen::Vector2d shift) const {
  return gap_side(shift).cwiseQuotient(unit_).maxCoeff();
}

// Q A_m Q applied to a matrix that is 0 beyond some columns; returns the same
// columns of the result, or all of them.
SeatPatchSolver::Map SeatPatchSolver::apply(const std::vector<Map>& by_order,
                                            const Map& of, int columns) const {
  const auto leading = std::min<Eigen::Index>(columns, of.cols());
  Map harmonics = of.leftCols(leading) * transform_.topRows(leading);
  Map result(of.rows(), of.cols());
  for (int m = 0; m <= order_; ++m) {
    result.col(m).noalias() = by_order[m] * harmonics.col(m);
  }
  harmonics.leftCols(leading).noalias() = result * transform_.leftCols(leading);
  harmonics.rightCols(of.cols() - leading).setZero();
  return harmonics;
}

void SeatPatchSolver::conjugate_gradients(const Map& right,
                                          const Eigen::ArrayXXd& contact,
                                          double tolerance,
                                          Map& solution) const {
  const int columns = columns_of(contact);
  const auto masked = [&](const Map& x) -> Map {
    return (x.array() * contact).matrix();
  };
  Map residual = masked(right - apply(compliance_.matrix, solution, columns));
  const double goal = tolerance * std::sqrt(dot(masked(right), masked(right)));
  Map direction = Map::Zero(right.rows(), right.cols());
  double before = 1;
  int count = 1;
  while (std::sqrt(dot(residual, residual)) > goal && count < 400) {
    const Map better = masked(apply(compliance_.inverse, residual, columns));
    const double now = dot(residual, better);
    direction = better + (count == 1 ? 0 : now / before) * direction;
    before = now;
    const Map image = masked(apply(compliance_.matrix, direction, columns));
    const double step = now / dot(direction, image);
    solution += step * direction;
    residual -= step * image;
    ++count;
  }
}

void SeatPatchSolver::solve(Eigen::Vector2d shift, SeatPatch& patch) const {
  const Map right = gap_side(shift);
  const double overlap = right.maxCoeff();
  if (patch.contact.size() == 0) {
    patch.contact = (right.array() > 0).cast<double>();
    patch.pressure = Map::Zero(right.rows(), right.cols());
  }
  const Map roots = root_.replicate(right.rows(), 1);
  Map y = patch.pressure.cwiseProduct(roots);
  // A coarse start is improved before its set is believed.
  constexpr double tolerances[] = {1e-4, 1e-4, 1e-6, 1e-6};
  constexpr double finest = 1e-9;
  patch.converged = false;
  for (int round = 0; round < 60 && !patch.converged; ++round) {
    const double tolerance = round < 4 ? tolerances[round] : finest;
    y = (y.array() * patch.contact).matrix();
    conjugate_gradients(right, patch.contact, tolerance, y);
    const Map gap = apply(compliance_.matrix, y, order_ + 1) - right;
    const auto outside = patch.contact == 0;
    const Eigen::ArrayXXd drop = (!outside && y.array() < 0).cast<double>();
    const Eigen::ArrayXXd add =
        (outside && gap.array() < -1e-7 * overlap).cast<double>();
    if (drop.sum() == 0 && add.sum() == 0) {
      patch.converged = tolerance == finest;
      round = std::max(round, 3);
    }
    patch.contact += add - drop;
  }
  const double weight = 2 * pi / order_;
  patch.pressure = y.cwiseQuotient(roots);
  patch.shift = shift;
  patch.force = weight * Eigen::Vector2d(dot(y, lever_x_), dot(y, lever_z_));
  patch.sum = weight * dot(y, unit_);
}

// Newton's method on D for the minimum of the convex U(D) - F.D.
void SeatPatchSolver::balance(Eigen::Vector2d force, SeatPatch& patch) const {
  double farthest = 1.5;
  Eigen::Vector2d shift = patch.shift, step(0, 0);
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 40; ++round) {
    solve(shift, patch);
    const Eigen::Vector2d rest = force - patch.force;
    // Ten times what the solution at a shift leaves. With interference the sum
    // of the pressures is much larger than the force.
    const double goal = 1e-8 * std::max(force.norm(), patch.sum);
    if (!patch.converged || rest.norm() <= goal) return;
    if (rest.norm() > 2 * before) {  // far beyond: half as far
      step /= 2;
      shift -= step;
      continue;
    }
    before = rest.norm();
    step = solve_symmetric(tangent(patch), rest);
    // By overlap: a narrow zone may need a long shift for a little of it. The
    // way to where a load beyond the rims is carried is long too.
    const double most = farthest * overlap(shift);
    const double change = (step.x() * lever_x_ + step.y() * lever_z_)
                              .cwiseQuotient(unit_)
                              .cwiseAbs()
                              .maxCoeff();
    if (change > most) {
      step *= most / change;
      farthest *= 2;
    }
    shift += step;
    if (!step.allFinite()) break;
    // So that something stays in contact.
    while (!(overlap(shift) > 0)) {
      step /= 2;
      shift -= step;
    }
  }
  patch.converged = false;
}

Eigen::Matrix2d SeatPatchSolver::tangent(const SeatPatch& patch) const {
  Eigen::Matrix2d k;
  const double weight = 2 * pi / order_;
  int column = 0;
  for (const Map* lever : {&lever_x_, &lever_z_}) {
    Map y = Map::Zero(lever->rows(), lever->cols());
    conjugate_gradients(*lever, patch.contact, 1e-4, y);
    k.col(column++) =
        weight * Eigen::Vector2d(dot(y, lever_x_), dot(y, lever_z_));
  }
  return (k + k.transpose()) / 2;
}

}  // namespace contact::detail
