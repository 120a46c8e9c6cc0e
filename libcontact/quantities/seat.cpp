#include "libcontact/quantities/seat.hpp"

#include <cmath>
#include <iterator>
#include <vector>

#include "libcontact/quantities/lifted.hpp"
#include "libcontact/quantities/tables.hpp"

namespace contact {
namespace {

using S = RimContact;

bool is_number(double x) { return !std::isnan(x); }

constexpr Quantity<S> of_seat[] = {
    {"free", "", Dimension::number, "1 if the contact reaches no rim",
     [](const S& s) {
       return std::isnan(s.area) ? s.area : double(s.is_free);
     }},
    {"peak_pressure", "p_peak", Dimension::stress,
     "largest pressure report_distance (0.02 radii) or more from every rim",
     [](const S& s) { return s.peak_pressure; }},
    {"peak_polar_angle", "v_peak", Dimension::angle,
     "its angle from the seat's axis",
     [](const S& s) { return s.peak_place.polar_angle; }},
    {"peak_longitude", "phi_peak", Dimension::angle,
     "its longitude from the plane of the load",
     [](const S& s) { return s.peak_place.longitude; }},
    {"pressure_at_load", "p_at_load", Dimension::stress,
     "pressure where the load pierces the seat",
     [](const S& s) { return s.pressure_at_load; }},
    {"lower_end", "v_low", Dimension::angle,
     "end of the contact in the plane of the load, from the seat's axis",
     [](const S& s) { return s.lower_end; }},
    {"upper_end", "v_high", Dimension::angle, "the other end",
     [](const S& s) { return s.upper_end; }},
    {"half_width", "", Dimension::angle,
     "from the load to the contact's end across the plane of the load",
     [](const S& s) { return s.half_width; }},
    {"lower_rim_distance", "lower_rim", Dimension::angle,
     "from the contact to the lower rim in that plane; 0 if it is reached",
     [](const S& s) { return s.rims[0].distance; }},
    {"upper_rim_distance", "upper_rim", Dimension::angle, "to the upper rim",
     [](const S& s) { return s.rims[1].distance; }},
    {"lower_rim_gap", "lower_gap", Dimension::length,
     "from the contact to the lower rim along the seat",
     [](const S& s) { return s.rims[0].gap; }},
    {"upper_rim_gap", "upper_gap", Dimension::length, "to the upper rim",
     [](const S& s) { return s.rims[1].gap; }},
    {"lower_intensity", "K_low", Dimension::number,
     "p sqrt(2 pi s) at the lower rim, s from it, Pa m^0.5",
     [](const S& s) { return s.rims[0].intensity; }},
    {"upper_intensity", "K_high", Dimension::number, "at the upper rim",
     [](const S& s) { return s.rims[1].intensity; }},
    {"lower_rim_pressure", "p_rim_low", Dimension::stress,
     "largest pressure on the lower rim, rounded by edge_radius",
     [](const S& s) { return s.rims[0].peak_pressure; }, "",
     [](const S& s) { return is_number(s.rims[0].peak_pressure); }},
    {"upper_rim_pressure", "p_rim_high", Dimension::stress, "on the upper rim",
     [](const S& s) { return s.rims[1].peak_pressure; }, "",
     [](const S& s) { return is_number(s.rims[1].peak_pressure); }},
    {"force_ratio", "S", Dimension::number,
     "sum of the pressures without regard to their direction over the load",
     [](const S& s) { return s.force_ratio; }},
    {"contact_area", "", Dimension::area, "area of the contact",
     [](const S& s) { return s.area; }},
    {"shift", "", Dimension::length,
     "of the ball's centre from where it is concentric",
     [](const S& s) -> const Eigen::Vector3d& { return s.shift; }},
};

constexpr Quantity<S> of_rims[] = {
    {"seat_force", "F", Dimension::force,
     "force on the seat, sum of its pressures",
     [](const S& s) -> const Eigen::Vector3d& { return s.force; },
     "force on the seat"},
    {"nominal_area", "", Dimension::area,
     "the area of catalogues: diameter times width, of cups and thrust "
     "bearings the projection along the axis",
     [](const S& s) { return s.nominal_area; }},
};

using J = SeatJointSolution;

constexpr auto of_friction = std::to_array<Quantity<J>>({
    {"status", "", Dimension::number, "how the solver ended",
     [](const J& s) { return s.contact.status; }},
    {"reaction", "R", Dimension::force, "reaction on the body",
     [](const J& s) -> const Eigen::Vector3d& { return s.reaction; },
     "reaction"},
    {"seat_force", "F", Dimension::force,
     "force on the seat, sum of its pressures",
     [](const J& s) -> const Eigen::Vector3d& { return s.contact.force; },
     "force on the seat"},
    {"friction_force", "R_t", Dimension::force, "friction force on the body",
     [](const J& s) -> const Eigen::Vector3d& { return s.friction_force; },
     "friction force"},
    {"friction_moment", "M_t", Dimension::moment,
     "friction moment on the body about the joint's centre",
     [](const J& s) -> const Eigen::Vector3d& { return s.friction_moment; },
     "friction moment"},
    {"power", "", Dimension::power, "power of friction, never positive",
     [](const J& s) { return s.power; }},
    {"moment_coefficient", "f_M", Dimension::number,
     "M_t/(rho R), the coefficient of friction of catalogues",
     [](const J& s) { return s.moment_coefficient; }},
    {"nominal_area", "", Dimension::area,
     "the area of catalogues: diameter times width, of cups and thrust "
     "bearings the projection along the axis",
     [](const J& s) { return s.nominal_area; }},
    {"nominal_pressure", "p_nominal", Dimension::stress, "R over nominal_area",
     [](const J& s) { return s.reaction.norm() / s.nominal_area; }},
    {"evaluations", "", Dimension::number, "contacts that the solver found",
     [](const J& s) { return s.evaluations; }},
});

constexpr auto of_joint =
    detail::joined(of_friction, detail::lifted<J, &J::contact, of_seat>());

constexpr Quantity<SeatPv> of_pv[] = {
    {"pv_total", "", Dimension::power, "integral of p v over the contact",
     [](const SeatPv& pv) { return pv.total; }},
    {"pv_max", "", Dimension::power_density,
     "largest p v report_distance (0.02 radii) or more from every rim",
     [](const SeatPv& pv) { return pv.largest; }},
    {"pv_max_place", "pv_max", Dimension::number,
     "unit vector from the ball's centre to it",
     [](const SeatPv& pv) -> const Eigen::Vector3d& { return pv.place; }},
};

using Rest = SeatRestSolution;

constexpr auto of_limit = std::to_array<Quantity<Rest>>({
    {"utilisation", "", Dimension::number,
     "tau, the share of M_t that M needs: holds if <= 1",
     [](const Rest& s) { return s.utilisation; }},
    {"direction", "u", Dimension::number,
     "direction in which the joint would begin to slide",
     [](const Rest& s) -> const Eigen::Vector3d& { return s.direction; }},
});

constexpr auto of_rest =
    detail::joined(detail::lifted<Rest, &Rest::slip, of_joint>(), of_limit);

}  // namespace

std::span<const Quantity<SeatJointSolution>> seat_joint_quantities() {
  return of_joint;
}

std::span<const Quantity<SeatRestSolution>> seat_rest_quantities() {
  return of_rest;
}

std::span<const Quantity<SeatPv>> seat_pv_quantities() { return of_pv; }

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
