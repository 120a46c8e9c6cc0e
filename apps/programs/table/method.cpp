#include "programs/table/method.hpp"

#include <fmt/format.h>

#include <vector>

#include "cli/choice.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "libcontact/friction/elliptic/friction.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/friction/integrals.hpp"
#include "libcontact/friction/models.hpp"
#ifdef CONTACT_WITH_REFERENCE
#include "libcontact/reference/quadrature.hpp"
#endif

namespace hinge_table {
namespace {

constexpr std::string_view papers_pressure = "cosine";

using Pressure = std::shared_ptr<const contact::PressureLaw>;

MethodFunction exact(const Pressure& pressure) {
  return [pressure](const Points& points, const Columns& columns) {
    const auto& [normal, i_p, j_p, k_p, i_a, j_a, k_a, chi, sigma_y, sigma_z] =
        columns;
    contact::friction_integrals(
        *pressure, {points.half_angle, points.axis_sin, points.axis_cos},
        {normal, i_p, j_p, k_p, i_a, j_a, k_a, chi, sigma_y, sigma_z});
    return std::size_t{0};
  };
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
template <class PointMethod>
MethodFunction pointwise(PointMethod function) {
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
MethodFunction quadrature(double tolerance, const Pressure& pressure) {
  const bool cosine = pressure->name() == papers_pressure;
  return [tolerance, pressure, cosine](const Points& points,
                                       const Columns& columns) {
    std::size_t missed = 0;
    for (std::size_t i = 0; i < points.half_angle.size(); ++i) {
      const double half_angle = points.half_angle[i];
      const contact::SlipAxis axis{points.axis_sin[i], points.axis_cos[i]};
      namespace reference = contact::reference;
      const auto result = cosine ? reference::quadrature_friction_integrals(
                                       half_angle, axis, tolerance)
                                 : reference::quadrature_friction_integrals(
                                       *pressure, half_angle, axis, tolerance);
      set(columns, i, result.value);
      if (result.status == contact::Status::not_converged) ++missed;
    }
    return missed;
  };
}
#endif

}  // namespace

Method find_method(const std::string& name, double tolerance,
                   const cli::NamedPressure& named) {
  const Pressure& pressure = named.law;
  const auto viscous = [pressure](double half_angle, contact::SlipAxis axis) {
    return contact::viscous_friction_integrals(*pressure, half_angle, axis);
  };
  const std::vector<cli::Choice<MethodFunction>> methods = {
      {"exact", exact(pressure)},
      {"elliptic", pointwise(contact::elliptic_friction_integrals)},
#ifdef CONTACT_WITH_REFERENCE
      {"quadrature", quadrature(tolerance, pressure)},
#endif
      {"planar", pointwise(contact::planar_friction_integrals)},
      {"viscous", pointwise(viscous)},
      {"cosine", pointwise(contact::cosine_friction_integrals)},
  };
  MethodFunction function = cli::choice("--method", name, methods);
  if ((name == "elliptic" || name == "planar" || name == "cosine") &&
      pressure->name() != papers_pressure) {
    cli::refuse_without(
        cli::given("--method", name),
        fmt::format(
            "the pressure cosine; {} goes with exact, quadrature or viscous",
            pressure->name()));
  }
  return {std::move(function), named.name, pressure->largest_half_angle()};
}

}  // namespace hinge_table
