#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <initializer_list>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "python/interpreter_lock.hpp"

namespace contact_python {

namespace py = pybind11;

/// Floats, integers and booleans of any shape, in one piece. An array of
/// doubles that lies so is not copied.
class Numbers
    : public py::array_t<double, py::array::c_style | py::array::forcecast> {
 public:
  Numbers() : array_t(py::handle(), stolen_t{}) {}
  /// Throws Python's TypeError for other arrays, such as text, dates, complex
  /// numbers and masks, and NumPy's own error for other objects.
  explicit Numbers(py::handle given);
};
using Shape = std::vector<py::ssize_t>;

/// Arguments of an evaluation for many rows.
struct Argument {
  /// @param name   for messages
  /// @param width  how many numbers a row has, behind the others in the shape;
  ///               0: it is a number
  Argument(const char* name, const Numbers& array, int width);
  /// Three numbers that are the same for all rows.
  explicit Argument(const Eigen::Vector3d& all_rows) : data(all_rows.data()) {}
  /// Numbers of our own.
  Argument(const double* numbers, int row_width, Shape of_rows)
      : data(numbers), width(row_width), shape(std::move(of_rows)) {}
  /// Matrices of three by three, behind the others in the shape.
  static Argument matrix(const char* name, const Numbers& array);

  const double* data;
  int width = 3;
  Shape shape = {};  ///< shape of the rows
};

/// Arguments broadcast against each other by NumPy's rules, row by row.
class Rows {
 public:
  /// @throws contact::Error if the shapes do not go together
  explicit Rows(const std::vector<Argument>& arguments);
  Rows(std::initializer_list<Argument> arguments)
      : Rows(std::vector<Argument>(arguments)) {}

  const Shape& shape() const { return shape_; }
  std::size_t size() const { return size_; }
  /// Rows between two checks for Ctrl-C (takes well under 0.1 s).
  static constexpr std::size_t block = 1024;

  /// Calls `row(numbers)` for each in turn, numbers[k] from argument k, without
  /// Python's lock. Ctrl-C ends it.
  /// @param at_once  rows between two looks; below `block` the rows are slow
  template <class Row>
  void for_each(const Row& row, std::size_t at_once = block) const {
    Cursor cursor(*this);
    if (size_ < at_once && at_once == block) {
      for (std::size_t i = 0; i < size_; ++i, cursor.next()) row(cursor.at());
      return;
    }
    const Unlocked unlocked;
    for (std::size_t i = 0; i < size_;) {
      const std::size_t end = std::min(i + at_once, size_);
      for (; i < end; ++i, cursor.next()) row(cursor.at());
      heed_signals();
    }
  }
  /// Throws for Ctrl-C; where Python's lock has been let go.
  static void heed_signals();

  /// The same on several threads, or as many of them as the system starts:
  /// each `at_once` rows have a function `begin()(numbers, i)` of their own, i
  /// the number of the row.
  template <class Begin>
  void for_each(int threads, const Begin& begin,
                std::size_t at_once = block) const;

 private:
  // Places of the numbers of a row.
  class Cursor {
   public:
    /// At row `begin`.
    explicit Cursor(const Rows& rows, std::size_t begin = 0);
    const double* const* at() const { return at_.data(); }
    void next();

   private:
    const Rows& rows_;
    std::vector<const double*> at_;
    Shape index_;
  };

  Shape shape_;
  std::size_t size_ = 1;
  std::vector<const double*> begin_;
  std::vector<Shape> strides_;  // strides of each argument
};

template <class Begin>
void Rows::for_each(int threads, const Begin& begin,
                    std::size_t at_once) const {
  const std::size_t blocks = (size_ + at_once - 1) / at_once;
  const auto used = std::min(static_cast<std::size_t>(threads), blocks);
  if (used <= 1) {
    auto row = begin();
    std::size_t i = 0;
    for_each([&](const double* const* at) { row(at, i++); }, at_once);
    return;
  }
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex of_failure;
  const auto work = [&](bool is_caller) {
    try {
      for (std::size_t i; (i = next.fetch_add(at_once)) < size_;) {
        auto row = begin();
        Cursor cursor(*this, i);
        const std::size_t end = std::min(i + at_once, size_);
        for (; i < end; ++i, cursor.next()) row(cursor.at(), i);
        if (is_caller) heed_signals();
      }
    } catch (...) {
      const std::lock_guard lock(of_failure);
      failure = std::current_exception();
      next = size_;
    }
  };
  {
    const Unlocked unlocked;
    std::vector<std::jthread> others;
    try {
      for (std::size_t k = 1; k < used; ++k) others.emplace_back(work, false);
    } catch (const std::system_error&) {
      // The others do the work.
    }
    work(true);
  }
  if (failure) std::rethrow_exception(failure);
}

inline Eigen::Vector3d vector_at(const double* numbers) {
  return Eigen::Map<const Eigen::Vector3d>(numbers);
}

/// An array as functions return it: a number if it has no dimension.
py::object returned(const py::array& array);

/// Destination of numbers, and number of threads that share the rows: the
/// arguments `out` and `threads` of functions of one quantity.
struct Wanted {
  py::object out = py::none();
  int threads = 1;

  /// @throws contact::Error if there are none
  void check() const;
};

namespace detail {

/// Memory of an array in which results are put.
/// @param name  for messages
/// @throws contact::Error if it is of another type, shape or order of memory
void* memory_of(const std::string& name, const py::object& array,
                const py::dtype& type, const Shape& shape);

}  // namespace detail

/// The array of `value(numbers)` over all rows, of numbers or vectors.
template <class Value>
py::object evaluate(std::initializer_list<Argument> arguments,
                    const Value& value, const Wanted& wanted = {}) {
  constexpr bool is_vector = !std::is_arithmetic_v<decltype(value(nullptr))>;
  wanted.check();
  const Rows rows(arguments);
  Shape shape = rows.shape();
  if (is_vector) shape.push_back(3);
  const bool is_given = !wanted.out.is_none();
  const py::object array = is_given ? wanted.out : py::array_t<double>(shape);
  double* const to = static_cast<double*>(
      detail::memory_of("out", array, py::dtype::of<double>(), shape));
  rows.for_each(wanted.threads, [&] {
    return [&](const double* const* at, std::size_t i) {
      if constexpr (is_vector) {
        Eigen::Map<Eigen::Vector3d>(to + 3 * i) = value(at);
      } else {
        to[i] = value(at);
      }
    };
  });
  return is_given ? array : returned(array);
}

}  // namespace contact_python

/// Arguments of functions.
template <>
struct pybind11::detail::type_caster<contact_python::Numbers> {
  PYBIND11_TYPE_CASTER(contact_python::Numbers, const_name("array of numbers"));
  bool load(handle given, bool /*convert*/) {
    value = contact_python::Numbers(given);
    return true;
  }
};
