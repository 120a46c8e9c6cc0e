#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "multibody/friction/coupled_impl.hpp"
#include "multibody/system/eigen_conversion.hpp"

// Which resting hinges hold and which begin to slide.
namespace multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

}  // namespace

CoupledDynamics::Impl::Felt CoupledDynamics::Impl::felt(int body) {
  joints(body);  // for the convex problem
  const Matrix3d mobility = response(body).acceleration;
  const Vector3d alpha = vec3(dynamics.relative_acceleration(body));
  const Matrix3d inertia = mobility.inverse();
  return {0.5 * (inertia + inertia.transpose()),
          alpha - mobility * hinges[body].moment};
}

// A ball joint that begins to slide does so in the direction u of its own
// acceleration, on which its contact and so its friction depend: the parts of
// the accelerations across u have to vanish. They are returned in units of
// the accelerations, 2 numbers for each joint, along the tangents.
bool CoupledDynamics::Impl::across(const std::vector<int>& balls,
                                   const MatrixXd& tangents, VectorXd& parts) {
  if (evaluate(state_, *forces_).status != CoupledStatus::ok) return false;
  for (std::size_t k = 0; k < balls.size(); ++k) {
    const Hinge& hinge = hinges[balls[k]];
    const Vector3d alpha = vec3(dynamics.relative_acceleration(balls[k]));
    const Vector3d& u = hinge.direction;
    parts.segment<2>(2 * k) = tangents.middleCols<2>(2 * k).transpose() *
                              (alpha - alpha.dot(u) * u) / hinge.pace;
  }
  return true;
}

// Newton's method with slopes by differences. Going on with the direction of
// the acceleration instead may take forever: the contact turns about R with
// it.
bool CoupledDynamics::Impl::settle_directions(const std::vector<int>& balls) {
  const auto size = static_cast<Eigen::Index>(2 * balls.size());
  MatrixXd tangents(3, size);
  std::vector<Vector3d> from(balls.size());
  const auto set_tangents = [&] {
    for (std::size_t k = 0; k < balls.size(); ++k) {
      const Vector3d u = hinges[balls[k]].direction;
      const Vector3d t = u.unitOrthogonal();
      from[k] = u;
      tangents.col(2 * k) = t;
      tangents.col(2 * k + 1) = u.cross(t);
    }
  };
  const auto turn = [&](const VectorXd& step) {
    for (std::size_t k = 0; k < balls.size(); ++k) {
      hinges[balls[k]].direction =
          (from[k] + tangents.middleCols<2>(2 * k) * step.segment<2>(2 * k))
              .normalized();
    }
  };
  constexpr int step_limit = 60;
  constexpr double tolerance = 1e-9;
  // Longer steps leave what slopes are good for.
  constexpr double longest = 0.5;
  VectorXd left(size), other(size);
  for (int step = 0; step < step_limit; ++step) {
    set_tangents();
    if (!across(balls, tangents, left)) return false;
    if (left.cwiseAbs().maxCoeff() <= tolerance) return true;
    constexpr double h = 1e-6;
    MatrixXd slopes(size, size);
    for (Eigen::Index j = 0; j < size; ++j) {
      turn(h * VectorXd::Unit(size, j));
      if (!across(balls, tangents, other)) return false;
      slopes.col(j) = (other - left) / h;
    }
    VectorXd change = -slopes.fullPivLu().solve(left);
    change *= std::min(1.0, longest / change.cwiseAbs().maxCoeff());
    bool nearer = false;
    for (double share = 1; share > 1e-4 && !nearer; share /= 2) {
      turn(share * change);
      if (!across(balls, tangents, other)) return false;
      nearer = other.norm() < left.norm();
    }
    if (!nearer) return false;
  }
  return false;
}

// Friction that drives what it should hold back, by more than the rounding of
// the directions.
bool CoupledDynamics::Impl::driven(int body) const {
  const Hinge& hinge = hinges[body];
  constexpr double rounding = 1e-8;
  const double along =
      vec3(dynamics.relative_acceleration(body)).dot(hinge.direction);
  return along < (hinge.is_axis ? 0 : -rounding * hinge.pace);
}

// Newton's method from where the resting joints give way, else from where
// they would go without friction, else from where contacts frozen as they are
// would let them go (MomentSet::prox).
bool CoupledDynamics::Impl::find_directions(const std::vector<int>& begun) {
  std::vector<int> balls;
  for (const int body : begun) {
    if (!hinges[body].is_axis) balls.push_back(body);
  }
  if (balls.empty()) return true;
  const auto settled = [&] {
    return settle_directions(balls) &&
           std::ranges::all_of(balls, [&](int body) { return !driven(body); });
  };
  std::vector<Vector3d> free, frozen;
  for (const int body : balls) {
    const Felt feels = felt(body);
    Hinge& hinge = hinges[body];
    free.push_back(feels.free.normalized());
    const Vector3d rate = hinge.solver.prox(feels.inertia, feels.free);
    frozen.push_back(rate.isZero(0) ? hinge.direction : rate.normalized());
    const Vector3d alpha = vec3(dynamics.relative_acceleration(body));
    hinge.pace = std::max(feels.free.norm(), (feels.free - alpha).norm());
  }
  if (settled()) return true;
  for (const std::vector<Vector3d>& start : {frozen, free}) {
    for (std::size_t k = 0; k < balls.size(); ++k) {
      hinges[balls[k]].direction = start[k];
    }
    if (settled()) return true;
  }
  if (follow_excess(balls)) return true;
  if (report.status == CoupledStatus::ok) {
    report.status = CoupledStatus::not_converged;
  }
  report.body = balls.front();
  return false;
}

// From where the moments on the bodies are just what the resting joints can
// hold, so that the directions are known, to what they are, bit by bit.
bool CoupledDynamics::Impl::follow_excess(const std::vector<int>& balls) {
  std::vector<Vec3<double>> full;
  for (const int body : balls) {
    full.push_back(forces_->bodies[body].moment);
    hinges[body].direction = hinges[body].first_direction;
  }
  const auto set_share = [&](double share) {
    for (std::size_t k = 0; k < balls.size(); ++k) {
      const Vector3d less = (1 - share) * hinges[balls[k]].excess;
      forces_->bodies[balls[k]].moment = full[k] - vec3(less);
    }
  };
  double done = 0;
  double step = 1.0 / 16;
  constexpr double least = 1e-4;
  while (done < 1 && step > least) {
    std::vector<Vector3d> before;
    for (const int body : balls) before.push_back(hinges[body].direction);
    const double next = std::min(1.0, done + step);
    set_share(next);
    if (settle_directions(balls)) {
      done = next;
      step *= 2;
      continue;
    }
    for (std::size_t k = 0; k < balls.size(); ++k) {
      hinges[balls[k]].direction = before[k];
    }
    step /= 4;
  }
  set_share(1);
  return done == 1 && settle_directions(balls);
}

bool CoupledDynamics::Impl::any_follows() const {
  return std::ranges::any_of(hinges, &Hinge::follows);
}

// From where the last evaluation has left the directions.
const CoupledReport& CoupledDynamics::Impl::evaluate_following(
    const double* state, ActiveForces<double>& forces) {
  state_ = state;
  forces_ = &forces;
  std::vector<int> balls;
  for (int i = 0; i < static_cast<int>(hinges.size()); ++i) {
    if (hinges[i].follows) balls.push_back(i);
  }
  std::vector<Vector3d> before;
  for (const int body : balls) before.push_back(hinges[body].direction);
  if (settle_directions(balls)) return report;
  for (std::size_t k = 0; k < balls.size(); ++k) {
    hinges[balls[k]].direction = before[k];
  }
  if (report.status == CoupledStatus::ok) {
    report.status = CoupledStatus::not_converged;
    report.body = balls.front();
  }
  return report;
}

const CoupledReport& CoupledDynamics::Impl::resolve_rest(
    const double* state, ActiveForces<double>& forces, int forced) {
  state_ = state;
  forces_ = &forces;
  const int count = static_cast<int>(hinges.size());
  std::vector<int> begun;  // to slide, in this call
  const auto begin = [&](int body) {
    Hinge& hinge = hinges[body];
    const double tau = utilisation(body);
    hinge.excess = tau > 1
                       ? Vector3d((1 - 1 / tau) * vec3(reaction(body).moment))
                       : Vector3d(Vector3d::Zero());
    hinge.direction = hinge.solver.slip_direction();
    if (hinge.direction.isZero(0)) hinge.direction = Vector3d::UnitZ();
    hinge.first_direction = hinge.direction;
    set_mode(body, HingeMode::sliding);
    begun.push_back(body);
  };
  evaluate(state, forces);
  if (report.status != CoupledStatus::ok) return report;
  // Half of the threshold: what the motion found on its way is above all of
  // it, but for the rounding of tau and the error of dense output. Where that
  // is larger the hinge goes on resting, and is looked at again from here.
  if (forced >= 0 && hinges[forced].mode == HingeMode::resting &&
      utilisation(forced) > 0.5 + slip_limit(forced) / 2) {
    begin(forced);
  }

  // One change at a time, the worst first. For hinges whose friction is not
  // so strong that several answers are possible, each change brings the rest
  // nearer to what it should be; coming back to the same hinge again and
  // again says otherwise.
  const int change_limit = 4 * count + 8;
  for (int change = 0; change < change_limit; ++change) {
    evaluate(state, forces);
    if (report.status != CoupledStatus::ok || !find_directions(begun)) {
      return report;
    }

    // Friction must not drive what it should hold back.
    const auto held = std::ranges::find_if(
        begun, [&](int body) { return body != forced && driven(body); });
    if (held != begun.end()) {
      set_mode(*held, HingeMode::resting);
      begun.erase(held);
      continue;
    }
    int worst = -1;
    double most = 1;
    for (int i = 0; i < count; ++i) {
      if (hinges[i].mode != HingeMode::resting) continue;
      const double tau = utilisation(i);
      if (std::isnan(tau)) {
        fail_at(i);
        return report;
      }
      if (tau > std::max(most, slip_limit(i))) {
        worst = i;
        most = tau;
      }
    }
    if (worst < 0) return report;
    begin(worst);
  }
  report.status = CoupledStatus::no_solution;
  report.body = begun.empty() ? -1 : begun.back();
  return report;
}

}  // namespace multibody
