#include "libcontact/duty/pressed_wear_in.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/duty/pin_wear.hpp"
#include "libcontact/half_angle/exact.hpp"

namespace contact::detail {
namespace {

void check(Status status) {
  if (status == Status::ok) return;
  throw Error("the contact of a worn pin did not converge");
}

constexpr double pi = std::numbers::pi;

// What slides under a load in a cycle.
struct Level {
  double normal_force;  // N
  double distance;      // rho integral of |Dw| dt, m
};

// Those of the Gauss points by their load, put together to levels of one
// distance: the wear of each is found by itself.
std::vector<Level> levels_of(const JointCycle& cycle) {
  constexpr double count = 8;
  const double radius = cycle.contact().geometry().radius();
  std::vector<Level> all;
  double total = 0;
  for (const JointCycle::Instant& i : cycle.gauss_points()) {
    const double distance = i.weight * radius * i.state.angular_velocity.norm();
    if (!(distance > 0)) continue;
    all.push_back({i.solution.normal_force, distance});
    total += distance;
  }
  std::ranges::sort(all, {}, &Level::normal_force);
  std::vector<Level> levels;
  double done = 0;
  for (const Level& l : all) {
    constexpr double rounding = 1e-9;
    const bool begins_next =
        static_cast<double>(levels.size()) <= done / total * count;
    done += l.distance;
    if (levels.empty() ||
        (begins_next &&
         l.normal_force > (1 + rounding) * levels.back().normal_force)) {
      levels.push_back({0, 0});
    }
    Level& last = levels.back();
    last.normal_force =
        (last.normal_force * last.distance + l.normal_force * l.distance) /
        (last.distance + l.distance);
    last.distance += l.distance;
  }
  return levels;
}

LayeredPair bodies_of(const JointContact& contact) {
  const auto* law = dynamic_cast<const ExactLaw*>(&contact.half_angle_law());
  if (law != nullptr && law->walls()) return *law->walls();
  return {contact.geometry().radius(), contact.pair().inner(),
          contact.pair().outer()};
}

// Loads on a worn contact, between levels that are solved.
class WornLoads {
 public:
  WornLoads(const JointContact& contact, const PinWear& wear,
            const JointCycle& cycle)
      : contact_(contact), wear_(wear) {
    const auto [least, most] = std::ranges::minmax(
        cycle.rows(), {},
        [](const JointCycle::Instant& i) { return i.solution.normal_force; });
    const double low = least.solution.normal_force;
    const double high = most.solution.normal_force;
    constexpr int count = 9;
    const bool one = high - low <= 1e-9 * high;
    for (int i = 0; i < (one ? 1 : count); ++i) {
      const double share = one ? 1 : i / (count - 1.0);
      solved_.push_back(solve(low + share * (high - low)));
    }
  }

  struct Load {
    double normal_force;
    double half_angle;
    double peak_pressure;
    double sum_of_pressures;
  };
  Load at(double normal_force) const {
    const auto next = std::ranges::lower_bound(solved_, normal_force, {},
                                               &Load::normal_force);
    if (next == solved_.begin()) return solved_.front();
    if (next == solved_.end()) return solved_.back();
    const Load& a = *std::prev(next);
    const Load& b = *next;
    const double share =
        (normal_force - a.normal_force) / (b.normal_force - a.normal_force);
    const auto between = [share](double x, double y) {
      return x + share * (y - x);
    };
    return {normal_force, between(a.half_angle, b.half_angle),
            between(a.peak_pressure, b.peak_pressure),
            between(a.sum_of_pressures, b.sum_of_pressures)};
  }
  double moment(const Load& load, double speed) const {
    const JointContact::Strength s = contact_.strength(speed);
    const JointGeometry& g = contact_.geometry();
    return g.radius() * s.pressure_part * load.sum_of_pressures +
           s.area_part * 2 * load.half_angle * g.length();
  }

 private:
  Load solve(double normal_force) const {
    const JointGeometry& g = contact_.geometry();
    const WornCircle::Contact c =
        wear_.contact(g.load_from_force(normal_force));
    check(c.status);
    return {normal_force, c.half_angle, c.pressure.maxCoeff(),
            2 * pi * g.radius() * g.length() * wear_.circle().mean(c.pressure)};
  }

  const JointContact& contact_;
  const PinWear& wear_;
  std::vector<Load> solved_;
};

void add_cycle(const WornLoads& loads, const JointCycle& cycle,
               WearIn::State& state) {
  const double radius = cycle.contact().geometry().radius();
  for (const JointCycle::Instant& i : cycle.rows()) {
    const WornLoads::Load load = loads.at(i.solution.normal_force);
    const double speed = i.state.angular_velocity.norm();
    state.half_angle = std::max(state.half_angle, load.half_angle);
    state.peak_pressure = std::max(state.peak_pressure, load.peak_pressure);
    state.pv = std::max(state.pv, load.peak_pressure * radius * speed);
  }
  for (const JointCycle::Instant& i : cycle.gauss_points()) {
    const double speed = i.state.angular_velocity.norm();
    if (speed == 0) continue;
    const double moment =
        loads.moment(loads.at(i.solution.normal_force), speed);
    state.energy += i.weight * moment * speed;
    state.mean_moment += i.weight * moment / cycle.cycle().period();
  }
}

}  // namespace

std::vector<WearIn::State> pressed_wear_in(const JointCycle& fresh,
                                           const WearCoefficients& k,
                                           double cycles) {
  const JointContact& contact = fresh.contact();
  const JointGeometry& geometry = contact.geometry();
  if (geometry.kind() == JointKind::ball) {
    throw Error(needs("wear without clearance or with interference",
                      "a pin: a ball slides faster at its equator, so that "
                      "it loses its shape"));
  }
  const std::vector<Level> levels = levels_of(fresh);
  double distance = 0;
  for (const Level& level : levels) distance += level.distance;
  const double path = (k.seat + k.inner) * distance;  // of a cycle
  PinWear wear(bodies_of(contact), geometry.radial_clearance());
  std::vector<WearIn::State> states;
  WearIn::State next;
  for (;;) {
    WearIn::State& now = states.emplace_back(next);
    now.volume = wear.worn_area() * geometry.length();
    now.wear_number = now.worn_share = std::numeric_limits<double>::quiet_NaN();
    now.penetration = wear.depth();
    now.clearance = wear.clearance();
    add_cycle(WornLoads(contact, wear, fresh), fresh, now);
    if (now.cycles >= cycles) return states;
    const double block = path > 0
                             ? std::min(cycles - now.cycles,
                                        std::max(wear.next_step() / path, 1.0))
                             : cycles - now.cycles;
    for (const Level& level : levels) {
      const double slid = block * level.distance;
      check(wear.slide(geometry.load_from_force(level.normal_force),
                       {.hole = k.seat * slid, .pin = k.inner * slid}));
    }
    next = {};
    next.cycles = now.cycles + block;
  }
}

}  // namespace contact::detail
