#pragma once

#include "libcontact/files/joint_file.hpp"
#include "libcontact/quantities/tables.hpp"
#include "study/model/model.hpp"
#include "study/model/pool.hpp"

namespace study {

/// A joint under a reaction at an angle to its angular velocity: [load] of the
/// study file. Numbers are named as hinge-joint's columns, with those of
/// interference where the nominal joint has no clearance; with the keys of
/// EndedLoad as those of joints that end. Files are parsed and
/// keys that are drawn looked up once.
class JointModel : public Model {
 public:
  /// @param plan  has to outlive this object
  explicit JointModel(const Plan& plan);
  ~JointModel() override;

  std::vector<std::string> copies(const Dispersion& dispersion) const override;
  void check(const contact::KeySettings& settings) const override;
  Result run(const contact::KeySettings& settings, const Effort& effort,
             const std::function<std::string()>& stop) const override;
  Result run(const std::vector<double>& draws, const Effort& effort,
             const std::function<std::string()>& stop) const override;
  std::string identity() const override;

 private:
  struct Loaded;
  struct Seat;
  struct Form;
  Loaded loaded(const contact::TomlTable& joint,
                const contact::TomlTable& study) const;
  Loaded read(const contact::KeySettings& settings) const;
  Loaded read(const std::vector<double>& draws) const;
  Result run(const Loaded& loaded, const Effort& effort) const;

  const Plan& plan_;
  contact::TomlFiles files_;
  contact::SharedLaws laws_;  ///< laws of the nominal joint
  std::vector<contact::Column<contact::JointSolution>> columns_;
  std::vector<contact::Column<contact::ContactPatch>> preload_columns_;
  std::unique_ptr<const Seat> seat_;
  mutable Pool<Form> forms_;
};

}  // namespace study
