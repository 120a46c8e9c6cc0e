#include "separation/results/run.hpp"

#include <pybind11/stl.h>

#include <chrono>
#include <exception>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "python/file_case.hpp"
#include "python/file_joint.hpp"
#include "python/rows/rows.hpp"
#include "separation/results/notes.hpp"
#include "separation/results/saved_state.hpp"
#include "separation/results/summary.hpp"

namespace contact_python {
namespace {

/// Calls from a run to Python: check for Ctrl-C, report progress.
class Listener {
 public:
  Listener(py::object progress, const separation::Run& run)
      : progress_(std::move(progress)),
        time_(run.time()),
        end_(run.of().end_time) {}

  void come_to(double time) { time_ = time; }
  // As a separation::StopRule.
  std::string reason_to_stop() {
    const auto now = Clock::now();
    if (now < next_) return "";
    next_ = now + std::chrono::milliseconds(100);
    const Locked locked;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!progress_.is_none()) tell(progress_, py::make_tuple(time_, end_));
    } catch (...) {
      error_ = std::current_exception();
      return "an exception";
    }
    return "";
  }
  void raise() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  py::object progress_;
  double time_;
  double end_;
  Clock::time_point next_ = Clock::now();
  std::exception_ptr error_;
};

py::array_t<double> table_of(const separation::Rows& rows) {
  const Shape shape = {py::ssize_t(rows.size()),
                       py::ssize_t(rows.columns.size())};
  return py::array_t<double>(shape, rows.numbers.data());
}

py::list events_of(const separation::Recorder::Memory& memory) {
  py::list events;
  for (const separation::Note& note : memory.notes) {
    events.append(py::make_tuple(note.time, note.body, note.what));
  }
  return events;
}

// Columns and rows of the history, events, summary as JSON, failure.
py::tuple answer(const separation::Run& run,
                 const separation::Outcome& outcome) {
  const auto& memory = outcome.memory;
  return py::make_tuple(
      memory.rows.columns, table_of(memory.rows), events_of(memory),
      separation::summary(run.of(), outcome).dump(), outcome.failure);
}

const char* word(separation::Run::Status status) {
  constexpr const char* words[] = {"running", "finished", "failed", "stopped"};
  return words[static_cast<int>(status)];
}

/// A run that Python advances. Long work runs without Python's lock; queries
/// meanwhile are rejected.
class CaseRun {
 public:
  CaseRun(const FileCase& file, bool clearance)
      : identity_(identity_of(file.of, {.clearance = clearance})),
        run_(file.of, heard({.clearance = clearance})) {}
  explicit CaseRun(CaseRun& other)
      : identity_(other.identity_),
        run_(other.run_, heard(other.run_.options())) {}
  CaseRun& operator=(const CaseRun&) = delete;

  const separation::Run& run() const {
    if (!is_busy_) return run_;
    throw contact::Error(contact::detail::must_be(
        "a run that moves on", "left alone until advance_to() returns"));
  }

  const char* advance_to(double time, py::object progress) {
    Listener listener(std::move(progress), run());
    listener_ = &listener;
    alone([&] { run_.advance_to(time); });
    listener.raise();
    return word(run_.status());
  }
  py::bytes save() {
    std::string bytes;
    alone([&] { bytes = separation::saved_bytes(run_.save(), identity_); });
    return bytes;
  }
  void restore(const py::bytes& saved) {
    const std::string bytes = saved;
    alone([&] { run_.restore(separation::saved_state(bytes, identity_)); });
  }

  void set_inputs(std::vector<double> values) {
    run();
    run_.set_inputs(std::move(values));
  }

  static std::unique_ptr<CaseRun> copy_of(CaseRun& other) {
    std::unique_ptr<CaseRun> made;
    other.alone([&] { made = std::make_unique<CaseRun>(other); });
    return made;
  }

  const std::vector<double>& values() {
    if (values_.empty()) values_ = run().values();
    return values_;
  }
  // Runs to the end with a last row there, and no further queries. Includes the
  // notes on its contacts.
  py::tuple whole(py::object progress) && {
    advance_to(run_.of().end_time, std::move(progress));
    const auto notes = separation::contact_notes(run_.of(), run_.memory());
    separation::Outcome outcome;
    alone([&] { outcome = std::move(run_).end(); });
    return py::make_tuple(answer(run_, outcome), notes);
  }

 private:
  // Options with which the run calls its listener.
  separation::RunOptions heard(separation::RunOptions options) {
    options.progress = [this](const separation::Run& r) {
      if (listener_) listener_->come_to(r.time());
    };
    options.stop = [this](long) {
      return listener_ ? listener_->reason_to_stop() : "";
    };
    return options;
  }

  template <class Work>
  void alone(const Work& work) {
    run();
    values_.clear();
    is_busy_ = true;
    const std::unique_ptr<CaseRun, void (*)(CaseRun*)> at_the_end(
        this, [](CaseRun* r) {
          r->is_busy_ = false;
          r->listener_ = nullptr;
        });
    const Unlocked unlocked;
    work();
  }

  const std::string identity_;
  Listener* listener_ = nullptr;  // while it advances
  bool is_busy_ = false;          // under Python's lock
  std::vector<double> values_;  // values of the state, computed on first query
  separation::Run run_;
};

std::unique_ptr<CaseRun> make_run(const FileCase& file, bool clearance) {
  const Unlocked unlocked;
  return std::make_unique<CaseRun>(file, clearance);
}

std::vector<std::string> mode_words() {
  std::vector<std::string> words;
  for (const auto mode : multibody::hinge_modes) {
    words.emplace_back(to_string(mode));
  }
  return words;
}

}  // namespace

namespace {

// Properties that describe the state of the run.
void bind_place(py::class_<CaseRun>& type) {
  const auto look = [&](const char* name, auto of, const char* doc) {
    type.def_property_readonly(
        name, [of](const CaseRun& r) { return of(r.run()); }, doc);
  };
  using separation::Run;
  look(
      "time", [](const Run& r) { return r.time(); }, "Where it is, s.");
  look(
      "end_time", [](const Run& r) { return r.of().end_time; },
      "Of the case, s.");
  look(
      "status", [](const Run& r) { return word(r.status()); },
      "What advance_to() returned; \"stopped\" after an exception.");
  look(
      "message", [](const Run& r) { return r.message(); },
      "Why it has failed or was stopped, and where; \"\" otherwise.");
  look(
      "columns", [](const Run& r) { return r.columns(); },
      "Names of the values, in their order.");
}

}  // namespace

void bind_run(py::module_& m) {
  py::class_<CaseRun> type(m, "Run", "A case on its way.");
  type.def(py::init(&make_run), py::arg("case"), py::arg("clearance"));
  type.def(py::init(&CaseRun::copy_of), py::arg("other"));
  type.def("_advance_to", &CaseRun::advance_to, py::arg("time"),
           py::arg("progress"));
  type.def(
      "_index",
      [](const CaseRun& r, const std::string& column) {
        return r.run().memory().rows.column(column);
      },
      py::arg("column"));
  type.def("_outcome",
           [](const CaseRun& r) { return answer(r.run(), r.run().outcome()); });
  type.def_property_readonly(
      "_events", [](const CaseRun& r) { return events_of(r.run().memory()); });
  type.def_property_readonly("_contact_notes", [](const CaseRun& r) {
    return separation::contact_notes(r.run().of(), r.run().memory());
  });
  type.def(
      "_input",
      [](const CaseRun& r, const std::string& name) {
        return r.run().input(name);
      },
      py::arg("name"));
  type.def_property_readonly("_inputs", [](const CaseRun& r) {
    std::vector<std::string> names;
    for (const auto& input : r.run().inputs()) names.push_back(input.name);
    return py::make_tuple(names, r.run().input_values());
  });
  type.def("_set_inputs", &CaseRun::set_inputs, py::arg("values"));
  bind_place(type);
  type.def(
      "values",
      [](CaseRun& r) { return py::array_t<double>(py::cast(r.values())); },
      R"(values(self)
--

The present values of all columns, (n,). A mode is its number: 0 sliding,
1 resting, 2 locked, 3 released.)");
  type.def("save", &CaseRun::save, R"(save(self)
--

The state from which a run of the same case can continue, as bytes, with its
history. Saving restarts the steps: this run and restored ones then continue
bit-identically, and differ from a run that was never saved within the
tolerances.)");
  type.def("restore", &CaseRun::restore, py::arg("saved"),
           R"(restore(self, saved)
--

Moves to the state of a saved run of the same case and clearance, forwards or
back, also after a failure. A rejected state changes nothing.)");
  m.def(
      "_run",
      [](const FileCase& file, bool clearance, py::object progress) {
        return std::move(*make_run(file, clearance)).whole(std::move(progress));
      },
      py::arg("case"), py::arg("clearance"), py::arg("progress"));
  m.attr("_modes") = mode_words();
}

}  // namespace contact_python
