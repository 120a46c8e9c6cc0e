#pragma once

#include <string_view>
#include <utility>

#include "libcontact/load_law/formula.hpp"
#include "libcontact/load_law/load_law.hpp"

namespace contact::detail {

/// The formula of a law, of `load` and `f` for `moment` and `slope`, and what
/// its constants are.
std::string_view pin_formula(const PinLoadLaw& law);
Constants pin_constants(const PinLoadLaw& law);

/// {M, N m, dM/dR, m} of the formula in double or float.
template <class Real>
std::pair<Real, Real> pin_moment(const PinLoadLaw& law, Real load, Real f);

}  // namespace contact::detail
