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

/// Sampling method of the runs.
enum class Sampling { random, latin_hypercube, sobol, saltelli };
inline const std::array<std::string, 4> sampling_names = {
    "random", "latin_hypercube", "sobol", "saltelli"};

/// Share of a common factor, given by the factor's index.
struct Share {
  std::size_t factor;
  double loading;
};

/// A key that scatters.
struct Dispersion {
  std::string key;
  /// True: the draw multiplies the number or all numbers of the key.
  bool relative;
  /// True: each copy of a pattern has its own draw.
  bool each;
  Quantile quantile;
  /// The distribution in words: "uniform, low 1, high 2".
  std::string distribution;
  std::vector<Share> shares;
  /// Text of the dispersion in the file: TomlTable::canonical_text().
  std::string content;
  /// Its table in the file, for messages.
  contact::TomlTable table;

  /// Setting of the key with this draw.
  contact::KeySetting setting(double number) const;
};

/// Condition on a quantity.
struct Requirement {
  /// With `*`: the worst of all matching quantities.
  std::string quantity;
  bool at_least;  ///< else at most
  double limit;
  Demand demand;
  contact::TomlTable table;

  /// False for NaN: the run failed or has no such number.
  bool holds(double value) const {
    return at_least ? value >= limit : value <= limit;
  }
};

/// A study as its file describes it.
struct Plan {
  std::string name;
  /// One of the two files is given.
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

/// Settings of the command line that replace settings of the file.
struct PlanChanges {
  std::optional<std::uint64_t> runs = {};
  std::optional<std::uint64_t> seed = {};
};

/// Reads a study file (keys: study_file.md).
/// @throws contact::Error with one line that names file, line, key, value and
/// the allowed values
Plan read_plan(const std::filesystem::path& path,
               const PlanChanges& changes = {});
/// As above, from a text.
/// @param source  its name in messages
Plan parse_plan(std::string_view text, const std::string& source);

/// All keys that a study file may have.
contact::KnownKeys study_keys();

/// More runs than is practical.
inline constexpr std::int64_t most_runs = 100'000'000;

}  // namespace study
