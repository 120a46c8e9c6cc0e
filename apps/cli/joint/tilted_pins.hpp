#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/joint/joint_options.hpp"
#include "cli/sweep.hpp"
#include "libcontact/joint/joint.hpp"

/// Pins that end, tilted or loaded off their middle, as programs take them: the
/// load is along x, the pin along z.
namespace cli {

/// "" for options that were not given.
struct TiltOptions {
  /// Sweeps: of the tilt in the plane of the load, or of the load's place.
  std::string tilt = {};
  std::string load_at = {};
  std::optional<double> twist = {};  ///< deg

  bool is_placed() const { return !load_at.empty(); }
  bool given() const { return !tilt.empty() || is_placed(); }
  /// The option of the sweep.
  const char* flag() const { return is_placed() ? "--load-at" : "--tilt"; }
};

/// Intervals of the tilt, in degrees: a pin that bends or jams is another joint
/// long before.
inline constexpr Allowed allowed_tilt{-10, 10, "deg"};

/// Adds --tilt, --twist and --load-at.
/// @param needs     the option of the load
/// @param excludes  options that belong to other contacts; both last as long as
///                  the program
void add_tilt_options(Program& program, TiltOptions& options,
                      std::string_view needs, std::string_view excludes);

/// How the pins of the options lie, in the order of their sweep.
class Placements {
 public:
  /// @param joint  a pin that ends
  /// @throws contact::Error for one that has no size or no length, or is no
  ///   such pin, and for places beyond its ends
  Placements(const TiltOptions& options, const Joint& joint);

  std::size_t size() const { return sweep_.size(); }
  contact::Placement operator[](std::size_t index) const;

 private:
  bool is_placed_;
  double twist_;  // rad
  Sweep sweep_;
};

}  // namespace cli
