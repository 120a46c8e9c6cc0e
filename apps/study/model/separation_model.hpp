#pragma once

#include <vector>

#include "libcontact/files/joint_file.hpp"
#include "separation/case/case.hpp"
#include "separation/results/run.hpp"
#include "study/model/model.hpp"

namespace study {

/// A case of hinge-separation. Its files are parsed once; laws are made again
/// where a key changes geometry or material only.
class SeparationModel : public Model {
 public:
  explicit SeparationModel(const Plan& plan);

  int copies(const Dispersion& dispersion) const override;
  void check(const Settings& settings) const override { case_of(settings); }
  Result run(const Settings& settings, const Effort& effort,
             const std::function<std::string()>& stop) const override;
  std::string identity() const override;

  separation::Case case_of(const Settings& settings) const;

 private:
  /// Where the copies of a key are in the case.
  struct Copies {
    bool of_forces;
    std::vector<std::size_t> places;
  };
  Copies places_of(const std::string& key) const;
  separation::Case read(const contact::KeySettings& settings,
                        contact::SharedLaws& laws) const;

  std::filesystem::path file_;
  contact::TomlFiles files_;
  contact::SharedLaws laws_;  ///< of the nominal case
  separation::Case nominal_;
  std::vector<Copies> each_;  ///< of the dispersions that have copies
};

/// The numbers of a summary by their names: BODY.KEY, BODY.joint[1].KEY,
/// BODY.at_release.velocity_m_per_s[1], event.NAME.BODY.time_s,
/// clearance.A.B.smallest_m, clearance.smallest_m of all pairs; blanks of names
/// are underscores.
std::map<std::string, double> numbers_of(const separation::Case& c,
                                         const separation::Outcome& outcome);

}  // namespace study
