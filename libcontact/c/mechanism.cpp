#include "libcontact/c/mechanism.h"

#include <string>
#include <vector>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/c/call.hpp"
#include "libcontact/c/joint.hpp"
#include "libcontact/c/step.hpp"
#include "libcontact/joint/steps/mechanism_step.hpp"

struct contact_mechanism  // NOLINT(readability-identifier-naming)
    : contact::c::Handle {
  contact_mechanism(const std::vector<contact::MechanismJoint>& joints,
                    int rates)
      : size(rates), step(joints, rates) {}
  std::size_t count() const { return step.steps().size(); }
  const int size;
  contact::MechanismStep step;
};

namespace contact::c {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Numbers of the rates.
Eigen::Map<const Eigen::VectorXd> rates_of(const contact_mechanism& m,
                                           const double* numbers,
                                           const char* name) {
  return {m.size > 0 ? &given(numbers, name) : nullptr, m.size};
}

MechanismStart start_of(const contact_mechanism_start& s) {
  MechanismStart start{Vector3d(s.reaction), Vector3d(s.axis)};
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> turn(
      s.from_seat);
  if (!turn.isZero(0)) start.from_seat = turn;
  return start;
}

}  // namespace
}  // namespace contact::c

using contact::c::call;
using contact::c::call_for;
using contact::c::given;
using contact::c::rates_of;

contact_status contact_mechanism_make(const contact_mechanism_joint* joints,
                                      std::size_t count, std::size_t size,
                                      contact_mechanism** mechanism) {
  return call([=] {
    auto* const to =
        contact::c::emptied(mechanism, "contact_mechanism_make: mechanism");
    std::vector<contact::MechanismJoint> all;
    for (std::size_t i = 0; i < count; ++i) {
      given(joints, "contact_mechanism_make: joints");
      const std::string name = contact::detail::message(
          "contact_mechanism_make: joints[{}].joint", i);
      all.push_back({&given(joints[i].joint, name.c_str()).joint,
                     static_cast<int>(joints[i].first)});
    }
    return contact::c::hand_over(to, all, static_cast<int>(size));
  });
}

void contact_mechanism_free(contact_mechanism* mechanism) {
  contact::c::give_back(mechanism);
}

contact_status contact_mechanism_weigh(contact_mechanism* mechanism,
                                       const double* inertia,
                                       const double* rows,
                                       const double* stiffness,
                                       std::size_t count, double time_step) {
  return call([=] {
    auto& m = given(mechanism, "contact_mechanism_weigh: mechanism");
    if (m.size > 0) given(inertia, "contact_mechanism_weigh: inertia");
    if (count > 0) {
      given(rows, "contact_mechanism_weigh: rows");
      given(stiffness, "contact_mechanism_weigh: stiffness");
    }
    const auto n = static_cast<Eigen::Index>(count);
    const Eigen::Map<const contact::c::Matrix> jacobian(rows, n, m.size);
    // H is symmetric, so that the order of its numbers does not matter.
    m.step.weigh(Eigen::Map<const Eigen::MatrixXd>(inertia, m.size, m.size),
                 jacobian, Eigen::Map<const Eigen::VectorXd>(stiffness, n),
                 time_step);
    return CONTACT_OK;
  });
}

contact_status contact_mechanism_begin(contact_mechanism* mechanism,
                                       const contact_mechanism_start* starts,
                                       const double* rates,
                                       const double* likely) {
  return call([=] {
    auto& m = given(mechanism, "contact_mechanism_begin: mechanism");
    std::vector<contact::MechanismStart> all;
    for (std::size_t i = 0; i < m.count(); ++i) {
      given(starts, "contact_mechanism_begin: starts");
      all.push_back(contact::c::start_of(starts[i]));
    }
    m.step.begin(all, rates_of(m, rates, "contact_mechanism_begin: rates"),
                 rates_of(m, likely, "contact_mechanism_begin: likely"));
    return CONTACT_OK;
  });
}

contact_status contact_mechanism_turn(contact_mechanism* mechanism,
                                      const double* rates_at_end, double* force,
                                      double* change) {
  return call([=] {
    auto& m = given(mechanism, "contact_mechanism_turn: mechanism");
    rates_of(m, force, "contact_mechanism_turn: force");
    const double changed = m.step.turn(
        rates_of(m, rates_at_end, "contact_mechanism_turn: rates_at_end"),
        Eigen::Map<Eigen::VectorXd>(force, m.size));
    if (change) *change = changed;
    return contact::c::reported(contact::c::status_of(m.step.sweeps().status),
                                "contact_mechanism_turn");
  });
}

contact_status contact_mechanism_hold(const contact_mechanism* mechanism,
                                      const double* rates,
                                      const double* rates_at_end,
                                      double* force) {
  return call([=] {
    auto& m = given(mechanism, "contact_mechanism_hold: mechanism");
    rates_of(m, force, "contact_mechanism_hold: force");
    Eigen::Map<Eigen::VectorXd>(force, m.size) = m.step.holding_force(
        rates_of(m, rates, "contact_mechanism_hold: rates"),
        rates_of(m, rates_at_end, "contact_mechanism_hold: rates_at_end"));
    return CONTACT_OK;
  });
}

contact_status contact_mechanism_get(const contact_mechanism* mechanism,
                                     std::size_t i, contact_step* step,
                                     contact_sweeps* sweeps) {
  return call_for(
      [=] {
        auto& m = given(mechanism, "contact_mechanism_get: mechanism");
        if (i >= m.count()) {
          throw contact::Error(contact::detail::must_be(
              "contact_mechanism_get: i",
              contact::detail::message("below {}", m.count())));
        }
        contact::c::tell(given(step, "contact_mechanism_get: step"),
                         m.step.steps()[i], true);
        const contact::StepSweeps& all = m.step.sweeps();
        if (sweeps) {
          *sweeps = {contact::c::status_of(all.status), all.sweeps,
                     all.residual};
        }
        return CONTACT_OK;
      },
      step);
}
