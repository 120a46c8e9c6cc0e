#pragma once

#include <Eigen/Core>

namespace contact_hosts::simbody {

/// Solves x = g(x) by Broyden's method, where x are the friction moments and
/// g(x) the moments for the reactions that x causes. It learns the effect of an
/// error on the solution and keeps it between evaluations. g depends weakly on
/// x, by the ratio of joint radius to distance of the masses.
class MomentFit {
 public:
  explicit MomentFit(double tolerance) : tolerance_(tolerance) {}

  /// Call before the first turn of an evaluation.
  void begin() { turns_ = 0; }

  /// Moves x to the start of the next turn.
  /// @param found  g(x)
  /// @return true if x is the solution: the error of the last turn, or the
  ///         expected error of the next one, is below the tolerance times the
  ///         largest moment
  bool turn(Eigen::VectorXd& x, const Eigen::VectorXd& found) {
    const Eigen::VectorXd wrong = found - x;
    const double now = wrong.norm();
    const double small = tolerance_ * found.lpNorm<Eigen::Infinity>();
    const bool is_first = turns_++ == 0;
    const double share = is_first ? 1 : now / left_;
    if (answer_.rows() != x.size() || (!is_first && !(share < 0.5))) {
      answer_.setIdentity(x.size(), x.size());
    } else if (!is_first) {
      learn(x - last_, wrong - last_wrong_);
    }
    last_ = x;
    last_wrong_ = wrong;
    left_ = now;
    x += answer_ * wrong;
    return now <= small || share * now <= small / 10;
  }

 private:
  // Updates the approximation so that -answer times the change of the error
  // gives the change of x.
  void learn(const Eigen::VectorXd& move, const Eigen::VectorXd& change) {
    const Eigen::VectorXd seen = answer_ * change;
    const double size = move.dot(seen);
    if (size == 0) return;
    const Eigen::RowVectorXd row = move.transpose() * answer_;
    answer_ -= (move + seen) * (row / size);
  }

  double tolerance_;
  int turns_ = 0;
  double left_ = 0;  // error of the last turn
  Eigen::VectorXd last_, last_wrong_;
  Eigen::MatrixXd answer_;
};

}  // namespace contact_hosts::simbody
