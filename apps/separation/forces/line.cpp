#include "separation/forces/line.hpp"

namespace separation {
namespace {

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

}  // namespace

LineForce read_line(const ForceTable& from) {
  from.refuse_carrier();
  const TomlTable& table = from.table;
  const Eigen::Vector3d point = from.point();
  if (table.has("other_body")) {
    const int other = read_other(from);
    return {point, other,
            from.turn * vector(table, "other_point") -
                from.names.of.rigid_body(other).com};
  }
  if (table.has("other_point")) table.needs("other_point", "other_body");
  return {point, 0, from.carrier_point()};
}

}  // namespace separation
