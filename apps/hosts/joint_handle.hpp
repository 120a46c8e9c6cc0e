// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "libcontact/c/contact.h"

/// Helpers shared by the adapters to simulators. They use the C interface and
/// C++17, because headers of some simulators require C++17.
namespace contact_hosts {

/// @throws std::runtime_error with the message of a failed call
inline void must(contact_status status) {
  if (status == CONTACT_OK) return;
  throw std::runtime_error(contact_last_message());
}

/// Returns the sentences that a C function writes into a buffer.
/// @param fill  contact_status(char* text, std::size_t size)
template <class Fill>
std::string text_of(const Fill& fill) {
  std::string text(8192, 0);
  must(fill(text.data(), text.size()));
  return text.c_str();
}

/// Keys of a file, and their values as text.
using Settings = std::vector<std::pair<std::string, std::string>>;
/// Views of the settings for C.
inline std::vector<contact_setting> c_settings(const Settings& keys) {
  std::vector<contact_setting> given;
  for (const auto& [key, value] : keys) {
    given.push_back({key.c_str(), value.c_str()});
  }
  return given;
}

/// A joint of libcontact read from a file
/// (libcontact/docs/reference/joint_file.md).
using JointHandle = std::unique_ptr<contact_joint, void (*)(contact_joint*)>;

/// @param where  the host's joint, for messages
/// @param kind   of the host's joint
/// @throws std::runtime_error if the file is wrong or describes another kind
inline JointHandle read_joint(const std::string& file, const std::string& where,
                              contact_kind kind) {
  contact_joint* read = nullptr;
  must(contact_joint_read(file.c_str(), nullptr, 0, &read));
  JointHandle joint(read, contact_joint_free);
  contact_joint_size size;
  must(contact_joint_get_size(read, &size));
  if (size.kind != kind) {
    throw std::runtime_error(where + ": " + file + " must be a " +
                             (kind == CONTACT_BALL ? "ball" : "pin") +
                             " joint");
  }
  return joint;
}

/// The half of the joint that has the [seat], if any; its axes are the frame of
/// all vectors.
enum class Seat { none, on_body, on_carrier };
inline Seat seat_of(const contact_joint* joint) {
  contact_joint_size size;
  must(contact_joint_get_size(joint, &size));
  if (!size.has_seat) return Seat::none;
  return size.body_has_inner ? Seat::on_carrier : Seat::on_body;
}

/// True if the joint can hold a moment at rest; viscous joints cannot.
inline bool can_rest(const contact_joint* joint) {
  // Leave the seat out: it might not carry this force.
  contact_joint* made = nullptr;
  must(contact_joint_without_seat(joint, &made));
  const JointHandle endless(made, contact_joint_free);
  const contact_hold hold = {{1e3, 0, 0}, {0, 0, 1e-3}, {0, 0, 1}};
  contact_rest rest;
  must(contact_joint_at_rest(made, &hold, nullptr, &rest));
  return !std::isinf(rest.utilisation);
}

/// A joint with dry friction from its file, for hosts whose solver holds up to
/// a largest moment.
/// @throws std::runtime_error also for a joint that cannot hold a moment
inline JointHandle read_dry_joint(const std::string& file,
                                  const std::string& where, contact_kind kind) {
  JointHandle joint = read_joint(file, where, kind);
  if (!can_rest(joint.get())) {
    throw std::runtime_error(where + ": " + file + " must have dry friction");
  }
  return joint;
}

/// Friction moments of a joint; each solution starts from the previous one.
class FrictionMoment {
 public:
  explicit FrictionMoment(JointHandle joint)
      : joint_(std::move(joint)), seat_(seat_of(joint_.get())) {
    contact_memory* made = nullptr;
    must(contact_memory_make(&made));
    memory_.reset(made);
  }
  const contact_joint* joint() const { return joint_.get(); }
  Seat seat() const { return seat_; }
  /// @param from_seat  3 x 3 numbers, row by row: rotates from the axes of the
  ///                   half with the seat to the axes of the slip; null if they
  ///                   coincide
  void find(const contact_slip& slip, const double* from_seat,
            double* moment) const {
    contact_placement placement{};
    placement.size = sizeof placement;
    if (from_seat) std::copy_n(from_seat, 9, placement.from_seat);
    // A placement would turn the pin into a finite-length pin.
    const bool is_seated = from_seat && seat_ != Seat::none;
    const auto* const turned = is_seated ? &placement : nullptr;
    const char* const key = "friction_moment";
    must(contact_joint_get(joint_.get(), &slip, turned, memory_.get(), &key, 1,
                           moment));
  }

 private:
  JointHandle joint_;
  Seat seat_;
  std::unique_ptr<contact_memory, void (*)(contact_memory*)> memory_{
      nullptr, contact_memory_free};
};

}  // namespace contact_hosts
