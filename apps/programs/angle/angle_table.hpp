#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/joint/joint_approach.hpp"
#include "cli/joint/joint_options.hpp"
#include "cli/joint/joint_preload.hpp"
#include "cli/joint/laws.hpp"
#include "cli/table.hpp"
#include "libcontact/pressure/validity.hpp"
#include "programs/angle/input.hpp"
#include "programs/angle/loads.hpp"

/// The parts of the program hinge-angle.
namespace hinge_angle {

using cli::NamedLaw;

/// Counts of special rows of one law.
struct Findings {
  std::size_t out_of_range = 0;  ///< without a value
  std::size_t empty = 0;         ///< rows without a value of any law
  std::size_t not_converged = 0;
  contact::LargestContact largest;  ///< except peaks of dimensionless runs

  void add(const Findings& more);
};

/// Columns and rows of the half-angles of one joint by several laws.
class AngleTable {
 public:
  /// @param joint      with one pressure law; must outlive the table
  /// @param input      sweep of this joint; must outlive the table
  /// @param own_hertz  the law hertz gives the peaks of Hertz's own pressure
  /// @param preload    the table includes the columns of cli::JointPreload
  AngleTable(const cli::Joint& joint, const Input& input, bool own_hertz,
             bool preload);

  /// load_N or load_N_per_m (if the joint has a geometry), load_parameter, x,
  /// p_nominal_Pa (with a geometry), then for each law theta0_LAW_deg and
  /// p_peak_LAW_by_PRESSURE_Pa or _over_nominal; with a geometry and the law
  /// exact the columns of cli::JointApproach.
  /// If half-angles are given: theta0_deg, then for each law load_LAW_N or
  /// load_LAW_N_per_m, load_parameter_LAW, x_LAW, p_nominal_LAW_Pa, and peak
  /// pressure, approach and stiffness as above.
  /// The columns of cli::JointPreload, by exact or the first law, come last.
  std::vector<std::string> columns() const;
  /// @param findings  counts of each law; write_row adds to them
  void write_row(std::size_t index, cli::RowWriter& row,
                 std::vector<Findings>& findings) const;
  std::size_t size() const { return input_.values.size(); }

 private:
  void write_load_row(double load, cli::RowWriter& row,
                      std::vector<Findings>& findings) const;
  void write_half_angle_row(double theta0_deg, cli::RowWriter& row,
                            std::vector<Findings>& findings) const;
  /// Adds the columns after the half-angle or the load.
  void add_columns(const NamedLaw& law, std::vector<std::string>& names) const;
  /// The values of one law in a row.
  struct Cell {
    double half_angle;  ///< rad
    double load_parameter;
    double force;  ///< in the unit of Loads; 0 without a geometry
  };
  void write(std::size_t law, const Cell& cell, cli::RowWriter& row,
             Findings& findings) const;
  void add_preload_columns(std::vector<std::string>& names) const;
  void write_preload(const Cell& cell, cli::RowWriter& row) const;
  bool is_own_hertz(const NamedLaw& law) const;
  // Pa; without a geometry a multiple of the nominal pressure.
  double peak_pressure(const NamedLaw& law, double half_angle,
                       double load_parameter) const;

  const cli::Joint& joint_;
  const Input& input_;
  Loads loads_;
  bool own_hertz_;
  const std::vector<NamedLaw>& laws_;
  const cli::NamedPressure& pressure_;
  std::optional<cli::JointApproach> approach_;
  // For each law, if the table has these columns.
  std::vector<cli::JointPreload> preload_;
  // Index of the law that they use: exact, or the first one.
  std::size_t preload_law_ = 0;
  bool has_clearance_ = true;
};

}  // namespace hinge_angle
