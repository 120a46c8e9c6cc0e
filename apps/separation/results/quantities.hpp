#pragma once

#include <span>

#include "libcontact/quantities/quantity.hpp"
#include "separation/results/record.hpp"
#include "separation/simulation/torque_margin.hpp"

/// Quantities of a run, for its summary and the numbers of studies.
namespace separation {

std::span<const contact::Quantity<JointPeaks>> joint_quantities();
std::span<const contact::Quantity<BodyRecord>> hinge_quantities();
/// Quantities of a body with a lock, after the quantities of the hinge.
std::span<const contact::Quantity<BodyRecord>> lock_quantities();
/// Quantities of a body with stops, and of a body that an event latches.
std::span<const contact::Quantity<BodyRecord>> stop_quantities();
std::span<const contact::Quantity<BodyRecord>> latch_quantities();
std::span<const contact::Quantity<BodyRecord>> body_quantities();
std::span<const contact::Quantity<BodyRecord::Release>> release_quantities();

std::span<const contact::Quantity<TipOffRecord>> tip_off_quantities();
std::span<const contact::Quantity<TorqueMargin>> margin_quantities();

/// Rates in degrees, as angles.
const contact::Unit& summary_unit(contact::Dimension dimension);

/// "peak_reaction_N"
template <class T>
std::string summary_name(const contact::Quantity<T>& q) {
  return contact::column_name(q.stem(), "", summary_unit(q.dimension));
}

/// Calls `each(number, k)` for the numbers of a quantity: k is 1, 2, 3 of a
/// vector, else 0.
template <class T, class Each>
void for_numbers(const contact::Quantity<T>& q, const T& of, const Each& each) {
  const contact::Unit& unit = summary_unit(q.dimension);
  if (!q.is_vector()) {
    each(unit.from_si(number_of(q, of)), 0);
    return;
  }
  for (const int k : {0, 1, 2}) {
    each(unit.from_si(number_of(q, of, k)), k + 1);
  }
}

}  // namespace separation
