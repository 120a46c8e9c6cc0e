#include "angle/angle_table.hpp"

#include <fmt/format.h>

#include <cmath>

#include "libcontact/base/units.hpp"

namespace hinge_angle {
namespace {

void count(contact::Status status, Failures& failures) {
  if (status == contact::Status::out_of_range) ++failures.out_of_range;
  if (status == contact::Status::not_converged) ++failures.not_converged;
}

}  // namespace

AngleTable::AngleTable(const cli::Joint& joint, const Loads& loads)
    : joint_(joint),
      loads_(loads),
      laws_(joint.laws),
      pressure_(joint.pressures[0]) {
  if (!joint.geometry) return;
  for (const NamedLaw& law : laws_) {
    if (!cli::JointApproach::of(*law.law)) continue;
    approach_.emplace(law.law, *joint.geometry, joint.pair, 1);
  }
}

void AngleTable::add_columns(const NamedLaw& law,
                             std::vector<std::string>& names) const {
  const std::string& pressure = pressure_.name;
  names.push_back(fmt::format(
      "p_peak_{}{}_{}", law.name,
      pressure == contact::default_pressure_law ? "" : "_by_" + pressure,
      loads_.have_load() ? "Pa" : "over_mean"));
  if (!approach_ || !cli::JointApproach::of(*law.law)) return;
  for (std::string& name : cli::JointApproach::columns(joint_.kind)) {
    names.push_back(std::move(name));
  }
}

void AngleTable::write(const NamedLaw& law, double half_angle,
                       double load_parameter, cli::RowWriter& row) const {
  row.number(peak_pressure(half_angle, load_parameter));
  if (!approach_ || !cli::JointApproach::of(*law.law)) return;
  const contact::ContactApproach value = (*approach_)(half_angle);
  row.number(value.approach);
  row.number(value.stiffness);
}

std::vector<std::string> AngleTable::columns() const {
  std::vector<std::string> names;
  if (loads_.have_load()) names.emplace_back("load");
  names.emplace_back("load_parameter");
  names.emplace_back("x");
  for (const NamedLaw& law : laws_) {
    names.push_back(fmt::format("theta0_{}_deg", law.name));
    add_columns(law, names);
  }
  return names;
}

std::vector<std::string> AngleTable::inverse_columns() const {
  std::vector<std::string> names = {"theta0_deg"};
  for (const NamedLaw& law : laws_) {
    if (loads_.have_load()) names.push_back("load_" + law.name);
    names.push_back("load_parameter_" + law.name);
    names.push_back("x_" + law.name);
    add_columns(law, names);
  }
  return names;
}

void AngleTable::write_row(LoadVariable variable, double load,
                           cli::RowWriter& row,
                           std::vector<Failures>& failures) const {
  const double parameter =
      loads_.convert(variable, load, LoadVariable::load_parameter);
  if (loads_.have_load()) {
    row.number(loads_.convert(variable, load, LoadVariable::load));
  }
  row.number(parameter);
  row.number(loads_.convert(variable, load, LoadVariable::x));
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    const contact::HalfAngleResult result = laws_[i].law->half_angle(parameter);
    count(result.status, failures[i]);
    row.number(result.half_angle / contact::degree);
    write(laws_[i], result.half_angle, parameter, row);
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
    const auto load_as = [&](LoadVariable variable) {
      return loads_.convert(LoadVariable::load_parameter, parameter, variable);
    };
    if (loads_.have_load()) row.number(load_as(LoadVariable::load));
    row.number(parameter);
    row.number(load_as(LoadVariable::x));
    write(laws_[i], half_angle, parameter, row);
  }
  row.end();
}

double AngleTable::peak_pressure(double half_angle,
                                 double load_parameter) const {
  if (std::isnan(load_parameter)) return load_parameter;
  if (!loads_.have_load()) return pressure_.law->peak(half_angle);
  // The contact shrinks with the load, but slower.
  if (load_parameter == 0) return 0;
  return pressure_.law->peak(half_angle) *
         joint_.geometry->pressure_unit(loads_.convert(
             LoadVariable::load_parameter, load_parameter, LoadVariable::load));
}

}  // namespace hinge_angle
