#include "angle/loads.hpp"

namespace hinge_angle {

double Loads::convert(LoadVariable from, double load, LoadVariable to) const {
  if (from == to) return load;
  double parameter = load;
  if (from == LoadVariable::load) parameter = scale_->load_parameter(load);
  if (from == LoadVariable::x) {
    parameter = contact::load_parameter_from_x(kind_, load);
  }
  switch (to) {
    case LoadVariable::load:
      return scale_->load(parameter);
    case LoadVariable::x:
      return contact::x_from_load_parameter(kind_, parameter);
    case LoadVariable::load_parameter:
      break;
  }
  return parameter;
}

}  // namespace hinge_angle
