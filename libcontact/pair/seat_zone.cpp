#include "libcontact/pair/seat_zone.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/base/check.hpp"
#include "libcontact/base/constants.hpp"

namespace contact {
namespace {

using detail::pi;

}  // namespace

SeatZone::SeatZone(double from, double to) : from_(from), to_(to) {
  detail::require(from >= 0 && from < pi, "seat", "from", from, "0 to pi rad");
  detail::require(to > 0 && to <= pi, "seat", "to", to, "above 0 to pi rad");
  // Degrees that are 1 apart are so to rounding.
  detail::require(to - from >= smallest_width * (1 - 1e-12), "seat",
                  "to - from", to - from, "at least 1 deg (0.01745 rad)");
}

SeatZone SeatZone::ring(double width, double radius) {
  detail::require(detail::is_above_zero(radius), "seat", "radius", radius,
                  "above 0 m");
  detail::require(width > 0 && width < 2 * radius, "seat", "ring width", width,
                  "above 0 m and less than the ball's diameter");
  const double half = std::asin(width / (2 * radius));
  return {pi / 2 - half, pi / 2 + half};
}

SeatZone SeatZone::cup(double half_angle) { return {0, half_angle}; }

SeatZone SeatZone::about(const std::array<double, 3>& axis) const {
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  detail::require(detail::is_above_zero(length), "seat", "length of the axis",
                  length, "above 0 and finite");
  SeatZone other = *this;
  // A unit vector stays what it is, to the last bit.
  const bool is_unit = std::abs(length - 1) < 1e-15;
  for (int i = 0; i < 3; ++i) {
    other.axis_[i] = is_unit ? axis[i] : axis[i] / length;
  }
  return other;
}

SeatZone SeatZone::moved_in(double setback) const {
  detail::require(detail::is_not_negative(setback), "seat", "setback", setback,
                  "at least 0 rad and finite");
  SeatZone other = *this;
  other.setback_ += setback;
  detail::require(other.width() >= smallest_width, "seat",
                  "width after the setback", other.width(),
                  "at least 1 deg (0.01745 rad)");
  return other;
}

SeatZone SeatZone::drawn() const {
  SeatZone other = *this;
  other.setback_ = 0;
  return other;
}

double SeatZone::nominal_area(double radius) const {
  const double square = radius * radius;
  if (from_ < pi / 2 && to_ > pi / 2) {
    return 2 * square * (std::cos(from_) - std::cos(to_));
  }
  // sin^2 a - sin^2 b
  return pi * square * std::abs(std::sin(to_ + from_) * std::sin(to_ - from_));
}

SeatZone SeatZone::with_edge(const SeatEdge& edge) const {
  detail::require(detail::is_not_negative(edge.radius), "seat", "edge_radius",
                  edge.radius, "at least 0 m and finite");
  if (edge.angle) {
    detail::require(*edge.angle > 0 && *edge.angle < pi, "seat", "edge_angle",
                    *edge.angle, "above 0 and below pi rad");
  }
  detail::require(edge.report_distance > 0 && edge.report_distance < 1, "seat",
                  "report_distance", edge.report_distance,
                  "above 0 and below 1 radius");
  SeatZone other = *this;
  other.edge_ = edge;
  return other;
}

bool SeatZone::has_upper_rim() const { return to_ < pi; }

double SeatZone::reach() const {
  if (!has_lower_rim() && !has_upper_rim()) {
    return std::numeric_limits<double>::infinity();
  }
  return has_lower_rim() && has_upper_rim() ? width() / 2 : width();
}

bool SeatZone::carries(double direction) const {
  if (to() <= pi / 2) return direction < to();
  if (from() >= pi / 2) return direction > from();
  return direction >= 0 && direction <= pi;
}

double SeatZone::margin(double direction, double half_angle) const {
  constexpr double none = std::numeric_limits<double>::infinity();
  return std::min(has_lower_rim() ? direction - half_angle - from() : none,
                  has_upper_rim() ? to() - direction - half_angle : none);
}

double SeatZone::nearest(double direction) const {
  return std::clamp(direction, from(), to());
}

double SeatZone::side_angle(int rim) const {
  if (edge_.angle) return *edge_.angle;
  const double opening = rim == 0 ? from_ : pi - to_;
  return has_bore(rim) ? pi / 2 + opening : opening;
}

bool SeatZone::has_bore(int rim) const {
  return (rim == 0 ? from_ : pi - to_) < pi / 4;
}

}  // namespace contact
