#include "programs/joint/solution_row.hpp"

#include <cmath>
#include <iterator>
#include <limits>

#include "libcontact/base/units.hpp"

namespace hinge_joint {
namespace {

using contact::degree;
using contact::JointState;
using Eigen::Vector3d;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Directions and angles that rest and lack of load leave without meaning.
double if_sliding(const Answer& a, double value) {
  return a.solution.state == JointState::sliding ? value : nan;
}

// A force or an angle that was given is shown as it was given: what the
// solution says of it differs in the last digits, and rows would not be found
// by it.
double as_given(const Answer& a, Question given_in, double Input::Given::*what,
                double solved) {
  const bool given = a.given && a.question == given_in && !std::isnan(solved);
  return given ? (*a.given).*what : solved;
}

constexpr Quantity usual_quantities[] = {
    {"evaluations", "contacts that the solver evaluated",
     [](const Answer& a) { return double(a.solution.evaluations); }},
    {"residual", "estimate of |f/tan g - 1| that is left",
     [](const Answer& a) { return a.solution.residual; }},
    {"R_N", "reaction",
     [](const Answer& a) {
       return as_given(a, Question::reaction, &Input::Given::force,
                       a.solution.reaction.stableNorm());
     }},
    {"R_x_N", "reaction on the body",
     [](const Answer& a) { return a.solution.reaction.x(); }},
    {"R_y_N", "", [](const Answer& a) { return a.solution.reaction.y(); }},
    {"R_z_N", "", [](const Answer& a) { return a.solution.reaction.z(); }},
    {"w_x_rad_per_s", "angular velocity Dw, body against carrier",
     [](const Answer& a) { return a.rate.x(); }},
    {"w_y_rad_per_s", "", [](const Answer& a) { return a.rate.y(); }},
    {"w_z_rad_per_s", "", [](const Answer& a) { return a.rate.z(); }},
    {"b_deg", "angle between R and Dw",
     [](const Answer& a) {
       return as_given(a, Question::reaction, &Input::Given::angle_deg,
                       if_sliding(a, a.solution.reaction_angle() / degree));
     }},
    {"g_deg", "friction angle, tan g = R_t/R_n",
     [](const Answer& a) { return a.solution.friction_angle() / degree; }},
    {"a_deg", "slip axis angle: 0 sliding, 90 spinning",
     [](const Answer& a) {
       return as_given(a, Question::contact, &Input::Given::angle_deg,
                       if_sliding(a, a.solution.slip_axis_angle() / degree));
     }},
    {"R_n_N", "normal force",
     [](const Answer& a) {
       return as_given(a, Question::contact, &Input::Given::force,
                       a.solution.normal_force);
     }},
    {"n_x", "its direction on the body",
     [](const Answer& a) { return a.solution.normal.x(); }},
    {"n_y", "", [](const Answer& a) { return a.solution.normal.y(); }},
    {"n_z", "", [](const Answer& a) { return a.solution.normal.z(); }},
    {"R_t_N", "friction force",
     [](const Answer& a) { return a.solution.friction_force.stableNorm(); }},
    {"R_t_x_N", "friction force on the body",
     [](const Answer& a) { return a.solution.friction_force.x(); }},
    {"R_t_y_N", "",
     [](const Answer& a) { return a.solution.friction_force.y(); }},
    {"R_t_z_N", "",
     [](const Answer& a) { return a.solution.friction_force.z(); }},
    {"M_t_N_m", "friction moment",
     [](const Answer& a) { return a.solution.friction_moment.stableNorm(); }},
    {"M_t_x_N_m", "friction moment on the body about the joint's centre",
     [](const Answer& a) { return a.solution.friction_moment.x(); }},
    {"M_t_y_N_m", "",
     [](const Answer& a) { return a.solution.friction_moment.y(); }},
    {"M_t_z_N_m", "",
     [](const Answer& a) { return a.solution.friction_moment.z(); }},
    {"M_traditional_N_m", "friction moment if R were the normal force",
     [](const Answer& a) { return a.traditional; }},
    {"v_m_per_s", "slip velocity at the contact's centre",
     [](const Answer& a) { return a.solution.slip_velocity.stableNorm(); }},
    {"v_x_m_per_s", "of the body's half against the carrier's",
     [](const Answer& a) { return a.solution.slip_velocity.x(); }},
    {"v_y_m_per_s", "",
     [](const Answer& a) { return a.solution.slip_velocity.y(); }},
    {"v_z_m_per_s", "",
     [](const Answer& a) { return a.solution.slip_velocity.z(); }},
    {"power_W", "of friction, never positive",
     [](const Answer& a) { return a.solution.power; }},
    {"f", "effective coefficient R_t/R_n",
     [](const Answer& a) { return a.solution.force_coefficient; }},
    {"f_R", "effective coefficient R_t/R = sin g",
     [](const Answer& a) { return a.solution.friction_direction.sin; }},
    {"f_M", "M_t/(rho R), the coefficient of friction of catalogues",
     [](const Answer& a) { return a.moment_coefficient; }},
    {"f_sliding", "sliding moment over rho R_n",
     [](const Answer& a) { return a.solution.sliding_coefficient; }},
    {"f_spinning", "spinning moment over rho R_n",
     [](const Answer& a) { return a.solution.spinning_coefficient; }},
    {"Abar", "adhesion number A rho^2/(f0 R_n)",
     [](const Answer& a) { return a.solution.adhesion_number; }},
    {"load_parameter", "mu of a ball, lambda of a pin",
     [](const Answer& a) { return a.solution.load_parameter; }},
    {"theta0_deg", "half-angle of the contact",
     [](const Answer& a) { return a.solution.half_angle / degree; }},
    {"p_peak_Pa", "peak pressure",
     [](const Answer& a) { return a.solution.peak_pressure; }},
    {"p_mean_Pa", "mean pressure over the contact",
     [](const Answer& a) { return a.mean_pressure; }},
    {"p_nominal_Pa", "R over the projected area, pi rho^2 or 2 rho L",
     [](const Answer& a) { return a.nominal_pressure; }},
    {"contact_area_m2", "area of the contact",
     [](const Answer& a) { return a.solution.contact_area; }},
};

constexpr Quantity pv_quantities[] = {
    {"pv_max_W_per_m2", "largest p v over the contact",
     [](const Answer& a) { return a.pv.value; }},
    {"pv_max_theta_deg", "its angle from the centre of the contact",
     [](const Answer& a) { return if_sliding(a, a.pv.theta / degree); }},
    {"pv_max_x", "its direction from the joint's centre",
     [](const Answer& a) { return if_sliding(a, a.pv.place.x()); }},
    {"pv_max_y", "",
     [](const Answer& a) { return if_sliding(a, a.pv.place.y()); }},
    {"pv_max_z", "",
     [](const Answer& a) { return if_sliding(a, a.pv.place.z()); }},
    {"pv_mean_W_per_m2", "mean p v over the contact",
     [](const Answer& a) { return a.pv_mean; }},
    {"pv_nominal_W_per_m2", "p_nominal_Pa times rho |Dw|: p v as in catalogues",
     [](const Answer& a) { return a.pv_nominal; }},
    {"nominal_area_m2", "projected area of these two: pi rho^2 or 2 rho L",
     [](const Answer& a) { return a.nominal_area; }},
    {"q_max_W_per_m2", "largest heat flux of friction, into both bodies",
     [](const Answer& a) { return a.heat.value; }},
    {"q_max_theta_deg", "its angle from the centre of the contact",
     [](const Answer& a) { return if_sliding(a, a.heat.theta / degree); }},
    {"slip_coefficient", "L: all p v is rho |Dw| R_n L",
     [](const Answer& a) { return if_sliding(a, a.slip_coefficient); }},
};

constexpr Quantity approach_quantities[] = {
    {"approach_m", "of the two bodies, from first touch",
     [](const Answer& a) { return a.approach.approach; }},
    {"stiffness_N_per_m", "d R_n/d approach",
     [](const Answer& a) { return a.approach.stiffness; }},
};

constexpr Quantity rest_quantities[] = {
    {"utilisation", "tau, the share of M_t that M needs: holds if <= 1",
     [](const Answer& a) { return a.utilisation; }},
    {"u_x", "direction in which the joint would begin to slide",
     [](const Answer& a) { return a.direction.x(); }},
    {"u_y", "", [](const Answer& a) { return a.direction.y(); }},
    {"u_z", "", [](const Answer& a) { return a.direction.z(); }},
};

constexpr Quantity friction_quantities[] = {
    {"f0", "friction coefficient of the surface, with which M_t is as measured",
     [](const Answer& a) { return a.coefficient; }},
};

void add_pv(const contact::JointContact& contact, Answer& a) {
  const contact::SlidingContact sliding(contact, a.solution, a.rate);
  a.nominal_area = 1 / contact.geometry().nominal_pressure(1);
  const auto peaks = sliding.peaks();
  a.pv = peaks.pv;
  a.heat = peaks.heat_flux;
  a.pv_mean = sliding.pv_mean();
  a.pv_nominal = sliding.pv_nominal();
  a.slip_coefficient = sliding.slip_coefficient();
}

}  // namespace

Answer answer(const NamedJoint& named, Question question, const Input& input) {
  const contact::Joint& joint = named.joint;
  Answer a{.question = question,
           .given = input.given,
           .rate = input.turn,
           .solution = {},
           .traditional = nan,
           .moment_coefficient = nan,
           .mean_pressure = nan,
           .nominal_pressure = nan,
           .nominal_area = nan,
           .pv = {},
           .heat = {},
           .pv_mean = nan,
           .pv_nominal = nan,
           .slip_coefficient = nan,
           .coefficient = nan,
           .utilisation = nan,
           .direction = Vector3d::Constant(nan),
           .approach = {nan, nan}};
  switch (question) {
    case Question::reaction:
      a.solution = joint.solve(
          {.reaction = input.force, .angular_velocity = input.turn});
      break;
    case Question::contact:
      a.solution = joint.solve_contact(
          {.normal_force = input.force, .angular_velocity = input.turn});
      break;
    case Question::rest: {
      const auto rest =
          joint.at_rest({.reaction = input.force, .moment = input.turn});
      a.solution = rest.slip;
      a.solution.status = rest.status;
      a.utilisation = rest.utilisation;
      a.direction = a.rate = rest.direction;
      break;
    }
  }
  const contact::JointSolution& s = a.solution;
  if (named.approach) a.approach = (*named.approach)(s.half_angle);
  const double force = s.reaction.stableNorm();
  const double moment = s.friction_moment.stableNorm();
  const contact::JointSolution traditional = joint.solve_contact(
      {.normal_force = s.reaction, .angular_velocity = a.rate});
  a.traditional = traditional.friction_moment.stableNorm();
  a.mean_pressure = s.normal_force == 0 ? 0
                                        : joint.contact().mean_pressure(
                                              s.normal_force, s.half_angle);
  a.nominal_pressure = joint.contact().geometry().nominal_pressure(force);
  const double rho = joint.contact().geometry().radius();
  if (const auto* dry =
          std::get_if<contact::FrictionLaw>(&joint.contact().friction())) {
    a.coefficient = dry->coefficient();
  }
  if (named.pv) add_pv(joint.contact(), a);
  a.moment_coefficient = force > 0 ? moment / (rho * force) : 0;
  return a;
}

std::string_view state_text(const Answer& a) {
  if (!std::isnan(a.utilisation)) {
    return a.utilisation <= 1 ? "holds" : "slips";
  }
  switch (a.solution.state) {
    case JointState::sliding:
      return "sliding";
    case JointState::resting:
      return "resting";
    case JointState::unloaded:
      break;
  }
  return "unloaded";
}

std::string_view status_text(contact::Status status) {
  switch (status) {
    case contact::Status::ok:
      return "ok";
    case contact::Status::out_of_range:
      return "out_of_range";
    case contact::Status::not_converged:
      break;
  }
  return "not_converged";
}

std::vector<Quantity> quantities(bool rest, bool approach, bool friction,
                                 bool pv) {
  std::vector<Quantity> all(std::begin(usual_quantities),
                            std::end(usual_quantities));
  const auto add = [&all](const auto& more) {
    all.insert(all.end(), std::begin(more), std::end(more));
  };
  if (approach) add(approach_quantities);
  if (rest) add(rest_quantities);
  if (friction) add(friction_quantities);
  if (pv) add(pv_quantities);
  return all;
}

}  // namespace hinge_joint
