#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "libcontact/joint/contact_notes.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/validity.hpp"
#include "python/rows/rows.hpp"

namespace contact_python {

/// The joints that functions of rows are over: an array of any shape; () for a
/// single joint.
class JointSet {
 public:
  /// @param refusal  what functions of friction say if the joints have none, or
  ///   none in their seats
  JointSet(Shape shape, std::vector<contact::Joint> joints,
           std::string refusal);

  const Shape& shape() const { return shape_; }
  std::size_t size() const { return joints_.size(); }
  /// The first argument of rows, their joint.
  Argument argument() const;
  /// The number of the joint of a row whose first argument it is.
  static std::size_t number(const double* const* at) {
    return static_cast<std::size_t>(*at[0]);
  }
  const contact::Joint& operator()(const double* const* at) const {
    return joints_[number(at)];
  }
  const contact::Joint& operator[](std::size_t i) const { return joints_[i]; }
  /// @throws contact::Error if they have no friction, or none in their seats
  void require_friction() const;
  /// Rows between two looks at Ctrl-C: few if rims may take some 30 ms each.
  std::size_t at_once() const { return any_ends_ ? 16 : Rows::block; }
  /// Limits of a joint's contact; with Python's lock.
  const contact::ContactLimits& limits(std::size_t i) const;

 private:
  Shape shape_;
  std::vector<contact::Joint> joints_;
  std::vector<double> numbers_;  // 0, 1, ...
  std::string refusal_;
  bool any_ends_;  // the contact of one of the joints ends
  mutable std::vector<std::optional<contact::ContactLimits>> limits_;
};

/// Ends that are left out of a joint, as by JointSpec::without_seat() and
/// without_relief().
struct LeftOut {
  bool seat;
  bool relief;

  contact::JointSpec of(const contact::JointSpec& spec) const {
    const contact::JointSpec some = seat ? spec.without_seat() : spec;
    return relief ? some.without_relief() : some;
  }
};

/// A joint that can be asked of its contact, whether there is friction in its
/// seat or not.
struct AnyJoint {
  contact::Joint joint;
  std::string refusal;  ///< error of functions of friction; "" if they work
};
AnyJoint any_joint(const contact::JointSpec& spec, contact::SharedLaws& laws);

/// The largest contact of each joint, and notes on contacts beside rims, of
/// rows on any thread.
class LargestContacts {
 public:
  explicit LargestContacts(const JointSet& joints)
      : joints_(joints), largest_(joints.size()) {}

  void add(const double* const* at, double half_angle, double peak_pressure,
           double rim_overlap = 0);
  /// Solutions without a number say so by their status.
  void add(const double* const* at, const contact::JointSolution& s);
  /// Gives a ContactWarning for each limit that the first joint of those that
  /// pass any has passed, and for each note on its rims.
  void warn() const;
  /// A sentence for each limit that a single joint has passed.
  std::vector<std::string> notes() const;

 private:
  struct Largest {
    std::atomic<double> half_angle = 0;
    std::atomic<double> peak_pressure = 0;
    std::atomic<double> rim_overlap = 0;
  };
  contact::LargestContact at(std::size_t joint) const;

  const JointSet& joints_;
  std::vector<Largest> largest_;
  std::mutex of_notes_;
  std::map<std::size_t, contact::ContactNotes> notes_;  // on contacts that end
};

/// Gives the warnings of a solution of a single joint.
void warn_of(const JointSet& joint, const contact::JointSolution& s);

}  // namespace contact_python
