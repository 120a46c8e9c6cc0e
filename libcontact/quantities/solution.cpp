#include "libcontact/quantities/tables.hpp"

namespace contact {
namespace {

using S = JointSolution;

// Directions and angles that rest and lack of load leave without meaning.
bool slides(const S& s) { return s.state == JointState::sliding; }
// The moment of interference without load has no ratio to R_n.
bool has_ratios(const S& s) { return !slides(s) || s.normal_force != 0; }

constexpr Quantity<S> of_solution[] = {
    {"status", "", Dimension::number, "how the solver ended",
     [](const S& s) { return s.status; }},
    {"state", "", Dimension::number, "sliding, resting or unloaded",
     [](const S& s) { return s.state; }},
    {"contact_state", "", Dimension::number,
     "closed or lifted (interference), zero or clearance",
     [](const S& s) { return s.contact_state; }},
    {"evaluations", "", Dimension::number, "contacts that the solver evaluated",
     [](const S& s) { return s.evaluations; }},
    {"residual", "", Dimension::number,
     "estimate of the remaining |f/tan g - 1|",
     [](const S& s) { return s.residual; }},
    {"reaction", "R", Dimension::force, "reaction on the body",
     [](const S& s) -> const Eigen::Vector3d& { return s.reaction; },
     "reaction"},
    {"reaction_angle", "b", Dimension::angle, "angle between R and Dw",
     [](const S& s) { return s.reaction_angle(); }, "", slides},
    {"friction_angle", "g", Dimension::angle, "friction angle, tan g = R_t/R_n",
     [](const S& s) { return s.friction_angle(); }},
    {"slip_axis_angle", "a", Dimension::angle,
     "slip axis angle: 0 sliding, a quarter turn spinning",
     [](const S& s) { return s.slip_axis_angle(); }, "", slides},
    {"normal_force", "R_n", Dimension::force, "normal force",
     [](const S& s) { return s.normal_force; }},
    {"normal", "n", Dimension::number,
     "direction of the normal force on the body",
     [](const S& s) -> const Eigen::Vector3d& { return s.normal; }},
    {"friction_force", "R_t", Dimension::force, "friction force on the body",
     [](const S& s) -> const Eigen::Vector3d& { return s.friction_force; },
     "friction force"},
    {"friction_moment", "M_t", Dimension::moment,
     "friction moment on the body about the joint's centre",
     [](const S& s) -> const Eigen::Vector3d& { return s.friction_moment; },
     "friction moment"},
    {"textbook_moment", "M_textbook", Dimension::moment,
     "friction moment of textbooks, f0 R rho: coefficient times load times "
     "radius",
     [](const S& s) { return s.textbook_moment; }, "",
     [](const S& s) { return !std::isnan(s.textbook_moment); }},
    {"slip_velocity", "v", Dimension::velocity,
     "slip of the body's half against the carrier's",
     [](const S& s) -> const Eigen::Vector3d& { return s.slip_velocity; },
     "slip velocity at the contact's centre"},
    {"power", "", Dimension::power, "power of friction, never positive",
     [](const S& s) { return s.power; }},
    {"force_coefficient", "f", Dimension::number,
     "effective coefficient R_t/R_n",
     [](const S& s) { return s.force_coefficient; }},
    {"reaction_coefficient", "f_R", Dimension::number,
     "effective coefficient R_t/R = sin g",
     [](const S& s) { return s.friction_direction.sin; }},
    {"moment_coefficient", "f_M", Dimension::number,
     "M_t/(rho R), the coefficient of friction of catalogues",
     [](const S& s) { return s.moment_coefficient(); }, "", has_ratios},
    {"sliding_coefficient", "f_sliding", Dimension::number,
     "sliding moment over rho R_n",
     [](const S& s) { return s.sliding_coefficient; }, "", has_ratios},
    {"spinning_coefficient", "f_spinning", Dimension::number,
     "spinning moment over rho R_n",
     [](const S& s) { return s.spinning_coefficient; }, "", has_ratios},
    {"adhesion_number", "Abar", Dimension::number,
     "adhesion number A rho^2/(f0 R_n)",
     [](const S& s) { return s.adhesion_number; }, "", has_ratios},
    {"load_parameter", "", Dimension::number, "mu of a ball, lambda of a pin",
     [](const S& s) { return s.load_parameter; }},
    {"half_angle", "theta0", Dimension::angle, "half-angle of the contact",
     [](const S& s) { return s.half_angle; }},
    {"peak_pressure", "p_peak", Dimension::stress, "peak pressure",
     [](const S& s) { return s.peak_pressure; }},
    {"contact_area", "", Dimension::area, "area of the contact",
     [](const S& s) { return s.contact_area; }},
    {"mean_heat_flux", "q_mean", Dimension::power_density,
     "heat of friction over the contact's area, into both bodies",
     [](const S& s) { return s.mean_heat_flux(); }},
};

using Rest = RestSolution;
constexpr Quantity<Rest> of_rest[] = {
    {"status", "", Dimension::number, "how the solver ended",
     [](const Rest& s) { return s.status; }},
    {"holds", "", Dimension::number, "whether the joint rests",
     [](const Rest& s) { return s.utilisation <= 1; }},
    {"utilisation", "", Dimension::number,
     "tau, M over the largest moment that friction holds: holds if <= 1",
     [](const Rest& s) { return s.utilisation; }},
    {"direction", "u", Dimension::number,
     "direction in which the joint would begin to slide",
     [](const Rest& s) -> const Eigen::Vector3d& { return s.direction; }},
    {"normal_force", "R_n", Dimension::force, "normal force of that sliding",
     [](const Rest& s) { return s.slip.normal_force; }},
    {"friction_moment", "M_t", Dimension::moment,
     "friction moment of that sliding, M/tau",
     [](const Rest& s) -> const Eigen::Vector3d& {
       return s.slip.friction_moment;
     }},
    {"half_angle", "theta0", Dimension::angle,
     "half-angle of that sliding's contact",
     [](const Rest& s) { return s.slip.half_angle; }},
};

constexpr Quantity<JointStep> of_step[] = {
    {"status", "", Dimension::number, "the worst of friction, rest and motion",
     [](const JointStep& s) { return s.status; }},
    {"holds", "", Dimension::number, "whether the joint rests at the end",
     [](const JointStep& s) { return s.holds; }},
    {"angular_velocity", "Dw", Dimension::angular_velocity,
     "body against carrier at the end of the step, exactly 0 where it holds",
     [](const JointStep& s) -> const Eigen::Vector3d& {
       return s.angular_velocity;
     }},
    {"moment", "M_t", Dimension::moment,
     "friction moment on the body during the step",
     [](const JointStep& s) -> const Eigen::Vector3d& { return s.moment; }},
};

using Prox = MomentSet::Prox;
constexpr Quantity<Prox> of_prox[] = {
    {"status", "", Dimension::number, "how the solver ended",
     [](const Prox& p) { return p.status; }},
    {"angular_velocity", "", Dimension::number,
     "with friction, of the kind of the free one; exactly 0 where it holds",
     [](const Prox& p) -> const Eigen::Vector3d& {
       return p.angular_velocity;
     }},
    {"moment", "M_t", Dimension::moment, "friction moment on the body",
     [](const Prox& p) -> const Eigen::Vector3d& { return p.moment; }},
    {"iterations", "", Dimension::number, "Newton steps",
     [](const Prox& p) { return p.iterations; }},
    {"residual", "", Dimension::number, "of the equation, over |W free|",
     [](const Prox& p) { return p.residual; }},
};

}  // namespace

std::span<const Quantity<JointStep>> step_quantities() { return of_step; }

std::span<const Quantity<Prox>> prox_quantities() { return of_prox; }

std::span<const Quantity<JointSolution>> solution_quantities() {
  return of_solution;
}

std::span<const Quantity<RestSolution>> rest_quantities() { return of_rest; }

}  // namespace contact
