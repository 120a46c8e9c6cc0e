#include "multibody/friction_guess.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "multibody/eigen_conversion.hpp"

namespace multibody {

using Eigen::Vector3d;

// Near the direction of R the axes of a ball joint's moment turn too fast.
constexpr double smallest_sine = 1e-2;

void FrictionGuess::set_units(const Reaction<double>& reaction,
                              const Vector3d& rate) {
  const auto reciprocal = [](double x) { return x > 0 ? 1 / x : 1; };
  per_force_ = reciprocal(vec3(reaction.force).norm());
  // Moments of smaller arms, m, are rounding.
  constexpr double smallest_arm = 1e-6;
  per_moment_ =
      reciprocal(std::max(vec3(reaction.moment).norm(),
                          smallest_arm * vec3(reaction.force).norm()));
  per_rate_ = reciprocal(rate.norm());
  slope_.setZero();
}

bool FrictionGuess::place(const Reaction<double>& reaction,
                          const Vector3d& rate, Place& place) const {
  const Vector3d force = vec3(reaction.force);
  if (is_axis_) {
    place.input << per_force_ * force, per_moment_ * reaction.moment.x,
        per_moment_ * reaction.moment.y, per_rate_ * rate.z();
    place.axes.setIdentity();
    place.size = 1 / per_force_;
    return true;
  }
  const double length = force.norm();
  const double speed = rate.norm();
  if (!(length > 0 && speed > 0)) return false;
  const Vector3d w = rate / speed;
  const Vector3d e = force / length;
  const Vector3d cross = w.cross(e);
  const double sine = cross.norm();
  if (!(sine > smallest_sine)) return false;
  const Vector3d q = cross / sine;
  place.input << per_force_ * length, w.dot(e), per_rate_ * speed, 0, 0, 0;
  place.axes << w, q.cross(w), q;
  place.size = length;
  return true;
}

bool FrictionGuess::predict(const Reaction<double>& reaction,
                            const Vector3d& rate, Vector3d& moment) const {
  Place at;
  if (!valid() || !place(reaction, rate, at)) return false;
  moment = at.size * (at.axes * (output_ + slope_ * (at.input - input_)));
  return moment.allFinite();
}

void FrictionGuess::learn(const Reaction<double>& reaction,
                          const Vector3d& rate, const Vector3d& moment) {
  if (solutions_ == 0) set_units(reaction, rate);
  Place at;
  if (!place(reaction, rate, at)) {
    forget();
    return;
  }
  const Vector3d output = at.axes.transpose() * moment / at.size;
  if (solutions_ > 0) {
    const Input move = at.input - input_;
    const double square = move.squaredNorm();
    // Shorter moves are drowned in the tolerance of the solutions.
    constexpr double shortest = 1e-8;
    if (square > shortest * shortest) {
      const Vector3d missed = output - output_ - slope_ * move;
      slope_ += missed / square * move.transpose();
    }
  }
  input_ = at.input;
  output_ = output;
  ++solutions_;
}

}  // namespace multibody
