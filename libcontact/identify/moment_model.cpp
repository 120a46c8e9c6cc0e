#include "libcontact/identify/moment_model.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "libcontact/joint/joint.hpp"

namespace contact::detail {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Solves all states, each from its last solution on: the one place that knows
// which joints there are.
void solve_all(const JointContact& contact,
               std::span<const MeasuredMoment> states,
               std::vector<JointSolution>& solutions) {
  const Joint joint(contact);
  for (std::size_t i = 0; i < states.size(); ++i) {
    solutions[i] = joint.solve(
        {.reaction = states[i].reaction, .angular_velocity = states[i].rate},
        solutions[i]);
  }
}

// Far beyond any fit that means something, and still a joint.
constexpr double least_relative_clearance = 1e-9;
constexpr double largest_relative_clearance = 0.9;

}  // namespace

MomentModel::MomentModel(JointContact joint,
                         std::span<const MeasuredMoment> states)
    : joint_(std::move(joint)), states_(states), last_(states.size()) {
  double force = 0;
  for (const MeasuredMoment& state : states_) {
    size_ += state.size();
    force += state.reaction.stableNorm();
  }
  unit_ = joint_.geometry().nominal_pressure(
      force / static_cast<double>(states_.size()));
}

Point MomentModel::point(double coefficient, double adhesion,
                         double clearance) const {
  return {coefficient, adhesion / unit_, std::log(clearance)};
}

JointContact MomentModel::joint_at(const Point& p) const {
  const double radius = joint_.geometry().radius();
  const double clearance =
      std::clamp(std::exp(p[2]), least_relative_clearance * radius,
                 largest_relative_clearance * radius);
  return joint_.with_clearance(clearance).with_friction(
      FrictionLaw(p[0], p[1] * unit_));
}

VectorXd MomentModel::solved(const Point& point) const {
  solve_all(joint_at(point), states_, last_);
  VectorXd all(size_);
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const MeasuredMoment& state = states_[i];
    const Vector3d& moment = last_[i].friction_moment;
    if (last_[i].status != Status::ok) {
      all.segment(at, state.size()).setConstant(nan);
    } else if (state.is_vector()) {
      all.segment<3>(at) = moment;
    } else {
      all[at] = -moment.dot(state.rate.stableNormalized());
    }
    at += state.size();
  }
  return all;
}

VectorXd MomentModel::moments(const Point& point) const {
  if (!point.allFinite() || point.head<2>().cwiseAbs().maxCoeff() > 1e6) {
    return VectorXd::Constant(size_, nan);
  }
  if (point[0] >= 0 && point[1] >= 0) return solved(point);
  Point inside = point;
  inside.head<2>() = inside.head<2>().cwiseMax(0);
  Point mirrored = point;
  mirrored.head<2>() = mirrored.head<2>().cwiseAbs();
  return 2 * solved(inside) - solved(mirrored);
}

VectorXd MomentModel::slope(const Point& point, int number) const {
  // Moments are so nearly linear in f0 and A that more does no harm; a
  // clearance that changes by 1e-4 changes them by some 1e-5.
  const double step =
      1e-4 * (number == 2 ? 1 : std::max(std::abs(point[number]), 0.01));
  const Point change = step * Point::Unit(number);
  return (moments(point + change) - moments(point - change)) / (2 * step);
}

Eigen::MatrixXd MomentModel::slopes(const Point& point,
                                    const std::vector<int>& numbers) const {
  Eigen::MatrixXd all(size_, numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    all.col(static_cast<Eigen::Index>(i)) = slope(point, numbers[i]);
  }
  return all;
}

}  // namespace contact::detail
