#include "libcontact/load_law/minimax.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <limits>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/text.hpp"

namespace contact::detail {

MinimaxFit minimax_fit(Eigen::MatrixXd a, const Eigen::VectorXd& b,
                       int rows_of_one, int rounds) {
  const Eigen::Index points = b.size() / rows_of_one;
  const Eigen::RowVectorXd scale = a.colwise().norm();
  a.array().rowwise() /= scale.array();
  Eigen::ArrayXd weight = Eigen::ArrayXd::Ones(points);
  MinimaxFit best = {{}, std::numeric_limits<double>::infinity()};
  for (int round = 0; round < rounds; ++round) {
    const Eigen::ArrayXd root = weight.sqrt().replicate(rows_of_one, 1);
    const Eigen::VectorXd x = (a.array().colwise() * root)
                                  .matrix()
                                  .householderQr()
                                  .solve((b.array() * root).matrix());
    const Eigen::VectorXd all = a * x - b;
    const Eigen::ArrayXd residual =
        all.reshaped(points, rows_of_one).rowwise().norm();
    const double error = residual.maxCoeff();
    if (error < best.error) {
      best = {(x.array() / scale.transpose().array()).matrix(), error};
    }
    weight *= residual / error + 0.03;  // none is forgotten
    weight /= weight.mean();
  }
  return best;
}

void check_endless(const Joint& joint) {
  if (joint.is_endless()) return;
  throw Error(needs("a load law",
                    "a joint without a [seat] and a [relief], or "
                    "without_seat() and without_relief()"));
}

void check_loads(double low, double high) {
  if (low > 0 && low < high) return;
  throw Error(must_be(message("the loads {} and {} N of a load law", low, high),
                      "above 0, the first one less"));
}

Error out_of_reach(double wanted, double best) {
  return Error(must_be(
      fmt::format("an error of {} of the load law", wanted),
      fmt::format("at least {:.2g}, which is what all its numbers reach",
                  best)));
}

}  // namespace contact::detail
