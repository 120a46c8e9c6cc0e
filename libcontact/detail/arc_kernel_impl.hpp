#pragma once

// Included by cap_kernel_impl.hpp: once per instruction set, Lanes being a
// different type in each.

#include <algorithm>
#include <array>

#include "libcontact/detail/arc_sum.hpp"
#include "libcontact/detail/cap_point.hpp"
#include "libcontact/detail/cap_rule.hpp"
#include "libcontact/detail/expansion_table.hpp"

namespace contact::detail {
namespace {

/// The arcs of one contact, for lanes over nodes of the outer rule first and
/// along the arcs then.
struct ArcArrays {
  using Array = std::array<double, CapRule::longest>;
  Array radius, constant, cosine, half, edge;
  Array force, sliding_cosine, sliding_sine, spinning;

  void set(int i, const Arc<Lanes>& arc) {
    const auto store = [i](const Lanes& x, Array& array) {
      x.copy_to(array.data() + i, stdx::element_aligned);
    };
    store(arc.radius, radius);
    store(arc.constant, constant);
    store(arc.cosine, cosine);
    store(arc.half, half);
    store(arc.edge, edge);
    store(arc.force, force);
    store(arc.sliding_cosine, sliding_cosine);
    store(arc.sliding_sine, sliding_sine);
    store(arc.spinning, spinning);
  }
  Arc<Lanes> get(int i) const {
    return {radius[i], constant[i],       cosine[i],       half[i],    edge[i],
            force[i],  sliding_cosine[i], sliding_sine[i], spinning[i]};
  }
};

/// The rules that a pressure needs.
struct Rules {
  Rules(bool with_logarithm, bool rough)
      : inner(with_logarithm || rough ? gauss_arc_rule : short_rule),
        inside(with_logarithm ? inside_rule : short_rule),
        chord(with_logarithm ? small_log_chord_rule : chord_rule),
        cut(with_logarithm ? small_log_chord_rule : log_chord_rule) {}
  /// Circles that all but touch the edge weigh little: the rule of
  /// k'^2 = 2.8e-4 serves all of a smaller one, to 2e-11 up to 120 deg.
  const CapRule& inner_for(double complementary_squared) const {
    constexpr int last = 14;
    return inner(std::min(cap_rule_index()(complementary_squared), last));
  }

  const CapRule& (*inner)(int);
  const CapRule& (*inside)(int);
  const CapRule& (*chord)(int);
  const CapRule& (*cut)(int);
};

/// hmin(), but for NaN.
double smallest(const Lanes& x) {
  return hmin(select(x >= 0.0, x, Lanes(1.0)));
}

/// One contact, its arcs in lanes along them.
template <bool with_logarithm>
class OneContact {
 public:
  OneContact(const ArcPoint<double>& p, const PressureExpansion& pressure,
             const Rules& rules)
      : point_(p),
        pressure_{Lanes(pressure.edge_constant), pressure.size,
                  pressure.coefficient.data(), pressure.logarithmic.data()},
        rules_(rules) {}

  template <Circles circles>
  PressureSums<double> sum(const CapRule& rule) const {
    const ArcPoint<Lanes> point{point_.s, point_.c, point_.sa,
                                point_.q, point_.k, point_.m};
    ArcArrays arcs;
    for (int i = 0; i < rule.size; i += width) {
      arcs.set(i, arc_of<circles>(point, pressure_.edge_constant,
                                  load(rule.cosine_squared + i),
                                  load(rule.sine_squared + i),
                                  load(rule.weight + i)));
    }
    PressureSums<Lanes> sum;
    for (int i = 0; i < rule.size; ++i) {
      const Arc<Lanes> arc = arcs.get(i);
      const CapRule& inner = rules_.inner_for(arcs.constant[i]);
      for (int j = 0; j < inner.size; j += width) {
        add_point<circles == Circles::whole, with_logarithm>(
            arc, pressure_,
            {load(inner.cosine_squared + j), load(inner.sine_squared + j),
             load(inner.weight + j), load(inner.log_cosine_squared + j)},
            sum);
      }
    }
    return scaled<circles, double>(
        point_, {reduce(sum.force), reduce(sum.sliding), reduce(sum.spinning)});
  }

 private:
  ArcPoint<double> point_;
  RootPressure<Lanes, double> pressure_;
  const Rules& rules_;
};

/// Calls f.template operator()<circles>(outer rule) for each family of circles
/// that a contact needs and adds up.
template <class V, class Sum>
[[gnu::always_inline]] inline PressureSums<V> sum_circles(const Rules& rules,
                                                          bool pole_inside,
                                                          bool beyond,
                                                          double k2, double m,
                                                          Sum sum) {
  const CapRuleIndex& index = cap_rule_index();
  if (pole_inside) {
    return sum.template operator()<Circles::inside>(rules.inside(index(m)));
  }
  if (!beyond) {
    return sum.template operator()<Circles::outside>(rules.chord(index(m)));
  }
  const PressureSums<V> cut =
      sum.template operator()<Circles::outside>(rules.cut(index(m)));
  const PressureSums<V> whole =
      sum.template operator()<Circles::whole>(log_chord_rule(index(k2)));
  return {cut.force + whole.force, cut.sliding + whole.sliding,
          cut.spinning + whole.spinning};
}

PressureSums<double> root_pressure(const ArcPoint<double>& p, bool pole_inside,
                                   const PressureExpansion& pressure) {
  const auto with = [&]<bool with_logarithm>() {
    const Rules rules(with_logarithm, is_rough(pressure));
    const OneContact<with_logarithm> contact(p, pressure, rules);
    return sum_circles<double>(rules, pole_inside, p.c < 0, p.k * p.k, p.m,
                               [&]<Circles circles>(const CapRule& rule) {
                                 return contact.template sum<circles>(rule);
                               });
  };
  return pressure.has_logarithm() ? with.template operator()<true>()
                                  : with.template operator()<false>();
}

/// A contact in each lane; what root_pressure() does for one.
template <bool with_logarithm>
PressureSums<Lanes> root_pressures(const ArcPoint<Lanes>& p, bool pole_inside,
                                   bool beyond,
                                   const RootPressure<Lanes, Lanes>& pressure,
                                   const Rules& rules) {
  const auto sum = [&]<Circles circles>(const CapRule& rule) {
    PressureSums<Lanes> total;
    for (int i = 0; i < rule.size; ++i) {
      const Arc<Lanes> arc = arc_of<circles>(
          p, pressure.edge_constant, Lanes(rule.cosine_squared[i]),
          Lanes(rule.sine_squared[i]), Lanes(rule.weight[i]));
      // The longest arc's rule serves the others too.
      const CapRule& inner = rules.inner_for(smallest(arc.constant));
      for (int j = 0; j < inner.size; ++j) {
        add_point<circles == Circles::whole, with_logarithm>(
            arc, pressure,
            {Lanes(inner.cosine_squared[j]), Lanes(inner.sine_squared[j]),
             Lanes(inner.weight[j]), Lanes(inner.log_cosine_squared[j])},
            total);
      }
    }
    return scaled<circles>(p, total);
  };
  // So does the outer rule of the highest modulus.
  return sum_circles<Lanes>(rules, pole_inside, beyond, smallest(p.k * p.k),
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
    const RootPressure<Lanes, Lanes> pressure{
        edge_constant_, table_.size, coefficient_.data(), logarithmic_.data()};
    const Rules rules(table_.has_logarithm, table_.rough);
    const PressureSums<Lanes> root =
        table_.has_logarithm
            ? root_pressures<true>(point, pole_inside, beyond, pressure, rules)
            : root_pressures<false>(point, pole_inside, beyond, pressure,
                                    rules);
    Lanes peak = cosine_share_ * (one_minus_c / r.normal);
    for (int k = 0; k < table_.size; ++k) peak += coefficient_[k];
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
  std::array<Lanes, PressureExpansion::max_terms> coefficient_;
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
