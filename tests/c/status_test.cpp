// Every status of the C interface and its message; no memory is kept.
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <string>
#include <vector>

#include "c/run_door.hpp"
#include "libcontact/version.hpp"

namespace {
std::atomic<bool> out_of_memory = false;
std::atomic<long> allocations = 0;
std::atomic<long> in_use = 0;
}  // namespace

// The shared library uses it too.
void* operator new(std::size_t size) {
  ++allocations;
  void* const memory = out_of_memory ? nullptr : std::malloc(size ? size : 1);
  if (!memory) throw std::bad_alloc();
  ++in_use;
  return memory;
}
// A sanitizer's own operator has memory that is not for free().
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return operator new(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory) noexcept {
  if (memory) --in_use;
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  operator delete(memory);
}

namespace {

using contact::test::c_joint;
using contact::test::c_run;
using contact::test::CJoint;
using contact::test::CRun;
using contact::test::expect_failure;

const std::string hip = CONTACT_DATA_DIR "/joints/hip_cocr_uhmwpe.toml";
const std::string turn = CONTACT_DATA_DIR "/cases/two_stage_turn.toml";
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr contact_slip good = {{0, 100, 1000}, {1, 0, 0}, {}};

TEST(CStatus, VersionIsThatOfTheLibrary) {
  EXPECT_STREQ(contact_version(), contact::version);
  EXPECT_STREQ(contact_version(), CONTACT_VERSION);
  EXPECT_EQ(contact_solution_size(), sizeof(contact_solution));
}

TEST(CStatus, NullIsRefusedByName) {
  const CJoint joint = c_joint(hip);
  const CRun run = c_run(turn);
  const contact_joint* j = joint.get();
  contact_run* r = run.get();
  contact_joint* made = nullptr;
  contact_joint_numbers numbers = {};
  contact_solution s = {};
  const contact_hold hold = {};
  contact_rest rest = {};
  contact_slips slips = {};
  contact_patch patch;
  contact_friction friction;
  contact_event event;
  double x;
  std::size_t n;
  void* bytes = nullptr;
  const auto refuses = [](contact_status status, const std::string& what) {
    expect_failure(status, CONTACT_BAD_INPUT,
                   what + " must be other than NULL");
  };
  refuses(contact_joint_read(nullptr, nullptr, 0, &made),
          "contact_joint_read: path");
  refuses(contact_joint_read(hip.c_str(), nullptr, 0, nullptr),
          "contact_joint_read: joint");
  refuses(contact_joint_read(hip.c_str(), nullptr, 1, &made),
          "contact_joint_read: settings");
  const contact_setting bad[] = {{"name", "x"}, {"name", nullptr}};
  refuses(contact_joint_read(hip.c_str(), bad, 2, &made),
          "contact_joint_read: settings[1].value");
  refuses(contact_joint_parse(nullptr, nullptr, nullptr, 0, &made),
          "contact_joint_parse: text");
  refuses(contact_joint_parse("", nullptr, nullptr, 0, nullptr),
          "contact_joint_parse: joint");
  refuses(contact_joint_make(nullptr, &made), "contact_joint_make: numbers");
  refuses(contact_joint_make(&numbers, nullptr), "contact_joint_make: joint");
  refuses(contact_joint_patch(nullptr, 1, &patch),
          "contact_joint_patch: joint");
  refuses(contact_joint_patch(j, 1, nullptr), "contact_joint_patch: patch");
  refuses(contact_joint_normal_force(nullptr, 1, &x),
          "contact_joint_normal_force: joint");
  refuses(contact_joint_normal_force(j, 1, nullptr),
          "contact_joint_normal_force: normal_force");
  refuses(contact_joint_pressure(nullptr, 1, 0, &x),
          "contact_joint_pressure: joint");
  refuses(contact_joint_pressure(j, 1, 0, nullptr),
          "contact_joint_pressure: pressure");
  refuses(contact_joint_approach(nullptr, 1, &x, &x),
          "contact_joint_approach: joint");
  refuses(contact_joint_approach(j, 1, nullptr, &x),
          "contact_joint_approach: approach");
  refuses(contact_joint_approach(j, 1, &x, nullptr),
          "contact_joint_approach: stiffness");
  refuses(contact_joint_friction(nullptr, 1, 0, &friction),
          "contact_joint_friction: joint");
  refuses(contact_joint_friction(j, 1, 0, nullptr),
          "contact_joint_friction: friction");
  refuses(contact_joint_solve(nullptr, &good, nullptr, &s),
          "contact_joint_solve: joint");
  refuses(contact_joint_solve(j, nullptr, nullptr, &s),
          "contact_joint_solve: slip");
  refuses(contact_joint_solve(j, &good, nullptr, nullptr),
          "contact_joint_solve: solution");
  refuses(contact_joint_solve_contact(nullptr, &good, &s),
          "contact_joint_solve_contact: joint");
  refuses(contact_joint_solve_contact(j, nullptr, &s),
          "contact_joint_solve_contact: known");
  refuses(contact_joint_solve_contact(j, &good, nullptr),
          "contact_joint_solve_contact: solution");
  refuses(contact_joint_solve_rows(nullptr, &slips, &s, sizeof s),
          "contact_joint_solve_rows: joint");
  refuses(contact_joint_solve_rows(j, nullptr, &s, sizeof s),
          "contact_joint_solve_rows: slips");
  slips.count = 1;
  refuses(contact_joint_solve_rows(j, &slips, &s, sizeof s),
          "contact_joint_solve_rows: reaction");
  slips.reaction = good.reaction;
  refuses(contact_joint_solve_rows(j, &slips, &s, sizeof s),
          "contact_joint_solve_rows: angular_velocity");
  slips.angular_velocity = good.angular_velocity;
  refuses(contact_joint_solve_rows(j, &slips, nullptr, sizeof s),
          "contact_joint_solve_rows: solutions");
  refuses(contact_joint_at_rest(nullptr, &hold, nullptr, &rest),
          "contact_joint_at_rest: joint");
  refuses(contact_joint_at_rest(j, nullptr, nullptr, &rest),
          "contact_joint_at_rest: hold");
  refuses(contact_joint_at_rest(j, &hold, nullptr, nullptr),
          "contact_joint_at_rest: rest");
  contact_run* opened = nullptr;
  refuses(contact_run_open(nullptr, nullptr, 0, &opened),
          "contact_run_open: path");
  refuses(contact_run_open(turn.c_str(), nullptr, 0, nullptr),
          "contact_run_open: run");
  refuses(contact_run_advance(nullptr, 1), "contact_run_advance: run");
  refuses(contact_run_find_column(nullptr, "time_s", &n),
          "contact_run_find_column: run");
  refuses(contact_run_find_column(r, nullptr, &n),
          "contact_run_find_column: name");
  refuses(contact_run_find_column(r, "time_s", nullptr),
          "contact_run_find_column: i");
  refuses(contact_run_values(nullptr, &x, 1), "contact_run_values: run");
  refuses(contact_run_values(r, nullptr, 1), "contact_run_values: values");
  refuses(contact_run_event(nullptr, 0, &event), "contact_run_event: run");
  refuses(contact_run_event(r, 0, nullptr), "contact_run_event: event");
  refuses(contact_run_copy(nullptr, &opened), "contact_run_copy: run");
  refuses(contact_run_copy(r, nullptr), "contact_run_copy: copy");
  refuses(contact_run_save(nullptr, &bytes, &n), "contact_run_save: run");
  refuses(contact_run_save(r, nullptr, &n), "contact_run_save: bytes");
  refuses(contact_run_save(r, &bytes, nullptr), "contact_run_save: size");
  refuses(contact_run_restore(nullptr, "", 0), "contact_run_restore: run");
  refuses(contact_run_restore(r, nullptr, 0), "contact_run_restore: bytes");
  // These have no status.
  contact_joint_free(nullptr);
  contact_run_free(nullptr);
  contact_free(nullptr);
  EXPECT_EQ(contact_joint_note(nullptr, 0), nullptr);
  EXPECT_TRUE(std::isnan(contact_run_time(nullptr)));
  EXPECT_TRUE(std::isnan(contact_run_end_time(nullptr)));
  EXPECT_EQ(contact_run_column_count(nullptr), 0u);
  EXPECT_EQ(contact_run_column(nullptr, 0), nullptr);
  EXPECT_EQ(contact_run_row_count(nullptr), 0u);
  EXPECT_EQ(contact_run_row(nullptr, 0), nullptr);
  EXPECT_EQ(contact_run_event_count(nullptr), 0u);
}

TEST(CStatus, BadInputHasTheMessagesOfCpp) {
  contact_joint* joint = nullptr;
  const auto refuses = [](contact_status status, const std::string& message) {
    expect_failure(status, CONTACT_BAD_INPUT, message);
  };
  refuses(contact_joint_read("none.toml", nullptr, 0, &joint),
          "none.toml: cannot be read: No such file or directory");
  const contact_setting flat = {"geometry.radius_mm", "-1"};
  refuses(contact_joint_read(hip.c_str(), &flat, 1, &joint),
          hip +
              " with geometry.radius_mm = -1: geometry.radius_mm = -1 must be "
              "above 0");
  refuses(contact_joint_parse("kind = 3", nullptr, nullptr, 0, &joint),
          "joint:1: the file requires the table [geometry]");
  contact_joint_numbers numbers = {};
  refuses(contact_joint_make(&numbers, &joint),
          "ball joint: radius = 0 must be above 0 m and finite");
  numbers.radius = 0.02;
  numbers.radial_clearance = 1e-5;
  refuses(contact_joint_make(&numbers, &joint),
          "inner material: youngs_modulus = 0 must be above 0 Pa or inf for a "
          "rigid body");
  numbers.kind = 7;
  refuses(contact_joint_make(&numbers, &joint),
          "contact_joint_make: kind must be CONTACT_BALL or CONTACT_PIN");
  EXPECT_EQ(joint, nullptr);

  const CJoint c = c_joint(hip);
  contact_solution s[2];
  contact_slips slips = {};
  slips.tolerance = -1;
  refuses(contact_joint_solve_rows(c.get(), &slips, s, sizeof s[0]),
          "contact_joint_solve_rows: tolerance = -1 must be 0 or above");
  slips.tolerance = 0;
  EXPECT_EQ(contact_joint_solve_rows(c.get(), &slips, nullptr, 0), CONTACT_OK);
  slips.count = 2;
  slips.reaction = good.reaction;
  slips.angular_velocity = good.angular_velocity;
  // Too short, and long enough but not aligned.
  for (const std::size_t stride : {std::size_t{8}, sizeof s[0] + 4}) {
    refuses(contact_joint_solve_rows(c.get(), &slips, s,
                                     static_cast<std::ptrdiff_t>(stride)),
            "contact_joint_solve_rows: stride = " + std::to_string(stride) +
                " must be a multiple of 8, sizeof(contact_solution) = " +
                std::to_string(sizeof s[0]) + " or above");
  }

  const CRun run = c_run(turn);
  contact_run* other = nullptr;
  const contact_setting typo = {"carrier.mas_t", "1"};
  refuses(contact_run_open(turn.c_str(), &typo, 1, &other),
          turn +
              " with carrier.mas_t = 1: unknown key \"carrier.mas_t\": did you "
              "mean \"mass\"? (name, mass, density_kg_per_m3, com, inertia, "
              "principal_inertia, shape, direction, fixed, start, drive)");
  EXPECT_EQ(other, nullptr);
  ASSERT_EQ(contact_run_advance(run.get(), 1), CONTACT_OK);
  refuses(contact_run_advance(run.get(), 0.5),
          "time = 0.5 must be 1 s or later");
  refuses(contact_run_advance(run.get(), nan),
          "time = nan must be 1 s or later");
  std::size_t i;
  refuses(contact_run_find_column(run.get(), "stage.angel_deg", &i),
          "unknown column \"stage.angel_deg\": did you mean "
          "\"stage.angle_deg\"?");
  std::vector<double> values(contact_run_column_count(run.get()) + 1);
  refuses(contact_run_values(run.get(), values.data(), values.size()),
          "contact_run_values: count = " + std::to_string(values.size()) +
              " must be " + std::to_string(values.size() - 1));
  contact_event event;
  refuses(contact_run_event(run.get(), 99, &event),
          "contact_run_event: i = 99 must be below " +
              std::to_string(contact_run_event_count(run.get())));
  refuses(contact_run_restore(run.get(), "old", 3),
          "the saved state: the file must be a checkpoint of hinge-separation");
  const contact_setting shorter = {"run.end_time_s", "2"};
  const CRun short_run = c_run(turn, &shorter, 1);
  void* bytes = nullptr;
  std::size_t size = 0;
  ASSERT_EQ(contact_run_save(short_run.get(), &bytes, &size), CONTACT_OK);
  refuses(contact_run_restore(run.get(), bytes, size),
          "the saved state: the checkpoint must be one of this case file, "
          "these joints and these options");
  contact_free(bytes);
  EXPECT_EQ(contact_run_time(run.get()), 1);  // as before all this
}

TEST(CStatus, OutOfRangeGivesNan) {
  const CJoint joint = c_joint(hip);
  const CJoint fitted = c_joint(CONTACT_DATA_DIR "/joints/pin_joint.toml");
  contact_patch patch;
  double x, y;
  const auto is_out = [](contact_status status, const std::string& message) {
    expect_failure(status, CONTACT_OUT_OF_RANGE, message);
  };
  is_out(contact_joint_patch(joint.get(), -1, &patch),
         "contact_joint_patch: normal_force = -1 must be in the range of the "
         "laws");
  EXPECT_TRUE(std::isnan(patch.half_angle));
  is_out(contact_joint_normal_force(joint.get(), 4, &x),
         "contact_joint_normal_force: half_angle = 4 must be in the range of "
         "the laws");
  EXPECT_TRUE(std::isnan(x));
  is_out(contact_joint_pressure(joint.get(), nan, 0, &x),
         "contact_joint_pressure: normal_force = nan must be in the range of "
         "the laws");
  is_out(
      contact_joint_approach(fitted.get(), 100, &x, &y),
      "contact_joint_approach: joint must have an approach: the half-angle law "
      "\"exact\", a load through its centre, and no pin in an infinite hole");
  EXPECT_TRUE(std::isnan(x) && std::isnan(y));
  is_out(contact_joint_approach(joint.get(), 0, &x, &y),
         "contact_joint_approach: normal_force = 0 must be above 0 and in the "
         "range of the laws");
  is_out(contact_joint_pressure(joint.get(), 100, nan, &x),
         "contact_joint_pressure: theta = nan must be a number");
  contact_friction friction;
  is_out(contact_joint_friction(joint.get(), -1, 0, &friction),
         "contact_joint_friction: half_angle = -1 must be in the range of the "
         "laws");
  is_out(contact_joint_friction(joint.get(), 0.5, 9, &friction),
         "contact_joint_friction: slip_axis_angle = 9 must be -pi/2 to pi/2 "
         "rad");
  contact_slip bad = good;
  bad.reaction[1] = nan;
  const std::string why =
      ": no solution: numbers must be finite and the contact in the range of "
      "the laws";
  contact_solution s;
  is_out(contact_joint_solve(joint.get(), &bad, nullptr, &s),
         "contact_joint_solve" + why);
  EXPECT_TRUE(std::isnan(s.friction_moment[0]));
  is_out(contact_joint_solve_contact(joint.get(), &bad, &s),
         "contact_joint_solve_contact" + why);
  const contact_hold hold = {{0, 0, 10}, {0, nan, 0}, {}};
  contact_rest rest;
  is_out(contact_joint_at_rest(joint.get(), &hold, nullptr, &rest),
         "contact_joint_at_rest" + why);
  // The first bad row; the others are solved.
  const contact_slip all[] = {good, good, bad, bad, good};
  contact_solution rows[5];
  contact_slips slips = {};
  slips.count = 5;
  slips.reaction = all[0].reaction;
  slips.angular_velocity = all[0].angular_velocity;
  slips.reaction_stride = slips.angular_velocity_stride = sizeof all[0];
  slips.warm = 1;
  is_out(contact_joint_solve_rows(joint.get(), &slips, rows, sizeof rows[0]),
         "contact_joint_solve_rows: row 2" + why);
  EXPECT_EQ(rows[3].status, CONTACT_OUT_OF_RANGE);
  EXPECT_EQ(rows[4].status, CONTACT_OK);
  EXPECT_EQ(rows[4].normal_force, rows[0].normal_force);
}

TEST(CStatus, RefusedCallsLeaveNoHandle) {
  contact_joint* joint = nullptr;
  contact_play* play = nullptr;
  const auto garbage = [&] {
    joint = reinterpret_cast<contact_joint*>(0x1230);
    play = reinterpret_cast<contact_play*>(0x1230);
  };
  garbage();
  EXPECT_NE(contact_joint_read("none.toml", nullptr, 0, &joint), CONTACT_OK);
  EXPECT_EQ(joint, nullptr);
  garbage();
  EXPECT_NE(contact_joint_read(nullptr, nullptr, 0, &joint), CONTACT_OK);
  EXPECT_EQ(joint, nullptr);
  garbage();
  EXPECT_NE(contact_joint_parse("kind", nullptr, nullptr, 0, &joint),
            CONTACT_OK);
  EXPECT_EQ(joint, nullptr);
  garbage();
  EXPECT_NE(contact_joint_make(nullptr, &joint), CONTACT_OK);
  EXPECT_EQ(joint, nullptr);
  EXPECT_NE(contact_play_make(nullptr, nullptr, &play), CONTACT_OK);
  EXPECT_EQ(play, nullptr);
}

TEST(CStatus, RefusedCallsSaySoInTheirResults) {
  const CJoint joint = c_joint(hip);
  contact_solution s;
  ASSERT_EQ(contact_joint_solve(joint.get(), &good, nullptr, &s), CONTACT_OK);
  const contact_solution solved = s;
  const auto is_refused = [](const contact_solution& of) {
    return of.status == CONTACT_BAD_INPUT && std::isnan(of.residual) &&
           std::isnan(of.friction_moment[2]) && std::isnan(of.half_angle) &&
           std::isnan(of.contact_area) && std::isnan(of.slip_axis_angle);
  };
  EXPECT_NE(contact_joint_solve(nullptr, &good, nullptr, &s), CONTACT_OK);
  EXPECT_TRUE(is_refused(s));
  s = solved;
  EXPECT_NE(contact_joint_solve_contact(joint.get(), nullptr, &s), CONTACT_OK);
  EXPECT_TRUE(is_refused(s));
  s = solved;
  contact_slips slips = {};
  slips.count = 1;
  EXPECT_NE(contact_joint_solve_rows(joint.get(), &slips, &s, sizeof s),
            CONTACT_OK);
  EXPECT_TRUE(is_refused(s));
  contact_rest rest = {};
  EXPECT_NE(contact_joint_at_rest(joint.get(), nullptr, nullptr, &rest),
            CONTACT_OK);
  EXPECT_EQ(rest.status, CONTACT_BAD_INPUT);
  EXPECT_TRUE(std::isnan(rest.utilisation) && std::isnan(rest.direction[1]));
  EXPECT_TRUE(is_refused(rest.slip));
  contact_patch patch = {};
  contact_friction friction = {};
  double x = 0, y = 0;
  EXPECT_NE(contact_joint_patch(nullptr, 1, &patch), CONTACT_OK);
  EXPECT_TRUE(std::isnan(patch.half_angle) && std::isnan(patch.area));
  EXPECT_NE(contact_joint_friction(nullptr, 1, 0, &friction), CONTACT_OK);
  EXPECT_TRUE(std::isnan(friction.coefficient[0]) &&
              std::isnan(friction.area[2]));
  EXPECT_NE(contact_joint_approach(nullptr, 1, &x, &y), CONTACT_OK);
  EXPECT_TRUE(std::isnan(x) && std::isnan(y));
  x = 0;
  EXPECT_NE(contact_solution_get(&solved, "colour", &x), CONTACT_OK);
  EXPECT_TRUE(std::isnan(x));
}

// Only in builds with assertions.
TEST(CStatus, FreedHandlesAreRefusedWhereAssertionsAre) {
#ifdef NDEBUG
  GTEST_SKIP() << "a build without assertions";
#else
  contact_joint* joint = c_joint(hip).release();
  contact_joint_free(joint);
  contact_solution s;
  expect_failure(contact_joint_solve(joint, &good, nullptr, &s),
                 CONTACT_BAD_INPUT,
                 "contact_joint_solve: joint must be one that has not been "
                 "freed");
  contact_joint_free(joint);
#endif
}

// No residual of doubles but 0 is so small, and it is often 0.
TEST(CStatus, TooSmallAToleranceIsNotMet) {
  const CJoint joint = c_joint(CONTACT_DATA_DIR "/joints/paper_example_2.toml");
  std::vector<contact_slip> rows(50, good);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].angular_velocity[2] = static_cast<double>(i) / 10;
  }
  std::vector<contact_solution> s(rows.size());
  contact_slips slips = {};
  slips.count = rows.size();
  slips.reaction = rows[0].reaction;
  slips.angular_velocity = rows[0].angular_velocity;
  slips.reaction_stride = slips.angular_velocity_stride = sizeof rows[0];
  slips.tolerance = 1e-300;
  const contact_status status =
      contact_joint_solve_rows(joint.get(), &slips, s.data(), sizeof s[0]);
  const auto first =
      std::ranges::find(s, CONTACT_NOT_CONVERGED, &contact_solution::status);
  ASSERT_NE(first, s.end());
  expect_failure(status, CONTACT_NOT_CONVERGED,
                 "contact_joint_solve_rows: row " +
                     std::to_string(first - s.begin()) + ": not converged");
  EXPECT_GT(first->residual, 0);
  EXPECT_LT(first->residual, 1e-13);
}

TEST(CStatus, OutOfMemoryIsAFailure) {
  const CRun run = c_run(turn);
  contact_joint* joint = nullptr;
  contact_run* other = nullptr;
  void* bytes = nullptr;
  std::size_t size;
  out_of_memory = true;
  const contact_status read =
      contact_joint_read(hip.c_str(), nullptr, 0, &joint);
  const contact_status opened =
      contact_run_open(turn.c_str(), nullptr, 0, &other);
  const contact_status saved = contact_run_save(run.get(), &bytes, &size);
  out_of_memory = false;
  EXPECT_EQ(read, CONTACT_FAILURE);
  EXPECT_EQ(opened, CONTACT_FAILURE);
  expect_failure(saved, CONTACT_FAILURE, "out of memory");
  EXPECT_EQ(joint, nullptr);
  EXPECT_EQ(other, nullptr);
  EXPECT_EQ(bytes, nullptr);
}

TEST(CStatus, AMillionCallsAllocateNothing) {
  const CJoint joint = c_joint(CONTACT_DATA_DIR "/joints/pin_joint.toml");
  contact_solution s = {};
  contact_patch patch;
  contact_slip slip = good;
  contact_joint_solve(joint.get(), &slip, nullptr, &s);
  const long before = allocations;
  for (int i = 0; i < 1'000'000; ++i) {
    slip.reaction[0] = i % 1000;
    if (contact_joint_solve(joint.get(), &slip, &s, &s) != CONTACT_OK) FAIL();
  }
  for (int i = 0; i < 1'000'000; ++i) {
    contact_joint_patch(joint.get(), i + 1, &patch);
  }
  EXPECT_EQ(allocations, before);
}

// Handles, and calls that fail, give all of it back.
TEST(CStatus, NothingIsKeptOfWhatIsFreed) {
  const auto once = [] {
    const CJoint joint = c_joint(hip);
    const CRun run = c_run(turn);
    contact_run_advance(run.get(), 0.1);
    void* bytes = nullptr;
    std::size_t size;
    contact_run_save(run.get(), &bytes, &size);
    contact_free(bytes);
    contact_joint* none = nullptr;
    contact_joint_read("none.toml", nullptr, 0, &none);
    contact_patch patch;
    for (int i = 0; i < 1000; ++i) contact_joint_patch(joint.get(), -1, &patch);
  };
  // Until the caches of malloc() have what they want.
  for (int i = 0; i < 20; ++i) once();
  const long before = in_use;
  const auto bytes_before = mallinfo2().uordblks;
  for (int i = 0; i < 20; ++i) once();
  EXPECT_EQ(in_use, before);
  // malloc() alone is counted: what was saved is 10 kB; its caches come and go.
  EXPECT_LE(mallinfo2().uordblks, bytes_before + 20'000);
}

}  // namespace
