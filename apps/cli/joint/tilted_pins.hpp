#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/joint/joint_options.hpp"
#include "cli/sweep.hpp"
#include "libcontact/joint/joint.hpp"

/// Options for finite-length pins, tilted or loaded off their middle. The load
/// is along x, the pin along z.
namespace cli {

/// "" for options that were not given.
struct TiltOptions {
  /// Sweeps: tilt in the plane of the load, or the load's place.
  std::string tilt = {};
  std::string load_at = {};
  std::optional<double> twist = {};  ///< deg

  bool is_placed() const { return !load_at.empty(); }
  bool given() const { return !tilt.empty() || is_placed(); }
  /// The option that gives the sweep.
  const char* flag() const { return is_placed() ? "--load-at" : "--tilt"; }
};

/// Range of the tilt, degrees: a pin bends or jams at much smaller angles.
inline constexpr Allowed allowed_tilt{-10, 10, "deg"};

/// Adds --tilt, --twist and --load-at.
/// @param needs     the option of the load
/// @param excludes  options of other contacts; both texts must live as long as
///                  the program
void add_tilt_options(Program& program, TiltOptions& options,
                      std::string_view needs, std::string_view excludes);

/// Positions of the pins given by the options, in the order of their sweep.
class Placements {
 public:
  /// @param joint  a finite-length pin
  /// @throws contact::Error if the joint is no such pin, lacks size or length,
  ///   or a place is beyond its ends
  Placements(const TiltOptions& options, const Joint& joint);

  std::size_t size() const { return sweep_.size(); }
  contact::Placement operator[](std::size_t index) const;

 private:
  bool is_placed_;
  double twist_;  // rad
  Sweep sweep_;
};

}  // namespace cli
