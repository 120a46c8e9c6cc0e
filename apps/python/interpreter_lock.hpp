#pragma once

#include <pybind11/pybind11.h>

/// Python's lock, for threads that may outlive the interpreter.
///
/// When a daemon thread asks for the lock of an interpreter that is ending,
/// Python ends the thread by pthread_exit(). Its unwinding aborts the process
/// at a destructor or a catch (...), and pybind11 has both. Therefore such a
/// thread waits here for the end of the process, as it does in Python 3.14.
namespace contact_python {

[[noreturn]] void wait_for_the_end();

/// Calls a function of Python that asks for the lock. The function throws
/// nothing, so that only pthread_exit() is caught. Keep objects with
/// destructors outside.
template <class Call>
auto outlive_python(const Call& call) noexcept {
  try {
    return call();
  } catch (...) {
    wait_for_the_end();
  }
}

/// Calls a Python function that may release the lock, for example by printing.
void tell(pybind11::handle function, const pybind11::tuple& arguments);

/// Releases Python's lock while in scope, as pybind11::gil_scoped_release does.
/// A constructor must use it inside its factory, not as call_guard: pybind11
/// must not see the new object before the lock is held again, because Python
/// may end meanwhile and would free an unregistered object.
class Unlocked {
 public:
  Unlocked();
  ~Unlocked();
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;
};

/// Holds Python's lock while in scope, within an Unlocked of the same thread.
class Locked {
 public:
  Locked();
  ~Locked();
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;
};

}  // namespace contact_python
