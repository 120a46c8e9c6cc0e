#pragma once

#include <string>
#include <utility>
#include <vector>

#include "libcontact/c/call.hpp"
#include "libcontact/c/joint.h"
#include "libcontact/joint/joint.hpp"
#include "libcontact/joint/spec.hpp"

/// Joint that C holds.
struct contact_joint  // NOLINT(readability-identifier-naming)
    : contact::c::Handle {
  explicit contact_joint(const contact::JointSpec& of)
      : contact_joint(of, contact::Joint(of)) {}
  contact_joint(contact::JointSpec of, contact::Joint made)
      : spec(std::move(of)),
        joint(std::move(made)),
        notes(joint.contact().validity_notes()),
        table(joint.table()) {}

  const contact::JointSpec spec;
  const contact::Joint joint;
  const std::vector<std::string> notes;
  const std::string table;
};
