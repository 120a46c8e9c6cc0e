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
  explicit contact_joint(contact::JointSpec of)
      : spec(std::move(of)),
        joint(spec.without_seat().contact()),
        notes(joint.contact().validity_notes()) {}

  const contact::JointSpec spec;
  const contact::Joint joint;
  const std::vector<std::string> notes;
};
