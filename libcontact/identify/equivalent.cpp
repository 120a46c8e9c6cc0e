#include "libcontact/identify/equivalent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/magnitude.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"
#include "libcontact/joint/presliding/stiction.hpp"

namespace contact {
namespace {

// A load and the moment that resists under it.
struct Sample {
  double load;
  double moment;
};

// x with the least of the largest |x/ratio - 1|, ratios from low to high.
LeastWrong least_wrong(double low, double high) {
  const double sum = 1 / low + 1 / high;
  return {2 / sum, (1 / low - 1 / high) / sum};
}

// The least value of a convex function of one number, by golden section: such
// functions have corners, at which parabolas do not help.
template <class Function>
LeastWrong least_of(const Function& function, double low, double high) {
  constexpr int steps = 80;  // 0.618^80 is below the last digit
  const LeastWrong at_low = {low, function(low)};
  const double share = std::numbers::phi - 1;
  double a = high - share * (high - low);
  double b = low + share * (high - low);
  double at_a = function(a);
  double at_b = function(b);
  for (int i = 0; i < steps; ++i) {
    if (at_a <= at_b) {
      high = std::exchange(b, a);
      at_b = at_a;
      a = high - share * (high - low);
      at_a = function(a);
    } else {
      low = std::exchange(a, b);
      at_a = at_b;
      b = low + share * (high - low);
      at_b = function(b);
    }
  }
  const LeastWrong found =
      at_a <= at_b ? LeastWrong{a, at_a} : LeastWrong{b, at_b};
  // At the end of the interval to rounding: at the end.
  constexpr double rounding = 1e-14;
  return at_low.largest_error <= found.largest_error + rounding ? at_low
                                                                : found;
}

// The largest |(preload + arm R)/M - 1|.
double largest_error(const std::vector<Sample>& samples, double preload,
                     double arm) {
  double largest = 0;
  for (const auto& [load, moment] : samples) {
    largest = std::max(largest, std::abs((preload + arm * load) / moment - 1));
  }
  return largest;
}

double resisting_moment(const Joint& joint, const Joint::Slip& state) {
  const JointSolution solution = joint.solve(state);
  return solution.status == Status::ok
             ? -solution.power / magnitude(state.angular_velocity)
             : std::numeric_limits<double>::quiet_NaN();
}

std::vector<Sample> samples_of(const Joint& joint,
                               std::span<const Joint::Slip> states) {
  constexpr const char* place = "equivalent friction";
  if (states.empty()) throw Error(detail::needs(place, "at least one state"));
  std::vector<Sample> samples;
  for (const Joint::Slip& state : states) {
    const double moment = resisting_moment(joint, state);
    if (!(moment > 0)) {
      throw Error(detail::needs(detail::message("{}: a reaction of {} N", place,
                                                magnitude(state.reaction)),
                                "a friction moment above 0"));
    }
    samples.push_back({magnitude(state.reaction), moment});
  }
  return samples;
}

}  // namespace

EquivalentFriction equivalent_friction(const Joint& joint,
                                       std::span<const Joint::Slip> states) {
  const std::vector<Sample> samples = samples_of(joint, states);
  const auto [least, most] = std::ranges::minmax(samples, {}, &Sample::moment);
  const auto over_load = [](const Sample& s) { return s.moment / s.load; };
  const auto [low, high] = std::ranges::minmax(samples, {}, over_load);
  // A box of three axes resists by 1 to sqrt(3) of its sides.
  const double box = joint.is_pin() ? 1 : std::numbers::sqrt3;

  EquivalentFriction e;
  e.arm = least_wrong(over_load(low), over_load(high));
  e.arm_per_axis = least_wrong(over_load(low) / box, over_load(high));
  e.moment = least_wrong(least.moment, most.moment);
  e.moment_per_axis = least_wrong(least.moment / box, most.moment);
  const auto best_arm = [&](double preload) {
    return least_of(
        [&](double arm) { return largest_error(samples, preload, arm); }, 0,
        2 * e.arm.value);
  };
  const LeastWrong preload =
      least_of([&](double p) { return best_arm(p).largest_error; }, 0,
               2 * e.moment.value);
  e.preload = preload.value;
  e.arm_with_preload = best_arm(preload.value);
  return e;
}

LeastWrong equivalent_stiction(const Joint& joint,
                               std::span<const Joint::Slip> states) {
  if (states.empty()) {
    throw Error(detail::needs("equivalent stiction", "at least one state"));
  }
  double low = std::numeric_limits<double>::infinity();
  double high = 0;
  for (const Joint::Slip& state : states) {
    const JointSolution s = joint.solve(state);
    const double way =
        stiction_deformation(joint.contact(), s.normal_force, s.half_angle);
    if (!(way > 0)) return {detail::nan, detail::nan};
    low = std::min(low, way);
    high = std::max(high, way);
  }
  return least_wrong(low, high);
}

LeastWrong equivalent_bending_arm(const JointSpec& pin,
                                  std::span<const double> forces, double reach,
                                  double arm) {
  constexpr int steps = 16;
  const FinitePin finite(pin);
  std::vector<Sample> samples;  // loads are z, moments M/(c R)
  for (const double force : forces) {
    for (int i = 0; i <= steps; ++i) {
      const double z = reach * i / steps;
      const FinitePinSolution s = finite.solve_at({force, 0}, z, 1);
      if (s.contact.status != Status::ok) {
        throw Error(detail::needs(
            detail::message("bending arm: {} N at {} m", force, z),
            "a load that the pin holds"));
      }
      samples.push_back({z, std::abs(s.moment.z()) / (arm * force)});
    }
  }
  // R_b is half the distance between the contacts of a couple; at a twentieth
  // of the length they would be one.
  const double length = pin.geometry.length();
  const LeastWrong inverse = least_of(
      [&](double k) { return largest_error(samples, 1, k); }, 0, 20 / length);
  return {1 / inverse.value, inverse.largest_error};
}

}  // namespace contact
