// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <vector>

#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/validity.hpp"

namespace contact {

/// The direction of a load that was given to a joint without its seat.
enum class LoadDirection {
  vector,  ///< in the axes of the body with the seat
  angle,   ///< from z: for seats about z only
  none,    ///< not known
};

/// How far the contact of a solution goes beyond a rim of the seat that
/// JointSpec::without_seat() has left out of its joint, rad; at or below 0 it
/// stays inside, NaN without such a seat, a half-angle or a direction.
double rim_overlap(const JointContact& contact, const JointSolution& solution,
                   LoadDirection direction = LoadDirection::vector);

namespace detail {

/// Polar angle of a load from a seat's axis, rad, both in the axes of the body
/// that has the seat.
double load_direction(const SeatZone& zone, const Eigen::Vector3d& load);

}  // namespace detail

/// Notes on many solutions of a joint, each once: limits that the largest
/// contact has passed, and the neglected effects at the rims of a seat.
class ContactNotes {
 public:
  /// Solutions without a number count for nothing but their Joint::notes() in a
  /// seat that ends.
  void add(const Joint& joint, const JointSolution& solution,
           LoadDirection direction = LoadDirection::vector);
  /// Notes of the same joint.
  void add(const ContactNotes& more);

  const LargestContact& largest() const { return largest_; }
  /// Sentences on the contacts at rims, in the order of the alphabet.
  const std::set<std::string>& of_seat() const { return of_seat_; }
  /// All sentences.
  std::vector<std::string> notes(const Joint& joint) const;

 private:
  LargestContact largest_;
  std::set<std::string> of_seat_;
};

}  // namespace contact
