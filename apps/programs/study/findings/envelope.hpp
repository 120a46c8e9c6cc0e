#pragma once

#include <array>
#include <string>
#include <vector>

#include "programs/study/findings/findings.hpp"

namespace study {

/// Range of a quantity over time.
struct Envelope {
  std::string name;   ///< name of its picture
  std::string label;  ///< with its unit
  /// Its name in requirements, "" if none.
  std::string quantity;
  std::size_t runs;
  std::string special;  ///< run in the last column of shares
  std::vector<double> times;
  /// Smallest, 5 %, 50 %, 95 %, largest, and the special run's value; NaN where
  /// there is none.
  std::vector<std::array<double, 6>> shares;
  std::vector<std::size_t> counts;  ///< runs with a value, at each time

  /// True if all values are positive and spread so widely that a linear axis
  /// would hide the small ones.
  bool is_wide() const;
};

/// Names of envelopes.
inline constexpr std::array envelope_names = {"clearance", "angles"};

/// Envelopes of the first hundred runs and the worst ones, which it runs again:
/// the smallest clearance of all pairs, and the angles of all hinges until they
/// break. Runs whose draws make no valid case are left out.
std::vector<Envelope> envelopes(const Study& study, const Findings& findings);

}  // namespace study
