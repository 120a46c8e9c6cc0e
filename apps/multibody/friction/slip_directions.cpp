#include "multibody/friction/slip_directions.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "multibody/system/eigen_conversion.hpp"

namespace multibody {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

bool is_driven(const Hinges& hinges, int body) {
  const Hinge& hinge = hinges[body];
  constexpr double rounding = 1e-8;
  const HingeMemory& memory = hinges.memory(body);
  const double along = hinges.acceleration(body).dot(memory.direction);
  double pace = hinge.is_axis ? 0 : memory.pace;
  // In a deeper tree rounding of the neighbours' friction moves it too.
  for (int i = 0; i < hinges.size() && hinges.is_tree(); ++i) {
    pace = std::max(pace, hinges.acceleration(i).norm());
  }
  return along < -rounding * pace;
}

std::vector<Vector3d> SlipDirections::get() const {
  std::vector<Vector3d> all;
  for (const Onset& ball : balls_) {
    all.push_back(hinges_.memory(ball.body).direction);
  }
  return all;
}

void SlipDirections::set(const std::vector<Vector3d>& directions) {
  for (std::size_t k = 0; k < directions.size(); ++k) {
    memory(k).direction = directions[k];
  }
}

// Components along the tangents, in units of the accelerations: 0 at a
// solution.
bool SlipDirections::across(VectorXd& parts) {
  if (!evaluate_()) return false;
  for (std::size_t k = 0; k < balls_.size(); ++k) {
    const Vector3d alpha = hinges_.acceleration(balls_[k].body);
    const Vector3d& u = memory(k).direction;
    parts.segment<2>(2 * k) = tangents_.middleCols<2>(2 * k).transpose() *
                              (alpha - alpha.dot(u) * u) / memory(k).pace;
  }
  return true;
}

// Newton's method with slopes by differences. Iterating with the direction of
// the acceleration may not converge, because the contact turns about R with it.
bool SlipDirections::settle() {
  const Eigen::Index size = tangents_.cols();
  std::vector<Vector3d> from;
  const auto turn = [&](const VectorXd& step) {
    for (std::size_t k = 0; k < balls_.size(); ++k) {
      memory(k).direction =
          (from[k] + tangents_.middleCols<2>(2 * k) * step.segment<2>(2 * k))
              .normalized();
    }
  };
  constexpr int step_limit = 60;
  constexpr double tolerance = 1e-9;
  // Limits steps to the validity of the slopes.
  constexpr double longest = 0.5;
  VectorXd left(size), other(size);
  for (int step = 0; step < step_limit; ++step) {
    from = get();
    for (std::size_t k = 0; k < from.size(); ++k) {
      const Vector3d t = from[k].unitOrthogonal();
      tangents_.middleCols<2>(2 * k) << t, from[k].cross(t);
    }
    if (!across(left)) return false;
    if (left.cwiseAbs().maxCoeff() <= tolerance) return true;
    constexpr double h = 1e-6;
    MatrixXd slopes(size, size);
    for (Eigen::Index j = 0; j < size; ++j) {
      turn(h * VectorXd::Unit(size, j));
      if (!across(other)) return false;
      slopes.col(j) = (other - left) / h;
    }
    VectorXd change = -slopes.fullPivLu().solve(left);
    change *= std::min(1.0, longest / change.cwiseAbs().maxCoeff());
    bool nearer = false;
    for (double share = 1; share > 1e-4 && !nearer; share /= 2) {
      turn(share * change);
      if (!across(other)) return false;
      nearer = other.norm() < left.norm();
    }
    if (!nearer) return false;
  }
  return false;
}

// Starts where resting joints give way; if that fails, from the motion allowed
// by frozen contacts (MomentSet::prox), then from the motion without friction,
// and last in small steps.
bool SlipDirections::find() {
  if (balls_.empty()) return true;
  const auto settled = [&] {
    return settle() && std::ranges::none_of(balls_, [&](const Onset& ball) {
             return is_driven(hinges_, ball.body);
           });
  };
  std::vector<Vector3d> free, frozen;
  for (const Onset& ball : balls_) {
    const Hinges::Felt feels = hinges_.felt(ball.body);
    HingeMemory& hinge = hinges_.memory(ball.body);
    free.push_back(feels.free.normalized());
    const Vector3d rate =
        hinges_[ball.body].solver.prox(feels.inertia, feels.free, hinge.solver);
    frozen.push_back(rate.isZero(0) ? hinge.direction : rate.normalized());
    const Vector3d alpha = hinges_.acceleration(ball.body);
    hinge.pace = std::max(feels.free.norm(), (feels.free - alpha).norm());
  }
  if (settled()) return true;
  for (const std::vector<Vector3d>& start : {frozen, free}) {
    set(start);
    if (settled()) return true;
  }
  return follow_excess();
}

// Follows the moments on the bodies in small steps, from the limit of the
// resting joints, where the directions are known, to their present values.
bool SlipDirections::follow_excess() {
  std::vector<Vec3<double>> full;
  for (const Onset& ball : balls_) {
    full.push_back(hinges_.forces().bodies[ball.body].moment);
    hinges_.memory(ball.body).direction = ball.direction;
  }
  const auto set_share = [&](double share) {
    for (std::size_t k = 0; k < balls_.size(); ++k) {
      const Vector3d less = (1 - share) * balls_[k].excess;
      hinges_.forces().bodies[balls_[k].body].moment = full[k] - vec3(less);
    }
  };
  double done = 0;
  double step = 1.0 / 16;
  constexpr double least = 1e-4;
  while (done < 1 && step > least) {
    const std::vector<Vector3d> before = get();
    const double next = std::min(1.0, done + step);
    set_share(next);
    if (settle()) {
      done = next;
      step *= 2;
      continue;
    }
    set(before);
    step /= 4;
  }
  set_share(1);
  return done == 1 && settle();
}

}  // namespace multibody
