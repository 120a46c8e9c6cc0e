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
/// What comes in and goes out of a body is in its own axes (origin: centre of
/// mass); the steps are taken in the axes of its root, so that nothing turns on
/// the way from body to body. The first step goes from the leaves to the roots:
/// what is left of a body when the turn in its hinge is eliminated is a 6x6
/// matrix and a load of its parent. The second goes back with the
/// accelerations. It is Featherstone's articulated-body algorithm; (1.3) to
/// (1.5) of the paper are its case of depth 1, which Dynamics resolves faster.
namespace multibody {

/// A body and the hinge by which it hangs on its parent.
struct ForestBody {
  /// Index of the body it hangs on; -1: a root. Any order, no circle.
  int parent = -1;
  HingeKind kind = HingeKind::none;  ///< of a root: not used
  bool held = false;                 ///< the hinge does not turn
  /// A root alone: it stands in inertial space, mass and inertia do not count.
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
};

/// What an instant gives of a body, its own axes.
struct ForestMotion {
  Eigen::Vector3d acceleration;          ///< of the centre of mass, m/s^2
  Eigen::Vector3d angular_acceleration;  ///< absolute, rad/s^2
  /// Derivative in body axes of the velocity against the parent; root: 0.
  Eigen::Vector3d relative_acceleration;
  Eigen::Vector3d reaction;  ///< force of the hinge on the body, N; root: 0
  /// Moment on the body about the hinge's centre, the moment by the law of
  /// the hinge included, N m; root: 0.
  Eigen::Vector3d reaction_moment;
};

/// What an instant needs besides, to use again, and what it gives.
class ForestWork {
 public:
  ForestMotion motion(int body) const;
  /// Single quantities of it; the acceleration that of the hinge's centre, of a
  /// root that of the centre of mass.
  Vec3<double> acceleration(int body) const {
    return own(body, parts_[body].linear);
  }
  Vec3<double> angular_acceleration(int body) const {
    return own(body, parts_[body].angular);
  }
  Vec3<double> relative_acceleration(int body) const {
    return own(body, parts_[body].turn);
  }
  /// The same of an axis that turns, about it.
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

/// A forest of bodies: each root with what hangs on it is solved by itself.
class Forest {
 public:
  /// @param set  instruction set, a supported one
  /// @throws contact::Error naming the body: a parent that is not there, a
  ///   circle (with its bodies), a body that hangs on itself, a kind none on a
  ///   parent, a mass that is not > 0 and finite, an inertia, point or axis
  ///   that is not finite, an axis off the length 1 by more than 1e-6, a fixed
  ///   body that is no root.
  explicit Forest(std::vector<ForestBody> bodies,
                  contact::InstructionSet set = contact::instruction_set());

  /// @param parent  the body's own, or -1: a root from now on
  void set_hinge(int body, int parent, bool held);
  void set_fixed(int root, bool fixed) { bodies_[root].fixed = fixed; }

  const detail::ForestKernel& kernel() const { return kernel_; }

  /// Accelerations and reactions in O(size). Error measured against Simbody
  /// 3.7 on 18 trees of 2 to 64 bodies: 1e-11 of the largest component of its
  /// quantity, 1e-10 for light links below a heavy tip. NaN where a hinge
  /// cannot turn its body (no inertia about it), and in what hangs together
  /// with it.
  /// @param state    one for each body
  /// @param gravity  inertial axes, m/s^2
  /// @throws contact::Error if `state` has another size
  std::vector<ForestMotion> solve(const std::vector<ForestState>& state,
                                  const Eigen::Vector3d& gravity) const;

  /// The same in two parts, without gravity, which moves all bodies alike.
  /// Nothing allocates but the first time. First what depends on positions,
  /// velocities, active loads and slopes:
  /// @param sloped  false: slopes count as 0, for less work
  void prepare(const std::vector<ForestState>& state, bool sloped,
               ForestWork& work) const;
  /// Then the rest, also for other hinge moments and accelerations of fixed
  /// roots.
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
