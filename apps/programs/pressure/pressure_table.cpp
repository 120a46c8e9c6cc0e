#include "programs/pressure/pressure_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "libcontact/base/units.hpp"
#include "libcontact/friction/friction_integrals.hpp"

namespace hinge_pressure {

PressureTable::PressureTable(const cli::Joint& joint)
    : joint_(joint), loads_(joint) {
  const auto& law = joint.laws[0].law;
  if (joint.has_size && cli::JointApproach::of(*law)) {
    approach_.emplace(law, joint);
  }
}

// A pressure unit in Pa, or in nominal pressures.
double PressureTable::scale(const LoadedContact& contact) const {
  return joint_.has_size ? joint_.spec.geometry.pressure_unit(
                               loads_.law_load(contact.load_parameter))
                         : cli::nominal_area(joint_.kind());
}

double PressureTable::pressure(const NamedPressure& law,
                               const LoadedContact& contact,
                               double theta) const {
  // The contact shrinks with the load, but slower.
  if (joint_.has_size && contact.load == 0) return 0;
  return scale(contact) * law.law->pressure(theta, contact.half_angle);
}

void PressureTable::write_contact(const LoadedContact& contact,
                                  cli::RowWriter& row) const {
  cli::write_differences(joint_.differences, row);
  if (joint_.has_size) row.number(contact.load);
  row.number(contact.load_parameter);
  row.number(contact.half_angle / contact::degree);
  if (joint_.spec.loading.is_back()) row.text(to_string(joint_.spec.loading));
}

std::vector<std::string> PressureTable::contact_columns() const {
  std::vector<std::string> names;
  if (joint_.has_size) names.push_back(loads_.column());
  names.insert(names.end(), {"load_parameter", "theta0_deg"});
  if (joint_.spec.loading.is_back()) names.emplace_back("loading");
  return names;
}

std::vector<std::string> PressureTable::profile_columns() const {
  std::vector<std::string> names = contact_columns();
  names.emplace_back("theta_deg");
  for (const NamedPressure& law : joint_.pressures) {
    names.push_back(fmt::format("p_{}_{}", law.name, unit()));
  }
  return names;
}

void PressureTable::write_profile(const LoadedContact& contact, int points,
                                  cli::RowWriter& row) const {
  for (int i = 0; i < points; ++i) {
    const double theta = contact.half_angle * i / (points - 1);
    write_contact(contact, row);
    row.number(theta / contact::degree);
    for (const NamedPressure& law : joint_.pressures) {
      row.number(pressure(law, contact, theta));
    }
    row.end();
  }
}

std::vector<std::string> PressureTable::summary_columns() const {
  std::vector<std::string> names = contact_columns();
  names.insert(names.end(), {"law", "pressure"});
  names.push_back("p_peak_" + unit());
  names.push_back("p_mean_" + unit());
  if (joint_.has_size) names.emplace_back("p_nominal_Pa");
  const bool ball = joint_.kind() == contact::JointKind::ball;
  if (joint_.has_size) {
    names.emplace_back(ball ? "contact_area_m2" : "contact_width_m");
  } else {
    names.emplace_back(ball ? "contact_area_over_R2" : "contact_width_over_R");
  }
  names.emplace_back("S");
  if (ball) names.insert(names.end(), {"chi_0", "sigma_Y_0", "sigma_Z_90"});
  if (approach_) {
    for (auto& name : approach_->columns()) names.push_back(std::move(name));
  }
  return names;
}

void PressureTable::write_summary(const LoadedContact& contact,
                                  cli::RowWriter& row) const {
  const double half_angle = contact.half_angle;
  const double radius = joint_.has_size ? joint_.spec.geometry.radius() : 1;
  const double sine = std::sin(half_angle / 2);
  const double area = joint_.kind() == contact::JointKind::ball
                          ? 4 * std::numbers::pi * sine * sine * radius * radius
                          : 2 * half_angle * radius;
  const bool unloaded = joint_.has_size && contact.load == 0;
  const contact::ContactApproach approach =
      approach_ ? (*approach_)(half_angle) : contact::ContactApproach{};
  for (const NamedPressure& law : joint_.pressures) {
    write_contact(contact, row);
    row.text(joint_.laws[0].name);
    row.text(law.name);
    row.number(unloaded ? 0 : scale(contact) * law.law->peak(half_angle));
    row.number(unloaded ? 0 : scale(contact) * law.law->mean(half_angle));
    if (joint_.has_size) {
      row.number(loads_.nominal_pressure(contact.load_parameter));
    }
    row.number(area);
    row.number(law.law->force_ratio(half_angle));
    if (joint_.kind() == contact::JointKind::ball) {
      const auto coefficients = [&](contact::SlipAxis axis) {
        return contact::friction_integrals(*law.law, half_angle, axis)
            .coefficient;
      };
      const contact::FrictionTriple slide = coefficients({0, 1});
      row.number(slide.force);
      row.number(slide.sliding);
      row.number(coefficients({1, 0}).spinning);
    }
    if (approach_) {
      row.number(approach.approach);
      row.number(approach.stiffness);
    }
    row.end();
  }
}

}  // namespace hinge_pressure
