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

/// The loads of one joint in terms of each variable.
class Loads {
 public:
  /// @param joint  without a size there are load_parameter and x alone
  explicit Loads(const cli::Joint& joint);

  /// Whether `load` is one of them.
  bool have_load() const { return scale_.has_value(); }
  /// "load_N" or "load_N_per_m"; of a law "load_LAW_N".
  std::string column(const std::string& law = "") const;
  /// "N" or "N/m"
  std::string unit() const { return per_length_ ? "N/m" : "N"; }
  /// A load in terms of another variable.
  double convert(LoadVariable from, double load, LoadVariable to) const;
  /// The load of the laws, R_n, N, or P, N/m.
  double law_load(double load_parameter) const {
    return scale_->load(load_parameter);
  }
  /// Infinite without clearance, at every load.
  double load_parameter(double law_load) const {
    return geometry_.radial_clearance() == 0
               ? std::numeric_limits<double>::infinity()
               : scale_->load_parameter(law_load);
  }
  /// Whether a load makes a load parameter of the laws: of the clearance's
  /// sign, and none without clearance.
  bool makes(double load_parameter) const {
    return geometry_.radial_clearance() != 0 && law_load(load_parameter) >= 0;
  }
  /// Factor of load parameters where a law takes them.
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
