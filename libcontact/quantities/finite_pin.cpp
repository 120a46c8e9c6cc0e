#include "libcontact/quantities/finite_pin.hpp"

namespace contact {
namespace {

bool is_touching(const PinLie& s) { return s.pieces > 0; }

constexpr Quantity<PinLie> of_lie[] = {
    {"tilt", "", Dimension::angle, "slope of the pin's axis in its hole",
     [](const PinLie& s) -> const Eigen::Vector3d& { return s.tilt; }},
    {"pieces", "", Dimension::number, "pieces of contact along the pin",
     [](const PinLie& s) { return s.pieces; }},
    {"low", "z_low", Dimension::length,
     "where contact begins along the pin, from its middle",
     [](const PinLie& s) { return s.low; }, "", is_touching},
    {"high", "z_high", Dimension::length, "where it ends",
     [](const PinLie& s) { return s.high; }, "", is_touching},
    {"peak_place", "z_peak", Dimension::length,
     "where along the pin the pressure is largest",
     [](const PinLie& s) { return s.peak_place; }, "", is_touching},
    {"largest_half_angle", "theta0_max", Dimension::angle,
     "the largest half-angle along the pin",
     [](const PinLie& s) { return s.largest_half_angle; }},
    {"half_angle_place", "z_theta0_max", Dimension::length,
     "where along the pin", [](const PinLie& s) { return s.half_angle_place; },
     "", is_touching},
    {"low_pressure", "p_low", Dimension::stress,
     "largest pressure at the end of the pin at -length/2",
     [](const PinLie& s) { return s.end_pressure[0]; }},
    {"high_pressure", "p_high", Dimension::stress, "at that at length/2",
     [](const PinLie& s) { return s.end_pressure[1]; }},
    {"low_half_angle", "theta0_low", Dimension::angle,
     "half-angle at the end at -length/2",
     [](const PinLie& s) { return s.end_half_angle[0]; }},
    {"high_half_angle", "theta0_high", Dimension::angle, "at that at length/2",
     [](const PinLie& s) { return s.end_half_angle[1]; }},
    {"tilting_moment", "G", Dimension::moment,
     "sum of z times the normal force on the hole",
     [](const PinLie& s) -> const Eigen::Vector3d& {
       return s.tilting_moment;
     }},
    {"tilting_stiffness", "", Dimension::moment,
     "dG/dtilt in the plane of the reaction at a known shift, per rad",
     [](const PinLie& s) { return s.tilting_stiffness; }},
    {"moment", "M_middle", Dimension::moment,
     "on the body about the middle of the pin: across the axis of all that "
     "acts, along it of friction",
     [](const PinLie& s) -> const Eigen::Vector3d& { return s.moment; }},
    {"axial_friction_force", "R_t_axial", Dimension::force,
     "friction force on the body along the axis",
     [](const PinLie& s) { return s.axial_friction_force; }},
};

}  // namespace

std::span<const Quantity<PinLie>> lie_quantities() { return of_lie; }

}  // namespace contact
