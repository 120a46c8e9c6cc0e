#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/load_law/load_law.hpp"
#include "libcontact/load_law/minimax.hpp"
#include "libcontact/load_law/pin_formula.hpp"

namespace contact {
namespace {

using Eigen::VectorXd;

constexpr const char* place = "the load law of a pin";

double adhesion_of(const JointContact& contact) {
  const auto* dry = std::get_if<FrictionLaw>(&contact.friction());
  return dry == nullptr ? 0 : dry->adhesion();
}

// f has to be a factor.
void check_friction(const Joint& pin) {
  const JointContact& contact = pin.contact();
  const FrictionStress* stress = contact.stress();
  const auto* dry = std::get_if<FrictionLaw>(&contact.friction());
  if (!pin.is_pin() ||
      !(stress != nullptr ? stress->source().law == "stribeck"
                          : dry != nullptr && dry->coefficient() > 0)) {
    throw Error(
        detail::needs(place,
                      "a pin with dry friction, with a coefficient above 0, or "
                      "Stribeck's law"));
  }
}

// A load at which halves pressed into each other part, or else at which the
// contact has become large.
double unit_force(const JointContact& contact) {
  const double lift = contact.lift_off_force();
  if (lift > 0) return lift;
  const double per_force = contact.load_parameter(1);
  return std::isfinite(per_force) ? 1 / per_force : 1;
}

Joint::Slip state(double load, double rate) {
  return {{load, 0, 0}, {0, 0, rate}, {0, 0, 1}};
}

double solved_moment(const Joint& pin, double load) {
  return -pin.solve(state(load, 1)).friction_moment.z();
}

// The values of a function at some loads.
template <class Function>
VectorXd sampled(const VectorXd& loads, const Function& function) {
  return loads.unaryExpr([&](double load) {
    const double value = function(load);
    if (std::isfinite(value)) return value;
    throw Error(detail::needs(
        fmt::format("{}: a load of {} N", place, load),
        "a half-angle law and a pressure law that have a value there"));
  });
}

// S.
double pressures_over_load(const JointContact& contact, double normal_force) {
  const double half_angle = contact.half_angle(normal_force).half_angle;
  return contact.sum_of_pressures(normal_force, half_angle) / normal_force;
}

// Columns 1, x, x^2, ..., times y.
Eigen::MatrixXd powers(const VectorXd& x, const VectorXd& y, int count) {
  Eigen::MatrixXd a(x.size(), count);
  a.col(0) = y;
  for (int i = 1; i < count; ++i) a.col(i) = a.col(i - 1).cwiseProduct(x);
  return a;
}

// Points of (-1, 1), denser at its ends.
VectorXd nodes(int count) {
  return VectorXd::NullaryExpr(count, [=](Eigen::Index i) {
    return -std::cos(std::numbers::pi * (double(i) + 0.5) / count);
  });
}

std::vector<double> numbers_of(const VectorXd& x) {
  return {x.begin(), x.end()};
}

constexpr int points = 300;

void fit_clearance(const JointContact& contact, int count, PinLoadLaw& law) {
  const double unit = unit_force(contact);
  const VectorXd load = (std::log(law.loads.first) +
                         (nodes(points).array() + 1) / 2 *
                             std::log(law.loads.second / law.loads.first))
                            .exp();
  const VectorXd sum =
      sampled(load, [&](double n) { return pressures_over_load(contact, n); });
  double least = std::numeric_limits<double>::infinity();
  constexpr int steps = 40;
  for (int i = 0; i < steps; ++i) {
    const double scale = unit * 0.03 * std::pow(100, i / (steps - 1.0));
    const VectorXd u = load.array() / (load.array() + scale);
    const auto fit = detail::minimax_fit(powers(u, sum.cwiseInverse(), count),
                                         VectorXd::Ones(points));
    if (!(fit.error < least)) continue;
    least = fit.error;
    law.scale = scale;
    law.numbers = numbers_of(fit.numbers);
  }
}

void fit_interference(const JointContact& contact, int count, PinLoadLaw& law) {
  law.scale = contact.lift_off_force();
  const double least = pressures_over_load(contact, law.scale);
  const double most = std::max(law.loads.second, 2 * law.scale);
  const VectorXd u =
      (nodes(points).array() + 1) / 2 * std::sqrt(1 - law.scale / most);
  const VectorXd load = law.scale / (1 - u.array().square());
  const VectorXd sum =
      sampled(load, [&](double n) { return pressures_over_load(contact, n); });
  const auto fit = detail::minimax_fit(
      powers(2 * u.array() - 1, u.array().square() / sum.array(), count - 1),
      1 - least / sum.array());
  law.numbers = numbers_of(fit.numbers);
  law.numbers.insert(law.numbers.begin(), least);
}

void fit_adhesion(const Joint& pin, int count, PinLoadLaw& law) {
  const auto [low, high] = law.loads;
  const double middle = std::log(low * high) / 2;
  const double half = std::log(high / low) / 2;
  const VectorXd t = nodes(points);
  const VectorXd load = (middle + half * t.array()).exp();
  const VectorXd arm = sampled(
      load, [&](double force) { return solved_moment(pin, force) / force; });
  const auto fit = detail::minimax_fit(powers(t, arm.cwiseInverse(), count),
                                       VectorXd::Ones(points));
  law.numbers = numbers_of(fit.numbers);
}

void fit(const Joint& pin, int count, PinLoadLaw& law) {
  switch (law.form) {
    case PinLoadLaw::Form::clearance:
      return fit_clearance(pin.contact(), count, law);
    case PinLoadLaw::Form::interference:
      return fit_interference(pin.contact(), count, law);
    case PinLoadLaw::Form::adhesion:
      return fit_adhesion(pin, count, law);
  }
}

// Loads of the law if none are given: what a clearance needs is known for all.
std::pair<double, double> usual_loads(const JointContact& contact) {
  const double unit = unit_force(contact);
  return adhesion_of(contact) > 0 ? std::pair(1e-3 * unit, 10 * unit)
                                  : std::pair(1e-6 * unit, 1e4 * unit);
}

// Rates about which a coefficient is compared: all of it if it changes.
std::vector<double> rates(const JointContact& contact) {
  const FrictionStress* stress = contact.stress();
  if (stress == nullptr) return {1};
  const double rate = stress->speed_scale() / contact.geometry().radius();
  return {0.03 * rate, rate, 10 * rate};
}

// The largest errors.
void measure(const Joint& pin, PinLoadLaw& law) {
  const auto [low, high] = law.loads;
  constexpr int steps = 2000;
  law.error = law.float_error = 0;
  for (const double rate : rates(pin.contact())) {
    for (int i = 0; i < steps; ++i) {
      const double load = low * std::pow(high / low, (i + 0.5) / steps);
      const JointSolution exact = pin.solve(state(load, rate));
      const double f = exact.friction_force.norm() / exact.normal_force;
      const auto off = [&](double moment) {
        return std::abs(moment / -exact.friction_moment.z() - 1);
      };
      law.error =
          std::max(law.error, off(detail::pin_moment(law, load, f).first));
      law.float_error =
          std::max(law.float_error,
                   off(detail::pin_moment(law, float(load), float(f)).first));
    }
  }
}

}  // namespace

PinLoadLaw pin_load_law(const Joint& pin, double error,
                        const std::optional<std::pair<double, double>>& loads) {
  check_friction(pin);
  detail::check_endless(pin);
  const JointContact& contact = pin.contact();
  PinLoadLaw law;
  law.loads = loads.value_or(usual_loads(contact));
  detail::check_loads(law.loads.first, law.loads.second);
  law.radius = contact.geometry().radius();
  law.form = adhesion_of(contact) > 0     ? PinLoadLaw::Form::adhesion
             : contact.has_interference() ? PinLoadLaw::Form::interference
                                          : PinLoadLaw::Form::clearance;
  double best = std::numeric_limits<double>::infinity();
  for (const int count : {4, 6, 8, 10, 12}) {
    fit(pin, count, law);
    measure(pin, law);
    if (law.error <= error) return law;
    best = std::min(best, law.error);
  }
  throw detail::out_of_reach(error, best);
}

}  // namespace contact
