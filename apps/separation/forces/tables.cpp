#include "separation/forces/tables.hpp"

#include <algorithm>
#include <utility>

#include "separation/case/hinges/hinge_type.hpp"
#include "separation/case/system_of.hpp"

namespace separation {

IntegratedTable::IntegratedTable(std::vector<double> rows,
                                 std::vector<double> numbers)
    : Table{std::move(rows), std::move(numbers)}, sums_{0} {
  for (std::size_t i = 1; i < at.size(); ++i) {
    sums_.push_back(sums_.back() +
                    (at[i] - at[i - 1]) * (values[i - 1] + values[i]) / 2);
  }
}

double IntegratedTable::integral(double x) const {
  if (x <= at.front()) return (x - at.front()) * values.front();
  const std::size_t i = std::ranges::upper_bound(at, x) - at.begin() - 1;
  const double last = i + 1 == at.size() ? values[i] : (*this)(x);
  return sums_[i] + (x - at[i]) * (values[i] + last) / 2;
}

RowsOver read_variable(const ForceTable& from) {
  const TomlTable& table = from.table;
  table.refuse_both("angle", "time");
  if (table.has("angle") && from.hinge() == multibody::HingeKind::none) {
    table.needs("angle", "a body on a hinge");
  }
  if (table.has("time")) {
    return {Variable::time, times_with_jumps(table, "time")};
  }
  if (!table.has("angle")) return {};
  const auto at = increasing(table, "angle");
  check_angles(table, from.names.of.bodies[from.body - 1].hinge, at.front(),
               at.back(), "a ball hinge");
  return {Variable::angle, at};
}

TablePlace place_in(Variable over, const ForceInstant& at) {
  switch (over) {
    case Variable::time:
      return {at.time, at.begin};
    case Variable::angle:
      return {hinge_angle(at.hinge(), at.parent(), at.on()), 0};
    case Variable::none:
      break;
  }
  return {0, 0};
}

void add_kinks(Variable over, const std::vector<double>& rows,
               const ForceInstant& at,
               std::vector<multibody::KinkedVariable>& to) {
  if (over == Variable::angle) to.push_back({place_in(over, at).x, rows});
}

}  // namespace separation
