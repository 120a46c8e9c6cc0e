#pragma once

#include <cstdlib>

namespace contact::test {

/// Tests of many rows that are alike, seconds each, take every n-th of them;
/// with CONTACT_LONG in the environment (scripts/check.sh long) all.
inline int every(int n) { return std::getenv("CONTACT_LONG") ? 1 : n; }

}  // namespace contact::test
