#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/joint/joint_options.hpp"
#include "cli/sweep.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"

/// Pins that end, tilted or loaded off their middle, as programs take them.
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

/// How a pin lies: with a tilt, or a load at a place.
struct PinLie {
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();
  std::optional<double> place = {};  ///< m

  /// Under a reaction along x while the body moves.
  contact::FinitePinSolution solve(
      const contact::FinitePin& pin, const Eigen::Vector2d& reaction,
      const contact::FinitePin::Motion& motion) const noexcept;
  /// Under a normal force, without friction.
  contact::FinitePinSolution under(const contact::FinitePin& pin,
                                   const Eigen::Vector2d& force) const noexcept;
};

/// The lies of the options, in the order of their sweep.
class PinLies {
 public:
  PinLies(const TiltOptions& options, const contact::JointGeometry& geometry);

  std::size_t size() const { return sweep_.size(); }
  PinLie operator[](std::size_t index) const;

 private:
  bool is_placed_;
  double twist_;  // deg
  Sweep sweep_;
};

/// The pin of a joint.
/// @param flag  option that asks for it, for messages
/// @throws contact::Error for one that has no size or no length, or is no such
///   pin
contact::FinitePin make_finite_pin(const Joint& joint, const char* flag);

/// A column of such pins.
struct PinColumn {
  std::string name;
  std::function<double(const contact::FinitePin&,
                       const contact::FinitePinSolution&)>
      of;
};

/// The columns of the quantities of pins that end that `keys` name, of all
/// without it.
std::vector<PinColumn> pin_columns(
    const std::vector<std::string_view>& keys = {});

/// Table of such pins: rows of each load and lie.
struct TiltedTable {
  std::string_view program;
  std::string_view load_flag;
  std::string load_column;
  std::string loads;  ///< sweep
  /// Nothing: the loads are normal forces; else reactions.
  std::optional<contact::FinitePin::Motion> motion;
  std::vector<PinColumn> columns;  ///< behind those of the load
  /// Instead of one row of the columns, whose names alone count: writes rows,
  /// each begun by `begin`, which writes the cells of the load.
  std::function<void(const contact::FinitePin&,
                     const contact::FinitePinSolution&,
                     const std::function<void()>& begin, RowWriter&)>
      write = {};
};

/// Writes it, with warnings of what leaves the theory; some_bad if rows have no
/// value.
ExitStatus write_tilted(const std::vector<Joint>& joints,
                        const TiltOptions& options, const TiltedTable& table,
                        const OutputOptions& output);

}  // namespace cli
