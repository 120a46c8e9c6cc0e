#include "cli/stream/threads.hpp"

#include <fmt/format.h>

#include <system_error>
#include <thread>
#include <vector>

#include "cli/program.hpp"

namespace cli {

void in_threads(int jobs, const std::function<void()>& work) {
  std::vector<std::jthread> threads;
  threads.reserve(static_cast<std::size_t>(jobs));
  try {
    for (int i = 1; i < jobs; ++i) threads.emplace_back(work);
  } catch (const std::system_error& error) {
    note(program_invocation_short_name,
         fmt::format("{} of {} threads could be started: {}",
                     threads.size() + 1, jobs, error.code().message()));
  }
  work();
}

}  // namespace cli
