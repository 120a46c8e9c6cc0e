#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>

#include "cli/stream/threads.hpp"

namespace cli {

/// Works on blocks in `jobs` threads and passes them on in their order.
///
/// Every thread has one Block of its own, so memory does not grow with the
/// number of blocks.
/// @param next   bool(Block&): fills the block, false at the end; called by one
///               thread at a time, in order
/// @param work   void(Block&): called by all threads at once
/// @param write  void(const Block&): called by one thread at a time, in the
///               order of `next`
/// An exception in any of them ends the work and is rethrown here.
template <class Block, class Next, class Work, class Write>
void ordered_blocks(int jobs, const Next& next, const Work& work,
                    const Write& write) {
  std::mutex read_mutex;
  std::mutex write_mutex;
  std::condition_variable turn;
  std::size_t blocks_read = 0;     // guarded by read_mutex
  std::size_t blocks_written = 0;  // this and the rest by write_mutex
  std::exception_ptr failure;

  const auto process = [&] {
    Block block;
    for (;;) {
      std::size_t index = 0;
      {
        const std::lock_guard lock(read_mutex);
        if (!next(block)) return;
        index = blocks_read++;
      }
      work(block);
      std::unique_lock lock(write_mutex);
      turn.wait(lock, [&] { return failure || blocks_written == index; });
      if (failure) return;
      write(block);
      ++blocks_written;
      turn.notify_all();
    }
  };
  const auto run = [&] {
    try {
      process();
    } catch (...) {
      const std::lock_guard lock(write_mutex);
      if (!failure) failure = std::current_exception();
      turn.notify_all();
    }
  };
  in_threads(jobs, run);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace cli
