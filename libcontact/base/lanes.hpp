#pragma once

#include "libcontact/base/simd.hpp"

/// The widest vector of the instruction set that the file is compiled for, or
/// CONTACT_LANES numbers if the file says so.
namespace contact::detail {
namespace {

#ifdef CONTACT_LANES
using Lanes = LanesOf<CONTACT_LANES>;
#else
using Lanes = LanesOf<native_lanes>;
#endif
constexpr int width = Lanes::size();

}  // namespace
}  // namespace contact::detail
