#pragma once

#include <string_view>
#include <utility>

#include "libcontact/load_law/formula.hpp"
#include "libcontact/load_law/load_law.hpp"

namespace contact::detail {

/// The formula of a law, from `load` and `f` to `moment` and `slope`, and its
/// constants.
std::string_view pin_formula(const PinLoadLaw& law);
Constants pin_constants(const PinLoadLaw& law);

/// {M in N m, dM/dR in m} by the formula in double or float.
template <class Real>
std::pair<Real, Real> pin_moment(const PinLoadLaw& law, Real load, Real f);

}  // namespace contact::detail
