#include "multibody_support/compare.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace multibody::test {
namespace {

using nlohmann::ordered_json;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Extent {
  double difference = 0;
  double size = 0;
};

void flatten(const ordered_json& json, std::vector<double>& to) {
  if (json.is_array()) {
    for (const ordered_json& element : json) flatten(element, to);
  } else {
    to.push_back(json.get<double>());
  }
}

void add(const ordered_json& computed, const ordered_json& expected,
         const std::string& key, Extent& extent) {
  std::vector<double> a, b;
  if (computed.contains(key)) flatten(computed[key], a);
  flatten(expected[key], b);
  if (a.size() != b.size()) extent.difference = infinity;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const double difference = std::abs(a[i] - b[i]);
    // A NaN is the largest of all differences.
    if (!(difference <= extent.difference)) {
      extent.difference = std::isnan(difference) ? infinity : difference;
    }
    extent.size = std::max(extent.size, std::abs(b[i]));
  }
}

}  // namespace

CaseError case_error(const ordered_json& computed,
                     const ordered_json& expected) {
  std::map<std::string, Extent> extents;
  const std::string list = expected.contains("bodies") ? "bodies" : "loads";
  for (const auto& [key, value] : expected.items()) {
    if (key != list) add(computed, expected, key, extents[key]);
  }
  for (std::size_t i = 0; i < expected[list].size(); ++i) {
    const ordered_json empty = ordered_json::object();
    const ordered_json& body =
        computed.contains(list) && i < computed[list].size() ? computed[list][i]
                                                             : empty;
    for (const auto& [key, value] : expected[list][i].items()) {
      add(body, expected[list][i], key, extents[list + "." + key]);
    }
  }
  Extent& moment = extents[list + ".reaction_moment"];
  moment.size = std::max(moment.size, extents[list + ".reaction_force"].size);
  CaseError worst;
  for (const auto& [key, extent] : extents) {
    const double error =
        extent.difference == 0 ? 0 : extent.difference / extent.size;
    if (!(error <= worst.error)) worst = {error, key};
  }
  return worst;
}

}  // namespace multibody::test
