#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace multibody::test {

/// The largest error of a result, and its place.
struct CaseError {
  double error = 0;
  std::string quantity;
};

/// Compares results in the form of "expected" (data/reference/multibody):
/// each quantity's error in units of its largest component in the case, over
/// all bodies; the moment a ball joint must not have in units of the
/// largest reaction force times 1 m. A missing key is an infinite error.
CaseError case_error(const nlohmann::ordered_json& computed,
                     const nlohmann::ordered_json& expected);

}  // namespace multibody::test
