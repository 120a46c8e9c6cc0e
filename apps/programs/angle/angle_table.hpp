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

/// Counts of remarkable rows of one law.
struct Findings {
  std::size_t out_of_range = 0;  ///< without a value
  std::size_t empty = 0;         ///< rows that no law has a value for
  std::size_t not_converged = 0;
  contact::LargestContact largest;  ///< peaks not of dimensionless runs

  void add(const Findings& more);
};

/// Columns and rows of the half-angles of one joint by several laws.
class AngleTable {
 public:
  /// @param joint  with one pressure law; must outlive the table
  /// @param input  of that joint; must outlive the table
  /// @param own_hertz  whether the peaks of the law hertz are Hertz' own
  /// @param preload    whether it has the columns of cli::JointPreload
  AngleTable(const cli::Joint& joint, const Input& input, bool own_hertz,
             bool preload);

  /// load_N or load_N_per_m (if the joint has a geometry), load_parameter, x,
  /// p_nominal_Pa (with a geometry), then for each law theta0_LAW_deg and
  /// p_peak_LAW_by_PRESSURE_Pa or _over_nominal; with a geometry and the law
  /// exact the columns of cli::JointApproach. Of half-angles: theta0_deg, then
  /// for each law load_LAW_N or load_LAW_N_per_m, load_parameter_LAW, x_LAW,
  /// p_nominal_LAW_Pa, and the peak pressure, approach and stiffness as above.
  /// After all laws the columns of cli::JointPreload, by exact or the first
  /// law.
  std::vector<std::string> columns() const;
  /// @param findings  for each law; added to
  void write_row(std::size_t index, cli::RowWriter& row,
                 std::vector<Findings>& findings) const;
  std::size_t size() const { return input_.values.size(); }

 private:
  void write_load_row(double load, cli::RowWriter& row,
                      std::vector<Findings>& findings) const;
  void write_half_angle_row(double theta0_deg, cli::RowWriter& row,
                            std::vector<Findings>& findings) const;
  /// The columns behind the half-angle or the load.
  void add_columns(const NamedLaw& law, std::vector<std::string>& names) const;
  /// One law's cells there.
  struct Cell {
    double half_angle;  ///< rad
    double load_parameter;
    double force;  ///< as Loads has it; 0 without a geometry
  };
  void write(std::size_t law, const Cell& cell, cli::RowWriter& row,
             Findings& findings) const;
  void add_preload_columns(std::vector<std::string>& names) const;
  void write_preload(const Cell& cell, cli::RowWriter& row) const;
  bool is_own_hertz(const NamedLaw& law) const;
  // Pa, or over the nominal pressure without a geometry.
  double peak_pressure(const NamedLaw& law, double half_angle,
                       double load_parameter) const;

  const cli::Joint& joint_;
  const Input& input_;
  Loads loads_;
  bool own_hertz_;
  const std::vector<NamedLaw>& laws_;
  const cli::NamedPressure& pressure_;
  std::optional<cli::JointApproach> approach_;
  // For each law, where the tables have these columns.
  std::vector<cli::JointPreload> preload_;
  // Number of their law: exact, or the first one.
  std::size_t preload_law_ = 0;
  bool has_clearance_ = true;
};

}  // namespace hinge_angle
