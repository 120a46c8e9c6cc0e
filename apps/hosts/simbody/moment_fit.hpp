#pragma once

#include <Eigen/Core>

namespace contact_hosts::simbody {

/// Moments x that are those of the reactions which they cause, x = g(x), by
/// Broyden's method: how the answer depends on what is wrong is learned, and
/// kept from one evaluation to the next. g hardly depends on x, by the joint's
/// radius over the distance of the masses.
class MomentFit {
 public:
  explicit MomentFit(double tolerance) : tolerance_(tolerance) {}

  /// Before the first turn of an evaluation.
  void begin() { turns_ = 0; }

  /// Takes x to where the next turn begins.
  /// @param found  g(x)
  /// @return whether x is the answer: the last turn was wrong by the tolerance
  ///         times the largest moment, or the next one will be
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
  // So that answer times -change of what is wrong is the change of x.
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
