#include "table/method.hpp"

#include "cli/choice.hpp"
#include "libcontact/friction_batch.hpp"
#include "libcontact/friction_elliptic.hpp"
#include "libcontact/friction_integrals.hpp"
#include "libcontact/friction_models.hpp"

namespace hinge_table {
namespace {

void exact(const Points& points, const Columns& columns) {
  const auto& [normal, i_p, j_p, k_p, i_a, j_a, k_a, chi, sigma_y, sigma_z] =
      columns;
  contact::exact_friction_integrals(
      {points.half_angle, points.axis_sin, points.axis_cos},
      {normal, i_p, j_p, k_p, i_a, j_a, k_a, chi, sigma_y, sigma_z});
}

// A method that takes one point at a time.
template <class Function>
Method pointwise(const Function& function) {
  return [function](const Points& points, const Columns& columns) {
    for (std::size_t i = 0; i < points.half_angle.size(); ++i) {
      const contact::FrictionIntegrals result =
          function(points.half_angle[i],
                   contact::SlipAxis{points.axis_sin[i], points.axis_cos[i]});
      const auto& [normal, p, a, coefficient] = result;
      const std::array<double, quantities.size()> values = {
          normal,
          p.force,
          p.sliding,
          p.spinning,
          a.force,
          a.sliding,
          a.spinning,
          coefficient.force,
          coefficient.sliding,
          coefficient.spinning};
      for (std::size_t j = 0; j < values.size(); ++j) {
        columns[j][i] = values[j];
      }
    }
  };
}

}  // namespace

Method find_method(const std::string& name, double /*tolerance*/) {
  const std::array<cli::Choice<Method>, 5> methods = {{
      {"exact", exact},
      {"elliptic", pointwise(contact::elliptic_friction_integrals)},
      {"planar", pointwise(contact::planar_friction_integrals)},
      {"viscous", pointwise(contact::viscous_friction_integrals)},
      {"cosine", pointwise(contact::cosine_friction_integrals)},
  }};
  return cli::choice("--method", name, methods);
}

}  // namespace hinge_table
