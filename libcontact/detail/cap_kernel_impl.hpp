#pragma once

// Included once by each cap_kernel_*.cpp, which is compiled for its own
// instruction set: Lanes is a different type in each of them.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <experimental/simd>
#include <numbers>
#include <span>

#include "libcontact/detail/cap_kernel.hpp"
#include "libcontact/detail/cap_point.hpp"

namespace contact::detail {
namespace {

namespace stdx = std::experimental;
using Lanes = stdx::native_simd<double>;
constexpr int width = static_cast<int>(Lanes::size());
static_assert(CapRule::lanes % width == 0);

Lanes load(const double* x) { return Lanes(x, stdx::element_aligned); }

/// Calls f.template operator()<pole_inside, range>().
template <class F>
auto with_branches(bool pole_inside, ArcRange range, F f) {
  const auto with_range = [&]<bool inside>() {
    switch (range) {
      case ArcRange::small:
        return f.template operator()<inside, ArcRange::small>();
      case ArcRange::medium:
        return f.template operator()<inside, ArcRange::medium>();
      default:
        return f.template operator()<inside, ArcRange::large>();
    }
  };
  return pole_inside ? with_range.template operator()<true>()
                     : with_range.template operator()<false>();
}

template <bool pole_inside, ArcRange range>
CapSums<double> sum_nodes(const CapPoint<double>& point, const CapRule& rule) {
  NodeSum<pole_inside, range, Lanes> nodes(
      CapPoint<Lanes>{point.s, point.c, point.sa, point.q, point.k, point.m});
  for (int i = 0; i < rule.padded_size; i += width) {
    nodes.add(load(rule.cosine_squared + i), load(rule.sine_squared + i),
              load(rule.weight + i));
  }
  const CapSums<Lanes>& sum = nodes.sums();
  return {reduce(sum.force_pressure),    reduce(sum.sliding_pressure),
          reduce(sum.spinning_pressure), reduce(sum.force_area),
          reduce(sum.sliding_area),      reduce(sum.spinning_area)};
}

CapSums<double> one(const CapPoint<double>& point, const CapRule& rule,
                    bool pole_inside, ArcRange range) {
  return with_branches(pole_inside, range, [&]<bool inside, ArcRange arc>() {
    return sum_nodes<inside, arc>(point, rule);
  });
}

/// Points of a block, sorted by what they share: rule, side of the pole, arc
/// range. Only then can lanes run over points without waste.
class Block {
 public:
  static constexpr int capacity = 2048;

  Block(const FrictionBatchInput& in, const FrictionBatchOutput& out,
        std::size_t offset)
      : out_(out),
        offset_(offset),
        count_(static_cast<int>(
            std::min<std::size_t>(capacity, in.half_angle.size() - offset))) {
    for (int i = 0; i < count_; i += width) {
      // The last lanes may run over the end: they repeat the last point.
      const int last = count_ - 1 - i;
      const auto take = [&](std::span<const double> x) {
        const double* const start = x.data() + offset + i;
        if (last >= width - 1) return load(start);
        return Lanes([&](auto lane) {
          return start[std::min(static_cast<int>(lane), last)];
        });
      };
      prepare_lanes(i, prepare(take(in.half_angle), take(in.axis_sin),
                               take(in.axis_cos)));
    }
    sort();
  }

  void evaluate() const {
    for (int key = 0, first = 0; key < keys; ++key) {
      const int end = ends_[key];
      if (first == end) continue;
      const CapRule& rule = cap_rule(key / branches);
      with_branches(key % branches >= ranges,
                    static_cast<ArcRange>(key % ranges),
                    [&]<bool inside, ArcRange arc>() {
                      sum_group<inside, arc>(first, end, rule);
                    });
      first = end;
    }
  }

 private:
  static constexpr int ranges = 3;
  static constexpr int branches = 2 * ranges;
  static constexpr int keys = cap_rule_count * branches;
  using Array = std::array<double, capacity>;
  using LaneIndex = std::array<int, width>;

  void prepare_lanes(int i, const PreparedCap<Lanes>& cap) {
    const auto store = [i](const Lanes& x, Array& array) {
      x.copy_to(array.data() + i, stdx::element_aligned);
    };
    store(cap.point.s, s_);
    store(cap.point.c, c_);
    store(cap.point.sa, sa_);
    store(cap.point.q, q_);
    store(cap.point.k, k_);
    store(cap.point.m, m_);
    // Branches as numbers, arithmetic instead of lane-wise decisions.
    const auto one_if = [](const auto& mask) {
      return select(mask, Lanes(1.0), Lanes(0.0));
    };
    store(one_if(cap.beyond_hemisphere), beyond_);
    store(static_cast<double>(ranges) * one_if(cap.pole_inside) +
              one_if(!(cap.point.c >= arc_h_short.lower)) +
              one_if(!(cap.point.c >= arc_h_medium.lower)),
          branch_);
  }

  /// Counting sort by key.
  void sort() {
    const CapRuleIndex& index = cap_rule_index();
    for (int i = 0; i < count_; ++i) {
      const int key = index(m_[i]) * branches + static_cast<int>(branch_[i]);
      key_[i] = static_cast<short>(key);
      ++ends_[key];
    }
    int start = 0;
    for (int& end : ends_) {
      const int size = end;
      end = start;
      start += size;
    }
    for (int i = 0; i < count_; ++i) {
      order_[ends_[key_[i]]++] = static_cast<short>(i);
    }
  }

  template <bool pole_inside, ArcRange range>
  void sum_group(int first, int end, const CapRule& rule) const {
    for (int i = first; i < end; i += width) {
      // Lanes beyond the end repeat the last point.
      LaneIndex at;
      for (int lane = 0; lane < width; ++lane) {
        at[lane] = order_[std::min(i + lane, end - 1)];
      }
      const auto gather = [&](const auto& array) {
        return Lanes([&](auto lane) {
          return array[at[static_cast<std::size_t>(lane)]];
        });
      };
      const PreparedCap<Lanes> cap{{gather(s_), gather(c_), gather(sa_),
                                    gather(q_), gather(k_), gather(m_)},
                                   mask_of<Lanes>(pole_inside),
                                   gather(beyond_) != 0.0};
      NodeSum<pole_inside, range, Lanes> nodes(cap.point);
      for (int node = 0; node < rule.size; ++node) {
        nodes.add(Lanes(rule.cosine_squared[node]),
                  Lanes(rule.sine_squared[node]), Lanes(rule.weight[node]));
      }
      scatter(at, assemble(cap, nodes.sums()));
    }
  }

  void scatter(const LaneIndex& at, const CapResult<Lanes>& r) const {
    const auto store = [&](const Lanes& x, std::span<double> to) {
      if (to.empty()) return;
      std::array<double, width> lanes;
      x.copy_to(lanes.data(), stdx::element_aligned);
      double* const start = to.data() + offset_;
      for (int lane = 0; lane < width; ++lane) start[at[lane]] = lanes[lane];
    };
    store(r.normal, out_.normal);
    store(r.force_pressure, out_.force_pressure);
    store(r.sliding_pressure, out_.sliding_pressure);
    store(r.spinning_pressure, out_.spinning_pressure);
    store(r.force_area, out_.force_area);
    store(r.sliding_area, out_.sliding_area);
    store(r.spinning_area, out_.spinning_area);
    store(r.force, out_.force);
    store(r.sliding, out_.sliding);
    store(r.spinning, out_.spinning);
  }

  const FrictionBatchOutput& out_;
  std::size_t offset_;
  int count_;
  Array s_, c_, sa_, q_, k_, m_, beyond_, branch_;
  std::array<short, capacity> key_;
  std::array<short, capacity> order_;
  std::array<int, keys> ends_{};  // after sort(): end of each key's points
};

void batch(const FrictionBatchInput& in, const FrictionBatchOutput& out) {
  for (std::size_t i = 0; i < in.half_angle.size(); i += Block::capacity) {
    Block(in, out, i).evaluate();
  }
}

template <bool pole_inside, ArcRange range>
AreaSums<Lanes> areas_of(const PreparedCap<Lanes>& cap, const CapRule& rule) {
  AreaNodeSum<pole_inside, range, Lanes> nodes(cap.point);
  for (int node = 0; node < rule.size; ++node) {
    nodes.add(Lanes(rule.cosine_squared[node]), Lanes(rule.weight[node]));
  }
  return assemble_areas<range>(cap, nodes.sums());
}

AreaSums<double> areas(const CapStack& stack, double axis_sin,
                       double axis_cos) {
  AreaSums<Lanes> total;
  for (int i = 0; i < stack.size; i += width) {
    PreparedCap<Lanes> cap = prepare(
        SineCosinePair<Lanes>{load(stack.sine + i), load(stack.cosine + i)},
        Lanes(axis_sin), Lanes(axis_cos));
    // Next to the pole rounding may see it on the other side.
    cap.pole_inside = mask_of<Lanes>(stack.pole_inside);
    // The rule of the lane nearest to the pole serves the others too: the
    // singularities of their integrands are farther away.
    const CapRule& rule = cap_rule(cap_rule_index()(hmin(cap.point.m)));
    const AreaSums<Lanes> area =
        with_branches(stack.pole_inside, arc_range(hmin(cap.point.c)),
                      [&]<bool inside, ArcRange arc>() {
                        return areas_of<inside, arc>(cap, rule);
                      });
    const Lanes weight = load(stack.weight + i);
    total.force += weight * area.force;
    total.sliding += weight * area.sliding;
    total.spinning += weight * area.spinning;
  }
  return {reduce(total.force), reduce(total.sliding), reduce(total.spinning)};
}

/// Points of an arc, sin(eta/2) = sin(d/2) sin(psi): midpoint rule in psi on
/// [0, pi/2], spectral because what it integrates has the period pi.
template <int points>
struct ArcRule {
  std::array<double, points> sine_squared, weight;  // weight: cos^2 psi d psi
  std::array<double, points> cosine_squared;
  ArcRule() {
    for (int i = 0; i < points; ++i) {
      const double psi = std::numbers::pi / 2 * (i + 0.5) / points;
      sine_squared[i] = std::sin(psi) * std::sin(psi);
      cosine_squared[i] = std::cos(psi) * std::cos(psi);
      weight[i] = std::numbers::pi / 2 / points * cosine_squared[i];
    }
  }
};

/// What an arc brings with it, a node of the outer rule.
struct Arc {
  static constexpr int longest = 128;
  std::array<double, longest> half_sine_squared;  // sin^2(d/2)
  std::array<double, longest> radius;             // R
  std::array<double, longest> edge;  // x^2 (1 + R cos eta)/cos^2 psi
  std::array<double, longest> force, sliding_cosine, sliding_sine, spinning;
};

/// Lanes over arcs.
template <bool pole_inside>
void set_arcs(const CapPoint<double>& p, const CapRule& rule, Arc& arc) {
  const double k2 = p.k * p.k;
  const double sa2 = p.sa * p.sa;
  const Lanes r2_constant(pole_inside ? sa2 : p.c * p.c);
  const Lanes r2_cosine(pole_inside ? p.q * p.q : p.s * p.s);
  const double one_plus_c = 1 + p.c;
  for (int i = 0; i < rule.padded_size; i += width) {
    const Lanes cos2 = load(rule.cosine_squared + i);
    const Lanes sin2 = load(rule.sine_squared + i);
    const Lanes delta2 = p.m + k2 * cos2;
    const Lanes r2 = r2_constant + r2_cosine * cos2;
    const auto [u, inverse_delta] = inverse_roots(r2, delta2);
    const Lanes r = r2 * u;
    // D^2/s^2, cos^2 phi, sin^2 phi and d phi.
    const Lanes d2 = pole_inside ? delta2 : cos2;
    const Lanes cos2_phi = pole_inside ? cos2 : delta2;
    const Lanes sin2_phi = pole_inside ? sin2 : k2 * sin2;
    Lanes w = load(rule.weight + i);
    if constexpr (!pole_inside) w *= inverse_delta;
    // sin^2(d/2) = sd^2/(2 (1 + cd)) = (s^2 d2/R) /(2 (R + c)).
    const Lanes share = d2 / (2.0 * r * (r + p.c));  // sin^2(d/2)/s^2
    const Lanes edge = 4.0 * one_plus_c * r * share;
    const Lanes factor = 4.0 * w * sqrt(share * edge);
    const auto store = [i](const Lanes& x, auto& array) {
      x.copy_to(array.data() + i, stdx::element_aligned);
    };
    store(share * (p.s * p.s), arc.half_sine_squared);
    store(r, arc.radius);
    store(edge, arc.edge);
    store(factor * cos2_phi * u, arc.force);
    store(factor * cos2_phi * u * u, arc.sliding_cosine);
    store(factor * sa2 * sin2_phi * u * u, arc.sliding_sine);
    store(factor, arc.spinning);
  }
}

Lanes inverse_square_root(const Lanes& x) { return inverse_roots(x, x).first; }

/// Lanes along arcs. Arc lengths d, eta from the middle of the arc,
/// cos t = R cos eta:
///   I = 2 q ∫ cos^2(phi)/R ∫ p cos(eta) d eta d phi
///   J = 2 q ∫ ∫ p (cos^2(phi) cos^2(eta) + sa^2 sin^2(phi) sin^2(eta))/R^2
///   K = 2 sa ∫ ∫ p sin^2(eta)
template <int points>
AreaSums<double> sum_arcs(const Arc& arc, int size,
                          std::span<const double> series) {
  static const ArcRule<points> rule;
  AreaSums<Lanes> sum;
  for (int j = 0; j < points; j += width) {
    const Lanes sine_squared = load(rule.sine_squared.data() + j);
    const Lanes cosine_squared = load(rule.cosine_squared.data() + j);
    const Lanes psi_weight = load(rule.weight.data() + j);
    for (int i = 0; i < size; ++i) {
      const Lanes half = arc.half_sine_squared[i] * sine_squared;
      const Lanes rest = 1.0 - half;
      const Lanes cosine = rest - half;
      const Lanes sine2 = 4.0 * half * rest;
      const Lanes height = 1.0 + arc.radius[i] * cosine;
      const Lanes inverse = inverse_square_root(height * rest);
      const Lanes x2 =
          arc.edge[i] * cosine_squared * (inverse * inverse * rest);
      const Lanes y = 2.0 * x2 - 1.0;
      Lanes p = series.back();
      for (std::size_t k = series.size() - 1; k-- > 0;) p = p * y + series[k];
      const Lanes w = psi_weight * inverse * p;
      const Lanes across = w * sine2;
      sum.force += arc.force[i] * (w * cosine);
      sum.sliding +=
          arc.sliding_cosine[i] * (w - across) + arc.sliding_sine[i] * across;
      sum.spinning += arc.spinning[i] * across;
    }
  }
  return {reduce(sum.force), reduce(sum.sliding), reduce(sum.spinning)};
}

AreaSums<double> root_pressure(const CapPoint<double>& p, bool pole_inside,
                               std::span<const double> coefficients) {
  // Terms of a high order need more points, and a rule of this or a higher
  // modulus for theirs.
  constexpr std::size_t few_terms = 6;
  constexpr int many_nodes = 4;
  int index = cap_rule_index()(p.m);
  if (coefficients.size() > few_terms) index = std::max(index, many_nodes);
  const CapRule& rule = pole_inside ? cap_rule(index) : chord_rule(index);
  Arc arc;
  if (pole_inside) {
    set_arcs<true>(p, rule, arc);
  } else {
    set_arcs<false>(p, rule, arc);
  }
  const AreaSums<double> sum = coefficients.size() <= few_terms
                                   ? sum_arcs<8>(arc, rule.size, coefficients)
                                   : sum_arcs<16>(arc, rule.size, coefficients);
  // d phi has a factor k outside; sin(d/2) a factor s.
  const double along = 2 * p.s * (pole_inside ? p.q : p.s);
  const double across = 2 * p.s * p.sa * (pole_inside ? 1 : p.k);
  return {along * sum.force, along * sum.sliding, across * sum.spinning};
}

}  // namespace
}  // namespace contact::detail
