#include "multibody_support/dense_solver.hpp"

#include "multibody/system/state_layout.hpp"
#include "multibody_support/dense_reference.hpp"

namespace multibody::test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d eigen(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

}  // namespace

DenseSolver::DenseSolver(const System& system)
    : inverse_mass_(1 / system.carrier().mass),
      inertia_(system.carrier().inertia),
      inverse_inertia_(inertia_.inverse()) {
  int row = 0;
  const std::vector<JointMode> modes(system.size(), JointMode::turning);
  const StateLayout layout(system, modes);
  for (int i = 0; i < system.size(); ++i) {
    const Link& link = system.links()[i];
    bodies_.emplace_back();
    BodyPart& body = bodies_.back();
    body.axis = link.kind == HingeKind::axis;
    body.offset = layout.offset(i);
    body.row = row;
    row += body.axis ? 5 : 3;
    body.inverse_mass = 1 / link.mass;
    body.inertia = link.inertia;
    body.inverse_inertia = link.inertia.inverse();
    body.zero = link.axes_to_carrier_zero;
    body.r = body.axis ? Vector3d(link.arm, 0, 0) : Vector3d(0, 0, link.arm);
    body.r0 = link.hinge;
    body.inverse_i0_r0 = inverse_inertia_ * tilde<double>(body.r0);
    const Matrix3d r = tilde<double>(body.r);
    body.hinge_mobility =
        body.inverse_mass * Matrix3d::Identity() - r * body.inverse_inertia * r;
    body.turn_mobility = -r * body.inverse_inertia;
  }
  constant_ = Eigen::MatrixXd::Zero(row, row);
  for (const BodyPart& a : bodies_) {
    for (const BodyPart& b : bodies_) {
      constant_.block<3, 3>(a.row, b.row) =
          inverse_mass_ * Matrix3d::Identity() -
          tilde<double>(a.r0) * b.inverse_i0_r0;
    }
    if (a.axis) {
      constant_.block<2, 2>(a.row + 3, a.row + 3) =
          a.inverse_inertia.topLeftCorner<2, 2>();
    }
  }
  matrix_ = constant_;
  rhs_.resize(row);
}

void DenseSolver::set_motion(BodyPart& body, const double* state,
                             const LinkForces<double>& forces) {
  const double* const s = state + body.offset;
  Vector3d friction = eigen(forces.friction);
  if (body.axis) {
    const double cos = std::cos(s[0]);
    const double sin = std::sin(s[0]);
    body.c.col(0) = cos * body.zero.col(0) + sin * body.zero.col(1);
    body.c.col(1) = cos * body.zero.col(1) - sin * body.zero.col(0);
    body.c.col(2) = body.zero.col(2);
    body.relative_w = {0, 0, s[1]};
  } else {
    const Mat3<double> c = rotation(Quaternion<double>{s[0], s[1], s[2], s[3]});
    body.c << c.x.x, c.y.x, c.z.x, c.x.y, c.y.y, c.z.y, c.x.z, c.y.z, c.z.z;
    body.relative_w = {s[4], s[5], s[6]};
  }
  body.w0 = body.c.transpose() * w0_;
  const Vector3d w = body.w0 + body.relative_w;
  body.free_linear = body.inverse_mass * eigen(forces.force);
  body.free_angular = body.inverse_inertia * (eigen(forces.moment) + friction -
                                              w.cross(body.inertia * w));
  angular_ -= body.c * friction;
  // Errors of the conditions without reactions, still without the carrier's.
  const Vector3d hinge = body.free_linear + body.free_angular.cross(body.r) +
                         w.cross(w.cross(body.r));
  rhs_.segment<3>(body.row) = w0_.cross(w0_.cross(body.r0)) - body.c * hinge;
  if (body.axis) {
    const Vector3d turn = body.free_angular + w.cross(body.w0);
    rhs_.segment<2>(body.row + 3) = -turn.head<2>();
  }
}

void DenseSolver::fill_rows(std::size_t i) {
  const BodyPart& a = bodies_[i];
  matrix_.block<3, 3>(a.row, a.row) = constant_.block<3, 3>(a.row, a.row) +
                                      a.c * a.hinge_mobility * a.c.transpose();
  rhs_.segment<3>(a.row) += linear_ + angular_.cross(a.r0);
  if (!a.axis) {
    for (std::size_t j = 0; j < i; ++j) {
      const BodyPart& b = bodies_[j];
      matrix_.block<3, 3>(a.row, b.row) = constant_.block<3, 3>(a.row, b.row);
      if (b.axis) {
        matrix_.block<3, 2>(a.row, b.row + 3) =
            a.inverse_i0_r0.transpose() * b.c.leftCols<2>();
      }
    }
    return;
  }
  const Eigen::Matrix<double, 3, 2> d0 = a.c.leftCols<2>();
  const Eigen::Matrix<double, 3, 2> turn = inverse_inertia_ * d0;
  rhs_.segment<2>(a.row + 3) += d0.transpose() * angular_;
  for (std::size_t j = 0; j <= i; ++j) {
    const BodyPart& b = bodies_[j];
    if (j < i) {
      matrix_.block<3, 3>(a.row, b.row) = constant_.block<3, 3>(a.row, b.row);
    }
    matrix_.block<2, 3>(a.row + 3, b.row) = d0.transpose() * b.inverse_i0_r0;
    if (b.axis) {
      if (j < i) {
        matrix_.block<3, 2>(a.row, b.row + 3) =
            a.inverse_i0_r0.transpose() * b.c.leftCols<2>();
      }
      matrix_.block<2, 2>(a.row + 3, b.row + 3) =
          turn.transpose() * b.c.leftCols<2>();
    }
  }
  matrix_.block<2, 2>(a.row + 3, a.row + 3) +=
      constant_.block<2, 2>(a.row + 3, a.row + 3);
  matrix_.block<2, 3>(a.row + 3, a.row) +=
      (a.c * a.turn_mobility.leftCols<2>()).transpose();
}

void DenseSolver::evaluate(const double* state,
                           const ActiveForces<double>& forces) {
  w0_ = Eigen::Map<const Vector3d>(state + StateLayout::angular_velocity);
  linear_ = inverse_mass_ * eigen(forces.carrier.force);
  angular_ = eigen(forces.carrier.moment) - w0_.cross(inertia_ * w0_);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    set_motion(bodies_[i], state, forces.bodies[i]);
  }
  angular_ = (inverse_inertia_ * angular_).eval();
  for (std::size_t i = 0; i < bodies_.size(); ++i) fill_rows(i);
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(matrix_);
  factor.solveInPlace(rhs_);

  Vector3d force = Vector3d::Zero();
  Vector3d moment = Vector3d::Zero();
  for (const BodyPart& a : bodies_) {
    const Vector3d reaction = rhs_.segment<3>(a.row);
    force += reaction;
    moment += a.r0.cross(reaction);
    if (a.axis) moment += a.c.leftCols<2>() * rhs_.segment<2>(a.row + 3);
  }
  linear_ -= inverse_mass_ * force;
  angular_ -= inverse_inertia_ * moment;
  for (BodyPart& a : bodies_) {
    const Vector3d reaction = a.c.transpose() * rhs_.segment<3>(a.row);
    Vector3d m = a.r.cross(reaction);
    if (a.axis) m.head<2>() += rhs_.segment<2>(a.row + 3);
    a.relative = a.free_angular + a.inverse_inertia * m -
                 a.c.transpose() * angular_ + a.relative_w.cross(a.w0);
  }
}

}  // namespace multibody::test
