#pragma once

#include <Eigen/Dense>
#include <vector>

#include "multibody_support/instant.hpp"

/// The two-step resolution as the paper writes it, (1.3)-(1.8), matrix by
/// matrix in given axes, in any scalar: an independent check of the one that
/// exploits the structure, and the count of operations it is compared with.
/// What does not change during a motion is precomputed there too; where a
/// product is symmetric, all of it is computed.
namespace multibody::test {

template <class T>
class PlainTwoStep {
 public:
  using V = Eigen::Matrix<T, 3, 1>;
  using M = Eigen::Matrix<T, 3, 3>;
  using D = Eigen::Matrix<T, 3, 2>;

  explicit PlainTwoStep(const Instant& instant)
      : mass_(instant.carrier.mass), inertia_(cast(instant.carrier.inertia)) {
    for (const LoadInstant& load : instant.loads) loads_.emplace_back(load);
  }

  /// What acts, and the motion; rotations are given.
  struct Input {
    V w0, force, moment;
    struct Load {
      M c;         ///< load axes to carrier axes
      V relative;  ///< angular velocity, load axes
      V force, moment;
      V friction;  ///< load axes
    };
    std::vector<Load> loads;
  };

  void evaluate(const Input& in) {
    M a = mass_ * M(M::Identity());
    M b = M::Zero();
    M f = inertia_;
    V ra = in.force;
    V rb = in.moment - in.w0.cross(inertia_ * in.w0);
    for (std::size_t i = 0; i < loads_.size(); ++i) {
      Load& load = loads_[i];
      const typename Input::Load& now = in.loads[i];
      const V w00 = in.w0.cross(in.w0.cross(load.r0));
      load.c = now.c;
      const V w0 = now.c.transpose() * in.w0;
      const V w = w0 + now.relative;
      load.gyroscopic = w.cross(w0);
      // About the joint, (1.3)
      load.about = now.moment - load.r.cross(now.force) - w.cross(load.j * w) +
                   now.friction;
      const V e = load.inverse_j * load.about;
      V dr = -(now.force - load.mass * load.r.cross(e) +
               load.mass * w.cross(w.cross(load.r)));
      const M tilde0 = tilde(load.r0);
      if (load.kind == JointKind::spherical) {
        const M n = now.c * load.n * now.c.transpose();
        const M s = n * tilde0;
        const V d = now.c * dr + n * w00;
        a += n;
        b -= s;
        f -= tilde0 * s;
        ra -= d;
        rb -= now.c * now.friction + load.r0.cross(d);
        load.free = w00;
        continue;
      }
      // (1.6)-(1.8)
      const D d0 = now.c * load.d;
      load.k = -(load.d.transpose() * (e + load.gyroscopic));
      const Eigen::Matrix<T, 2, 1> dm = load.j_reduced * load.k;
      load.m_w = load.j_reduced * d0.transpose();
      const M rv = now.c * load.r_v * now.c.transpose();
      const M rw = -(now.c * load.s * load.m_w) - rv * tilde0;
      load.m_v = load.minus_j_s * now.c.transpose();
      load.m_w -= load.m_v * tilde0;
      dr -= load.s * dm;
      const V d = now.c * dr + rv * w00;
      load.dm = dm + load.m_v * w00;
      a += rv;
      b += rw;
      f += tilde0 * rw + d0 * load.m_w;
      ra -= d;
      rb -= now.c * now.friction + load.r0.cross(d) + d0 * load.dm;
      load.free = w00;
    }
    const M inverse_f = inverse(f);
    const M bf = b * inverse_f;
    linear = inverse(M(a - bf * b.transpose())) * (ra - bf * rb);
    angular = inverse_f * (rb - b.transpose() * linear);
    for (Load& load : loads_) {
      const V v =
          load.c.transpose() * (linear - load.r0.cross(angular) + load.free);
      V m = load.about + load.mass * load.r.cross(v);
      if (load.kind == JointKind::axis) {
        m += load.d * Eigen::Matrix<T, 2, 1>(load.m_v * linear +
                                             load.m_w * angular + load.dm);
      }
      load.relative =
          load.inverse_j * m - load.c.transpose() * angular + load.gyroscopic;
    }
  }

  V linear, angular;
  const V& relative(int load) const { return loads_[load].relative; }

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

  struct Load {
    explicit Load(const LoadInstant& given)
        : kind(given.load.kind), mass(given.load.mass) {
      using Eigen::Matrix3d;
      const Eigen::Vector3d rd = given.load.hinge_from_com;
      const double md = given.load.mass;
      Matrix3d t;
      t << 0, -rd.z(), rd.y(), rd.z(), 0, -rd.x(), -rd.y(), rd.x(), 0;
      const Matrix3d jd = given.load.inertia - md * t * t;
      const Matrix3d ij = jd.inverse();
      const Matrix3d nd = md * (Matrix3d::Identity() + md * t * ij * t);
      const Eigen::Matrix<double, 3, 2> dd =
          given.load.hinge_to_load.leftCols<2>();
      const Eigen::Matrix2d reduced = (dd.transpose() * ij * dd).inverse();
      const Eigen::Matrix<double, 3, 2> sd = -md * t * ij * dd;
      r = cast(rd);
      r0 = cast(given.load.hinge_from_carrier_com);
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
    JointKind kind;
    T mass;
    V r, r0;
    M j, inverse_j, n, r_v;
    D d, s;
    Eigen::Matrix<T, 2, 2> j_reduced;
    Eigen::Matrix<T, 2, 3> minus_j_s;
    // Of the instant.
    M c;
    V about, gyroscopic, free, relative;
    Eigen::Matrix<T, 2, 1> k, dm;
    Eigen::Matrix<T, 2, 3> m_v, m_w;
  };

  T mass_;
  M inertia_;
  std::vector<Load> loads_;
};

}  // namespace multibody::test
