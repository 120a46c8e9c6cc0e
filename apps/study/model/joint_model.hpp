#pragma once

#include "libcontact/files/joint_file.hpp"
#include "libcontact/quantities/quantity.hpp"
#include "study/model/model.hpp"

namespace study {

/// A joint under a reaction at an angle to its angular velocity: [load] of the
/// study file. Numbers are named as hinge-joint's columns.
class JointModel : public Model {
 public:
  explicit JointModel(const Plan& plan);

  int copies(const Dispersion& dispersion) const override;
  void check(const Settings& settings) const override;
  Result run(const Settings& settings, const Effort& effort,
             const std::function<std::string()>& stop) const override;
  std::string identity() const override;

 private:
  struct Loaded;
  Loaded read(const contact::KeySettings& settings,
              contact::SharedLaws& laws) const;

  std::filesystem::path joint_;
  std::filesystem::path study_;
  contact::TomlFiles files_;
  contact::SharedLaws laws_;  ///< of the nominal joint
  std::vector<contact::Column<contact::JointSolution>> columns_;
};

}  // namespace study
