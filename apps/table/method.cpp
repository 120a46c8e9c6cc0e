#include "table/method.hpp"

#include "cli/choice.hpp"
#include "libcontact/friction_exact.hpp"

namespace hinge_table {
namespace {

// A method that takes one point at a time.
template <class Function>
Method pointwise(Function function) {
  return [function](std::span<const double> half_angles,
                    std::span<const contact::SlipAxis> axes,
                    std::span<contact::FrictionIntegrals> results) {
    for (std::size_t i = 0; i < results.size(); ++i) {
      results[i] = function(half_angles[i], axes[i]);
    }
  };
}

}  // namespace

std::array<double, quantities.size()> values(
    const contact::FrictionIntegrals& integrals) {
  const auto& [normal, p, a, coefficient] = integrals;
  return {normal,
          p.force,
          p.sliding,
          p.spinning,
          a.force,
          a.sliding,
          a.spinning,
          coefficient.force,
          coefficient.sliding,
          coefficient.spinning};
}

Method find_method(const std::string& name, double /*tolerance*/) {
  const std::array<cli::Choice<Method>, 1> methods = {
      {{"exact", pointwise(contact::exact_friction_integrals)}}};
  return cli::choice("--method", name, methods);
}

}  // namespace hinge_table
