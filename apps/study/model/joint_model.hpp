#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "libcontact/files/joint_file.hpp"
#include "libcontact/quantities/tables.hpp"
#include "study/model/model.hpp"
#include "study/model/pool.hpp"

namespace study {

/// A joint under a Load: [load] of the study file. Numbers have the names of
/// hinge-joint's columns. If the nominal joint has no clearance, the numbers of
/// interference are included, else its presliding angle. Files are parsed and
/// drawn keys looked up only once.
///
/// Contacts at the rims of a seat take 20 to 60 ms. If only the load scatters,
/// and many contacts are at rims, all solutions but the nominal one come from a
/// table. If only load and friction scatter, solutions share their grids.
class JointModel : public Model {
 public:
  /// @param plan  must outlive this object
  explicit JointModel(const Plan& plan);
  ~JointModel() override;

  std::vector<std::string> copies(const Dispersion& dispersion) const override;
  void check(const contact::KeySettings& settings) const override;
  Result run(const contact::KeySettings& settings, const Effort& effort,
             const std::function<std::string()>& stop) const override;
  Result run(const std::vector<double>& draws, const Effort& effort,
             const std::function<std::string()>& stop) const override;
  void prepare(const std::vector<std::vector<double>>& first,
               std::uint64_t runs) override;
  std::string forecast(std::uint64_t runs, int jobs) const override;
  std::string identity() const override;

 private:
  struct Loaded;
  struct Form;
  struct Rims;
  Loaded loaded(const contact::TomlTable& joint,
                const contact::TomlTable& study) const;
  Loaded read(const contact::KeySettings& settings) const;
  Loaded read(const std::vector<double>& draws) const;
  Result run(const Loaded& loaded, const Effort& effort) const;
  const contact::Joint& tabulated() const;

  const Plan& plan_;
  contact::TomlFiles files_;
  contact::SharedLaws laws_;  ///< laws of the nominal joint
  std::vector<contact::Column<contact::JointSolution>> columns_;
  std::vector<contact::Column<contact::ContactPatch>> patch_columns_;
  std::optional<contact::Joint>
      joint_;                   ///< a single joint, if only the load scatters
  std::unique_ptr<Rims> rims_;  ///< null if no contact is at a rim
  mutable Pool<Form> forms_;
};

}  // namespace study
