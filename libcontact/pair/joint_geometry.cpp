#include "libcontact/pair/joint_geometry.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "libcontact/base/check.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace contact {
namespace {

// The theory is of first order in ebar = eps/rho. By Hertz' theory, which knows
// both radii, peaks of small contacts are (1 + ebar)^(1/2) (pin) or (1 +
// ebar)^(2/3) (ball) too high, 1 % here; by finite elements with true radii,
// peaks of wide contacts are by 0.6 to 1.2 ebar (docs/explanation/limits.md).
constexpr double largest_relative_clearance = 0.015;
// Limit of press fits: strains of a percent, beyond which metals yield.
constexpr double largest_relative_interference = 0.01;
// 0.25 um in a radius of 25 mm: errors of form and roughness of the best ground
// surfaces are of this size, and a degree or two of temperature changes it.
constexpr double smallest_relative_clearance = 1e-5;

}  // namespace

std::string to_string(JointKind kind) {
  return kind == JointKind::ball ? "ball" : "pin";
}

JointGeometry::JointGeometry(JointKind kind, double radius,
                             double radial_clearance, double length,
                             JointBody inner_body)
    : kind_(kind),
      radius_(radius),
      radial_clearance_(radial_clearance),
      length_(length),
      inner_body_(inner_body) {
  const std::string place = to_string(kind) + " joint";
  detail::require(detail::is_above_zero(radius), place, "radius", radius,
                  "above 0 m and finite");
  detail::require(std::abs(radial_clearance) < radius, place,
                  "radial_clearance", radial_clearance,
                  detail::message("above {} and below {} m", -radius, radius));
  if (kind == JointKind::pin) {
    detail::require(detail::is_above_zero(length), place, "length", length,
                    "above 0 m and finite");
  }
}

JointGeometry JointGeometry::ball(double radius, double radial_clearance,
                                  JointBody inner_body) {
  return {JointKind::ball, radius, radial_clearance,
          std::numeric_limits<double>::quiet_NaN(), inner_body};
}

JointGeometry JointGeometry::pin(double radius, double radial_clearance,
                                 double length, JointBody inner_body) {
  return {JointKind::pin, radius, radial_clearance, length, inner_body};
}

JointGeometry JointGeometry::with_seat(const SeatZone& zone) const {
  if (kind_ != JointKind::ball) {
    throw Error(detail::needs("a seat that ends", "a ball joint"));
  }
  JointGeometry other = *this;
  other.seat_ = zone;
  return other;
}

JointGeometry JointGeometry::without_seat() const {
  JointGeometry other = *this;
  other.left_out_ = drawn_seat();
  other.seat_.reset();
  return other;
}

std::vector<std::string> JointGeometry::validity_notes() const {
  std::vector<std::string> notes;
  const double relative = relative_clearance();
  if (relative < -largest_relative_interference) {
    notes.push_back(detail::message(
        "relative interference {:.3g} exceeds {}: the theory is of first order "
        "in it",
        -relative, largest_relative_interference));
  }
  if (relative > largest_relative_clearance) {
    notes.push_back(
        detail::message("relative clearance {:.3g} exceeds {}: the theory is "
                        "of first order in it, and pressures are too high by "
                        "0.5 to 1.2 times it; small contacts are exact with a "
                        "radial clearance of eps/(1 + eps/rho), {:.4g} mm",
                        relative, largest_relative_clearance,
                        1e3 * radial_clearance_ / (1 + relative)));
  }
  // A clearance of 0 is a model's own, which says that it is small.
  if (relative != 0 && std::abs(relative) < smallest_relative_clearance) {
    notes.push_back(
        detail::message("relative clearance {:.3g} is below {:g}: form errors "
                        "and temperature change such small clearances",
                        relative, smallest_relative_clearance));
  }
  if (radial_clearance_ < 0) {
    notes.emplace_back(
        "the hoop stress that interference causes in the two bodies is not "
        "computed");
  }
  if (radial_clearance_ <= 0 && kind_ == JointKind::ball) {
    notes.emplace_back(
        "without clearance the theory assumes a ball in a complete seat: use "
        "it only for nearly complete seats");
  }
  return notes;
}

LoadScale::LoadScale(const JointGeometry& geometry, const ElasticPair& pair) {
  // ebar rho1 = eps
  const double eps_E = geometry.radial_clearance() * pair.effective_modulus();
  unit_load_ = geometry.kind() == JointKind::ball
                   ? 2 * eps_E * geometry.radius() / 3
                   : eps_E * (std::numbers::pi / 2);
}

double LoadScale::x_from_load_parameter(JointKind kind, double load_parameter) {
  return kind == JointKind::ball ? std::cbrt(load_parameter)
                                 : 2 * std::sqrt(load_parameter);
}

double LoadScale::load_parameter_from_x(JointKind kind, double x) {
  if (kind == JointKind::ball) return x * x * x;
  const double half = x / 2;
  return half * half;
}

}  // namespace contact
