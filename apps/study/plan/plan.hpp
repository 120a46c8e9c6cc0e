#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/plan/distribution.hpp"
#include "study/statistics/verdict.hpp"

namespace study {

/// How the runs are spread.
enum class Sampling { random, latin_hypercube, sobol, saltelli };
inline const std::array<std::string, 4> sampling_names = {
    "random", "latin_hypercube", "sobol", "saltelli"};

/// A common cause, by its place among the factors, and how much of it.
struct Share {
  std::size_t factor;
  double loading;
};

/// A key that scatters.
struct Dispersion {
  std::string key;
  /// The draw multiplies the number or all numbers of the key.
  bool relative;
  /// A draw for each copy of a pattern.
  bool each;
  Quantile quantile;
  /// The same in words: "uniform, low 1, high 2".
  std::string distribution;
  std::vector<Share> shares;
  /// Text of the dispersion in the file: TomlTable::canonical_text().
  std::string content;
  /// For messages: its table in the file.
  contact::TomlTable table;

  /// Setting of the key with this draw.
  contact::KeySetting setting(double number) const;
};

/// Condition on a quantity.
struct Requirement {
  /// With `*`: the worst of all that match.
  std::string quantity;
  bool at_least;  ///< else at most
  double limit;
  Demand demand;
  contact::TomlTable table;

  /// NaN, of a run that failed or has no such number, does not.
  bool holds(double value) const {
    return at_least ? value >= limit : value <= limit;
  }
};

/// A study as its file describes it.
struct Plan {
  std::string name;
  /// One of them.
  std::filesystem::path case_file;
  std::filesystem::path joint_file;
  std::uint64_t runs;
  std::uint64_t seed;
  Sampling sampling;
  std::vector<std::string> factors;
  std::vector<Dispersion> dispersions;
  std::vector<Requirement> requirements;
  /// Quantities recorded in addition to the requirements; may have `*`.
  std::vector<std::string> quantities;
  std::filesystem::path path;
  contact::TomlTable file;
};

/// Settings of the command line in place of the file's.
struct PlanChanges {
  std::optional<std::uint64_t> runs = {};
  std::optional<std::uint64_t> seed = {};
};

/// Reads a study file (keys: study_file.md).
/// @throws contact::Error with one line that names file, line, key, value and
/// the allowed values
Plan read_plan(const std::filesystem::path& path,
               const PlanChanges& changes = {});
/// The same of a text.
/// @param source  what messages call it
Plan parse_plan(std::string_view text, const std::string& source);

/// All keys that a study file may have.
contact::KnownKeys study_keys();

/// More than anyone waits for.
inline constexpr std::int64_t most_runs = 100'000'000;

}  // namespace study
