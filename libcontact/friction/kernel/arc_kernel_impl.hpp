#pragma once

// Included by cap_kernel_impl.hpp: once per instruction set, Lanes being a
// different type in each.

#include <algorithm>
#include <array>

#include "libcontact/friction/kernel/arc_rule.hpp"
#include "libcontact/friction/kernel/arc_sum.hpp"
#include "libcontact/friction/kernel/cap_point.hpp"
#include "libcontact/friction/kernel/cap_rule.hpp"
#include "libcontact/friction/kernel/expansion_table.hpp"

namespace contact::detail {
namespace {

/// Nodes i, i + 1, ... in lanes, and node i in all of them.
ArcNode<Lanes> nodes_at(const CapRule& rule, int i) {
  return {load(rule.cosine_squared + i), load(rule.sine_squared + i),
          load(rule.weight + i), load(rule.log_cosine_squared + i)};
}
ArcNode<Lanes> node_at(const CapRule& rule, int i) {
  return {rule.cosine_squared[i], rule.sine_squared[i], rule.weight[i],
          rule.log_cosine_squared[i]};
}

/// The arcs of one contact, for lanes over nodes of the outer rule first and
/// along the arcs then.
struct ArcArrays {
  struct alignas(64) Array : std::array<double, CapRule::longest> {};
  Array radius, constant, cosine, half, edge, log_top;
  Array force, sliding_cosine, sliding_sine, spinning;

  void set(int i, const Arc<Lanes>& arc) {
    const auto store = [i](const Lanes& x, Array& array) {
      x.store(array.data() + i);
    };
    store(arc.radius, radius);
    store(arc.constant, constant);
    store(arc.cosine, cosine);
    store(arc.half, half);
    store(arc.edge, edge);
    store(arc.log_top, log_top);
    store(arc.force, force);
    store(arc.sliding_cosine, sliding_cosine);
    store(arc.sliding_sine, sliding_sine);
    store(arc.spinning, spinning);
  }
  Arc<Lanes> get(int i) const {
    return {radius[i],       constant[i], cosine[i], half[i],
            edge[i],         log_top[i],  force[i],  sliding_cosine[i],
            sliding_sine[i], spinning[i]};
  }
};

/// The rules along circles of a contact.
class AlongRules {
 public:
  explicit AlongRules(ArcTerms terms)
      : arc_(arc_rules(terms)), whole_(short_rules_of(terms)) {}

  template <Circles circles>
  const CapRule& get(double complementary_squared) const {
    const std::size_t index = std::min<std::size_t>(
        cap_rule_index(complementary_squared), arc_.size() - 1);
    return circles == Circles::whole ? whole_[index] : arc_[index];
  }

 private:
  const CapRules arc_;
  const CapRules whole_;
};

/// hmin(), but for NaN.
double smallest(const Lanes& x) {
  return hmin(select(x >= 0.0, x, Lanes(1.0)));
}

/// Calls f.template operator()<terms, with_logarithm>(), terms >= size.
template <class F>
auto with_terms(int size, bool with_logarithm, F f) {
  static_assert(PressureExpansion::max_terms == 32);
  if (with_logarithm) {
    return size <= 12   ? f.template operator()<12, true>()
           : size <= 16 ? f.template operator()<16, true>()
                        : f.template operator()<32, true>();
  }
  return size <= 1    ? f.template operator()<1, false>()
         : size <= 4  ? f.template operator()<4, false>()
         : size <= 8  ? f.template operator()<8, false>()
         : size <= 12 ? f.template operator()<12, false>()
         : size <= 16 ? f.template operator()<16, false>()
                      : f.template operator()<32, false>();
}

/// One contact, its arcs in lanes along them.
template <int terms, bool with_logarithm>
class OneContact {
 public:
  OneContact(const ArcPoint<double>& p, const PressureExpansion& pressure,
             ArcTerms arc_terms)
      : point_(p),
        pressure_{Lanes(pressure.edge_constant), pressure.coefficient.data(),
                  pressure.logarithmic.data()},
        along_(arc_terms) {}

  template <Circles circles>
  PressureSums<double> sum(const CapRule& rule) const {
    const ArcPoint<Lanes> point{point_.s, point_.c, point_.sa,
                                point_.q, point_.k, point_.m};
    ArcArrays arcs;
    for (int i = 0; i < rule.size; i += width) {
      arcs.set(i, arc_of<circles, with_logarithm>(
                      point, pressure_.edge_constant, nodes_at(rule, i)));
    }
    PressureSums<Lanes> sum;
    for (int i = 0; i < rule.size; ++i) {
      const Arc<Lanes> arc = arcs.get(i);
      const CapRule& inner = along_.get<circles>(arcs.constant[i]);
      ArcMoments<Lanes> moments;
      for (int j = 0; j < inner.size; j += width) {
        add_point<circles == Circles::whole>(arc, pressure_, nodes_at(inner, j),
                                             moments);
      }
      add_arc(arc, moments, sum);
    }
    return scaled<circles, double>(
        point_, {reduce(sum.force), reduce(sum.sliding), reduce(sum.spinning)});
  }

 private:
  ArcPoint<double> point_;
  RootPressure<terms, with_logarithm, Lanes, double> pressure_;
  AlongRules along_;
};

/// Calls f.template operator()<circles>(outer rule) for each family of circles
/// that a contact needs and adds up.
template <class V, class Sum>
[[gnu::always_inline]] inline PressureSums<V> sum_circles(ArcTerms terms,
                                                          bool pole_inside,
                                                          bool beyond,
                                                          double k2, double m,
                                                          Sum sum) {
  if (pole_inside) {
    return sum.template operator()<Circles::inside>(
        short_rules_of(terms)[cap_rule_index(m)]);
  }
  const CapRules chords = chord_rules_of(terms);
  if (!beyond) {
    return sum.template operator()<Circles::outside>(chords[cap_rule_index(m)]);
  }
  const PressureSums<V> cut =
      sum.template operator()<Circles::outside>(chords[cap_rule_index(m)]);
  const PressureSums<V> whole = sum.template operator()<Circles::whole>(
      whole_chord_rules_of(terms)[cap_rule_index(k2)]);
  return {cut.force + whole.force, cut.sliding + whole.sliding,
          cut.spinning + whole.spinning};
}

PressureSums<double> root_pressure(const ArcPoint<double>& p, bool pole_inside,
                                   const PressureExpansion& pressure) {
  return with_terms(
      pressure.size, pressure.has_logarithm(),
      [&]<int terms, bool with_logarithm>() {
        const ArcTerms along = arc_terms(pressure);
        const OneContact<terms, with_logarithm> contact(p, pressure, along);
        return sum_circles<double>(along, pole_inside, p.c < 0, p.k * p.k, p.m,
                                   [&]<Circles circles>(const CapRule& rule) {
                                     return contact.template sum<circles>(rule);
                                   });
      });
}

/// A contact in each lane; what root_pressure() does for one.
template <int terms, bool with_logarithm>
PressureSums<Lanes> root_pressures(
    const ArcPoint<Lanes>& p, bool pole_inside, bool beyond,
    const RootPressure<terms, with_logarithm, Lanes, Lanes>& pressure,
    ArcTerms arc_terms) {
  const AlongRules along(arc_terms);
  const auto sum = [&]<Circles circles>(const CapRule& rule) {
    PressureSums<Lanes> total;
    for (int i = 0; i < rule.size; ++i) {
      const Arc<Lanes> arc = arc_of<circles, with_logarithm>(
          p, pressure.edge_constant, node_at(rule, i));
      // The longest arc's rule serves the others too.
      const CapRule& inner = along.get<circles>(smallest(arc.constant));
      ArcMoments<Lanes> moments;
      for (int j = 0; j < inner.size; ++j) {
        add_point<circles == Circles::whole>(arc, pressure, node_at(inner, j),
                                             moments);
      }
      add_arc(arc, moments, total);
    }
    return scaled<circles>(p, total);
  };
  // So does the outer rule of the highest modulus.
  return sum_circles<Lanes>(arc_terms, pole_inside, beyond, smallest(p.k * p.k),
                            smallest(p.m), sum);
}

/// Pressures of the contacts in lanes from a table.
class TabulatedPressure {
 public:
  TabulatedPressure(const ExpansionTable& table, const Lanes& half_angle,
                    const Lanes& one_minus_c)
      : table_(table) {
    using std::sqrt;
    const Lanes v =
        (sqrt(half_angle) - table.middle) * table.inverse_half_width;
    chebyshev_[0] = 1.0;
    chebyshev_[1] = v;
    for (int j = 2; j < table.rows; ++j) {
      chebyshev_[j] = 2.0 * v * chebyshev_[j - 1] - chebyshev_[j - 2];
    }
    edge_constant_ = column(ExpansionTable::edge_constant);
    cosine_share_ =
        table.has_cosine ? column(ExpansionTable::cosine_share) : Lanes(0.0);
    const Lanes unit = 0.5 / one_minus_c;
    for (int k = 0; k < table.size; ++k) {
      coefficient_[k] = unit * column(ExpansionTable::coefficient + k);
    }
    if (table.has_logarithm) {
      for (int k = 0; k < 3; ++k) {
        logarithmic_[k] = unit * column(ExpansionTable::logarithmic + k);
      }
    }
  }

  /// Replaces what is of the cosine pressure.
  void apply(const PreparedCap<Lanes>& cap, bool pole_inside, bool beyond,
             const Lanes& one_minus_c, CapResult<Lanes>& r) const {
    const CapPoint<Lanes>& p = cap.point;
    const ArcPoint<Lanes> point{
        p.s, select(cap.beyond_hemisphere, Lanes(-p.c), p.c), p.sa, p.q, p.k,
        p.m};
    const PressureSums<Lanes> root = with_terms(
        table_.size, table_.has_logarithm,
        [&]<int terms, bool with_logarithm>() {
          return root_pressures(
              point, pole_inside, beyond,
              RootPressure<terms, with_logarithm, Lanes, Lanes>{
                  edge_constant_, coefficient_.data(), logarithmic_.data()},
              table_.arc_terms);
        });
    Lanes peak = cosine_share_ * (one_minus_c / r.normal);
    for (int k = 0; k < std::min(table_.size, PressureExpansion::powers); ++k) {
      peak += coefficient_[k];
    }
    r.force = root.force + cosine_share_ * r.force;
    r.sliding = root.sliding + cosine_share_ * r.sliding;
    r.spinning = root.spinning + cosine_share_ * r.spinning;
    r.normal = 1.0 / peak;
    r.force_pressure = r.force * r.normal;
    r.sliding_pressure = r.sliding * r.normal;
    r.spinning_pressure = r.spinning * r.normal;
  }

 private:
  Lanes column(int index) const {
    const auto& series = table_.series[index];
    Lanes even = series[0];
    Lanes odd = 0.0;
    for (int j = 1; j < table_.rows; j += 2) {
      odd += series[j] * chebyshev_[j];
      even += series[j + 1] * chebyshev_[j + 1];
    }
    return even + odd;
  }

  const ExpansionTable& table_;
  Lanes edge_constant_, cosine_share_;
  std::array<Lanes, ExpansionTable::most_rows + 1> chebyshev_{};
  std::array<Lanes, PressureExpansion::max_terms> coefficient_{};
  std::array<Lanes, 3> logarithmic_{};
};

/// Replaces what is of the cosine pressure; the lanes lie on one side of 90
/// deg.
[[gnu::noinline]] void set_pressure(const ExpansionTable& table,
                                    const Lanes& half_angle,
                                    const PreparedCap<Lanes>& cap,
                                    bool pole_inside,
                                    CapResult<Lanes>& result) {
  const CapPoint<Lanes>& p = cap.point;
  const Lanes one_minus_c = select(cap.beyond_hemisphere, Lanes(1.0 + p.c),
                                   Lanes(p.s * p.s / (1.0 + p.c)));
  TabulatedPressure(table, half_angle, one_minus_c)
      .apply(cap, pole_inside, any(cap.beyond_hemisphere), one_minus_c, result);
}

}  // namespace
}  // namespace contact::detail
