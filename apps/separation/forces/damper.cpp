#include "separation/case/force_kind.hpp"
#include "separation/forces/line.hpp"

namespace separation {
namespace {

constexpr std::string_view fault_texts[] = {
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
    return fault_texts;
  }
  int find_fault(const ForceInstant& at, bool begins, bool) const override {
    return begins && ends.is_point(at) ? 1 : 0;
  }
};

// Copies of one body and of another are joined one by one.
int read_other(const ForceTable& from) {
  const TomlTable& table = from.table;
  table.refuse_both("other_body", "carrier_point");
  const auto others = from.names.rigid_bodies_of(table, "other_body");
  const int count = static_cast<int>(others.size());
  if (count != 1 && count != from.copies) {
    table.must_be("other_body", "one body, or as many as body names");
  }
  const int other = others[count == 1 ? 0 : from.copy];
  if (other == 0) {
    table.must_be("other_body",
                  "a body, not the carrier, whose point is carrier_point");
  }
  if (other == from.body) table.must_be("other_body", "another one than body");
  return other;
}

std::shared_ptr<const ForceLaw> read(const ForceTable& from) {
  from.refuse_carrier();
  const TomlTable& table = from.table;
  auto law = std::make_shared<Damper>();
  const Eigen::Vector3d point = from.point();
  if (table.has("other_body")) {
    const int other = read_other(from);
    law->ends = {
        point, other,
        vector(table, "other_point") - from.names.of.rigid_body(other).com};
  } else {
    if (table.has("other_point")) table.needs("other_point", "other_body");
    law->ends = {point, 0, from.carrier_point()};
  }
  law->damping = table.number("damping_N_s_per_m", Interval::non_negative());
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
           {"damping_N_s_per_m"}},
          read};
}

}  // namespace separation
