#pragma once

// Included by follower_kernel_impl.hpp: once per instruction set. What brings
// the acting moments together with M_t.

#include "libcontact/tracking/follower_largest.hpp"

namespace contact::detail {
namespace {

// Newton's step of every joint for itself, its slope by Broyden's update.
constexpr double action_rounding = 1e-20;  // of squares
constexpr double strongest = 0.1;          // slope, squared
[[gnu::flatten]] void act(FollowerRows rows, int size) {
  for_packets(rows, size, [](const Packet& p) {
    const Vector moment = get(p, Row::moment_x, Row::moment_y, Row::moment_z);
    const Vector acting = get(p, Row::acting_x, Row::acting_y, Row::acting_z);
    const Vector miss = moment - acting;
    const Vector last = get(p, Row::action_x, Row::action_y, Row::action_z);
    Vector x = get(p, Row::answer_xx, Row::answer_yx, Row::answer_zx);
    Vector y = get(p, Row::answer_xy, Row::answer_yy, Row::answer_zy);
    Vector z = get(p, Row::answer_xz, Row::answer_yz, Row::answer_zz);
    const auto times = [&](const Vector& v) {
      return v.x * x + v.y * y + v.z * z;
    };
    const Vector answer = answered(p, miss, last);
    const Lanes square = dot(last, last);
    const auto tells = square > action_rounding * dot(moment, moment) &&
                       dot(answer, answer) < strongest * square;
    const Lanes share =
        select(tells, 1.0 / select(tells, square, Lanes(1.0)), Lanes(0.0));
    const Vector wrong = share * (answer - times(last));
    x = x + last.x * wrong;
    y = y + last.y * wrong;
    z = z + last.z * wrong;
    set(p, Row::answer_xx, x);
    set(p, Row::answer_xy, y);
    set(p, Row::answer_xz, z);
    // 1/(1 - slope) to the second power.
    const Vector more = times(miss);
    const Vector all = more + times(more);
    const Lanes safe = select(dot(all, all) < strongest * dot(miss, miss),
                              Lanes(1.0), Lanes(0.0));
    // Who reads lanes without a joint finds nothing there.
    const auto none = p[Row::followed] == 0.0;
    const Vector step = miss + safe * all;
    const Vector action{select(none, Lanes(0.0), step.x),
                        select(none, Lanes(0.0), step.y),
                        select(none, Lanes(0.0), step.z)};
    set(p, Row::action_x, action);
    set(p, Row::missed_x, miss);
    set(p, Row::acting_x, acting + action);
  });
}

[[gnu::flatten]] void remember(FollowerRows rows, int size) {
  for_packets(rows, size, [](const Packet& p) {
    const Vector acting = get(p, Row::acting_x, Row::acting_y, Row::acting_z);
    set(p, Row::stretch_x,
        acting - get(p, Row::kept_x, Row::kept_y, Row::kept_z));
    set(p, Row::kept_x, acting);
  });
}

[[gnu::flatten]] void extrapolate(FollowerRows rows, int size, double share) {
  for_packets(rows, size, [&](const Packet& p) {
    set(p, Row::acting_x,
        get(p, Row::kept_x, Row::kept_y, Row::kept_z) +
            Lanes(share) *
                get(p, Row::stretch_x, Row::stretch_y, Row::stretch_z));
  });
}

}  // namespace
}  // namespace contact::detail
