#include "separation/case/force_kind.hpp"
#include "separation/forces/line.hpp"

namespace separation {
namespace {

constexpr std::string_view damper_faults[] = {
    "has no direction when it starts, t = {time:.6g} s: point on {body} and "
    "its other end are in one place",
};

/// A viscous damper between a point of the body and one of the carrier or of
/// another body: along the line between them a force against the rate of its
/// length, the opposite one on the other body. Forces are linear in the rate,
/// without friction or preload.
struct Damper final : ForceLaw {
  LineForce ends;
  double damping;  ///< N s/m

  void add(const ForceInstant& at,
           std::span<multibody::BodyForce> forces) const override {
    ends.add(at, forces,
             [this](double, double rate) { return -damping * rate; });
  }
  ForceEnds where(const Case&, int) const override { return ends.where(); }

  std::span<const std::string_view> faults() const override {
    return damper_faults;
  }
  int find_fault(const ForceInstant& at, bool begins, bool) const override {
    return begins && ends.is_point(at) ? 1 : 0;
  }
};

std::shared_ptr<const ForceLaw> read_damper(const ForceTable& from) {
  auto law = std::make_shared<Damper>();
  law->ends = read_line(from);
  law->damping = from.table.number("damping_N_s_per_m");
  return law;
}

}  // namespace

ForceKind damper() {
  using contact::Dimension;
  return {"damper",
          {{"point", Dimension::length},
           {"carrier_point", Dimension::length},
           {"other_body"},
           {"other_point", Dimension::length},
           contact::number_key("damping_N_s_per_m", Interval::non_negative())},
          read_damper,
          true};
}

}  // namespace separation
