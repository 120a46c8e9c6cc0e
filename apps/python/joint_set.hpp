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

/// The joints of functions that take rows: an array of any shape; () for a
/// single joint.
class JointSet {
 public:
  /// @param refusal  error of functions of friction if the joints have no
  ///                 friction, or none in their seats
  JointSet(Shape shape, std::vector<contact::Joint> joints,
           std::string refusal);

  const Shape& shape() const { return shape_; }
  std::size_t size() const { return joints_.size(); }
  /// The joints as the first argument of rows.
  Argument argument() const;
  /// Index of the joint of a row whose first argument are the joints.
  static std::size_t number(const double* const* at) {
    return static_cast<std::size_t>(*at[0]);
  }
  const contact::Joint& operator()(const double* const* at) const {
    return joints_[number(at)];
  }
  const contact::Joint& operator[](std::size_t i) const { return joints_[i]; }
  /// @throws contact::Error if they have no friction, or none in their seats
  void require_friction() const;
  /// Rows between two checks for Ctrl-C: few if contacts at rims may take some
  /// 30 ms each.
  std::size_t at_once() const { return any_ends_ ? 16 : Rows::block; }
  /// Limits of a joint's contact; call with Python's lock.
  const contact::ContactLimits& limits(std::size_t i) const;

 private:
  Shape shape_;
  std::vector<contact::Joint> joints_;
  std::vector<double> numbers_;  // 0, 1, ...
  std::string refusal_;
  bool any_ends_;  // the contact of one of the joints ends
  mutable std::vector<std::optional<contact::ContactLimits>> limits_;
};

/// Ends to leave out of a joint, as JointSpec::without_seat() and
/// without_relief() do.
struct LeftOut {
  bool seat;
  bool relief;

  contact::JointSpec of(const contact::JointSpec& spec) const {
    const contact::JointSpec some = seat ? spec.without_seat() : spec;
    return relief ? some.without_relief() : some;
  }
};

/// A joint whose contact can be computed, with or without friction in its seat.
struct AnyJoint {
  contact::Joint joint;
  std::string refusal;  ///< error of functions of friction; "" if they work
};
AnyJoint any_joint(const contact::JointSpec& spec, contact::SharedLaws& laws);

/// Collects the largest contact of each joint and notes on contacts at rims,
/// for rows on any thread.
class LargestContacts {
 public:
  explicit LargestContacts(const JointSet& joints)
      : joints_(joints), largest_(joints.size()) {}

  void add(const double* const* at, double half_angle, double peak_pressure,
           double rim_overlap = 0);
  /// Ignores solutions without numbers; their status reports them.
  void add(const double* const* at, const contact::JointSolution& s);
  /// Emits a ContactWarning for each limit exceeded by a joint, and for each
  /// note on its rims; only for the first such joint.
  void warn() const;
  /// A sentence for each limit exceeded by a single joint.
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

/// Emits the warnings of a solution of a single joint.
void warn_of(const JointSet& joint, const contact::JointSolution& s);

}  // namespace contact_python
