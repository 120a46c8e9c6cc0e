#include "libcontact/conforming/kernel/ball_wall_kernel.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/special_functions/chebyshev.hpp>
#include <cmath>

#include "libcontact/base/constants.hpp"

namespace contact::detail {
namespace {

// cos and sin of products of x with numbers of few digits. The product of x's
// first 33 binary places is exact, and the rest is small: a rounding of angles
// of hundreds would be a rounding of the sum's terms that is as large.
class Waves {
 public:
  explicit Waves(const Eigen::VectorXd& x)
      : head_(x.unaryExpr([](double at) {
          constexpr double places = 0x1p33;
          return std::nearbyint(places * at) / places;
        })),
        rest_(x - head_) {}

  struct Both {
    Eigen::MatrixXd cosine;
    Eigen::MatrixXd sine;
  };
  Both operator()(const Eigen::RowVectorXd& number) const {
    const Eigen::ArrayXXd angle = head_ * number;
    const Eigen::ArrayXXd more = rest_ * number;
    const Eigen::ArrayXXd c =
        angle.unaryExpr([](double a) { return std::cos(a); });
    const Eigen::ArrayXXd s =
        angle.unaryExpr([](double a) { return std::sin(a); });
    return {c - more * s, s + more * c};
  }

 private:
  Eigen::VectorXd head_;
  Eigen::VectorXd rest_;
};

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
    const Waves waves(x);
    const auto inner =
        waves(Eigen::RowVectorXd::LinSpaced(block, 0.5, block - 0.5));
    const Eigen::Index blocks = weight_.cols();
    const auto outer = waves(Eigen::RowVectorXd::LinSpaced(
        blocks, 0, 1.0 * block * (static_cast<double>(blocks) - 1)));
    return ((inner.cosine * weight_).cwiseProduct(outer.cosine) -
            (inner.sine * weight_).cwiseProduct(outer.sine))
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
