#pragma once

// Included by cap_kernel_impl.hpp: once per instruction set, Lanes being a
// different type in each.

#include <array>

#include "libcontact/detail/arc_sum.hpp"
#include "libcontact/detail/cap_rule.hpp"
#include "libcontact/pressure_expansion.hpp"

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

/// Whether the last terms count; few do in smooth pressures.
bool is_rough(const PressureExpansion& p) {
  return p.size == PressureExpansion::max_terms &&
         std::abs(p.coefficient[p.size - 1]) >
             1e-10 * std::abs(p.coefficient[0]);
}

using RuleOfIndex = const CapRule& (*)(int);
RuleOfIndex inner_rule(bool rough) { return rough ? rough_rule : short_rule; }

/// hmin(), but for NaN.
double smallest(const Lanes& x) {
  return hmin(select(x >= 0.0, x, Lanes(1.0)));
}

/// One contact, its arcs in lanes along them.
template <bool with_logarithm>
class OneContact {
 public:
  OneContact(const ArcPoint<double>& p, const PressureExpansion& pressure)
      : point_(p),
        pressure_{Lanes(pressure.edge_constant), pressure.size,
                  pressure.coefficient.data(), pressure.logarithmic.data()},
        inner_(inner_rule(is_rough(pressure))) {}

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
    const CapRuleIndex& index = cap_rule_index();
    PressureSums<Lanes> sum;
    for (int i = 0; i < rule.size; ++i) {
      const Arc<Lanes> arc = arcs.get(i);
      const CapRule& inner = inner_(index(arcs.constant[i]));
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
  RuleOfIndex inner_;
};

/// Calls f.template operator()<circles>(outer rule) for each family of circles
/// that a contact needs and adds up.
template <class V, class Sum>
[[gnu::always_inline]] inline PressureSums<V> sum_circles(bool pole_inside,
                                                          bool beyond,
                                                          double k2, double m,
                                                          Sum sum) {
  const CapRuleIndex& index = cap_rule_index();
  if (pole_inside) {
    return sum.template operator()<Circles::inside>(short_rule(index(m)));
  }
  if (!beyond) {
    return sum.template operator()<Circles::outside>(chord_rule(index(m)));
  }
  const PressureSums<V> cut =
      sum.template operator()<Circles::outside>(log_chord_rule(index(m)));
  const PressureSums<V> whole =
      sum.template operator()<Circles::whole>(log_chord_rule(index(k2)));
  return {cut.force + whole.force, cut.sliding + whole.sliding,
          cut.spinning + whole.spinning};
}

PressureSums<double> root_pressure(const ArcPoint<double>& p, bool pole_inside,
                                   const PressureExpansion& pressure) {
  const auto with = [&]<bool with_logarithm>() {
    const OneContact<with_logarithm> contact(p, pressure);
    return sum_circles<double>(pole_inside, p.c < 0, p.k * p.k, p.m,
                               [&]<Circles circles>(const CapRule& rule) {
                                 return contact.template sum<circles>(rule);
                               });
  };
  return pressure.logarithmic[0] != 0 ? with.template operator()<true>()
                                      : with.template operator()<false>();
}

/// A contact in each lane; what root_pressure() does for one.
template <bool with_logarithm>
PressureSums<Lanes> root_pressures(const ArcPoint<Lanes>& p, bool pole_inside,
                                   bool beyond,
                                   const RootPressure<Lanes, Lanes>& pressure,
                                   RuleOfIndex inner_rule) {
  const auto sum = [&]<Circles circles>(const CapRule& rule) {
    const CapRuleIndex& index = cap_rule_index();
    PressureSums<Lanes> total;
    for (int i = 0; i < rule.size; ++i) {
      const Arc<Lanes> arc = arc_of<circles>(
          p, pressure.edge_constant, Lanes(rule.cosine_squared[i]),
          Lanes(rule.sine_squared[i]), Lanes(rule.weight[i]));
      // The longest arc's rule serves the others too.
      const CapRule& inner = inner_rule(index(smallest(arc.constant)));
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
  return sum_circles<Lanes>(pole_inside, beyond, smallest(p.k * p.k),
                            smallest(p.m), sum);
}

}  // namespace
}  // namespace contact::detail
