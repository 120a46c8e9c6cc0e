#include "study/workers.hpp"

#include <atomic>
#include <exception>
#include <mutex>

#include "cli/stream/threads.hpp"

namespace study {

void compute(const Study& study, const std::vector<std::uint64_t>& runs,
             int jobs, Journal& journal,
             const std::function<std::string()>& stop,
             const std::function<void()>& done) {
  std::atomic<std::size_t> next = 0;
  std::mutex writing;
  std::exception_ptr failure;  // guarded by writing
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < runs.size(); i = next++) {
        const Row row = study.row(runs[i], stop);
        if (!stop().empty()) return;
        const std::lock_guard lock(writing);
        journal.append(row);
        done();
      }
    } catch (...) {
      next = runs.size();
      const std::lock_guard lock(writing);
      if (!failure) failure = std::current_exception();
    }
  };
  cli::in_threads(jobs, work);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace study
