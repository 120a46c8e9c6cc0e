// Threads that the system does not start: those that run do the work.
#include "cli/stream/threads.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <cerrno>
#include <limits>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "cli/stream/ordered_blocks.hpp"
#include "support/error_message.hpp"

namespace contact::test::threads_test {
namespace {

// Threads that may still be started.
int left = std::numeric_limits<int>::max();

}  // namespace

// In the place of the C library's.
extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* how,
                              void* (*work)(void*), void* argument) noexcept {
  if (left-- <= 0) return EAGAIN;
  static const auto real = reinterpret_cast<decltype(&pthread_create)>(
      dlsym(RTLD_NEXT, "pthread_create"));
  return real(thread, how, work, argument);
}

namespace {

class FewThreads : public testing::Test {
 protected:
  void TearDown() override { left = std::numeric_limits<int>::max(); }
};

TEST_F(FewThreads, WorkInThoseThatRun) {
  std::mutex mutex;
  std::set<std::thread::id> seen;
  const auto work = [&] {
    const std::lock_guard lock(mutex);
    seen.insert(std::this_thread::get_id());
  };
  left = 2;
  testing::internal::CaptureStderr();
  cli::in_threads(5, work);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_EQ(seen.size(), 3u);
  EXPECT_TRUE(has_text(said, ": note: 3 of 5 threads could be started: "));
  left = 0;
  seen.clear();
  testing::internal::CaptureStderr();
  cli::in_threads(5, work);
  EXPECT_TRUE(has_text(testing::internal::GetCapturedStderr(), "note: 1 of 5"));
  EXPECT_EQ(seen, std::set{std::this_thread::get_id()});
}

TEST_F(FewThreads, AllBlocksComeInTheirOrder) {
  left = 1;
  int next = 0;
  std::vector<int> written;
  testing::internal::CaptureStderr();
  cli::ordered_blocks<int>(
      4,
      [&](int& block) {
        block = next++;
        return block < 1000;
      },
      [](int& block) { block *= 2; },
      [&](int block) { written.push_back(block); });
  testing::internal::GetCapturedStderr();
  ASSERT_EQ(written.size(), 1000u);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(written[i], 2 * i);
}

}  // namespace
}  // namespace contact::test::threads_test
