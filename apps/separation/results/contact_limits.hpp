#pragma once

#include <optional>
#include <string>
#include <vector>

#include "separation/results/record.hpp"

namespace separation {

/// Joints whose largest contact leaves the theory or what its materials bear,
/// a sentence each: contact::ContactLimits::notes().
std::vector<std::string> contact_notes(const Case& c,
                                       const Recorder::Memory& memory);

/// The largest share that a joint's peak pressure has been of
/// contact::ContactLimits::peak_pressure(); none without joints.
std::optional<double> pressure_over_limit(const Case& c,
                                          const Recorder::Memory& memory);

}  // namespace separation
