#pragma once

// Included once by each cap_kernel_*.cpp, which is compiled for its own
// instruction set: native_simd is a different type in each of them.

#include <algorithm>
#include <experimental/simd>

#include "libcontact/detail/cap_kernel.hpp"

namespace contact::detail {
namespace {

namespace stdx = std::experimental;
using Lanes = stdx::native_simd<double>;
constexpr int width = static_cast<int>(Lanes::size());
static_assert(CapRule::lanes % width == 0);

template <bool pole_inside, ArcRange range>
CapSums<double> sum_nodes(const CapPoint<double>& point, const CapRule& rule) {
  const CapConstants<range, Lanes> p(
      CapPoint<Lanes>{point.s, point.c, point.sa, point.q, point.k2, point.m});
  CapSums<Lanes> sum;
  for (int i = 0; i < rule.padded_size; i += width) {
    const auto load = [i](const double* x) {
      return Lanes(x + i, stdx::element_aligned);
    };
    add_node<pole_inside, range>(p, load(rule.cosine), load(rule.sine_squared),
                                 load(rule.weight), sum);
  }
  return {
      stdx::reduce(sum.force_pressure),    stdx::reduce(sum.sliding_pressure),
      stdx::reduce(sum.spinning_pressure), stdx::reduce(sum.force_area),
      stdx::reduce(sum.sliding_area),      stdx::reduce(sum.spinning_area)};
}

template <bool pole_inside, ArcRange range>
void sum_group(const CapGroup& group) {
  for (int first = 0; first < group.count; first += width) {
    const int used = std::min(width, group.count - first);
    // Lanes beyond the end repeat the last point; they are not stored.
    const auto gather = [&](double CapPoint<double>::*member) {
      return Lanes([&](auto lane) {
        const int i = std::min<int>(lane, used - 1);
        return group.points[group.order[first + i]].*member;
      });
    };
    const CapConstants<range, Lanes> p(CapPoint<Lanes>{
        gather(&CapPoint<double>::s), gather(&CapPoint<double>::c),
        gather(&CapPoint<double>::sa), gather(&CapPoint<double>::q),
        gather(&CapPoint<double>::k2), gather(&CapPoint<double>::m)});
    CapSums<Lanes> sum;
    for (int i = 0; i < group.rule->size; ++i) {
      add_node<pole_inside, range>(p, Lanes(group.rule->cosine[i]),
                                   Lanes(group.rule->sine_squared[i]),
                                   Lanes(group.rule->weight[i]), sum);
    }
    for (int lane = 0; lane < used; ++lane) {
      group.sums[group.order[first + lane]] = {
          sum.force_pressure[lane],    sum.sliding_pressure[lane],
          sum.spinning_pressure[lane], sum.force_area[lane],
          sum.sliding_area[lane],      sum.spinning_area[lane]};
    }
  }
}

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

CapSums<double> one(const CapPoint<double>& point, const CapRule& rule,
                    bool pole_inside, ArcRange range) {
  return with_branches(pole_inside, range, [&]<bool inside, ArcRange arc>() {
    return sum_nodes<inside, arc>(point, rule);
  });
}

void group(const CapGroup& g) {
  with_branches(g.pole_inside, g.range, [&]<bool inside, ArcRange arc>() {
    sum_group<inside, arc>(g);
  });
}

}  // namespace
}  // namespace contact::detail
