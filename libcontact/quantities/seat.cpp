#include "libcontact/quantities/seat.hpp"

#include <cmath>
#include <iterator>
#include <vector>

#include "libcontact/quantities/tables.hpp"

namespace contact {
namespace {

bool is_number(double x) { return !std::isnan(x); }

constexpr Quantity<RimContact> of_seat[] = {
    {"free", "", Dimension::number, "1 if the contact reaches no rim",
     [](const RimContact& s) {
       return std::isnan(s.area) ? s.area : double(s.is_free);
     }},
    {"peak_pressure", "p_peak", Dimension::stress,
     "largest pressure report_distance (0.02 radii) or more from every rim",
     [](const RimContact& s) { return s.peak_pressure; }},
    {"peak_polar_angle", "v_peak", Dimension::angle,
     "its angle from the seat's axis",
     [](const RimContact& s) { return s.peak_place.polar_angle; }},
    {"peak_longitude", "phi_peak", Dimension::angle,
     "its longitude from the plane of the load",
     [](const RimContact& s) { return s.peak_place.longitude; }},
    {"pressure_at_load", "p_at_load", Dimension::stress,
     "pressure where the load pierces the seat",
     [](const RimContact& s) { return s.pressure_at_load; }},
    {"lower_end", "v_low", Dimension::angle,
     "end of the contact in the plane of the load, from the seat's axis",
     [](const RimContact& s) { return s.lower_end; }},
    {"upper_end", "v_high", Dimension::angle, "the other end",
     [](const RimContact& s) { return s.upper_end; }},
    {"half_width", "", Dimension::angle,
     "from the load to the contact's end across the plane of the load",
     [](const RimContact& s) { return s.half_width; }},
    {"lower_rim_distance", "lower_rim", Dimension::angle,
     "from the contact to the lower rim in that plane; 0 if it is reached",
     [](const RimContact& s) { return s.rims[0].distance; }},
    {"upper_rim_distance", "upper_rim", Dimension::angle, "to the upper rim",
     [](const RimContact& s) { return s.rims[1].distance; }},
    {"lower_rim_gap", "lower_gap", Dimension::length,
     "from the contact to the lower rim along the seat",
     [](const RimContact& s) { return s.rims[0].gap; }},
    {"upper_rim_gap", "upper_gap", Dimension::length, "to the upper rim",
     [](const RimContact& s) { return s.rims[1].gap; }},
    {"lower_intensity", "K_low", Dimension::number,
     "p sqrt(2 pi s) at the lower rim, s from it, Pa m^0.5",
     [](const RimContact& s) { return s.rims[0].intensity; }},
    {"upper_intensity", "K_high", Dimension::number, "at the upper rim",
     [](const RimContact& s) { return s.rims[1].intensity; }},
    {"lower_rim_pressure", "p_rim_low", Dimension::stress,
     "largest pressure on the lower rim, rounded by edge_radius",
     [](const RimContact& s) { return s.rims[0].peak_pressure; }, "",
     [](const RimContact& s) { return is_number(s.rims[0].peak_pressure); }},
    {"upper_rim_pressure", "p_rim_high", Dimension::stress, "on the upper rim",
     [](const RimContact& s) { return s.rims[1].peak_pressure; }, "",
     [](const RimContact& s) { return is_number(s.rims[1].peak_pressure); }},
    {"force_ratio", "S", Dimension::number,
     "sum of the pressures without regard to their direction over the load",
     [](const RimContact& s) { return s.force_ratio; }},
    {"contact_area", "", Dimension::area, "area of the contact",
     [](const RimContact& s) { return s.area; }},
    {"shift", "", Dimension::length,
     "of the ball's centre from where it is concentric",
     [](const RimContact& s) -> const Eigen::Vector3d& { return s.shift; }},
};

constexpr Quantity<RimContact> of_rims[] = {
    {"seat_force", "F", Dimension::force,
     "force on the seat, sum of its pressures",
     [](const RimContact& s) -> const Eigen::Vector3d& { return s.force; },
     "force on the seat"},
    {"nominal_area", "", Dimension::area,
     "the area of catalogues: diameter times width, of cups and thrust "
     "bearings the projection along the axis",
     [](const RimContact& s) { return s.nominal_area; }},
};

}  // namespace

std::span<const Quantity<RimContact>> seat_quantities() { return of_seat; }

std::span<const Quantity<RimContact>> rim_quantities() {
  static const auto& all = *new std::vector<Quantity<RimContact>>([] {
    std::vector<Quantity<RimContact>> some(std::begin(of_rims),
                                           std::end(of_rims));
    for (const auto& quantity : of_seat) {
      if (!find_quantity(solution_quantities(), quantity.key)) {
        some.push_back(quantity);
      }
    }
    return some;
  }());
  return all;
}

}  // namespace contact
