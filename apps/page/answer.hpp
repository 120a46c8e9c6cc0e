#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace page {

/// Presets of friction and units to choose from, as JSON:
///
///     {"presets": [{"name", "least", "largest"}], "units": {"length": [..]}}
std::string choices();

/// Calculator of the page: answers a joint file and a state with all that the
/// page shows, as JSON. The laws of the last joint are kept, so that another
/// load costs solutions alone, and another friction or clearance no new law.
///
/// Numbers equal the columns of hinge-joint and hinge-pressure, in their units;
/// columns, notes and errors have the library's words.
class Calculator {
 public:
  /// @param data  the folder with materials/, to which the paths of joint files
  ///   are relative as if they lay in its joints/
  explicit Calculator(std::filesystem::path data);
  ~Calculator();

  /// An answer, or {"error": MESSAGE}, whose message names the key at fault:
  ///
  ///     {"words": {"law", ...}, "joint": {"name", "kind", "radius_m", ...},
  ///      "numbers": [{"name", "symbol", "unit", "meaning", "value"}],
  ///      "notes": [..], "warnings": [..],
  ///      "pressure": {"theta_deg": [..], "p_Pa": [..]},
  ///      "same": {"file", "command", "python", "cpp"}}
  ///
  /// A number that does not exist is null, an infinite one "inf".
  /// @param joint  text of a joint file
  /// @param state  TOML too: reaction, rate and, of a ball, beta_deg
  std::string answer(const std::string& joint, const std::string& state);

  /// Columns over four decades of load around the load of the state, {"R_N":
  /// [..], "theta0_deg": [..], ...}, or an error; empty without load. They are
  /// kept while the decades are the same.
  std::string curves(const std::string& joint, const std::string& state);

 private:
  struct Prepared;
  Prepared& prepared(const std::string& joint);

  std::filesystem::path data_;
  std::unique_ptr<Prepared> last_;
};

}  // namespace page
