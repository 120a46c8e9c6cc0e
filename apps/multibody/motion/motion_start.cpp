#include "multibody/motion/motion_start.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "multibody/system/kinematics.hpp"

namespace multibody {
namespace {

using Eigen::Map;
using Eigen::Matrix3d;
using Eigen::Vector3d;

void check_positive(double value, const char* name) {
  if (!(value > 0)) {
    throw contact::Error(contact::detail::must_be(
        fmt::format("motion: {} = {}", name, value), "above 0"));
  }
}

// For the dynamics a fixed carrier has prescribed accelerations: its equations
// need no solution, and hinges on it are decoupled.
void prescribe_fixed(const MotionStart& start, MotionOptions& options) {
  if (options.carrier_drive) {
    throw contact::Error(
        contact::detail::conflicts("motion: carrier_drive", "a fixed carrier"));
  }
  if (!start.carrier.velocity.isZero(0) ||
      !start.carrier.angular_velocity.isZero(0)) {
    throw contact::Error(contact::detail::must_be("start.carrier: velocity",
                                                  "0: the carrier is fixed"));
  }
  options.carrier_drive = CarrierDrive{};
}

double gap_of_ball(const HingeStop& stop, const BodyStart& start) {
  const Vector3d body = start.rotation * stop.body_direction;
  return stop.gap(std::atan2(body.cross(stop.parent_direction).norm(),
                             body.dot(stop.parent_direction)));
}

void check_stops(const System& system, const MotionStart& start,
                 const std::vector<HingeStop>& stops) {
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const auto& [body, angle, side, restitution, of_body, of_parent] = stops[k];
    const std::string place = fmt::format("stops[{}]", k);
    const auto require = [&](bool holds, const std::string& what,
                             const char* rule) {
      if (holds) return;
      throw contact::Error(contact::detail::must_be(place + "." + what, rule));
    };
    require(body >= 0 && body < system.size() &&
                system.links()[body].kind != HingeKind::none,
            fmt::format("body = {}", body), "a body with a hinge");
    const bool is_axis = system.links()[body].kind == HingeKind::axis;
    require(is_axis || (0 < angle && angle < std::numbers::pi),
            fmt::format("angle = {}", angle),
            "between 0 and pi on a ball joint");
    constexpr double unit = 1e-9;
    require(is_axis || (std::abs(of_body.norm() - 1) < unit &&
                        std::abs(of_parent.norm() - 1) < unit),
            "body_direction and parent_direction",
            "unit vectors on a ball joint");
    require(side == 1 || side == -1, fmt::format("side = {}", side), "1 or -1");
    require(restitution >= 0 && restitution <= 1,
            fmt::format("restitution = {}", restitution), "0 to 1");
    require(body >= std::ssize(start.bodies) ||
                (is_axis ? stops[k].gap(start.bodies[body].angle) >= 0
                         : gap_of_ball(stops[k], start.bodies[body]) >=
                               -cone_rounding),
            fmt::format("angle = {}", angle),
            "one that the body does not start beyond");
    for (std::size_t other = 0; other < k; ++other) {
      if (stops[other].body != body) continue;
      require(stops[other].side != side, fmt::format("side = {}", side),
              "another than that of the body's other stop");
      require(stops[other].body_direction == of_body &&
                  stops[other].parent_direction == of_parent,
              "directions", "those of the body's other stop");
    }
  }
}

BodyMotion checked_body(const BodyMotion& body, const std::string& place) {
  if (!body.position.allFinite() || !body.velocity.allFinite() ||
      !body.angular_velocity.allFinite()) {
    throw contact::Error(contact::detail::must_be(place, "finite"));
  }
  BodyMotion result = body;
  result.rotation = checked_rotation(body.rotation, place + ".rotation");
  return result;
}

// Numbers of a body on the carrier.
void put_hinged(const BodyStart& start, const Link& link,
                const std::string& place, double* to) {
  with_hinge(link.kind, [&](auto hinge) { hinge.put(start, link, place, to); });
  const Vector3d rate = relative_rate(link, to);
  if (!std::isfinite(to[0]) || !rate.allFinite()) {
    throw contact::Error(contact::detail::must_be(place, "finite"));
  }
  if (start.locked && !rate.isZero(0)) {
    throw contact::Error(contact::detail::must_be(
        place + ": relative velocity", "0 while the body is locked"));
  }
}

}  // namespace

MotionOptions checked_options(const System& system, const MotionStart& start,
                              const MotionOptions& given) {
  MotionOptions options = given;
  check_positive(options.relative_tolerance, "relative_tolerance");
  check_positive(options.absolute_tolerance, "absolute_tolerance");
  check_positive(options.step, "step");
  check_positive(options.longest_step, "longest_step");
  check_positive(options.stall_changes, "stall_changes");
  check_positive(options.stall_span, "stall_span");
  check_stops(system, start, options.stops);
  if (system.carrier().fixed) prescribe_fixed(start, options);
  return options;
}

// A ball joint that begins at a stop, and does not leave or hit it, rests there
// unless the stop would have to pull.
void begin_on_stop(int body, Equations& equations, double* s) {
  const Hinge& hinge = equations.coupled.hinge(body);
  if (hinge.is_axis || hinge.stops.empty()) return;
  for (int k = 0; k < static_cast<int>(hinge.stops.size()); ++k) {
    const HingeStop& stop = hinge.stops[k];
    if (!(std::abs(hinge.gap(stop, s)) <= cone_rounding)) continue;
    if (hinge.stop_rate(s) != 0) continue;
    hinge.cone->put_on(stop, s);
    equations.coupled.rest_on(body, k, equations.memory);
  }
}

std::vector<double> start_state(Equations& equations,
                                const MotionStart& start) {
  const System& system = equations.system;
  if (static_cast<int>(start.bodies.size()) != system.size()) {
    throw contact::Error(contact::detail::must_be(
        fmt::format("start of {} bodies", start.bodies.size()),
        fmt::format("of {}, one for each body", system.size())));
  }
  std::vector<double> state(equations.number_count());
  put_body(checked_body(start.carrier, "start.carrier"), Matrix3d::Identity(),
           state.data());
  for (int i = 0; i < system.size(); ++i) {
    const Link& link = system.links()[i];
    const BodyStart& body = start.bodies[i];
    const std::string place = fmt::format("start.bodies[{}]", i);
    double* to = &state[equations.offset(i)];
    if (link.kind == HingeKind::none) {
      put_body(checked_body(body.body, place), link.axes, to);
      equations.set_mode(i, HingeMode::released);
      continue;
    }
    put_hinged(body, link, place, to);
    begin_on_stop(i, equations, to);
    const Vector3d rate = equations.rate_of(i, state.data());
    if (body.locked) {
      equations.set_mode(i, HingeMode::locked);
    } else if (rate.isZero(0) && equations.coupled.can_rest(i, state.data())) {
      equations.set_mode(i, HingeMode::resting);
    } else {
      equations.set_mode(i, HingeMode::sliding);
      if (!rate.isZero(0)) {
        equations.memory.hinges[i].direction = rate.normalized();
      }
    }
  }
  return state;
}

}  // namespace multibody
