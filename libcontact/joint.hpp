// SPDX-License-Identifier: MIT
#pragma once

/// Joints under a reaction: normal force, friction force and moments, and
/// joints at rest.
// clang-format off
#include "libcontact/joint/contact.hpp"
#include "libcontact/joint/spec.hpp"
#include "libcontact/joint/solution.hpp"
#include "libcontact/joint/moment_set.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/joint/presliding/stiction.hpp"
#include "libcontact/joint/presliding/stuck_joint.hpp"
#include "libcontact/joint/contact_notes.hpp"
#include "libcontact/joint/thrust_face.hpp"
#include "libcontact/joint/group.hpp"
#include "libcontact/joint/step.hpp"
#include "libcontact/joint/steps/mechanism_step.hpp"
#include "libcontact/joint/derivatives.hpp"
// clang-format on
