#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace page {

/// Presets of friction, and units to choose from, as JSON:
///
///     {"presets": [{"name", "least", "largest"}], "units": {"length": [..]}}
std::string choices();

/// Calculator of the page: returns all results that the page shows for a joint
/// file and a state, as JSON. It keeps the laws of the last joint, so that
/// another load needs only new solutions, and another friction or clearance no
/// new law.
///
/// Numbers have the names and units of columns of hinge-joint and
/// hinge-pressure; meanings, notes and errors have the texts of the library.
class Calculator {
 public:
  /// @param data  folder with materials/; relative paths in joint files are
  ///              resolved as if the files lay in its joints/
  explicit Calculator(std::filesystem::path data);
  ~Calculator();

  /// The results, or {"error": MESSAGE} with a message that names the wrong
  /// key:
  ///
  ///     {"words": {"law", ...}, "joint": {"name", "kind", "radius_m", ...},
  ///      "numbers": [{"name", "symbol", "unit", "meaning", "value"}],
  ///      "notes": [..], "warnings": [..],
  ///      "pressure": {"theta_deg": [..], "p_Pa": [..]},
  ///      "same": {"file", "command", "python", "cpp"}}
  ///
  /// A missing number is null, an infinite one "inf".
  /// @param joint  text of a joint file
  /// @param state  TOML: reaction, rate and, for a ball, beta_deg
  std::string answer(const std::string& joint, const std::string& state);

  /// Columns over four decades of load around the load of the state, {"R_N":
  /// [..], "theta0_deg": [..], ...}, or an error; empty without load. They are
  /// kept while the decades stay the same.
  std::string curves(const std::string& joint, const std::string& state);

 private:
  struct Prepared;
  Prepared& prepared(const std::string& joint);

  std::filesystem::path data_;
  std::unique_ptr<Prepared> last_;
};

}  // namespace page
