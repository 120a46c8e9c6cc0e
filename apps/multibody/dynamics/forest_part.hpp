#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace multibody::detail {

/// A body of a forest between the two steps, its own axes; origin: its hinge's
/// centre, of a root its centre of mass. What hangs on it included,
///   R = a v' + b w' + force,   M = c v' + d w' + moment
/// act on it there. The row e = T^T (-S, 1) of its hinge's law M = m + S R
/// takes the turn out of this; T^T m is `given`.
struct ForestPart {
  using Matrix = Eigen::Matrix3d;
  using Vector = Eigen::Vector3d;
  enum class Turn { none, axis, ball };

  Vector r;            ///< of the origin from the centre of mass
  Vector w;            ///< absolute angular velocity
  Matrix rotation;     ///< to the parent's axes
  Vector from_parent;  ///< hinge from the parent's origin, parent's axes
  /// Accelerations for those of the parent 0 and no turn.
  Vector linear_bias, angular_bias;
  Matrix a, b, c, d;
  Vector own_force, own_moment;  ///< without those of the children
  Vector force, moment;
  Turn turn;
  Matrix slope;              ///< S; 0 where it is not asked for
  Vector axis, e;            ///< axis: T; -S^T T
  Vector x_force, x_moment;  ///< axis: what a turn of 1 needs
  double inverse;            ///< axis: 1 over what it needs about itself
  Matrix inverse_ball;
  Vector linear, angular;  ///< v', w'

  /// Its own equations, before anything hangs on it.
  void set_own(double mass, const Matrix& inertia, const Vector& active_force,
               const Vector& active_moment) {
    a = mass * Matrix::Identity();
    b = mass * cross_matrix(r);
    c = -b;
    d = inertia +
        mass * (r.squaredNorm() * Matrix::Identity() - r * r.transpose());
    own_force = -mass * w.cross(w.cross(r)) - active_force;
    own_moment = w.cross(inertia * w) - active_moment - r.cross(own_force);
  }

  /// First step: what the parent sees of it, with all that hangs on it.
  /// @tparam sloped  some slope is not 0: nothing is symmetric
  template <bool sloped>
  void eliminate(ForestPart& parent) {
    if (!sloped) c = b.transpose();
    own_force += a * linear_bias + b * angular_bias;
    own_moment += c * linear_bias + d * angular_bias;
    switch (turn) {
      case Turn::none:
        return pass<sloped>(a, b, c, d, parent);
      case Turn::axis:
        return eliminate_axis<sloped>(parent);
      case Turn::ball:
        return eliminate_ball<sloped>(parent);
    }
  }

  /// The same of the loads.
  void eliminate_load(const Vector& given, ForestPart& parent) const {
    Vector up = force;
    Vector turned = moment;
    if (turn == Turn::axis) {
      const double q = inverse * missing_axis(given, force, moment);
      up += q * x_force;
      turned += q * x_moment;
    } else if (turn == Turn::ball) {
      up += b * (inverse_ball * missing_ball(given, force, moment));
      turned = given + slope * up;
    }
    const Vector at_parent = rotation * up;
    parent.force += at_parent;
    parent.moment += rotation * turned + from_parent.cross(at_parent);
  }

  struct Reaction {
    Vector force, moment, turn;
  };
  /// Second step: accelerations from those of the parent.
  Reaction resolve(const Vector& given, const ForestPart& parent) {
    const auto to_own = rotation.transpose();
    linear = to_own * (parent.linear + parent.angular.cross(from_parent));
    angular = to_own * parent.angular;
    Reaction to{a * linear + b * angular + force,
                c * linear + d * angular + moment, Vector::Zero()};
    if (turn == Turn::axis) {
      const double q = inverse * missing_axis(given, to.force, to.moment);
      to.turn = q * axis;
      to.force += q * x_force;
      to.moment += q * x_moment;
    } else if (turn == Turn::ball) {
      to.turn = inverse_ball * missing_ball(given, to.force, to.moment);
      to.force += b * to.turn;
      to.moment = given + slope * to.force;
    }
    linear += linear_bias;
    angular += angular_bias + to.turn;
    return to;
  }

  static Matrix cross_matrix(const Vector& v) {
    Matrix m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
  }

 private:
  // Moment by the hinge's law less that of these.
  double missing_axis(const Vector& given, const Vector& f,
                      const Vector& m) const {
    return axis.dot(given - m) - e.dot(f);
  }
  Vector missing_ball(const Vector& given, const Vector& f,
                      const Vector& m) const {
    return given - m + slope * f;
  }

  template <bool sloped>
  void eliminate_axis(ForestPart& parent) {
    x_force = b * axis;
    x_moment = d * axis;
    Eigen::RowVector3d row_force = axis.transpose() * c;
    Eigen::RowVector3d row_moment = axis.transpose() * d;
    e.setZero();
    if (sloped) {
      e = -slope.transpose() * axis;
      row_force += e.transpose() * a;
      row_moment += e.transpose() * b;
    }
    inverse = 1 / (row_moment.dot(axis));
    row_force *= inverse;
    row_moment *= inverse;
    pass<sloped>(a - x_force * row_force, b - x_force * row_moment,
                 c - x_moment * row_force, d - x_moment * row_moment, parent);
  }

  // The columns of a turn vanish, and (c, d) is S (a, b) after it.
  template <bool sloped>
  void eliminate_ball(ForestPart& parent) {
    Matrix law_c = c;
    Matrix law_d = d;
    if (sloped) {
      law_c -= slope * a;
      law_d -= slope * b;
    }
    inverse_ball = law_d.inverse();
    const Matrix left = a - b * inverse_ball * law_c;
    const Matrix n = rotation * left * rotation.transpose();
    const Matrix arm = cross_matrix(from_parent);
    const Matrix n_arm = n * arm;
    parent.a += n;
    parent.b -= n_arm;
    parent.d -= arm * n_arm;
    if (!sloped) return;
    const Matrix turned = rotation * (slope * left) * rotation.transpose();
    parent.c += turned + arm * n;
    parent.d -= turned * arm;
  }

  template <bool sloped>
  void pass(const Matrix& own_a, const Matrix& own_b, const Matrix& own_c,
            const Matrix& own_d, ForestPart& parent) const {
    const auto turned = [this](const Matrix& m) -> Matrix {
      return rotation * m * rotation.transpose();
    };
    const Matrix arm = cross_matrix(from_parent);
    const Matrix pa = turned(own_a);
    const Matrix pb = turned(own_b);
    const Matrix pc = sloped ? turned(own_c) : Matrix(pb.transpose());
    const Matrix moved = pb - pa * arm;
    parent.a += pa;
    parent.b += moved;
    if (sloped) parent.c += pc + arm * pa;
    parent.d += turned(own_d) - pc * arm + arm * moved;
  }
};

}  // namespace multibody::detail
