#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "separation/case/case.hpp"
#include "study/model/model.hpp"
#include "study/plan/design.hpp"
#include "study/plan/plan.hpp"
#include "study/rows/row.hpp"

namespace study {

/// A quantity of every row of a case: the largest drift of the energy balance
/// over the largest energy.
inline constexpr const char* energy_drift = "energy.drift";

/// A study. The row of each run is a function of the file and the run's number
/// only, in any order and thread.
class Study {
 public:
  /// @throws contact::Error if a dispersion does not suit its key, the nominal
  ///   run fails, or it lacks a number named by a requirement
  explicit Study(const std::filesystem::path& file,
                 const PlanChanges& changes = {});
  Study(const Study&) = delete;
  Study& operator=(const Study&) = delete;

  const Plan& plan() const { return plan_; }
  const Design& design() const { return *design_; }
  /// Rows are numbered 0 (nominal) to runs().
  std::uint64_t runs() const { return plan_.runs; }

  /// Names of a row's numbers: inputs, then quantities.
  std::vector<std::string> columns() const;
  std::size_t inputs() const { return design_->draws().size(); }
  const std::vector<std::string>& quantities() const { return quantities_; }
  /// Number of quantities for requirements; they come first.
  std::size_t required() const { return for_requirements_; }
  /// All numbers of the nominal run by name.
  const std::map<std::string, double>& nominal() const {
    return nominal_.numbers;
  }
  /// Unintended effects in the nominal run, and numbers that match a name with
  /// `*` but are undefined in it.
  const std::vector<std::string>& warnings() const { return nominal_.warnings; }
  /// Value to which a requirement applies: the worst of a row's quantities.
  double value_of(std::size_t requirement, const Row& row) const;

  /// @param stop  called during the run: the reason to end it, or "" to
  ///              continue
  Row row(std::uint64_t run,
          const std::function<std::string()>& stop = {}) const;
  /// The case of a run, for its history; throws Error for a study of a joint.
  separation::Case case_of(std::uint64_t run) const;

  /// Keys whose value does not affect any quantity except the energies.
  /// @param notable  significant change of each quantity; smaller changes may
  ///                 come from the steps of the integrator
  std::vector<std::string> idle_keys(const std::vector<double>& notable) const;
  /// Expected time of so many runs if it is long; else "".
  std::string forecast(std::uint64_t runs, int jobs) const {
    return model_->forecast(runs, jobs);
  }
  /// Identifies everything that affects its rows.
  std::string identity() const;

 private:
  void check_draws() const;
  void refuse_repeated_keys() const;
  bool has_effect(std::size_t dispersion, double u,
                  const std::vector<double>& notable) const;
  void find_quantities();
  std::vector<std::string> matching(const std::string& pattern,
                                    const contact::TomlTable& table,
                                    const char* key);

  Plan plan_;
  std::unique_ptr<Model> model_;
  std::unique_ptr<Design> design_;
  Result nominal_;  ///< with all numbers
  std::vector<std::string> quantities_;
  std::vector<std::vector<std::size_t>> required_;  ///< indices in quantities_
  std::size_t for_requirements_ = 0;
  Effort effort_;
};

}  // namespace study
