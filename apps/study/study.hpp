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

/// The quantity that every row of a case has: the largest drift of the balance
/// of energies over the largest of them.
inline constexpr const char* energy_drift = "energy.drift";

/// A study: of each run its row, a function of the file and the run's number
/// alone, in any order and from any thread.
class Study {
 public:
  /// @throws contact::Error if a dispersion does not fit its key, the nominal
  ///   run fails, or it has no number of a requirement's name
  explicit Study(const std::filesystem::path& file,
                 const PlanChanges& changes = {});
  Study(const Study&) = delete;
  Study& operator=(const Study&) = delete;

  const Plan& plan() const { return plan_; }
  const Design& design() const { return *design_; }
  /// Rows 0, the nominal one, to runs().
  std::uint64_t runs() const { return plan_.runs; }

  /// Names of a row's numbers: inputs, quantities.
  std::vector<std::string> columns() const;
  std::size_t inputs() const { return design_->draws().size(); }
  const std::vector<std::string>& quantities() const { return quantities_; }
  /// Number of them for requirements; others follow.
  std::size_t required() const { return for_requirements_; }
  /// All numbers of the nominal run by their names.
  const std::map<std::string, double>& nominal() const {
    return nominal_.numbers;
  }
  /// Unintended effects in the nominal run, and numbers that names with `*`
  /// leave out as it does not reach them.
  const std::vector<std::string>& warnings() const { return nominal_.warnings; }
  /// Value that a requirement tests: the worst of a row's quantities.
  double value_of(std::size_t requirement, const Row& row) const;

  /// @param stop  asked on the way: why the run has to end; "" to go on
  Row row(std::uint64_t run,
          const std::function<std::string()>& stop = {}) const;
  /// The case of a run, for its history; throws Error of a joint.
  separation::Case case_of(std::uint64_t run) const;

  /// Keys that, given another value, change none of the quantities, the
  /// energies aside.
  /// @param notable  changes of each quantity that count: of those below them
  ///   the steps of the integrator may be the reason
  std::vector<std::string> idle_keys(const std::vector<double>& notable) const;
  /// Before so many runs: how long they take, if that is long; else "".
  std::string forecast(std::uint64_t runs, int jobs) const {
    return model_->forecast(runs, jobs);
  }
  /// Whatever its rows depend on.
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
