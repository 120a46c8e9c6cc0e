#include "libcontact/pair/friction_stress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "libcontact/base/check.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace contact {
namespace {

using detail::require;

bool is_finite_number(double x) { return x >= 0 && std::isfinite(x); }
bool is_positive_number(double x) { return x > 0 && std::isfinite(x); }

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
    require(is_positive_number(x[i]), place, "point", x[i], "above 0");
    require(is_finite_number(f[i]), place, "coefficient", f[i], "0 or above");
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
    if (table.curve == TableCurve::spline) set_bends();
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
  if (table.curve == TableCurve::spline) return {};
  return "friction from a table with straight lines between its points, which "
         "costs up to some 1e-3 of it";
}

// Curves that leave what is physical between good points.
[[noreturn]] void refuse_curve(const char* place, std::string_view rule) {
  throw Error(detail::must_be(
      detail::message("{}: the curve through the coefficients", place), rule));
}

// Of what falls by rounding.
constexpr double rounding = 1e-12;

}  // namespace

FrictionStress::FrictionStress(Function stress, StressOverSpeed over_speed)
    : stress_(std::make_shared<Function>(std::move(stress))),
      over_speed_(over_speed) {}

FrictionStress FrictionStress::stribeck(double static_coefficient,
                                        double dynamic_coefficient,
                                        double speed) {
  const char* const place = "stribeck friction";
  require(is_finite_number(static_coefficient), place, "static_coefficient",
          static_coefficient, "0 or above and finite");
  require(is_finite_number(dynamic_coefficient), place, "dynamic_coefficient",
          dynamic_coefficient, "0 or above and finite");
  require(is_positive_number(speed), place, "speed", speed,
          "above 0 m/s and finite");
  const double more = static_coefficient - dynamic_coefficient;
  FrictionStress made(
      [=](double p, double v) {
        return p * (dynamic_coefficient + more * std::exp(-v / speed));
      },
      more > 0   ? StressOverSpeed::falls
      : more < 0 ? StressOverSpeed::rises
                 : StressOverSpeed::constant);
  made.source_ = {.law = "stribeck",
                  .numbers = {static_coefficient, dynamic_coefficient, speed}};
  made.speed_scale_ = speed;
  return made;
}

FrictionStress FrictionStress::power(double coefficient, double pressure,
                                     double exponent) {
  const char* const place = "power friction";
  require(is_finite_number(coefficient), place, "coefficient", coefficient,
          "0 or above and finite");
  require(is_positive_number(pressure), place, "pressure", pressure,
          "above 0 Pa and finite");
  require(exponent >= 0 && exponent <= 1, place, "exponent", exponent,
          "0 to 1");
  const double scale = coefficient * pressure;
  FrictionStress made(
      [=](double p, double) {
        return scale * std::pow(p / pressure, 1 - exponent);
      },
      StressOverSpeed::constant);
  made.source_ = {.law = "power", .numbers = {coefficient, pressure, exponent}};
  return made;
}

FrictionStress FrictionStress::of_pressure(const Table& table) {
  const char* const place = "friction over pressure";
  check_table(table, place);
  Curve curve(table);
  double last = 0;
  curve.walk([&](double x, double f) {
    if (f < 0) refuse_curve(place, "0 or above");
    const double stress = std::exp(x) * f;
    if (stress < last * (1 - rounding)) {
      refuse_curve(place, "so that p f does not fall with p");
    }
    last = stress;
  });
  FrictionStress made(
      [curve = std::move(curve)](double p, double) {
        return p > 0 ? p * curve(std::log(p)) : 0;
      },
      StressOverSpeed::constant);
  made.note_ = note_of(table);
  made.source_ = {.law = "pressure_table", .table = table};
  return made;
}

FrictionStress FrictionStress::of_hersey(const Table& table) {
  const char* const place = "friction over v/p";
  check_table(table, place);
  Curve curve(table);
  // Where f over H = v/p grows, p f falls with p.
  double last = std::numeric_limits<double>::infinity();
  double last_f = table.coefficients.front();
  bool falls = false;
  curve.walk([&](double x, double f) {
    if (f < 0) refuse_curve(place, "0 or above");
    const double slope = f * std::exp(-x);
    if (slope > last * (1 + rounding)) {
      refuse_curve(place, "so that p f does not fall with p");
    }
    falls = falls || f < last_f * (1 - rounding);
    last = slope;
    last_f = f;
  });
  FrictionStress made(
      [curve = std::move(curve)](double p, double v) {
        return p > 0 ? p * curve(std::log(v / p)) : 0;
      },
      falls ? StressOverSpeed::falls : StressOverSpeed::rises);
  made.note_ = note_of(table);
  made.source_ = {.law = "hersey_table", .table = table};
  return made;
}

FrictionStress FrictionStress::at_rest() const {
  FrictionStress resting = *this;
  resting.at_rest_ = true;
  resting.over_speed_ = StressOverSpeed::constant;
  return resting;
}

}  // namespace contact
