#include "programs/pressure/loaded_contacts.hpp"

namespace hinge_pressure {

using hinge_angle::LoadVariable;

LoadedContact LoadedContacts::operator[](std::size_t index) const {
  const double value = input_.values[index];
  const double parameter =
      loads_.convert(input_.variable, value, LoadVariable::load_parameter);
  const double load =
      loads_.have_load()
          ? loads_.convert(input_.variable, value, LoadVariable::load)
          : parameter;
  const auto result = law_.half_angle(parameter * loads_.factor(law_));
  return {load, parameter, result.half_angle, result.status};
}

}  // namespace hinge_pressure
