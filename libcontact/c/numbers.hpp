#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>

/// The numbers of a struct in both languages: each_number(c, cpp, copy) of a
/// struct calls `copy` for each, one of these.
namespace contact::c {

struct ToC {
  void operator()(int& c, int cpp) const { c = cpp; }
  void operator()(double& c, double cpp) const { c = cpp; }
  /// Column by column.
  template <int n, int rows, int columns>
  void operator()(double (&c)[n],
                  const Eigen::Matrix<double, rows, columns>& cpp) const {
    static_assert(rows * columns == n);
    std::copy_n(cpp.data(), n, c);
  }
  template <std::size_t n>
  void operator()(double (&c)[n], const std::array<double, n>& cpp) const {
    std::ranges::copy(cpp, c);
  }
};

struct FromC {
  void operator()(int c, int& cpp) const { cpp = c; }
  void operator()(double c, double& cpp) const { cpp = c; }
  template <int n, int rows, int columns>
  void operator()(const double (&c)[n],
                  Eigen::Matrix<double, rows, columns>& cpp) const {
    static_assert(rows * columns == n);
    std::copy_n(c, n, cpp.data());
  }
  template <std::size_t n>
  void operator()(const double (&c)[n], std::array<double, n>& cpp) const {
    std::ranges::copy(c, cpp.begin());
  }
};

/// Results of a refused call.
struct ToNan {
  template <class Cpp>
  void operator()(int& c, const Cpp& /*cpp*/) const {
    c = 0;
  }
  template <class Cpp>
  void operator()(double& c, const Cpp& /*cpp*/) const {
    c = std::numeric_limits<double>::quiet_NaN();
  }
  template <int n, class Cpp>
  void operator()(double (&c)[n], const Cpp& /*cpp*/) const {
    std::ranges::fill(c, std::numeric_limits<double>::quiet_NaN());
  }
};

}  // namespace contact::c
