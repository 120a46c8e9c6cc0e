#pragma once

#include <array>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "python/rows.hpp"

/// Results of many rows, whose quantities are attributes.
namespace contact_python {

/// A quantity of a row.
template <class Row>
struct Field {
  const char* name;
  std::variant<double (*)(const Row&), int (*)(const Row&),
               bool (*)(const Row&), Eigen::Vector3d (*)(const Row&)>
      of;
  const char* doc;
};

/// Rows as they were computed; arrays of a quantity are made when asked for.
template <class Row>
struct Answers {
  Shape shape;
  std::vector<Row> rows;
};

/// The rows of `row(numbers)`.
template <class Row, class Function>
Answers<Row> answers(std::initializer_list<Argument> arguments,
                     const Function& row) {
  const Rows in(arguments);
  Answers<Row> result{in.shape(), {}};
  result.rows.reserve(in.size());
  in.for_each([&](const double* const* at) { result.rows.push_back(row(at)); });
  return result;
}

namespace detail {

template <class Row, class Value>
py::array column(const Answers<Row>& a, Value (*of)(const Row&)) {
  py::array_t<Value> array(a.shape);
  Value* to = array.mutable_data();
  for (const Row& row : a.rows) *to++ = of(row);
  return array;
}

template <class Row>
py::array column(const Answers<Row>& a, Eigen::Vector3d (*of)(const Row&)) {
  Shape shape = a.shape;
  shape.push_back(3);
  py::array_t<double> array(shape);
  double* to = array.mutable_data();
  for (const Row& row : a.rows) {
    for (const double x : of(row)) *to++ = x;
  }
  return array;
}

template <class Row>
py::array column(const Answers<Row>& a, const Field<Row>& field) {
  return std::visit([&](auto of) { return column(a, of); }, field.of);
}

// Columns of tables have one dimension: vectors are three columns.
template <class Row>
py::dict to_dict(const Answers<Row>& a, std::span<const Field<Row>> fields) {
  py::dict columns;
  for (const Field<Row>& field : fields) {
    const py::object array = column(a, field);
    if (field.of.index() == 3) {
      const py::object rows = array.attr("reshape")(-1, 3);
      constexpr std::array ends = {"_x", "_y", "_z"};
      for (std::size_t i = 0; i < ends.size(); ++i) {
        columns[py::str(field.name + std::string(ends[i]))] =
            rows[py::make_tuple(py::slice(0, a.rows.size(), 1), i)];
      }
    } else {
      columns[field.name] = array.attr("ravel")();
    }
  }
  return columns;
}

template <class Row>
py::tuple state_of(const Answers<Row>& a) {
  const auto* bytes = reinterpret_cast<const char*>(a.rows.data());
  return py::make_tuple(a.shape, py::bytes(bytes, a.rows.size() * sizeof(Row)));
}

// Pickles are for other processes of this program, not for files.
template <class Row>
Answers<Row> from_state(const py::tuple& state) {
  Answers<Row> a{state[0].cast<Shape>(), {}};
  const auto bytes = state[1].cast<std::string>();
  if (bytes.size() % sizeof(Row) != 0) {
    throw py::value_error("pickled by another version");
  }
  a.rows.resize(bytes.size() / sizeof(Row));
  std::memcpy(static_cast<void*>(a.rows.data()), bytes.data(), bytes.size());
  return a;
}

}  // namespace detail

/// The Python class of such results.
/// @param fields  that last
template <class Row>
void bind_answers(py::module_& m, const char* name,
                  std::span<const Field<Row>> fields, const char* doc) {
  static_assert(std::is_trivially_destructible_v<Row>);
  py::class_<Answers<Row>> type(m, name, doc);
  for (const Field<Row>& field : fields) {
    type.def_property_readonly(
        field.name,
        [&field](const Answers<Row>& a) {
          return returned(detail::column(a, field));
        },
        field.doc);
  }
  type.def_property_readonly(
          "shape",
          [](const Answers<Row>& a) { return py::tuple(py::cast(a.shape)); },
          "Shape of the rows: that of the arguments broadcast.")
      .def("__len__",
           [](const Answers<Row>& a) {
             if (a.shape.empty()) throw py::type_error("a single row");
             return a.shape[0];
           })
      .def("__repr__",
           [name = std::string(name)](const Answers<Row>& a) {
             return "<" + name + " of shape " +
                    py::str(py::tuple(py::cast(a.shape))).cast<std::string>() +
                    ">";
           })
      .def(
          "to_dict",
          [fields](const Answers<Row>& a) {
            return detail::to_dict(a, fields);
          },
          "to_dict(self)\n--\n\nAll quantities as columns of one dimension, "
          "vectors as three\n(NAME_x, NAME_y, NAME_z): "
          "pandas.DataFrame(s.to_dict()).")
      .def(py::pickle(&detail::state_of<Row>, &detail::from_state<Row>));
}

}  // namespace contact_python
