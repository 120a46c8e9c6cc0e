#include "programs/joint/state.hpp"

#include "libcontact/base/units.hpp"

namespace hinge_joint {

Input state_from_reaction(double reaction, double b_deg, double rate) {
  const auto [sin, cos] = contact::detail::sine_cosine_deg(b_deg);
  return {{reaction * sin, 0, reaction * cos},
          {0, 0, rate},
          Input::Given{reaction, b_deg}};
}

Input state_from_contact(double normal_force, double a_deg, double rate) {
  const auto [sin, cos] = contact::detail::sine_cosine_deg(a_deg);
  return {{0, 0, normal_force},
          {0, rate * cos, rate * sin},
          Input::Given{normal_force, a_deg}};
}

}  // namespace hinge_joint
