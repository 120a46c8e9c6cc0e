#include "separation/case/force_kind.hpp"
#include "separation/forces/line.hpp"

namespace separation {
namespace {

constexpr std::string_view spring_faults[] = {
    "has no direction when it starts, t = {time:.6g} s: point on {body} and "
    "its other end are in one place",
    "pulls {body} back after its release, from t = {time:.6g} s: it is longer "
    "than free_length; ends_at_event ends it, a pusher only pushes",
};

/// A spring between a point of the body and one of the carrier or of another
/// body.
struct Spring final : ForceLaw {
  enum Fault { none, no_direction, pulls_back };

  LineForce ends;
  double stiffness;    ///< N/m
  double free_length;  ///< m
  double damping;      ///< N s/m

  void add(const ForceInstant& at,
           std::span<multibody::BodyForce> forces) const override {
    ends.add(at, forces, [this](double length, double rate) {
      return stiffness * (free_length - length) - damping * rate;
    });
  }
  ForceEnds where(const Case&, int) const override { return ends.where(); }

  std::span<const std::string_view> faults() const override {
    return spring_faults;
  }
  int find_fault(const ForceInstant& at, bool begins,
                 bool released) const override {
    if (!(stiffness > 0)) return none;
    if (begins && ends.is_point(at) && free_length > 0) return no_direction;
    const Hinge& hinge = at.of.bodies[at.body - 1].hinge;
    const bool has_come_off = released && ends.other == hinge.on &&
                              hinge.kind != multibody::HingeKind::none;
    // Longer than rounding of lengths and tolerances of steps make it.
    const bool pulls = ends.line(at).span.norm() > (1 + 1e-6) * free_length;
    return has_come_off && pulls ? pulls_back : none;
  }
  bool is_watched() const override { return true; }
};

std::shared_ptr<const ForceLaw> read_spring(const ForceTable& from) {
  const TomlTable& table = from.table;
  auto law = std::make_shared<Spring>();
  law->ends = read_line(from);
  law->stiffness = table.number("stiffness");
  law->free_length = table.number("free_length");
  law->damping = table.optional_number("damping_N_s_per_m").value_or(0);
  return law;
}

}  // namespace

ForceKind spring() {
  using contact::Dimension;
  using contact::number_key;
  constexpr auto non_negative = Interval::non_negative();
  return {"spring",
          {{"point", Dimension::length},
           {"carrier_point", Dimension::length},
           {"other_body"},
           {"other_point", Dimension::length},
           number_key("stiffness", Dimension::line_force, non_negative),
           number_key("free_length", Dimension::length, non_negative),
           number_key("damping_N_s_per_m", non_negative)},
          read_spring,
          true};
}

}  // namespace separation
