#include "separation/simulation/touches.hpp"

#include <algorithm>
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

template <class Visit>
void Touches::for_pairs(int event, int body, const Visit& visit) const {
  const auto& pairs = case_.events[event].pairs;
  const auto has = [body](const WatchedPair& pair) {
    return pair.a == 1 + body || pair.b == 1 + body;
  };
  const bool any = std::ranges::any_of(pairs, has);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!any || has(pairs[i])) visit(pairs[i], i);
  }
}

double Touches::condition(int event, int body, const History& history,
                          const MotionSample& sample) const {
  double highest = -History::not_yet;
  double unwatched = -1;
  for_pairs(event, body, [&](const WatchedPair& pair, std::size_t i) {
    const double time = sample.time();
    if (time > history.time_of(pair.end, pair, case_)) return;
    if (time < history.time_of(pair.begin, pair, case_)) {
      unwatched = 1;
      return;
    }
    const double near = case_.events[event].value -
                        of_events_[event].distance(i, sample.motions());
    highest = std::max(highest, near);
  });
  return std::isinf(highest) ? unwatched : highest;
}

double Touches::speed(int event, int body, const MotionSample& sample) const {
  double highest = 0;
  for_pairs(event, body, [&](const WatchedPair& pair, std::size_t) {
    highest = std::max(
        highest, speed_bound(sample.motions()[pair.a], sample.motions()[pair.b],
                             reach(case_.rigid_body(pair.b).shapes)));
  });
  return highest;
}

// Derivative of third order from distances before: those of the event may be
// off by the tolerance of the steps.
double Touches::approach(int event, int body, const History& history,
                         const multibody::Motion& motion) const {
  const MotionSample& sample = motion.sample();
  std::vector<BodyMotion> bodies(sample.motions().begin(),
                                 sample.motions().end());
  double nearest = History::not_yet;
  double result = 0;
  for_pairs(event, body, [&](const WatchedPair& pair, std::size_t i) {
    if (!history.is_on(pair, sample.time(), case_)) return;
    const double now = of_events_[event].distance(i, sample.motions());
    if (!(now < nearest)) return;
    nearest = now;
    // So long a way is far above the rounding of distances.
    constexpr double way = 1e-3;  // m
    const double step = std::min((sample.time() - motion.step_begin()) / 4,
                                 way / speed(event, body, sample));
    if (!(step > 0)) return;
    constexpr std::array weights{-26., 57., -42., 11.};
    result = 0;
    for (int k = 0; k < 4; ++k) {
      for (const int of : {pair.a, pair.b}) {
        bodies[of] = motion.place_back(of, sample.time() - (k + 1) * step);
      }
      result += weights[k] / (6 * step) * of_events_[event].distance(i, bodies);
    }
  });
  return result;
}

}  // namespace separation
