#pragma once

/// Friction parameters from measured moments.
#include "libcontact/identify/identify.hpp"
