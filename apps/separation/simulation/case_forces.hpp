// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "multibody/system/force_model.hpp"
#include "separation/case/case.hpp"
#include "separation/simulation/compliant_stops.hpp"
#include "separation/simulation/inputs.hpp"
#include "separation/simulation/mass_flow.hpp"

namespace separation {

struct ForceInstant;

/// Past of a simulation that affects forces.
struct History {
  static constexpr double not_yet = std::numeric_limits<double>::infinity();
  /// Time of event e for body i: events[e][i]; not_yet.
  std::vector<std::vector<double>> events;
  /// One flag per force: its stroke is used up, and it no longer acts.
  std::vector<char> spent;
  /// Rate of the last touch of each compliant stop, rad/s: touches[body][stop].
  std::vector<std::vector<double>> touches;
  /// Loads from outside, inputs_of(); empty: all are 0.
  std::vector<double> inputs;

  History() = default;
  explicit History(const Case& c)
      : events(c.events.size(), std::vector<double>(c.bodies.size(), not_yet)),
        spent(c.forces.size(), false) {
    for (const Body& body : c.bodies) {
      touches.emplace_back(body.hinge.stops.size());
    }
  }

  /// Time of a clock for a body: for an event of other bodies its first time.
  /// not_yet if unknown.
  double time_of(const Clock& clock, int body, const Case& c) const;
  /// When a clock strikes for a pair: WatchedPair::begin.
  double time_of(const Clock& clock, const WatchedPair& pair,
                 const Case& c) const {
    return std::max(time_of(clock, pair.a, c), time_of(clock, pair.b, c));
  }
  bool is_on(const WatchedPair& pair, double time, const Case& c) const {
    return time >= time_of(pair.begin, pair, c) &&
           time <= time_of(pair.end, pair, c);
  }
  /// When the hinge of a body (1 +) broke; not_yet.
  double release_of(int body, const Case& c) const;
};

/// Whether any force of the case stores energy.
bool stores_energy(const Case& c);

/// The forces of a case from one event to the next.
class CaseForces final : public multibody::ForceModel {
 public:
  /// @param c  must outlive this object
  CaseForces(const Case& c, const History& history);

  void add_forces(double time, std::span<const multibody::BodyMotion> bodies,
                  std::span<multibody::BodyForce> forces) const override;
  void add_masses(double time,
                  std::vector<multibody::BodyMass>& to) const override {
    flow_.add_masses(time, to);
  }
  double next_break(double time) const override;
  void add_kinks(double during, std::span<const multibody::BodyMotion> bodies,
                 std::vector<multibody::KinkedVariable>& to) const override;
  /// Load by one force of the case on its body; none before its begin, after
  /// its end, and without stroke.
  std::optional<multibody::BodyForce> of(
      int force, double time,
      std::span<const multibody::BodyMotion> bodies) const;
  /// Energy stored by forces, J.
  double stored_energy(double time,
                       std::span<const multibody::BodyMotion> bodies) const;
  const MassFlow& flow() const { return flow_; }
  /// As CompliantStops has it.
  double stop_moment(int body,
                     std::span<const multibody::BodyMotion> bodies) const {
    return stops_.moment(body, bodies);
  }

 private:
  struct Active {
    const Force* force;
    double begin, end;  // s
    double own;         // its own clock
    bool is_on(double time) const { return time >= begin && time < end; }
  };
  ForceInstant instant(const Active& active, double time,
                       std::span<const multibody::BodyMotion> bodies) const;

  const Case& case_;
  std::vector<Active> active_;
  std::vector<double> breaks_;  // increasing
  CompliantStops stops_;
  GivenLoads given_;
  MassFlow flow_;
};

}  // namespace separation
