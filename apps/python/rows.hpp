#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <vector>

#include "python/interpreter_lock.hpp"

namespace contact_python {

namespace py = pybind11;

/// Whatever NumPy makes an array of numbers of.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Shape = std::vector<py::ssize_t>;

/// Arguments of an evaluation for many rows.
struct Argument {
  /// @param name   for messages
  /// @param width  how many numbers a row has, behind the others in the shape;
  ///               0: it is a number
  Argument(const char* name, const Numbers& array, int width);
  /// Three numbers that are the same for all rows.
  explicit Argument(const Eigen::Vector3d& all_rows) : data(all_rows.data()) {}

  const double* data;
  int width = 3;
  Shape shape = {};  ///< of rows
};

/// Arguments broadcast against each other by NumPy's rules, row by row.
class Rows {
 public:
  /// @throws contact::Error if the shapes do not go together
  Rows(std::initializer_list<Argument> arguments);

  const Shape& shape() const { return shape_; }
  std::size_t size() const { return size_; }

  /// Calls `row(numbers)` for each in turn, numbers[k] those of argument k,
  /// without Python's lock. Ctrl-C ends it.
  template <class Row>
  void for_each(const Row& row) const {
    Cursor cursor(*this);
    if (size_ < block) {
      for (std::size_t i = 0; i < size_; ++i, cursor.next()) row(cursor.at());
      return;
    }
    const Unlocked unlocked;
    for (std::size_t i = 0; i < size_;) {
      const std::size_t end = std::min(i + block, size_);
      for (; i < end; ++i, cursor.next()) row(cursor.at());
      heed_signals();
    }
  }

 private:
  // As many rows as nobody waits for.
  static constexpr std::size_t block = 1024;

  // Where the numbers of a row are.
  class Cursor {
   public:
    explicit Cursor(const Rows& rows);
    const double* const* at() const { return at_.data(); }
    void next();

   private:
    const Rows& rows_;
    std::vector<const double*> at_;
    Shape index_;
  };

  static void heed_signals();

  Shape shape_;
  std::size_t size_ = 1;
  std::vector<const double*> begin_;
  std::vector<Shape> strides_;  // of each argument
};

inline Eigen::Vector3d vector_at(const double* numbers) {
  return Eigen::Map<const Eigen::Vector3d>(numbers);
}

/// An array as functions return it: a number if it has no dimension.
py::object returned(const py::array& array);

/// The array of `value(numbers)` over all rows.
template <class Value>
py::object evaluate(std::initializer_list<Argument> arguments,
                    const Value& value) {
  const Rows rows(arguments);
  py::array_t<double> result(rows.shape());
  double* to = result.mutable_data();
  rows.for_each([&](const double* const* at) { *to++ = value(at); });
  return returned(result);
}

}  // namespace contact_python
