// Friction stresses by a table of coefficients, over p or v/p.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "libcontact/base/check.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/pair/stress_registry.hpp"

namespace contact {
namespace detail {

extern constexpr StressEntry pressure_table_stress = {
    .name = "pressure_table",
    .meaning = "p f(p)",
    .points = "pressures",
    .points_unit = "Pa",
    .make = [](std::span<const double>, const FrictionStress::Table& table) {
      return FrictionStress::of_pressure(table);
    }};

extern constexpr StressEntry hersey_table_stress = {
    .name = "hersey_table",
    .meaning = "p f(v/p)",
    .points = "speeds_over_pressure",
    .points_unit = "m_per_s_Pa",
    .make = [](std::span<const double>, const FrictionStress::Table& table) {
      return FrictionStress::of_hersey(table);
    }};

}  // namespace detail

namespace {

using detail::is_above_zero;
using detail::is_not_negative;
using detail::require;

void check_table(const FrictionStress::Table& table, const char* place) {
  const auto fail = [&](std::string_view what, std::string_view rule) {
    throw Error(detail::must_be(detail::message("{}: {}", place, what), rule));
  };
  const auto& [x, f, curve] = table;
  if (x.size() < 2 || x.size() != f.size()) {
    fail(detail::message("{} points and {} coefficients", x.size(), f.size()),
         "as many of both, 2 or more");
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    require(is_above_zero(x[i]), place, "point", x[i], "above 0");
    require(is_not_negative(f[i]), place, "coefficient", f[i], "0 or above");
    if (i == 0 || x[i] > x[i - 1]) continue;
    fail(detail::message("point = {}", x[i]),
         detail::message("above {}, the point before it", x[i - 1]));
  }
}

// f over ln x.
class Curve {
 public:
  explicit Curve(const FrictionStress::Table& table)
      : f_(table.coefficients), bend_(f_.size()) {
    for (const double x : table.points) x_.push_back(std::log(x));
    if (table.curve == FrictionStress::Table::Curve::spline) set_bends();
  }

  double operator()(double logarithm) const {
    if (!(logarithm > x_.front())) return f_.front();
    if (logarithm >= x_.back()) return f_.back();
    const auto to = static_cast<std::size_t>(
        std::upper_bound(x_.begin(), x_.end(), logarithm) - x_.begin());
    const std::size_t from = to - 1;
    const double step = x_[to] - x_[from];
    const double b = (logarithm - x_[from]) / step;
    const double a = 1 - b;
    return a * f_[from] + b * f_[to] -
           a * b * step * step / 6 *
               ((1 + a) * bend_[from] + (1 + b) * bend_[to]);
  }

  // Visits ln x and f at the points and between them.
  template <class Visit>
  void walk(const Visit& visit) const {
    constexpr int parts = 16;
    for (std::size_t i = 1; i < x_.size(); ++i) {
      for (int k = 0; k < parts; ++k) {
        const double x = x_[i - 1] + k * (x_[i] - x_[i - 1]) / parts;
        visit(x, (*this)(x));
      }
    }
    visit(x_.back(), f_.back());
  }

 private:
  // Second derivatives, 0 at the ends: elimination in a band of three.
  void set_bends() {
    const std::size_t n = x_.size();
    std::vector<double> diagonal(n, 1);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const double before = x_[i] - x_[i - 1];
      const double after = x_[i + 1] - x_[i];
      const double share = i == 1 ? 0 : before / diagonal[i - 1];
      diagonal[i] = 2 * (before + after) - share * before;
      bend_[i] =
          6 * ((f_[i + 1] - f_[i]) / after - (f_[i] - f_[i - 1]) / before) -
          share * bend_[i - 1];
    }
    for (std::size_t i = n - 1; i-- > 1;) {
      bend_[i] = (bend_[i] - (x_[i + 1] - x_[i]) * bend_[i + 1]) / diagonal[i];
    }
  }

  std::vector<double> x_;  // ln
  std::vector<double> f_;
  std::vector<double> bend_;
};

std::string note_of(const FrictionStress::Table& table) {
  if (table.curve == FrictionStress::Table::Curve::spline) return {};
  return "friction from a table with straight lines between its points is off "
         "by up to some 1e-3";
}

// Curves that leave what is physical between good points.
[[noreturn]] void refuse_curve(const char* place, std::string_view rule) {
  throw Error(detail::must_be(
      detail::message("{}: the curve through the coefficients", place), rule));
}

// Relative fall that is rounding.
constexpr double rounding = 1e-12;

}  // namespace

FrictionStress FrictionStress::of_pressure(const Table& table) {
  const char* const place = "friction over pressure";
  check_table(table, place);
  Curve curve(table);
  double last = 0;
  curve.walk([&](double x, double f) {
    if (f < 0) refuse_curve(place, "0 or above");
    const double stress = std::exp(x) * f;
    if (stress < last * (1 - rounding)) {
      refuse_curve(place, "one whose friction stress p f does not fall with p");
    }
    last = stress;
  });
  FrictionStress made(
      [curve = std::move(curve)](double p, double) {
        return p > 0 ? p * curve(std::log(p)) : 0;
      },
      OverSpeed::constant);
  made.note_ = note_of(table);
  made.source_ = {.law = std::string(detail::pressure_table_stress.name),
                  .table = table};
  return made;
}

FrictionStress FrictionStress::of_hersey(const Table& table) {
  const char* const place = "friction over v/p";
  check_table(table, place);
  Curve curve(table);
  // p f falls with p where f/H grows, H = v/p.
  double last = std::numeric_limits<double>::infinity();
  double last_f = table.coefficients.front();
  bool falls = false;
  curve.walk([&](double x, double f) {
    if (f < 0) refuse_curve(place, "0 or above");
    const double slope = f * std::exp(-x);
    if (slope > last * (1 + rounding)) {
      refuse_curve(place, "one whose friction stress p f does not fall with p");
    }
    falls = falls || f < last_f * (1 - rounding);
    last = slope;
    last_f = f;
  });
  FrictionStress made(
      [curve = std::move(curve)](double p, double v) {
        return p > 0 ? p * curve(std::log(v / p)) : 0;
      },
      falls ? OverSpeed::falls : OverSpeed::rises);
  made.note_ = note_of(table);
  made.source_ = {.law = std::string(detail::hersey_table_stress.name),
                  .table = table};
  return made;
}

}  // namespace contact
