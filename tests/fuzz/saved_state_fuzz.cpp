// Saved runs with arbitrary content: a run is restored and continues, or
// rejects them with one contact::Error and keeps its state.
//
// Input that begins with 0 is followed by the CBOR of a state. Otherwise every
// four bytes replace one place of a valid state, given by the first two bytes,
// by one of several values, selected by the third and built from the fourth.
#include <fmt/format.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz.hpp"
#include "libcontact/base/error.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/results/cbor.hpp"
#include "separation/results/saved_state.hpp"
#include "separation/results/state_json.hpp"
#include "separation/results/summary.hpp"
#include "support/toml_text.hpp"

namespace {

using contact::test::operator""_toml;
using nlohmann::json;
using separation::Case;
// A ball on a lock that has opened, and a wheel that comes to rest.
const std::string text = R"(
name = "two"
[run]; end_time_s = 2; output_step_s = 0.1
[carrier]; name = "core"; mass_kg = 100; principal_inertia_kg_m2 = [10, 12, 14]
start = { angular_velocity_rad_per_s = [0.1, -0.2, 0.3] }
[[carrier.shape]]; kind = "capsule"; from_m = [0, 0, 0]; to_m = [0.1, 0, 0]
radius_m = 0.4
[[body]]; name = "tip"; mass_kg = 20; com_m = [0.2, 0.1, 0]
principal_inertia_kg_m2 = [1, 2, 2.5]; lock.body_point_m = [0.5, 0, 0]
[[body.shape]]; kind = "capsule"; from_m = [0, 0, 0]; to_m = [0.1, 0, 0]
radius_m = 0.1
[body.hinge]; kind = "ball"; carrier_point_m = [1, 0, 0]
[[body.hinge.joint]]; name = "ball"; kind = "ball"
geometry = { radius_mm = 30, radial_clearance_um = 60 }
materials.inner = { youngs_modulus_GPa = 200, poissons_ratio = 0.3 }
materials.outer = { youngs_modulus_GPa = 200, poissons_ratio = 0.3 }
friction = { coefficient = 0.2, adhesion_MPa = 1 }
[[body]]; name = "wheel"; mass_kg = 8
principal_inertia_kg_m2 = [0.4, 0.4, 0.7]; start.rate_rpm = 20
[body.hinge]; kind = "axis"; carrier_point_m = [-0.5, 0, 0.5]; axis = [0, 0, 1]
[[body.hinge.joint]]; name = "pin"; kind = "pin"
geometry = { radius_mm = 15, radial_clearance_um = 30, length_mm = 20 }
materials.inner = { youngs_modulus_GPa = 200, poissons_ratio = 0.3 }
materials.outer = { youngs_modulus_GPa = 200, poissons_ratio = 0.3 }
friction = { coefficient = 0.2 }
[[event]]; name = "lock opens"; time_s = 0.4; breaks = "lock"; bodies = ["tip"]
[[event]]; name = "tip leaves"; after = "lock opens"; delay_s = 0.7
breaks = "hinge"; bodies = ["tip"]
[[force]]; name = "pusher"; kind = "pusher"; body = "tip"
point_m = [0.1, 0.3, 0]; carrier_point_m = [1.1, 0.3, 0]
direction = [-0.5, 1, 0.2]; first_force_N = 200; last_force_N = 50
stroke_mm = 60
[[clearance]]; a = "core"; b = "tip"
)"_toml;

using contact::test::check;

// Tells a run that has changed from one that has not.
struct Sight {
  explicit Sight(const separation::Run& run)
      : time(run.time()),
        values(run.values()),
        rows(run.memory().rows.numbers),
        notes(run.memory().notes.size()) {}
  bool operator==(const Sight& other) const {
    return time == other.time && notes == other.notes &&
           same(values, other.values) && same(rows, other.rows);
  }
  // NaN too.
  static bool same(const std::vector<double>& a, const std::vector<double>& b) {
    return std::ranges::equal(a, b, [](double x, double y) {
      return x == y || (std::isnan(x) && std::isnan(y));
    });
  }

  double time;
  std::vector<double> values, rows;
  std::size_t notes;
};

/// A run in the middle.
struct Subject {
  Subject() : of(separation::parse_case(text, "fuzz")), run(of, options()) {
    run.advance_to(0.7);
    identity = separation::identity_of(of, {});
    good = run.save();
    json_of_good = {{"identity", identity},
                    {"simulation", good.simulation},
                    {"memory", good.memory},
                    {"columns", good.memory.rows.columns},
                    {"numbers", good.memory.rows.numbers},
                    {"notes", good.memory.notes}};
    is_short = true;
  }

  // A forged body may turn so fast that a run takes millions of steps.
  separation::RunOptions options() {
    separation::RunOptions options;
    options.stop = [this](long steps) {
      return is_short && steps > 20 ? "the test" : "";
    };
    return options;
  }

  bool is_short = false;
  Case of;
  separation::Run run;
  std::string identity;
  separation::RunState good;
  json json_of_good;
};

void add_places(json& j, std::vector<json*>& all) {
  all.push_back(&j);
  if (!j.is_structured()) return;
  for (json& inside : j) add_places(inside, all);
}

json value(std::uint8_t which, std::uint8_t of, const json& before) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  switch (which % 12) {
    case 0:
      return NAN;
    case 1:
      return of % 2 == 0 ? infinity : -infinity;
    case 2:
      return std::ldexp(of % 2 == 0 ? 1 : -1, 8 * of - 1020);
    case 3:
      return of;
    case 4:
      return -of;
    case 5:
      return of / 255.0;
    case 6:
      return json::array();
    case 7:
      return std::vector<json>(of, before);
    case 8:
      return std::vector<double>(std::size_t{1} << of % 17, 0.5);
    case 9:
      return std::string(of, 'a');
    case 10:
      return before.is_number() ? json(before.get<double>() * (1 + of))
                                : json();
    default:
      return of % 2 == 0;
  }
}

json forged(std::string_view bytes, const json& good) {
  json j = good;
  for (; bytes.size() >= 4; bytes.remove_prefix(4)) {
    const auto at = [&](int i) { return static_cast<std::uint8_t>(bytes[i]); };
    std::vector<json*> places;
    add_places(j, places);
    // Copies of copies would fill the memory.
    if (places.size() > 4000) break;
    json& place = *places[(at(0) << 8U | at(1)) % places.size()];
    place = value(at(2), at(3), json(place));
  }
  return j;
}

std::string with_sum(std::string_view content) {
  // As packed(), which packs JSON alone.
  const std::string empty = separation::packed(json::object());
  std::string bytes = empty.substr(0, empty.find('\n') + 1);
  bytes += content;
  boost::crc_32_type sum;
  sum.process_bytes(bytes.data(), bytes.size());
  return bytes + fmt::format("{:08x}", sum.checksum());
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  static Subject subject;
  separation::Run& run = subject.run;
  std::string_view input(reinterpret_cast<const char*>(data), size);
  std::string content;
  if (input.starts_with('\0')) {
    content = input.substr(1);
  } else {
    json::to_cbor(forged(input, subject.json_of_good), content);
  }
  const std::string bytes = with_sum(content);
  const Sight before(run);
  try {
    run.restore(separation::saved_state(bytes, subject.identity));
    run.advance_to(std::min(run.time() + 0.25, subject.of.end_time));
    check(run.values().size() == run.columns().size());
    separation::summary(subject.of, run.outcome()).dump();
    separation::saved_bytes(run.save(), subject.identity);
    run.restore(subject.good);
    check(Sight(run) == before);
  } catch (const contact::Error& error) {
    check(Sight(run) == before);
    const std::string message = error.what();
    check(message.find_first_of("\n\r") == message.npos);
  }
  return 0;
}
