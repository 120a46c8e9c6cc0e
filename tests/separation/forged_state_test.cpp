// Saved runs whose check sum is right and whose contents are not: refused,
// which changes nothing, or harmless.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "separation/case/case_reader.hpp"
#include "separation/results/cbor.hpp"
#include "separation/results/saved_state.hpp"
#include "separation/results/state_json.hpp"
#include "separation/results/summary.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"

namespace contact::test::forged_state_test {
namespace {

using nlohmann::json;
using separation::Case;
using CaseRun = separation::Run;

json content_of(std::string_view bytes) {
  bytes.remove_suffix(8);  // the check sum
  bytes.remove_prefix(bytes.find('\n') + 1);
  return separation::take_cbor(bytes).value();
}

// With few rows, which are many places.
Case case_of(const std::string& name) {
  Case c = separation::read_case(CONTACT_DATA_DIR "/cases/" + name + ".toml");
  c.output_step = c.end_time / 20;
  return c;
}

std::string with_sum(const std::string& bytes) {
  boost::crc_32_type sum;
  sum.process_bytes(bytes.data(), bytes.size());
  return bytes + fmt::format("{:08x}", sum.checksum());
}

/// A run in the middle, restored from manipulated states.
class Forgery {
 public:
  explicit Forgery(const std::string& name, double part = 0.41)
      : case_(case_of(name)),
        identity_(separation::identity_of(case_, {})),
        run_(case_, options()) {
    run_.advance_to(part * case_.end_time);
    bytes_ = separation::saved_bytes(run_.save(), identity_);
    good_ = content_of(bytes_);
    here_ = look();
    is_short_ = true;
    EXPECT_EQ(said(good_), "");
  }

  const json& good() const { return good_; }
  double end_time() const { return case_.end_time; }

  // The message; "" if the run accepts the state, continues and can be saved.
  std::string said(const json& forged) {
    return said_of_bytes(separation::packed(forged));
  }
  std::string said_of_bytes(const std::string& bytes) {
    const std::string message = error_message(
        [&] { run_.restore(separation::saved_state(bytes, identity_)); });
    if (message != "(no error)") {
      EXPECT_TRUE(is_where_it_was()) << message;
      return message;
    }
    run_.advance_to(
        std::min(run_.time() + 2 * case_.output_step, case_.end_time));
    EXPECT_EQ(run_.values().size(), run_.columns().size());
    separation::summary(case_, run_.outcome()).dump();
    separation::saved_bytes(run_.save(), identity_);
    run_.restore(separation::saved_state(bytes_, identity_));
    EXPECT_TRUE(is_where_it_was());
    return "";
  }

 private:
  // A forged body may turn so fast that a run takes millions of steps.
  separation::RunOptions options() {
    separation::RunOptions options;
    options.stop = [this](long steps) {
      return is_short_ && steps > 20 ? "the test" : "";
    };
    return options;
  }
  std::vector<double> look() const {
    const separation::Recorder::Memory& memory = run_.memory();
    std::vector<double> all = run_.values();
    all.push_back(run_.time());
    all.push_back(memory.largest_drift);
    all.push_back(static_cast<double>(memory.notes.size()));
    all.insert(all.end(), memory.rows.numbers.begin(),
               memory.rows.numbers.end());
    for (const auto& body : memory.bodies) all.push_back(body.peak_reaction);
    return all;
  }
  // To the last bit, NaN too.
  bool is_where_it_was() const {
    const std::vector<double> now = look();
    return now.size() == here_.size() &&
           std::memcmp(now.data(), here_.data(), now.size() * sizeof(double)) ==
               0;
  }

  const Case case_;
  const std::string identity_;
  CaseRun run_;
  std::string bytes_;
  json good_;
  std::vector<double> here_;
  bool is_short_ = false;
};

using Pointer = json::json_pointer;

// Long arrays have some of their elements in it, the first and the last too.
void add_places(const json& j, const Pointer& at, std::vector<Pointer>& all) {
  constexpr std::size_t most = 3;
  all.push_back(at);
  if (j.is_object()) {
    for (const auto& [key, value] : j.items()) add_places(value, at / key, all);
  }
  if (!j.is_array()) return;
  const std::size_t step = 1 + j.size() / most;
  for (std::size_t i = 0; i < j.size(); ++i) {
    if (i % step != 0 && i + 1 != j.size()) continue;
    add_places(j[i], at / i, all);
  }
}

std::vector<Pointer> places_of(const json& j) {
  std::vector<Pointer> all;
  add_places(j, Pointer(), all);
  return all;
}

bool is_below(const Pointer& at, const std::string& path) {
  return at.to_string().starts_with(path);
}

// Results that no run computes with.
bool is_told_alone(const Pointer& at) {
  static const std::set<std::string> names = {
      "angle",         "rate",          "rates",         "velocity",
      "first_balance", "largest_drift", "largest_energy"};
  for (Pointer up = at; !up.empty(); up.pop_back()) {
    if (names.contains(up.back())) return true;
  }
  return is_below(at, "/numbers");
}

class Forged : public testing::TestWithParam<const char*> {};
// With balls and axes, rest, locks, free bodies, distances.
INSTANTIATE_TEST_SUITE_P(Cases, Forged,
                         testing::Values("two_stage_turn", "platform",
                                         "slosh"));

TEST_P(Forged, ListsOfOtherLengthsAreRefused) {
  Forgery run(GetParam());
  for (const Pointer& at : places_of(run.good())) {
    const json& there = run.good()[at];
    if (!there.is_array()) continue;
    const auto refused = [&](const json& list) {
      json forged = run.good();
      forged[at] = list;
      return !run.said(forged).empty();
    };
    json shorter = there;
    if (!there.empty()) shorter.erase(shorter.size() - 1);
    // A missing note has no effect on the run.
    const bool may_be_shorter = there.empty() || is_below(at, "/notes");
    EXPECT_TRUE(refused(shorter) || may_be_shorter) << at;
    EXPECT_TRUE(refused(json::array()) || may_be_shorter) << at;
    json longer = there;
    auto& list = longer.get_ref<json::array_t&>();
    list.push_back(there.empty() ? json(0.5) : there.back());
    // Notes may repeat.
    if (is_below(at, "/notes") && !there.empty()) continue;
    EXPECT_TRUE(refused(longer)) << at;
    list.insert(list.end(), 20'000, list.back());
    EXPECT_TRUE(refused(longer)) << at;
  }
}

TEST_P(Forged, RowsThatAreMissingAreRefused) {
  Forgery run(GetParam());
  const auto numbers = run.good().at("numbers").get<std::vector<double>>();
  const auto width = std::ssize(run.good().at("columns"));
  const auto rows = std::ssize(numbers) / width;
  ASSERT_GE(rows, 9);
  for (std::ptrdiff_t row = 0; row < rows; ++row) {
    // At events there are two, and others between output times.
    const double time = numbers[row * width];
    const double outputs = 20 * time / run.end_time();
    if (std::abs(outputs - std::round(outputs)) > 1e-9) continue;
    std::vector<double> others = numbers;
    const auto begin = others.begin() + row * width;
    others.erase(begin, begin + width);
    json forged = run.good();
    forged["numbers"] = others;
    EXPECT_NE(run.said(forged), "") << time;
    // Nor are they exchanged.
    others.insert(others.end(), numbers.begin() + row * width,
                  numbers.begin() + (row + 1) * width);
    forged["numbers"] = others;
    EXPECT_TRUE(!run.said(forged).empty() || row + 1 == rows) << time;
  }
}

TEST_P(Forged, NumbersThatNoRunHasAreRefused) {
  Forgery run(GetParam());
  for (const Pointer& at : places_of(run.good())) {
    const json& there = run.good()[at];
    if (!there.is_number()) continue;
    const auto refused = [&](const json& value) {
      json forged = run.good();
      forged[at] = value;
      return !run.said(forged).empty();
    };
    const bool is_told = is_told_alone(at);
    const bool is_whole = there.is_number_integer();
    const bool may_be_missing = is_below(at, "/simulation/motion/hinge_angles");
    EXPECT_TRUE(refused(NAN) || is_told || may_be_missing) << at;
    EXPECT_TRUE(refused(1e300) || !is_whole) << at;
    EXPECT_TRUE(refused(77) || !is_whole || at.back() == "not_found") << at;
    EXPECT_TRUE(refused(0.5) || !is_whole) << at;
    EXPECT_TRUE(refused("text")) << at;
    EXPECT_TRUE(refused(nullptr)) << at;
    EXPECT_TRUE(refused(json::array({there}))) << at;
    // These at least do no harm.
    for (const double value :
         {infinity, -infinity, -1.0, 0.0, 1e-300, -1e300}) {
      refused(value);
    }
    refused(true);
    refused(std::numeric_limits<std::int64_t>::min());
    refused(std::numeric_limits<std::uint64_t>::max());
  }
}

TEST_P(Forged, TimesThatAreNotOverAreRefused) {
  Forgery run(GetParam());
  for (const Pointer& at : places_of(run.good())) {
    const json& there = run.good()[at];
    const std::string name = at.empty() ? "" : at.back();
    const bool is_time = name.ends_with("time") && name != "rest_time";
    if (!there.is_number() ||
        (!is_time && !is_below(at, "/simulation/history/events"))) {
      continue;
    }
    for (const double time : {-1.0, 1e300, -infinity}) {
      json forged = run.good();
      forged[at] = time;
      EXPECT_NE(run.said(forged), "") << at << ' ' << time;
    }
  }
}

TEST_P(Forged, PartsThatAreMissingAreRefused) {
  Forgery run(GetParam());
  for (const Pointer& at : places_of(run.good())) {
    if (at.empty() || !run.good()[at.parent_pointer()].is_object()) continue;
    json forged = run.good();
    forged[at.parent_pointer()].erase(at.back());
    EXPECT_TRUE(!run.said(forged).empty() || at.to_string() == "/format") << at;
  }
}

TEST(ForgedBytes, OfManyLevelsAreRefused) {
  Forgery run("slosh");
  const std::string good = separation::packed(run.good());
  const std::string line = good.substr(0, good.find('\n') + 1);
  const auto said = [&](const std::string& content) {
    return run.said_of_bytes(with_sum(line + content));
  };
  // Lists, maps, tags, texts and bytes of unknown length in each other.
  for (const char* level : {"\x81", "\xa1", "\xa1\x61\x61", "\xc1", "\x9f",
                            "\xbf", "\x7f", "\x5f", "\x9a\x7f\xff\xff\xff"}) {
    std::string content;
    for (int i = 0; i < 300'000; ++i) content += level;
    EXPECT_EQ(
        said(content),
        "the saved state: the file must be a checkpoint of hinge-separation");
  }
  const std::string name = "the saved state: the file must be a checkpoint";
  for (const std::string& content :
       {std::string(), std::string("\xff"), std::string("\x1b"),
        std::string("\x9b\xff\xff\xff\xff\xff\xff\xff\xff"),
        std::string("\xbb\x80\0\0\0\0\0\0\0", 9), std::string("\x78\xff"),
        std::string("\x80\x80"), std::string("\xf9"), std::string("\0", 1)}) {
    EXPECT_TRUE(said(content).starts_with(name)) << content;
  }
}

}  // namespace
}  // namespace contact::test::forged_state_test
