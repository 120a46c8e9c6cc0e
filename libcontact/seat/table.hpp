// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/seat/contact.hpp"

namespace contact {

namespace detail {
class SeatBasis;
class SeatSums;
struct SeatHarmonics;
}  // namespace detail

/// Contacts of a seat that reach a rim, over the size and the direction of the
/// load. The table is built once; reading a contact takes 8 to 12 us, 17 us
/// with adhesion, and friction about any slip axis 4 to 6 us more. It consists
/// of squares of 4 x 4 states with cubic interpolation. Squares are halved
/// until the error in the middle of each is a quarter of the required accuracy.
///
/// All directions across the seat's axis are equivalent, and so are the two
/// sides of a symmetric zone.
class SeatTable {
 public:
  using Options = RimTableOptions;
  using Check = RimTableCheck;

  /// @param contact  must outlive the table
  /// @throws Error without a clearance, and for options out of range.
  SeatTable(const SeatContact& contact, const Options& options);
  /// Restores a table.
  /// @param bytes  from bytes() on a machine of the same kind
  /// @throws Error if they are no table, or a table of another joint.
  SeatTable(const SeatContact& contact, const JointSpec& joint,
            std::string_view bytes);
  ~SeatTable();

  /// The table as bytes for a file: the joint's canonical text, then numbers.
  /// @param joint  of the contact
  std::string bytes(const JointSpec& joint) const;

  /// Number of states.
  int size() const;
  const Check& check() const { return check_; }

  /// Whether the contact reaches a rim and the table covers it. Directions
  /// within 10 % of the largest that a seat carries are never covered.
  bool covers(const Eigen::Vector3d& force) const;

  /// Reads a covered contact; longitudes of maxima, and the pressure where the
  /// load pierces the seat, are unknown.
  /// @return whether it is covered; if not, `state` does not change
  bool find(const Eigen::Vector3d& force, SeatState& state) const {
    return find(force, state, nullptr, false);
  }
  /// As above, with the harmonics for Joint.
  /// @param has_area  whether the harmonics of the area are needed
  bool find(const Eigen::Vector3d& force, SeatState& state,
            detail::SeatHarmonics* harmonics, bool has_area) const;
  const detail::SeatBasis& basis() const;

 private:
  using Numbers = Eigen::Array<double, 16, 1>;
  struct Node;
  struct Square;
  struct Place;
  class Maker;

  explicit SeatTable(const SeatContact& contact);
  void make(const Options& options);
  template <class Table, class Stream>
  static void pass(Table& table, Stream&& stream);
  bool is_whole() const;
  Place place(const Eigen::Vector3d& force) const;
  double load_place(double load) const;
  double shift_unit(double load) const;
  bool is_free(const Eigen::Vector3d& force) const;
  const Square* square(const Place& at) const;
  void interpolate(const Square& in, const Place& at, Numbers& numbers,
                   detail::SeatHarmonics* harmonics, bool has_area) const;
  void set_peak(const Numbers& numbers, SeatState& state) const;

  const SeatContact& contact_;
  double radius_, clearance_;
  double unit_load_;  // N
  bool has_mirror_;
  Eigen::Array2d low_, high_;      // places of loads and directions
  Eigen::Array2i count_ = {0, 0};  // number of the largest squares
  std::unique_ptr<const detail::SeatSums> sums_;
  std::vector<Node> nodes_;
  std::vector<Square> squares_;
  Check check_;
};

}  // namespace contact
