#include <algorithm>
#include <array>
#include <cmath>

#include "separation/case/body_reader.hpp"
#include "separation/forces/tables.hpp"

namespace separation {
namespace {

/// An engine: its thrust until it is cut off, then T exp(-t/decay).
struct Thrust final : ForceLaw {
  Eigen::Vector3d point;
  Eigen::Vector3d direction;  ///< body axes
  bool timed = false;         ///< the table is one over time
  IntegratedTable thrust;     ///< N
  Clock cutoff;
  double decay;  ///< s
  std::optional<Propellant> burnt;

  double full(double time, double begin, double own) const {
    return timed ? thrust(std::min(time, own), begin) : thrust.values.front();
  }
  double part(double time, double own) const {
    if (time < own) return 1;
    return decay > 0 ? std::exp((own - time) / decay) : 0;
  }

  void add(const ForceInstant& at,
           std::span<multibody::BodyForce> forces) const override {
    const multibody::BodyMotion& body = at.on();
    const Eigen::Vector3d force = full(at.time, at.begin, at.own) * direction;
    forces[at.body].add_at(body, body.point(point),
                           body.rotation * (part(at.time, at.own) * force));
  }
  ForceEnds where(const Case&, int) const override {
    return {.point = point, .exhaust = -direction};
  }
  Clock own_clock() const override { return cutoff; }
  void add_breaks(double begin, std::vector<double>& breaks) const override {
    if (timed) thrust.add_breaks(begin, breaks);
  }
  const Propellant* propellant() const override {
    return burnt ? &*burnt : nullptr;
  }
  double thrust_at(double time, double begin, double own) const override {
    return full(time, begin, own) * part(time, own);
  }
  double impulse_until(double time, double begin, double own) const override {
    const double cut = std::max(begin, own);
    const double impulse =
        thrust.integral(std::min(time, cut) - begin) - thrust.integral(0);
    if (time <= cut || !(decay > 0)) return impulse;
    return impulse +
           full(cut, begin, own) * decay * (part(cut, own) - part(time, own));
  }
};

std::optional<Propellant> read_propellant(const ForceTable& from) {
  const TomlTable& table = from.table;
  constexpr double standard_gravity = 9.80665;  // m/s^2
  const auto impulse = table.optional_number("specific_impulse");
  auto speed = table.optional_number("exhaust_speed");
  table.refuse_both("specific_impulse", "exhaust_speed");
  if (impulse) speed = *impulse * standard_gravity;
  constexpr std::array names = {"propellant", "empty_com", "empty_inertia",
                                "empty_principal_inertia"};
  for (const char* key : names) {
    if (!table.has(key)) continue;
    if (!speed) table.needs(key, "specific_impulse or exhaust_speed");
    if (!table.has("propellant")) table.needs(key, "propellant");
    if (key != names.front()) table.refuse_both(key, "pattern");
  }
  if (!speed) return {};
  Propellant propellant{*speed};
  propellant.mass =
      table.optional_number("propellant").value_or(propellant.mass);
  if (const auto com = optional_vector(table, "empty_com")) {
    propellant.empty_com = *com - from.rigid_body().com;
  }
  propellant.empty_inertia = read_inertia(table, "empty_");
  if (propellant.empty_inertia &&
      !is_below(*propellant.empty_inertia, from.rigid_body().inertia)) {
    table.must_be(
        inertia_key(table, "empty_"),
        "about no axis above the inertia of the body with its propellant");
  }
  return propellant;
}

std::shared_ptr<const ForceLaw> read_thrust(const ForceTable& from) {
  const TomlTable& table = from.table;
  auto law = std::make_shared<Thrust>();
  law->point = from.point();
  law->timed = table.has("time");
  if (law->timed) {
    const auto at = times_with_jumps(table, "time");
    law->thrust = {at, table.numbers("thrust", {at.size()})};
  } else {
    law->thrust = {{0}, {table.number("thrust")}};
  }
  law->direction = from.body_direction();
  law->cutoff = from.clock("cutoff", never);
  law->decay = table.optional_number("decay").value_or(0);
  if (law->decay > 0 && law->cutoff.event < 0 && std::isinf(law->cutoff.time)) {
    table.needs("decay", "cutoff_at or cutoff_at_event");
  }
  law->burnt = read_propellant(from);
  return law;
}

}  // namespace

ForceKind thrust() {
  using contact::Dimension;
  using contact::number_key;
  constexpr auto non_negative = Interval::non_negative();
  constexpr auto positive = Interval::positive();
  return {"thrust",
          {{"point", Dimension::length},
           {"direction"},
           {"time", Dimension::time},
           number_key("thrust", Dimension::force, non_negative),
           number_key("cutoff_at", Dimension::time, non_negative),
           {"cutoff_at_event"},
           number_key("cutoff_delay", Dimension::time, non_negative),
           number_key("decay", Dimension::time, positive),
           number_key("specific_impulse", Dimension::time, positive),
           number_key("exhaust_speed", Dimension::velocity, positive),
           number_key("propellant", Dimension::mass, positive),
           {"empty_com", Dimension::length},
           {"empty_inertia", Dimension::inertia},
           {"empty_principal_inertia", Dimension::inertia}},
          read_thrust,
          true};
}

}  // namespace separation
