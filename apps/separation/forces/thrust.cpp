#include <cmath>

#include "separation/case/force_kind.hpp"

namespace separation {
namespace {

/// An engine: full thrust until it is cut off, then T exp(-t/decay).
struct Thrust final : ForceLaw {
  Eigen::Vector3d point;
  Eigen::Vector3d force;  ///< body axes, N
  Clock cutoff;
  double decay;  ///< s

  void add(const ForceInstant& at,
           std::span<multibody::BodyForce> forces) const override {
    double part = 1;
    if (at.time >= at.own) {
      part = decay > 0 ? std::exp((at.own - at.time) / decay) : 0;
    }
    const multibody::BodyMotion& body = at.on();
    forces[at.body].add_at(body, body.point(point),
                           body.rotation * (part * force));
  }
  ForceEnds where(const Case&, int) const override { return {point}; }
  Clock own_clock() const override { return cutoff; }
};

std::shared_ptr<const ForceLaw> read(const ForceTable& from) {
  const TomlTable& table = from.table;
  auto law = std::make_shared<Thrust>();
  law->point = from.point();
  law->force = table.number("thrust", Interval::non_negative()) *
               direction(table, "direction");
  law->cutoff = from.clock("cutoff", never);
  law->decay = table.optional_number("decay", Interval::positive()).value_or(0);
  if (law->decay > 0 && law->cutoff.event < 0 && std::isinf(law->cutoff.time)) {
    table.needs("decay", "cutoff_at or cutoff_at_event");
  }
  return law;
}

}  // namespace

ForceKind thrust() {
  using contact::Dimension;
  return {"thrust",
          {{"point", Dimension::length},
           {"direction"},
           {"thrust", Dimension::force},
           {"cutoff_at", Dimension::time},
           {"cutoff_at_event"},
           {"cutoff_delay", Dimension::time},
           {"decay", Dimension::time}},
          read};
}

}  // namespace separation
