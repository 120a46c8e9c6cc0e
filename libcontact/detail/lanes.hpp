#pragma once

#include <experimental/simd>

/// The widest vector of the instruction set that the file is compiled for: a
/// different type in each, so without linkage.
namespace contact::detail {
namespace {

namespace stdx = std::experimental;
using Lanes = stdx::native_simd<double>;
constexpr int width = static_cast<int>(Lanes::size());

}  // namespace
}  // namespace contact::detail
