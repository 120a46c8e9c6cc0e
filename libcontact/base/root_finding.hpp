#pragma once

#include <boost/math/policies/policy.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>

/// Boost.Math's root finders for functions that may be NaN: nothing throws.
namespace contact {

/// Policy for boost::math::tools.
using NoThrow = boost::math::policies::policy<
    boost::math::policies::domain_error<boost::math::policies::ignore_error>,
    boost::math::policies::evaluation_error<
        boost::math::policies::ignore_error>>;

/// Bracket that remains after a search.
struct RootBracket {
  double low;
  double high;
  bool converged;

  double middle() const { return low + (high - low) / 2; }
};

/// Shrinks a bracket about a change of sign by TOMS 748.
///
/// @param function    double -> double, continuous
/// @param at_low      its value at low; of the other sign than at_high
/// @param bits        until high - low is 2^(1 - bits) of them or less; 53
///                    means 4 epsilon
/// @param step_limit  of evaluations; not converged if they are used up
template <class Function>
RootBracket shrink_bracket(const Function& function, double low, double high,
                           double at_low, double at_high, int bits,
                           std::uintmax_t step_limit = 100) {
  std::uintmax_t steps = step_limit;
  const auto [a, b] = boost::math::tools::toms748_solve(
      function, low, high, at_low, at_high,
      boost::math::tools::eps_tolerance<double>(bits), steps, NoThrow());
  return {a, b, steps < step_limit};
}

}  // namespace contact
