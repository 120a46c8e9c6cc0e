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

/// Contiguous floats, integers and booleans of any shape. A contiguous array of
/// doubles is not copied.
class Numbers
    : public py::array_t<double, py::array::c_style | py::array::forcecast> {
 public:
  Numbers() : array_t(py::handle(), stolen_t{}) {}
  /// Throws Python's TypeError for other arrays, such as text, dates, complex
  /// numbers and masked arrays, and NumPy's own error for other objects.
  explicit Numbers(py::handle given);
};
using Shape = std::vector<py::ssize_t>;

/// An argument of an evaluation for many rows.
struct Argument {
  /// @param name   for messages
  /// @param width  numbers in each row, the last dimension of the shape; 0:
  ///               each row is a single number
  Argument(const char* name, const Numbers& array, int width);
  /// Three numbers that are equal for all rows.
  explicit Argument(const Eigen::Vector3d& all_rows) : data(all_rows.data()) {}
  /// Numbers owned by the caller in C++.
  Argument(const double* numbers, int row_width, Shape of_rows)
      : data(numbers), width(row_width), shape(std::move(of_rows)) {}
  /// 3 x 3 matrices in the last two dimensions.
  static Argument matrix(const char* name, const Numbers& array);

  const double* data;
  int width = 3;
  Shape shape = {};  ///< shape of the rows
};

/// Broadcasts arguments against each other by NumPy's rules, row by row.
class Rows {
 public:
  /// @throws contact::Error if the shapes cannot be broadcast
  explicit Rows(const std::vector<Argument>& arguments);
  Rows(std::initializer_list<Argument> arguments)
      : Rows(std::vector<Argument>(arguments)) {}

  const Shape& shape() const { return shape_; }
  std::size_t size() const { return size_; }
  /// Rows between two checks for Ctrl-C (takes well under 0.1 s).
  static constexpr std::size_t block = 1024;

  /// Calls `row(numbers)` for each row in turn, numbers[k] from argument k,
  /// without Python's lock. Ctrl-C ends it.
  /// @param at_once  rows between two checks; set it below `block` for slow
  ///                 rows
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
  /// Throws for Ctrl-C; call without Python's lock.
  static void heed_signals();

  /// As above on several threads, or as many as the system starts. Each
  /// `at_once` rows use their own function `begin()(numbers, i)`, where i is
  /// the index of the row.
  template <class Begin>
  void for_each(int threads, const Begin& begin,
                std::size_t at_once = block) const;

 private:
  // Pointers to the numbers of a row.
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
      // The other threads do the work.
    }
    work(true);
  }
  if (failure) std::rethrow_exception(failure);
}

inline Eigen::Vector3d vector_at(const double* numbers) {
  return Eigen::Map<const Eigen::Vector3d>(numbers);
}

/// The array as a return value: a scalar if it has no dimension.
py::object returned(const py::array& array);

/// Destination of numbers, and number of threads that share the rows: the
/// arguments `out` and `threads` of functions with a single quantity.
struct Wanted {
  py::object out = py::none();
  int threads = 1;

  /// @throws contact::Error for a number of threads below 1
  void check() const;
};

namespace detail {

/// Memory of an array that receives results.
/// @param name  for messages
/// @throws contact::Error for another type, shape or memory order
void* memory_of(const std::string& name, const py::object& array,
                const py::dtype& type, const Shape& shape);

}  // namespace detail

/// Evaluates `value(numbers)` over all rows; returns an array of numbers or
/// vectors.
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
