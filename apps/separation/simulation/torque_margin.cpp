#include "separation/simulation/torque_margin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <memory>
#include <vector>

#include "libcontact/base/error.hpp"
#include "libcontact/base/units.hpp"
#include "multibody/friction/hinge_solver.hpp"
#include "multibody/motion/motion.hpp"
#include "multibody/system/eigen_conversion.hpp"
#include "multibody/system/state_layout.hpp"
#include "separation/case/force_law.hpp"
#include "separation/case/hinge_reader.hpp"
#include "separation/case/system_of.hpp"
#include "separation/simulation/case_forces.hpp"

namespace separation {
namespace {

using Eigen::Vector3d;
using multibody::BodyForce;
using multibody::BodyMotion;

ForceInstant at_start(const Case& c, const Force& force,
                      std::span<const BodyMotion> bodies) {
  return {c, force.body, bodies, 0, 0, History::not_yet};
}

// Forces at 0 s, without forces that act through hinges, which the held hinges
// carry.
class Others : public multibody::ForceModel {
 public:
  explicit Others(const Case& c) : case_(c) {}
  void add_forces(double, std::span<const BodyMotion> bodies,
                  std::span<BodyForce> forces) const override {
    for (const Force& force : case_.forces) {
      const bool on = force.begin.event < 0 && !(force.begin.time > 0);
      if (!on || force.law->ends_with_hinge()) continue;
      force.law->add(at_start(case_, force, bodies), forces);
    }
  }

 private:
  const Case& case_;
};

class Sweep {
 public:
  Sweep(const Case& c, int body, FrictionChoice friction)
      : case_(c),
        body_(body),
        hinge_(c.bodies[body].hinge),
        system_(system_of(c)),
        others_(std::make_shared<Others>(c)),
        solver_(make_friction(hinge_, friction), system_.links()[body], body),
        memory_(solver_.make_memory()),
        motion_(all_held()),
        state_(motion_.save()),
        sense_(hinge_.margin->to > hinge_.margin->from ? 1 : -1) {
    for (const Force& force : c.forces) {
      if (force.body == body + 1 && force.law->ends_with_hinge()) {
        own_.push_back(&force);
      }
    }
  }

  TorqueMargin at(double angle) {
    const multibody::MotionSample& sample = still(angle);
    const multibody::HingeSample held = sample.hinge(body_);
    const Vector3d axis = hinge_.zero_rotation.transpose() * hinge_.axis;
    const MarginPath& path = *hinge_.margin;
    TorqueMargin found;
    found.angle = angle;
    const auto count = [&](double moment, double drives) {
      if (moment > 0) {
        found.driving += drives * moment;
      } else {
        found.other -= path.other_factor * moment;
      }
    };
    count(-sense_ * held.reaction_moment.dot(axis), 1);
    for (const Force* force : own_) {
      std::vector<BodyForce> forces(sample.motions().size());
      force->law->add(at_start(case_, *force, sample.motions()), forces);
      count(sense_ * forces[1 + body_].moment.dot(sample.body(body_).rotation *
                                                  axis),
            force->law->stores() ? path.spring_factor : 1);
    }
    found.friction = path.friction_factor * friction(angle, held);
    found.ratio = found.driving / (found.friction + found.other);
    found.lacks_load = solver_.has_friction() && found.friction == 0;
    return found;
  }

  // Nodes that no kink is between.
  std::vector<double> nodes() {
    const auto [from, to] = std::minmax(hinge_.margin->from, hinge_.margin->to);
    constexpr int parts = 48;
    std::vector<double> nodes;
    for (int i = 0; i <= parts; ++i) {
      nodes.push_back(i == parts ? to : from + i * (to - from) / parts);
    }
    const multibody::MotionSample& sample = still(from);
    for (const Force& force : case_.forces) {
      if (force.body != body_ + 1) continue;
      std::vector<multibody::KinkedVariable> kinks;
      force.law->add_kinks(at_start(case_, force, sample.motions()), kinks);
      for (const auto& variable : kinks) {
        for (const double kink : variable.kinks) {
          if (kink > from && kink < to) nodes.push_back(kink);
        }
      }
    }
    std::ranges::sort(nodes);
    return nodes;
  }

 private:
  const multibody::MotionSample& still(double angle) {
    state_.numbers[at_angle_] = angle;
    motion_.restore(state_);
    return motion_.sample();
  }

  // All held; notes where a state has the angle of the hinge.
  multibody::Motion all_held() {
    std::vector<multibody::JointMode> modes;
    multibody::MotionStart start;
    start.carrier = case_.carrier_start;
    start.carrier.velocity.setZero();
    start.carrier.angular_velocity.setZero();
    for (const Body& body : case_.bodies) {
      start.bodies.push_back(body.start);
      multibody::BodyStart& of = start.bodies.back();
      of.locked = body.hinge.kind != multibody::HingeKind::none;
      modes.push_back(of.locked ? multibody::JointMode::held
                                : multibody::JointMode::released);
      of.angle_rate = 0;
      of.relative_angular_velocity.setZero();
      of.body.velocity.setZero();
      of.body.angular_velocity.setZero();
    }
    at_angle_ = multibody::StateLayout(system_, modes).offset(body_);
    return {system_, {}, others_, start, case_.options};
  }

  double friction(double angle, const multibody::HingeSample& held) {
    if (!solver_.has_friction()) return 0;
    const Eigen::Matrix3d axes = system_.links()[body_].axes.transpose();
    // Slower than any viscous friction shows.
    constexpr double slow = 1e-9;  // rad/s
    const double moment =
        solver_
            .slide({multibody::vec3(Vector3d(axes * held.reaction_force)),
                    multibody::vec3(Vector3d(axes * held.reaction_moment))},
                   {0, 0, sense_ * slow}, memory_)
            .z();
    if (std::isnan(moment)) {
      throw contact::Error(fmt::format(
          "torque_margin of \"{}\": the joints have no friction moment at "
          "{:.6g} deg",
          case_.bodies[body_].rigid.name, angle / contact::degree));
    }
    return std::abs(moment);
  }

  const Case& case_;
  int body_;
  const Hinge& hinge_;
  multibody::System system_;
  std::shared_ptr<const Others> others_;
  multibody::HingeSolver solver_;
  multibody::HingeSolver::Memory memory_;
  int at_angle_ = 0;
  multibody::Motion motion_;
  multibody::MotionState state_;
  double sense_;
  std::vector<const Force*> own_;
};

}  // namespace

TorqueMargin torque_margin(const Case& c, int body, FrictionChoice friction) {
  Sweep sweep(c, body, friction);
  const std::vector<double> nodes = sweep.nodes();
  std::vector<double> ratios;
  TorqueMargin least;
  const auto note = [&](const TorqueMargin& found) {
    if (found.ratio < least.ratio) least = found;
    return found.ratio;
  };
  for (const double angle : nodes) ratios.push_back(note(sweep.at(angle)));
  // Between the neighbours of each node that is lower than both.
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const double before = i > 0 ? ratios[i - 1] : ratios[i];
    const double after = i + 2 < nodes.size() ? ratios[i + 2] : ratios[i + 1];
    if (ratios[i] > before || ratios[i + 1] > after) continue;
    constexpr int bits = 26;  // bits of the angle: ratios differ by 1e-15
    boost::math::tools::brent_find_minima(
        [&](double at) { return note(sweep.at(at)); }, nodes[i], nodes[i + 1],
        bits);
  }
  return least;
}

std::vector<std::string> margin_notes(const MarginPath& path,
                                      const TorqueMargin& margin) {
  std::vector<std::string> notes;
  if (std::isinf(margin.ratio)) {
    notes.emplace_back("is infinite: nothing resists");
  } else if (margin.ratio < path.required) {
    notes.push_back(fmt::format("is {:.4g} at {:.4g} deg: {} requires {}",
                                margin.ratio, margin.angle / contact::degree,
                                path.standard, path.required));
  }
  if (margin.lacks_load) {
    notes.emplace_back(
        "contains no friction of joints, which carry no load at rest: add the "
        "friction in operation as a resisting moment");
  }
  return notes;
}

TorqueMargin TorqueMargins::of(const Case& c, int body,
                               FrictionChoice friction) {
  const std::lock_guard lock(mutex_);
  const auto found = known_.find(body);
  if (found != known_.end()) return found->second;
  return known_[body] = torque_margin(c, body, friction);
}

}  // namespace separation
