#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "multibody/coupled_impl.hpp"
#include "multibody/eigen_conversion.hpp"

// Which resting hinges hold and which begin to slide.
namespace multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

}  // namespace

CoupledDynamics::Impl::Felt CoupledDynamics::Impl::felt(int load) {
  const Matrix3d mobility = response(load).acceleration;
  const Vector3d alpha = vec3(dynamics.relative_acceleration(load));
  const Matrix3d inertia = mobility.inverse();
  return {0.5 * (inertia + inertia.transpose()),
          alpha - mobility * hinges[load].moment};
}

// A ball joint that begins to slide does so in the direction of its own
// acceleration, on which its friction depends. With the contact frozen that
// is a convex problem (MomentSet::prox) with the inertia that the hinge feels;
// the contact follows until the direction stays.
bool CoupledDynamics::Impl::settle_direction(int load) {
  Hinge& hinge = hinges[load];
  constexpr int round_limit = 100;
  constexpr double tolerance = 1e-10;
  for (int round = 0; round < round_limit; ++round) {
    evaluate(state_, *loading_);
    if (report.status != CoupledStatus::ok) return false;
    const Felt feels = felt(load);
    const Vector3d found = hinge.solver.prox(feels.inertia, feels.free);
    // Right at the edge nothing moves yet: the direction is that of the edge.
    if (found.isZero(0)) return true;
    const Vector3d next = found.normalized();
    const double turn = (next - hinge.direction).norm();
    hinge.direction = next;
    if (turn <= tolerance) return true;
  }
  return false;
}

const CoupledReport& CoupledDynamics::Impl::resolve_rest(
    const double* state, Loading<double>& loading, int forced) {
  state_ = state;
  loading_ = &loading;
  const int count = static_cast<int>(hinges.size());
  std::vector<int> begun;  // to slide, in this call
  const auto begin = [&](int load) {
    utilisation(load);
    hinges[load].direction = hinges[load].solver.slip_direction();
    if (hinges[load].direction.isZero(0)) {
      hinges[load].direction = Vector3d::UnitZ();
    }
    set_mode(load, HingeMode::sliding);
    begun.push_back(load);
  };
  evaluate(state, loading);
  if (report.status != CoupledStatus::ok) return report;
  if (forced >= 0 && hinges[forced].mode == HingeMode::resting) begin(forced);

  // One change at a time, the worst first. For hinges whose friction is not
  // so strong that several answers are possible, each change brings the rest
  // nearer to what it should be; coming back to the same hinge again and
  // again says otherwise.
  const int change_limit = 4 * count + 8;
  for (int change = 0; change < change_limit; ++change) {
    evaluate(state, loading);
    for (const int load : begun) {
      if (hinges[load].solver.is_axis()) continue;
      if (report.status == CoupledStatus::ok && !settle_direction(load)) {
        if (report.status == CoupledStatus::ok) {
          report.status = CoupledStatus::not_converged;
        }
        report.load = load;
      }
    }
    if (report.status != CoupledStatus::ok) return report;

    // Friction must not drive what it should hold back.
    const auto driven = std::ranges::find_if(begun, [&](int load) {
      return load != forced && vec3(dynamics.relative_acceleration(load))
                                       .dot(hinges[load].direction) < 0;
    });
    if (driven != begun.end()) {
      set_mode(*driven, HingeMode::resting);
      begun.erase(driven);
      continue;
    }
    int worst = -1;
    double most = 1 + options.slip_threshold;
    for (int i = 0; i < count; ++i) {
      if (hinges[i].mode != HingeMode::resting) continue;
      const double tau = utilisation(i);
      if (!(tau <= most)) {
        worst = i;
        most = tau;
      }
    }
    if (worst < 0) return report;
    begin(worst);
  }
  report.status = CoupledStatus::no_solution;
  report.load = begun.empty() ? -1 : begun.back();
  return report;
}

}  // namespace multibody
