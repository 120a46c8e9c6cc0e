// A run in pieces, saved and restored, beside another one: the same to the
// last bit.
#include "separation/results/run.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "separation/case/case_reader.hpp"
#include "separation/results/saved_state.hpp"
#include "separation/results/summary.hpp"
#include "support/error_message.hpp"

namespace contact::test::run_object_test {
namespace {

using separation::Case;
using separation::Outcome;
using separation::Rows;
// gtest has a Run of its own.
using CaseRun = separation::Run;
using separation::run_case;
using separation::RunState;
using Status = CaseRun::Status;

Case case_of(const std::string& name) {
  return separation::read_case(CONTACT_DATA_DIR "/cases/" + name + ".toml");
}

// Bodies that come off, hinges that rest and slide, balls.
const std::vector<std::string> names = {"soyuz", "platform", "flywheels",
                                        "slosh", "two_stage_turn"};

// To the last bit, NaN too.
void expect_same(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)), 0);
}

void expect_same(const Case& c, Outcome a, Outcome b, bool counts = true) {
  ASSERT_GT(a.memory.rows.size(), 50u);
  expect_same(a.memory.rows.numbers, b.memory.rows.numbers);
  if (!counts) a.counts = b.counts = {};
  EXPECT_EQ(separation::summary(c, a).dump(), separation::summary(c, b).dump());
}

class Runs : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Cases, Runs, testing::ValuesIn(names));

TEST_P(Runs, StopsAndLooksOnTheWayChangeNothing) {
  const Case c = case_of(GetParam());
  CaseRun run(c);
  double largest = 0;
  // Times that are neither steps nor output times.
  const double step = c.end_time / 37.3;
  for (double t = step; run.advance_to(t) == Status::running; t += step) {
    ASSERT_EQ(run.time(), t);
    const std::vector<double> values = run.values();
    ASSERT_EQ(values.size(), run.columns().size());
    ASSERT_EQ(values[0], t);
    for (int i = 0; i <= static_cast<int>(c.bodies.size()); ++i) {
      largest = std::max(largest, run.sample().angular_acceleration(i).norm());
    }
  }
  EXPECT_GT(largest, 0);  // it was asked for
  EXPECT_EQ(run.status(), Status::finished);
  EXPECT_EQ(run.time(), c.end_time);
  expect_same(c, std::move(run).end(), run_case(c));
}

TEST_P(Runs, GoOnFromASavedStateToTheSameEnd) {
  const Case c = case_of(GetParam());
  CaseRun first(c);
  first.advance_to(0.41 * c.end_time);
  const RunState saved = first.save();
  ASSERT_EQ(first.advance_to(c.end_time), Status::finished);
  CaseRun second(c);
  second.advance_to(0.2 * c.end_time);  // leaves no trace
  second.restore(saved);
  EXPECT_EQ(second.time(), saved.simulation.motion.time);
  ASSERT_EQ(second.advance_to(c.end_time), Status::finished);
  expect_same(c, first.outcome(), second.outcome(), false);
  // Back again, from the end.
  first.restore(saved);
  EXPECT_EQ(first.status(), Status::running);
  ASSERT_EQ(first.advance_to(c.end_time), Status::finished);
  expect_same(c, first.outcome(), second.outcome());
  // Other steps, the same motion: notes and times at rest are not lost.
  const Outcome whole = run_case(c);
  const Outcome pieces = first.outcome();
  ASSERT_EQ(whole.memory.notes.size(), pieces.memory.notes.size());
  for (std::size_t i = 0; i < whole.memory.notes.size(); ++i) {
    EXPECT_EQ(whole.memory.notes[i].what, pieces.memory.notes[i].what);
    EXPECT_NEAR(whole.memory.notes[i].time, pieces.memory.notes[i].time,
                1e-6 * c.end_time);
  }
  for (std::size_t b = 0; b < c.bodies.size(); ++b) {
    EXPECT_NEAR(whole.memory.bodies[b].rest_time,
                pieces.memory.bodies[b].rest_time, 1e-6 * c.end_time);
    EXPECT_NEAR(whole.memory.bodies[b].peak_reaction,
                pieces.memory.bodies[b].peak_reaction,
                1e-5 * whole.memory.bodies[b].peak_reaction);
  }
}

TEST_P(Runs, CopiesGoOnAsTheOriginal) {
  const Case c = case_of(GetParam());
  CaseRun original(c);
  original.advance_to(0.41 * c.end_time);
  CaseRun copy = original;
  EXPECT_EQ(copy.time(), original.time());
  expect_same(copy.values(), original.values());
  // Copies at the same time of both: all four go on alike.
  original.advance_to(0.6 * c.end_time);
  CaseRun second = original;
  // The steps of the others have no effect.
  ASSERT_EQ(second.advance_to(c.end_time), Status::finished);
  ASSERT_EQ(original.advance_to(c.end_time), Status::finished);
  expect_same(c, original.outcome(), second.outcome(), false);
  copy.advance_to(0.6 * c.end_time);
  CaseRun third = copy;
  ASSERT_EQ(copy.advance_to(c.end_time), Status::finished);
  ASSERT_EQ(third.advance_to(c.end_time), Status::finished);
  expect_same(c, original.outcome(), copy.outcome(), false);
  expect_same(c, original.outcome(), third.outcome(), false);
  CaseRun ended = original;
  EXPECT_EQ(ended.status(), Status::finished);
  expect_same(c, original.outcome(), ended.outcome(), false);
}

TEST_P(Runs, GoOnFromSavedBytesToTheSameEnd) {
  const Case c = case_of(GetParam());
  const std::string identity = separation::identity_of(c, {});
  CaseRun first(c);
  first.advance_to(0.41 * c.end_time);
  const std::string bytes = separation::saved_bytes(first.save(), identity);
  ASSERT_EQ(first.advance_to(c.end_time), Status::finished);
  CaseRun second(c);
  second.restore(separation::saved_state(bytes, identity));
  ASSERT_EQ(second.advance_to(c.end_time), Status::finished);
  expect_same(c, first.outcome(), second.outcome(), false);
}

// For damaged bytes see parts_test.cpp.
TEST(SavedBytes, OfOthersAreRefused) {
  const Case c = case_of("two_stage_turn");
  const std::string bytes = separation::saved_bytes(CaseRun(c).save(), "own");
  const auto message = [](const std::string& from, const char* identity) {
    return error_message([&] { separation::saved_state(from, identity); });
  };
  EXPECT_EQ(message(bytes, "other"),
            "the saved state: the checkpoint must be one of this case file, "
            "these joints and these options");
  EXPECT_EQ(
      message("some text", "own"),
      "the saved state: the file must be a checkpoint of hinge-separation");
}

// Copies of a case share the laws of its joints.
TEST_P(Runs, InTwoThreadsAreIndependent) {
  const Case c = case_of(GetParam());
  const Case other = case_of("soyuz");
  const Outcome alone = run_case(c);
  const Outcome other_alone = run_case(other);
  std::vector<Outcome> outcomes(3);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      threads.emplace_back(
          [&, i] { outcomes[i] = run_case(i < 2 ? c : other); });
    }
  }
  expect_same(c, outcomes[0], alone);
  expect_same(c, outcomes[1], alone);
  expect_same(other, outcomes[2], other_alone);
}

// At output times the values are the row of the history. Between them they
// equal the row of a run with this output time, to the tolerance of the steps
// (1e-9, and its effect on rates).
TEST(Run, ValuesAreRowsOfTheHistory) {
  Case c = case_of("soyuz");
  CaseRun run(c);
  ASSERT_EQ(run.advance_to(run.next_output()), Status::running);
  const Rows& rows = run.memory().rows;
  ASSERT_EQ(rows.size(), 2u);
  const auto row_of = [](const Rows& of, std::size_t row) {
    std::vector<double> values;
    for (std::size_t i = 0; i < of.columns.size(); ++i) {
      values.push_back(of.at(row, i));
    }
    return values;
  };
  expect_same(run.values(), row_of(rows, 1));
  const double between = 1.5 * c.output_step;
  run.advance_to(between);
  const std::vector<double> values = run.values();
  EXPECT_EQ(rows.size(), 2u);
  c.output_step = between;
  CaseRun rough(c);
  rough.advance_to(between);
  const std::vector<double> row = rough.values();
  ASSERT_EQ(values.size(), row.size());
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (std::isnan(row[i]) && std::isnan(values[i])) continue;
    EXPECT_NEAR(values[i], row[i], 1e-7 * (1 + std::abs(row[i])))
        << run.columns()[i];
  }
  const auto& now = run.sample().body(0);
  const auto column = rows.column("booster_1.x_m");
  EXPECT_EQ(now.position.x(), values[column]);
}

// The last step goes beyond the end.
TEST(Run, EndsAndIsSavedWhereItIsBetweenOutputTimes) {
  Case c = case_of("two_stage_turn");
  c.output_step = 0.13;
  CaseRun run(c);
  run.advance_to(1.066);
  const std::vector<double> values = run.values();
  EXPECT_LE(run.save().memory.pairs.at(0).time, 1.066);
  CaseRun other(c);
  other.advance_to(1.066);
  const Outcome outcome = std::move(other).end();
  const std::vector<double>& numbers = outcome.memory.rows.numbers;
  expect_same({numbers.end() - static_cast<std::ptrdiff_t>(values.size()),
               numbers.end()},
              values);
}

TEST(Run, MeetsOutputTimesWithinRounding) {
  CaseRun run(case_of("soyuz"));
  const double time = run.next_output();
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(run.advance_to(time * (1 - 1e-13)), Status::running);
    EXPECT_EQ(run.time(), time);
    EXPECT_EQ(run.memory().rows.size(), 2u);
  }
}

TEST(Run, StopsAtAFlagAndGoesOn) {
  const Case c = case_of("soyuz");
  std::atomic<bool> stop = false;
  int steps = 0;
  separation::RunOptions options;
  options.stop = [&](long) { return stop ? "the pilot" : ""; };
  options.progress = [&](const CaseRun& run) {
    EXPECT_GE(run.time(), 0);
    EXPECT_EQ(run.values()[0], run.time());
    if (++steps == 20) std::jthread([&] { stop = true; });
  };
  CaseRun run(c, options);
  ASSERT_EQ(run.advance_to(c.end_time), Status::stopped);
  EXPECT_TRUE(has_text(run.message(), " s: stopped by the pilot after "));
  EXPECT_LT(run.time(), c.end_time);
  EXPECT_EQ(run.outcome().failure, run.message());
  EXPECT_EQ(run.advance_to(c.end_time), Status::stopped);
  stop = false;
  ASSERT_EQ(run.advance_to(c.end_time), Status::finished);
  EXPECT_EQ(run.message(), "");
  expect_same(c, std::move(run).end(), run_case(c));
}

TEST(Run, RefusesWhatCannotBe) {
  const Case c = case_of("slosh");
  CaseRun run(c);
  run.advance_to(1);
  EXPECT_ERROR(run.advance_to(0.5), "time = 0.5 must be 1 s or later");
  EXPECT_ERROR(run.advance_to(NAN), "time = nan must be 1 s or later");
  CaseRun other(case_of("soyuz"));
  EXPECT_ERROR(other.restore(run.save()),
               "the state to restore must be of a run of the same case and "
               "options");
  EXPECT_EQ(other.time(), 0);
  run.advance_to(INFINITY);
  EXPECT_EQ(run.time(), c.end_time);
  EXPECT_EQ(run.advance_to(c.end_time), Status::finished);
  for (const double earlier : {0., double{NAN}}) {
    EXPECT_THROW(run.advance_to(earlier), Error) << earlier;
  }
}

}  // namespace
}  // namespace contact::test::run_object_test
