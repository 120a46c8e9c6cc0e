// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "libcontact/base/dimension.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/magnitude.hpp"
#include "libcontact/joint/solution.hpp"

/// Tables of the quantities of results, one for each struct, from which columns
/// and their help, summaries, the names that studies know, the getters of C and
/// the attributes of Python are made. A new quantity is a member of the struct
/// and a row here.
namespace contact {

enum class SeatStatus;

/// A quantity of a T. Values are in SI units and radians.
template <class T>
struct Quantity {
  std::string_view key;     ///< in C and Python: "friction_moment"
  std::string_view symbol;  ///< in columns: "M_t"; "" if it is the key
  Dimension dimension;
  std::string_view meaning;
  std::variant<double (*)(const T&), int (*)(const T&), bool (*)(const T&),
               Status (*)(const T&), JointState (*)(const T&),
               const Eigen::Vector3d& (*)(const T&), ContactState (*)(const T&),
               SeatStatus (*)(const T&)>
      of;
  /// Meaning of a vector's length, if it is a column too.
  std::string_view length_meaning = {};
  /// Null: always. Without it tables are empty.
  bool (*exists)(const T&) = nullptr;

  std::string_view stem() const { return symbol.empty() ? key : symbol; }
  bool is_vector() const { return of.index() == 5; }
  /// A Status or another enumeration, which tables print as a word.
  bool is_word() const {
    return of.index() == 3 || of.index() == 4 || of.index() >= 6;
  }
};

/// The SI unit for people: "N m"; "" if there is none.
std::string unit_text(Dimension dimension);

/// "M_t: friction moment on the body, N m"
std::string description(std::string_view symbol, std::string_view meaning,
                        Dimension dimension);
template <class T>
std::string description(const Quantity<T>& q) {
  return description(q.symbol, q.meaning, q.dimension);
}

/// The row of a key; null if there is none.
template <class T>
const Quantity<T>* find_quantity(std::span<const Quantity<T>> all,
                                 std::string_view key) {
  for (const Quantity<T>& q : all) {
    if (q.key == key) return &q;
  }
  return nullptr;
}

/// Stands for the length of a vector where its parts are 0, 1, 2.
inline constexpr int whole = -1;

/// A number, a part of a vector or its length, in the SI unit, whether it
/// exists or not.
template <class T>
double number_of(const Quantity<T>& q, const T& of, int part = whole) {
  // Most are such: rows are written in inner loops.
  if (const auto* number = std::get_if<0>(&q.of)) return (*number)(of);
  if (const auto* vector = std::get_if<5>(&q.of)) {
    const Eigen::Vector3d& v = (*vector)(of);
    return part == whole ? magnitude(v) : v[part];
  }
  return std::visit(
      [&](auto get) -> double {
        if constexpr (std::is_same_v<decltype(get(of)),
                                     const Eigen::Vector3d&>) {
          return 0;  // done above
        } else {
          return static_cast<double>(get(of));
        }
      },
      q.of);
}

/// The same; NaN where it does not exist.
template <class T>
double value_of(const Quantity<T>& q, const T& of, int part = whole) {
  return q.exists && !q.exists(of) ? std::numeric_limits<double>::quiet_NaN()
                                   : number_of(q, of, part);
}

/// A quantity, the length of a vector or a part of it as tables print it.
template <class T>
struct Column {
  std::string name;          ///< "M_t_x_N_m"
  std::string_view meaning;  ///< "" for all parts of a vector but the first
  const Quantity<T>* quantity;
  const Unit* unit;
  int part = whole;

  /// In `unit`; NaN where it does not exist.
  double operator()(const T& of) const {
    return unit->from_si(value_of(*quantity, of, part));
  }
};

/// "M_t_x_N_m" of "M_t", "_x", "N_m".
std::string column_name(std::string_view stem, std::string_view part,
                        const Unit& unit);

/// The columns of a quantity. A word is none.
/// @param unit  printed_unit(), or what a table prints instead
template <class T>
std::vector<Column<T>> columns_of(const Quantity<T>& q, const Unit& unit) {
  std::vector<Column<T>> columns;
  const auto add = [&](std::string_view end, std::string_view meaning,
                       int part) {
    columns.push_back(
        {column_name(q.stem(), end, unit), meaning, &q, &unit, part});
  };
  if (q.is_word()) return columns;
  if (!q.is_vector()) {
    add("", q.meaning, whole);
    return columns;
  }
  if (!q.length_meaning.empty()) {
    add("", q.length_meaning, whole);
  }
  add("_x", q.meaning, 0);
  add("_y", "", 1);
  add("_z", "", 2);
  return columns;
}
template <class T>
std::vector<Column<T>> columns_of(const Quantity<T>& q) {
  return columns_of(q, printed_unit(q.dimension));
}
/// Columns of all quantities of a table.
template <class T>
std::vector<Column<T>> columns_of(std::span<const Quantity<T>> all) {
  std::vector<Column<T>> columns;
  for (const Quantity<T>& q : all) {
    for (Column<T>& column : columns_of(q)) {
      columns.push_back(std::move(column));
    }
  }
  return columns;
}

}  // namespace contact
