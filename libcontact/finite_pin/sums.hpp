#pragma once

#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>

#include "libcontact/finite_pin/finite_pin.hpp"

/// Parts of FinitePin: sums along its pin, its contacts, its peaks.
namespace contact {

struct FinitePin::Sums {
  Eigen::Vector4d load = Eigen::Vector4d::Zero();  // F, G
  double energy = 0;
  Eigen::Matrix4d stiffness = Eigen::Matrix4d::Zero();
  double pressure_moment = 0;
  Eigen::Vector4d area = Eigen::Vector4d::Zero();  // tangent, its z-moment
  double area_moment = 0;
};

/// A piece of contact along z, within one of the relief's.
struct FinitePin::Interval {
  double from, to;
  const Relief::Piece* piece;
};

/// The largest pressure of a slice by its half-angle, in pressure units, from a
/// table of 512 exact ones: for comparisons, as an exact one takes 5 us.
class FinitePin::Peaks {
 public:
  Peaks(const PressureLaw& pressure, const ForceLaw& law);

  double operator()(double half_angle) const noexcept;

 private:
  double from_, to_;  // ends of the table over the root of the half-angle
  boost::math::interpolators::cardinal_cubic_b_spline<double> spline_;
};

namespace detail {

/// By 90 deg about z.
inline Eigen::Vector2d turned(const Eigen::Vector2d& v) {
  return {-v.y(), v.x()};
}

}  // namespace detail
}  // namespace contact
