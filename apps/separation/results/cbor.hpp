#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string_view>

namespace separation {

/// Removes the first item from CBOR bytes. nullopt: they do not begin with an
/// item as nlohmann's writer makes it from a state, of known lengths and few
/// levels. nlohmann's reader recurses for every level, so that untrusted bytes
/// could overflow the stack.
std::optional<nlohmann::json> take_cbor(std::string_view& bytes);

}  // namespace separation
