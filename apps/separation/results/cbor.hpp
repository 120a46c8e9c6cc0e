#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

namespace separation {

/// Takes the first item off CBOR bytes. nullopt: they do not begin with one
/// such as nlohmann's writer makes of a state, of known lengths and of few
/// levels; its reader calls itself for every level, and bytes of strangers may
/// have more than any stack.
std::optional<nlohmann::json> take_cbor(std::string_view& bytes);

}  // namespace separation
