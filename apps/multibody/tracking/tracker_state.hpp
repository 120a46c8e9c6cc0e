#pragma once

#include "libcontact/base/lanes/vec3.hpp"
#include "libcontact/joint/slip/slip_triangle.hpp"

/// State of JointTracker: numbers of one joint (T = double), or of several in
/// lanes.
namespace multibody::detail {

using contact::Mat3;
using contact::Vec3;
using contact::detail::SlipTriangle;

/// Range of series, slopes and windows: moves of ln R, ln R_n, b, ... With
/// moves of 10 % the seventh order of the series is 1e-8.
constexpr double trust_radius = 0.1;
/// Largest 1/sin b of tracked joints: M_t over R changes at this rate.
constexpr double largest_inverse_sine = 100;
/// Lower bound of sin a and cos a of contacts: quantities divided by them tend
/// to constants. Its square still differs from 0.
constexpr double smallest_axis = 1e-150;

/// A move of the contact.
template <class T>
struct ContactMove {
  T force, cosine;  ///< moves of x = ln R_n and y = ln cos^2 a
};

/// F, one of f/cos a, c_Y/cos a, c_Z/sin a, around the last evaluated contact.
template <class T>
struct Secants {
  T value;                ///< F there; for the speed 1 if viscous
  T by_force, by_cosine;  ///< d ln F over dx and dy
  T curvature;            ///< half of d^2 ln F along the last move
};

/// Two functions of R_n alone, as Newton's polynomials near the middle.
template <class T>
struct Window {
  static constexpr int size = 12;
  /// Chebyshev's nodes, cos((2 i + 1) pi/24), in an order that keeps rounding
  /// small.
  static constexpr double nodes[size] = {
      0.991445,  -0.991445, -0.130526, 0.608761, -0.608761, 0.382683,
      -0.793353, 0.92388,   -0.382683, -0.92388, 0.793353,  0.130526};
  T middle, inverse_half_width;  ///< range of R_n
  T first[size], second[size];   ///< divided differences

  T place(const T& force) const {
    return (force - middle) * inverse_half_width;
  }
  /// @param place  -1 to 1
  [[gnu::always_inline]] static T value(const T (&differences)[size],
                                        const T& place) {
    T sum = differences[size - 1];
#pragma GCC unroll 12
    for (int i = size - 2; i >= 0; --i) {
      sum = sum * (place - nodes[i]) + differences[i];
    }
    return sum;
  }
  /// With its slope over ln R_n and half the curvature, both of ln F.
  [[gnu::always_inline]] Secants<T> tangent(const T (&differences)[size],
                                            const T& force) const {
    T sum = differences[size - 1];
    T slope = T(0.0), bend = T(0.0);  // over the place; half of the curvature
#pragma GCC unroll 12
    for (int i = size - 2; i >= 0; --i) {
      const T from = place(force) - nodes[i];
      bend = bend * from + slope;
      slope = slope * from + sum;
      sum = sum * from + differences[i];
    }
    const T scale = force * inverse_half_width;
    const T inverse = 1.0 / sum;
    const T by_force = slope * scale * inverse;
    return {sum, by_force, T(0.0),
            bend * scale * scale * inverse + 0.5 * by_force * (1.0 - by_force)};
  }
};

/// R and Dw: e = w cos b + p sin b, q = w x p.
template <class T>
struct ReactionFrame {
  Vec3<T> w, p, q;
  T reaction, inverse_reaction;
  T sine, cosine;  ///< angle min(b, pi - b)
  T inverse_sine;
  T sign;   ///< sign of cos b
  T speed;  ///< |Dw|, 1 if friction is dry
};

/// The triangle after a Newton step by the secants.
template <class T>
struct SlipState : SlipTriangle<T> {
  ContactMove<T> move;  ///< from the last evaluated contact
  T step;               ///< last step of ln tan psi
  T squares;            ///< sum of its squared steps
  T inverse_slope;      ///< d ln tan psi over d(residual)
  T trust;              ///< largest move over trust_radius
};

template <class T>
struct TrackerState {
  // The joint.
  T radius;                    ///< rho, m
  T side;                      ///< s of docs/explanation/joint.md (7)
  T is_ball, is_viscous;       ///< 1 or 0
  T is_plain;                  ///< 1: needs only the exact integrals
  T pressure_part, area_part;  ///< JointContact::Strength at speed 1

  // The last solution.
  T last_inverse_reaction, last_sine, last_cosine, last_speed;
  T last_tangent, last_residual;  ///< ln tan psi - ln f/cos a of the contact
  T tangent_by_reaction, tangent_by_angle;  ///< d ln tan psi over d ln R, db

  // The last evaluated contact.
  T inverse_force, inverse_axis_cosine;  ///< 1/R_n, 1/cos a
  Secants<T> friction, sliding, spinning;
  ContactMove<T> last_move;  ///< to it, from the one before
  T inverse_square;          ///< 1/length^2 of this move
  T slope_error;             ///< recent errors of slopes: d ln F per length
  T is_known;                ///< 1: slopes and curvatures from a pin's window
  Window<T> window;

  // The last prediction and its M_t.
  ReactionFrame<T> frame;
  SlipState<T> slip;
  Vec3<T> reaction, moment;
  Mat3<T> jacobian;  ///< dM_t/dR
  T error;           ///< relative, of `moment`

  // The last kept applied moment, and its change from the previous one.
  Vec3<T> kept, stretch;
};

}  // namespace multibody::detail
