#pragma once

/// libcontact, all of it, in physics order: each stage includes only earlier
/// ones.
// clang-format off
#include "libcontact/error.hpp"
#include "libcontact/units.hpp"
#include "libcontact/toml_reader.hpp"
#include "libcontact/material.hpp"
#include "libcontact/joint_geometry.hpp"
#include "libcontact/friction_law.hpp"
#include "libcontact/conforming/loading.hpp"
#include "libcontact/conforming/contact_pressure.hpp"
#include "libcontact/conforming/pin_closed_form.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/half_angle.hpp"
#include "libcontact/pressure.hpp"
#include "libcontact/joint_file.hpp"
#include "libcontact/instruction_set.hpp"
#include "libcontact/elliptic.hpp"
#include "libcontact/friction_integrals.hpp"
#include "libcontact/friction_exact.hpp"
#include "libcontact/friction_elliptic.hpp"
#include "libcontact/friction_special.hpp"
#include "libcontact/friction_batch.hpp"
#include "libcontact/friction_models.hpp"
#include "libcontact/joint_contact.hpp"
#include "libcontact/joint_solution.hpp"
#include "libcontact/moment_set.hpp"
#include "libcontact/spherical_joint.hpp"
#include "libcontact/cylindrical_joint.hpp"
#include "libcontact/joint_node.hpp"
// clang-format on
