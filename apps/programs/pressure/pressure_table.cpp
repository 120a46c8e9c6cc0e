#include "programs/pressure/pressure_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "cli/column_of.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/friction/friction_integrals.hpp"

namespace hinge_pressure {
namespace {

std::string patch_column(std::string_view key) {
  return cli::column_of(contact::patch_quantities(), key);
}

}  // namespace

PressureTable::PressureTable(const cli::Joint& joint, bool preload)
    : joint_(joint), loads_(joint) {
  const auto& law = joint.laws[0].law;
  if (joint.has_size && cli::JointApproach::of(*law)) {
    approach_.emplace(law, joint);
  }
  if (!joint.has_size || !preload) return;
  has_clearance_ = joint.spec.geometry.radial_clearance() > 0;
  for (std::size_t i = 0; i < joint.pressures.size(); ++i) {
    preload_.emplace_back(joint, 0, i);
  }
}

// A pressure unit in Pa, or in nominal pressures.
double PressureTable::scale(const LoadedContact& contact) const {
  return joint_.has_size ? joint_.spec.geometry.pressure_unit(
                               loads_.law_load(contact.load_parameter))
                         : cli::nominal_area(joint_.kind());
}

double PressureTable::pressure(std::size_t i, const LoadedContact& contact,
                               double theta) const {
  if (!has_clearance_) {
    return preload_[i].contact().pressure(theta, contact.load,
                                          contact.half_angle);
  }
  // The contact shrinks with the load, but more slowly than the load.
  if (joint_.has_size && contact.load == 0) return 0;
  return scale(contact) *
         joint_.pressures[i].law->pressure(theta, contact.half_angle);
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
  names.push_back(patch_column("load_parameter"));
  names.push_back(patch_column("half_angle"));
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
    for (std::size_t k = 0; k < joint_.pressures.size(); ++k) {
      row.number(pressure(k, contact, theta));
    }
    row.end();
  }
}

std::vector<std::string> PressureTable::summary_columns() const {
  std::vector<std::string> names = contact_columns();
  names.insert(names.end(), {"law", "pressure"});
  const bool ball = joint_.kind() == contact::JointKind::ball;
  if (joint_.has_size) {
    for (const char* key :
         {"peak_pressure", "mean_pressure", "nominal_pressure"}) {
      names.push_back(patch_column(key));
    }
    names.push_back(ball ? patch_column("contact_area") : "contact_width_m");
  } else {
    names.insert(names.end(),
                 {"p_peak_" + unit(), "p_mean_" + unit(),
                  ball ? "contact_area_over_R2" : "contact_width_over_R"});
  }
  names.emplace_back("S");
  if (ball) {
    // At the slip axis angle of each: sliding, sliding, spinning.
    for (const auto& [key, angle] :
         {std::pair("force", "_0"), {"sliding", "_0"}, {"spinning", "_90"}}) {
      names.push_back(cli::column_of(contact::coefficient_quantities(), key) +
                      angle);
    }
  }
  if (approach_) {
    for (auto& name : approach_->columns()) names.push_back(std::move(name));
  }
  if (!preload_.empty()) {
    std::ranges::move(preload_[0].columns(), std::back_inserter(names));
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
  for (std::size_t i = 0; i < joint_.pressures.size(); ++i) {
    const NamedPressure& law = joint_.pressures[i];
    const contact::JointContact* preloaded =
        has_clearance_ ? nullptr : &preload_[i].contact();
    write_contact(contact, row);
    row.text(joint_.laws[0].name);
    row.text(law.name);
    if (preloaded != nullptr) {
      row.number(preloaded->peak_pressure(contact.load, half_angle));
      row.number(preloaded->mean_pressure(contact.load, half_angle));
      row.number(joint_.spec.geometry.nominal_pressure(contact.load));
    } else {
      row.number(unloaded ? 0 : scale(contact) * law.law->peak(half_angle));
      row.number(unloaded ? 0 : scale(contact) * law.law->mean(half_angle));
      if (joint_.has_size) {
        row.number(loads_.nominal_pressure(contact.load_parameter));
      }
    }
    row.number(area);
    // Ratios to the load are undefined for zero load.
    const double load = contact.load == 0
                            ? std::numeric_limits<double>::quiet_NaN()
                            : contact.load;
    row.number(preloaded != nullptr
                   ? preloaded->sum_of_pressures(load, half_angle) / load
                   : law.law->force_ratio(half_angle));
    if (joint_.kind() == contact::JointKind::ball) {
      const auto coefficients = [&](contact::SlipAxis axis) {
        return preloaded != nullptr
                   ? preloaded->integrals(half_angle, axis, {load, 0})
                         .coefficient
                   : contact::friction_integrals(*law.law, half_angle, axis)
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
    if (!preload_.empty()) preload_[i].write(contact.load, half_angle, row);
    row.end();
  }
}

}  // namespace hinge_pressure
