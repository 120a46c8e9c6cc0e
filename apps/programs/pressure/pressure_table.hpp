#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/joint/joint_approach.hpp"
#include "cli/joint/joint_options.hpp"
#include "cli/joint/joint_preload.hpp"
#include "cli/joint/laws.hpp"
#include "cli/table.hpp"
#include "programs/pressure/loaded_contacts.hpp"

namespace hinge_pressure {

using cli::NamedPressure;

/// Pressures of one joint in Pa, or as multiples of the nominal pressure if the
/// joint has no geometry.
class PressureTable {
 public:
  /// @param joint    with one half-angle law; must outlive the table
  /// @param preload  the summary includes the columns of cli::JointPreload
  PressureTable(const cli::Joint& joint, bool preload);

  /// load_N or load_N_per_m (if the joint has a geometry), load_parameter,
  /// theta0_deg, loading (if through the back), theta_deg, and for each law
  /// p_LAW_Pa or p_LAW_over_nominal.
  std::vector<std::string> profile_columns() const;
  /// Writes `points` rows from the contact's centre to its edge.
  void write_profile(const LoadedContact& contact, int points,
                     cli::RowWriter& row) const;

  /// The first columns as above, then law, pressure, p_peak, p_mean and
  /// p_nominal (with a geometry), area of the contact, S, and for a ball the
  /// friction coefficients of pure sliding and pure spinning. With a geometry
  /// and exact half-angles: approach and stiffness. Last the columns of
  /// cli::JointPreload.
  std::vector<std::string> summary_columns() const;
  /// Writes a row for each law.
  void write_summary(const LoadedContact& contact, cli::RowWriter& row) const;

  /// p by the pressure law i of the joint at an angle from the centre, rad.
  double pressure(std::size_t i, const LoadedContact& contact,
                  double theta) const;
  /// "Pa" or "over_nominal".
  std::string unit() const { return joint_.has_size ? "Pa" : "over_nominal"; }

 private:
  std::vector<std::string> contact_columns() const;
  void write_contact(const LoadedContact& contact, cli::RowWriter& row) const;
  double scale(const LoadedContact& contact) const;

  const cli::Joint& joint_;
  hinge_angle::Loads loads_;
  std::optional<cli::JointApproach> approach_;
  // For each pressure law, if the summary has these columns.
  std::vector<cli::JointPreload> preload_;
  // Without a clearance the contact also depends on more than load parameter
  // and half-angle.
  bool has_clearance_ = true;
};

}  // namespace hinge_pressure
