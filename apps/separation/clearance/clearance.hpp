#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <utility>
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

  /// Where the bodies of a pair are nearest to each other, inertial axes, m;
  /// nothing if they overlap or it was not found.
  std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> nearest_points(
      std::span<const multibody::BodyMotion> bodies, std::size_t pair);

 private:
  struct Solids;
  struct Nearest;
  void place(const Pair& pair, std::span<const multibody::BodyMotion> bodies);
  Nearest nearest(const Pair& pair) const;

  std::unique_ptr<Solids> solids_;
  std::vector<Pair> pairs_;
};

}  // namespace separation
