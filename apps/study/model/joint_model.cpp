#include "study/model/joint_model.hpp"

#include <algorithm>
#include <iterator>
#include <numbers>

#include "libcontact/files/joint_tables.hpp"
#include "libcontact/files/toml_form.hpp"
#include "libcontact/joint/contact_notes.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/validity.hpp"
#include "study/model/joint_ends.hpp"

namespace study {

using contact::Interval;
using contact::KeySettings;
using contact::TomlTable;

struct JointModel::Loaded {
  contact::JointSpec spec;
  EndedLoad ended;
  contact::Joint joint;
  Turning turning;
};

namespace {

bool is_of_load(const std::string& key) { return key.starts_with("load."); }

}  // namespace

/// The nominal joint in its seat, whose matrices take up to a second: where
/// only the load scatters it serves all runs.
struct JointModel::Seat {
  contact::JointSpec spec;
  contact::SeatJoint joint{spec};
};

/// The files with the drawn keys.
struct JointModel::Form {
  contact::TomlForm joint, study;
};

JointModel::JointModel(const Plan& plan)
    : plan_(plan), columns_(columns_of(contact::solution_quantities())) {
  const contact::JointSpec nominal = contact::read_joint(plan.joint_file);
  nominal.contact(laws_);
  if (nominal.geometry.radial_clearance() <= 0) {
    preload_columns_ = columns_of(contact::preload_quantities());
  }
  const Loaded first = read(KeySettings{});
  // One that scatters about a clearance of 0 may be unloaded in some runs.
  if (first.turning.reaction == 0 &&
      !first.joint.contact().has_interference()) {
    plan.file.table("load").must_be(
        "reaction",
        "above 0, as a joint without interference has no friction "
        "without load");
  }
  if (first.ended.in_seat) seat_.reset(new Seat{first.spec});
}

JointModel::~JointModel() = default;

std::vector<std::string> JointModel::copies(
    const Dispersion& dispersion) const {
  if (dispersion.each) {
    dispersion.table.needs("each", "a case with bodies that have a pattern");
  }
  return {};
}

JointModel::Loaded JointModel::loaded(const TomlTable& joint,
                                      const TomlTable& study) const {
  contact::SharedLaws laws = laws_;
  const contact::JointSpec spec = contact::joint_of_file(joint);
  const TomlTable load = study.table("load");
  return {
      spec,
      read_ended_load(load, spec.geometry),
      contact::Joint(spec.without_seat().contact(laws)),
      {.reaction = load.number("reaction", Interval::non_negative()),
       .beta = load.optional_number("beta", {0, std::numbers::pi})
                   .value_or(std::numbers::pi / 2),
       .rate = load.optional_number("rate", Interval::positive()).value_or(1)}};
}

JointModel::Loaded JointModel::read(const KeySettings& settings) const {
  KeySettings of_joint;
  KeySettings of_study;
  for (const contact::KeySetting& setting : settings) {
    (is_of_load(setting.key) ? of_study : of_joint).push_back(setting);
  }
  return loaded(files_.open(plan_.joint_file, contact::joint_keys, of_joint),
                files_.open(plan_.path, study_keys, of_study));
}

// Numbers that make no joint are read as settings: messages name them.
JointModel::Loaded JointModel::read(const std::vector<double>& draws) const {
  KeySettings of_joint;
  KeySettings of_study;
  for (const Dispersion& d : plan_.dispersions) {
    (is_of_load(d.key) ? of_study : of_joint).push_back(d.setting(1));
  }
  const auto form = [&] {
    return Form{{files_, plan_.joint_file, contact::joint_keys, of_joint},
                {files_, plan_.path, study_keys, of_study}};
  };
  try {
    return forms_.with_one(form, [&](Form& one) {
      std::size_t joint = 0;
      std::size_t study = 0;
      for (std::size_t i = 0; i < draws.size(); ++i) {
        if (is_of_load(plan_.dispersions[i].key)) {
          one.study.set(study++, draws[i]);
        } else {
          one.joint.set(joint++, draws[i]);
        }
      }
      return loaded(one.joint.table(), one.study.table());
    });
  } catch (const contact::Error&) {
    KeySettings settings;
    for (std::size_t i = 0; i < draws.size(); ++i) {
      settings.push_back(plan_.dispersions[i].setting(draws[i]));
    }
    return read(settings);
  }
}

void JointModel::check(const KeySettings& settings) const { read(settings); }

Result JointModel::run(const KeySettings& settings, const Effort& effort,
                       const std::function<std::string()>& /*stop*/) const {
  return run(read(settings), effort);
}

Result JointModel::run(const std::vector<double>& draws, const Effort& effort,
                       const std::function<std::string()>& /*stop*/) const {
  return run(read(draws), effort);
}

Result JointModel::run(const Loaded& loaded, const Effort& effort) const {
  const Turning& turning = loaded.turning;
  if (loaded.ended.in_seat) {
    return seat_ && loaded.spec == seat_->spec
               ? run_in_seat(loaded.spec, seat_->joint, loaded.ended, turning,
                             effort)
               : run_in_seat(loaded.spec, contact::SeatJoint(loaded.spec),
                             loaded.ended, turning, effort);
  }
  if (loaded.ended.is_pin()) {
    return run_pin_that_ends(loaded.spec, loaded.ended, turning, effort);
  }
  const contact::JointSolution s =
      loaded.joint.solve({turning.force(), turning.angular_velocity()});
  if (s.status != contact::Status::ok) return {failure_of(s.status), {}};
  const contact::JointContact& contact = loaded.joint.contact();
  const contact::ContactLimits limits = contact.limits();
  std::vector<std::string> warnings;
  if (effort.remarks) {
    warnings = contact.validity_notes();
    // beta counts from z.
    const auto& seat = contact.geometry().drawn_seat();
    const double overlap =
        seat && is_about_z(*seat) ? contact::rim_overlap(contact, s) : 0;
    std::ranges::move(limits.notes({s.half_angle, s.peak_pressure, overlap}),
                      std::back_inserter(warnings));
  }
  Result result{{},
                {{over_limit, s.peak_pressure / limits.peak_pressure()}},
                {},
                std::move(warnings)};
  for (const auto& column : columns_) {
    result.numbers.emplace(column.name, column(s));
  }
  const contact::ContactPatch patch{contact, s.normal_force, s.half_angle};
  for (const auto& column : preload_columns_) {
    result.numbers.emplace(column.name, column(patch));
  }
  return result;
}

std::string JointModel::identity() const {
  return contact::read_joint(plan_.joint_file).canonical_text() +
         files_.open(plan_.path, study_keys).table("load").canonical_text();
}

}  // namespace study
