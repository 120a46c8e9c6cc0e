#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "libcontact/quantities/quantity.hpp"
#include "python/rows.hpp"

/// Results of many rows, whose quantities are attributes.
namespace contact_python {

using contact::Quantity;

/// What a getter of a quantity returns, as NumPy has it.
template <class Value>
using Number =
    std::conditional_t<std::is_same_v<Value, const Eigen::Vector3d&>, double,
                       std::conditional_t<std::is_enum_v<Value>, int, Value>>;

/// For people: "M_t: friction moment on the body, N m, (..., 3)."
template <class Row>
std::string documentation(const Quantity<Row>& q) {
  return description(q) + (q.is_vector() ? ", (..., 3)."
                           : q.is_word() ? ", as a number."
                                         : ".");
}

/// Rows as they were computed; arrays of a quantity are made when asked for.
/// Unpickled ones have the arrays in their place, and with them all that can be
/// asked of the rows.
template <class Row>
struct Answers {
  Shape shape;
  std::vector<Row> rows = {};
  py::object arrays = {};  ///< a dict by the names of the fields, or nothing
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

/// An array of a pickle that is none, or of another type or shape.
/// @param rows  their shape, if it is known
[[noreturn]] void refuse_pickled(const char* name, const py::dtype& type,
                                 const std::optional<Shape>& rows,
                                 bool is_vector);
/// Arrays of a pickle beside those that there are.
[[noreturn]] void refuse_pickled_names(const py::dict& arrays);

template <class Row, class Value>
py::array column(const Answers<Row>& a, Value (*of)(const Row&)) {
  py::array_t<Number<Value>> array(a.shape);
  auto* to = array.mutable_data();
  for (const Row& row : a.rows) *to++ = static_cast<Number<Value>>(of(row));
  return array;
}

template <class Row>
py::array column(const Answers<Row>& a,
                 const Eigen::Vector3d& (*of)(const Row&)) {
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
py::array column(const Answers<Row>& a, const Quantity<Row>& q) {
  if (a.arrays) return a.arrays[q.key.data()].attr("copy")();
  return std::visit([&](auto of) { return column(a, of); }, q.of);
}

// Columns of tables have one dimension: vectors are three columns.
template <class Row>
py::dict to_dict(const Answers<Row>& a, std::span<const Quantity<Row>> fields) {
  py::dict columns;
  for (const Quantity<Row>& field : fields) {
    const py::object array = column(a, field);
    if (field.is_vector()) {
      const py::object rows = array.attr("reshape")(-1, 3);
      constexpr std::array ends = {"_x", "_y", "_z"};
      for (std::size_t i = 0; i < ends.size(); ++i) {
        columns[py::str(std::string(field.key) + ends[i])] =
            rows[py::make_tuple(py::ellipsis(), i)];
      }
    } else {
      columns[field.key.data()] = array.attr("ravel")();
    }
  }
  return columns;
}

template <class Row>
py::dict arrays_of(const Answers<Row>& a,
                   std::span<const Quantity<Row>> fields) {
  py::dict arrays;
  for (const Quantity<Row>& field : fields)
    arrays[field.key.data()] = column(a, field);
  return arrays;
}

// A copy of an array of a pickle, as column() makes them. Those of another
// shape would be read beyond their ends.
template <class Row>
py::array array_in(const py::dict& arrays, const Quantity<Row>& field,
                   const std::optional<Shape>& rows) {
  return std::visit(
      [&]<class Value>(Value (*)(const Row&)) -> py::array {
        using Number = Number<Value>;
        const bool is_vector = field.is_vector();
        const auto given = arrays.attr("get")(field.key.data());
        if (py::isinstance<py::array_t<Number>>(given)) {
          const py::array_t<Number, py::array::c_style> array(given);
          const Shape shape(array.shape(), array.shape() + array.ndim());
          Shape wanted = rows.value_or(shape);
          if (is_vector && rows) wanted.push_back(3);
          if (shape == wanted) return py::array_t<Number>(shape, array.data());
        }
        refuse_pickled(field.key.data(), py::dtype::of<Number>(), rows,
                       is_vector);
      },
      field.of);
}

template <class Row>
Answers<Row> from_arrays(const py::dict& arrays,
                         std::span<const Quantity<Row>> fields) {
  std::optional<Shape> shape;  // of the rows, by a quantity that is a number
  py::dict own;
  for (const Quantity<Row>& field : fields) {
    const py::array array = array_in(arrays, field, shape);
    if (!shape) shape.emplace(array.shape(), array.shape() + array.ndim());
    own[field.key.data()] = array;
  }
  if (arrays.size() != own.size()) refuse_pickled_names(own);
  return {std::move(*shape), {}, std::move(own)};
}

}  // namespace detail

/// The Python class of such results.
/// @param fields  a table; the first is a number
template <class Row>
void bind_answers(py::module_& m, const char* name,
                  std::span<const Quantity<Row>> fields, const char* doc) {
  py::class_<Answers<Row>> type(m, name, doc);
  for (const Quantity<Row>& field : fields) {
    type.def_property_readonly(
        field.key.data(),
        [&field](const Answers<Row>& a) {
          return returned(detail::column(a, field));
        },
        documentation(field).c_str());
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
      .def(py::pickle(
          [fields](const Answers<Row>& a) {
            return detail::arrays_of(a, fields);
          },
          [fields](const py::dict& arrays) {
            return detail::from_arrays(arrays, fields);
          }));
}

}  // namespace contact_python
