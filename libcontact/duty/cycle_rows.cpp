#include "libcontact/duty/duty_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "libcontact/base/text.hpp"

namespace contact {
namespace {

using Eigen::Vector3d;

// Columns of rows that are all alike repeat nothing.
bool has_range(const std::vector<Vector3d>& rows) {
  for (const Vector3d& row : rows) {
    if (row != rows.front()) return true;
  }
  return false;
}

bool ends_as_it_begins(const std::vector<Vector3d>& rows) {
  // Numbers may have been written with some digits, or turned.
  constexpr double tolerance = 1e-9;
  Vector3d least = rows.front();
  Vector3d largest = rows.front();
  for (const Vector3d& row : rows) {
    least = least.cwiseMin(row);
    largest = largest.cwiseMax(row);
  }
  const Vector3d difference = (rows.back() - rows.front()).cwiseAbs();
  return (difference.array() <= tolerance * (largest - least).array()).all();
}

bool repeats_first(const DutyCycle::Rows& rows) {
  const std::size_t count = rows.times.size();
  // Others are no cycle, which PeriodicSpline says.
  if (rows.forces.size() != count || rows.motion.size() != count) return false;
  return (has_range(rows.forces) || has_range(rows.motion)) &&
         ends_as_it_begins(rows.forces) && ends_as_it_begins(rows.motion);
}

std::optional<double> even_period(const std::vector<double>& times) {
  const double span = times.back() - times.front();
  const double step = span / static_cast<double>(times.size() - 1);
  // Times may have been rounded to some digits.
  constexpr double rounding = 1e-3;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double error = times[i] - times[i - 1] - step;
    if (!(std::abs(error) <= rounding * step)) return {};
  }
  return span + step;
}

}  // namespace

bool DutyCycle::Rows::is_steady() const {
  return !times.empty() && forces.size() == times.size() &&
         motion.size() == times.size() && !has_range(forces) &&
         !has_range(motion);
}

DutyCycle::Rows DutyCycle::Rows::filled() const {
  if (times.size() > 2 || !is_steady() ||
      !(period.value_or(0) > times.back() - times.front())) {
    return *this;  // the spline reports the error
  }
  constexpr double turn = 2 * std::numbers::pi;
  const double wanted = 8 * std::ceil(motion[0].norm() * *period / turn);
  if (!std::isfinite(wanted)) return *this;
  const double count = std::clamp(wanted, 8.0, 8000.0);
  Rows all = {{}, {}, {}, period};
  for (double i = 0; i < count; ++i) {
    all.times.push_back(times[0] + i / count * *period);
    all.forces.push_back(forces[0]);
    all.motion.push_back(motion[0]);
  }
  return all;
}

std::string DutyCycle::Rows::make_one_period() {
  if (times.size() < 2) return {};
  const double span = times.back() - times.front();
  // Times such as 0.01, 0.02, ... are rounded.
  constexpr double rounding = 1e-9;
  const bool may_repeat =
      !period || std::abs(*period - span) <= rounding * span;
  if (!may_repeat || !repeats_first(*this)) {
    if (!period) period = even_period(times);
    return {};
  }
  if (!period) period = span;
  times.pop_back();
  forces.pop_back();
  motion.pop_back();
  return detail::message(
      "the last row repeats the first and is left out: the period is {:.6g} s; "
      "give a longer period if it is a separate row",
      *period);
}

}  // namespace contact
