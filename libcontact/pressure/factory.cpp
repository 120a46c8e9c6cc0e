#include "libcontact/pressure/factory.hpp"

#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/pressure/cosine.hpp"
#include "libcontact/pressure/exact.hpp"
#include "libcontact/pressure/mixture.hpp"
#include "libcontact/pressure/sqrt.hpp"

namespace contact {

const std::vector<std::string>& pressure_law_names() {
  static const std::vector<std::string> names = {
      "cosine", "sqrt_tan", "sqrt_theta", "mixture", "exact"};
  return names;
}

bool pressure_law_allows(std::string_view name, const InnerLoading& loading) {
  return !loading.is_back() || name != "mixture";
}

std::unique_ptr<PressureLaw> make_pressure_law(std::string_view name,
                                               JointKind kind,
                                               const ElasticPair& pair,
                                               const InnerLoading& loading) {
  if (!pressure_law_allows(name, loading)) {
    throw Error(detail::message(
        "loading {}: pressure law {}: allowed: cosine, sqrt_tan, sqrt_theta, "
        "exact",
        to_string(loading), name));
  }
  if (name == "cosine") return std::make_unique<CosinePressure>(kind);
  if (name == "sqrt_tan") return std::make_unique<SqrtTanPressure>(kind);
  if (name == "sqrt_theta") return std::make_unique<SqrtThetaPressure>(kind);
  if (name == "mixture") return std::make_unique<MixturePressure>(kind, pair);
  if (name == "exact")
    return std::make_unique<ExactPressure>(kind, pair, loading);
  throw Error(detail::message("pressure law {}: allowed: {}",
                              detail::printable(name),
                              detail::joined(pressure_law_names(), ", ")));
}

}  // namespace contact
