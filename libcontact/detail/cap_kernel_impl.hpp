#pragma once

// Included once by each cap_kernel_*.cpp, which is compiled for its own
// instruction set.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "libcontact/detail/cap_kernel.hpp"
#include "libcontact/detail/cap_point.hpp"
#include "libcontact/detail/lanes.hpp"

namespace contact::detail {
namespace {

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

struct FewPoints {
  static constexpr int rows = 8;
  double s[rows], c[rows], sa[rows], q[rows], k[rows], m[rows];
  double pole_inside[rows];
  double force_pressure[rows], sliding_pressure[rows], spinning_pressure[rows];
  double force_area[rows], sliding_area[rows], spinning_area[rows];
};

[[gnu::flatten]] void few(const double* half_angle, const double* axis_sin,
                          const double* axis_cos, const double* wanted,
                          int count, double* integrals) {
  constexpr int rows = FewPoints::rows;
  static_assert(rows % width == 0);
  const auto store = [](const Lanes& x, double* to) {
    x.copy_to(to, stdx::element_aligned);
  };
  const CapRuleIndex& index = cap_rule_index();
  for (int first = 0; first < count; first += width) {
    FewPoints p;
    const PreparedCap<Lanes> cap =
        prepare(load(half_angle + first), load(axis_sin + first),
                load(axis_cos + first));
    store(cap.point.s, p.s);
    store(cap.point.c, p.c);
    store(cap.point.sa, p.sa);
    store(cap.point.q, p.q);
    store(cap.point.k, p.k);
    store(cap.point.m, p.m);
    store(select(cap.pole_inside, Lanes(1.0), Lanes(0.0)), p.pole_inside);
    for (int i = 0; i < width; ++i) {
      CapSums<double> sum{};
      if (first + i < count && wanted[first + i] != 0) {
        const CapPoint<double> point{p.s[i], p.c[i], p.sa[i],
                                     p.q[i], p.k[i], p.m[i]};
        sum = one(point, cap_rule(index(point.m)), p.pole_inside[i] != 0,
                  arc_range(point.c));
      }
      p.force_pressure[i] = sum.force_pressure;
      p.sliding_pressure[i] = sum.sliding_pressure;
      p.spinning_pressure[i] = sum.spinning_pressure;
      p.force_area[i] = sum.force_area;
      p.sliding_area[i] = sum.sliding_area;
      p.spinning_area[i] = sum.spinning_area;
    }
    const CapResult<Lanes> r = assemble(
        cap, CapSums<Lanes>{load(p.force_pressure), load(p.sliding_pressure),
                            load(p.spinning_pressure), load(p.force_area),
                            load(p.sliding_area), load(p.spinning_area)});
    double* const to = integrals + first;
    store(r.force, to);
    store(r.sliding, to + rows);
    store(r.spinning, to + 2 * rows);
    store(r.force_area, to + 3 * rows);
    store(r.sliding_area, to + 4 * rows);
    store(r.spinning_area, to + 5 * rows);
  }
}

}  // namespace
}  // namespace contact::detail

#include "libcontact/detail/arc_kernel_impl.hpp"

namespace contact::detail {
namespace {

/// Points of a block, sorted by what they share: rule, side of the pole, arc
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
      const CapRule& rule = cap_rule(key / branches);
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
    store(2.0 * ranges * one_if(cap.beyond_hemisphere) +
              static_cast<double>(ranges) * one_if(cap.pole_inside) +
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

  const FrictionBatchInput& in_;
  const FrictionBatchOutput& out_;
  const ExpansionTable* table_;
  std::size_t offset_;
  bool wants_sums_;  // of the cosine pressure and the area
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
