#pragma once

#include <span>
#include <string>
#include <string_view>

#include "libcontact/quantities/quantity.hpp"

namespace cli {

/// Column name of a quantity with its unit: "theta0_deg".
/// @param of  the law or body, if there are several: "theta0_exact_deg"
template <class T>
std::string column_of(std::span<const contact::Quantity<T>> table,
                      std::string_view key, std::string_view of = "") {
  const auto& quantity = *contact::find_quantity(table, key);
  std::string part(of);
  if (!part.empty()) part.insert(0, 1, '_');
  return contact::column_name(quantity.stem(), part,
                              contact::printed_unit(quantity.dimension));
}

}  // namespace cli
