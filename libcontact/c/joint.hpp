#pragma once

#include <string>
#include <utility>
#include <vector>

#include "libcontact/c/joint.h"
#include "libcontact/joint/joint.hpp"

/// What C holds of a joint.
struct contact_joint {  // NOLINT(readability-identifier-naming)
  explicit contact_joint(contact::JointContact contact)
      : joint(std::move(contact)), notes(joint.contact().validity_notes()) {}

  const contact::Joint joint;
  const std::vector<std::string> notes;
};
