#include "python/joint_set.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "libcontact/base/error.hpp"
#include "python/contact_warning.hpp"

namespace contact_python {

JointSet::JointSet(Shape shape, std::vector<contact::Joint> joints,
                   std::string refusal)
    : shape_(std::move(shape)),
      joints_(std::move(joints)),
      numbers_(joints_.size()),
      refusal_(std::move(refusal)),
      any_ends_(std::ranges::any_of(
          joints_, [](const contact::Joint& j) { return !j.is_endless(); })),
      limits_(joints_.size()) {
  std::iota(numbers_.begin(), numbers_.end(), 0.0);
}

Argument JointSet::argument() const {
  return Argument(numbers_.data(), 0, shape_);
}

void JointSet::require_friction() const {
  if (!refusal_.empty()) throw contact::Error(refusal_);
}

const contact::ContactLimits& JointSet::limits(std::size_t i) const {
  if (!limits_[i]) limits_[i] = joints_[i].contact().limits();
  return *limits_[i];
}

AnyJoint any_joint(const contact::JointSpec& spec, contact::SharedLaws& laws) {
  contact::JointSpec smooth = spec;
  std::string refusal;
  if (!spec.friction) {
    smooth.friction = contact::FrictionLaw(0);
    try {
      spec.contact(laws);
    } catch (const contact::Error& error) {
      refusal = error.what();
    }
  }
  try {
    return {contact::Joint(smooth, laws), std::move(refusal)};
  } catch (const contact::Error& error) {
    if (!spec.geometry.seat()) throw;
    return {contact::Joint(smooth.without_seat(), laws), error.what()};
  }
}

namespace {

// Comparisons with NaN are false.
void raise(std::atomic<double>& largest, double value) {
  double before = largest.load(std::memory_order_relaxed);
  while (value > before && !largest.compare_exchange_weak(
                               before, value, std::memory_order_relaxed)) {
  }
}

}  // namespace

void LargestContacts::add(const double* const* at, double half_angle,
                          double peak_pressure, double rim_overlap) {
  Largest& largest = largest_[JointSet::number(at)];
  raise(largest.half_angle, half_angle);
  raise(largest.peak_pressure, peak_pressure);
  raise(largest.rim_overlap, rim_overlap);
}

void LargestContacts::add(const double* const* at,
                          const contact::JointSolution& s) {
  const contact::Joint& joint = joints_(at);
  add(at, s.half_angle, s.peak_pressure,
      contact::rim_overlap(joint.contact(), s));
  const bool ends = !joint.is_endless() || s.work;
  if (!ends || s.status != contact::Status::ok) return;
  contact::ContactNotes notes;
  notes.add(joint, s);
  const std::lock_guard lock(of_notes_);
  notes_[JointSet::number(at)].add(notes);
}

contact::LargestContact LargestContacts::at(std::size_t joint) const {
  const Largest& of = largest_[joint];
  contact::LargestContact largest{of.half_angle, of.peak_pressure,
                                  of.rim_overlap};
  if (const auto found = notes_.find(joint); found != notes_.end()) {
    largest.add(found->second.largest());
  }
  return largest;
}

void LargestContacts::warn() const {
  for (std::size_t i = 0; i < largest_.size(); ++i) {
    bool any = warn_of(joints_.limits(i), at(i));
    if (const auto found = notes_.find(i); found != notes_.end()) {
      for (const std::string& note : found->second.of_seat()) warn_of(note);
      any |= !found->second.of_seat().empty();
    }
    if (any) return;
  }
}

std::vector<std::string> LargestContacts::notes() const {
  return joints_.limits(0).notes(at(0));
}

void warn_of(const JointSet& joint, const contact::JointSolution& s) {
  LargestContacts largest(joint);
  const double* const first = joint.argument().data;
  largest.add(&first, s);
  largest.warn();
}

}  // namespace contact_python
