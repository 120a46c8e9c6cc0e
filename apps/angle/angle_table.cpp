#include "angle/angle_table.hpp"

#include <fmt/format.h>

#include <cmath>

#include "libcontact/units.hpp"

namespace hinge_angle {
namespace {

void count(contact::Status status, Failures& failures) {
  if (status == contact::Status::out_of_range) ++failures.out_of_range;
  if (status == contact::Status::not_converged) ++failures.not_converged;
}

}  // namespace

AngleTable::AngleTable(const Setup& setup, const std::vector<NamedLaw>& laws,
                       const contact::PressureLaw& pressure)
    : setup_(setup), laws_(laws), pressure_(pressure) {
  if (setup.geometry) scale_.emplace(*setup.geometry, setup.pair);
}

std::string AngleTable::peak_column(const NamedLaw& law) const {
  const std::string pressure = pressure_.name();
  return fmt::format(
      "p_peak_{}{}_{}", law.name,
      pressure == contact::default_pressure_law ? "" : "_by_" + pressure,
      scale_ ? "Pa" : "over_mean");
}

std::vector<std::string> AngleTable::columns() const {
  std::vector<std::string> names;
  if (scale_) names.emplace_back("load");
  names.emplace_back("load_parameter");
  names.emplace_back("x");
  for (const NamedLaw& law : laws_) {
    names.push_back(fmt::format("theta0_{}_deg", law.name));
    names.push_back(peak_column(law));
  }
  return names;
}

std::vector<std::string> AngleTable::inverse_columns() const {
  std::vector<std::string> names = {"theta0_deg"};
  for (const NamedLaw& law : laws_) {
    if (scale_) names.push_back("load_" + law.name);
    names.push_back("load_parameter_" + law.name);
    names.push_back("x_" + law.name);
    names.push_back(peak_column(law));
  }
  return names;
}

void AngleTable::write_row(LoadVariable variable, double load,
                           cli::RowWriter& row,
                           std::vector<Failures>& failures) const {
  const double parameter =
      convert(variable, load, LoadVariable::load_parameter);
  if (scale_) row.number(convert(variable, load, LoadVariable::load));
  row.number(parameter);
  row.number(convert(variable, load, LoadVariable::x));
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    const contact::HalfAngleResult result = laws_[i].law->half_angle(parameter);
    count(result.status, failures[i]);
    row.number(result.half_angle / contact::degree);
    row.number(peak_pressure(result.half_angle, parameter));
  }
  row.end();
}

void AngleTable::write_inverse_row(double theta0_deg, cli::RowWriter& row,
                                   std::vector<Failures>& failures) const {
  const double half_angle = theta0_deg * contact::degree;
  row.number(theta0_deg);
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    const contact::LoadParameterResult result =
        laws_[i].law->load_parameter(half_angle);
    const double parameter = result.load_parameter;
    count(result.status, failures[i]);
    if (scale_) row.number(scale_->load(parameter));
    row.number(parameter);
    row.number(contact::x_from_load_parameter(setup_.kind, parameter));
    row.number(peak_pressure(half_angle, parameter));
  }
  row.end();
}

double AngleTable::peak_pressure(double half_angle,
                                 double load_parameter) const {
  if (std::isnan(load_parameter)) return load_parameter;
  if (!scale_) return pressure_.peak(half_angle);
  // The contact shrinks with the load, but slower.
  if (load_parameter == 0) return 0;
  return pressure_.peak(half_angle) *
         setup_.geometry->pressure_unit(scale_->load(load_parameter));
}

double AngleTable::convert(LoadVariable from, double load,
                           LoadVariable to) const {
  if (from == to) return load;
  double parameter = load;
  if (from == LoadVariable::load) parameter = scale_->load_parameter(load);
  if (from == LoadVariable::x) {
    parameter = contact::load_parameter_from_x(setup_.kind, load);
  }
  switch (to) {
    case LoadVariable::load:
      return scale_->load(parameter);
    case LoadVariable::x:
      return contact::x_from_load_parameter(setup_.kind, parameter);
    case LoadVariable::load_parameter:
      break;
  }
  return parameter;
}

}  // namespace hinge_angle
