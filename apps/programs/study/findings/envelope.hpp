#pragma once

#include <array>
#include <string>
#include <vector>

#include "programs/study/findings/findings.hpp"

namespace study {

/// Range of a quantity over the time.
struct Envelope {
  std::string name;   ///< name of its picture
  std::string label;  ///< with its unit
  /// Name in requirements, "" if none.
  std::string quantity;
  std::size_t runs;
  std::string special;  ///< run of the last number
  std::vector<double> times;
  /// Smallest, 5 %, 50 %, 95 %, largest, and the special run's value; NaN where
  /// there is none.
  std::vector<std::array<double, 6>> shares;
  std::vector<std::size_t> counts;  ///< runs that have a number, at each time

  /// All above 0, and far apart.
  bool is_wide() const;
};

/// Names that they may have.
inline constexpr std::array envelope_names = {"clearance", "angles"};

/// Envelopes of the first hundred runs and the worst ones, run again: the
/// smallest clearance of all pairs, and the angles of all hinges until they
/// break. Runs whose draws make no case are not among them.
std::vector<Envelope> envelopes(const Study& study, const Findings& findings);

}  // namespace study
