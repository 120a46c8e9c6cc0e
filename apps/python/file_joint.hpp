#pragma once

#include <pybind11/pybind11.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libcontact/files/joint_tables.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/validity.hpp"
#include "python/joint_set.hpp"

namespace contact_python {

/// Keys and their values as strings from Python.
using Settings = std::vector<std::pair<std::string, std::string>>;
contact::KeySettings key_settings(const Settings& settings);

/// A joint from the text of a joint file.
class FileJoint : public JointSet {
 public:
  /// @param left_out  ends to leave out of the joint
  /// @param table     Joint::table() of this joint
  /// @throws contact::Error as read_joint() and Joint::tabulated()
  FileJoint(const std::string& text, const std::string& source,
            const std::filesystem::path& folder,
            const contact::KeySettings& settings, LeftOut left_out,
            const std::optional<std::string>& table);

  const contact::JointSpec& spec() const { return spec_; }
  const contact::JointContact& contact() const { return (*this)[0].contact(); }
  const contact::ContactLimits& limits() const { return JointSet::limits(0); }
  /// @throws contact::Error if it has no friction, or no friction in its seat
  const contact::Joint& joint() const {
    require_friction();
    return (*this)[0];
  }
  /// The file with its settings, as TOML.
  const std::string& toml() const { return toml_; }
  /// JointSpec::canonical_text(); joints are equal if their texts are equal.
  const std::string& canonical() const { return canonical_; }

 private:
  FileJoint(std::string toml, contact::JointSpec spec, AnyJoint joint);

  std::string toml_;
  contact::JointSpec spec_;
  std::string canonical_;
};

/// Adds the classes and functions of one subject to the module.
void bind_joint(pybind11::module_& m);
void bind_contact(pybind11::module_& m, pybind11::class_<JointSet>& joints,
                  pybind11::class_<FileJoint, JointSet>& joint);
void bind_solutions(pybind11::module_& m, pybind11::class_<JointSet>& joints);
void bind_ratings(pybind11::module_& m, pybind11::class_<JointSet>& joints,
                  pybind11::class_<FileJoint, JointSet>& joint);
void bind_stuck(pybind11::module_& m,
                pybind11::class_<FileJoint, JointSet>& joint);
void bind_step(pybind11::module_& m, pybind11::class_<JointSet>& joints);
void bind_mechanism(pybind11::module_& m);
void bind_moment_set(pybind11::module_& m, pybind11::class_<JointSet>& joints);
void bind_joints(pybind11::module_& m);
void bind_play(pybind11::module_& m);
void bind_duty(pybind11::module_& m);
void bind_identify(pybind11::module_& m);
void bind_case(pybind11::module_& m);
void bind_run(pybind11::module_& m);

}  // namespace contact_python
