// Compares the layout of C structs in the package's scripts with the
// compiler's; adds nothing to the module.
#include <cstddef>

#include "libcontact/base/simd.hpp"
#include "libcontact/c/contact.h"
#include "libcontact/joint/contact.hpp"
#include "libcontact/joint/solution.hpp"

// WebAssembly's vectors have two doubles.
static_assert(contact::detail::native_lanes == 2);

// memory.js
static_assert(sizeof(contact_solution) <= 512 && sizeof(contact_rest) <= 512 &&
              sizeof(contact_step) <= 1024);
static_assert(CONTACT_BAD_INPUT == 3 && CONTACT_FAILURE == 5 &&
              CONTACT_OUT_OF_SEAT == 6);
static_assert(offsetof(contact_step, holds) == 4 &&
              offsetof(contact_step, angular_velocity) == 8 &&
              offsetof(contact_step, moment) == 32);

// quantities.js
static_assert(offsetof(contact_quantity, meaning) == 12 &&
              offsetof(contact_quantity, size) == 16);
static_assert(static_cast<int>(contact::JointState::unloaded) == 2 &&
              static_cast<int>(contact::ContactState::clearance) == 3);

// joint.js
static_assert(sizeof(contact_setting) == 8);
static_assert(sizeof(contact_joint_size) == 48 &&
              offsetof(contact_joint_size, radius) == 8 &&
              offsetof(contact_joint_size, effective_modulus) == 32 &&
              offsetof(contact_joint_size, has_seat) == 40);
static_assert(sizeof(contact_slip) == 72 && sizeof(contact_hold) == 72 &&
              sizeof(contact_step_start) == 96 &&
              offsetof(contact_step_start, axis) == 72);
static_assert(sizeof(contact_placement) == 128 &&
              offsetof(contact_placement, from_seat) == 8 &&
              offsetof(contact_placement, tilt) == 80 &&
              offsetof(contact_placement, is_placed) == 104 &&
              offsetof(contact_placement, place) == 112 &&
              offsetof(contact_placement, axial_velocity) == 120);

// mechanism.js
static_assert(sizeof(contact_mechanism_joint) == 8 &&
              offsetof(contact_mechanism_joint, first) == 4);
static_assert(sizeof(contact_mechanism_start) == 120 &&
              offsetof(contact_mechanism_start, axis) == 24 &&
              offsetof(contact_mechanism_start, from_seat) == 48);
