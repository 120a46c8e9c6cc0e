#pragma once

#include <span>
#include <string>
#include <string_view>

#include "libcontact/quantities/quantity.hpp"

namespace cli {

/// The column of a number of the tables of quantities: "theta0_deg".
/// @param of  which of several laws or bodies has it: "theta0_exact_deg"
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
