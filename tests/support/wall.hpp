#pragma once

#include <string>

#include "libcontact/pair/layers.hpp"

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

}  // namespace contact::test
