#include <cmath>

#include "libcontact/quantities/tables.hpp"

namespace contact {
namespace {

constexpr Quantity<JointCycle::Instant> of_instant[] = {
    {"time", "", Dimension::time, "time of the cycle",
     [](const JointCycle::Instant& i) { return i.time; }},
    {"reaction", "R", Dimension::force, "reaction on the body",
     [](const JointCycle::Instant& i) -> const Eigen::Vector3d& {
       return i.state.reaction;
     }},
    {"angular_velocity", "w", Dimension::angular_velocity,
     "angular velocity Dw, body against carrier",
     [](const JointCycle::Instant& i) -> const Eigen::Vector3d& {
       return i.state.angular_velocity;
     }},
};

// L is over R_n, without which interference wears too.
bool has_load_alone(const JointCycle& c) {
  return !c.contact().has_interference();
}

constexpr Quantity<JointCycle> of_cycle[] = {
    {"period", "", Dimension::time,
     "one cycle; integrals and means are over it",
     [](const JointCycle& c) { return c.cycle().period(); }},
    {"closure", "", Dimension::angle,
     "gap after which the integrated rates close the turn",
     [](const JointCycle& c) { return c.cycle().closure(); }},
    {"energy", "", Dimension::energy, "dissipated by friction",
     [](const JointCycle& c) { return c.sums().energy; }},
    {"mean_heat", "", Dimension::power, "energy over period",
     [](const JointCycle& c) { return c.sums().energy / c.cycle().period(); }},
    {"sliding_path", "", Dimension::length,
     "path of the rim: integral of rho |Dw|",
     [](const JointCycle& c) { return c.sums().sliding_path; }},
    {"effective_sliding_distance", "", Dimension::length,
     "integral of rho |Dw| L, the slip that wears under p",
     [](const JointCycle& c) { return c.sums().effective_distance; }, "",
     has_load_alone},
    {"pv_integral", "", Dimension::energy,
     "of p v over contact and time; times k: volume",
     [](const JointCycle& c) { return c.sums().pv; }},
    {"mean_moment", "mean_M_t", Dimension::moment,
     "mean of the friction moment",
     [](const JointCycle& c) { return c.sums().moment / c.cycle().period(); }},
    {"contact_spread", "", Dimension::angle,
     "of the contact over the seat: rms angle from its middle, weight p v",
     [](const JointCycle& c) { return c.contact_spread(); }},
};

bool has_seat(const JointCycle& c) {
  return !c.joint().is_pin() && !c.joint().is_endless();
}

// It rises with K.
double rim_pressure(const JointCycle& cycle) {
  return cycle.of_rims(cycle.largest_intensity(), &RimContact::rim_pressure);
}

constexpr Quantity<JointCycle> of_worst[] = {
    {"largest_peak_pressure", "largest_p_peak", Dimension::stress,
     "peak pressure; at rims report_distance (0.02 radii) or more from them",
     [](const JointCycle& c) {
       return c.largest_peak().solution.peak_pressure;
     }},
    {"largest_pv", "largest_pv_max", Dimension::power_density,
     "largest p v; at rims report_distance (0.02 radii) or more from them",
     [](const JointCycle& c) { return c.pv(c.largest_pv()).largest; }},
    {"rim_share", "", Dimension::number,
     "share of the time in which the contact is at a rim of its seat",
     [](const JointCycle& c) { return c.rim_share(); }, "", has_seat},
    {"least_gap", "", Dimension::length,
     "from the contact to the nearest rim along the seat",
     [](const JointCycle& c) {
       return c.of_rims(c.least_gap(), &RimContact::gap);
     },
     "", has_seat},
    {"largest_intensity", "largest_K", Dimension::number,
     "largest p sqrt(2 pi s) at a rim, s from it, Pa m^0.5",
     [](const JointCycle& c) {
       return c.of_rims(c.largest_intensity(), &RimContact::intensity);
     },
     "", has_seat},
    {"largest_rim_pressure", "largest_p_rim", Dimension::stress,
     "largest pressure on a rim, rounded by edge_radius",
     [](const JointCycle& c) { return rim_pressure(c); }, "",
     [](const JointCycle& c) { return !std::isnan(rim_pressure(c)); }},
    {"table_error", "", Dimension::number,
     "of the table of contacts, over the load: the largest of 100 states",
     [](const JointCycle& c) { return c.joint().table_check()->error(); }, "",
     [](const JointCycle& c) { return c.joint().table_check().has_value(); }},
};

using Worn = WearIn::State;
constexpr Quantity<Worn> of_worn[] = {
    {"cycles", "", Dimension::number, "after them",
     [](const Worn& w) { return w.cycles; }},
    {"wear_number", "", Dimension::number,
     "volume over pi rho^2 eps, of a pin 2 rho eps l",
     [](const Worn& w) { return w.wear_number; }},
    {"volume", "volume_seat", Dimension::volume, "worn off; reliable",
     [](const Worn& w) { return w.volume; }},
    {"penetration", "", Dimension::length,
     "deepest wear; to 8 %, once most of it is wear, of loads that stand still",
     [](const Worn& w) { return w.penetration; }},
    {"half_angle", "theta0", Dimension::angle, "largest, to 1.1 deg",
     [](const Worn& w) { return w.half_angle; }},
    {"peak_pressure", "p_peak", Dimension::stress,
     "largest, to 6 %, of a ball much worn up to 17 % too high",
     [](const Worn& w) { return w.peak_pressure; }},
    {"pv_max", "", Dimension::power_density, "largest, as p_peak",
     [](const Worn& w) { return w.pv; }},
    {"energy", "", Dimension::energy, "of a cycle",
     [](const Worn& w) { return w.energy; }},
    {"mean_moment", "mean_M_t", Dimension::moment,
     "mean of the friction moment",
     [](const Worn& w) { return w.mean_moment; }},
    {"worn_share", "", Dimension::number,
     "of p ~ cos theta in the pressure; the rest is the joint's",
     [](const Worn& w) { return w.worn_share; }},
    {"clearance", "", Dimension::length,
     "mean radial clearance round a pin; below 0: interference",
     [](const Worn& w) { return w.clearance; }},
};

}  // namespace

std::span<const Quantity<JointCycle::Instant>> instant_quantities() {
  return of_instant;
}

std::span<const Quantity<JointCycle>> cycle_quantities() { return of_cycle; }

std::span<const Quantity<JointCycle>> worst_quantities() { return of_worst; }

std::span<const Quantity<WearIn::State>> worn_quantities() { return of_worn; }

}  // namespace contact
