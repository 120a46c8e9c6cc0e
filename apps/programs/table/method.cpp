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
#include "libcontact/tools/reference/quadrature.hpp"
#endif

namespace hinge_table {
namespace {

constexpr std::string_view papers_pressure = "cosine";

using Pressure = std::shared_ptr<const contact::PressureLaw>;

MethodFunction exact(const Pressure& pressure) {
  return [pressure](const Points& points, const Columns& columns) {
    contact::friction_integrals(
        *pressure, {points.half_angle, points.axis_sin, points.axis_cos},
        {columns[0], columns[1], columns[2], columns[3], columns[4], columns[5],
         columns[6], columns[7], columns[8], columns[9]});
    return std::size_t{0};
  };
}

// Row `i` of the columns.
void set(const Columns& columns, std::size_t i,
         const contact::FrictionIntegrals& result) {
  for (std::size_t j = 0; j < columns.size(); ++j) {
    columns[j][i] = contact::number_of(quantities()[j], result);
  }
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
  struct Row {
    MethodFunction function;
    bool any_pressure;
  };
  const std::vector<cli::Choice<Row>> methods = {
      {"exact", {exact(pressure), true}},
      {"elliptic", {pointwise(contact::elliptic_friction_integrals), false}},
#ifdef CONTACT_WITH_REFERENCE
      {"quadrature", {quadrature(tolerance, pressure), true}},
#endif
      {"planar", {pointwise(contact::planar_friction_integrals), false}},
      {"viscous", {pointwise(viscous), true}},
      {"cosine", {pointwise(contact::cosine_friction_integrals), false}},
  };
  if (name == "chebyshev") {
    cli::refuse_without(cli::given("--method", name), "--quantity K,E");
  }
  const Row method = cli::choice("--method", name, methods);
  if (!method.any_pressure && pressure->name() != papers_pressure) {
    std::vector<std::string> others;
    for (const auto& [other, row] : methods) {
      if (row.any_pressure) others.emplace_back(other);
    }
    cli::refuse_without(
        cli::given("--method", name),
        fmt::format("the pressure {}; {} goes with {}", papers_pressure,
                    pressure->name(), contact::detail::either(others)));
  }
  return {method.function, named.name, pressure->largest_half_angle()};
}

}  // namespace hinge_table
