#pragma once

#include "libcontact/base/simd.hpp"

/// The widest vector of the instruction set that the file is compiled for, or
/// CONTACT_LANES numbers if the file says so: a different type in each, so
/// without linkage.
namespace contact::detail {
namespace {

namespace stdx = std::experimental;
#ifdef CONTACT_LANES
using Lanes =
    stdx::simd<double, stdx::simd_abi::deduce_t<double, CONTACT_LANES>>;
#else
using Lanes = stdx::native_simd<double>;
#endif
constexpr int width = static_cast<int>(Lanes::size());

}  // namespace
}  // namespace contact::detail
