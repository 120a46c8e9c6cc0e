#pragma once

#include <cstddef>

namespace contact::test {

/// Calls of operator new in this program so far, all threads. A test that
/// reads it replaces the global operator new by one that counts.
std::size_t allocation_count();

}  // namespace contact::test
