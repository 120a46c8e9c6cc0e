#pragma once

#include <functional>
#include <string>

#include "libcontact/files/toml_reader.hpp"

namespace study {

/// Quantile function of a number, in the unit of its key: a draw is below it
/// with probability u, for u in (0, 1).
using Quantile = std::function<double(double u)>;

/// Reads a distribution from a table with distribution_keys(): its `kind` and
/// the keys of this kind.
Quantile read_distribution(const contact::TomlTable& table);
/// Text of such a table: "uniform, low 1, high 2".
std::string distribution_text(const contact::TomlTable& table);
contact::KnownKeys distribution_keys();

}  // namespace study
