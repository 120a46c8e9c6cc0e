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

/// Numbers that are undefined for a run, with the reason.
struct Unreached {
  std::string name;  ///< or "BODY.at_release." for all that begin with it
  std::string why;   ///< "BODY is not released"
};

/// A number of every run with joints: the largest ratio of peak pressure to
/// contact::ContactLimits::peak_pressure() of the joint. Above 1 the joint
/// exceeds the range of the theory or the strength of its materials.
inline constexpr const char* over_limit = "p_peak_over_limit";

/// Result of one run: its numbers by name, or the reason of its failure.
struct Result {
  std::string failure;
  std::map<std::string, double> numbers;
  std::vector<Unreached> unreached = {};   ///< with Effort::remarks
  std::vector<std::string> warnings = {};  ///< with Effort::remarks
};

/// Optional evaluations of a run.
struct Effort {
  bool peaks = true;
  bool clearance = true;
  bool margins = true;   ///< torque margins of hinges
  bool remarks = false;  ///< effects that are probably not intended
};

/// A system that a study runs many times, from several threads at once.
class Model {
 public:
  virtual ~Model() = default;

  /// Names of the copies (bodies, or bodies with the force) that get one draw
  /// each from a dispersion; empty if one draw applies to all.
  /// @throws contact::Error for a key without copies
  virtual std::vector<std::string> copies(
      const Dispersion& dispersion) const = 0;

  /// Reads the case with these values.
  /// @throws contact::Error if they make no valid case
  virtual void check(const contact::KeySettings& settings) const = 0;
  /// Runs the case with these values.
  /// @throws contact::Error if they make no valid case
  virtual Result run(const contact::KeySettings& settings, const Effort& effort,
                     const std::function<std::string()>& stop) const = 0;
  /// Runs the case with one draw for each key, as Design::numbers() gives them.
  /// @throws contact::Error if they make no valid case
  virtual Result run(const std::vector<double>& draws, const Effort& effort,
                     const std::function<std::string()>& stop) const = 0;
  /// Receives the first draws before any run; its decisions are part of the
  /// identity.
  virtual void prepare(const std::vector<std::vector<double>>& /*first*/,
                       std::uint64_t /*runs*/) {}
  /// A sentence on the expected time if the runs take long; else "".
  /// @param jobs  threads
  virtual std::string forecast(std::uint64_t /*runs*/, int /*jobs*/) const {
    return {};
  }
  /// Identifies everything but the settings that affects the numbers.
  virtual std::string identity() const = 0;
};

}  // namespace study
