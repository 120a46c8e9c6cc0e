#include "libcontact/seat/rim_warning.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"

namespace contact::detail {

namespace {

constexpr double acute = 85 * degree;
constexpr double obtuse = 100 * degree;
// Loads count as axial or radial to this.
constexpr double straight = 1 * degree;

bool lies_in(double x, double from, double to) {
  constexpr double rounding = 1e-9;
  return x >= from - rounding && x <= to + rounding;
}

// Displacement of a wedge's tip under a force there minus the displacement of a
// half-plane: additional compliance of a corner over the continued seat.
double yielding(double corner) {
  const double s = std::sin(corner / 2), c = std::cos(corner / 2);
  return 2 * s * s / (corner + std::sin(corner)) +
         2 * c * c / (corner - std::sin(corner)) - 2 / pi;
}

// Exponents of a product, and its factor.
struct Bound {
  double factor, distance, rim, corner, thickness, poisson, share;
};
// The least products, in the mean of their logarithms, that no difference
// exceeds.
constexpr Bound pressure_bound = {7.93, 0.58, -1.87, 0.43, 0.45, 0.65, 0.75};
constexpr Bound approach_bound = {11.83, 0.45, -1.99, 0.46, 0.60, 2.33, 0.79};

// Half-angle of a cup, half the width of a ring.
double opening(const SeatZone& zone, int rim) {
  if (zone.has_lower_rim() && zone.has_upper_rim()) return zone.width() / 2;
  return rim == 1 ? zone.to() : pi - zone.from();
}

// Up to 10 in tenths.
std::string rounded_up(double percent) {
  return percent < 10 ? message("{:.1f}", std::ceil(10 * percent) / 10)
                      : message("{:.0f}", std::ceil(percent));
}

}  // namespace

double corner_exponent(double corner) {
  if (corner < pi / 2) return nan;
  double low = 0.5, high = 1;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    const double sum =
        middle * std::sin(2 * corner) + std::sin(2 * middle * corner);
    (sum > 0 ? low : high) = middle;
  }
  return low - 1;
}

RimWarning::RimWarning(const LayeredPair& pair, const SeatZone& zone,
                       std::string cure)
    : zone_(zone),
      cure_(std::move(cure)),
      is_known_(pair.inner().layers.empty() &&
                pair.outer().layers.size() == 1 &&
                pair.outer().backing.kind() == Backing::Kind::rigid &&
                zone.setback() == 0),
      poissons_ratio_(pair.outer().surface().poissons_ratio),
      share_(pair.surfaces().outer_compliance_share()) {
  if (is_known_) {
    thickness_ = pair.outer().layers.front().thickness / pair.radius();
  }
}

double RimWarning::reach(int rim) const {
  const bool is_soft = zone_.side_angle(rim) < acute || poissons_ratio_ >= 0.4;
  return (is_soft ? 15 : 10) * degree;
}

std::optional<RimWarning::Largest> RimWarning::of_cup(int rim, double direction,
                                                      double half_angle) const {
  const bool is_axial = rim == 1
                            ? direction <= straight && zone_.from() == 0
                            : direction >= pi - straight && zone_.to() == pi;
  const double angle = opening(zone_, rim);
  const double corner = zone_.side_angle(rim);
  // In steps, so that the rows of a table say the same.
  constexpr double steps[] = {-10, -5, -2, 3, 10, 20};
  const double exact = (half_angle - angle) / degree;
  const auto* step =
      std::lower_bound(std::begin(steps), std::end(steps), exact - 0.1);
  if (!(is_axial && lies_in(angle / degree, 35, 90) &&
        lies_in(corner / degree, 60, 165) && lies_in(thickness_, 0.05, 1.5) &&
        lies_in(poissons_ratio_, 0.3, 0.46) && exact >= -15.1 &&
        step != std::end(steps))) {
    return {};
  }
  const auto value = [&](const Bound& of) {
    return of.factor *
               std::pow(std::log1p(std::exp((*step + 6) / 6)), of.distance) *
               std::pow(std::sin(angle), of.rim) *
               std::pow(yielding(corner), of.corner) *
               std::pow(thickness_ / (1 + thickness_), of.thickness) *
               std::exp(of.poisson * (poissons_ratio_ - 0.3)) *
               std::pow(share_, of.share) -
           0.5;
  };
  return Largest{std::max(value(pressure_bound), 0.0),
                 std::max(value(approach_bound), 0.0)};
}

std::optional<RimWarning::Largest> RimWarning::of_ring(double direction,
                                                       double corner) const {
  const double half = opening(zone_, 0);
  const bool is_radial = std::abs(direction - pi / 2) <= straight &&
                         std::abs(zone_.from() + half - pi / 2) <= straight;
  if (!(is_radial && lies_in(half / degree, 15, 35) &&
        lies_in(corner / degree, 60, 75) && lies_in(thickness_, 0.14, 1) &&
        lies_in(poissons_ratio_, 0.27, 0.33))) {
    return {};
  }
  if (thickness_ <= 0.3) return Largest{33, 33};
  // Under a ball that yields as much.
  if (share_ <= 0.51) return Largest{35, 48};
  return {};
}

std::optional<RimWarning::Largest> RimWarning::largest(
    int rim, double direction, double half_angle) const {
  if (!is_known_) return {};
  return zone_.has_lower_rim() && zone_.has_upper_rim()
             ? of_ring(direction, zone_.side_angle(rim))
             : of_cup(rim, direction, half_angle);
}

std::string RimWarning::sentence(int rim, std::string_view place,
                                 bool is_reached, double direction,
                                 double half_angle) const {
  const double corner = zone_.side_angle(rim);
  const auto most = largest(rim, direction, half_angle);
  const char* least = corner < obtuse ? "up to" : "-1.2 to";
  const std::string size =
      most ? message(
                 "finite elements of such seats, of {:.4g} deg, give pressures "
                 "in the middle larger by {} {} %, an approach larger by up to "
                 "{} %",
                 opening(zone_, rim) / degree, least,
                 rounded_up(most->pressure), rounded_up(most->approach))
           : std::string(
                 "true pressures in the middle and the true approach are "
                 "usually larger, in nine of ten cups of all sizes by up to 23 "
                 "and 42 %, in all by up to 152 and 1735 %, which is no bound "
                 "here (docs/explanation/seats.md)");
  return message(
      "the contact {} {}. The model neglects the free side face there, "
      "assumed at {:.4g} deg to the seat: {}, true pressures at the rim {}; {}",
      is_reached ? "is at" : "ends beside", place, corner / degree, size,
      corner < acute ? "fall to 0, so that the peak is elsewhere"
                     : "are smaller",
      cure_);
}

}  // namespace contact::detail
