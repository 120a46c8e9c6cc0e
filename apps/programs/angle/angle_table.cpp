#include "programs/angle/angle_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "cli/column_of.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/pressure/hertz.hpp"

namespace hinge_angle {
namespace {

std::string patch_column(std::string_view key, std::string_view law = "") {
  return cli::column_of(contact::patch_quantities(), key, law);
}

// Counts what the laws of one row could not give.
class RowCount {
 public:
  explicit RowCount(std::vector<Findings>& findings) : findings_(findings) {}

  void add(std::size_t law, contact::Status status) {
    if (status == contact::Status::out_of_range) {
      ++findings_[law].out_of_range;
      ++without_;
    }
    if (status == contact::Status::not_converged) {
      ++findings_[law].not_converged;
    }
  }
  void end() {
    if (without_ < findings_.size()) return;
    for (Findings& law : findings_) ++law.empty;
  }

 private:
  std::vector<Findings>& findings_;
  std::size_t without_ = 0;
};

}  // namespace

void Findings::add(const Findings& more) {
  out_of_range += more.out_of_range;
  empty += more.empty;
  not_converged += more.not_converged;
  largest.add(more.largest);
}

AngleTable::AngleTable(const cli::Joint& joint, const Input& input,
                       bool own_hertz, bool preload)
    : joint_(joint),
      input_(input),
      loads_(joint),
      own_hertz_(own_hertz),
      laws_(joint.laws),
      pressure_(joint.pressures[0]) {
  if (!joint.has_size) return;
  for (const NamedLaw& law : laws_) {
    if (cli::JointApproach::of(*law.law)) approach_.emplace(law.law, joint);
  }
  if (!preload) return;
  has_clearance_ = joint.spec.geometry.radial_clearance() > 0;
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    preload_.emplace_back(joint, i);
    if (cli::JointApproach::of(*laws_[i].law)) preload_law_ = i;
  }
}

bool AngleTable::is_own_hertz(const NamedLaw& law) const {
  return own_hertz_ && law.name == "hertz";
}

void AngleTable::add_columns(const NamedLaw& law,
                             std::vector<std::string>& names) const {
  const std::string by = fmt::format(
      "{}_by_{}", law.name, is_own_hertz(law) ? law.name : pressure_.name);
  names.push_back(loads_.have_load()
                      ? patch_column("peak_pressure", by)
                      : fmt::format("p_peak_{}_over_nominal", by));
  if (!approach_ || !cli::JointApproach::of(*law.law)) return;
  for (std::string& name : approach_->columns()) {
    names.push_back(std::move(name));
  }
}

void AngleTable::write(std::size_t i, const Cell& cell, cli::RowWriter& row,
                       Findings& findings) const {
  const NamedLaw& law = laws_[i];
  const double peak =
      has_clearance_
          ? peak_pressure(law, cell.half_angle, cell.load_parameter)
          : preload_[i].contact().peak_pressure(cell.force, cell.half_angle);
  row.number(peak);
  findings.largest.add(cell.half_angle, loads_.have_load() ? peak : 0);
  if (!approach_ || !cli::JointApproach::of(*law.law)) return;
  const contact::ContactApproach value = (*approach_)(cell.half_angle);
  row.number(value.approach);
  row.number(value.stiffness);
}

void AngleTable::write_preload(const Cell& cell, cli::RowWriter& row) const {
  if (preload_.empty()) return;
  preload_[preload_law_].write(cell.force, cell.half_angle, row);
}

void AngleTable::add_preload_columns(std::vector<std::string>& names) const {
  if (preload_.empty()) return;
  std::ranges::move(preload_[0].columns(), std::back_inserter(names));
}

std::vector<std::string> AngleTable::columns() const {
  std::vector<std::string> names;
  if (input_.inverse) {
    names.push_back(patch_column("half_angle"));
    for (const NamedLaw& law : laws_) {
      if (loads_.have_load()) names.push_back(loads_.column(law.name));
      names.push_back(patch_column("load_parameter", law.name));
      names.push_back("x_" + law.name);
      if (loads_.have_load()) {
        names.push_back(patch_column("nominal_pressure", law.name));
      }
      add_columns(law, names);
    }
    add_preload_columns(names);
    return names;
  }
  if (loads_.have_load()) names.push_back(loads_.column());
  names.push_back(patch_column("load_parameter"));
  names.emplace_back("x");
  if (loads_.have_load()) names.push_back(patch_column("nominal_pressure"));
  for (const NamedLaw& law : laws_) {
    names.push_back(patch_column("half_angle", law.name));
    add_columns(law, names);
  }
  add_preload_columns(names);
  return names;
}

void AngleTable::write_row(std::size_t index, cli::RowWriter& row,
                           std::vector<Findings>& findings) const {
  cli::write_differences(joint_.differences, row);
  const double value = input_.values[index];
  if (input_.inverse) {
    write_half_angle_row(value, row, findings);
  } else {
    write_load_row(value, row, findings);
  }
  row.end();
}

void AngleTable::write_load_row(double load, cli::RowWriter& row,
                                std::vector<Findings>& findings) const {
  const auto load_as = [&](LoadVariable variable) {
    return loads_.convert(input_.variable, load, variable);
  };
  const double parameter = load_as(LoadVariable::load_parameter);
  const double force = loads_.have_load() ? load_as(LoadVariable::load) : 0;
  if (loads_.have_load()) row.number(force);
  row.number(parameter);
  row.number(load_as(LoadVariable::x));
  if (loads_.have_load()) {
    row.number(has_clearance_ ? loads_.nominal_pressure(parameter)
                              : joint_.spec.geometry.nominal_pressure(force));
  }
  RowCount count(findings);
  Cell of_preload{};
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    const contact::HalfAngleLaw& law = *laws_[i].law;
    const contact::HalfAngleResult result =
        law.half_angle(parameter * loads_.factor(law));
    count.add(i, result.status);
    row.number(result.half_angle / contact::degree);
    const Cell cell{result.half_angle, parameter, force};
    write(i, cell, row, findings[i]);
    if (i == preload_law_) of_preload = cell;
  }
  count.end();
  write_preload(of_preload, row);
}

void AngleTable::write_half_angle_row(double theta0_deg, cli::RowWriter& row,
                                      std::vector<Findings>& findings) const {
  const double half_angle = theta0_deg * contact::degree;
  row.number(theta0_deg);
  RowCount count(findings);
  Cell of_preload{};
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    const contact::HalfAngleLaw& law = *laws_[i].law;
    contact::LoadParameterResult result = law.load_parameter(half_angle);
    result.load_parameter /= loads_.factor(law);
    // Half-angles of another sign of the clearance. Without clearance there is
    // one, which every load makes.
    if (loads_.have_load() && !loads_.makes(result.load_parameter)) {
      result = {std::numeric_limits<double>::quiet_NaN(),
                contact::Status::out_of_range};
    }
    const double parameter = result.load_parameter;
    count.add(i, result.status);
    const auto load_as = [&](LoadVariable variable) {
      return loads_.convert(LoadVariable::load_parameter, parameter, variable);
    };
    const double force = loads_.have_load() ? load_as(LoadVariable::load) : 0;
    if (loads_.have_load()) row.number(force);
    row.number(parameter);
    row.number(load_as(LoadVariable::x));
    if (loads_.have_load()) row.number(loads_.nominal_pressure(parameter));
    const Cell cell{half_angle, parameter, force};
    write(i, cell, row, findings[i]);
    if (i == preload_law_) of_preload = cell;
  }
  count.end();
  write_preload(of_preload, row);
}

double AngleTable::peak_pressure(const NamedLaw& law, double half_angle,
                                 double load_parameter) const {
  if (std::isnan(load_parameter)) return load_parameter;
  const bool hertz = is_own_hertz(law);
  if (!loads_.have_load()) {
    return hertz ? contact::hertz_peak_over_nominal(joint_.kind(), half_angle)
                 : pressure_.law->peak(half_angle) *
                       cli::nominal_area(joint_.kind());
  }
  // The contact shrinks with the load, but slower.
  if (load_parameter == 0) return 0;
  const double load = loads_.law_load(load_parameter);
  return hertz ? contact::hertz_peak_pressure(joint_.spec.geometry, load,
                                              half_angle)
               : pressure_.law->peak(half_angle) *
                     joint_.spec.geometry.pressure_unit(load);
}

}  // namespace hinge_angle
