#include "libcontact/pair/friction_stress.hpp"

#include <utility>

namespace contact {

FrictionStress::FrictionStress(Function stress, OverSpeed over_speed)
    : stress_(std::make_shared<Function>(std::move(stress))),
      over_speed_(over_speed) {}

FrictionStress FrictionStress::at_rest() const {
  FrictionStress resting = *this;
  resting.at_rest_ = true;
  resting.over_speed_ = OverSpeed::constant;
  return resting;
}

}  // namespace contact
