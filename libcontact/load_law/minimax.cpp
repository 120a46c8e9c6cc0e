#include "libcontact/load_law/minimax.hpp"

#include <Eigen/QR>
#include <limits>

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

}  // namespace contact::detail
