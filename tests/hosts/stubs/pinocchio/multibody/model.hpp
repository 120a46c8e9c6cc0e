// Declarations of our own of what recipes/pinocchio.cpp uses of Pinocchio.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace pinocchio {

struct Model {};
struct Force {
  Eigen::Vector3d linear() const;
};
struct Data {
  explicit Data(const Model&);
  Eigen::MatrixXd M;
  std::vector<Force> f;
};

const Eigen::VectorXd& aba(const Model&, Data&, const Eigen::VectorXd& q,
                           const Eigen::VectorXd& v,
                           const Eigen::VectorXd& tau);
const Eigen::MatrixXd& crba(const Model&, Data&, const Eigen::VectorXd& q);
const Eigen::VectorXd& rnea(const Model&, Data&, const Eigen::VectorXd& q,
                            const Eigen::VectorXd& v, const Eigen::VectorXd& a);
Eigen::VectorXd integrate(const Model&, const Eigen::VectorXd& q,
                          const Eigen::VectorXd& v);

}  // namespace pinocchio
