// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/joint/contact.hpp"
#include "libcontact/joint/rim_contact.hpp"
#include "libcontact/joint/spec.hpp"
#include "libcontact/pair/seat_zone.hpp"

namespace contact {

namespace detail {
class RimWarning;
class SeatModel;
class SeatWindows;
class SideFaceReach;
struct SeatSolution;
}  // namespace detail

enum class SeatStatus {
  ok,
  not_converged,  ///< the contact was not found to full accuracy
  out_of_seat,    ///< no pressure on the seat can carry the load
  no_load,        ///< the force is 0 or not finite
};

/// "ok", "not_converged", "out_of_seat", "no_load".
constexpr std::string_view to_string(SeatStatus status) {
  switch (status) {
    case SeatStatus::ok:
      return "ok";
    case SeatStatus::not_converged:
      return "not_converged";
    case SeatStatus::out_of_seat:
      return "out_of_seat";
    case SeatStatus::no_load:
      break;
  }
  return "no_load";
}

/// Place on the seat of a vector from the ball's centre.
/// @param force  of the contact, any unit
/// @param place  of any length, in the axes of the force, the seat's axes
SeatPlace seat_place(const Eigen::Vector3d& force,
                     const Eigen::Vector3d& place);

/// The contact under one load, and how it was found.
struct SeatState : RimContact {
  SeatStatus status = SeatStatus::no_load;
  /// The grid's solution; none if free.
  std::shared_ptr<const detail::SeatSolution> solution = {};
};

/// Pressure on a rounded rim (Hertz' shape of a punch's edge).
struct RoundedRim {
  double peak_pressure;  ///< Pa
  double reach;          ///< reach beyond the old rim, m
};

/// The exact contact of a ball in a seat that ends at rims: a ring, a cup, a
/// socket, for any elastic pair and any walls, under any load. The bodies
/// extend beyond the rims as in the laws without rims; only the contact ends
/// there, unless SideFace::free. docs/explanation/seats.md lists the errors of
/// this model, 0 to 68 %.
///
/// Axes: z is the seat's axis, from which a SeatZone counts its angles; forces
/// act on the seat, shifts refer to the ball's centre.
///
/// If the contact of the unbounded seat lies inside the rims, and free side
/// faces do not change its pressure, the result is that contact, bit-identical;
/// such side faces add to its shift. Otherwise a grid is solved: make one
/// object per joint, because the first grid takes 0.1 to 1 s for its matrices.
/// A contact much narrower than its zone uses finer grids, which are built on
/// first use and kept. Any number of threads may share the object.
///
/// Accuracy (seat/seat_test.cpp, against two-grid references):
/// docs/explanation/seats.md, "Accuracy".
class SeatContact {
 public:
  struct Grid {
    int cells = 28;       ///< over latitude, 8 to 200; a few more near rims
    int longitudes = 90;  ///< over half a turn, 16 to 720
  };
  /// Thinner surface layers, over the radius, would need too many cells.
  static constexpr double smallest_relative_thickness = 1e-3;

  /// @param joint  a ball; its laws and friction have no effect
  /// @throws Error for pins, for a ball loaded through the back, for layers
  ///   that are too thin, for a grid out of range, and for SideFace::free with
  ///   a held backing or side faces that meet.
  SeatContact(const JointSpec& joint, const SeatZone& zone)
      : SeatContact(joint, zone, Grid()) {}
  SeatContact(const JointSpec& joint, const SeatZone& zone, const Grid& grid);
  ~SeatContact();

  /// The contact under a force on the seat, N.
  SeatState under(const Eigen::Vector3d& force) const;
  /// As above, starting from a nearby state.
  SeatState under(const Eigen::Vector3d& force, const SeatState& near) const;

  /// Pressure of a state at a place, Pa, never negative: 0 outside the contact,
  /// infinite at a reached rim. Cell by cell in latitude, linear between
  /// longitudes, so that p r integrates to F within 1e-3. Errors over the
  /// largest pressure (seat/identities_test.cpp): at least two cells inside the
  /// contact 3e-3 in the mean and 2e-2 at worst, in its last cell 0.15. NaN
  /// without a contact, and for states of a SeatTable.
  double pressure(const SeatState& state, const SeatPlace& place) const;

  /// PV of a contact on the grid, v = rho |rate x r|: the total to 1e-3, the
  /// maximum to 5e-3 (seat/pv_test.cpp). NaN for free contacts (use
  /// SlidingContact) and for states of a SeatTable. At the rim itself PV is
  /// infinite; wear there is outside the model.
  /// @param rate  Dw, rad/s, in the axes of the force
  ContactPv pv(const SeatState& state, const Eigen::Vector3d& rate) const;

  /// dF/dD at a state, N/m: symmetric. Eight solutions for central differences
  /// of fourth order, because the stiffness of a fixed set of cells differs.
  /// NaN without a shift.
  Eigen::Matrix3d stiffness(const SeatState& state) const;

  /// Contact at a rim rounded along the meridian, for a radius much smaller
  /// than the contact and than the thickness of the surface layer: p = 0.582
  /// (K^2 E*/r)^(1/3), over d = (1.880 K r/E*)^(2/3).
  /// @param intensity  K, Pa m^(1/2)
  /// @param radius     r, m
  RoundedRim rounded_rim(double intensity, double radius) const;

  /// Reason for a missing result as a sentence; "" if there is a result.
  std::string note(const SeatState& state) const;
  /// Adds notes about neglected effects for a contact that ends less than 10
  /// deg from a rim (15 with corners below 85 deg and seats of nu 0.4 and
  /// more), and about a rim with too large a radius for rounded_rim().
  std::vector<std::string> notes(const SeatState& state) const;

  /// SeatZone::nominal_area(), m^2.
  double nominal_area() const;

  const SeatZone& zone() const { return zone_; }
  /// Contact of the unbounded seat.
  const JointContact& unbounded() const { return contact_; }

 private:
  friend class SeatTable;
  friend class detail::SeatModel;

  // Whether a contact about a polar angle equals the contact without rims.
  bool is_free(double direction, double half_angle) const;
  void set_rim_warning(const LayeredPair& pair);
  bool has_free_side_face() const;
  const detail::SideFaceReach& reach() const;
  // Shift that free side faces add to a contact far from them.
  Eigen::Vector3d more_shift(const Eigen::Vector3d& force,
                             double half_angle) const;
  Eigen::Matrix3d free_stiffness(const Eigen::Vector3d& force) const;
  // Half-angle of a contact that reaches no rim; else none.
  std::optional<double> free_half_angle(const Eigen::Vector3d& force) const;
  // A contact that reaches no rim.
  SeatState free_state(const Eigen::Vector3d& force, double half_angle) const;
  // Solution on the grid, with or without a reached rim.
  SeatState confined(const Eigen::Vector3d& force, const SeatState& near) const;
  double unit_force() const;
  void set_confined(double direction, SeatState& state) const;
  void set_rims(SeatState& state) const;
  std::string rim_sentence(const SeatState& state, int rim,
                           std::string_view place) const;
  void add_side_face_notes(const SeatState& state, int rim,
                           std::vector<std::string>& all) const;
  void add_rounding_notes(const SeatState& state, int rim,
                          std::vector<std::string>& all) const;

  double report_distance() const { return zone_.edge().report_distance; }

  double radius_;
  JointContact contact_;
  SeatZone zone_;
  double surface_layer_;  // thickness, m; infinite: none
  std::unique_ptr<const detail::SeatWindows> windows_;
  std::unique_ptr<const detail::RimWarning> rim_warning_;
  mutable std::once_flag made_reach_;
  mutable std::unique_ptr<const detail::SideFaceReach> reach_;
};

}  // namespace contact
