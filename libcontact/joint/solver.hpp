#pragma once

#include <Eigen/Core>
#include <span>

#include "libcontact/joint/contact.hpp"
#include "libcontact/joint/solution.hpp"

/// Vectors of a joint around its scalar equation. What is said of a ball
/// holds for a pin with R normal to Dw.
namespace contact::detail {

/// From the reaction R.
/// @param last  an earlier solution of the same joint to start from, or null
JointSolution solve_reaction(const JointContact& contact,
                             const Eigen::Vector3d& reaction,
                             const Eigen::Vector3d& rate,
                             const JointSolution* last,
                             const SolveOptions& options) noexcept;

/// From the normal force R_n n: no equation to solve.
JointSolution solve_contact(const JointContact& contact,
                            const Eigen::Vector3d& normal_force,
                            const Eigen::Vector3d& rate) noexcept;

/// The paper's inner loop.
FixedPointResult fixed_point(const JointContact& contact,
                             const Eigen::Vector3d& reaction,
                             const Eigen::Vector3d& rate,
                             std::span<FixedPointStep> trace, double tolerance,
                             int step_limit, double start) noexcept;

}  // namespace contact::detail
