#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "angle/loads.hpp"
#include "cli/joint_approach.hpp"
#include "cli/joint_options.hpp"
#include "cli/laws.hpp"
#include "cli/table.hpp"

/// The parts of the program hinge-angle.
namespace hinge_angle {

using cli::NamedLaw;

/// How often a law had no value.
struct Failures {
  std::size_t out_of_range = 0;
  std::size_t not_converged = 0;
};

/// Columns and rows of the half-angles of one joint by several laws.
class AngleTable {
 public:
  /// @param joint  with one pressure law; must outlive the table
  /// @param loads  of the same joint; must outlive the table
  AngleTable(const cli::Joint& joint, const Loads& loads);

  /// load (if the joint has a geometry), load_parameter, x, then for each law
  /// theta0_LAW_deg and p_peak_LAW_Pa or p_peak_LAW_over_mean; with a geometry
  /// and the law exact those of cli::JointApproach.
  std::vector<std::string> columns() const;
  /// @param load      in terms of `variable`, [0, infinity]
  /// @param failures  for each law; added to
  void write_row(LoadVariable variable, double load, cli::RowWriter& row,
                 std::vector<Failures>& failures) const;

  /// theta0_deg, then for each law load_LAW (if the joint has a geometry),
  /// load_parameter_LAW, x_LAW and the peak pressure; approach and stiffness as
  /// above.
  std::vector<std::string> inverse_columns() const;
  void write_inverse_row(double theta0_deg, cli::RowWriter& row,
                         std::vector<Failures>& failures) const;

 private:
  /// The columns behind the half-angle or the load.
  void add_columns(const NamedLaw& law, std::vector<std::string>& names) const;
  void write(const NamedLaw& law, double half_angle, double load_parameter,
             cli::RowWriter& row) const;
  // Pa, or in pressure units (R_n/rho1^2, P/rho1) without a geometry.
  double peak_pressure(double half_angle, double load_parameter) const;

  const cli::Joint& joint_;
  const Loads& loads_;
  const std::vector<NamedLaw>& laws_;
  const cli::NamedPressure& pressure_;
  std::optional<cli::JointApproach> approach_;
};

}  // namespace hinge_angle
