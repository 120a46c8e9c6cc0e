#pragma once

#include <limits>

#include "libcontact/tracking/follower_lanes.hpp"

// What is asked of all joints. Part of follower_kernel_impl.hpp.

namespace contact::detail {
namespace {

// What the acting moment misses.
[[gnu::always_inline]] inline Vector miss_of(const Packet& p) {
  return get(p, Row::moment_x, Row::moment_y, Row::moment_z) -
         get(p, Row::acting_x, Row::acting_y, Row::acting_z);
}
// What M_t has done since the acting moment last changed.
[[gnu::always_inline]] inline Vector answered(const Packet& p,
                                              const Vector& miss,
                                              const Vector& action) {
  return miss - get(p, Row::missed_x, Row::missed_y, Row::missed_z) + action;
}

// The largest numbers of the joints followed, NaN as infinity.
class Largest {
 public:
  explicit Largest(double floor) : floor_(floor) {}

  [[gnu::always_inline]] void add(const Packet& p) {
    const auto none = p[Row::followed] == 0.0;
    const auto raise = [&](Lanes& most, const Lanes& x) {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      most = max(
          most, select(none, Lanes(0.0), select(x >= 0.0, x, Lanes(infinity))));
    };
    raise(reach_, p[Row::reach]);
    raise(shift_, p[Row::shift]);
    raise(error_, p[Row::error]);
    const Vector moment = get(p, Row::moment_x, Row::moment_y, Row::moment_z);
    const Vector action = get(p, Row::action_x, Row::action_y, Row::action_z);
    const Vector miss = miss_of(p);
    const Vector answer = answered(p, miss, action);
    const Lanes inverse = 1.0 / (4.0 * dot(moment, moment) + floor_);
    raise(miss_, dot(miss, miss) * inverse);
    raise(moved_, dot(action, action) * inverse);
    raise(answered_, dot(answer, answer) * inverse);
  }
  FollowerLargest result() const {
    return {hmax(reach_), hmax(shift_), hmax(error_),
            hmax(miss_),  hmax(moved_), hmax(answered_)};
  }

 private:
  double floor_;
  Lanes reach_ = 0.0, shift_ = 0.0, error_ = 0.0;
  Lanes miss_ = 0.0, moved_ = 0.0, answered_ = 0.0;
};

[[gnu::flatten]] FollowerLargest largest(FollowerRows rows, int size,
                                         double floor) {
  Largest most(floor);
  for (int i = 0; i < size; i += width) most.add(Packet(rows, i));
  return most.result();
}

}  // namespace
}  // namespace contact::detail
