#include "table/method.hpp"

#include <fmt/format.h>

#include <vector>

#include "cli/choice.hpp"
#include "cli/number.hpp"
#include "libcontact/friction_batch.hpp"
#include "libcontact/friction_elliptic.hpp"
#include "libcontact/friction_integrals.hpp"
#include "libcontact/friction_models.hpp"
#ifdef CONTACT_WITH_REFERENCE
#include "libcontact/reference/quadrature.hpp"
#endif

namespace hinge_table {
namespace {

std::size_t exact(const Points& points, const Columns& columns) {
  const auto& [normal, i_p, j_p, k_p, i_a, j_a, k_a, chi, sigma_y, sigma_z] =
      columns;
  contact::exact_friction_integrals(
      {points.half_angle, points.axis_sin, points.axis_cos},
      {normal, i_p, j_p, k_p, i_a, j_a, k_a, chi, sigma_y, sigma_z});
  return 0;
}

// Row `i` of the columns.
void set(const Columns& columns, std::size_t i,
         const contact::FrictionIntegrals& result) {
  const auto& [normal, p, a, coefficient] = result;
  const std::array<double, quantities.size()> values = {normal,
                                                        p.force,
                                                        p.sliding,
                                                        p.spinning,
                                                        a.force,
                                                        a.sliding,
                                                        a.spinning,
                                                        coefficient.force,
                                                        coefficient.sliding,
                                                        coefficient.spinning};
  for (std::size_t j = 0; j < values.size(); ++j) columns[j][i] = values[j];
}

// A method that takes one point at a time.
using PointMethod = contact::FrictionIntegrals (*)(double, contact::SlipAxis);

Method pointwise(PointMethod function) {
  return [function](const Points& points, const Columns& columns) {
    for (std::size_t i = 0; i < points.half_angle.size(); ++i) {
      set(columns, i,
          function(points.half_angle[i],
                   {points.axis_sin[i], points.axis_cos[i]}));
    }
    return std::size_t{0};
  };
}

#ifdef CONTACT_WITH_REFERENCE
Method quadrature(double tolerance) {
  return [tolerance](const Points& points, const Columns& columns) {
    std::size_t missed = 0;
    for (std::size_t i = 0; i < points.half_angle.size(); ++i) {
      const auto result = contact::reference::quadrature_friction_integrals(
          points.half_angle[i], {points.axis_sin[i], points.axis_cos[i]},
          tolerance);
      set(columns, i, result.value);
      if (result.status == contact::Status::not_converged) ++missed;
    }
    return missed;
  };
}
#endif

}  // namespace

Method find_method(const std::string& name, double tolerance) {
  constexpr cli::Allowed allowed{1e-13, 1e-2, ""};
  if (!allowed.contains(tolerance)) {
    throw contact::Error(
        fmt::format("--tolerance {}: allowed {}", tolerance, allowed.text()));
  }
  const std::vector<cli::Choice<Method>> methods = {
      {"exact", exact},
      {"elliptic", pointwise(contact::elliptic_friction_integrals)},
#ifdef CONTACT_WITH_REFERENCE
      {"quadrature", quadrature(tolerance)},
#endif
      {"planar", pointwise(contact::planar_friction_integrals)},
      {"viscous", pointwise(contact::viscous_friction_integrals)},
      {"cosine", pointwise(contact::cosine_friction_integrals)},
  };
  return cli::choice("--method", name, methods);
}

}  // namespace hinge_table
