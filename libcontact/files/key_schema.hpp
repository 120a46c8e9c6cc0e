#pragma once

#include <string>

#include "libcontact/files/toml_reader.hpp"

namespace contact {

/// A JSON schema of a file with these keys, by which editors complete and check
/// TOML: every spelling of a key, with its unit, once, and in tables with a
/// `kind` the keys of that kind, with the ranges and words that their reader
/// allows (KnownKey::allowed). Ranges that depend on other numbers, and keys
/// that need each other, are for the reader to check.
std::string schema_text(const KnownKeys& keys);

}  // namespace contact
