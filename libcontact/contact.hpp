#pragma once

/// libcontact in physics order: each stage includes only earlier ones.
// clang-format off
#include "libcontact/version.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/base/root_finding.hpp"
#include "libcontact/base/instruction_set.hpp"
#include "libcontact/pair.hpp"
#include "libcontact/conforming.hpp"
#include "libcontact/half_angle/paper_laws.hpp"
#include "libcontact/pressure/cosine.hpp"
#include "libcontact/friction.hpp"
#include "libcontact/joint.hpp"
#include "libcontact/files.hpp"
// clang-format on
