// A pin of finite length under known loads.
#include <Eigen/LU>
#include <algorithm>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/linear/solve.hpp"
#include "libcontact/finite_pin/sums.hpp"

namespace contact {

using detail::turned;
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector4d;

namespace {

using detail::nan;

}  // namespace

// Place along the force at which the pin first lies a third of the clearance
// deep, or less deep where the force law ends before: there the stiffness is
// regular.
Vector4d FinitePin::start(const Vector2d& force,
                          const Vector2d& tilt) const noexcept {
  Vector4d place = (Vector4d() << Vector2d::Zero(), tilt).finished();
  Vector2d step = clearance_ / 4 * force.stableNormalized();
  if (step.isZero(0)) return place;
  const auto deepest = [&] {
    double deep = 0;
    for (const Relief::Piece& piece : pieces_) {
      for (const double z :
           {piece.from, (piece.from + piece.to) / 2, piece.to}) {
        deep = std::max(deep, (place.head<2>() + z * tilt).norm() - clearance_ -
                                  piece.at(z));
      }
    }
    return deep;
  };
  constexpr int most = 8;
  for (int i = 0; i < most && deepest() <= clearance_ / 3; ++i) {
    place.head<2>() += step;
  }
  constexpr int halvings = 40;
  const double end = 0.9 * law_.largest_penetration();
  for (int i = 0; i < halvings; ++i) {
    const double deep = deepest();
    if (deep > 0 && deep <= end) break;
    step /= 2;
    place.head<2>() += deep > 0 ? Vector2d(-step) : step;
  }
  return place;
}

// Newton's steps to the least of U - F.a - G.psi, which is convex.
FinitePinState FinitePin::solved(const Vector4d& load, bool tilts,
                                 const Vector2d& tilt) const noexcept {
  // Lengths, and forces, of one size.
  const double turn = tilts ? 1 / half_length_ : 0;
  const Vector4d unit(1, 1, turn, turn);
  const double size = load.cwiseProduct(unit).norm();
  Vector4d place = start(load.head<2>(), tilt);
  Sums now = sums(place);
  const auto rest = [&](const Sums& of) -> Vector4d {
    return (of.load - load).cwiseProduct(unit);
  };
  const auto merit = [&](const Sums& of, const Vector4d& at) {
    return of.energy - load.dot(at);
  };
  constexpr int most = 60;
  constexpr double tolerance = 1e-12;
  FinitePinState found;
  Status status = Status::not_converged;
  bool beyond = false;  // the force law's end lies before the load
  for (found.iterations = 0; found.iterations < most; ++found.iterations) {
    const Vector4d missing = rest(now);
    if (missing.norm() <= tolerance * size) {
      status = Status::ok;
      break;
    }
    Eigen::Matrix4d k = unit.asDiagonal() * now.stiffness * unit.asDiagonal();
    // A tilt that is known has no equations.
    if (!tilts) k.bottomRightCorner<2, 2>() = Matrix2d::Identity();
    const Vector4d step =
        -unit.cwiseProduct(detail::solve_symmetric(k, missing));
    bool taken = false;
    for (double share = 1; share > 1e-9 && !taken; share /= 2) {
      const Vector4d there = place + share * step;
      const Sums next = sums(there);
      if (share == 1) beyond = !next.load.allFinite();
      // Rounding hides the energy's last steps.
      taken =
          next.load.allFinite() && (merit(next, there) < merit(now, place) ||
                                    rest(next).norm() < missing.norm() / 2);
      if (!taken) continue;
      place = there;
      now = next;
    }
    if (!taken) break;
  }
  const int iterations = found.iterations;
  const double residual = size == 0 ? 0 : rest(now).norm() / size;
  if (status != Status::ok && beyond) {
    place.setConstant(nan);
    now = sums(place);
  }
  found = state(place, now);
  found.iterations = iterations;
  found.residual = residual;
  if (found.status == Status::ok && !(residual <= 1e-9)) found.status = status;
  return found;
}

FinitePinState FinitePin::under(const Vector2d& force,
                                const Vector2d& tilt) const noexcept {
  Vector4d load;
  load << force, Vector2d::Zero();
  return solved(load, false, tilt);
}

FinitePinState FinitePin::under_moment(const Vector2d& force,
                                       const Vector2d& moment) const noexcept {
  Vector4d load;
  load << force, moment;
  return solved(load, true, Vector2d::Zero());
}

// Strengths of friction about the axis and along it, 0 without motion.
struct FinitePin::Slip {
  double around, along;          // cos and sin of the direction of slip
  double coefficient, adhesion;  // f0, A
  double radius;

  double slip() const { return around * coefficient; }
  double stick() const { return around * adhesion; }
  // The share of G by friction along the axis.
  Vector2d axial(const Vector2d& force, const Vector2d& tangent) const {
    return along * radius * (coefficient * force - adhesion * turned(tangent));
  }
};

FinitePin::Slip FinitePin::slip(const Motion& motion) const noexcept {
  const double rho = joint_.geometry.radius();
  const double speed = slip_speed(motion);
  if (!(speed > 0) || !joint_.friction) return {0, 0, 0, 0, rho};
  const FrictionLaw& friction = std::get<FrictionLaw>(*joint_.friction);
  return {rho * motion.rate / speed, motion.axial_velocity / speed,
          friction.coefficient(), friction.adhesion(), rho};
}

// Slip is along cos t + sin Z everywhere, with cos and sin by the motion:
//   R = (s - cos f0 J) F - cos A T_A,  J the turn by 90 deg,
// and the same for the z-moments, plus the part of friction along the axis, sin
// rho (f0 F - A J T_A). Without adhesion F and G are known at once.
FinitePinSolution FinitePin::sliding(const Vector4d& load, bool tilts,
                                     const Vector2d& tilt,
                                     const Motion& motion) const noexcept {
  const double s = joint_.geometry.side();
  const Slip by = slip(motion);
  Matrix2d of_force;
  of_force << s, by.slip(), -by.slip(), s;
  const Matrix2d to_force = of_force.inverse();
  FinitePinState at;
  Vector4d area = Vector4d::Zero();
  constexpr int most = 100;
  for (int i = 0; i < most; ++i) {
    Vector4d normal = load + by.stick() * area;
    normal.head<2>() = to_force * normal.head<2>();
    normal.tail<2>() =
        tilts
            ? Vector2d(to_force * (normal.tail<2>() -
                                   by.axial(normal.head<2>(), area.head<2>())))
            : Vector2d::Zero();
    at = solved(normal, tilts, tilt);
    Vector4d next;
    next << at.area_tangent, at.area_tangent_moment;
    Vector4d change = by.adhesion * (next - area);
    area = next;
    if (tilts) {
      change.tail<2>() /= half_length_;
    } else {
      change.tail<2>().setZero();
    }
    // Without a load a tilted pin may be pressed at both ends.
    const double size =
        load.isZero(0) ? at.pressure_moment / by.radius : load.head<2>().norm();
    if (!(change.norm() > 1e-12 * size)) break;
    if (i + 1 == most) at.status = Status::not_converged;
  }
  return friction(at, motion);
}

FinitePinSolution FinitePin::friction(const FinitePinState& at,
                                      const Motion& motion) const noexcept {
  const double s = joint_.geometry.side();
  const Slip by = slip(motion);
  FinitePinSolution found;
  found.contact = at;
  found.friction_force =
      -by.slip() * turned(at.force) - by.stick() * at.area_tangent;
  const double twist =
      by.coefficient * at.pressure_moment + by.adhesion * at.area_moment;
  found.axial_friction_force = -by.along * twist / by.radius;
  const Vector2d g = s * at.force_moment - by.slip() * turned(at.force_moment) -
                     by.stick() * at.area_tangent_moment +
                     by.axial(at.force, at.area_tangent);
  found.moment = {-g.y(), g.x(), -by.around * twist};
  return found;
}

FinitePinSolution FinitePin::solve(const Vector2d& reaction,
                                   const Vector2d& tilt,
                                   const Motion& motion) const noexcept {
  Vector4d load;
  load << reaction, Vector2d::Zero();
  return sliding(load, false, tilt, motion);
}

FinitePinSolution FinitePin::solve_at(const Vector2d& reaction, double place,
                                      const Motion& motion) const noexcept {
  Vector4d load;
  load << reaction, place * reaction;
  return sliding(load, true, Vector2d::Zero(), motion);
}

}  // namespace contact
