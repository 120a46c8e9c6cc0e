#pragma once

#include <limits>
#include <optional>
#include <string>

#include "cli/joint/joint_options.hpp"
#include "libcontact/half_angle/law.hpp"
#include "libcontact/pair/joint_geometry.hpp"

namespace hinge_angle {

/// Variable in which a load is given.
enum class LoadVariable {
  load,       ///< N; N/m of a pin without a length
  line_load,  ///< N/m of a pin
  load_parameter,
  x
};

/// Converts the loads of one joint between their variables.
class Loads {
 public:
  /// @param joint  without a size only load_parameter and x are available
  explicit Loads(const cli::Joint& joint);

  /// True if loads in N or N/m are available.
  bool have_load() const { return scale_.has_value(); }
  /// "load_N" or "load_N_per_m"; for one law "load_LAW_N".
  std::string column(const std::string& law = "") const;
  /// "N" or "N/m"
  std::string unit() const { return per_length_ ? "N/m" : "N"; }
  /// Converts a load to another variable.
  double convert(LoadVariable from, double load, LoadVariable to) const;
  /// The load as laws take it: R_n, N, or P, N/m.
  double law_load(double load_parameter) const {
    return scale_->load(load_parameter);
  }
  /// Infinite at every load if there is no clearance.
  double load_parameter(double law_load) const {
    return geometry_.radial_clearance() == 0
               ? std::numeric_limits<double>::infinity()
               : scale_->load_parameter(law_load);
  }
  /// True if the load parameter belongs to a load: it has the clearance's sign,
  /// and does not exist without clearance.
  bool makes(double load_parameter) const {
    return geometry_.radial_clearance() != 0 && law_load(load_parameter) >= 0;
  }
  /// Factor on load parameters before a law takes them.
  double factor(const contact::HalfAngleLaw& law) const {
    return scale_ ? law.load_factor(geometry_.relative_clearance()) : 1;
  }
  /// Nominal pressure, Pa.
  double nominal_pressure(double load_parameter) const {
    return geometry_.nominal_pressure(
        geometry_.force_from_load(law_load(load_parameter)));
  }

 private:
  contact::JointGeometry geometry_;
  std::optional<contact::LoadScale> scale_;
  bool per_length_;
};

}  // namespace hinge_angle
