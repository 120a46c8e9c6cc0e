#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cli/joint/joint_options.hpp"
#include "cli/table.hpp"
#include "libcontact/joint/contact.hpp"
#include "libcontact/quantities/tables.hpp"

namespace cli {

/// Effect of interference and of a clearance of 0 on a contact, as columns of
/// tables: contact_state and contact::preload_quantities().
class JointPreload {
 public:
  /// True if one of the joints has a size and no clearance; then the tables of
  /// all of them have the columns.
  static bool any_of(const std::vector<Joint>& joints) {
    return std::ranges::any_of(joints, [](const Joint& joint) {
      return joint.has_size && joint.spec.geometry.radial_clearance() <= 0;
    });
  }

  /// @param joint     with a size
  /// @param law       index of its half-angle law
  /// @param pressure  index of its pressure law
  explicit JointPreload(const Joint& joint, std::size_t law = 0,
                        std::size_t pressure = 0)
      : contact_(joint.contact(contact::FrictionLaw(0), law, pressure)),
        rubbing_(contact_.with_friction(
            joint.spec.friction.value_or(contact_.friction()))),
        has_friction_(joint.spec.friction.has_value()),
        per_length_(!joint.has_length) {}

  /// "contact_state", "p_0_Pa", ...; forces and moments of a pin without a
  /// length are per m of it: "R_lift_off_N_per_m".
  std::vector<std::string> columns() const {
    std::vector<std::string> names = {"contact_state"};
    for (const auto& column : quantities_) {
      names.push_back(column.name);
      const contact::Dimension d = column.quantity->dimension;
      const bool grows =
          d == contact::Dimension::force || d == contact::Dimension::moment;
      if (per_length_ && grows) names.back() += "_per_m";
    }
    return names;
  }

  /// Writes the cells for a normal force, N; empty if the force is NaN. The
  /// moment is also empty if the joint's friction is not known.
  void write(double force, double half_angle, RowWriter& row) const {
    if (std::isnan(force)) {
      for (std::size_t i = 0; i < columns().size(); ++i) row.empty();
      return;
    }
    // A load computed from a half-angle of 180 deg may differ by rounding.
    const bool closed =
        contact_.has_interference() && half_angle == std::numbers::pi;
    row.text(to_string(closed ? contact::ContactState::closed
                              : contact_.state(force)));
    const contact::ContactPatch patch{rubbing_, force, half_angle};
    for (const auto& column : quantities_) {
      if (column.quantity->dimension == contact::Dimension::moment &&
          !has_friction_) {
        row.empty();
      } else {
        row.number(column(patch));
      }
    }
  }

  /// The contact without friction.
  const contact::JointContact& contact() const { return contact_; }

 private:
  std::vector<contact::Column<contact::ContactPatch>> quantities_ =
      columns_of(contact::preload_quantities());
  contact::JointContact contact_;
  contact::JointContact rubbing_;  // with the joint's friction, if it has one
  bool has_friction_;
  bool per_length_;
};

}  // namespace cli
