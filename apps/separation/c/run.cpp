#include "separation/c/run.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <new>
#include <string>
#include <utility>

#include "libcontact/base/text.hpp"
#include "libcontact/c/call.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/results/notes.hpp"
#include "separation/results/run.hpp"
#include "separation/results/saved_state.hpp"

using contact::detail::message;
using contact::detail::must_be;
using separation::Case;
using separation::Run;

/// State of a run behind C's handle.
struct contact_run  // NOLINT(readability-identifier-naming)
    : contact::c::Handle {
  explicit contact_run(Case c)
      : identity(identity_of(c, {})), run(std::move(c)) {}
  explicit contact_run(contact_run& other)
      : identity(other.identity), run(other.run) {}

  const std::string identity;
  Run run;
};

namespace contact::c {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// An index of so many things.
void check_index(std::size_t i, std::size_t count, const char* name) {
  if (i < count) return;
  throw Error(must_be(message("{} = {}", name, i), message("below {}", count)));
}

}  // namespace
}  // namespace contact::c

using contact::c::call;
using contact::c::given;

contact_status contact_run_open(const char* path,
                                const contact_setting* settings,
                                std::size_t count, contact_run** run) {
  return call([=] {
    contact_run** const to = contact::c::emptied(run, "contact_run_open: run");
    return contact::c::hand_over(
        to, separation::read_case(
                &given(path, "contact_run_open: path"), {},
                contact::c::settings_of(settings, count, "contact_run_open")));
  });
}

void contact_run_free(contact_run* run) { contact::c::give_back(run); }

contact_status contact_run_advance(contact_run* run, double time) {
  return call([=] {
    Run& r = given(run, "contact_run_advance: run").run;
    return r.advance_to(time) == Run::Status::failed
               ? contact_report(CONTACT_RUN_FAILED, r.message().c_str())
               : CONTACT_OK;
  });
}

double contact_run_time(const contact_run* run) {
  return run ? run->run.time() : contact::c::none;
}

double contact_run_end_time(const contact_run* run) {
  return run ? run->run.of().end_time : contact::c::none;
}

std::size_t contact_run_column_count(const contact_run* run) {
  return run ? run->run.columns().size() : 0;
}

const char* contact_run_column(const contact_run* run, std::size_t i) {
  return i < contact_run_column_count(run) ? run->run.columns()[i].c_str()
                                           : nullptr;
}

contact_status contact_run_find_column(const contact_run* run, const char* name,
                                       std::size_t* i) {
  return call([=] {
    given(i, "contact_run_find_column: i") =
        given(run, "contact_run_find_column: run")
            .run.memory()
            .rows.column(&given(name, "contact_run_find_column: name"));
    return CONTACT_OK;
  });
}

contact_status contact_run_values(const contact_run* run, double* values,
                                  std::size_t count) {
  return call([=] {
    const Run& r = given(run, "contact_run_values: run").run;
    given(values, "contact_run_values: values");
    if (count != r.columns().size()) {
      throw contact::Error(
          must_be(message("contact_run_values: count = {}", count),
                  message("{}", r.columns().size())));
    }
    std::ranges::copy(r.values(), values);
    return CONTACT_OK;
  });
}

std::size_t contact_run_input_count(const contact_run* run) {
  return run ? run->run.inputs().size() : 0;
}

const char* contact_run_input(const contact_run* run, std::size_t i) {
  return i < contact_run_input_count(run) ? run->run.inputs()[i].name.c_str()
                                          : nullptr;
}

contact_status contact_run_find_input(const contact_run* run, const char* name,
                                      std::size_t* i) {
  return call([=] {
    std::size_t& to = given(i, "contact_run_find_input: i");
    to = given(run, "contact_run_find_input: run")
             .run.input(&given(name, "contact_run_find_input: name"));
    return CONTACT_OK;
  });
}

contact_status contact_run_set_inputs(contact_run* run, const double* values,
                                      std::size_t count) {
  return call([=] {
    Run& r = given(run, "contact_run_set_inputs: run").run;
    const double* const first =
        count > 0 ? &given(values, "contact_run_set_inputs: values") : values;
    r.set_inputs({first, first + count});
    return CONTACT_OK;
  });
}

std::size_t contact_run_row_count(const contact_run* run) {
  return run ? run->run.memory().rows.size() : 0;
}

const double* contact_run_row(const contact_run* run, std::size_t i) {
  if (i >= contact_run_row_count(run)) return nullptr;
  const separation::Rows& rows = run->run.memory().rows;
  return rows.numbers.data() + i * rows.columns.size();
}

std::size_t contact_run_event_count(const contact_run* run) {
  return run ? run->run.memory().notes.size() : 0;
}

contact_status contact_run_event(const contact_run* run, std::size_t i,
                                 contact_event* event) {
  return call([=] {
    const auto& notes = given(run, "contact_run_event: run").run.memory().notes;
    contact_event& to = given(event, "contact_run_event: event");
    contact::c::check_index(i, notes.size(), "contact_run_event: i");
    to = {notes[i].time, notes[i].body.c_str(), notes[i].what.c_str()};
    return CONTACT_OK;
  });
}

contact_status contact_run_notes(const contact_run* run, char* text,
                                 std::size_t size) {
  return call([=] {
    const Run& r = given(run, "contact_run_notes: run").run;
    if (size > 0) given(text, "contact_run_notes: text");
    auto notes = separation::joint_notes(r.of());
    for (auto& note : separation::contact_notes(r.of(), r.memory())) {
      notes.push_back(std::move(note));
    }
    return contact::c::hand_over_notes(notes, text, size);
  });
}

contact_status contact_run_copy(contact_run* run, contact_run** copy) {
  return call([=] {
    contact_run** const to =
        contact::c::emptied(copy, "contact_run_copy: copy");
    *to = new contact_run(given(run, "contact_run_copy: run"));
    return CONTACT_OK;
  });
}

contact_status contact_run_save(contact_run* run, void** bytes,
                                std::size_t* size) {
  return call([=] {
    void*& to = *contact::c::emptied(bytes, "contact_run_save: bytes");
    contact_run& r = given(run, "contact_run_save: run");
    std::size_t& length = given(size, "contact_run_save: size");
    const std::string saved = separation::saved_bytes(r.run.save(), r.identity);
    void* const copy = std::malloc(saved.size());
    if (!copy) throw std::bad_alloc();
    std::ranges::copy(saved, static_cast<char*>(copy));
    to = copy;
    length = saved.size();
    return CONTACT_OK;
  });
}

contact_status contact_run_restore(contact_run* run, const void* bytes,
                                   std::size_t size) {
  return call([=] {
    contact_run& r = given(run, "contact_run_restore: run");
    const auto* first =
        &given(static_cast<const char*>(bytes), "contact_run_restore: bytes");
    r.run.restore(separation::saved_state({first, size}, r.identity));
    return CONTACT_OK;
  });
}

void contact_free(void* bytes) { std::free(bytes); }
