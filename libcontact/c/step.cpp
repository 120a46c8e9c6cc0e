#include "libcontact/c/step.h"

#include <string>
#include <vector>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/c/call.hpp"
#include "libcontact/c/joint.hpp"
#include "libcontact/c/slip.hpp"
#include "libcontact/c/step.hpp"
#include "libcontact/joint/step.hpp"

namespace contact::c {

using Eigen::Vector3d;

void tell(contact_step& to, const JointStep& step, bool with_rest) {
  to.status = status_of(step.status);
  to.holds = step.holds;
  Vector3d::Map(to.angular_velocity) = step.angular_velocity;
  Vector3d::Map(to.moment) = step.moment;
  put(to.solution, step.solution);
  if (with_rest) put(to.rest, step.rest);
}

namespace {

StepStart start_of(const contact_step_start& s) {
  return {Vector3d(s.reaction), Vector3d(s.angular_velocity), Vector3d(s.free),
          Vector3d(s.axis)};
}

bool rests(const StepStart& start) { return start.angular_velocity.isZero(0); }

// Step to begin from, with or without the report on rest.
JointStep last_of(const contact_step* last, bool with_rest) {
  JointStep step;
  if (!last) return step;
  step.angular_velocity = Vector3d(last->angular_velocity);
  step.solution = solution_of(last->solution);
  if (with_rest) step.rest = rest_of(last->rest);
  return step;
}

contact_status step_all(const contact_joint* const* joints, std::size_t count,
                        const contact_step_start* starts, const double* inertia,
                        contact_step* steps, contact_sweeps* told) {
  std::vector<const Joint*> all;
  std::vector<StepStart> all_starts;
  std::vector<JointStep> all_steps;
  Eigen::Index size = 0;
  all.reserve(count);
  all_starts.reserve(count);
  all_steps.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!joints[i] || is_freed(joints[i])) {
      const std::string name =
          detail::message("contact_joints_step: joints[{}]", i);
      given(joints[i], name.c_str());
    }
    all.push_back(&joints[i]->joint);
    all_starts.push_back(start_of(starts[i]));
    all_steps.push_back(last_of(&steps[i], rests(all_starts.back())));
    const bool is_pin = all.back()->is_pin();
    if (is_pin && all_starts.back().axis.isZero(0)) {
      throw Error(detail::must_be(
          detail::message("contact_joints_step: starts[{}].axis", i),
          "the axis of the pin, other than 0"));
    }
    size += is_pin ? 1 : 3;
  }
  // Symmetric, so that the order of its numbers does not matter.
  const StepSweeps done =
      step(all, all_starts,
           Eigen::Map<const Eigen::MatrixXd>(inertia, size, size), all_steps);
  for (std::size_t i = 0; i < count; ++i) {
    // Otherwise the last rest that was told of stays.
    tell(steps[i], all_steps[i], rests(all_starts[i]));
  }
  if (told) *told = {status_of(done.status), done.sweeps, done.residual};
  return reported(status_of(done.status), "contact_joints_step");
}

}  // namespace

}  // namespace contact::c

using contact::c::call;
using contact::c::call_for;
using contact::c::given;

contact_status contact_joint_step(const contact_joint* joint,
                                  const contact_step_start* start,
                                  const double inertia[9],
                                  const contact_step* last,
                                  contact_step* step) {
  return call_for(
      [=] {
        const contact::Joint& j =
            given(joint, "contact_joint_step: joint").joint;
        const contact::StepStart s =
            contact::c::start_of(given(start, "contact_joint_step: start"));
        const Eigen::Matrix3d w(&given(inertia, "contact_joint_step: inertia"));
        contact_step& to = given(step, "contact_joint_step: step");
        if (!contact::is_inertia(j, s, w)) {
          throw contact::Error(contact::detail::must_be(
              "contact_joint_step: inertia", contact::inertia_rule));
        }
        contact::c::tell(
            to, contact::step(j, s, w, contact::c::last_of(last, true)), true);
        return contact::c::reported(to.status, "contact_joint_step");
      },
      step);
}

contact_status contact_joints_step(const contact_joint* const* joints,
                                   std::size_t count,
                                   const contact_step_start* starts,
                                   const double* inertia, contact_step* steps,
                                   contact_sweeps* sweeps) {
  return call([=] {
    if (count > 0) {
      given(joints, "contact_joints_step: joints");
      given(starts, "contact_joints_step: starts");
      given(inertia, "contact_joints_step: inertia");
      given(steps, "contact_joints_step: steps");
    }
    return contact::c::step_all(joints, count, starts, inertia, steps, sweeps);
  });
}
