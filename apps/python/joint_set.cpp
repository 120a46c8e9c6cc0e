#include "python/joint_set.hpp"

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

contact::Joint friction_or_none(const contact::JointSpec& spec,
                                contact::SharedLaws* laws) {
  contact::SharedLaws own;
  if (!laws) laws = &own;
  contact::JointSpec smooth = spec.without_seat().without_relief();
  if (spec.friction) return contact::Joint(smooth, *laws);
  smooth.friction = contact::FrictionLaw(0);
  return contact::Joint(smooth, *laws);
}

std::string friction_refusal(const contact::JointSpec& spec) {
  if (spec.friction) return "";
  try {
    spec.contact();
  } catch (const contact::Error& error) {
    return error.what();
  }
  return "";
}

namespace {

// NaN is not larger than anything.
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

contact::LargestContact LargestContacts::at(std::size_t joint) const {
  const Largest& largest = largest_[joint];
  return {largest.half_angle, largest.peak_pressure, largest.rim_overlap};
}

void LargestContacts::warn() const {
  for (std::size_t i = 0; i < largest_.size(); ++i) {
    if (warn_of(joints_.limits(i), at(i))) return;
  }
}

std::vector<std::string> LargestContacts::notes() const {
  return joints_.limits(0).notes(at(0));
}

}  // namespace contact_python
