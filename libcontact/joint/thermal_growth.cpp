#include "libcontact/joint/thermal_growth.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace contact::detail {
namespace {

using Side = LayerCompliance::Side;

bool has_backing(const LayeredBody& body) {
  return body.backing.kind() != Backing::Kind::held;
}

double expansion_of(const Material& material, const std::string& place) {
  if (material.thermal_expansion) return *material.thermal_expansion;
  std::string whose = place;
  if (!material.name.empty()) whose += " " + material.name;
  throw Error(needs("a temperature", "thermal_expansion of the " + whose));
}

std::string place_of(Side side, const LayeredBody& body, std::size_t layer) {
  const bool inner = side == Side::inner;
  if (layer < body.layers.size()) {
    return message("{} {}", inner ? "coating" : "wall layer", layer + 1);
  }
  if (body.layers.empty()) return inner ? "inner material" : "outer material";
  return inner ? "inner material" : "wall backing";
}

// alpha dT of each layer, and of the body behind them, if any.
std::vector<double> strains(Side side, const LayeredBody& body,
                            double warming) {
  std::vector<double> result;
  for (const Layer& layer : body.layers) {
    const std::string place = place_of(side, body, result.size());
    result.push_back(expansion_of(layer.material, place) * warming);
  }
  if (has_backing(body)) {
    const std::string place = place_of(side, body, result.size());
    result.push_back(expansion_of(body.backing.material(), place) * warming);
  }
  return result;
}

}  // namespace

double free_growth(JointKind kind, Side side, const LayeredBody& body,
                   double radius, double warming, AxialGrowth axial) {
  if (warming == 0) return 0;
  std::vector<double> around = strains(side, body, warming);
  if (kind == JointKind::pin) {
    const double along = axial == AxialGrowth::held ? 0 : around.back();
    for (std::size_t i = 0; i < around.size(); ++i) {
      const bool is_layer = i < body.layers.size();
      // A rigid body keeps its shape.
      if (!is_layer && body.backing.kind() == Backing::Kind::rigid) continue;
      const double nu =
          (is_layer ? body.layers[i].material : body.backing.material())
              .poissons_ratio;
      around[i] = (1 + nu) * around[i] - nu * along;
    }
  }
  const LayerCompliance compliance(
      kind, side, body, radius,
      body.layers.empty() ? 1 : body.surface().youngs_modulus);
  return radius *
         compliance.free_growth(std::span(around).first(body.layers.size()),
                                has_backing(body) ? around.back() : 0);
}

double largest_free_strain(const LayeredBody& body, double warming) {
  double largest = 0;
  const auto add = [&](const Material& material) {
    const double strain = material.thermal_expansion.value_or(0) * warming;
    largest = std::max(largest, std::abs(strain));
  };
  for (const Layer& layer : body.layers) add(layer.material);
  if (has_backing(body)) add(body.backing.material());
  return largest;
}

}  // namespace contact::detail
