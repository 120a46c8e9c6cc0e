#pragma once

/// Pressure over the contact.
// clang-format off
#include "libcontact/pressure/law.hpp"
#include "libcontact/pressure/cosine.hpp"
#include "libcontact/pressure/shaped.hpp"
#include "libcontact/pressure/sqrt.hpp"
#include "libcontact/pressure/mixture.hpp"
#include "libcontact/pressure/exact.hpp"
#include "libcontact/pressure/worn.hpp"
#include "libcontact/pressure/running_in.hpp"
#include "libcontact/pressure/profile.hpp"
#include "libcontact/pressure/factory.hpp"
#include "libcontact/pressure/hertz.hpp"
#include "libcontact/pressure/validity.hpp"
// clang-format on
