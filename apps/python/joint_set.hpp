#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "libcontact/joint/contact_notes.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/validity.hpp"
#include "python/rows.hpp"

namespace contact_python {

/// The joints that functions of rows are over: an array of any shape, that of a
/// single one ().
class JointSet {
 public:
  /// @param refusal  what functions of friction say if the joints have none
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
  /// @throws contact::Error if they have no friction
  void require_friction() const;
  /// Limits of a joint's contact; with Python's lock.
  const contact::ContactLimits& limits(std::size_t i) const;

 private:
  Shape shape_;
  std::vector<contact::Joint> joints_;
  std::vector<double> numbers_;  // 0, 1, ...
  std::string refusal_;
  mutable std::vector<std::optional<contact::ContactLimits>> limits_;
};

/// The joint; without friction where there is none.
contact::Joint friction_or_none(const contact::JointSpec& spec,
                                contact::SharedLaws* laws = nullptr);
/// Why it has none; "" if it has.
std::string friction_refusal(const contact::JointSpec& spec);

/// The largest contact of each joint, of rows on any thread.
class LargestContacts {
 public:
  explicit LargestContacts(const JointSet& joints)
      : joints_(joints), largest_(joints.size()) {}

  void add(const double* const* at, double half_angle, double peak_pressure,
           double rim_overlap = 0);
  void add(const double* const* at, const contact::JointSolution& s) {
    add(at, s.half_angle, s.peak_pressure,
        contact::rim_overlap(joints_(at).contact(), s));
  }
  /// Gives a ContactWarning for each limit that the first joint of those that
  /// pass any has passed.
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
};

}  // namespace contact_python
