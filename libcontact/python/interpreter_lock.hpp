#pragma once

#include <pybind11/pybind11.h>

/// Python's lock, for threads that may outlive the interpreter.
///
/// Python ends a daemon thread that asks for the lock of an interpreter that
/// is ending, by pthread_exit(). Its unwinding ends the process where it meets
/// a destructor or a catch (...), and pybind11 has both. Such a thread waits
/// here for the end of the process instead, as Python 3.14 has it wait.
namespace contact_python {

/// Lets go of Python's lock while in scope, as pybind11::gil_scoped_release.
class Unlocked {
 public:
  Unlocked() : thread_(PyEval_SaveThread()) {}
  ~Unlocked();
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

 private:
  PyThreadState* thread_;
};

/// Has it while in scope, within that of an Unlocked.
class Locked {
 public:
  Locked();
  ~Locked() { PyGILState_Release(before_); }
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;

 private:
  PyGILState_STATE before_;
};

}  // namespace contact_python
