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

/// The contacts of a seat that reach a rim, over the size and the direction of
/// the load: made once, then read in 8 to 12 us, 17 us with adhesion, for
/// friction about any slip axis in 4 to 6 us more. Squares of 4 x 4 states,
/// which are halved until a state in the middle of each is found with a quarter
/// of the accuracy that is asked for; cubic between.
///
/// Across the seat's axis all directions are alike, and the two sides of a zone
/// that is symmetric too.
class SeatTable {
 public:
  using Options = RimTableOptions;
  using Check = RimTableCheck;

  /// @param contact  has to outlive the table
  /// @throws Error without a clearance, and for options out of range.
  SeatTable(const SeatContact& contact, const Options& options);
  /// A table that was made before.
  /// @param bytes  what bytes() gave on a machine of the same kind
  /// @throws Error if they are not a table, or one of another joint.
  SeatTable(const SeatContact& contact, const JointSpec& joint,
            std::string_view bytes);
  ~SeatTable();

  /// The table for a file: the joint's canonical text, then its numbers.
  /// @param joint  that the contact was made for
  std::string bytes(const JointSpec& joint) const;

  /// States that were found.
  int size() const;
  const Check& check() const { return check_; }

  /// Whether the contact reaches a rim and the table covers it. Directions
  /// within 10 % of the largest that a seat carries are never covered.
  bool covers(const Eigen::Vector3d& force) const;

  /// A contact that is covered; longitudes of maxima, and where the load
  /// pierces the seat, are not known.
  /// @return whether it is covered; else nothing happens
  bool find(const Eigen::Vector3d& force, SeatState& state) const {
    return find(force, state, nullptr, false);
  }
  /// The same with its harmonics, which Joint takes.
  /// @param has_area  whether those of the area are wanted
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
