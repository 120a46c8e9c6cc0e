#include "python/ratings.hpp"

namespace contact_python {
namespace {

using contact::JointSolution;
using State = contact::WearIn::State;

const Field<JointSolution> of_solution[] = {
    {"status", [](const JointSolution& s) { return int(s.status); },
     "Status, as numbers."},
    {"state", [](const JointSolution& s) { return int(s.state); },
     "State, as numbers."},
    {"evaluations", [](const JointSolution& s) { return s.evaluations; },
     "Contacts that the solver evaluated."},
    {"residual", [](const JointSolution& s) { return s.residual; },
     "Estimate of |f/tan g - 1| that is left."},
    {"reaction", [](const JointSolution& s) { return s.reaction; },
     "R = R_n n + R_t on the body, N, (..., 3)."},
    {"normal", [](const JointSolution& s) { return s.normal; },
     "n, direction of the push on the body, (..., 3)."},
    {"normal_force", [](const JointSolution& s) { return s.normal_force; },
     "R_n, N."},
    {"friction_force", [](const JointSolution& s) { return s.friction_force; },
     "R_t on the body, N, (..., 3)."},
    {"friction_moment",
     [](const JointSolution& s) { return s.friction_moment; },
     "M_t on the body about the joint's centre, N m, (..., 3)."},
    {"slip_velocity", [](const JointSolution& s) { return s.slip_velocity; },
     "Of the body's half against the carrier's at the contact's centre, m/s,\n"
     "(..., 3)."},
    {"power", [](const JointSolution& s) { return s.power; },
     "Of friction, W; never positive."},
    {"reaction_angle",
     [](const JointSolution& s) { return s.reaction_angle(); },
     "b between R and Dw, rad, [0, pi]."},
    {"friction_angle",
     [](const JointSolution& s) { return s.friction_angle(); },
     "g, tan g = R_t/R_n, rad."},
    {"slip_axis_angle",
     [](const JointSolution& s) { return s.slip_axis_angle(); },
     "a, rad: 0 sliding, +-pi/2 spinning."},
    {"force_coefficient",
     [](const JointSolution& s) { return s.force_coefficient; }, "R_t/R_n."},
    {"sliding_coefficient",
     [](const JointSolution& s) { return s.sliding_coefficient; },
     "Moment about the part of Dw normal to n, over -rho R_n."},
    {"spinning_coefficient",
     [](const JointSolution& s) { return s.spinning_coefficient; },
     "Moment about n, over -rho R_n."},
    {"adhesion_number",
     [](const JointSolution& s) { return s.adhesion_number; },
     "A rho^2/(f0 R_n)."},
    {"load_parameter", [](const JointSolution& s) { return s.load_parameter; },
     "mu of a ball, lambda of a pin."},
    {"half_angle", [](const JointSolution& s) { return s.half_angle; },
     "theta0 of the contact, rad."},
    {"peak_pressure", [](const JointSolution& s) { return s.peak_pressure; },
     "Pa."},
    {"contact_area", [](const JointSolution& s) { return s.contact_area; },
     "m^2."},
};

const Field<Rating> of_rating[] = {
    {"pv_max", [](const Rating& r) { return r.pv.value; },
     "Largest p v over the contact, W/m^2."},
    {"pv_max_theta", [](const Rating& r) { return r.pv.theta; },
     "Its angle from the contact's centre, rad."},
    {"pv_max_place", [](const Rating& r) { return r.pv.place; },
     "Its direction from the joint's centre, (..., 3)."},
    {"pv_mean", [](const Rating& r) { return r.pv_mean; },
     "Mean over the contact, W/m^2."},
    {"pv_nominal", [](const Rating& r) { return r.pv_nominal; },
     "R over the projected area, pi rho^2 or 2 rho l, times rho |Dw|, W/m^2."},
    {"pv_total", [](const Rating& r) { return r.pv_total; },
     "Integral of p v over the contact, W."},
    {"heat_flux_max", [](const Rating& r) { return r.heat_flux.value; },
     "Largest heat flux of friction, into both bodies, W/m^2."},
    {"heat_flux_max_theta", [](const Rating& r) { return r.heat_flux.theta; },
     "Its angle from the contact's centre, rad."},
    {"heat_flux_max_place", [](const Rating& r) { return r.heat_flux.place; },
     "Its direction from the joint's centre, (..., 3)."},
    {"heat", [](const Rating& r) { return r.heat; },
     "Of friction over the contact, W."},
    {"slip_coefficient", [](const Rating& r) { return r.slip_coefficient; },
     "L: pv_total is rho |Dw| R_n L."},
};

const Field<State> of_worn[] = {
    {"cycles", [](const State& w) { return w.cycles; }, "After them."},
    {"volume", [](const State& w) { return w.volume; },
     "Worn off the seat or hole, m^3; reliable."},
    {"wear_number", [](const State& w) { return w.wear_number; },
     "v: volume over pi rho^2 eps, of a pin 2 rho eps l."},
    {"penetration", [](const State& w) { return w.penetration; },
     "Deepest wear, m, to 8 %, once most of it is wear; no creep."},
    {"worn_share", [](const State& w) { return w.worn_share; },
     "Share of the law \"worn\" in the pressure; the rest is the joint's."},
    {"half_angle", [](const State& w) { return w.half_angle; },
     "Largest of a cycle then, rad, to 1.1 deg."},
    {"peak_pressure", [](const State& w) { return w.peak_pressure; },
     "Largest of a cycle then, Pa, to 6 %; of a ball much worn up to 17 % too "
     "high."},
    {"pv_max", [](const State& w) { return w.pv; },
     "Largest of a cycle then, W/m^2."},
    {"energy", [](const State& w) { return w.energy; }, "Of a cycle then, J."},
    {"mean_moment", [](const State& w) { return w.mean_moment; },
     "Of friction over a cycle then, N m."},
};

}  // namespace

Rating rating(const contact::SlidingContact& sliding) {
  const auto peaks = sliding.peaks();
  return {peaks.pv,
          peaks.heat_flux,
          sliding.pv_mean(),
          sliding.pv_nominal(),
          sliding.pv_total(),
          sliding.heat(),
          sliding.slip_coefficient()};
}

std::span<const Field<JointSolution>> solution_fields() { return of_solution; }

std::span<const Field<Rating>> rating_fields() { return of_rating; }

std::span<const Field<State>> worn_fields() { return of_worn; }

}  // namespace contact_python
