#include "separation/forces/tables.hpp"

#include <numbers>

#include "separation/case/system_of.hpp"

namespace separation {

using multibody::HingeKind;

RowsOver read_variable(const ForceTable& from) {
  const TomlTable& table = from.table;
  const HingeKind hinge = from.hinge();
  table.refuse_both("angle", "time");
  if (table.has("angle") && hinge == HingeKind::none) {
    table.needs("angle", "a body on a hinge");
  }
  if (table.has("time")) {
    return {Variable::time, times_with_jumps(table, "time")};
  }
  if (!table.has("angle")) return {};
  const auto at = increasing(table, "angle");
  // 180 deg but for the rounding of units.
  constexpr double most = std::numbers::pi * (1 + 1e-15);
  if (hinge == HingeKind::ball && (at.front() < 0 || at.back() > most)) {
    table.must_be("angle",
                  "0 deg to 180 deg on a ball hinge: it is the angle between "
                  "two directions");
  }
  return {Variable::angle, at};
}

TablePlace place_in(Variable over, const ForceInstant& at) {
  switch (over) {
    case Variable::time:
      return {at.time, at.begin};
    case Variable::angle:
      return {
          hinge_angle(at.of.bodies[at.body - 1].hinge, at.carrier(), at.on()),
          0};
    case Variable::none:
      break;
  }
  return {0, 0};
}

}  // namespace separation
