#include "separation/results/quantities.hpp"

namespace separation {
namespace {

using contact::Dimension;
using contact::Quantity;

constexpr Quantity<JointPeaks> of_joint[] = {
    {"peak_reaction", "", Dimension::force, "largest reaction",
     [](const JointPeaks& p) { return p.reaction; }},
    {"peak_reaction_time", "", Dimension::time, "when that was",
     [](const JointPeaks& p) { return p.reaction_time; }},
    {"peak_pressure", "", Dimension::stress, "largest peak pressure",
     [](const JointPeaks& p) { return p.peak_pressure(); }},
    {"largest_half_angle", "largest_theta0", Dimension::angle,
     "largest half-angle of the contact",
     [](const JointPeaks& p) { return p.largest_half_angle(); }},
    {"largest_friction_moment", "", Dimension::moment,
     "largest friction moment", [](const JointPeaks& p) { return p.moment; }},
    {"least_rim_gap", "", Dimension::length,
     "least distance of the contact to a rim of its seat",
     [](const JointPeaks& p) { return p.least_gap(); }, "",
     [](const JointPeaks& p) { return std::isfinite(p.least_gap()); }},
    {"time_at_rim", "", Dimension::time,
     "for which the contact was at a rim of its seat",
     [](const JointPeaks& p) { return p.rim_time; }, "",
     [](const JointPeaks& p) { return std::isfinite(p.least_gap()); }},
};

constexpr Quantity<BodyRecord> of_hinge[] = {
    {"peak_reaction", "", Dimension::force, "largest reaction of the hinge",
     [](const BodyRecord& b) { return b.peak_reaction; }},
    {"peak_reaction_time", "", Dimension::time, "when that was",
     [](const BodyRecord& b) { return b.peak_reaction_time; }},
};

constexpr Quantity<BodyRecord> of_lock[] = {
    {"peak_lock_reaction", "", Dimension::force, "largest reaction of the lock",
     [](const BodyRecord& b) { return b.peak_lock; }},
    {"peak_lock_reaction_time", "", Dimension::time, "when that was",
     [](const BodyRecord& b) { return b.peak_lock_time; }},
};

constexpr Quantity<BodyRecord> of_stop[] = {
    {"peak_stop_moment", "", Dimension::moment, "largest moment of a stop",
     [](const BodyRecord& b) { return b.peak_stop; }},
    {"peak_stop_moment_time", "", Dimension::time, "when that was",
     [](const BodyRecord& b) { return b.peak_stop_time; }},
    {"impacts", "", Dimension::number, "impacts on stops",
     [](const BodyRecord& b) { return b.impacts; }},
    {"largest_stop_impulse", "largest_stop_impulse_N_m_s", Dimension::number,
     "largest impulse of a rigid stop, N m s",
     [](const BodyRecord& b) { return b.largest_impulse; }},
    {"stop_impulses", "stop_impulses_N_m_s", Dimension::number,
     "sum of the impulses of rigid stops, N m s",
     [](const BodyRecord& b) { return b.stop_impulses; }},
    {"energy_of_stops", "", Dimension::energy,
     "energy that rigid stops have taken",
     [](const BodyRecord& b) { return b.stop_loss; }},
    {"rests_on_stop", "", Dimension::time,
     "for which the body rested on a rigid stop",
     [](const BodyRecord& b) { return b.rest_on_stop; }},
};

constexpr Quantity<BodyRecord> of_latch[] = {
    {"peak_latch_moment", "", Dimension::moment, "largest moment of the latch",
     [](const BodyRecord& b) { return b.peak_latch; }},
    {"peak_latch_moment_time", "", Dimension::time, "when that was",
     [](const BodyRecord& b) { return b.peak_latch_time; }},
    {"latch_impulse", "latch_impulse_N_m_s", Dimension::number,
     "largest impulse by which it latched, N m s",
     [](const BodyRecord& b) { return b.latch_impulse; }},
    {"energy_of_latches", "", Dimension::energy,
     "energy that latches have taken",
     [](const BodyRecord& b) { return b.latch_loss; }},
};

constexpr Quantity<BodyRecord> of_body[] = {
    {"work_of_friction", "", Dimension::energy, "work of the hinge's friction",
     [](const BodyRecord& b) { return b.work; }},
    {"time_at_rest", "", Dimension::time, "for which the hinge rested",
     [](const BodyRecord& b) { return b.rest_time; }},
};

constexpr Quantity<TorqueMargin> of_margin[] = {
    {"torque_margin", "", Dimension::number,
     "least driving over resisting moment on the hinge's way",
     [](const TorqueMargin& m) { return m.ratio; }},
    {"torque_margin_angle", "", Dimension::angle, "where that is",
     [](const TorqueMargin& m) { return m.angle; }},
    {"torque_margin_driving", "", Dimension::moment,
     "driving moment there, with its factor",
     [](const TorqueMargin& m) { return m.driving; }},
    {"torque_margin_friction", "", Dimension::moment,
     "friction of the joints there, with its factor",
     [](const TorqueMargin& m) { return m.friction; }},
    {"torque_margin_other", "", Dimension::moment,
     "other resisting moments there, with their factor",
     [](const TorqueMargin& m) { return m.other; }},
};

using Release = BodyRecord::Release;
constexpr Quantity<Release> of_release[] = {
    {"time", "", Dimension::time, "of the release",
     [](const Release& r) { return r.time; }},
    {"angle", "", Dimension::angle, "of the hinge",
     [](const Release& r) { return r.angle; }},
    {"rate", "", Dimension::angular_velocity,
     "of the angle on an axis, else |Dw|",
     [](const Release& r) { return r.rate; }},
    {"angular_velocity", "", Dimension::angular_velocity, "Dw, body axes",
     [](const Release& r) -> const Eigen::Vector3d& { return r.rates; }},
    {"velocity", "", Dimension::velocity,
     "of the centre of mass against the parent's, parent axes",
     [](const Release& r) -> const Eigen::Vector3d& { return r.velocity; }},
};

constexpr Quantity<TipOffRecord> of_tip_off[] = {
    {"time", "", Dimension::time, "when that is",
     [](const TipOffRecord& t) { return t.time; }},
    {"angular_velocity", "", Dimension::angular_velocity, "body axes",
     [](const TipOffRecord& t) -> const Eigen::Vector3d& { return t.rates; }},
    {"velocity", "", Dimension::velocity, "inertial axes",
     [](const TipOffRecord& t) -> const Eigen::Vector3d& {
       return t.velocity;
     }},
    {"attitude", "", Dimension::angle,
     "axis times angle, body axes to inertial ones",
     [](const TipOffRecord& t) -> const Eigen::Vector3d& {
       return t.attitude;
     }},
    {"tip_off_rate", "", Dimension::angular_velocity,
     "across the direction that is named",
     [](const TipOffRecord& t) { return t.across; }, "",
     [](const TipOffRecord& t) { return !std::isnan(t.across); }},
    {"mass", "", Dimension::mass, "of a body whose mass flows",
     [](const TipOffRecord& t) { return t.mass; }, "",
     [](const TipOffRecord& t) { return !std::isnan(t.mass); }},
};

}  // namespace

std::span<const Quantity<TipOffRecord>> tip_off_quantities() {
  return of_tip_off;
}
std::span<const Quantity<JointPeaks>> joint_quantities() { return of_joint; }
std::span<const Quantity<BodyRecord>> hinge_quantities() { return of_hinge; }
std::span<const Quantity<BodyRecord>> lock_quantities() { return of_lock; }
std::span<const Quantity<BodyRecord>> stop_quantities() { return of_stop; }
std::span<const Quantity<BodyRecord>> latch_quantities() { return of_latch; }
std::span<const Quantity<BodyRecord>> body_quantities() { return of_body; }
std::span<const Quantity<TorqueMargin>> margin_quantities() {
  return of_margin;
}
std::span<const Quantity<Release>> release_quantities() { return of_release; }

const contact::Unit& summary_unit(Dimension dimension) {
  return dimension == Dimension::angular_velocity
             ? contact::unit_of(dimension, "deg_per_s")
             : contact::printed_unit(dimension);
}

}  // namespace separation
