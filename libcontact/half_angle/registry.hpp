#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "libcontact/half_angle/factory.hpp"
#include "libcontact/pair/law_entry.hpp"

/// The half-angle laws that have a name: each stands in the file of its law,
/// all of them in registry.cpp.
namespace contact::detail {

struct HalfAngleRequest {
  JointKind kind;
  const ElasticPair& pair;
  const HalfAngleOptions& options;
  const ContactConditions& conditions;
  std::string_view parameter;  ///< the K of "blend:K", else empty
};

struct HalfAngleEntry {
  LawEntry about;
  std::string_view equation = {};  ///< equation of the paper; "" for none
  /// Cost of a half-angle in multiples of std::tanh (docs/reference/speed.md),
  /// ball and pin.
  int ball_cost = 0;
  int pin_cost = 0;
  bool takes_options = false;    ///< HalfAngleOptions
  bool takes_parameter = false;  ///< after a colon
  /// @throws Error if an option or the parameter is out of range.
  std::unique_ptr<HalfAngleLaw> (*make)(const HalfAngleRequest&) = nullptr;
};

/// In the order of the sources.
std::span<const HalfAngleEntry* const> half_angle_entries();

/// The entry of a name, with or without a parameter; null if there is none.
const HalfAngleEntry* find_half_angle_entry(std::string_view name);

}  // namespace contact::detail
