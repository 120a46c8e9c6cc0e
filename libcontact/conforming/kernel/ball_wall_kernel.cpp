#include "libcontact/conforming/kernel/ball_wall_kernel.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/special_functions/chebyshev.hpp>
#include <cmath>
#include <numbers>

namespace contact::detail {
namespace {

constexpr double pi = std::numbers::pi;

// sum_n weight_n cos((n + 1/2) x), n = block i + j: cosines of sums, so that
// few are evaluated, each to its last digit, and the rest is a product.
class CosineSum {
 public:
  explicit CosineSum(std::span<const double> correction)
      : weight_(Eigen::MatrixXd::Zero(
            block, (correction.size() + block - 1) / block)) {
    for (std::size_t n = 0; n < correction.size(); ++n) {
      weight_.data()[n] = (static_cast<double>(n) + 0.5) * correction[n];
    }
  }

  Eigen::VectorXd operator()(const Eigen::VectorXd& x) const {
    const auto cosine = [](double angle) { return std::cos(angle); };
    const auto sine = [](double angle) { return std::sin(angle); };
    const Eigen::MatrixXd inner =
        x * Eigen::RowVectorXd::LinSpaced(block, 0.5, block - 0.5);
    const Eigen::Index blocks = weight_.cols();
    const Eigen::MatrixXd outer =
        x * Eigen::RowVectorXd::LinSpaced(
                blocks, 0, 1.0 * block * (static_cast<double>(blocks) - 1));
    const Eigen::MatrixXd cosines = inner.unaryExpr(cosine) * weight_;
    const Eigen::MatrixXd sines = inner.unaryExpr(sine) * weight_;
    return (cosines.cwiseProduct(outer.unaryExpr(cosine)) -
            sines.cwiseProduct(outer.unaryExpr(sine)))
        .rowwise()
        .sum();
  }

 private:
  static constexpr int block = 64;
  Eigen::MatrixXd weight_;
};

}  // namespace

BallWallKernel::BallWallKernel(std::span<const double> correction,
                               double thickness) {
  const CosineSum sum(correction);
  double start = 0;
  while (start < pi) {
    const double end = std::min(start == 0 ? 2 * thickness : 2 * start, pi);
    Eigen::VectorXd angle(terms);
    Eigen::VectorXd x(terms);
    for (int i = 0; i < terms; ++i) {
      angle(i) = pi * (i + 0.5) / terms;
      x(i) = start + (end - start) * (1 + std::cos(angle(i))) / 2;
    }
    const Eigen::VectorXd value = sum(x);
    Panel panel{end, {}};
    for (int k = 0; k < terms; ++k) {
      panel.series[k] =
          2.0 / terms * (k * angle).array().cos().matrix().dot(value);
    }
    panels_.push_back(panel);
    start = end;
  }
}

double BallWallKernel::operator()(double x) const {
  if (x > pi) return -(*this)(2 * pi - x);
  const auto panel = std::ranges::lower_bound(panels_, x, {}, &Panel::end);
  const double start = panel == panels_.begin() ? 0 : (panel - 1)->end;
  return boost::math::chebyshev_clenshaw_recurrence(
      panel->series, terms, 2 * (x - start) / (panel->end - start) - 1);
}

}  // namespace contact::detail
