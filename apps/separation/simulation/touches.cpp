#include "separation/simulation/touches.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <utility>

#include "separation/clearance/pair_way.hpp"

namespace separation {

using multibody::BodyMotion;
using multibody::MotionSample;

Clearance clearance_of(const Case& c, const std::vector<WatchedPair>& pairs) {
  std::vector<std::vector<Shape>> shapes;
  for (std::size_t i = 0; i <= c.bodies.size(); ++i) {
    shapes.push_back(c.rigid_body(static_cast<int>(i)).shapes);
  }
  std::vector<Clearance::Pair> of;
  for (const WatchedPair& pair : pairs) {
    of.push_back({pair.a, pair.b, pair.a_shapes, pair.b_shapes});
  }
  return {shapes, std::move(of)};
}

Touches::Touches(const Case& c) : case_(c) {
  for (const Event& event : c.events) {
    of_events_.push_back(clearance_of(c, event.pairs));
  }
}

std::vector<int> Touches::pairs_of(int event, int body) const {
  const auto& pairs = case_.events[event].pairs;
  std::vector<int> own, all;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    all.push_back(static_cast<int>(i));
    if (pairs[i].a == 1 + body || pairs[i].b == 1 + body) {
      own.push_back(static_cast<int>(i));
    }
  }
  return own.empty() ? all : own;
}

double Touches::condition(int event, int pair, const History& history,
                          const MotionSample& sample) const {
  const WatchedPair& watched = case_.events[event].pairs[pair];
  const double time = sample.time();
  if (time > history.time_of(watched.end, watched, case_)) return -1;
  if (time < history.time_of(watched.begin, watched, case_)) return 1;
  return case_.events[event].value -
         of_events_[event].distance(pair, sample.motions());
}

double Touches::speed(int event, int pair, const MotionSample& sample) const {
  const WatchedPair& watched = case_.events[event].pairs[pair];
  return speed_bound(sample.motions()[watched.a], sample.motions()[watched.b],
                     reach(case_.rigid_body(watched.b).shapes));
}

// Derivative of third order from the distances at earlier positions, which are
// extrapolated by the present velocities: positions of the run may deviate by
// the tolerance of its steps.
double Touches::approach(int event, int pair,
                         const MotionSample& sample) const {
  // Far above the rounding of distances.
  constexpr double way = 1e-3;  // m
  const double step = way / speed(event, pair, sample);
  if (!std::isfinite(step)) return 0;
  const WatchedPair& watched = case_.events[event].pairs[pair];
  std::vector<BodyMotion> bodies(sample.motions().begin(),
                                 sample.motions().end());
  const auto distance = [&](double back) {
    for (const int of : {watched.a, watched.b}) {
      const BodyMotion& now = sample.motions()[of];
      const double rate = now.angular_velocity.norm();
      bodies[of].position = now.position - back * now.velocity;
      if (rate == 0) continue;
      bodies[of].rotation =
          Eigen::AngleAxisd(-back * rate, now.angular_velocity / rate) *
          now.rotation;
    }
    return of_events_[event].distance(pair, bodies);
  };
  constexpr std::array weights{-26., 57., -42., 11.};
  double result = 0;
  for (int k = 0; k < 4; ++k) {
    result += weights[k] / (6 * step) * distance((k + 1) * step);
  }
  return result;
}

}  // namespace separation
