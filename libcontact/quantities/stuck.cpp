#include "libcontact/quantities/stuck.hpp"

namespace contact {
namespace {

constexpr Quantity<StuckJoint> of_stuck[] = {
    {"load_stiffness", "K_load", Dimension::moment,
     "stiffness against a turn across a constant load, per rad",
     [](const StuckJoint& s) { return s.load_stiffness; }},
    {"held_stiffness", "K_held", Dimension::moment,
     "stiffness with the centre held, per rad",
     [](const StuckJoint& s) { return s.held_stiffness; }},
    {"spin_stiffness", "K_spin", Dimension::moment,
     "against a turn of a ball about the load, per rad",
     [](const StuckJoint& s) { return s.spin_stiffness; }},
    {"friction_moment", "M_s", Dimension::moment,
     "friction moment of slow sliding across the load",
     [](const StuckJoint& s) { return s.friction_moment; }},
    {"shape_exponent", "b", Dimension::number,
     "of the way from stuck to sliding: M/M_s = 1 - (1 - x/b)^b, x = w "
     "K_load/M_s",
     [](const StuckJoint& s) { return s.shape; }},
    {"dahl_exponent", "", Dimension::number,
     "of Dahl's model beside sigma0 = K_load",
     [](const StuckJoint& s) { return s.dahl_exponent(); }},
    {"lugre_stiffness", "sigma0", Dimension::moment,
     "of plain LuGre, which turns as far at M_s/2, per rad",
     [](const StuckJoint& s) { return s.lugre_stiffness(); }},
    {"breakaway_angle", "", Dimension::angle,
     "turn at which the joint slides, b M_s/K_load",
     [](const StuckJoint& s) { return s.breakaway_angle(); }},
};

}  // namespace

std::span<const Quantity<StuckJoint>> stuck_quantities() { return of_stuck; }

}  // namespace contact
