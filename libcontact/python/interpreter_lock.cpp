#include "libcontact/python/interpreter_lock.hpp"

#include <chrono>
#include <thread>

namespace contact_python {
namespace {

// Python's functions throw nothing: what is caught is pthread_exit(), which
// may come before they wait for the lock and after.
template <class Take>
auto taken(const Take& take) noexcept {
  try {
    return take();
  } catch (...) {
    for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
  }
}

}  // namespace

Unlocked::~Unlocked() {
  taken([this] { PyEval_RestoreThread(thread_); });
}

Locked::Locked() : before_(taken([] { return PyGILState_Ensure(); })) {}

}  // namespace contact_python
