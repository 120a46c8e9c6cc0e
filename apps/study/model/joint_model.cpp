#include "study/model/joint_model.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "libcontact/files/joint_tables.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/validity.hpp"
#include "libcontact/quantities/tables.hpp"

namespace study {

using contact::Interval;
using contact::KeySettings;
using contact::TomlTable;

struct JointModel::Loaded {
  contact::Joint joint;
  double reaction;  ///< N
  double beta;      ///< rad
  double rate;      ///< rad/s
};

JointModel::JointModel(const Plan& plan)
    : joint_(plan.joint_file), study_(plan.path) {
  for (const auto& q : contact::solution_quantities()) {
    std::ranges::move(columns_of(q), std::back_inserter(columns_));
  }
  contact::read_joint(joint_).contact(laws_);
  read({}, laws_);
}

int JointModel::copies(const Dispersion& dispersion) const {
  if (dispersion.each) {
    dispersion.table.needs("each", "a case with bodies that have a pattern");
  }
  return 0;
}

JointModel::Loaded JointModel::read(const KeySettings& settings,
                                    contact::SharedLaws& laws) const {
  KeySettings of_joint;
  KeySettings of_study;
  for (const contact::KeySetting& setting : settings) {
    (setting.key.starts_with("load.") ? of_study : of_joint).push_back(setting);
  }
  const contact::JointSpec joint = contact::joint_of_file(
      files_.open(joint_, contact::joint_keys, of_joint));
  const TomlTable load =
      files_.open(study_, study_keys, of_study).table("load");
  return {contact::Joint(joint.contact(laws)),
          load.number("reaction", Interval::positive()),
          load.optional_number("beta", {0, std::numbers::pi})
              .value_or(std::numbers::pi / 2),
          load.optional_number("rate", Interval::positive()).value_or(1)};
}

void JointModel::check(const Settings& settings) const {
  contact::SharedLaws laws = laws_;
  read(settings[0], laws);
}

Result JointModel::run(const Settings& settings, const Effort& effort,
                       const std::function<std::string()>& /*stop*/) const {
  contact::SharedLaws laws = laws_;
  const Loaded loaded = read(settings[0], laws);
  const contact::JointSolution s = loaded.joint.solve(
      {loaded.reaction *
           Eigen::Vector3d(std::sin(loaded.beta), 0, std::cos(loaded.beta)),
       {0, 0, loaded.rate}});
  if (s.status != contact::Status::ok) {
    return {s.status == contact::Status::out_of_range
                ? "the load is out of the range of the laws"
                : "the solution did not converge",
            {}};
  }
  const contact::JointContact& contact = loaded.joint.contact();
  const contact::ContactLimits limits(contact.half_angle_law(), contact.pair());
  std::vector<std::string> warnings;
  if (effort.remarks) {
    warnings = contact.validity_notes();
    std::ranges::move(limits.notes({s.half_angle, s.peak_pressure}),
                      std::back_inserter(warnings));
  }
  Result result{{},
                {{over_limit, s.peak_pressure / limits.peak_pressure()}},
                {},
                std::move(warnings)};
  for (const auto& column : columns_) {
    result.numbers.emplace(column.name, column(s));
  }
  return result;
}

std::string JointModel::identity() const {
  return contact::read_joint(joint_).canonical_text() +
         files_.open(study_, study_keys).table("load").canonical_text();
}

}  // namespace study
