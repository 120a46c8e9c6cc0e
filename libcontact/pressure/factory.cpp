#include "libcontact/pressure/factory.hpp"

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/pressure/cosine.hpp"
#include "libcontact/pressure/exact.hpp"
#include "libcontact/pressure/mixture.hpp"
#include "libcontact/pressure/sqrt.hpp"
#include "libcontact/pressure/worn.hpp"

namespace contact {

const std::vector<std::string>& pressure_law_names() {
  static const std::vector<std::string> names = {
      "cosine", "sqrt_tan", "sqrt_theta", "mixture", "exact", "worn"};
  return names;
}

bool pressure_law_allows(std::string_view name,
                         const ContactConditions& conditions) {
  if (conditions.walls) return name == "exact" || name == "worn";
  return !conditions.loading.is_back() || name != "mixture";
}

std::unique_ptr<PressureLaw> make_pressure_law(
    std::string_view name, JointKind kind, const ElasticPair& pair,
    const ContactConditions& conditions) {
  if (!pressure_law_allows(name, conditions)) {
    std::vector<std::string> fitting = pressure_law_names();
    std::erase_if(fitting, [&](const std::string& other) {
      return !pressure_law_allows(other, conditions);
    });
    throw Error(detail::must_be(
        detail::message("pressure law {}", detail::printable(name)),
        detail::message("{} with {}", detail::either(fitting),
                        to_string(conditions))));
  }
  if (name == "cosine") return std::make_unique<CosinePressure>(kind);
  if (name == "sqrt_tan") return std::make_unique<SqrtTanPressure>(kind);
  if (name == "sqrt_theta") return std::make_unique<SqrtThetaPressure>(kind);
  if (name == "mixture") return std::make_unique<MixturePressure>(kind, pair);
  if (name == "exact") {
    const auto& [loading, walls] = conditions;
    return walls ? std::make_unique<ExactPressure>(kind, *walls, loading)
                 : std::make_unique<ExactPressure>(kind, pair, loading);
  }
  if (name == "worn") return std::make_unique<WornPressure>(kind);
  throw Error(detail::unknown("pressure law", name, pressure_law_names()));
}

}  // namespace contact
