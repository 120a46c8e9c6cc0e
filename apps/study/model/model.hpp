#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "libcontact/base/error.hpp"
#include "libcontact/files/toml_reader.hpp"
#include "study/plan/plan.hpp"

namespace study {

/// Numbers that a run does not have.
struct Unreached {
  std::string name;  ///< or "BODY.at_release." of all that begin so
  std::string why;   ///< "BODY is not released"
};

/// The number that every run with joints has: the largest peak pressure over
/// contact::ContactLimits::peak_pressure() of its joint; above 1 it leaves the
/// theory or what the materials bear.
inline constexpr const char* over_limit = "p_peak_over_limit";

/// Result of one run: numbers by their names, or the reason of its failure.
struct Result {
  std::string failure;
  std::map<std::string, double> numbers;
  std::vector<Unreached> unreached = {};   ///< with Effort::remarks
  std::vector<std::string> warnings = {};  ///< with Effort::remarks
};

/// Evaluations wanted along a run.
struct Effort {
  bool peaks = true;
  bool clearance = true;
  bool margins = true;   ///< torque margins of hinges
  bool remarks = false;  ///< effects that are hardly intended
};

/// System that a study runs again and again, from several threads at once.
class Model {
 public:
  virtual ~Model() = default;

  /// Names of the bodies, or of those that forces act on, that a dispersion has
  /// a draw for, each; none if it has one for all.
  /// @throws contact::Error of a key that has no copies
  virtual std::vector<std::string> copies(
      const Dispersion& dispersion) const = 0;

  /// Reads with these values.
  /// @throws contact::Error if they make no case
  virtual void check(const contact::KeySettings& settings) const = 0;
  /// With these values.
  /// @throws contact::Error if they make no case
  virtual Result run(const contact::KeySettings& settings, const Effort& effort,
                     const std::function<std::string()>& stop) const = 0;
  /// With a draw of each key, as of Design::numbers().
  /// @throws contact::Error if they make no case
  virtual Result run(const std::vector<double>& draws, const Effort& effort,
                     const std::function<std::string()>& stop) const = 0;
  /// Looks at the first draws before any of the runs is made; what it decides
  /// belongs to the identity.
  virtual void prepare(const std::vector<std::vector<double>>& /*first*/,
                       std::uint64_t /*runs*/) {}
  /// A sentence on how the runs are made, if that takes long; else "".
  /// @param jobs  threads
  virtual std::string forecast(std::uint64_t /*runs*/, int /*jobs*/) const {
    return {};
  }
  /// Identity of everything that numbers depend on beside the settings.
  virtual std::string identity() const = 0;
};

}  // namespace study
