#include "libcontact/identify/moment_model.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/magnitude.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/joint/slip/slip_equation.hpp"

namespace contact::detail {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Solves all states, each from its last solution on: the one place that knows
// which joints there are.
void solve_all(const JointContact& contact,
               std::span<const MeasuredMoment> states,
               std::vector<JointSolution>& solutions) {
  const Joint joint(contact);
  for (std::size_t i = 0; i < states.size(); ++i) {
    solutions[i] = joint.solve({.reaction = states[i].reaction,
                                .angular_velocity = states[i].angular_velocity},
                               solutions[i]);
  }
}

// Trial at any tan psi of a state, root or not: f/cos a, and the parts of M_t
// along w = Dw/|Dw| and along d, the direction of n normal to it.
Vector3d trial(const JointContact& contact, const JointSolution& solution,
               double tangent) {
  const SineCosine b = solution.reaction_direction;
  // Friction is dry: any speed will do.
  const SlipEquation equation(contact, 1, magnitude(solution.reaction),
                              {b.sin, std::abs(b.cos)});
  const SlipPoint p = equation.at(tangent);
  const SlipAxis a = {p.triangle.axis_sin, p.triangle.axis_cos};
  const double scale = contact.geometry().radius() * p.normal_force;
  return {
      p.friction, -scale * (p.sliding * a.cos + p.spinning * a.sin),
      std::copysign(scale, b.cos) * (p.sliding * a.sin - p.spinning * a.cos)};
}

// dM_t/dx from the slopes of trials, in a number x and in tan psi. As tan psi
// is f/cos a it moves by (df/cos a)/dx / (1 - (df/cos a)/dtan psi), and turns
// d.
Vector3d moment_slope(const MeasuredMoment& state,
                      const JointSolution& solution, const Vector3d& by_number,
                      const Vector3d& by_tangent) {
  const Vector3d w = state.angular_velocity.stableNormalized();
  const Vector3d turning = solution.slip_velocity.stableNormalized();
  // Exactly normal to w, also where n is w but for rounding.
  Vector3d d = turning.cross(w);
  if (solution.normal.dot(d) < 0) d = -d;
  const double tangent = solution.memory.tangent;
  const double move = by_number[0] / (1 - by_tangent[0]);
  const double turn = move / (1 + tangent * tangent);
  const Vector3d change = by_number + move * by_tangent;
  return change[1] * w + change[2] * d +
         turn * solution.friction_moment.dot(d) * turning;
}

// Puts a moment where the measured numbers of its state are.
template <class Numbers>
void put(Numbers&& numbers, const MeasuredMoment& state,
         const Vector3d& moment) {
  if (state.is_vector()) {
    numbers = moment;
  } else {
    numbers[0] = -moment.dot(state.angular_velocity.stableNormalized());
  }
}

// Bounds of MomentModel::range().
constexpr double least_relative_clearance = 1e-9;
constexpr double largest_relative_clearance = 0.9;
constexpr double largest_friction = 1e6;

// Points with f0 or A below 0, and their replacements.
bool is_inside(const Point& p) { return p[0] >= 0 && p[1] >= 0; }
Point inside(Point p) {
  p.head<2>() = p.head<2>().cwiseMax(0);
  return p;
}
Point mirrored(Point p) {
  p.head<2>() = p.head<2>().cwiseAbs();
  return p;
}

}  // namespace

MomentModel::MomentModel(JointContact joint,
                         std::span<const MeasuredMoment> states)
    : joint_(std::move(joint)), states_(states), last_(states.size()) {
  double force = 0;
  for (const MeasuredMoment& state : states_) {
    size_ += state.size();
    force += magnitude(state.reaction);
  }
  const JointGeometry& geometry = joint_.geometry();
  force /= static_cast<double>(states_.size());
  unit_ = geometry.nominal_pressure(force) + joint_.interference_pressure();
  moment_unit_ = geometry.radius() * (unit_ / geometry.nominal_pressure(1));
  beside_.resize(size_, 2);
  const Vector3d first = states_[0].angular_velocity.stableNormalized();
  Eigen::Index at = 0;
  for (const MeasuredMoment& state : states_) {
    const Vector3d turning = state.angular_velocity.stableNormalized();
    put(beside_.col(0).segment(at, state.size()), state,
        -moment_unit_ * turning);
    put(beside_.col(1).segment(at, state.size()), state, -moment_unit_ * first);
    at += state.size();
  }
  if (geometry.radial_clearance() <= 0) {
    length_ = 4 * geometry.radius() * unit_ / joint_.pair().effective_modulus();
  }
}

Point MomentModel::point(double coefficient, double adhesion,
                         double clearance) const {
  return {coefficient, adhesion / unit_,
          length_ > 0 ? clearance / length_ : std::log(clearance), 0, 0};
}

double MomentModel::clearance(const Point& p) const {
  return length_ > 0 ? p[2] * length_ : std::exp(p[2]);
}

double MomentModel::clearance_slope(const Point& p) const {
  return length_ > 0 ? length_ : std::exp(p[2]);
}

JointContact MomentModel::joint_at(const Point& p) const {
  return joint_.with_clearance(clearance(p))
      .with_friction(FrictionLaw(p[0], p[1] * unit_));
}

std::pair<double, double> MomentModel::range(int number) const {
  if (number < 2) return {0, largest_friction};
  if (number > 2) return {-largest_friction, largest_friction};
  const double radius = joint_.geometry().radius();
  if (length_ > 0) {
    const double largest = largest_relative_clearance * radius / length_;
    return {-largest, largest};
  }
  return {std::log(least_relative_clearance * radius),
          std::log(largest_relative_clearance * radius)};
}

bool MomentModel::is_usable(const Point& p) const {
  const Point size = mirrored(p);
  for (int number = 0; number < size.size(); ++number) {
    const auto [least, largest] = range(number);
    if (!(size[number] >= least && size[number] <= largest)) return false;
  }
  return true;
}

VectorXd MomentModel::solved(const Point& point) const {
  solve_all(joint_at(point), states_, last_);
  VectorXd all(size_);
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const MeasuredMoment& state = states_[i];
    const bool good = last_[i].status == Status::ok;
    put(all.segment(at, state.size()), state,
        good ? last_[i].friction_moment : Vector3d::Constant(nan));
    at += state.size();
  }
  return all;
}

VectorXd MomentModel::moments(const Point& point) const {
  if (!is_usable(point)) return VectorXd::Constant(size_, nan);
  return friction(point) + beside_ * point.tail<2>();
}

VectorXd MomentModel::friction(const Point& point) const {
  if (is_inside(point)) return solved(point);
  return 2 * solved(inside(point)) - solved(mirrored(point));
}

MatrixXd MomentModel::slopes(const Point& point,
                             const std::vector<int>& numbers) const {
  if (!is_usable(point)) {
    return MatrixXd::Constant(size_, numbers.size(), nan);
  }
  std::vector<int> of_friction = numbers;
  std::erase_if(of_friction, [](int number) { return number > 2; });
  const MatrixXd slopes = friction_slopes(point, of_friction);
  MatrixXd all(size_, numbers.size());
  Eigen::Index next = 0;
  for (Eigen::Index i = 0; i < all.cols(); ++i) {
    const int number = numbers[i];
    if (number > 2) {
      all.col(i) = beside_.col(number - 3);
    } else {
      all.col(i) = slopes.col(next++);
    }
  }
  return all;
}

MatrixXd MomentModel::friction_slopes(const Point& point,
                                      const std::vector<int>& numbers) const {
  if (is_inside(point)) return solved_slopes(point, numbers);
  // Below 0 the first part does not depend on the number, and the second one
  // grows as it falls.
  MatrixXd at_bound = 2 * solved_slopes(inside(point), numbers);
  MatrixXd beyond = solved_slopes(mirrored(point), numbers);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] == 2 || point[numbers[i]] >= 0) continue;
    at_bound.col(static_cast<Eigen::Index>(i)).setZero();
    beyond.col(static_cast<Eigen::Index>(i)) *= -1;
  }
  return at_bound - beyond;
}

// Step of the clearance and of the friction angle's tangent: its errors are the
// rounding of the integrals, 4e-15, over it, and its square.
constexpr double relative_step = 1e-5;

// The slope of a state's moment in a number of the point.
// @param moved  the joints of unit numbers, or a step apart
Vector3d MomentModel::slope_at(const std::vector<JointContact>& moved,
                               int number, std::size_t i,
                               const Vector3d& by_tangent) const {
  const MeasuredMoment& state = states_[i];
  const auto difference = [&](const auto& of) {
    const auto first = of(moved[0]);
    if (number < 2) return first;
    return decltype(first)((first - of(moved[1])) / (2 * relative_step));
  };
  if (state.reaction.isZero(0)) {  // interference alone
    const double slope = difference([](const JointContact& contact) {
      constexpr double any_speed = 1;
      return contact.unloaded_moment(any_speed);
    });
    return -slope * state.angular_velocity.stableNormalized();
  }
  const JointSolution& s = last_[i];
  const Vector3d by_number = difference([&](const JointContact& contact) {
    return trial(contact, s, s.memory.tangent);
  });
  return moment_slope(state, s, by_number, by_tangent);
}

MatrixXd MomentModel::solved_slopes(const Point& point,
                                    const std::vector<int>& numbers) const {
  solved(point);
  const JointContact contact = joint_at(point);
  std::vector<Vector3d> by_tangent;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const double tangent = last_[i].memory.tangent;
    const double move = relative_step * (1 + tangent);
    by_tangent.push_back(
        states_[i].reaction.isZero(0)
            ? Vector3d(Vector3d::Zero())
            : Vector3d((trial(contact, last_[i], tangent + move) -
                        trial(contact, last_[i], tangent - move)) /
                       (2 * move)));
  }
  MatrixXd all(size_, numbers.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const int number = numbers[k];
    // Friction is linear in f0 and A: the friction of 1 is the slope.
    std::vector<JointContact> moved;
    if (number < 2) {
      moved.push_back(contact.with_friction(
          number == 0 ? FrictionLaw(1, 0) : FrictionLaw(0, unit_)));
    } else {
      const Point step = relative_step * Point::Unit(number);
      moved = {joint_at(point + step), joint_at(point - step)};
    }
    Eigen::Index at = 0;
    for (std::size_t i = 0; i < states_.size(); ++i) {
      put(all.col(static_cast<Eigen::Index>(k)).segment(at, states_[i].size()),
          states_[i], slope_at(moved, number, i, by_tangent[i]));
      at += states_[i].size();
    }
  }
  return all;
}

}  // namespace contact::detail
