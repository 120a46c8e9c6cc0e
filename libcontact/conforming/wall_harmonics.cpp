#include "libcontact/conforming/wall_harmonics.hpp"

#include <algorithm>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/conforming/layer_compliance.hpp"

namespace contact::detail {

WallHarmonics::WallHarmonics(JointKind kind, const LayeredPair& pair)
    : first(0) {
  using Side = LayerCompliance::Side;
  for (const Side side : {Side::inner, Side::outer}) {
    const LayerCompliance compliance(
        kind, side, side == Side::inner ? pair.inner() : pair.outer(),
        pair.radius(), pair.surfaces().effective_modulus());
    const int count = compliance.corrected();
    correction.resize(std::max<std::size_t>(correction.size(), count));
    for (int n = 0; n < count; ++n) {
      if (n != 1) correction[n] += compliance(n).correction;
    }
    first += compliance(1).total;
  }
}

int walled_unknowns(const LayeredPair& pair) {
  // Measured: docs/conforming.md, "Walls".
  const double thickness = pair.relative_thickness();
  if (thickness > 0.09) return 16;
  if (thickness > 0.025) return 24;
  if (thickness > 0.009) return 32;
  return thickness > 0.0045 ? 48 : 64;
}

void require_uncoated(const LayeredPair& pair, const InnerLoading& loading) {
  if (!loading.is_back() || pair.inner().layers.empty()) return;
  throw Error(needs("loading = back", "an inner body without coatings"));
}

}  // namespace contact::detail
