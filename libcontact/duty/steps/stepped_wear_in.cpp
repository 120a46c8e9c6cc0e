#include "libcontact/duty/steps/stepped_wear_in.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/duty/steps/stepped_joint.hpp"
#include "libcontact/duty/steps/worn_circle.hpp"
#include "libcontact/duty/steps/worn_sphere.hpp"
#include "libcontact/duty/wear_check.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "libcontact/half_angle/worn.hpp"

namespace contact::detail {
namespace {

void check(Status status) {
  if (status == Status::ok) return;
  throw Error(status == Status::out_of_range
                  ? "the contact of a worn ball reaches further than 90 deg "
                    "beyond its load, where the grid of its wear ends"
                  : "the contact of a worn joint did not converge");
}

class Steps {
 public:
  Steps(const JointCycle& cycle, const WearCoefficients& k,
        const WornSeat& before)
      : cycle_(cycle), k_(k), path_(cycle) {
    const JointContact& contact = cycle.contact();
    joint_ = contact.geometry().kind() == JointKind::pin
                 ? stepped_pin(contact, before)
                 : stepped_ball(contact, path_, before);
  }

  /// How many cycles may be taken at once; infinite without wear.
  double next_block() const {
    return joint_->next_step(!path_.keeps_direction()) /
           ((k_.seat + k_.inner) * path_.distance());
  }
  /// Mean growth over all of the surface of the depth in some cycles, about, m.
  double mean_growth(double cycles) const {
    double load = 0;
    for (const SeatPath::Place& place : path_.places(joint_->places(), 0)) {
      load = std::max(load, place.load.norm());
    }
    return cycles * (k_.seat + k_.inner) * path_.distance() * load *
           joint_->mean_pressure_of_force();
  }

  void wear(double cycles) {
    // There and back in turns, so that no place is always the last.
    std::vector<SeatPath::Place> places =
        path_.places(joint_->places(), round_);
    if (round_++ % 2 == 1) std::ranges::reverse(places);
    const double slid =
        cycles * path_.distance() / static_cast<double>(places.size());
    for (const SeatPath::Place& place : places) {
      check(joint_->wear(place, k_.seat * slid, k_.inner * slid,
                         places.size() > 1));
    }
  }

  WearIn::State state() const {
    WearIn::State now;
    const JointGeometry& geometry = cycle_.contact().geometry();
    now.volume = joint_->volume();
    now.wear_number = geometry.radial_clearance() > 0
                          ? now.volume / WornHalfAngle::unit_volume(geometry)
                          : std::numeric_limits<double>::quiet_NaN();
    now.worn_share = std::numeric_limits<double>::quiet_NaN();
    now.penetration = joint_->depth();
    now.clearance = joint_->clearance();
    add_cycle(now);
    return now;
  }
  WornSeat worn() const { return joint_->worn(); }

 private:
  using Look = SteppedJoint::Look;

  void add_cycle(WearIn::State& state) const {
    const double first = cycle_.cycle().times().front();
    const int count = joint_->looks();
    const double rho = cycle_.contact().geometry().radius();
    std::vector<Look> seen;
    for (int i = 0; i < count; ++i) {
      const JointCycle::Instant at =
          cycle_.at(first + i * cycle_.cycle().period() / count);
      const Look& look =
          seen.emplace_back(joint_->look(SeatPath::place(cycle_, at)));
      check(look.status);
      const double speed = rho * at.state.angular_velocity.norm();
      state.half_angle = std::max(state.half_angle, look.half_angle);
      state.peak_pressure = std::max(state.peak_pressure, look.peak_pressure);
      state.pv = std::max(state.pv, look.peak_slip_pressure * speed);
    }
    add_friction(seen, state);
  }

  // With the load of every instant, and between looks what is beyond it.
  void add_friction(const std::vector<Look>& seen, WearIn::State& state) const {
    const double first = cycle_.cycle().times().front();
    const double period = cycle_.cycle().period();
    const double rho = cycle_.contact().geometry().radius();
    for (const JointCycle::Instant& i : cycle_.gauss_points()) {
      const double speed = i.state.angular_velocity.norm();
      if (speed == 0) continue;
      const double at =
          (i.time - first) / period * static_cast<double>(seen.size());
      const auto before = static_cast<std::size_t>(at);
      const double share = at - std::floor(at);
      const auto between = [&](double Look::*of) {
        const double a = seen[before % seen.size()].*of;
        return a + share * (seen[(before + 1) % seen.size()].*of - a);
      };
      const JointContact::Strength s = cycle_.contact().strength(speed);
      const double sum = i.solution.normal_force + between(&Look::beyond);
      // Along Dw.
      const double moment = rho * s.pressure_part * sum +
                            area_moment(s.area_part, between(&Look::area));
      state.energy += i.weight * moment * speed;
      state.mean_moment += i.weight * moment * between(&Look::tilt) / period;
    }
  }
  // A rho^2 times 2 theta0 l, or times rho and the integral over the ball.
  double area_moment(double strength, double area) const {
    const JointGeometry& geometry = cycle_.contact().geometry();
    return strength * area *
           (geometry.kind() == JointKind::ball ? geometry.radius() : 1);
  }

  const JointCycle& cycle_;
  WearCoefficients k_;
  SeatPath path_;
  std::unique_ptr<SteppedJoint> joint_;
  int round_ = 0;
};

}  // namespace

LayeredPair bodies_of(const JointContact& contact) {
  const auto* law = dynamic_cast<const ExactLaw*>(&contact.half_angle_law());
  if (law != nullptr && law->walls()) return *law->walls();
  return {contact.geometry().radius(), contact.pair().inner(),
          contact.pair().outer()};
}

WearIn stepped_wear_in(const JointCycle& fresh, const WearCoefficients& k,
                       double cycles, const WornSeat& before,
                       const std::function<void(double)>& progress) {
  const JointGeometry& geometry = fresh.contact().geometry();
  if (geometry.kind() == JointKind::ball && geometry.radial_clearance() <= 0) {
    throw Error(needs("wear without clearance or with interference",
                      "a pin: a ball slides faster at its equator, so that "
                      "it loses its shape"));
  }
  const std::size_t points = worn_points(geometry.kind(), before);
  if (!before.depths.empty() && before.depths.size() != points) {
    throw Error(
        must_be(message("a worn seat with {} depths", before.depths.size()),
                message("one with {}", points)));
  }
  Steps steps(fresh, k, before);
  WearIn result;
  double done = 0;
  for (;;) {
    WearIn::State& now = result.states.emplace_back(steps.state());
    now.cycles = done;
    progress(done);
    check_depth(now.penetration, before.cycles + done, geometry);
    if (done >= cycles) break;
    // At least a cycle: what wears so fast is no bearing.
    const double block =
        std::min(cycles - done, std::max(steps.next_block(), 1.0));
    check_depth(steps.mean_growth(block), before.cycles + done + block,
                geometry);
    steps.wear(block);
    done += block;
  }
  result.worn = steps.worn();
  result.worn.cycles = before.cycles + cycles;
  return result;
}

}  // namespace contact::detail

std::size_t contact::worn_points(JointKind kind, const WornSeat& seat) {
  return kind == JointKind::pin ? detail::WornCircle::default_points
                                : detail::WornSphere::points(seat.reach);
}
