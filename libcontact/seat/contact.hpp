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

/// The place of a vector from the ball's centre.
/// @param force  of the contact, any unit
/// @param place  of any length, in the axes of the force: the seat's
SeatPlace seat_place(const Eigen::Vector3d& force,
                     const Eigen::Vector3d& place);

/// The contact under one load, and how it was found.
struct SeatState : RimContact {
  SeatStatus status = SeatStatus::no_load;
  /// The grid's solution; none if free.
  std::shared_ptr<const detail::SeatSolution> solution = {};
};

/// Pressure on a rim that is rounded (Hertz' shape of a punch's edge).
struct RoundedRim {
  double peak_pressure;  ///< Pa
  double reach;          ///< reach beyond the old rim, m
};

/// The exact contact of a ball in a seat that ends at rims: a ring, a cup, a
/// socket, for any elastic pair and any walls, under any load. The bodies go on
/// beyond the rims as they do in the laws without rims; only the contact ends
/// there, unless SideFace::free. What that leaves out, 0 to 68 %, says
/// docs/explanation/seats.md.
///
/// Axes: z is the seat's axis, which a SeatZone counts its angles from; forces
/// act on the seat, shifts are those of the ball's centre.
///
/// Where the contact of the seat without end lies inside the rims, and where
/// side faces that are free leave its pressure as it is, that contact answers,
/// to the last bit; such side faces add to its shift. Else a grid is solved:
/// make one object per joint, as the first of these takes 0.1 to 1 s for its
/// matrices. A contact much narrower than its zone gets finer grids, made when
/// first asked for and kept too. Any number of threads may ask.
///
/// Accuracy (seat/seat_test.cpp, against two-grid references):
/// docs/explanation/seats.md, "Accuracy".
class SeatContact {
 public:
  struct Grid {
    int cells = 28;       ///< over latitude, 8 to 200; some more near rims
    int longitudes = 90;  ///< over half a turn, 16 to 720
  };
  /// Thinner surface layers, over the radius, would take too many cells.
  static constexpr double smallest_relative_thickness = 1e-3;

  /// @param joint  a ball; its laws and friction are without influence
  /// @throws Error for pins, for a ball that is loaded through the back, for
  ///   layers that are too thin, for a grid out of range, and where
  ///   SideFace::free has a backing that is held, or side faces that meet.
  SeatContact(const JointSpec& joint, const SeatZone& zone)
      : SeatContact(joint, zone, Grid()) {}
  SeatContact(const JointSpec& joint, const SeatZone& zone, const Grid& grid);
  ~SeatContact();

  /// The contact under a force on the seat, N.
  SeatState under(const Eigen::Vector3d& force) const;
  /// The same, begun from a state that is near.
  SeatState under(const Eigen::Vector3d& force, const SeatState& near) const;

  /// p of a state at a place, Pa, never below 0: 0 outside the contact,
  /// infinite at a rim that is reached. Cell by cell in latitude, linear from
  /// one longitude to the next, so that p r sums up to F within 1e-3. Two cells
  /// and more inside the contact 3e-3 of the largest in the mean, 2e-2 at worst
  /// (seat/identities_test.cpp), in its last cell 0.15. NaN without a contact,
  /// and of states of a SeatTable.
  double pressure(const SeatState& state, const SeatPlace& place) const;

  /// p v of a contact on the grid, v = rho |rate x r|: the total to 1e-3, the
  /// largest to 5e-3 (seat/pv_test.cpp). NaN of free contacts, which
  /// SlidingContact has, and of states of a SeatTable. At the rim itself the
  /// model's p v is infinite, and what wears there is beyond it.
  /// @param rate  Dw, rad/s, in the axes of the force
  ContactPv pv(const SeatState& state, const Eigen::Vector3d& rate) const;

  /// dF/dD at a state, N/m: symmetric. By central differences of fourth order
  /// (a set of cells has a stiffness of its own): eight solutions. NaN without
  /// a shift.
  Eigen::Matrix3d stiffness(const SeatState& state) const;

  /// Contact at a rim that is rounded along the meridian, for a radius much
  /// smaller than the contact and than the thickness of the surface layer:
  /// p = 0.582 (K^2 E*/r)^(1/3), over d = (1.880 K r/E*)^(2/3).
  /// @param intensity  K, Pa m^(1/2)
  /// @param radius     r, m
  RoundedRim rounded_rim(double intensity, double radius) const;

  /// Why there is no answer, a sentence; "" if there is one.
  std::string note(const SeatState& state) const;
  /// The same, and of a contact that ends less than 10 deg from a rim (15 with
  /// corners below 85 deg and seats of nu 0.4 and more) what the model leaves
  /// out there, and of a rim that is rounded too much for rounded_rim().
  std::vector<std::string> notes(const SeatState& state) const;

  /// SeatZone::nominal_area(), m^2.
  double nominal_area() const;

  const SeatZone& zone() const { return zone_; }
  /// The contact of the seat without end.
  const JointContact& unbounded() const { return contact_; }

 private:
  friend class SeatTable;
  friend class detail::SeatModel;

  // Whether a contact about a polar angle is that of the seat without rims.
  bool is_free(double direction, double half_angle) const;
  void set_rim_warning(const LayeredPair& pair);
  bool has_free_side_face() const;
  const detail::SideFaceReach& reach() const;
  // The shift that free side faces add to that of one that is far from them.
  Eigen::Vector3d more_shift(const Eigen::Vector3d& force,
                             double half_angle) const;
  Eigen::Matrix3d free_stiffness(const Eigen::Vector3d& force) const;
  // Half-angle of one that reaches none; none of others.
  std::optional<double> free_half_angle(const Eigen::Vector3d& force) const;
  // One that reaches none.
  SeatState free_state(const Eigen::Vector3d& force, double half_angle) const;
  // On the grid, whether a rim is reached or not.
  SeatState confined(const Eigen::Vector3d& force, const SeatState& near) const;
  double unit_force() const;
  void set_confined(double direction, SeatState& state) const;
  void set_rims(SeatState& state) const;
  void add_side_face_notes(const SeatState& state, int rim,
                           std::vector<std::string>& all) const;
  void add_rounding_notes(const SeatState& state, int rim,
                          std::vector<std::string>& all) const;

  double report_distance() const { return zone_.edge().report_distance; }

  double radius_;
  JointContact contact_;
  SeatZone zone_;
  double surface_layer_;  // thickness, m; infinite without
  std::unique_ptr<const detail::SeatWindows> windows_;
  std::unique_ptr<const detail::RimWarning> rim_warning_;
  mutable std::once_flag made_reach_;
  mutable std::unique_ptr<const detail::SideFaceReach> reach_;
};

}  // namespace contact
