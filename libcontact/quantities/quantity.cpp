#include "libcontact/quantities/quantity.hpp"

#include "libcontact/base/text.hpp"

namespace contact {

std::string unit_text(Dimension dimension) {
  return unit_symbol(units_of(dimension).front().ending);
}

std::string description(std::string_view symbol, std::string_view meaning,
                        Dimension dimension) {
  std::string text;
  if (!symbol.empty()) text = detail::message("{}: ", symbol);
  text += meaning;
  if (const std::string unit = unit_text(dimension); !unit.empty()) {
    text += ", " + unit;
  }
  return text;
}

std::string column_name(std::string_view stem, std::string_view part,
                        const Unit& unit) {
  return detail::message("{}{}{}{}", stem, part, unit.ending.empty() ? "" : "_",
                         unit.ending);
}

}  // namespace contact
