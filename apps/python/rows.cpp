#include "python/rows.hpp"

#include <string>
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

}  // namespace

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

Rows::Rows(std::initializer_list<Argument> arguments) {
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
  for (const auto length : shape_) size_ *= length;
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

Rows::Cursor::Cursor(const Rows& rows)
    : rows_(rows), at_(rows.begin_), index_(rows.shape_.size(), 0) {}

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
