#pragma once

#include <vector>

#include "libcontact/files/joint_file.hpp"
#include "separation/case/form/case_form.hpp"
#include "separation/results/run.hpp"
#include "study/model/model.hpp"
#include "study/model/pool.hpp"

namespace study {

/// A case of hinge-separation. Its files are parsed and drawn keys looked up
/// only once; laws are made again only if a key changes geometry or material.
class SeparationModel : public Model {
 public:
  /// @param plan  must outlive this object
  explicit SeparationModel(const Plan& plan);

  std::vector<std::string> copies(const Dispersion& dispersion) const override;
  void check(const contact::KeySettings& settings) const override {
    case_of(settings);
  }
  Result run(const contact::KeySettings& settings, const Effort& effort,
             const std::function<std::string()>& stop) const override {
    return run(case_of(settings), effort, stop);
  }
  Result run(const std::vector<double>& draws, const Effort& effort,
             const std::function<std::string()>& stop) const override {
    return run(case_of(draws), effort, stop);
  }
  std::string identity() const override;

  separation::Case case_of(const contact::KeySettings& settings) const;
  separation::Case case_of(const std::vector<double>& draws) const;

 private:
  Result run(separation::Case c, const Effort& effort,
             const std::function<std::string()>& stop) const;
  separation::CaseForm form() const;

  const Plan& plan_;
  contact::TomlFiles files_;
  contact::SharedLaws laws_;  ///< laws of the nominal case
  separation::Case nominal_;
  mutable Pool<separation::CaseForm> forms_;
};

/// The numbers of a summary by name: BODY.KEY, BODY.joint[1].KEY,
/// BODY.at_release.velocity_m_per_s[1], event.NAME.BODY.time_s,
/// clearance.A.B.smallest_m, clearance.smallest_m of all pairs. Blanks in names
/// become underscores.
/// @param margins  include torque margins, which take long
std::map<std::string, double> numbers_of(const separation::Case& c,
                                         const separation::Outcome& outcome,
                                         bool margins = true);

}  // namespace study
