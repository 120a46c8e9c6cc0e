#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <variant>
#include <vector>

#include "multibody/dynamics/carrier_equations.hpp"
#include "multibody/dynamics/kernel/forest_kernel.hpp"
#include "multibody/system/system.hpp"

/// Bodies on bodies: the paper's two steps on any tree, one instant, with
/// hinge moments that may depend on the reactions.
///
/// Input and output of a body are in its own axes (origin: centre of mass); the
/// steps use the axes of its root, so that no vector is rotated between bodies.
/// The first step goes from the leaves to the roots: eliminating the rotation
/// in a hinge leaves a 6x6 matrix and a load on the parent. The second returns
/// with the accelerations. This is Featherstone's articulated-body algorithm;
/// (1.3) to (1.5) of the paper are its case of depth 1, which Dynamics computes
/// faster.
namespace multibody {

/// A body and the hinge to its parent.
struct ForestBody {
  /// Index of the parent; -1: a root. Any order, no circle.
  int parent = -1;
  HingeKind kind = HingeKind::none;  ///< not used for a root
  bool held = false;                 ///< the hinge does not turn
  /// Only for a root: fixed in inertial space, mass and inertia have no effect.
  bool fixed = false;
  double mass = 0;  ///< kg, > 0
  /// About the centre of mass, kg m^2.
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  /// Centre of the hinge from the centre of mass, body axes, m.
  Eigen::Vector3d hinge_from_com = Eigen::Vector3d::Zero();
  /// The same point from the parent's centre of mass, parent's axes, m.
  Eigen::Vector3d hinge_from_parent_com = Eigen::Vector3d::Zero();
  /// axis only: unit vector of the axis, body axes.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  /// Present place of the centre of mass. States, motions and points that refer
  /// to "the centre of mass" refer to 0 of the body axes. Body axes, m.
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
};

/// Results of an instant for a body, in its own axes.
struct ForestMotion {
  Eigen::Vector3d acceleration;          ///< centre of mass, m/s^2
  Eigen::Vector3d angular_acceleration;  ///< absolute, rad/s^2
  /// Derivative in body axes of the velocity relative to the parent; root: 0.
  Eigen::Vector3d relative_acceleration;
  Eigen::Vector3d reaction;  ///< force of the hinge on the body, N; root: 0
  /// Moment on the body about the hinge's centre, including the moment by the
  /// hinge's law, N m; root: 0.
  Eigen::Vector3d reaction_moment;
};

/// Workspace and results of an instant, for repeated use.
class ForestWork {
 public:
  ForestMotion motion(int body) const;
  /// Single quantities of a body; the acceleration refers to the hinge's
  /// centre, for a root to the centre of mass.
  Vec3<double> acceleration(int body) const {
    return own(body, parts_[body].linear);
  }
  Vec3<double> angular_acceleration(int body) const {
    return own(body, parts_[body].angular);
  }
  Vec3<double> relative_acceleration(int body) const {
    return own(body, parts_[body].turn);
  }
  /// As above for a turning axis, about it.
  double rate_change(int body) const { return parts_[body].rate_change; }
  Vec3<double> reaction(int body) const {
    return own(body, parts_[body].reaction);
  }
  Vec3<double> reaction_moment(int body) const {
    return own(body, parts_[body].reaction_moment);
  }

 private:
  friend class Forest;
  using Root = std::variant<CarrierSolver<double>,
                            Eigen::PartialPivLU<Eigen::Matrix<double, 6, 6>>>;
  // From the axes of the root.
  Vec3<double> own(int body, const detail::Padded& v) const {
    return transposed_times(mat3(parts_[body].rotation), vec3(v));
  }

  std::vector<detail::ForestPart> parts_;
  std::vector<Root> roots_;
  bool sloped_ = false;
};

/// A forest of bodies: each root and its descendants are solved separately.
class Forest {
 public:
  /// @param set  instruction set, a supported one
  /// @throws contact::Error naming the body: a missing parent, a circle (with
  ///   its bodies), a body that hangs on itself, a kind none on a parent, a
  ///   mass that is not > 0 and finite, an inertia, point or axis that is not
  ///   finite, an axis whose length differs from 1 by more than 1e-6, a fixed
  ///   body that is no root.
  explicit Forest(std::vector<ForestBody> bodies,
                  contact::InstructionSet set = contact::instruction_set());

  /// @param parent  the body's parent, or -1: becomes a root
  void set_hinge(int body, int parent, bool held);
  /// @param com  ForestBody::com
  void set_mass(int body, double mass, const Eigen::Vector3d& com,
                const Eigen::Matrix3d& inertia);
  void set_fixed(int root, bool fixed) { bodies_[root].fixed = fixed; }

  const detail::ForestKernel& kernel() const { return kernel_; }

  /// Accelerations and reactions in O(size). Error measured against Simbody 3.7
  /// on 18 trees of 2 to 64 bodies: 1e-11 of the largest component of its
  /// quantity, 1e-10 for light links below a heavy tip. NaN for a hinge whose
  /// body has no inertia about it, and for all bodies of its tree.
  /// @param state    one for each body
  /// @param gravity  inertial axes, m/s^2
  /// @throws contact::Error if `state` has another size
  std::vector<ForestMotion> solve(const std::vector<ForestState>& state,
                                  const Eigen::Vector3d& gravity) const;

  /// Evaluation in two parts, without gravity, which moves all bodies alike.
  /// Allocates only in the first call. First the part that depends on
  /// positions, velocities, active loads and slopes:
  /// @param sloped  false: slopes are taken as 0, which is faster
  void prepare(const std::vector<ForestState>& state, bool sloped,
               ForestWork& work) const;
  /// Then the rest, which may be repeated for other hinge moments and
  /// accelerations of fixed roots.
  void respond(const std::vector<ForestState>& state, ForestWork& work) const;

 private:
  detail::ForestBodies of(ForestWork& work) const {
    return {order_, hinges_.data(), work.parts_.data()};
  }

  std::vector<ForestBody> bodies_;
  std::vector<detail::ForestHinge> hinges_;
  std::vector<int> order_;  // children come after parents
  detail::ForestKernel kernel_;
};

}  // namespace multibody
