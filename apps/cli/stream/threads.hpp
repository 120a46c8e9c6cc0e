#pragma once

#include <functional>

namespace cli {

/// Calls `work`, which throws nothing, in so many threads at once, including
/// the caller's, and returns when all are done. Where the system starts fewer
/// of them these do the work, and a note says how many they are.
void in_threads(int jobs, const std::function<void()>& work);

}  // namespace cli
