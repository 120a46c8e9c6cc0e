#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <chrono>
#include <exception>
#include <utility>

#include "libcontact/python/file_joint.hpp"
#include "libcontact/python/rows.hpp"
#include "separation/case/case_keys.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/output/summary.hpp"
#include "separation/record/run.hpp"

namespace contact_python {
namespace {

using contact::TomlTable;
using separation::Case;

/// A case from the text of a case file.
struct FileCase {
  Case of;
  std::string toml;
};

std::unique_ptr<FileCase> make_case(const std::string& text,
                                    const std::string& source,
                                    const std::filesystem::path& folder,
                                    const Settings& settings) {
  const auto all = key_settings(settings);
  const py::gil_scoped_release unlocked;
  return std::make_unique<FileCase>(FileCase{
      separation::parse_case(text, source, {}, all, folder),
      TomlTable::from_text(text, source, separation::case_keys(), folder, all)
          .toml_text()});
}

/// What a run asks Python on its way: whether somebody pressed Ctrl-C, and
/// who wants to know how far it is.
class Listener {
 public:
  Listener(py::object progress, double end)
      : progress_(std::move(progress)), end_(end) {}

  void come_to(double time) { time_ = time; }
  // As a separation::StopRule.
  std::string reason_to_stop() {
    const auto now = Clock::now();
    if (now < next_) return "";
    next_ = now + std::chrono::milliseconds(100);
    const py::gil_scoped_acquire locked;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!progress_.is_none()) progress_(time_, end_);
    } catch (...) {
      error_ = std::current_exception();
      return "stopped";
    }
    return "";
  }
  void raise() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  py::object progress_;
  double end_;
  double time_ = 0;
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
py::tuple run(const FileCase& file, bool clearance,
              const py::object& progress) {
  Listener listener(progress, file.of.end_time);
  separation::RunOptions options;
  options.clearance = clearance;
  options.progress = [&](const separation::Run& r) {
    listener.come_to(r.time());
  };
  options.stop = [&](long) { return listener.reason_to_stop(); };
  separation::Outcome outcome;
  {
    const py::gil_scoped_release unlocked;
    outcome = separation::run_case(file.of, options);
  }
  listener.raise();
  const auto& memory = outcome.memory;
  return py::make_tuple(
      memory.rows.columns, table_of(memory.rows), events_of(memory),
      separation::summary(file.of, outcome).dump(), outcome.failure);
}

std::vector<std::string> mode_words() {
  std::vector<std::string> words;
  for (const auto mode :
       {multibody::HingeMode::sliding, multibody::HingeMode::resting,
        multibody::HingeMode::locked, multibody::HingeMode::released}) {
    words.emplace_back(to_string(mode));
  }
  return words;
}

}  // namespace

void bind_case(py::module_& m) {
  py::class_<FileCase>(m, "Case")
      .def(py::init(&make_case), py::arg("text"), py::arg("source"),
           py::arg("folder"), py::arg("settings"))
      .def_readonly("_toml", &FileCase::toml)
      .def_property_readonly("_canonical",
                             [](const FileCase& c) { return c.of.content; })
      .def_property_readonly("name",
                             [](const FileCase& c) { return c.of.name; })
      .def("_run", &run, py::arg("clearance"), py::arg("progress"));
  m.attr("_modes") = mode_words();
}

}  // namespace contact_python
