#pragma once

#include <pybind11/pybind11.h>

/// Python's lock, for threads that may outlive the interpreter.
///
/// Python ends a daemon thread that asks for the lock of an interpreter that
/// is ending, by pthread_exit(). Its unwinding ends the process where it meets
/// a destructor or a catch (...), and pybind11 has both. Such a thread waits
/// here for the end of the process instead, as Python 3.14 has it wait.
namespace contact_python {

[[noreturn]] void wait_for_the_end();

/// Calls what asks for the lock: a function of Python's, which throws nothing,
/// so that pthread_exit() alone is caught. Objects with destructors have to be
/// outside.
template <class Call>
auto outlive_python(const Call& call) noexcept {
  try {
    return call();
  } catch (...) {
    wait_for_the_end();
  }
}

/// Lets go of Python's lock while in scope, as pybind11::gil_scoped_release. A
/// constructor has it inside its factory, not as call_guard: pybind11 must not
/// see the new object before the lock is back, since Python may end then and
/// would free an unregistered object.
class Unlocked {
 public:
  Unlocked();
  ~Unlocked();
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;
};

/// Holds it while in scope, within an Unlocked of the same thread.
class Locked {
 public:
  Locked();
  ~Locked();
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;
};

}  // namespace contact_python
