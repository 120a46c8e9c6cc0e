#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "multibody/motion/equations.hpp"

namespace multibody {

/// Jumps of the velocities by impulses in hinges.
class Impulse {
 public:
  /// Keeps references to its arguments.
  explicit Impulse(const Equations& equations)
      : equations_(equations), dynamics_(equations.system) {}

  /// A hinge with its relative velocity after the jump, link axes.
  struct Target {
    int body;
    Eigen::Vector3d rate;
    /// Ball joint: only the component of the rate along this unit vector jumps
    /// to that of `rate`, and it turns freely about the normals.
    std::optional<Eigen::Vector3d> along = {};
  };
  struct Jump {
    Eigen::Vector3d impulse;  ///< moment over time, link axes, N m s
    double loss;              ///< energy loss, J
    /// Response of its rate to a unit impulse about z, or along the target's
    /// unit vector, 1/(kg m^2).
    double response;
  };

  /// One impulse in several hinges at once. Velocities jump like accelerations
  /// under moments with all bodies at rest: the momentum is conserved.
  /// @param ideal  resting hinges turn freely, and ball joints off their stops;
  ///   else they hold, and these turn along their stops. Locked hinges hold.
  /// @return one for each target
  std::vector<Jump> apply(double time, const std::vector<Target>& targets,
                          bool ideal, std::vector<double>& state);

 private:
  std::vector<Jump> apply(const std::vector<Target>& targets, bool ideal,
                          std::vector<double>& state);
  /// A component of a target's moment.
  struct Unknown {
    std::size_t target;
    int body;
    Eigen::Vector3d direction;
  };
  std::vector<Target> along_stops(const std::vector<Target>& targets,
                                  const std::vector<double>& state) const;
  std::vector<double> make_still(const std::vector<Target>& targets, bool ideal,
                                 const std::vector<double>& state);
  void evaluate(const std::vector<double>& still);
  Eigen::MatrixXd mobility(const std::vector<Unknown>& unknowns,
                           const std::vector<double>& still);
  void add_jump(const std::vector<double>& still,
                std::vector<double>& state) const;

  const Equations& equations_;
  Dynamics dynamics_;
  ActiveForces<double> moments_;
  std::vector<BodyMass> masses_;
};

}  // namespace multibody
