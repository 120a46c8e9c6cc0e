#include "python/rows/rows.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "python/answers.hpp"

namespace contact_python {
namespace {

std::string text_of(const Shape& shape) {
  std::string text = "(";
  for (const auto length : shape) text += std::to_string(length) + ", ";
  if (shape.size() > 1) text.resize(text.size() - 2);
  if (shape.size() == 1) text.pop_back();
  return text + ")";
}

// True for contiguous doubles and no subclass, whose values may mean more.
bool is_plain(py::handle given) {
  return Py_TYPE(given.ptr()) == py::detail::npy_api::get().PyArray_Type_ &&
         py::isinstance<py::array_t<double, py::array::c_style>>(given);
}

bool is_masked(py::handle given) {
  return py::isinstance<py::array>(given) &&
         py::isinstance(given,
                        py::module_::import("numpy.ma").attr("MaskedArray"));
}

// True for quantities of pint or astropy, alone or in a list; NumPy would take
// their numbers and ignore the unit.
bool has_unit(py::handle given) {
  if (PyFloat_CheckExact(given.ptr()) || PyLong_CheckExact(given.ptr())) {
    return false;
  }
  if (py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given)) {
    const auto all = py::reinterpret_borrow<py::sequence>(given);
    return std::any_of(all.begin(), all.end(),
                       [](const py::object& one) { return has_unit(one); });
  }
  return py::hasattr(given, "to") &&
         ((py::hasattr(given, "magnitude") && py::hasattr(given, "units")) ||
          (py::hasattr(given, "value") && py::hasattr(given, "unit")));
}

// NumPy's default conversion.
py::array natural(py::handle given) {
  const auto from_any = py::detail::npy_api::get().PyArray_FromAny_;
  auto array = py::reinterpret_steal<py::array>(
      from_any(given.ptr(), nullptr, 0, 0, 0, nullptr));
  if (!array) throw py::error_already_set();
  return array;
}

py::object numbers_of(py::handle given) {
  if (is_plain(given)) return py::reinterpret_borrow<py::object>(given);
  if (is_masked(given)) {
    throw py::type_error(contact::detail::must_be(
        "a masked array", "filled or compressed: its mask would be ignored"));
  }
  if (has_unit(given)) {
    throw py::type_error(
        contact::detail::must_be("a quantity with a unit",
                                 "a number in the unit of the argument, as by "
                                 "load.to(\"N\").magnitude"));
  }
  py::array array = natural(given);
  if (std::string_view("fiub").find(array.dtype().kind()) ==
      std::string_view::npos) {
    throw py::type_error(contact::detail::must_be(
        "an array of " + std::string(py::str(py::object(array.dtype()))),
        "of floats, integers or booleans"));
  }
  return array;
}

}  // namespace

Numbers::Numbers(py::handle given) : array_t(numbers_of(given)) {}

Argument::Argument(const char* name, const Numbers& array, int row_width)
    : data(array.data()),
      width(row_width),
      shape(array.shape(), array.shape() + array.ndim()) {
  if (width == 0) return;
  if (shape.empty() || shape.back() != width) {
    throw contact::Error(contact::detail::must_be(
        name + (" of shape " + text_of(shape)),
        "of shape (..., " + std::to_string(width) + ")"));
  }
  shape.pop_back();
}

Argument Argument::matrix(const char* name, const Numbers& array) {
  Shape shape(array.shape(), array.shape() + array.ndim());
  if (shape.size() < 2 || shape.back() != 3 || shape.end()[-2] != 3) {
    throw contact::Error(contact::detail::must_be(
        name + (" of shape " + text_of(shape)), "of shape (..., 3, 3)"));
  }
  shape.resize(shape.size() - 2);
  return {array.data(), 9, std::move(shape)};
}

Rows::Rows(const std::vector<Argument>& arguments) {
  for (const Argument& argument : arguments) {
    if (argument.shape.size() > shape_.size()) {
      shape_.insert(shape_.begin(), argument.shape.size() - shape_.size(), 1);
    }
    const auto first = shape_.end() - argument.shape.size();
    for (std::size_t d = 0; d < argument.shape.size(); ++d) {
      const auto length = argument.shape[d];
      if (first[d] == 1) first[d] = length;
      if (length == 1 || length == first[d]) continue;
      throw contact::Error(
          contact::detail::must_be("arguments of " + text_of(shape_) + " and " +
                                       text_of(argument.shape) + " rows",
                                   "of shapes that broadcast together"));
    }
  }
  py::ssize_t size = 1;
  for (const auto length : shape_) {
    if (!__builtin_mul_overflow(size, length, &size)) continue;
    throw contact::Error(contact::detail::must_be(
        "arguments of " + text_of(shape_) + " rows together",
        "of fewer rows than memory has bytes"));
  }
  size_ = static_cast<std::size_t>(size);
  for (const Argument& argument : arguments) {
    begin_.push_back(argument.data);
    Shape strides(shape_.size(), 0);
    py::ssize_t stride = std::max(argument.width, 1);
    for (std::size_t d = argument.shape.size(); d-- > 0;) {
      const auto length = argument.shape[d];
      if (length != 1)
        strides[strides.size() - argument.shape.size() + d] = stride;
      stride *= length;
    }
    strides_.push_back(std::move(strides));
  }
}

Rows::Cursor::Cursor(const Rows& rows, std::size_t begin)
    : rows_(rows), at_(rows.begin_), index_(rows.shape_.size(), 0) {
  if (begin == 0) return;
  for (std::size_t d = index_.size(); d-- > 0;) {
    const auto length = static_cast<std::size_t>(rows.shape_[d]);
    index_[d] = static_cast<py::ssize_t>(begin % length);
    begin /= length;
    for (std::size_t k = 0; k < at_.size(); ++k)
      at_[k] += rows.strides_[k][d] * index_[d];
  }
}

void Rows::Cursor::next() {
  for (std::size_t d = index_.size(); d-- > 0;) {
    const auto length = rows_.shape_[d];
    const bool is_last = ++index_[d] == length;
    for (std::size_t k = 0; k < at_.size(); ++k) {
      const auto stride = rows_.strides_[k][d];
      at_[k] += is_last ? stride * (1 - length) : stride;
    }
    if (!is_last) return;
    index_[d] = 0;
  }
}

void Rows::heed_signals() {
  const Locked locked;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

py::object returned(const py::array& array) {
  return array.ndim() == 0 ? array[py::tuple()] : py::object(array);
}

std::vector<std::string> detail::chosen_names(const Fields& names,
                                              const Out& out) {
  if (names && out) {
    throw contact::Error(contact::detail::must_be(
        "fields", "left out: out names the quantities"));
  }
  if (names) {
    if (const auto* one = std::get_if<std::string>(&*names)) return {*one};
    const auto& several = std::get<std::vector<std::string>>(*names);
    for (auto name = several.begin(); name != several.end(); ++name) {
      if (std::find(several.begin(), name, *name) == name) continue;
      throw contact::Error(contact::detail::duplicate("field", *name));
    }
    return several;
  }
  std::vector<std::string> all;
  for (const auto& item : *out) all.push_back(item.first.cast<std::string>());
  return all;
}

void detail::refuse_field(const std::string& name,
                          std::vector<std::string> known) {
  throw contact::Error(contact::detail::unknown("quantity", name, known));
}

void Wanted::check() const {
  if (threads >= 1) return;
  throw contact::Error(contact::detail::must_be(
      "threads = " + std::to_string(threads), "1 or more"));
}

void* detail::memory_of(const std::string& name, const py::object& array,
                        const py::dtype& type, const Shape& shape) {
  if (py::isinstance<py::array>(array)) {
    auto to = py::reinterpret_borrow<py::array>(array);
    if (to.dtype().equal(type) && to.writeable() &&
        (to.flags() & py::array::c_style) != 0 &&
        Shape(to.shape(), to.shape() + to.ndim()) == shape) {
      return to.mutable_data();
    }
  }
  throw contact::Error(contact::detail::must_be(
      name, "a writable array of " + std::string(py::str(py::object(type))) +
                " of shape " + text_of(shape) + " in the order of C"));
}

void detail::protect(py::array& array) {
  py::detail::array_proxy(array.ptr())->flags &=
      ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
}

py::array detail::rows_of(const py::array& array,
                          const py::array_t<std::size_t>& which,
                          bool is_vector) {
  const py::object flat =
      is_vector ? array.attr("reshape")(-1, 3) : array.attr("ravel")();
  return py::array(flat[which]);
}

void detail::refuse_pickled(const char* name, const py::dtype& type,
                            const std::optional<Shape>& rows, bool is_vector) {
  std::string rule = "an array of " + std::string(py::str(py::object(type)));
  if (rows) {
    Shape shape = *rows;
    if (is_vector) shape.push_back(3);
    rule += " of shape " + text_of(shape);
  }
  throw contact::Error(
      contact::detail::must_be(std::string("the pickle's ") + name, rule));
}

void detail::refuse_pickled_names(const py::dict& arrays) {
  throw contact::Error(contact::detail::must_be(
      "the pickle's names",
      py::str(", ").attr("join")(arrays).cast<std::string>()));
}

}  // namespace contact_python
