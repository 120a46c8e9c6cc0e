#include "libcontact/files/tables/friction_presets.hpp"

namespace contact::detail {
namespace {

// Factors of a catalogue, page 26, and of a head in serum: mean -+ deviation.
constexpr FrictionPreset presets[] = {
    {"steel_steel_greased", 0.08, 0.22, "ina-238"},
    {"steel_bronze_greased", 0.1, 0.25, "ina-238"},
    {"steel_ptfe_composite", 0.05, 0.2, "ina-238"},
    {"steel_ptfe_bronze_film", 0.05, 0.2, "ina-238"},
    {"steel_ptfe_fabric", 0.02, 0.2, "ina-238"},
    {"cocr_uhmwpe_wet", 0.054, 0.07, "dipuccio-2015"},
};

}  // namespace

std::span<const FrictionPreset> friction_presets() { return presets; }

}  // namespace contact::detail
