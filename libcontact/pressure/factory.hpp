// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/pair/contact_conditions.hpp"
#include "libcontact/pair/material.hpp"
#include "libcontact/pressure/law.hpp"

/// Pressure laws by their names.
namespace contact {

/// The law of joints that name none, whose materials are known.
inline constexpr std::string_view default_pressure_law = "exact";

/// Names that make_pressure_law() knows: cosine, sqrt_tan, sqrt_theta,
/// mixture, exact, worn.
const std::vector<std::string>& pressure_law_names();

/// Whether the law of this name may be taken under these conditions. Loaded
/// through the back all but mixture, which is fitted to contacts under a force
/// at the centre; cosine, sqrt_tan, sqrt_theta and worn are plain shapes, the
/// same for any pair and loading. With finite walls exact and worn alone: thin
/// liners and free rings press in other shapes until wear has shaped them.
bool pressure_law_allows(std::string_view name,
                         const ContactConditions& conditions);

/// A law by its name.
/// @param pair  elastic constants, which mixture and exact depend on; ignored
/// with walls
/// @param conditions  on which exact depends
/// @throws Error if the name is not known or the law is not for these
///         conditions.
std::unique_ptr<PressureLaw> make_pressure_law(
    std::string_view name, JointKind kind, const ElasticPair& pair,
    const ContactConditions& conditions = {});

}  // namespace contact
