#include "libcontact/quantities/finite_pin.hpp"

namespace contact {
namespace {

using S = FinitePinSolution;

bool touches(const S& s) { return s.contact.pieces > 0; }

constexpr Quantity<S> of_finite_pin[] = {
    {"status", "", Dimension::number, "how the solver ended",
     [](const S& s) { return s.contact.status; }},
    {"tilt_x", "", Dimension::angle, "tilt in the plane of the reaction",
     [](const S& s) { return s.contact.tilt.x(); }},
    {"tilt_y", "", Dimension::angle, "tilt across it",
     [](const S& s) { return s.contact.tilt.y(); }},
    {"pieces", "", Dimension::number, "pieces of contact along the pin",
     [](const S& s) { return s.contact.pieces; }},
    {"low", "z_low", Dimension::length,
     "where contact begins along the pin, from its middle",
     [](const S& s) { return s.contact.low; }, "", touches},
    {"high", "z_high", Dimension::length, "where it ends",
     [](const S& s) { return s.contact.high; }, "", touches},
    {"peak_pressure", "p_peak", Dimension::stress, "peak pressure",
     [](const S& s) { return s.contact.peak_pressure; }},
    {"peak_place", "z_peak", Dimension::length, "where along the pin",
     [](const S& s) { return s.contact.peak_place; }, "", touches},
    {"largest_half_angle", "theta0_max", Dimension::angle,
     "the largest half-angle",
     [](const S& s) { return s.contact.largest_half_angle; }},
    {"half_angle_place", "z_theta0_max", Dimension::length,
     "where along the pin",
     [](const S& s) { return s.contact.half_angle_place; }, "", touches},
    {"low_pressure", "p_low", Dimension::stress,
     "largest pressure at the end of the pin at -length/2",
     [](const S& s) { return s.contact.end_pressure[0]; }},
    {"high_pressure", "p_high", Dimension::stress, "at that at length/2",
     [](const S& s) { return s.contact.end_pressure[1]; }},
    {"low_half_angle", "theta0_low", Dimension::angle,
     "half-angle at the end at -length/2",
     [](const S& s) { return s.contact.end_half_angle[0]; }},
    {"high_half_angle", "theta0_high", Dimension::angle, "at that at length/2",
     [](const S& s) { return s.contact.end_half_angle[1]; }},
    {"tilting_moment_x", "G_x", Dimension::moment,
     "sum of z times the normal force, along the reaction",
     [](const S& s) { return s.contact.force_moment.x(); }},
    {"tilting_moment_y", "G_y", Dimension::moment, "across it",
     [](const S& s) { return s.contact.force_moment.y(); }},
    {"tilting_stiffness", "", Dimension::moment,
     "dG_x/dtilt_x at a known shift, per rad",
     [](const S& s) { return s.contact.stiffness(2, 2); }},
    {"moment", "M", Dimension::moment,
     "about the middle: x and y of all that acts, z of friction",
     [](const S& s) -> const Eigen::Vector3d& { return s.moment; }},
    {"axial_friction_force", "R_t_z", Dimension::force,
     "friction force on the body along the axis",
     [](const S& s) { return s.axial_friction_force; }},
};

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

using Cycle = PinCycle;
using Instant = PinCycle::Instant;

constexpr Quantity<Cycle> of_cycle[] = {
    {"largest_pv", "pin_largest_pv", Dimension::power_density,
     "largest p v of the pin that ends",
     [](const Cycle& c) { return c.largest_pv().largest_pv(); }},
    {"largest_peak_pressure", "pin_largest_p_peak", Dimension::stress,
     "its largest pressure",
     [](const Cycle& c) {
       return c.largest_peak().solution.contact.peak_pressure;
     }},
    {"largest_half_angle", "pin_largest_theta0", Dimension::angle,
     "its largest half-angle",
     [](const Cycle& c) {
       return c.largest_half_angle().solution.contact.largest_half_angle;
     }},
    {"energy", "pin_energy", Dimension::energy, "dissipated by its friction",
     [](const Cycle& c) {
       return c.integral([](const Instant& i) {
         return -i.solution.moment.z() * i.state.angular_velocity.z();
       });
     }},
    {"pv_integral", "pin_pv_integral", Dimension::energy,
     "of p v over its contact and time; times k: volume",
     [](const Cycle& c) {
       const double radius = c.pin().force_law().geometry().radius();
       return c.integral([&](const Instant& i) {
         return i.slip_speed * i.solution.contact.pressure_moment / radius;
       });
     }},
};

}  // namespace

std::span<const Quantity<PinCycle>> pin_cycle_quantities() { return of_cycle; }

std::span<const Quantity<PinLie>> lie_quantities() { return of_lie; }

std::span<const Quantity<FinitePinSolution>> finite_pin_quantities() {
  return of_finite_pin;
}

}  // namespace contact
