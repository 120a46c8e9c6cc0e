#include "libcontact/c/moments.h"
#include "libcontact/base/constants.hpp"

#include <cmath>
#include <string>

#include "libcontact/c/call.hpp"
#include "libcontact/c/joint.hpp"
#include "libcontact/c/slip.hpp"
#include "libcontact/joint/derivatives.hpp"

namespace contact::c {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d vector(const double* numbers, const std::string& name) {
  return Vector3d(&given(numbers, name.c_str()));
}

// Row by row.
void tell(double (&to)[9], const Matrix3d& from) {
  Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>{to} = from;
}

// Calls use(set) with the moment set of a ball's solution.
template <class Use>
contact_status with_set(const contact_joint* joint,
                        const contact_solution* solution,
                        const std::string& function, const Use& use) {
  const Joint& ball = given(joint, (function + ": joint").c_str()).joint;
  if (ball.is_pin()) {
    throw Error(detail::must_be(function + ": joint", "a ball joint"));
  }
  const JointSolution solved =
      whole(ball, given(solution, (function + ": solution").c_str()));
  return use(ball.moment_set(solved));
}

// OK if there are results; else the argument must be otherwise.
contact_status status_if(bool has_results, const char* argument,
                         const char* rule) {
  if (has_results) return CONTACT_OK;
  return contact_report(CONTACT_OUT_OF_RANGE,
                        detail::must_be(argument, rule).c_str());
}

}  // namespace

template <>
struct Refused<contact_prox> {
  static void write(contact_prox* prox, contact_status status) noexcept {
    using detail::nan;
    *prox = {status, 0, nan, {nan, nan, nan}, {nan, nan, nan}};
  }
};

}  // namespace contact::c

using contact::c::call_for;
using contact::c::given;
using contact::c::tell;
using contact::c::vector;
using contact::c::with_set;
using Eigen::Vector3d;

contact_status contact_joint_edge(const contact_joint* joint,
                                  const contact_solution* solution,
                                  const double angular_velocity[3],
                                  contact_edge* edge) {
  const char* const function = "contact_joint_edge";
  return call_for(
      [=] {
        return with_set(joint, solution, function, [&](const auto& set) {
          const Vector3d rate =
              vector(angular_velocity, "contact_joint_edge: angular_velocity");
          contact_edge& to = given(edge, "contact_joint_edge: edge");
          to.power = set.support(rate);
          Vector3d::Map(to.moment) = set.moment(rate);
          return contact::c::status_if(!std::isnan(to.power + to.moment[0]),
                                       "contact_joint_edge: angular_velocity",
                                       "finite and not 0, with friction that "
                                       "does not fall with the speed");
        });
      },
      edge);
}

contact_status contact_joint_held(const contact_joint* joint,
                                  const contact_solution* solution,
                                  const double moment[3], contact_held* held) {
  const char* const function = "contact_joint_held";
  return call_for(
      [=] {
        return with_set(joint, solution, function, [&](const auto& set) {
          const Vector3d m = vector(moment, "contact_joint_held: moment");
          contact_held& to = given(held, "contact_joint_held: held");
          to.utilisation = set.utilisation(m);
          Vector3d::Map(to.nearest) = set.project(m);
          return contact::c::status_if(
              !std::isnan(to.utilisation), "contact_joint_held: moment",
              "finite, with friction that does not fall with the speed");
        });
      },
      held);
}

contact_status contact_joint_prox(const contact_joint* joint,
                                  const contact_solution* solution,
                                  const double inertia[9], const double free[3],
                                  contact_prox* prox) {
  const char* const function = "contact_joint_prox";
  return call_for(
      [=] {
        return with_set(joint, solution, function, [&](const auto& set) {
          // Symmetric, so that the order of its numbers does not matter.
          const Eigen::Matrix3d w(
              &given(inertia, "contact_joint_prox: inertia"));
          const auto p = set.prox(w, vector(free, "contact_joint_prox: free"));
          contact_prox& to = given(prox, "contact_joint_prox: prox");
          to.status = contact::c::status_of(p.status);
          to.iterations = p.iterations;
          to.residual = p.residual;
          Vector3d::Map(to.angular_velocity) = p.angular_velocity;
          Vector3d::Map(to.moment) = p.moment;
          return contact::c::reported(to.status, function);
        });
      },
      prox);
}

contact_status contact_joint_derivatives(const contact_joint* joint,
                                         const contact_slip* slip,
                                         const contact_solution* solution,
                                         contact_derivatives* derivatives) {
  return call_for(
      [=] {
        const contact::Joint& j =
            given(joint, "contact_joint_derivatives: joint").joint;
        const contact_slip& s = given(slip, "contact_joint_derivatives: slip");
        const contact::JointSolution solved = contact::c::solution_of(
            given(solution, "contact_joint_derivatives: solution"));
        contact_derivatives& to =
            given(derivatives, "contact_joint_derivatives: derivatives");
        const contact::SlipDerivatives d = contact::derivatives(
            j,
            {Vector3d(s.reaction), Vector3d(s.angular_velocity),
             Vector3d(s.axis)},
            solved);
        tell(to.over_rate, d.over_rate);
        tell(to.over_reaction, d.over_reaction);
        tell(to.at_contact, d.at_contact);
        return contact::c::status_if(
            d.status == contact::Status::ok,
            "contact_joint_derivatives: solution",
            "OK and of a joint that slides under a reaction");
      },
      derivatives);
}
