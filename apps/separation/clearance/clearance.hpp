#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "multibody/system/force_model.hpp"
#include "separation/case/shape.hpp"

namespace separation {

/// Smallest distances between bodies on their way (FCL).
///
/// Accuracy: 1e-5 m plus 1e-5 of the distance for solids of some metres, any
/// pair of kinds, against the widest gap between parallel planes
/// (separation/parts_test.cpp).
class Clearance {
 public:
  /// Two bodies, numbered as in `shapes`.
  struct Pair {
    int a;
    int b;
  };

  /// @param shapes  of each body, from its centre of mass, body axes; a body
  ///                may have none
  /// @param pairs   of bodies that have some
  Clearance(const std::vector<std::vector<Shape>>& shapes,
            std::vector<Pair> pairs);
  ~Clearance();
  Clearance(Clearance&&) noexcept;
  Clearance& operator=(Clearance&&) noexcept;

  const std::vector<Pair>& pairs() const { return pairs_; }

  /// Distance of each pair, m; 0 if they overlap, NaN if it was not found.
  std::vector<double> distances(std::span<const multibody::BodyMotion> bodies);
  /// Of one of them.
  double distance(std::size_t pair,
                  std::span<const multibody::BodyMotion> bodies);

 private:
  struct Solids;
  void place(int body, const multibody::BodyMotion& motion,
             const Eigen::Vector3d& origin);
  std::unique_ptr<Solids> solids_;
  std::vector<Pair> pairs_;
};

}  // namespace separation
