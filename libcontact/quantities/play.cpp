#include "libcontact/quantities/play.hpp"

namespace contact {
namespace {

using F = ForceState;
constexpr Quantity<F> of_force_state[] = {
    {"force", "F", Dimension::force, "force",
     [](const F& s) { return s.force; }},
    {"slope", "", Dimension::line_force, "dF/d penetration",
     [](const F& s) { return s.slope; }},
    {"energy", "W", Dimension::energy, "strain energy, whose derivative F is",
     [](const F& s) { return s.energy; }},
    {"half_angle", "theta0", Dimension::angle, "half-angle of the contact",
     [](const F& s) { return s.half_angle; }},
    {"force_ratio", "S", Dimension::number, "sum of the pressures over F",
     [](const F& s) { return s.force_ratio; }},
};

using I = Impact;
constexpr Quantity<I> of_impact[] = {
    {"restitution", "e", Dimension::number, "coefficient of restitution",
     [](const I& i) { return i.restitution; }},
    {"penetration", "", Dimension::length, "largest penetration",
     [](const I& i) { return i.penetration; }},
    {"elastic_force", "F", Dimension::force,
     "force at the largest penetration, without damping",
     [](const I& i) { return i.elastic_force; }},
    {"peak_force", "", Dimension::force, "largest force with damping",
     [](const I& i) { return i.peak_force; }},
    {"half_angle", "theta0", Dimension::angle,
     "half-angle at the largest penetration",
     [](const I& i) { return i.half_angle; }},
    {"peak_pressure", "p_peak", Dimension::stress,
     "largest pressure with damping",
     [](const I& i) { return i.peak_pressure; }},
    {"compression_time", "", Dimension::time,
     "from touch to the largest penetration",
     [](const I& i) { return i.compression_time; }},
    {"restitution_time", "", Dimension::time, "from there to parting",
     [](const I& i) { return i.restitution_time; }},
};

using P = PlayForce;
constexpr Quantity<P> of_force[] = {
    {"penetration", "", Dimension::length,
     "from first touch; its zero is touching and parting",
     [](const P& f) { return f.penetration; }},
    {"force", "", Dimension::force, "on the ball or pin",
     [](const P& f) -> const Eigen::Vector3d& { return f.force; }},
    {"moment", "", Dimension::moment, "on the ball or pin about its centre",
     [](const P& f) -> const Eigen::Vector3d& { return f.moment; }},
    {"normal_force", "R_n", Dimension::force, "normal force with damping",
     [](const P& f) { return f.normal_force; }},
    {"energy", "W", Dimension::energy, "strain energy",
     [](const P& f) { return f.energy; }},
    {"damping_power", "", Dimension::power, "power of damping",
     [](const P& f) { return f.damping_power; }},
    {"friction_power", "", Dimension::power, "power of friction",
     [](const P& f) { return f.friction_power; }},
};

}  // namespace

std::span<const Quantity<ForceState>> force_state_quantities() {
  return of_force_state;
}

std::span<const Quantity<Impact>> impact_quantities() { return of_impact; }

std::span<const Quantity<PlayForce>> play_force_quantities() {
  return of_force;
}

}  // namespace contact
