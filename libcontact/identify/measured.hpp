#pragma once

#include <Eigen/Core>
#include <variant>

namespace contact {

/// A friction moment that was measured while a joint slides.
struct MeasuredMoment {
  Eigen::Vector3d reaction;          ///< R on the body, N; not 0
  Eigen::Vector3d angular_velocity;  ///< Dw, rad/s; not 0
  /// The moment that it takes to turn the joint, -M_t . Dw/|Dw|, or the vector
  /// M_t on the body; N m.
  std::variant<double, Eigen::Vector3d> moment;
  /// Standard error of the moment, or of each component, N m; > 0. Their ratios
  /// alone count.
  double sigma;

  bool is_vector() const {
    return std::holds_alternative<Eigen::Vector3d>(moment);
  }
  /// How many numbers that are: 1 or 3.
  int size() const { return is_vector() ? 3 : 1; }
};

}  // namespace contact
