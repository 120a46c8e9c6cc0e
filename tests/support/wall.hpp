#pragma once

#include <string>
#include <vector>

#include "libcontact/pair/layers.hpp"
#include "support/reference_table.hpp"

namespace contact::test {

/// A layer of modulus 1 and radius 1 around a body 50 times as stiff.
struct Wall {
  double thickness;
  double nu;
  bool held;  ///< else on a rigid backing
  LayeredPair pair() const {
    return {
        1,
        {{}, Backing::medium({50, 0.3})},
        {{{thickness, {1, nu}}}, held ? Backing::held() : Backing::rigid()}};
  }
  std::string label() const {
    return "t " + std::to_string(thickness) + ", nu " + std::to_string(nu) +
           (held ? ", held" : "");
  }
};

inline Material reference_material(const ReferenceTable::Row& row,
                                   const std::string& name,
                                   const std::string& nu) {
  return {row.value(name), row.value(nu)};
}

inline void add_reference_layer(const ReferenceTable::Row& row,
                                const std::string& name,
                                std::vector<Layer>& layers) {
  if (!row.given(name + "_t")) return;
  layers.push_back({row.value(name + "_t"),
                    reference_material(row, name + "_E", name + "_nu")});
}

/// The bodies of a row of data/reference/walls/walls_{ball,pin}.csv, and of
/// data/reference/play/{force_law,impact}.csv.
struct ReferenceBodies {
  LayeredBody inner;
  LayeredBody outer;
};
inline ReferenceBodies reference_bodies(const ReferenceTable::Row& row) {
  LayeredBody inner{{},
                    row.given("E1")
                        ? Backing::medium(reference_material(row, "E1", "nu1"))
                        : Backing::rigid()};
  add_reference_layer(row, "coat", inner.layers);
  const std::string& end = row.text("end");
  LayeredBody outer{
      {},
      end == "rigid" ? Backing::rigid()
      : end == "free" || end == "held"
          ? Backing::held()
          : Backing::medium(reference_material(row, "end_E", "end_nu"))};
  add_reference_layer(row, "La", outer.layers);
  add_reference_layer(row, "Lb", outer.layers);
  return {inner, outer};
}
inline LayeredPair reference_pair(const ReferenceTable::Row& row) {
  const ReferenceBodies bodies = reference_bodies(row);
  return {row.value("rho"), bodies.inner, bodies.outer};
}

}  // namespace contact::test
