#pragma once

#include <Eigen/Dense>
#include <vector>

#include "multibody_support/instant.hpp"

/// The two-step resolution as in the paper, (1.3)-(1.8), matrix by matrix in
/// body axes, for any scalar: an independent check of the optimised version,
/// and the reference for its operation count. Constants of a motion are
/// precomputed here too; symmetric products are computed in full.
namespace multibody::test {

template <class T>
class PlainTwoStep {
 public:
  using V = Eigen::Matrix<T, 3, 1>;
  using M = Eigen::Matrix<T, 3, 3>;
  using D = Eigen::Matrix<T, 3, 2>;

  explicit PlainTwoStep(const Instant& instant)
      : mass_(instant.carrier.mass), inertia_(cast(instant.carrier.inertia)) {
    for (const BodyInstant& body : instant.bodies) bodies_.emplace_back(body);
  }

  /// Loads and motion; rotations are given.
  struct Input {
    V w0, force, moment;
    struct Body {
      M c;         ///< link axes to carrier axes
      V relative;  ///< angular velocity, link axes
      V force, moment;
      V friction;  ///< link axes
    };
    std::vector<Body> bodies;
  };

  void evaluate(const Input& in) {
    M a = mass_ * M(M::Identity());
    M b = M::Zero();
    M f = inertia_;
    V ra = in.force;
    V rb = in.moment - in.w0.cross(inertia_ * in.w0);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      Body& body = bodies_[i];
      const typename Input::Body& now = in.bodies[i];
      const V w00 = in.w0.cross(in.w0.cross(body.r0));
      body.c = now.c;
      const V w0 = now.c.transpose() * in.w0;
      const V w = w0 + now.relative;
      body.gyroscopic = w.cross(w0);
      // About the joint, (1.3)
      body.about = now.moment - body.r.cross(now.force) - w.cross(body.j * w) +
                   now.friction;
      const V e = body.inverse_j * body.about;
      V dr = -(now.force - body.mass * body.r.cross(e) +
               body.mass * w.cross(w.cross(body.r)));
      const M tilde0 = tilde(body.r0);
      if (body.kind == HingeKind::ball) {
        const M n = now.c * body.n * now.c.transpose();
        const M s = n * tilde0;
        const V d = now.c * dr + n * w00;
        a += n;
        b -= s;
        f -= tilde0 * s;
        ra -= d;
        rb -= now.c * now.friction + body.r0.cross(d);
        body.free = w00;
        continue;
      }
      // (1.6)-(1.8)
      const D d0 = now.c * body.d;
      body.k = -(body.d.transpose() * (e + body.gyroscopic));
      const Eigen::Matrix<T, 2, 1> dm = body.j_reduced * body.k;
      body.m_w = body.j_reduced * d0.transpose();
      const M rv = now.c * body.r_v * now.c.transpose();
      const M rw = -(now.c * body.s * body.m_w) - rv * tilde0;
      body.m_v = body.minus_j_s * now.c.transpose();
      body.m_w -= body.m_v * tilde0;
      dr -= body.s * dm;
      const V d = now.c * dr + rv * w00;
      body.dm = dm + body.m_v * w00;
      a += rv;
      b += rw;
      f += tilde0 * rw + d0 * body.m_w;
      ra -= d;
      rb -= now.c * now.friction + body.r0.cross(d) + d0 * body.dm;
      body.free = w00;
    }
    const M inverse_f = inverse(f);
    const M bf = b * inverse_f;
    linear = inverse(M(a - bf * b.transpose())) * (ra - bf * rb);
    angular = inverse_f * (rb - b.transpose() * linear);
    for (Body& body : bodies_) {
      const V v =
          body.c.transpose() * (linear - body.r0.cross(angular) + body.free);
      V m = body.about + body.mass * body.r.cross(v);
      if (body.kind == HingeKind::axis) {
        m += body.d * Eigen::Matrix<T, 2, 1>(body.m_v * linear +
                                             body.m_w * angular + body.dm);
      }
      body.relative =
          body.inverse_j * m - body.c.transpose() * angular + body.gyroscopic;
    }
  }

  V linear, angular;
  const V& relative(int body) const { return bodies_[body].relative; }

 private:
  template <class E>
  static auto cast(const E& e) {
    return e.template cast<T>().eval();
  }
  static M tilde(const V& a) {
    M m;
    m << T(0.0), -a.z(), a.y(), a.z(), T(0.0), -a.x(), -a.y(), a.x(), T(0.0);
    return m;
  }
  // By cofactors.
  static M inverse(const M& m) {
    const V x = m.col(0), y = m.col(1), z = m.col(2);
    M adjoint;
    adjoint.row(0) = y.cross(z);
    adjoint.row(1) = z.cross(x);
    adjoint.row(2) = x.cross(y);
    const T per_determinant = T(1.0) / x.dot(y.cross(z));
    return per_determinant * adjoint;
  }

  struct Body {
    explicit Body(const BodyInstant& given)
        : kind(given.body.kind), mass(given.body.mass) {
      using Eigen::Matrix3d;
      const Eigen::Vector3d rd = given.body.hinge_from_com;
      const double md = given.body.mass;
      Matrix3d t;
      t << 0, -rd.z(), rd.y(), rd.z(), 0, -rd.x(), -rd.y(), rd.x(), 0;
      const Matrix3d jd = given.body.inertia - md * t * t;
      const Matrix3d ij = jd.inverse();
      const Matrix3d nd = md * (Matrix3d::Identity() + md * t * ij * t);
      const Eigen::Matrix<double, 3, 2> dd =
          given.body.hinge_to_body.leftCols<2>();
      const Eigen::Matrix2d reduced = (dd.transpose() * ij * dd).inverse();
      const Eigen::Matrix<double, 3, 2> sd = -md * t * ij * dd;
      r = cast(rd);
      r0 = cast(given.body.hinge_from_carrier_com);
      j = cast(jd);
      inverse_j = cast(ij);
      n = cast(nd);
      d = cast(dd);
      s = cast(sd);
      j_reduced = cast(reduced);
      const Eigen::Matrix<double, 2, 3> mv = -reduced * sd.transpose();
      minus_j_s = cast(mv);
      const Matrix3d rv = nd - sd * mv;
      r_v = cast(rv);
    }
    HingeKind kind;
    T mass;
    V r, r0;
    M j, inverse_j, n, r_v;
    D d, s;
    Eigen::Matrix<T, 2, 2> j_reduced;
    Eigen::Matrix<T, 2, 3> minus_j_s;
    // Quantities of the instant.
    M c;
    V about, gyroscopic, free, relative;
    Eigen::Matrix<T, 2, 1> k, dm;
    Eigen::Matrix<T, 2, 3> m_v, m_w;
  };

  T mass_;
  M inertia_;
  std::vector<Body> bodies_;
};

}  // namespace multibody::test
