#pragma once

// Included once by each follower_kernel_*.cpp, which is compiled for its own
// instruction set.

#include "libcontact/tracking/follower_largest.hpp"

namespace contact::detail {
namespace {

// The kernel's functions are flattened: they call so many small ones that the
// compiler's limits on the growth of a file would leave some of them out.

// Where the last solution's responses lead, and what is missing there.
struct Guess {
  Lanes tangent;
  Triangle triangle;
  Move move;
  Lanes inverse_slope;  // of the residual
  Lanes step;           // in ln tan psi, to the root by the slopes
  Lanes largest;        // of all moves
};
[[gnu::always_inline]] inline Guess guess_of(const Packet& p, const Frame& f) {
  const Lanes reaction =
      log_of_growth(f.reaction * p[Row::last_inverse_reaction] - 1.0);
  const Lanes angle =
      f.sine * p[Row::last_cosine] - f.cosine * p[Row::last_sine];
  const Lanes speed = log_ratio(f.speed, p[Row::last_speed]);
  const Lanes step = p[Row::tangent_by_along] * reaction +
                     p[Row::tangent_by_tilt] * angle +
                     speed * p[Row::inverse_slope];
  Guess g;
  g.tangent = p[Row::last_tangent] * exponential(step);
  g.triangle = triangle_of(g.tangent, f);
  g.move = move_of(p, f, g.triangle);
  const Slopes friction = friction_slopes(p);
  const Lanes bend = useful(p, bend_of(p, g.move));
  // ln f/cos a
  const Lanes expected =
      along(friction, g.move) + p[Row::friction_curve] * bend + speed;
  g.inverse_slope = 1.0 / residual_slope(g.triangle, friction);
  g.step = (expected - step - p[Row::last_residual]) * g.inverse_slope;
  // All series are good for small moves only.
  g.largest =
      larger(larger(abs(reaction) + abs(angle), abs(step)),
             larger(abs(g.move.force) + abs(g.move.cosine), abs(g.step)));
  return g;
}

// M_t and its slopes at the solution `t`.
//   M_t = -rho R_n ((Y C^2 + Z S^2) w + S C (Z - Y) d),  C, S = cos a, sin a,
//   d = p cos psi + s q sin psi
[[gnu::always_inline]] inline void set_moment(const Packet& p, const Frame& f,
                                              const Triangle& t,
                                              const Lanes& inverse_slope,
                                              const Lanes& sliding,
                                              const Lanes& spinning) {
  const Slopes friction = friction_slopes(p);
  const Slopes y = sliding_slopes(p);
  const Slopes z = spinning_slopes(p);
  const Lanes scale = -p[Row::radius] * f.reaction * t.cos_g;
  const Lanes side = p[Row::side];
  const Lanes c2 = t.axis_cosine * t.axis_cosine;
  const Lanes s2 = t.axis_sine * t.axis_sine;
  const Lanes sc = f.sign * t.axis_sine * t.axis_cosine;
  const Lanes difference = spinning - sliding;
  const Lanes length = sliding * c2 + spinning * s2;
  const Lanes across = sc * difference;
  const Vector d = t.cos_psi * f.p + side * t.sin_psi * f.q;
  const Vector turned = t.cos_psi * f.q + -side * t.sin_psi * f.p;
  const Vector moment = scale * (length * f.w + across * d);
  set(p, Row::base_x, moment);
  set(p, Row::moment_x, moment);

  // R grows by a factor, b and tan psi grow: what R_n, a, Y and Z do.
  const Lanes sin2_psi = t.sin_psi * t.sin_psi;
  const Lanes inverse_g = 1.0 / t.cos_g;
  const Lanes inverse_g2 = inverse_g * inverse_g;
  const Lanes b_force = f.sine * f.cosine * sin2_psi * inverse_g2;
  const Lanes b_cosine = 2.0 * f.cosine * f.inverse_sine * inverse_g2;
  const auto grow = [&](const Lanes& reaction, const Lanes& angle,
                        const Lanes& tangent, Row by_x, Row sine) {
    const Lanes cos_g = -b_force * angle - sin2_psi * c2 * tangent;
    const Move move{reaction + cos_g,
                    b_cosine * angle - 2.0 * sin2_psi * s2 * tangent};
    const Lanes d_sliding = sliding * along(y, move);
    const Lanes d_spinning = spinning * along(z, move);
    const Lanes d_length =
        d_sliding * c2 + d_spinning * s2 - difference * (c2 * move.cosine);
    // sin a = cos b/cos g.
    const Lanes d_s = -(f.sine * inverse_g) * angle - t.axis_sine * cos_g;
    const Lanes d_sc =
        f.sign * (d_s * t.axis_cosine +
                  t.axis_sine * t.axis_cosine * (0.5 * move.cosine));
    const Lanes d_across = sc * (d_spinning - d_sliding) + d_sc * difference;
    const Lanes d_psi = t.sin_psi * t.cos_psi * tangent;
    set(p, by_x,
        scale * ((d_length + move.force * length) * f.w +
                 (d_across + move.force * across) * d +
                 side * across * d_psi * turned));
    if (sine != Row::count) p.set(sine, d_s);
    return move;
  };
  const Lanes one(1.0), none(0.0);
  const Lanes by_along = friction.force * inverse_slope;
  const Lanes by_tilt =
      (friction.cosine * b_cosine - friction.force * b_force) * inverse_slope;
  p.set(Row::tangent_by_along, by_along);
  p.set(Row::tangent_by_tilt, by_tilt);
  const Move m_along =
      grow(one, none, by_along, Row::by_along_x, Row::sine_by_along);
  const Move m_tilt =
      grow(none, one, by_tilt, Row::by_tilt_x, Row::sine_by_tilt);
  const Move m_tangent = grow(none, none, one, Row::by_tangent_x, Row::count);
  p.set(Row::force_by_along, m_along.force);
  p.set(Row::cosine_by_along, m_along.cosine);
  p.set(Row::force_by_tilt, m_tilt.force);
  p.set(Row::cosine_by_tilt, m_tilt.cosine);
  p.set(Row::force_by_tangent, m_tangent.force);
  p.set(Row::cosine_by_tangent, m_tangent.cosine);
  set(p, Row::by_turn_x, scale * across * turned);
  const Lanes y_scale = scale * sliding;
  const Lanes z_scale = scale * spinning;
  set(p, Row::by_sliding_x, y_scale * (c2 * f.w + -sc * d));
  set(p, Row::by_spinning_x, z_scale * (s2 * f.w + sc * d));
  p.set(Row::sliding_share, sliding * t.axis_cosine);
  p.set(Row::spinning_share, spinning * t.axis_sine);

  const Lanes inverse = f.inverse_reaction;
  set(p, Row::along_x, inverse * (f.sign * f.cosine * f.w + f.sine * f.p));
  set(p, Row::tilt_x,
      (p[Row::ball] * inverse) * (f.cosine * f.p + -(f.sign * f.sine) * f.w));
  set(p, Row::turn_x, inverse * f.inverse_sine * f.q);
  p.set(Row::sensitivity, f.inverse_sine);
  p.set(Row::inverse_slope, inverse_slope);
  p.set(Row::sin_psi, t.sin_psi);
}

template <class F>
[[gnu::always_inline]] inline void for_packets(FollowerRows rows, int size,
                                               F f) {
  for (int i = 0; i < size; i += width) f(Packet(rows, i));
}

// What M_t answers to parts x and y of the acting moment that come back in R.
[[gnu::always_inline]] inline void set_feedback(const Packet& p) {
  const Lanes s = p[Row::feedback];
  const auto none = s == 0.0;
  if (all_of(none)) return;
  const auto answer = [&](Row to, const Lanes& by, Row along, Row tilt,
                          Row turn) __attribute__((always_inline)) {
    const Vector v =
        by *
        (p[along] * get(p, Row::by_along_x, Row::by_along_y, Row::by_along_z) +
         p[tilt] * get(p, Row::by_tilt_x, Row::by_tilt_y, Row::by_tilt_z) +
         p[turn] * get(p, Row::by_turn_x, Row::by_turn_y, Row::by_turn_z));
    const auto next = [to](int k) {
      return static_cast<Row>(static_cast<int>(to) + k);
    };
    p.set(next(0), select(none, p[next(0)], v.x));
    p.set(next(1), select(none, p[next(1)], v.y));
    p.set(next(2), select(none, p[next(2)], v.z));
  };
  answer(Row::answer_xx, s, Row::along_y, Row::tilt_y, Row::turn_y);
  answer(Row::answer_xy, -s, Row::along_x, Row::tilt_x, Row::turn_x);
}

[[gnu::flatten]] FollowerLargest predict(FollowerRows rows, int size,
                                         double floor) {
  Largest most(floor);
  for_packets(rows, size, [&](const Packet& p) {
    const Frame f = frame_of(p);
    Guess g = guess_of(p, f);
    Triangle& t = g.triangle;
    const Lanes sin2 = t.sin_psi * t.sin_psi * g.step;
    const Move move{g.move.force - sin2 * t.axis_cosine * t.axis_cosine,
                    g.move.cosine - 2.0 * sin2 * t.axis_sine * t.axis_sine};
    step_on(t, g.step);
    const Lanes bend = useful(p, bend_of(p, move));
    set_moment(p, f, t, g.inverse_slope,
               p[Row::sliding] * f.speed *
                   exponential(along(sliding_slopes(p), move) +
                               p[Row::sliding_curve] * bend),
               p[Row::spinning] * f.speed *
                   exponential(along(spinning_slopes(p), move) +
                               p[Row::spinning_curve] * bend));
    set_feedback(p);
    // No answer to the acting moment.
    set(p, Row::missed_x, miss_of(p));
    p.set(Row::place_x, p[Row::reaction_x]);
    p.set(Row::place_y, p[Row::reaction_y]);
    p.set(Row::place_z, p[Row::reaction_z]);
    p.set(Row::place_reaction, f.reaction);
    p.set(Row::place_sine, f.sine);
    p.set(Row::place_cosine, f.cosine);
    p.set(Row::place_speed, f.speed);
    p.set(Row::tangent, g.tangent * (1.0 + g.step));
    p.set(Row::force, f.reaction * t.cos_g);
    p.set(Row::axis_sine, t.axis_sine);
    p.set(Row::axis_cosine, t.axis_cosine);
    p.set(Row::force_move, move.force);
    p.set(Row::cosine_move, move.cosine);
    p.set(Row::evaluated_error, t.sin_psi * g.step * g.step);
    p.set(Row::reach,
          larger(g.largest * (1 / FollowerReach::move),
                 p[Row::sensitivity] * (1 / FollowerReach::inverse_sine)));
    for (const Row row :
         {Row::along, Row::tilt, Row::evaluated_along, Row::evaluated_tilt,
          Row::shift, Row::action_x, Row::action_y, Row::action_z}) {
      p.set(row, Lanes(0.0));
    }
    most.add(p);
  });
  return most.result();
}

[[gnu::always_inline]] inline void extend(const Packet& p) {
  const Vector change{p[Row::reaction_x] - p[Row::place_x],
                      p[Row::reaction_y] - p[Row::place_y],
                      p[Row::reaction_z] - p[Row::place_z]};
  const Lanes along =
      dot(change, get(p, Row::along_x, Row::along_y, Row::along_z));
  const Lanes tilt = dot(change, get(p, Row::tilt_x, Row::tilt_y, Row::tilt_z));
  const Lanes turn = dot(change, get(p, Row::turn_x, Row::turn_y, Row::turn_z));
  p.set(Row::along, along);
  p.set(Row::tilt, tilt);
  set(p, Row::moment_x,
      get(p, Row::base_x, Row::base_y, Row::base_z) +
          along * get(p, Row::by_along_x, Row::by_along_y, Row::by_along_z) +
          tilt * get(p, Row::by_tilt_x, Row::by_tilt_y, Row::by_tilt_z) +
          turn * get(p, Row::by_turn_x, Row::by_turn_y, Row::by_turn_z));
  const Lanes shift = abs(along) + abs(tilt) * p[Row::sensitivity] + abs(turn);
  p.set(Row::shift, shift);
  const Lanes since =
      abs(along - p[Row::evaluated_along]) +
      2.0 * p[Row::sensitivity] * abs(tilt - p[Row::evaluated_tilt]);
  p.set(Row::error,
        p[Row::evaluated_error] + p[Row::slope_error] * since + shift * shift);
}
[[gnu::flatten]] FollowerLargest extend(FollowerRows rows, int size,
                                        double floor) {
  Largest most(floor);
  for_packets(rows, size, [&](const Packet& p) {
    extend(p);
    most.add(p);
  });
  return most.result();
}

// sin a and cos a of contacts are taken at least so large: what is divided by
// them tends to a constant.
constexpr double smallest = 1e-150;

// The polynomial of the window: even and odd powers side by side.
[[gnu::always_inline]] inline Lanes window_value(const Packet& p, Row first,
                                                 const Lanes& place) {
  const auto coefficient = [&](int k) {
    return p[static_cast<Row>(static_cast<int>(first) + k)];
  };
  constexpr int last = FollowerWindow::size - 1;
  static_assert(last % 2 == 1);
  const Lanes square = place * place;
  Lanes even = coefficient(last - 1);
  Lanes odd = coefficient(last);
#pragma GCC unroll 8
  for (int k = last - 3; k >= 0; k -= 2) {
    even = even * square + coefficient(k);
    odd = odd * square + coefficient(k + 1);
  }
  return even + place * odd;
}

[[gnu::flatten]] bool approach(FollowerRows rows, int size) {
  bool asks = false;
  for_packets(rows, size, [&](const Packet& p) {
    extend(p);
    const Lanes along = p[Row::along];
    const Lanes tilt = p[Row::tilt];
    const auto moved = [&](Row by_along, Row by_tilt) {
      return p[by_along] * along + p[by_tilt] * tilt;
    };
    const Lanes force = moved(Row::force_by_along, Row::force_by_tilt);
    const Lanes cosine = moved(Row::cosine_by_along, Row::cosine_by_tilt);
    const Lanes evaluated_force = p[Row::force] * (1.0 + force);
    p.set(Row::evaluated_force, evaluated_force);
    p.set(Row::evaluated_axis_cosine,
          max(p[Row::axis_cosine] * (1.0 + 0.5 * cosine), Lanes(smallest)));
    p.set(Row::evaluated_axis_sine,
          max(p[Row::axis_sine] + moved(Row::sine_by_along, Row::sine_by_tilt),
              Lanes(smallest)));
    p.set(Row::force_move, p[Row::force_move] + force);
    p.set(Row::cosine_move, p[Row::cosine_move] + cosine);
    p.set(Row::evaluated_along, along);
    p.set(Row::evaluated_tilt, tilt);

    const Lanes place =
        (evaluated_force - p[Row::window_middle]) * p[Row::window_scale];
    p.set(Row::window_place, place);
    const Lanes value_1 = window_value(p, Row::window_1, place);
    const Lanes value_2 = window_value(p, Row::window_2, place);
    p.set(Row::half_angle_sin, value_1);
    p.set(Row::half_angle_cos, value_2);
    p.set(Row::found_friction, value_1);
    p.set(Row::found_sliding, value_2);
    p.set(Row::found_spinning, Lanes(0.0));
    const auto known =
        abs(place) <= 1.0 && (p[Row::ball] == 0.0 || p[Row::plain] != 0.0);
    asks = asks || any_of(p[Row::followed] != 0.0 && !known);
  });
  return asks;
}

// What was found at the contacts; of plain joints by (3.7), (3.8).
struct Found {
  Lanes friction, sliding, spinning;
};
[[gnu::always_inline]] inline Found found_in(const Packet& p) {
  const auto plain = p[Row::plain] != 0.0;
  const Lanes pressure = p[Row::pressure_part];
  const Lanes area = p[Row::area_part] * p[Row::last_inverse_force];
  const Lanes over_cosine = p[Row::last_inverse_axis_cosine];
  const auto value = [&](Row given, Row coefficient, Row area_integral,
                         const Lanes& over) {
    return select(plain,
                  (pressure * p[coefficient] + area * p[area_integral]) * over,
                  p[given]);
  };
  return {
      value(Row::found_friction, Row::integral_force, Row::integral_force_area,
            over_cosine),
      value(Row::found_sliding, Row::integral_sliding,
            Row::integral_sliding_area, over_cosine),
      value(Row::found_spinning, Row::integral_spinning,
            Row::integral_spinning_area, 1.0 / p[Row::evaluated_axis_sine])};
}

// Broyden's update. Slopes below this move, or of a miss so large, say
// nothing.
constexpr double shortest = 1e-8;
constexpr double largest_miss = 0.1;

[[gnu::flatten]] FollowerLargest settle(FollowerRows rows, int size,
                                        double floor) {
  Largest most(floor);
  for_packets(rows, size, [&](const Packet& p) {
    p.set(Row::last_inverse_force, 1.0 / p[Row::evaluated_force]);
    p.set(Row::last_inverse_axis_cosine, 1.0 / p[Row::evaluated_axis_cosine]);
    const Move move{p[Row::force_move], p[Row::cosine_move]};
    const Lanes square = move.force * move.force + move.cosine * move.cosine;
    const auto tells = square > shortest * shortest;
    const Lanes inverse = 1.0 / select(tells, square, Lanes(1.0));
    const Lanes inverse_length = sqrt(inverse);
    const Bend bend = bend_of(p, move);
    const Lanes expected_bend = useful(p, bend);
    // On the same way, and not back at where it came from.
    const auto bends = tells && bend.distance * bend.distance > 0.8 * square &&
                       abs(bend.product) > 0.2 * square;
    const Lanes inverse_bend = 1.0 / select(bends, bend.product, Lanes(1.0));
    Lanes slope_miss(0.0);
    const auto learn = [&](Row value, const Lanes& found, Row by_force,
                           Row by_cosine, Row curve_row, const Lanes& weight)
        __attribute__((always_inline)) {
      const Lanes old = p[value];
      const Lanes force = p[by_force];
      const Lanes cosine = p[by_cosine];
      const Lanes curve = p[curve_row];
      // (A pin has no spinning moment.)
      const Lanes missed =
          select(found == old, Lanes(0.0), log_ratio(found, old)) -
          (force * move.force + cosine * move.cosine);
      const auto fair = abs(missed) < largest_miss;
      const Lanes share = select(tells && fair, missed * inverse, Lanes(0.0));
      p.set(by_force, force + share * move.force);
      p.set(by_cosine, cosine + share * move.cosine);
      p.set(curve_row,
            select(bends, select(fair, missed * inverse_bend, Lanes(0.0)),
                   curve));
      p.set(value, found);
      slope_miss += abs(missed) * weight;
      return missed - curve * expected_bend;
    };
    // As far as each counts in the moment.
    const Lanes sin_psi = p[Row::sin_psi];
    const Lanes share = 1.0 / (p[Row::sliding_share] + p[Row::spinning_share]);
    const Lanes sliding_weight = p[Row::sliding_share] * share;
    const Lanes spinning_weight = p[Row::spinning_share] * share;
    const Found found = found_in(p);
    const Lanes friction =
        learn(Row::friction, found.friction, Row::friction_by_force,
              Row::friction_by_cosine, Row::friction_curve, sin_psi);
    const Lanes sliding =
        learn(Row::sliding, found.sliding, Row::sliding_by_force,
              Row::sliding_by_cosine, Row::sliding_curve, sliding_weight);
    const Lanes spinning =
        learn(Row::spinning, found.spinning, Row::spinning_by_force,
              Row::spinning_by_cosine, Row::spinning_curve, spinning_weight);
    const Lanes missed = abs(friction) * sin_psi +
                         abs(sliding) * sliding_weight +
                         abs(spinning) * spinning_weight;
    p.set(Row::way_force,
          select(tells, move.force * inverse_length, p[Row::way_force]));
    p.set(Row::way_cosine,
          select(tells, move.cosine * inverse_length, p[Row::way_cosine]));
    p.set(Row::way_length,
          select(tells, square * inverse_length, p[Row::way_length]));
    // Slopes across the way that the contact has gone are not looked at.
    constexpr double kept = 0.7;
    constexpr double least = 1e-2;
    const Lanes old_error = p[Row::slope_error];
    const Lanes slope_error = select(
        tells,
        max(max(kept * old_error, slope_miss * inverse_length), Lanes(least)),
        old_error);
    p.set(Row::slope_error, slope_error);

    // The root is where tan psi = f/cos a.
    const Lanes along = p[Row::along];
    const Lanes tilt = p[Row::tilt];
    const Lanes tangent =
        p[Row::tangent] * (1.0 + p[Row::tangent_by_along] * along +
                           p[Row::tangent_by_tilt] * tilt);
    const Lanes step =
        -log_ratio(tangent, p[Row::friction] * p[Row::place_speed]) *
        p[Row::inverse_slope];
    const Vector correction =
        step * get(p, Row::by_tangent_x, Row::by_tangent_y, Row::by_tangent_z) +
        sliding *
            get(p, Row::by_sliding_x, Row::by_sliding_y, Row::by_sliding_z) +
        spinning *
            get(p, Row::by_spinning_x, Row::by_spinning_y, Row::by_spinning_z);
    set(p, Row::base_x,
        get(p, Row::base_x, Row::base_y, Row::base_z) + correction);
    set(p, Row::moment_x,
        get(p, Row::moment_x, Row::moment_y, Row::moment_z) + correction);
    // No answer to the acting moment.
    set(p, Row::missed_x,
        get(p, Row::missed_x, Row::missed_y, Row::missed_z) + correction);
    const Lanes rest = abs(step) * (abs(p[Row::force_by_tangent]) +
                                    abs(p[Row::cosine_by_tangent]));
    const Lanes shift = p[Row::shift];
    const Lanes evaluated_error = p[Row::evaluated_error] + slope_error * rest +
                                  sin_psi * step * step +
                                  missed * (missed + shift);
    p.set(Row::evaluated_error, evaluated_error);
    p.set(Row::error, evaluated_error + shift * shift);
    p.set(Row::reach,
          larger(p[Row::reach], abs(step) * (1 / FollowerReach::move)));

    // Where the next guess starts from.
    const Lanes last_tangent = tangent * (1.0 + step);
    p.set(Row::last_inverse_reaction,
          1.0 / (p[Row::place_reaction] * (1.0 + along)));
    p.set(Row::last_sine, p[Row::place_sine] + tilt * p[Row::place_cosine]);
    p.set(Row::last_cosine, p[Row::place_cosine] - tilt * p[Row::place_sine]);
    p.set(Row::last_tangent, last_tangent);
    p.set(Row::last_residual,
          log_ratio(last_tangent, p[Row::friction] * p[Row::place_speed]));
    p.set(Row::last_speed, p[Row::place_speed]);
    most.add(p);
  });
  return most.result();
}

}  // namespace
}  // namespace contact::detail

#include "libcontact/tracking/follower_acting_impl.hpp"
