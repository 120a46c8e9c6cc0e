#pragma once

// Included by each forest_kernel_*.cpp, which is compiled for its own
// instruction set and has vectors V of its own.

#include <cmath>

#include "libcontact/base/lanes/sine_cosine.hpp"
#include "multibody/dynamics/kernel/forest_kernel.hpp"
#include "multibody/dynamics/kernel/forest_vectors.hpp"

namespace multibody::detail {

template <class V, bool sloped>
struct ForestSteps {
  using M = Columns<V>;

  /// Motion of a body from its parent's motion.
  [[gnu::always_inline]] static void set_motion(const ForestHinge& hinge,
                                                const ForestState& state,
                                                const ForestPart& parent,
                                                ForestPart& p) {
    const M up = matrix<V>(parent.rotation);
    const M turn = product(up, state.rotation);
    store(turn, p.rotation);
    store(times(turn, hinge.r), p.r);
    const V from_parent = times(up, hinge.from_parent) - vector<V>(parent.r);
    store(from_parent, p.from_parent);
    const V w = vector<V>(parent.w);
    store(cross(w, cross(w, from_parent)), p.linear_bias);
    V relative{};
    if (hinge.turn == ForestTurn::axis) {
      const V axis = times(turn, hinge.axis);
      store(axis, p.axis);
      relative = dot(hinge.axis, state.angular_velocity) * axis;
    } else if (hinge.turn == ForestTurn::ball) {
      relative = times(turn, state.angular_velocity);
    }
    store(w + relative, p.w);
    store(cross(w, relative), p.angular_bias);
  }
  [[gnu::always_inline]] static void set_root(const ForestState& state,
                                              ForestPart& p) {
    p.rotation = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    p.r = {};
    p.w = padded(state.angular_velocity);
    // It may have hung on another body before.
    p.turn = p.reaction = p.reaction_moment = {};
  }

  /// Equations of the body alone, before its children are added.
  [[gnu::always_inline]] static void set_own(const ForestHinge& hinge,
                                             const ForestState& state,
                                             ForestPart& p) {
    const M turn = matrix<V>(p.rotation);
    const V w = vector<V>(p.w);
    const V mass_r = times(turn, hinge.mass_r);
    const M inertia =
        product_transposed(product(turn, hinge.inertia), p.rotation);
    const double m = hinge.mass;
    p.a = {{m, 0, 0}, {0, m, 0}, {0, 0, m}};
    Padded at;
    store(mass_r, at);
    p.b = {{0, at.z, -at.y}, {-at.z, 0, at.x}, {at.y, -at.x, 0}};
    store(inertia, p.d);
    const V active = times(turn, state.force);
    store(V{} - cross(w, cross(w, mass_r)) - active, p.own_force);
    store(cross(w, times(inertia, p.w)) - times(turn, state.moment) +
              cross(vector<V>(p.r), active),
          p.own_moment);
    if constexpr (sloped) {
      p.c = {{0, -at.z, at.y}, {at.z, 0, -at.x}, {-at.y, at.x, 0}};
      const M slope =
          product_transposed(product(turn, state.slope), p.rotation);
      store(slope, p.slope);
      store(V{} - times(transposed(slope), p.axis), p.e);
    }
  }

  /// First step: contribution of the body and its descendants to the parent.
  [[gnu::always_inline]] static void eliminate(ForestTurn turn, ForestPart& p,
                                               ForestPart& parent) {
    const M a = matrix<V>(p.a);
    const M b = matrix<V>(p.b);
    const M d = matrix<V>(p.d);
    M c;
    if constexpr (sloped) {
      c = matrix<V>(p.c);
    } else {
      c = transposed(b);
      store(c, p.c);
    }
    add(times(a, p.linear_bias) + times(b, p.angular_bias), p.own_force);
    add(times(c, p.linear_bias) + times(d, p.angular_bias), p.own_moment);
    if (turn == ForestTurn::axis) {
      eliminate_axis(a, b, c, d, p, parent);
    } else if (turn == ForestTurn::ball) {
      eliminate_ball(a, b, c, d, p, parent);
    } else {
      pass(a, b, c, d, p, parent);
    }
  }

  /// First step for the loads. The chain of operations at the parent is short,
  /// because most terms are computed before.
  [[gnu::always_inline]] static void gather(const ForestHinge& hinge,
                                            const ForestState& state,
                                            ForestPart& p, ForestPart& parent) {
    const V force = vector<V>(p.force);
    const V moment = vector<V>(p.moment);
    const V arm = vector<V>(p.from_parent);
    if (hinge.turn == ForestTurn::axis) {
      double missing =
          dot(hinge.axis, state.hinge_moment) - dot(vector<V>(p.axis), moment);
      if constexpr (sloped) missing -= dot(vector<V>(p.e), force);
      p.rate_change = p.inverse * missing;
      add(force + p.rate_change * vector<V>(p.x_force), parent.force);
      add(moment + cross(arm, force) + p.rate_change * vector<V>(p.y_moment),
          parent.moment);
    } else if (hinge.turn == ForestTurn::ball) {
      V given = times(matrix<V>(p.rotation), state.hinge_moment);
      store(given, p.given);
      if constexpr (sloped) given += times(matrix<V>(p.slope), force);
      const V missing = given - moment;
      store(times(matrix<V>(p.inverse_ball), missing), p.turn);
      add(force + times(matrix<V>(p.x_ball), missing), parent.force);
      add(given + cross(arm, force) + times(matrix<V>(p.y_ball), missing),
          parent.moment);
    } else {
      add(force, parent.force);
      add(moment + cross(arm, force), parent.moment);
    }
  }

  /// Second step: accelerations from the parent's accelerations, and the
  /// reaction.
  [[gnu::always_inline]] static void resolve(ForestTurn turn,
                                             const ForestPart& parent,
                                             ForestPart& p) {
    const V up = vector<V>(parent.angular);
    const V linear =
        vector<V>(parent.linear) + cross(up, vector<V>(p.from_parent));
    V angular = up;
    V force = vector<V>(p.force);
    V moment = vector<V>(p.moment);
    if (turn == ForestTurn::axis) {
      const double q = p.rate_change -
                       dot(vector<V>(p.row_force), vector<V>(parent.linear)) -
                       dot(vector<V>(p.row_moment), up);
      p.rate_change = q;
      angular = up + q * vector<V>(p.axis);
    } else if (turn == ForestTurn::ball) {
      // The parent's turn does not count: d takes it back.
      angular = vector<V>(p.turn) -
                times(matrix<V>(p.row_ball), parent.linear) +
                times(matrix<V>(p.row_arm), parent.angular);
    }
    store(linear + vector<V>(p.linear_bias), p.linear);
    store(angular + vector<V>(p.angular_bias), p.angular);
    store(angular - up, p.turn);
    force += times(matrix<V>(p.a), linear) + times(matrix<V>(p.b), angular);
    store(force, p.reaction);
    if (turn == ForestTurn::ball) {
      moment = vector<V>(p.given);
      if constexpr (sloped) moment += times(matrix<V>(p.slope), force);
    } else {
      moment += times(matrix<V>(p.c), linear) + times(matrix<V>(p.d), angular);
    }
    store(moment, p.reaction_moment);
  }

 private:
  [[gnu::always_inline]] static void eliminate_axis(const M& a, const M& b,
                                                    const M& c, const M& d,
                                                    ForestPart& p,
                                                    ForestPart& parent) {
    const V arm = vector<V>(p.from_parent);
    const V force = times(b, p.axis);
    const V moment = times(d, p.axis);
    V row_force = force;
    V row_moment = moment;
    if constexpr (sloped) {
      row_force = times(transposed(c), p.axis) + times(transposed(a), p.e);
      row_moment = times(transposed(d), p.axis) + times(transposed(b), p.e);
    }
    // About the parent's origin.
    const V y_moment = moment + cross(arm, force);
    const V y_row = row_moment + cross(arm, row_force);
    Padded of_force, of_moment;
    store(row_force, of_force);
    store(y_row, of_moment);
    store(force, p.x_force);
    store(y_moment, p.y_moment);
    const double inverse = 1 / dot(row_moment, vector<V>(p.axis));
    p.inverse = inverse;
    store(inverse * row_force, p.row_force);
    store(inverse * y_row, p.row_moment);
    const V less_force = inverse * force;
    const V less_moment = inverse * y_moment;
    const M moved = b - crossed(a, p.from_parent);
    add(a - outer(less_force, of_force), parent.a);
    add(moved - outer(less_force, of_moment), parent.b);
    if constexpr (sloped) {
      add(c + crossed(arm, a) - outer(less_moment, of_force), parent.c);
    }
    add(d - crossed(c, p.from_parent) + crossed(arm, moved) -
            outer(less_moment, of_moment),
        parent.d);
  }

  // The columns of a turn vanish, and (c, d) is S (a, b) after it.
  [[gnu::always_inline]] static void eliminate_ball(const M& a, const M& b,
                                                    const M& c, const M& d,
                                                    ForestPart& p,
                                                    ForestPart& parent) {
    const V arm = vector<V>(p.from_parent);
    M law_c = c;
    M law_d = d;
    M slope;
    if constexpr (sloped) {
      slope = matrix<V>(p.slope);
      law_c = c - product(slope, p.a);
      law_d = d - product(slope, p.b);
    }
    const M turn = inverse<!sloped>(law_d);
    store(turn, p.inverse_ball);
    const M x = product(b, p.inverse_ball);
    M y = crossed(arm, x);
    if constexpr (sloped) y = y + product(slope, x);
    const M row = sloped ? product(turn, law_c) : transposed(x);
    store(x, p.x_ball);
    store(y, p.y_ball);
    store(row, p.row_ball);
    store(crossed(row, p.from_parent), p.row_arm);
    const M left =
        a - (sloped ? product(x, law_c) : product_transposed(x, p.b));
    const M left_arm = crossed(left, p.from_parent);
    M moment = scaled(-1, crossed(arm, left_arm));
    if constexpr (sloped) {
      const M turned = product(slope, left);
      add(turned + crossed(arm, left), parent.c);
      moment = moment - crossed(turned, p.from_parent);
    }
    add(left, parent.a);
    add(scaled(-1, left_arm), parent.b);
    add(moment, parent.d);
  }

  [[gnu::always_inline]] static void pass(const M& a, const M& b, const M& c,
                                          const M& d, const ForestPart& p,
                                          ForestPart& parent) {
    const V arm = vector<V>(p.from_parent);
    const M moved = b - crossed(a, p.from_parent);
    if constexpr (sloped) add(c + crossed(arm, a), parent.c);
    add(a, parent.a);
    add(moved, parent.b);
    add(d - crossed(c, p.from_parent) + crossed(arm, moved), parent.d);
  }
};

template <class V, bool sloped>
void prepare_forest(const ForestBodies& f, const ForestState* state) {
  using Steps = ForestSteps<V, sloped>;
  for (const int i : f.order) {
    const int up = f.hinges[i].parent;
    if (up < 0) {
      Steps::set_root(state[i], f.parts[i]);
    } else {
      Steps::set_motion(f.hinges[i], state[i], f.parts[up], f.parts[i]);
    }
    Steps::set_own(f.hinges[i], state[i], f.parts[i]);
  }
  for (std::size_t k = f.order.size(); k-- > 0;) {
    const int i = f.order[k];
    const int up = f.hinges[i].parent;
    if (up < 0) continue;
    Steps::eliminate(f.hinges[i].turn, f.parts[i], f.parts[up]);
  }
}

template <class V, bool sloped>
void gather_forest(const ForestBodies& f, const ForestState* state) {
  for (const int i : f.order) {
    f.parts[i].force = f.parts[i].own_force;
    f.parts[i].moment = f.parts[i].own_moment;
  }
  for (std::size_t k = f.order.size(); k-- > 0;) {
    const int i = f.order[k];
    const ForestHinge& hinge = f.hinges[i];
    if (hinge.parent < 0) continue;
    ForestSteps<V, sloped>::gather(hinge, state[i], f.parts[i],
                                   f.parts[hinge.parent]);
  }
}

template <class V, bool sloped>
void resolve_forest(const ForestBodies& f) {
  for (const int i : f.order) {
    const ForestHinge& hinge = f.hinges[i];
    if (hinge.parent < 0) continue;
    ForestSteps<V, sloped>::resolve(hinge.turn, f.parts[hinge.parent],
                                    f.parts[i]);
  }
}

[[gnu::always_inline]] inline void turn_angle(const double* angle, double* sine,
                                              double* cosine, Vec3<double>) {
  for (int i = 0; i < 4; ++i) {
    sine[i] = std::sin(angle[i]);
    cosine[i] = std::cos(angle[i]);
  }
}
template <contact::detail::LaneSet set>
[[gnu::always_inline]] inline void turn_angle(const double* angle, double* sine,
                                              double* cosine, LanesOf<4, set>) {
  const auto [s, c] =
      contact::detail::sine_cosine_of_any(LanesOf<4, set>::load(angle));
  s.store(sine);
  c.store(cosine);
}

template <class V>
ForestKernel kernel_of() {
  return {[](int n, const double* angles, double* sines, double* cosines) {
            for (int i = 0; i < n; i += 4) {
              turn_angle(angles + i, sines + i, cosines + i, V{});
            }
          },
          [](const ForestBodies& f, const ForestState* state, bool sloped) {
            sloped ? prepare_forest<V, true>(f, state)
                   : prepare_forest<V, false>(f, state);
          },
          [](const ForestBodies& f, const ForestState* state, bool sloped) {
            sloped ? gather_forest<V, true>(f, state)
                   : gather_forest<V, false>(f, state);
          },
          [](const ForestBodies& f, bool sloped) {
            sloped ? resolve_forest<V, true>(f) : resolve_forest<V, false>(f);
          }};
}

}  // namespace multibody::detail
