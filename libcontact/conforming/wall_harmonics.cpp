#include "libcontact/conforming/wall_harmonics.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/conforming/layer_compliance.hpp"

namespace contact::detail {
namespace {

using Side = LayerCompliance::Side;

// How much long waves of the pressure press in, over the shortest that count:
// roundings and the truncation of the series are enlarged by its inverse.
double conditioning(JointKind kind, const LayeredPair& pair) {
  constexpr int long_wave = 16;
  double compliance = 0;
  for (const Side side : {Side::inner, Side::outer}) {
    compliance += LayerCompliance(kind, side, pair)(long_wave).total;
  }
  return compliance * pair.relative_thickness();
}

// Thin layers that hardly yield, because they can neither be compressed nor
// squeezed sideways, between bodies that do not yield either.
void require_conditioning(JointKind kind, const LayeredPair& pair) {
  // Measured: docs/how-to/walls_matter.md. The ball's kernel is a table.
  const double least = kind == JointKind::ball ? 1.7e-10 : 5e-12;
  const auto is_good = [&](const LayeredPair& p) {
    return conditioning(kind, p) >= least;
  };
  if (is_good(pair)) return;
  LayeredBody inner = pair.inner();
  LayeredBody outer = pair.outer();
  const bool coating =
      !inner.layers.empty() &&
      inner.layers[0].thickness <= pair.relative_thickness() * pair.radius();
  Layer& layer = (coating ? inner : outer).layers[0];
  const std::string given =
      message("{} 1: thickness = {}", coating ? "coating" : "wall layer",
              layer.thickness);
  do {
    layer.thickness *= 1.01;
  } while (!is_good({pair.radius(), inner, outer}));
  throw Error(must_be(
      given, message("at least {:.3g} m: with Poisson's ratio {} and between "
                     "bodies this stiff a thinner one hardly yields, and its "
                     "pressure cannot be computed",
                     1.01 * layer.thickness, layer.material.poissons_ratio)));
}

}  // namespace

WallHarmonics::WallHarmonics(JointKind kind, const LayeredPair& pair)
    : mean(0), first(0) {
  require_conditioning(kind, pair);
  for (const Side side : {Side::inner, Side::outer}) {
    const LayerCompliance compliance(kind, side, pair);
    const int count = compliance.corrected();
    correction.resize(std::max<std::size_t>(correction.size(), count));
    for (int n = 0; n < count; ++n) {
      if (n != 1) correction[n] += compliance(n).correction;
    }
    mean += compliance(0).total;
    first += compliance(1).total;
  }
}

double free_ring_thickness(const LayeredPair& pair) {
  const LayeredBody& outer = pair.outer();
  if (outer.backing.kind() != Backing::Kind::held) {
    return std::numeric_limits<double>::infinity();
  }
  double thickness = 0;
  for (const Layer& layer : outer.layers) thickness += layer.thickness;
  return thickness / pair.radius();
}

namespace {

// How wide the layer at the edge of the contact is, over the radius.
double edge_layer(const LayeredPair& pair) {
  return std::min(pair.relative_thickness(), free_ring_thickness(pair) / 5);
}

}  // namespace

int walled_unknowns(const LayeredPair& pair) {
  // Measured: docs/internals/conforming_methods.md, "The edge".
  const double thickness = edge_layer(pair);
  if (thickness > 0.09) return 16;
  if (thickness > 0.025) return 24;
  if (thickness > 0.009) return 32;
  return thickness > 0.0045 ? 48 : 64;
}

std::string unresolved_note(const LayeredPair& pair) {
  // Against finite grids that are graded to the edge. Of rings: peaks right at
  // 0.002 to 0.1 radii, 1 % too low at 0.00136, 22 % at 0.00114. Of stiff
  // skins, depth over the radius and ratio of moduli: 0.27 % too high at 2e-4
  // and 55, 1.3 % at 2e-4 and 200, 4 % at 5e-4 and 4000, 25 to 30 % at 2.5e-4
  // and 4000, right at 1e-3 and 100, which the formula is within a factor of 2
  // of.
  constexpr double thinnest_ring = 0.002;
  constexpr double noted = 0.01;
  const auto error = [](double depth, double ratio) {
    const double thin = 2e-4 / depth;
    return 0.013 * (ratio / 200) * thin * thin;
  };
  if (const double ring = free_ring_thickness(pair); ring < thinnest_ring) {
    return message(
        "a free ring of {:.3g} radii is below {:g}: it presses on strips that "
        "are not resolved, and its peak pressure may be too low by 1 % and "
        "more",
        ring, thinnest_ring);
  }
  for (const LayeredBody* body : {&pair.inner(), &pair.outer()}) {
    double depth = 0;
    for (std::size_t i = 0; i < body->layers.size(); ++i) {
      depth += body->layers[i].thickness / pair.radius();
      const Material& below = i + 1 < body->layers.size()
                                  ? body->layers[i + 1].material
                                  : body->backing.material();
      const double ratio =
          body->layers[i].material.youngs_modulus / below.youngs_modulus;
      const bool ends = i + 1 == body->layers.size() &&
                        body->backing.kind() == Backing::Kind::held;
      if (ends || !(error(depth, ratio) > noted)) continue;
      return message(
          "a skin of {:.3g} radii on a body {:.3g} times softer: its peak "
          "pressure is not resolved, some {:.2g} % too high; the half-angle "
          "holds",
          depth, ratio, 100 * error(depth, ratio));
    }
  }
  return {};
}

int gap_unknowns(const LayeredPair& pair) {
  // Measured: conforming/gap_test.cpp.
  const double thickness = edge_layer(pair);
  if (thickness > 0.5) return 16;
  if (thickness > 0.15) return 24;
  if (thickness > 0.05) return 32;
  return thickness > 0.015 ? 48 : 64;
}

bool can_have_interference(JointKind kind, const LayeredPair& pair) {
  // Rounding of c_0, which is of the order of the thickness otherwise.
  constexpr double incompressible = 1e-12;
  const double mean = LayerCompliance(kind, Side::inner, pair)(0).total +
                      LayerCompliance(kind, Side::outer, pair)(0).total;
  return mean > incompressible;
}

LayeredPair without_layers(const ElasticPair& pair) {
  return {1,
          {{}, Backing::medium(pair.inner())},
          {{}, Backing::medium(pair.outer())}};
}

void require_uncoated(const LayeredPair& pair, const InnerLoading& loading) {
  if (!loading.is_back() || pair.inner().layers.empty()) return;
  throw Error(needs("loading = back", "an inner body without coatings"));
}

}  // namespace contact::detail
