#include "libcontact/identify/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/NonLinearOptimization>

namespace contact::detail {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Some numbers of a point as MINPACK's unknowns.
class Unknowns {
 public:
  Unknowns(const MomentModel& model, const Measurements& measured,
           const VectorXd& weight, const Point& start,
           const std::vector<int>& free)
      : model_(model),
        measured_(measured),
        root_weight_(weight.cwiseSqrt()),
        start_(start),
        free_(free) {}

  Eigen::Index values() const { return model_.size(); }
  Point point(const VectorXd& x) const {
    Point all = start_;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      all[free_[i]] = x[static_cast<Eigen::Index>(i)];
    }
    return all;
  }
  int operator()(const VectorXd& x, VectorXd& residuals) const {
    residuals = root_weight_.cwiseProduct(
        measured_.residuals(model_.moments(point(x))));
    return 0;
  }
  int df(const VectorXd& x, MatrixXd& slopes) const {
    slopes = root_weight_.cwiseQuotient(measured_.sigma).asDiagonal() *
             model_.slopes(point(x), free_);
    return slopes.allFinite() ? 0 : -1;
  }

 private:
  const MomentModel& model_;
  const Measurements& measured_;
  VectorXd root_weight_;
  Point start_;
  const std::vector<int>& free_;
};

bool converged(Eigen::LevenbergMarquardtSpace::Status status) {
  using namespace Eigen::LevenbergMarquardtSpace;
  return status != ImproperInputParameters && status != UserAsked &&
         status != TooManyFunctionEvaluation && status != NotStarted &&
         status != Running;
}

// Without bounds.
Minimum unbounded(const MomentModel& model, const Measurements& measured,
                  const VectorXd& weight, const Point& start,
                  const std::vector<int>& free, double tolerance) {
  Unknowns unknowns(model, measured, weight, start, free);
  VectorXd x(free.size());
  for (std::size_t i = 0; i < free.size(); ++i) {
    x[static_cast<Eigen::Index>(i)] = start[free[i]];
  }
  Minimum found;
  found.inside = free;
  bool good = true;
  if (!free.empty()) {
    Eigen::LevenbergMarquardt<Unknowns> solver(unknowns);
    solver.parameters.xtol = tolerance;
    // Data that ask for more tell nothing.
    solver.parameters.maxfev = 100;
    solver.parameters.ftol = std::numeric_limits<double>::epsilon();
    good = converged(solver.minimize(x));
  }
  VectorXd residuals(model.size());
  unknowns(x, residuals);
  found.point = unknowns.point(x);
  found.chi2 = residuals.squaredNorm();
  if (good && std::isfinite(found.chi2)) found.status = Status::ok;
  return found;
}

}  // namespace

Minimum least_squares(const MomentModel& model, const Measurements& measured,
                      const VectorXd& weight, const Point& start,
                      const std::vector<int>& free, double tolerance) {
  Minimum found = unbounded(model, measured, weight, start, free, tolerance);
  for (;;) {
    const auto below = std::ranges::min_element(
        found.inside, {}, [&](int i) { return i < 2 ? found.point[i] : 0; });
    if (below == found.inside.end() || *below >= 2 || found.point[*below] >= 0)
      return found;
    std::vector<int> left = found.inside;
    std::erase(left, *below);
    Point at_bound = found.point;
    at_bound[*below] = 0;
    found = unbounded(model, measured, weight, at_bound, left, tolerance);
  }
}

double robust_scale(const VectorXd& residuals) {
  constexpr double normal_median = 0.6744897501960817;
  std::vector<double> sizes(residuals.begin(), residuals.end());
  for (double& size : sizes) size = std::abs(size);
  std::ranges::sort(sizes);
  const std::size_t n = sizes.size();
  return (sizes[(n - 1) / 2] + sizes[n / 2]) / 2 / normal_median;
}

HuberMinimum huber(const MomentModel& model, const Measurements& measured,
                   const Point& start, const std::vector<int>& free) {
  constexpr double tolerance = 1e-11;
  constexpr int most_steps = 200;
  // Floor for data without errors: rounding is no scale.
  const double least_scale =
      1e-11 * measured.moment.cwiseQuotient(measured.sigma).norm();
  HuberMinimum found;
  found.point = start;
  for (int step = 0; step < most_steps; ++step) {
    const VectorXd size =
        measured.residuals(model.moments(found.point)).cwiseAbs();
    found.scale = std::max(robust_scale(size), least_scale);
    found.weight =
        (huber_limit * found.scale * size.cwiseInverse()).cwiseMin(1);
    const Point last = found.point;
    static_cast<Minimum&>(found) =
        least_squares(model, measured, found.weight, found.point, free);
    if (found.status != Status::ok) return found;
    const Point change = found.point - last;
    Point numbers = found.point;
    numbers[2] = 0;  // a logarithm
    if (change.norm() <= tolerance * numbers.norm()) {
      return found;
    }
  }
  found.status = Status::not_converged;
  return found;
}

}  // namespace contact::detail
