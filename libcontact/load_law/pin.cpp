#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/load_law/load_law.hpp"
#include "libcontact/load_law/minimax.hpp"
#include "libcontact/load_law/pin_formula.hpp"

namespace contact {
namespace {

using Eigen::ArrayXd;
using Form = PinLoadLaw::Form;

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
  const double number =
      form == Form::adhesion
          ? -solved(pin, load, 1).friction_moment.z()
          : contact.sum_of_pressures(load, contact.half_angle(load).half_angle);
  return detail::checked(number / load, load);
}

// The numbers of a pin at some loads, and how a law has them: by powers of x
// times `factor`, with `known` for c0 or none.
struct Nodes {
  ArrayXd load, x, factor, sum;
  std::vector<double> known = {};
};

Nodes nodes_of(const Joint& pin, const PinLoadLaw& law) {
  const auto at = [&](double load) { return number_at(pin, law.form, load); };
  const auto [low, high] = law.loads;
  const ArrayXd t = detail::nodes(300);
  if (law.form == Form::interference) {
    const ArrayXd u =
        t * std::sqrt(1 - law.scale / std::max(high, 2 * law.scale));
    const ArrayXd load = law.scale / (1 - u.square());
    const ArrayXd number = load.unaryExpr(at);
    const double least = at(law.scale);
    return {load, 2 * u - 1, u.square() / number, 1 - least / number, {least}};
  }
  const ArrayXd load = (std::log(low) + t * std::log(high / low)).exp();
  return {load, 2 * t - 1, load.unaryExpr(at).inverse(),
          ArrayXd::Ones(t.size())};
}

void fit(const Nodes& nodes, double unit, int count, PinLoadLaw& law) {
  double least = std::numeric_limits<double>::infinity();
  const int scales = law.form == Form::clearance ? 40 : 1;
  for (int i = 0; i < scales; ++i) {
    const double scale = unit * 0.03 * std::pow(100, i / 39.0);
    const ArrayXd x = scales == 1 ? nodes.x : nodes.load / (nodes.load + scale);
    const auto best = detail::minimax_fit(
        detail::powers(x, count - int(nodes.known.size()), nodes.factor),
        nodes.sum);
    if (!(best.error < least)) continue;
    least = best.error;
    if (scales > 1) law.scale = scale;
    law.numbers = nodes.known;
    law.numbers.insert(law.numbers.end(), best.numbers.begin(),
                       best.numbers.end());
  }
}

// A state of the pin, by which a law is compared.
struct State {
  double load, f, moment;
};

// At all speeds if the coefficient changes with them.
std::vector<State> states_of(const Joint& pin, const PinLoadLaw& law) {
  const FrictionStress* stress = pin.contact().stress();
  std::vector<double> rates = {1};
  if (stress != nullptr) {
    const double rate = stress->speed_scale() / law.radius;
    rates = {0.03 * rate, rate, 10 * rate};
  }
  const auto [low, high] = law.loads;
  constexpr int steps = 2000;
  std::vector<State> all;
  for (const double rate : rates) {
    for (int i = 0; i < steps; ++i) {
      const double load = low * std::pow(high / low, (i + 0.5) / steps);
      const JointSolution exact = solved(pin, load, rate);
      all.push_back({load, exact.friction_force.norm() / exact.normal_force,
                     -exact.friction_moment.z()});
    }
  }
  return all;
}

void measure(const std::vector<State>& states, PinLoadLaw& law) {
  law.error = law.float_error = 0;
  for (const auto& [load, f, moment] : states) {
    law.error =
        std::max(law.error,
                 std::abs(detail::pin_moment(law, load, f).first / moment - 1));
    const double single = detail::pin_moment(law, float(load), float(f)).first;
    law.float_error = std::max(law.float_error, std::abs(single / moment - 1));
  }
}

}  // namespace

PinLoadLaw pin_load_law(const Joint& pin, double error,
                        const std::optional<std::pair<double, double>>& loads) {
  const FrictionStress* stress = pin.contact().stress();
  const FrictionLaw dry = detail::dry_friction(pin);
  // f has to be a factor.
  detail::require(pin.is_pin() && (stress ? stress->source().law == "stribeck"
                                          : dry.coefficient() > 0),
                  "the load law of a pin",
                  "a pin with dry friction, with a coefficient above 0, or "
                  "Stribeck's law");
  const JointContact& contact = pin.contact();
  const bool sticks = dry.adhesion() > 0;
  const double unit = unit_force(contact);
  PinLoadLaw law;
  law.form = sticks                       ? Form::adhesion
             : contact.has_interference() ? Form::interference
                                          : Form::clearance;
  law.radius = contact.geometry().radius();
  if (law.form == Form::interference) law.scale = unit;
  // A clearance needs no data that depend on the range of loads.
  law.loads = detail::loads_of_endless(pin, loads, unit, sticks ? 1e-3 : 1e-6,
                                       sticks ? 10 : 1e4);
  const Nodes nodes = nodes_of(pin, law);
  const std::vector<State> all = states_of(pin, law);
  double best = std::numeric_limits<double>::infinity();
  for (const int count : {4, 6, 8, 10, 12}) {
    fit(nodes, unit, count, law);
    measure(all, law);
    if (law.error <= error) return law;
    best = std::min(best, law.error);
  }
  throw detail::out_of_reach(error, best);
}

}  // namespace contact
