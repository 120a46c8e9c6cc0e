#include "libcontact/pair/friction_law.hpp"

#include "libcontact/base/check.hpp"

namespace contact {

FrictionLaw::FrictionLaw(double coefficient, double adhesion)
    : coefficient_(coefficient), adhesion_(adhesion) {
  detail::require(detail::is_not_negative(coefficient), "friction law",
                  "coefficient", coefficient, "0 or above and finite");
  detail::require(detail::is_not_negative(adhesion), "friction law", "adhesion",
                  adhesion, "0 Pa or above and finite");
}

ViscousLaw::ViscousLaw(double constant, double pressure_slope)
    : constant_(constant), pressure_slope_(pressure_slope) {
  detail::require(detail::is_not_negative(constant), "viscous law", "constant",
                  constant, "0 Pa s/m or above and finite");
  detail::require(detail::is_not_negative(pressure_slope), "viscous law",
                  "pressure_slope", pressure_slope,
                  "0 s/m or above and finite");
}

}  // namespace contact
