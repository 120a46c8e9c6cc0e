#include "libcontact/friction_law.hpp"

#include <cmath>

#include "libcontact/detail/check.hpp"

namespace contact {

FrictionLaw::FrictionLaw(double coefficient, double adhesion)
    : coefficient_(coefficient), adhesion_(adhesion) {
  detail::require(coefficient >= 0 && std::isfinite(coefficient),
                  "friction law", "coefficient", coefficient,
                  "0 or above, finite");
  detail::require(adhesion >= 0 && std::isfinite(adhesion), "friction law",
                  "adhesion", adhesion, "0 Pa or above, finite");
}

}  // namespace contact
