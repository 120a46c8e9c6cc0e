#include "python/interpreter_lock.hpp"

#include <chrono>
#include <thread>

namespace contact_python {
namespace {

// State of this thread while it does not hold the lock.
thread_local PyThreadState* without_lock = nullptr;

void take_lock(PyThreadState* thread) {
  outlive_python([=] { PyEval_RestoreThread(thread); });
}

}  // namespace

void wait_for_the_end() {
  for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
}

void tell(pybind11::handle function, const pybind11::tuple& arguments) {
  PyObject* const answer = outlive_python(
      [&] { return PyObject_CallObject(function.ptr(), arguments.ptr()); });
  if (answer == nullptr) throw pybind11::error_already_set();
  Py_DECREF(answer);
}

Unlocked::Unlocked() { without_lock = PyEval_SaveThread(); }
Unlocked::~Unlocked() { take_lock(without_lock); }

// Not PyGILState_Ensure(), which is unusable after the interpreter has ended.
Locked::Locked() { take_lock(without_lock); }
Locked::~Locked() { without_lock = PyEval_SaveThread(); }

}  // namespace contact_python
