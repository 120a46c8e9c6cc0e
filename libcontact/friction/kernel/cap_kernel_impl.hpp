#pragma once

// Included once by each cap_kernel_*.cpp, which is compiled for its own
// instruction set.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "libcontact/base/lanes.hpp"
#include "libcontact/friction/kernel/cap_kernel.hpp"
#include "libcontact/friction/kernel/cap_point.hpp"

namespace contact::detail {
namespace {

static_assert(CapRule::lanes % width == 0);

Lanes load(const double* x) { return Lanes::load(x); }

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

// Apart, each has registers enough with 16 of two numbers: 4 % fewer
// instructions of a call.
template <bool pole_inside, ArcRange range>
[[gnu::noinline]] CapSums<double> sum_nodes(const CapPoint<double>& point,
                                            const CapRule& rule) {
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

template <bool pole_inside, ArcRange range, class V>
CapSums<V> sum_points(const CapPoint<V>& points, const CapRule& rule) {
  NodeSum<pole_inside, range, V> nodes(points);
  for (int i = 0; i < rule.size; ++i) {
    nodes.add(V(rule.cosine_squared[i]), V(rule.sine_squared[i]),
              V(rule.weight[i]));
  }
  return nodes.sums();
}

template <class V, class F>
[[gnu::always_inline]] inline void for_sums(F f) {
  f(&CapSums<V>::force_pressure, &CapSums<double>::force_pressure);
  f(&CapSums<V>::sliding_pressure, &CapSums<double>::sliding_pressure);
  f(&CapSums<V>::spinning_pressure, &CapSums<double>::spinning_pressure);
  f(&CapSums<V>::force_area, &CapSums<double>::force_area);
  f(&CapSums<V>::sliding_area, &CapSums<double>::sliding_area);
  f(&CapSums<V>::spinning_area, &CapSums<double>::spinning_area);
}

// The sums of points of one branch, lanes over points with the rule of the
// largest modulus, which serves the others as well; or one after the other.
template <class V>
void sum_group(const CapPoint<V>& points, const mask_of<V>& group,
               bool pole_inside, ArcRange range, CapSums<V>& sums) {
  constexpr int count = V::size();
  int most = 0;
  for (int i = 0; i < count; ++i) {
    if (group[i]) most = std::max(most, cap_rule_index(points.m[i]));
  }
  const CapRule& rule = cap_rules[most];
  // In units of one node in four lanes; a point alone is brought together from
  // its lanes besides.
  const int together = rule.size * count / 4;
  const int alone = popcount(group) * (rule.padded_size / 4 + 3);
  if (together <= alone) {
    const CapSums<V> found =
        with_branches(pole_inside, range, [&]<bool inside, ArcRange arc>() {
          return sum_points<inside, arc>(points, rule);
        });
    for_sums<V>([&](auto sum, auto) {
      sums.*sum = select(group, found.*sum, sums.*sum);
    });
    return;
  }
  for (int i = 0; i < count; ++i) {
    if (!group[i]) continue;
    const CapPoint<double> point{points.s[i], points.c[i], points.sa[i],
                                 points.q[i], points.k[i], points.m[i]};
    const CapSums<double> found =
        one(point, cap_rules[cap_rule_index(point.m)], pole_inside, range);
    for_sums<V>(
        [&](auto sum, auto of_one) { (sums.*sum).set_lane(i, found.*of_one); });
  }
}

template <class V>
[[gnu::flatten]] void few_lanes(const double* half_angle_sin,
                                const double* half_angle_cos,
                                const double* axis_sin, const double* axis_cos,
                                const double* wanted, int count,
                                double* integrals) {
  const auto read = [](const double* from) { return V::load(from); };
  const PreparedCap<V> cap =
      prepare(SineCosinePair<V>{read(half_angle_sin), read(half_angle_cos)},
              read(axis_sin), read(axis_cos));
  const V number([](auto lane) { return static_cast<double>(lane); });
  auto left = read(wanted) != 0.0 && number < static_cast<double>(count);
  const V branch = select(cap.pole_inside, V(4.0), V(0.0)) +
                   select(cap.point.c >= arc_h_short.lower, V(0.0), V(1.0)) +
                   select(cap.point.c >= arc_h_medium.lower, V(0.0), V(1.0));
  CapSums<V> sums;
  while (any_of(left)) {
    const int first = find_first_set(left);
    const auto group = left && branch == V(branch[first]);
    sum_group(cap.point, group, cap.pole_inside[first],
              arc_range(cap.point.c[first]), sums);
    left = left && !group;
  }
  const CapResult<V> r = assemble(cap, sums);
  const auto store = [&](const V& x, int row) {
    x.store(integrals + row * CapKernel::few_points);
  };
  store(r.force, 0);
  store(r.sliding, 1);
  store(r.spinning, 2);
  store(r.force_area, 3);
  store(r.sliding_area, 4);
  store(r.spinning_area, 5);
}

void few(const double* half_angle_sin, const double* half_angle_cos,
         const double* axis_sin, const double* axis_cos, const double* wanted,
         int count, double* integrals) {
  constexpr int half = (width + 1) / 2;
  using HalfLanes = LanesOf<half>;
  static_assert(CapKernel::few_points % width == 0);
  for (int i = 0; i < count; i += width) {
    const auto with = [&]<class V>(V) {
      few_lanes<V>(half_angle_sin + i, half_angle_cos + i, axis_sin + i,
                   axis_cos + i, wanted + i, count - i, integrals + i);
    };
    const auto wants = [&]<class V>(const V&, int from) {
      return any_of(V::load(wanted + from) != 0.0);
    };
    if (!wants(Lanes{}, i)) continue;
    if constexpr (width > 4) {
      if (count - i <= half || !wants(HalfLanes{}, i + half)) {
        with(HalfLanes{});
        continue;
      }
    }
    with(Lanes{});
  }
}

}  // namespace
}  // namespace contact::detail

#include "libcontact/friction/kernel/arc_kernel_impl.hpp"

namespace contact::detail {
namespace {

/// Points of a block, sorted by common properties: rule, side of the pole, arc
/// range. Only then can lanes run over points without waste.
class Block {
 public:
  static constexpr int capacity = 2048;

  Block(const FrictionBatchInput& in, const FrictionBatchOutput& out,
        const ExpansionTable* table, std::size_t offset)
      : in_(in),
        out_(out),
        table_(table),
        offset_(offset),
        wants_sums_(!table || table->has_cosine || !out.force_area.empty() ||
                    !out.sliding_area.empty() || !out.spinning_area.empty()),
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
      const CapRule& rule = cap_rules[key / branches];
      with_branches(key / ranges % 2 != 0, static_cast<ArcRange>(key % ranges),
                    [&]<bool inside, ArcRange arc>() {
                      sum_group<inside, arc>(first, end, rule);
                    });
      first = end;
    }
  }

 private:
  static constexpr int ranges = 3;
  static constexpr int branches = 4 * ranges;
  static constexpr int keys = cap_rule_count * branches;
  using Array = std::array<double, capacity>;
  using LaneIndex = std::array<int, width>;

  void prepare_lanes(int i, const PreparedCap<Lanes>& cap) {
    const auto store = [i](const Lanes& x, Array& array) {
      x.store(array.data() + i);
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
    store(2.0 * ranges * one_if(cap.beyond_hemisphere) +
              static_cast<double>(ranges) * one_if(cap.pole_inside) +
              one_if(!(cap.point.c >= arc_h_short.lower)) +
              one_if(!(cap.point.c >= arc_h_medium.lower)),
          branch_);
  }

  /// Counting sort by key.
  void sort() {
    for (int i = 0; i < count_; ++i) {
      const int key =
          cap_rule_index(m_[i]) * branches + static_cast<int>(branch_[i]);
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
      const int size = wants_sums_ ? rule.size : 0;
      for (int node = 0; node < size; ++node) {
        nodes.add(Lanes(rule.cosine_squared[node]),
                  Lanes(rule.sine_squared[node]), Lanes(rule.weight[node]));
      }
      CapResult<Lanes> result = assemble(cap, nodes.sums());
      if (table_) {
        const Lanes half_angle([&](auto lane) {
          return in_.half_angle[offset_ + at[static_cast<std::size_t>(lane)]];
        });
        set_pressure(*table_, half_angle, cap, pole_inside, result);
      }
      scatter(at, result);
    }
  }

  void scatter(const LaneIndex& at, const CapResult<Lanes>& r) const {
    const auto store = [&](const Lanes& x, std::span<double> to) {
      if (to.empty()) return;
      std::array<double, width> lanes;
      x.store(lanes.data());
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

  const FrictionBatchInput& in_;
  const FrictionBatchOutput& out_;
  const ExpansionTable* table_;
  std::size_t offset_;
  bool wants_sums_;  // sums of the cosine pressure and the area
  int count_;
  Array s_, c_, sa_, q_, k_, m_, beyond_, branch_;
  std::array<short, capacity> key_;
  std::array<short, capacity> order_;
  std::array<int, keys> ends_{};  // after sort(): end of each key's points
};

void batch(const FrictionBatchInput& in, const FrictionBatchOutput& out,
           const ExpansionTable* table) {
  for (std::size_t i = 0; i < in.half_angle.size(); i += Block::capacity) {
    Block(in, out, table, i).evaluate();
  }
}

}  // namespace
}  // namespace contact::detail
