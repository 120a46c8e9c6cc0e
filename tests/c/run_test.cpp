// Runs from C are bit-identical to C++.
#include "separation/results/run.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "c/run_door.hpp"
#include "separation/case/case_reader.hpp"

namespace contact::test::run_test {
namespace {

const std::string cases = CONTACT_DATA_DIR "/cases/";

void expect_same(const double* a, const double* b, std::size_t count) {
  EXPECT_EQ(std::memcmp(a, b, count * sizeof(double)), 0);
}

class CaseRuns : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(CDoor, CaseRuns,
                         testing::Values("soyuz", "two_stage_turn", "slosh",
                                         "fairing_on_stage"));

TEST_P(CaseRuns, AreThoseOfCpp) {
  const std::string file = cases + GetParam() + ".toml";
  const contact_setting setting = {"run.relative_tolerance", "1e-8"};
  const CRun c = c_run(file, &setting, 1);
  const auto of =
      separation::read_case(file, {}, {{"run.relative_tolerance", "1e-8"}});
  separation::Run cpp(of, {.friction = of.friction});
  ASSERT_EQ(contact_run_end_time(c.get()), of.end_time);
  const std::size_t columns = contact_run_column_count(c.get());
  ASSERT_EQ(columns, cpp.columns().size());
  for (std::size_t i = 0; i < columns; ++i) {
    const char* name = contact_run_column(c.get(), i);
    ASSERT_EQ(name, cpp.columns()[i]);
    std::size_t found;
    ASSERT_EQ(contact_run_find_column(c.get(), name, &found), CONTACT_OK);
    EXPECT_EQ(found, i);
  }
  EXPECT_EQ(contact_run_column(c.get(), columns), nullptr);
  std::vector<double> values(columns);
  for (double t = 0; t < 1.1 * of.end_time; t += 0.17 * of.end_time) {
    ASSERT_EQ(contact_run_advance(c.get(), t), CONTACT_OK);
    cpp.advance_to(t);
    EXPECT_EQ(contact_run_time(c.get()), cpp.time());
    ASSERT_EQ(contact_run_values(c.get(), values.data(), columns), CONTACT_OK);
    expect_same(values.data(), cpp.values().data(), columns);
  }
  EXPECT_EQ(contact_run_time(c.get()), of.end_time);
  const auto& memory = cpp.memory();
  ASSERT_EQ(contact_run_row_count(c.get()), memory.rows.size());
  for (std::size_t i = 0; i < memory.rows.size(); ++i) {
    expect_same(contact_run_row(c.get(), i),
                memory.rows.numbers.data() + i * columns, columns);
  }
  EXPECT_EQ(contact_run_row(c.get(), memory.rows.size()), nullptr);
  ASSERT_EQ(contact_run_event_count(c.get()), memory.notes.size());
  for (std::size_t i = 0; i < memory.notes.size(); ++i) {
    contact_event event;
    ASSERT_EQ(contact_run_event(c.get(), i, &event), CONTACT_OK);
    EXPECT_EQ(event.time, memory.notes[i].time);
    EXPECT_EQ(event.body, memory.notes[i].body);
    EXPECT_EQ(event.what, memory.notes[i].what);
  }
}

// A controller, and what it may not ask for.
TEST(CDoor, RunsTakeTheInputsOfCpp) {
  const std::string file = cases + "flywheels.toml";
  const CRun c = c_run(file);
  const auto of = separation::read_case(file);
  separation::Run cpp(of, {.friction = of.friction});
  const std::size_t count = contact_run_input_count(c.get());
  ASSERT_EQ(count, cpp.inputs().size());
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(contact_run_input(c.get(), i), cpp.inputs()[i].name);
  }
  EXPECT_EQ(contact_run_input(c.get(), count), nullptr);
  std::size_t place, rate;
  ASSERT_EQ(contact_run_find_input(c.get(), "wheel_x.applied_hinge_moment_N_m",
                                   &place),
            CONTACT_OK);
  ASSERT_EQ(contact_run_find_column(c.get(), "wheel_x.rate_deg_per_s", &rate),
            CONTACT_OK);
  std::vector<double> values(contact_run_column_count(c.get()));
  std::vector<double> inputs(count);
  for (double t = 0; t < 5; t += 0.37) {
    ASSERT_EQ(contact_run_advance(c.get(), t), CONTACT_OK);
    cpp.advance_to(t);
    ASSERT_EQ(contact_run_values(c.get(), values.data(), values.size()),
              CONTACT_OK);
    expect_same(values.data(), cpp.values().data(), values.size());
    inputs[place] = -1e-4 * values[rate];
    ASSERT_EQ(contact_run_set_inputs(c.get(), inputs.data(), count),
              CONTACT_OK);
    cpp.set_inputs(inputs);
  }
  EXPECT_EQ(contact_run_set_inputs(c.get(), inputs.data(), 1),
            CONTACT_BAD_INPUT);
  EXPECT_EQ(contact_run_set_inputs(c.get(), nullptr, count), CONTACT_BAD_INPUT);
  EXPECT_EQ(contact_run_find_input(c.get(), "wheel_x", &place),
            CONTACT_BAD_INPUT);
  EXPECT_EQ(contact_run_input_count(nullptr), 0u);
}

TEST_P(CaseRuns, GoOnFromSavedBytes) {
  const std::string file = cases + GetParam() + ".toml";
  const CRun first = c_run(file);
  const CRun second = c_run(file);
  const double end = contact_run_end_time(first.get());
  ASSERT_EQ(contact_run_advance(first.get(), 0.4 * end), CONTACT_OK);
  void* bytes = nullptr;
  std::size_t size = 0;
  ASSERT_EQ(contact_run_save(first.get(), &bytes, &size), CONTACT_OK);
  ASSERT_EQ(contact_run_restore(second.get(), bytes, size), CONTACT_OK);
  contact_free(bytes);
  EXPECT_EQ(contact_run_time(second.get()), contact_run_time(first.get()));
  for (const CRun* run : {&first, &second}) {
    ASSERT_EQ(contact_run_advance(run->get(), end), CONTACT_OK);
  }
  const std::size_t rows = contact_run_row_count(first.get());
  ASSERT_EQ(contact_run_row_count(second.get()), rows);
  for (std::size_t i = 0; i < rows; ++i) {
    expect_same(contact_run_row(first.get(), i),
                contact_run_row(second.get(), i),
                contact_run_column_count(first.get()));
  }
}

TEST_P(CaseRuns, CopiesGoOnAsTheOriginal) {
  const CRun run = c_run(cases + GetParam() + ".toml");
  const double end = contact_run_end_time(run.get());
  ASSERT_EQ(contact_run_advance(run.get(), 0.4 * end), CONTACT_OK);
  contact_run* made = nullptr;
  ASSERT_EQ(contact_run_copy(run.get(), &made), CONTACT_OK);
  const CRun copy(made, run.get_deleter());
  EXPECT_EQ(contact_run_time(copy.get()), contact_run_time(run.get()));
  for (const CRun* each : {&copy, &run}) {
    ASSERT_EQ(contact_run_advance(each->get(), end), CONTACT_OK);
  }
  const std::size_t rows = contact_run_row_count(run.get());
  ASSERT_EQ(contact_run_row_count(copy.get()), rows);
  for (std::size_t i = 0; i < rows; ++i) {
    expect_same(contact_run_row(run.get(), i), contact_run_row(copy.get(), i),
                contact_run_column_count(run.get()));
  }
}

// The [run] of the file says which, as for the program.
TEST(RunFromC, HasTheFrictionOfItsCase) {
  const contact_setting ideal = {"run.friction", "ideal"};
  const CRun run = c_run(cases + "two_stage_turn.toml", &ideal, 1);
  std::size_t work;
  ASSERT_EQ(contact_run_find_column(run.get(), "stage.friction_work_J", &work),
            CONTACT_OK);
  ASSERT_EQ(contact_run_advance(run.get(), 1), CONTACT_OK);
  const std::size_t rows = contact_run_row_count(run.get());
  EXPECT_EQ(contact_run_row(run.get(), rows - 1)[work], 0);
}

// The load of the case crane is near both rims of its ring, ten times of it at
// them.
TEST(RunFromC, HasNotesOfItsJoints) {
  const contact_setting heavy[] = {{"body[1].mass_t", "10"},
                                   {"run.end_time_s", "0.001"},
                                   {"run.output_step_s", "0.001"}};
  for (const bool is_heavy : {false, true}) {
    const CRun run = c_run(cases + "crane.toml", heavy, is_heavy ? 3 : 0);
    ASSERT_EQ(contact_run_advance(run.get(), 0.001), CONTACT_OK)
        << contact_last_message();
    char text[4000];
    ASSERT_EQ(contact_run_notes(run.get(), text, sizeof text), CONTACT_OK);
    const std::string notes = text;
    const std::string where = is_heavy ? "is at" : "ends beside";
    EXPECT_NE(notes.find("the contact " + where + " both its rims"), notes.npos)
        << notes;
    char little[5];
    ASSERT_EQ(contact_run_notes(run.get(), little, sizeof little), CONTACT_OK);
    EXPECT_EQ(notes.substr(0, 4), little);
  }
  char text[4];
  expect_failure(contact_run_notes(nullptr, text, sizeof text),
                 CONTACT_BAD_INPUT,
                 "contact_run_notes: run must be other than NULL");
}

// "failed" of the motion: velocities that overflow.
// A file may name a body by anything; a host's terminal does not hear it.
TEST(RunFromC, MessagesHaveNoControlCharacters) {
  std::ifstream from(CONTACT_DATA_DIR "/cases/slosh.toml");
  std::string text(std::istreambuf_iterator<char>(from), {});
  const std::string name = "name = \"fuel\"";
  text.replace(text.find(name), name.size(), "name = \"\\u001b[2J\"");
  const std::string body = "body = \"tank\"";
  text.replace(text.find(body), body.size(), "body = \"tanks\"");
  const std::string file = testing::TempDir() + "control_characters.toml";
  std::ofstream(file) << text;
  contact_run* run = nullptr;
  EXPECT_EQ(contact_run_open(file.c_str(), nullptr, 0, &run),
            CONTACT_BAD_INPUT);
  const std::string said = contact_last_message();
  EXPECT_NE(said.find("(tank, \\x1b[2J"), std::string::npos) << said;
  EXPECT_EQ(said.find('\x1b'), std::string::npos);
}

TEST(RunFromC, ThatCannotGoOnSaysWhy) {
  const contact_setting fast = {"body[1].start.rate_rpm", "1e300"};
  const CRun run = c_run(cases + "flywheels.toml", &fast, 1);
  for (int i = 0; i < 2; ++i) {  // it stays so
    expect_failure(contact_run_advance(run.get(), 1), CONTACT_RUN_FAILED,
                   "at 0 s: a force or a velocity is not a finite number "
                   "(\"wheel x\")");
  }
  EXPECT_EQ(contact_run_time(run.get()), 0);
}

}  // namespace
}  // namespace contact::test::run_test
