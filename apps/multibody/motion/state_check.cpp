#include "multibody/motion/state_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace multibody {
namespace {

using contact::detail::must_be;

void require(bool holds, const char* name, std::size_t i, double value,
             const char* rule) {
  if (holds) return;
  throw contact::Error(
      must_be(fmt::format("state.{}[{}] = {}", name, i, value), rule));
}

void check_count(const char* name, std::size_t count, std::size_t wanted) {
  if (count == wanted) return;
  throw contact::Error(must_be(fmt::format("state.{} of {}", name, count),
                               fmt::format("of {}", wanted)));
}

void check_counts(const MotionState& state, std::size_t bodies) {
  check_count("modes", state.modes.size(), bodies);
  check_count("directions", state.directions.size(), bodies);
  check_count("friction", state.friction.size(), bodies);
  check_count("straight_from", state.straight_from.size(), bodies);
  check_count("paces", state.paces.size(), bodies);
  check_count("hinge_angles", state.hinge_angles.size(), bodies);
  check_count("settle_times", state.settle_times.size(), bodies);
  check_count("rests_on", state.rests_on.size(), bodies);
  check_count("losses", state.losses.size(), bodies);
}

bool can_be(HingeMode mode, HingeKind kind, bool can_rest) {
  switch (mode) {
    case HingeMode::released:
      return true;
    case HingeMode::resting:
      return kind != HingeKind::none && can_rest;
    case HingeMode::sliding:
    case HingeMode::locked:
    case HingeMode::latched:
      return kind != HingeKind::none;
  }
  return false;
}

void check_hinge(const MotionState& state, std::size_t i, HingeKind kind,
                 bool can_rest) {
  const HingeMode mode = state.modes[i];
  require(can_be(mode, kind, can_rest), "modes", i, static_cast<int>(mode),
          "a mode of this hinge");
  const bool straight =
      !hinge_traits(kind).is_axis && mode == HingeMode::sliding;
  for (const auto& [name, value] :
       {std::pair("straight_from", state.straight_from[i]),
        std::pair("paces", state.paces[i])}) {
    require(straight || !(value > 0), name, i, value,
            "0 but where a ball joint slides");
  }
}

void check_rest(const MotionState& state, std::size_t i, const Hinge& hinge) {
  const int stop = state.rests_on[i];
  const bool can_rest = hinge.cone && state.modes[i] != HingeMode::released;
  const auto stops = static_cast<int>(hinge.stops.size());
  require(stop == -1 || (can_rest && 0 <= stop && stop < stops), "rests_on", i,
          stop, "a stop of a ball joint, or -1");
}

StateLayout layout_of(const System& system,
                      const std::vector<HingeMode>& modes) {
  std::vector<JointMode> joints;
  for (const HingeMode mode : modes) {
    joints.push_back(mode == HingeMode::released ? JointMode::released
                                                 : JointMode::turning);
  }
  return StateLayout(system, joints);
}

// Its length has no effect as long as the square is finite.
void check_quaternion(const MotionState& state, int at) {
  constexpr double longest = 1e3;
  double square = 0;
  for (int i = at; i < at + 4; ++i) square += std::pow(state.numbers[i], 2);
  const double length = std::sqrt(square);
  require(length > 1 / longest && length < longest, "numbers",
          static_cast<std::size_t>(at), length,
          "a part of a quaternion of length 1");
}

void check_finite(const char* name, const std::vector<double>& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    require(std::isfinite(numbers[i]), name, i, numbers[i], "finite");
  }
}

void check_finite(const char* name,
                  const std::vector<Eigen::Vector3d>& vectors) {
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    require(vectors[i].allFinite(), name, i, vectors[i].sum(), "finite");
  }
}

}  // namespace

void check_layout(const MotionState& state, const Equations& equations) {
  const System& system = equations.system;
  const CoupledDynamics& coupled = equations.coupled;
  const auto bodies = static_cast<std::size_t>(system.size());
  check_counts(state, bodies);
  for (std::size_t i = 0; i < bodies; ++i) {
    const Hinge& hinge = coupled.hinge(static_cast<int>(i));
    check_hinge(state, i, system.links()[i].kind,
                hinge.can_rest || (hinge.is_axis && !hinge.stops.empty()));
    check_rest(state, i, hinge);
  }
  const int beside = equations.number_count() - coupled.layout().size();
  const StateLayout layout = layout_of(system, state.modes);
  check_count("numbers", state.numbers.size(),
              static_cast<std::size_t>(layout.size() + beside));
  for (int i = 0; i < system.size(); ++i) {
    const Hinge& hinge = coupled.hinge(i);
    const double* s = &state.numbers[layout.offset(i)];
    require(state.modes[i] != HingeMode::resting || hinge.can_rest ||
                hinge.push_at(s) != 0,
            "numbers", layout.offset(i), *s, "the angle of a stop");
    if (state.rests_on[i] < 0) continue;
    // As far as tolerances let it go in a step.
    constexpr double far = 1e-3;
    const double gap = hinge.gap(hinge.stops[state.rests_on[i]], s);
    require(std::abs(gap) <= far, "numbers", layout.offset(i), *s,
            "that of a body at its stop");
  }
}

void check_numbers(const MotionState& state, const System& system) {
  if (!std::isfinite(state.time)) {
    throw contact::Error(
        must_be(fmt::format("state.time = {}", state.time), "finite"));
  }
  // 0: not known.
  if (!(state.step >= 0) || std::isinf(state.step)) {
    throw contact::Error(
        must_be(fmt::format("state.step = {}", state.step), "0 s or above"));
  }
  check_finite("numbers", state.numbers);
  check_finite("losses", state.losses);
  check_finite("directions", state.directions);
  check_finite("friction", state.friction);
  const StateLayout layout = layout_of(system, state.modes);
  check_quaternion(state, StateLayout::rotation);
  for (int i = 0; i < system.size(); ++i) {
    const auto body = static_cast<std::size_t>(i);
    for (const auto& [name, value] :
         {std::pair("straight_from", state.straight_from[body]),
          std::pair("paces", state.paces[body]),
          std::pair("settle_times", state.settle_times[body])}) {
      require(value >= 0 && std::isfinite(value), name, body, value,
              "0 or above");
    }
    // NaN where there is no axis.
    const double angle = state.hinge_angles[body];
    require(!std::isinf(angle), "hinge_angles", body, angle, "finite");
    const int quaternion =
        state.modes[body] == HingeMode::released
            ? StateLayout::rotation
            : hinge_traits(system.links()[body].kind).quaternion;
    if (quaternion >= 0) check_quaternion(state, layout.offset(i) + quaternion);
  }
}

}  // namespace multibody
