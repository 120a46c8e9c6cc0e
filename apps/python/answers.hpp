#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "libcontact/quantities/quantity.hpp"
#include "python/rows/rows.hpp"

/// Results of many rows; their quantities are attributes.
namespace contact_python {

using contact::Quantity;

namespace detail {

template <class Row, class Pointers>
struct Getters;
template <class Row, class Part, class... Value>
struct Getters<Row, std::variant<Value (*)(const Part&)...>> {
  using type = std::variant<std::function<Value(const Row&)>...>;
};

}  // namespace detail

/// A Quantity of a Row, or of a part of a Row.
template <class Row>
struct Field {
  std::string_view key;
  std::string_view symbol;
  contact::Dimension dimension;
  std::string_view meaning;
  typename detail::Getters<Row, decltype(Quantity<Row>::of)>::type of;

  bool is_vector() const { return of.index() == 5; }
  bool is_word() const {
    return of.index() == 3 || of.index() == 4 || of.index() >= 6;
  }
};

/// The quantities of a Row; made once, and never destroyed.
template <class Row>
using Table = std::vector<Field<Row>>;

/// Adds quantities of `*part(row)`.
template <class Row, class Part, class Get>
void add(Table<Row>& to, std::span<const Quantity<Part>> quantities,
         const Get& part) {
  for (const Quantity<Part>& q : quantities) {
    Field<Row>& field = to.emplace_back(
        Field<Row>{q.key, q.symbol, q.dimension, q.meaning, {}});
    std::visit(
        [&]<class Value>(Value (*get)(const Part&)) {
          field.of = std::function<Value(const Row&)>(
              [get, part](const Row& row) -> Value { return get(part(row)); });
        },
        q.of);
  }
}

/// The quantities of a Row itself, made once; call with Python's lock.
template <class Row>
const Table<Row>& table_of(std::span<const Quantity<Row>> quantities) {
  static auto& all = *new std::map<const Quantity<Row>*, Table<Row>>();
  const auto [kept, is_new] = all.try_emplace(quantities.data());
  Table<Row>& table = kept->second;
  if (is_new) {
    add(table, quantities, [](const Row& row) -> const Row& { return row; });
  }
  return table;
}

/// NumPy's type for the return type of a quantity's getter.
template <class Value>
using Number =
    std::conditional_t<std::is_same_v<Value, const Eigen::Vector3d&>, double,
                       std::conditional_t<std::is_enum_v<Value>, int, Value>>;

/// For people: "M_t: friction moment on the body, N m, (..., 3)."
template <class Quantity>
std::string documentation(const Quantity& q) {
  return contact::description(q.symbol, q.meaning, q.dimension) +
         (q.is_vector() ? ", (..., 3)."
          : q.is_word() ? ", as a number."
                        : ".");
}

/// Rows as they were computed; the array of a quantity is made on first use and
/// is read-only. After unpickling, `rows` is empty and every array is already
/// present.
template <class Row>
struct Answers {
  Shape shape;
  std::vector<Row> rows = {};
  mutable py::object arrays = {};  ///< a dict by the names of the fields
};

/// Computes the rows `row(numbers)`.
/// @param at_once  see Rows::for_each()
template <class Row, class Function>
Answers<Row> answers(std::initializer_list<Argument> arguments,
                     const Function& row, std::size_t at_once = Rows::block) {
  const Rows in(arguments);
  Answers<Row> result{in.shape(), {}};
  result.rows.reserve(in.size());
  in.for_each([&](const double* const* at) { result.rows.push_back(row(at)); },
              at_once);
  return result;
}

/// The argument `fields` (one name or several), and `out` of WantedRows.
using Fields =
    std::optional<std::variant<std::string, std::vector<std::string>>>;
using Out = std::optional<py::dict>;

namespace detail {

/// Rejects an array of a pickle that is no array or has another type or shape.
/// @param rows  their shape, if known
[[noreturn]] void refuse_pickled(const char* name, const py::dtype& type,
                                 const std::optional<Shape>& rows,
                                 bool is_vector);
/// Rejects unknown arrays of a pickle.
[[noreturn]] void refuse_pickled_names(const py::dict& arrays);
/// The requested quantities without repetition.
std::vector<std::string> chosen_names(const Fields& names, const Out& out);
[[noreturn]] void refuse_field(const std::string& name,
                               std::vector<std::string> known);
template <class Row>
[[noreturn]] void refuse_field(const std::string& name,
                               const Table<Row>& fields) {
  std::vector<std::string> known;
  for (const Field<Row>& q : fields) known.emplace_back(q.key);
  refuse_field(name, std::move(known));
}
/// Makes an array read-only.
void protect(py::array& array);
/// Some rows of an array.
py::array rows_of(const py::array& array, const py::array_t<std::size_t>& which,
                  bool is_vector);

template <class Row, class Value>
py::array made(const Answers<Row>& a,
               const std::function<Value(const Row&)>& of) {
  py::array_t<Number<Value>> array(a.shape);
  auto* to = array.mutable_data();
  for (const Row& row : a.rows) *to++ = static_cast<Number<Value>>(of(row));
  return array;
}

template <class Row>
py::array made(const Answers<Row>& a,
               const std::function<const Eigen::Vector3d&(const Row&)>& of) {
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
py::array column(const Answers<Row>& a, const Field<Row>& q) {
  if (!a.arrays) a.arrays = py::dict();
  const py::str key(q.key.data(), q.key.size());
  if (PyObject* const known = PyDict_GetItem(a.arrays.ptr(), key.ptr())) {
    return py::reinterpret_borrow<py::array>(known);
  }
  py::array array =
      std::visit([&](const auto& of) { return made(a, of); }, q.of);
  protect(array);
  a.arrays[key] = array;
  return array;
}

template <class Row>
py::dict arrays_of(const Answers<Row>& a, const Table<Row>& fields) {
  py::dict arrays;
  for (const Field<Row>& field : fields)
    arrays[field.key.data()] = column(a, field);
  return arrays;
}

// Copies an array of a pickle into the layout of column(). An array of another
// shape would be read beyond its end.
template <class Row>
py::array array_in(const py::dict& arrays, const Field<Row>& field,
                   const std::optional<Shape>& rows) {
  return std::visit(
      [&]<class Value>(const std::function<Value(const Row&)>&) -> py::array {
        using Number = Number<Value>;
        const bool is_vector = field.is_vector();
        const auto given = arrays.attr("get")(field.key.data());
        if (py::isinstance<py::array_t<Number>>(given)) {
          const py::array_t<Number, py::array::c_style> array(given);
          const Shape shape(array.shape(), array.shape() + array.ndim());
          Shape wanted = rows.value_or(shape);
          if (is_vector && rows) wanted.push_back(3);
          if (shape == wanted) {
            py::array own = py::array_t<Number>(shape, array.data());
            protect(own);
            return own;
          }
        }
        refuse_pickled(field.key.data(), py::dtype::of<Number>(), rows,
                       is_vector);
      },
      field.of);
}

template <class Row>
Answers<Row> from_arrays(const py::dict& arrays, const Table<Row>& fields) {
  std::optional<Shape> shape;  // shape of the rows, from a scalar quantity
  py::dict own;
  for (const Field<Row>& field : fields) {
    const py::array array = array_in(arrays, field, shape);
    if (!shape) shape.emplace(array.shape(), array.shape() + array.ndim());
    own[field.key.data()] = array;
  }
  if (arrays.size() != own.size()) refuse_pickled_names(own);
  return {std::move(*shape), {}, std::move(own)};
}

// Some rows, in any shape.
template <class Row>
Answers<Row> taken(const Answers<Row>& a, const Table<Row>& fields,
                   const py::array_t<std::size_t>& which) {
  Answers<Row> some{Shape(which.shape(), which.shape() + which.ndim())};
  if (!a.rows.empty()) {
    for (py::ssize_t i = 0; i < which.size(); ++i)
      some.rows.push_back(a.rows.at(which.data()[i]));
    return some;
  }
  py::dict arrays;
  for (const Field<Row>& field : fields) {
    py::array array = rows_of(column(a, field), which, field.is_vector());
    protect(array);
    arrays[field.key.data()] = array;
  }
  some.arrays = arrays;
  return some;
}

template <class Row, class Value>
const char* words_of(const std::function<Value(const Row&)>&) {
  if (std::is_same_v<Value, contact::Status>) return "Status";
  return std::is_same_v<Value, contact::JointState> ? "State" : "";
}

// For people, and for labels: key, symbol, unit, meaning, and the enumeration
// of words or "".
template <class Row>
py::list quantities_of(const Table<Row>& fields) {
  py::list all;
  for (const Field<Row>& q : fields) {
    all.append(py::make_tuple(
        q.key, q.symbol, contact::unit_text(q.dimension), q.meaning,
        std::visit([](const auto& of) { return words_of(of); }, q.of)));
  }
  return all;
}
template <class Row>
py::list quantities_of(std::span<const Quantity<Row>> quantities) {
  return quantities_of(table_of(quantities));
}

}  // namespace detail

/// Some quantities of rows, in new arrays or arrays of the caller.
template <class Row>
class ChosenColumns {
 public:
  /// @throws contact::Error for unknown names and arrays of another shape or
  ///   type
  ChosenColumns(const Table<Row>& fields, const Fields& names, const Out& out,
                const Shape& shape) {
    if (out) arrays_ = *out;
    for (const std::string& name : detail::chosen_names(names, out)) {
      const auto q = std::ranges::find(fields, name, &Field<Row>::key);
      if (q == fields.end()) detail::refuse_field(name, fields);
      std::visit([&](const auto& of) { add(*q, of, shape, out.has_value()); },
                 q->of);
    }
  }

  void operator()(std::size_t i, const Row& row) const {
    for (const auto& put : columns_) put(i, row);
  }
  const py::dict& arrays() const { return arrays_; }

 private:
  template <class Value>
  void add(const Field<Row>& q, const std::function<Value(const Row&)>& of,
           Shape shape, bool is_given) {
    using Number = Number<Value>;
    if (q.is_vector()) shape.push_back(3);
    const py::str key(q.key.data(), q.key.size());
    if (!is_given) arrays_[key] = py::array_t<Number>(shape);
    // Keep a reference: other threads of the caller may remove it from `out`.
    const py::object array = kept_.emplace_back(arrays_[key]);
    Number* const to = static_cast<Number*>(
        detail::memory_of("out[\"" + std::string(q.key) + "\"]", array,
                          py::dtype::of<Number>(), shape));
    columns_.push_back([to, &of](std::size_t i, const Row& row) {
      if constexpr (std::is_same_v<Value, const Eigen::Vector3d&>) {
        Eigen::Map<Eigen::Vector3d>(to + 3 * i) = of(row);
      } else {
        to[i] = static_cast<Number>(of(row));
      }
    });
  }

  py::dict arrays_;
  std::vector<py::object> kept_;
  std::vector<std::function<void(std::size_t, const Row&)>> columns_;
};

/// Request for rows: the arguments `fields`, `out` and `threads`.
struct WantedRows {
  Fields fields = {};
  Out out = {};
  int threads = 1;
};

/// Answers of all rows, or a dict of the requested quantities; the rows are
/// then not kept.
/// @param begin, at_once  see Rows::for_each(); its functions return a Row
template <class Row, class Begin>
py::object answered(const Rows& rows, const Table<Row>& fields,
                    const WantedRows& wanted, const Begin& begin,
                    std::size_t at_once = Rows::block) {
  Wanted{.threads = wanted.threads}.check();
  const auto into = [&](const auto& put) {
    rows.for_each(
        wanted.threads,
        [&] {
          return [&put, row = begin()](const double* const* at,
                                       std::size_t i) mutable {
            put(i, row(at, i));
          };
        },
        at_once);
  };
  if (wanted.fields || wanted.out) {
    const ChosenColumns<Row> chosen(fields, wanted.fields, wanted.out,
                                    rows.shape());
    into(chosen);
    return chosen.arrays();
  }
  Answers<Row> all{rows.shape()};
  all.rows.resize(rows.size());
  into([&](std::size_t i, const Row& row) { all.rows[i] = row; });
  return py::cast(std::move(all));
}
template <class Row, class Begin>
py::object answered(const Rows& rows, std::span<const Quantity<Row>> quantities,
                    const WantedRows& wanted, const Begin& begin,
                    std::size_t at_once = Rows::block) {
  return answered(rows, table_of(quantities), wanted, begin, at_once);
}

/// The Python class of such results; libcontact/_results.py extends it.
/// @param fields  the first one is a number
template <class Row>
py::class_<Answers<Row>> bind_answers(py::module_& m, const char* name,
                                      const Table<Row>& fields,
                                      const char* doc) {
  py::class_<Answers<Row>> type(m, name, doc);
  for (const Field<Row>& field : fields) {
    type.def_property_readonly(
        field.key.data(),
        [&field](const Answers<Row>& a) {
          return returned(detail::column(a, field));
        },
        documentation(field).c_str());
  }
  type.attr("_quantities") = detail::quantities_of(fields);
  type.def_property_readonly(
          "shape",
          [](const Answers<Row>& a) { return py::tuple(py::cast(a.shape)); },
          "Shape of the rows: that of the arguments broadcast.")
      .def(
          "_rows",
          [&fields](const Answers<Row>& a,
                    const py::array_t<std::size_t, py::array::c_style>& which) {
            return detail::taken(a, fields, which);
          })
      .def(py::pickle(
          [&fields](const Answers<Row>& a) {
            return detail::arrays_of(a, fields);
          },
          [&fields](const py::dict& arrays) {
            return detail::from_arrays(arrays, fields);
          }));
  return type;
}

template <class Row>
py::class_<Answers<Row>> bind_answers(py::module_& m, const char* name,
                                      std::span<const Quantity<Row>> quantities,
                                      const char* doc) {
  return bind_answers(m, name, table_of(quantities), doc);
}

}  // namespace contact_python
