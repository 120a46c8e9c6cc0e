#pragma once

#include <functional>

namespace cli {

/// Runs `work`, which must not throw, in `jobs` threads at once, including the
/// caller's, and returns when all are done. If the system starts fewer threads,
/// these do all the work, and a note gives their number.
void in_threads(int jobs, const std::function<void()>& work);

}  // namespace cli
