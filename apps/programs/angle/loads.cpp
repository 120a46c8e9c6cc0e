#include "programs/angle/loads.hpp"

namespace hinge_angle {

Loads::Loads(const cli::Joint& joint)
    : geometry_(joint.spec.geometry), per_length_(!joint.has_length) {
  if (joint.has_size) scale_.emplace(geometry_, joint.pair);
}

std::string Loads::column(const std::string& law) const {
  return "load_" + (law.empty() ? law : law + '_') +
         (per_length_ ? "N_per_m" : "N");
}

double Loads::convert(LoadVariable from, double load, LoadVariable to) const {
  if (from == to) return load;
  if (from == LoadVariable::line_load && to == LoadVariable::load) {
    return geometry_.force_from_load(load);
  }
  double parameter = load;
  if (from == LoadVariable::load) {
    parameter = load_parameter(geometry_.load_from_force(load));
  }
  if (from == LoadVariable::line_load) parameter = load_parameter(load);
  if (from == LoadVariable::x) {
    parameter =
        contact::LoadScale::load_parameter_from_x(geometry_.kind(), load);
  }
  switch (to) {
    case LoadVariable::load:
      return geometry_.force_from_load(law_load(parameter));
    case LoadVariable::line_load:
      return law_load(parameter);
    case LoadVariable::x:
      return contact::LoadScale::x_from_load_parameter(geometry_.kind(),
                                                       parameter);
    case LoadVariable::load_parameter:
      break;
  }
  return parameter;
}

}  // namespace hinge_angle
