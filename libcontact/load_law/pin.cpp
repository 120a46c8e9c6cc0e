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

using Eigen::ArrayXd;
using Form = PinLoadLaw::Form;

constexpr const char* place = "the load law of a pin";

// f has to be a factor.
void check_friction(const Joint& pin) {
  const FrictionStress* stress = pin.contact().stress();
  if (pin.is_pin() &&
      (stress != nullptr ? stress->source().law == "stribeck"
                         : detail::dry_friction(pin).coefficient() > 0)) {
    return;
  }
  throw Error(detail::needs(place,
                            "a pin with dry friction, with a coefficient above "
                            "0, or Stribeck's law"));
}

// A load at which halves pressed into each other part, or else at which the
// contact has become large.
double unit_force(const JointContact& contact) {
  const double lift = contact.lift_off_force();
  if (lift > 0) return lift;
  const double per_force = contact.load_parameter(1);
  return std::isfinite(per_force) ? 1 / per_force : 1;
}

JointSolution solved(const Joint& pin, double load, double rate) {
  return pin.solve({{load, 0, 0}, {0, 0, rate}, {0, 0, 1}});
}

// S, or M/R with adhesion.
double number_at(const Joint& pin, Form form, double load) {
  const JointContact& contact = pin.contact();
  const double value = form == Form::adhesion
                           ? -solved(pin, load, 1).friction_moment.z() / load
                           : contact.sum_of_pressures(
                                 load, contact.half_angle(load).half_angle) /
                                 load;
  if (std::isfinite(value)) return value;
  throw Error(detail::needs(
      fmt::format("{}: a load of {} N", place, load),
      "a half-angle law and a pressure law that have a value there"));
}

void fit(const Joint& pin, int count, PinLoadLaw& law) {
  constexpr int points = 300;
  const ArrayXd t = 2 * detail::nodes(points) - 1;
  const auto [low, high] = law.loads;
  const auto at = [&](double load) { return number_at(pin, law.form, load); };
  const double unit = unit_force(pin.contact());
  if (law.form == Form::interference) {
    law.scale = unit;
    const double least = at(unit);
    const ArrayXd u =
        (t + 1) / 2 * std::sqrt(1 - unit / std::max(high, 2 * unit));
    const ArrayXd sum = (unit / (1 - u.square())).unaryExpr(at);
    const auto best = detail::minimax_fit(
        detail::powers(2 * u - 1, count - 1, u.square() / sum),
        1 - least / sum);
    law.numbers = {least};
    law.numbers.insert(law.numbers.end(), best.numbers.begin(),
                       best.numbers.end());
    return;
  }
  const ArrayXd load =
      (std::log(low) + (t + 1) / 2 * std::log(high / low)).exp();
  const ArrayXd number = load.unaryExpr(at);
  const int scales = law.form == Form::adhesion ? 1 : 40;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < scales; ++i) {
    const double scale =
        scales == 1 ? 0 : unit * 0.03 * std::pow(100, i / 39.0);
    const ArrayXd x = scales == 1 ? t : load / (load + scale);
    const auto one = detail::minimax_fit(
        detail::powers(x, count, number.inverse()), ArrayXd::Ones(points));
    if (!(one.error < least)) continue;
    least = one.error;
    law.scale = scale;
    law.numbers = {one.numbers.begin(), one.numbers.end()};
  }
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
      const JointSolution exact = solved(pin, load, rate);
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
  const bool sticks = detail::dry_friction(pin).adhesion() > 0;
  PinLoadLaw law;
  // Pins with a clearance need no range: one law holds for all loads.
  law.loads = detail::loads_of(loads, unit_force(contact), sticks ? 1e-3 : 1e-6,
                               sticks ? 10 : 1e4);
  law.radius = contact.geometry().radius();
  law.form = sticks                       ? Form::adhesion
             : contact.has_interference() ? Form::interference
                                          : Form::clearance;
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
