#pragma once

#include <cstdlib>

namespace contact::test {

/// Tests of many similar rows take every n-th row, or one of a kind; with
/// CONTACT_LONG in the environment (scripts/check.sh long) they take all.
inline bool is_long_run() { return std::getenv("CONTACT_LONG") != nullptr; }
inline int every(int n) { return is_long_run() ? 1 : n; }

}  // namespace contact::test
