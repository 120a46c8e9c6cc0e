#pragma once

#include <string>
#include <vector>

#include "libcontact/pair/layers.hpp"
#include "support/reference_table.hpp"

namespace contact::test {

/// One layer of modulus 1 and radius 1 around a body that is 50 times as stiff.
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

inline Material reference_material(const ReferenceTable& table, std::size_t row,
                                   const std::string& name,
                                   const std::string& nu) {
  return {table.value(row, name), table.value(row, nu)};
}

inline void add_reference_layer(const ReferenceTable& table, std::size_t row,
                                const std::string& name,
                                std::vector<Layer>& layers) {
  if (table.text(row, name + "_t").empty()) return;
  layers.push_back({table.value(row, name + "_t"),
                    reference_material(table, row, name + "_E", name + "_nu")});
}

/// The joint of a row of data/reference/walls/walls_{ball,pin}.csv.
inline LayeredPair reference_pair(const ReferenceTable& table,
                                  std::size_t row) {
  LayeredBody inner{
      {},
      table.text(row, "E1").empty()
          ? Backing::rigid()
          : Backing::medium(reference_material(table, row, "E1", "nu1"))};
  add_reference_layer(table, row, "coat", inner.layers);
  const std::string& end = table.text(row, "end");
  LayeredBody outer{{},
                    end == "rigid"  ? Backing::rigid()
                    : end == "free" ? Backing::held()
                                    : Backing::medium(reference_material(
                                          table, row, "end_E", "end_nu"))};
  add_reference_layer(table, row, "La", outer.layers);
  add_reference_layer(table, row, "Lb", outer.layers);
  return {table.value(row, "rho"), inner, outer};
}

}  // namespace contact::test
