#include "libcontact/pair/spherical_bearing.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace contact {
namespace {

// A ball and its ring belong to one bore in series E and to a smaller one in
// series G, whose inner ring is wider.
struct Size {
  double ball_mm;
  int ring_mm;
  int bore_e;
  int bore_g;  // 0: none
};
constexpr std::array<Size, 29> sizes = {{
    {10, 4, 6, 0},        {13, 5, 8, 6},        {16, 6, 10, 8},
    {18, 7, 12, 10},      {22, 9, 15, 12},      {25, 10, 17, 15},
    {29, 12, 20, 17},     {35.5, 16, 25, 20},   {40.7, 18, 30, 25},
    {47, 20, 35, 30},     {53, 22, 40, 35},     {60, 25, 45, 40},
    {66, 28, 50, 45},     {80, 36, 60, 50},     {92, 40, 70, 60},
    {105, 45, 80, 70},    {115, 50, 90, 80},    {130, 55, 100, 90},
    {140, 55, 110, 100},  {160, 70, 120, 110},  {180, 70, 140, 120},
    {200, 80, 160, 140},  {225, 80, 180, 160},  {250, 100, 200, 180},
    {275, 100, 220, 200}, {300, 100, 240, 220}, {325, 110, 260, 240},
    {350, 120, 280, 260}, {375, 120, 300, 280},
}};

// Limits of the groups: C2 lies between the first two, C3 between the last two.
struct Clearances {
  double up_to_ball_mm;
  std::array<int, 4> limits_um;
};
constexpr std::array<Clearances, 9> clearances = {{
    {18, {8, 32, 68, 104}},
    {29, {10, 40, 82, 124}},
    {47, {12, 50, 100, 150}},
    {80, {15, 60, 120, 180}},
    {115, {18, 72, 142, 212}},
    {180, {18, 85, 165, 245}},
    {250, {18, 100, 192, 284}},
    {300, {18, 110, 214, 318}},
    {375, {18, 125, 239, 353}},
}};

constexpr std::array<std::string_view, 3> group_names = {"C2", "CN", "C3"};

// A designation in its parts: GE 50 DO-2RS, in small or capital letters.
struct Name {
  bool wide = false;  // GEH
  int bore = 0;       // mm; 0: no name of such a bearing
  std::string series = {};
  std::string suffix = {};
};

bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

void drop(std::string_view& text, std::string_view what) {
  text.remove_prefix(std::min(text.find_first_not_of(what), text.size()));
}

Name parsed(std::string_view designation) {
  std::string capitals(designation);
  for (char& c : capitals) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  std::string_view text = capitals;
  drop(text, " ");
  Name name;
  name.wide = text.starts_with("GEH");
  if (!text.starts_with("GE")) return {};
  text.remove_prefix(name.wide ? 3 : 2);
  drop(text, " ");
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), name.bore);
  if (error != std::errc()) return {};
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  drop(text, " -");
  auto letters = static_cast<std::size_t>(
      std::find_if_not(text.begin(), text.end(), is_letter) - text.begin());
  const bool is_group =  // GE50-C3
      letters == 1 && text[0] == 'C' && text.size() > 1 && is_digit(text[1]);
  if (is_group) letters = 0;
  name.series = text.substr(0, letters);
  name.suffix = text.substr(letters);
  return name;
}

// The row of a bore in series E or G; -1 if there is none.
int row_of(int bore, int Size::*in_series) {
  const auto found = std::ranges::find(sizes, bore, in_series);
  return found == sizes.end() || bore <= 0
             ? -1
             : static_cast<int>(found - sizes.begin());
}

// The row of a bearing steel on steel.
int row_of(const Name& name) {
  constexpr std::array<std::string_view, 4> of_e = {"", "E", "ES", "DO"};
  const bool g = name.wide ? name.series == "ES" : name.series == "FO";
  if (!g && (name.wide || std::ranges::find(of_e, name.series) == of_e.end())) {
    return -1;
  }
  return row_of(name.bore, g ? &Size::bore_g : &Size::bore_e);
}

// The row of a lined bearing with the ball and ring of series E or G.
int row_of_lined(const Name& name) {
  constexpr std::array<std::string_view, 9> of_e = {
      "C", "CJ", "TE", "TXE", "TXA", "TGR", "TXGR", "ET", "UK"};
  if (name.series == "FW") return row_of(name.bore, &Size::bore_g);
  return std::ranges::find(of_e, name.series) == of_e.end() || name.wide
             ? -1
             : row_of(name.bore, &Size::bore_e);
}

// Throws where a suffix names another clearance than `group`.
void check_group(std::string_view bearing, const Name& name,
                 ClearanceGroup group) {
  const auto is_part_of_word = [](char c) {
    return is_letter(c) || is_digit(c);
  };
  for (std::size_t i = 0; i < group_names.size(); ++i) {
    const std::string_view word = group_names[i];
    const std::size_t at = name.suffix.find(word);
    if (at == name.suffix.npos || i == static_cast<std::size_t>(group) ||
        (at > 0 && is_part_of_word(name.suffix[at - 1])) ||
        (at + 2 < name.suffix.size() && is_part_of_word(name.suffix[at + 2]))) {
      continue;
    }
    throw Error(detail::needs(
        bearing,
        detail::message("the clearance group {} that it names", word)));
  }
}

int checked_row(std::string_view designation, ClearanceGroup group) {
  const std::string bearing =
      detail::message("bearing {}", detail::printable(designation));
  const Name name = parsed(designation);
  if (const int row = row_of(name); row >= 0) {
    check_group(bearing, name, group);
    return row;
  }
  if (const int row = row_of_lined(name); row >= 0) {
    throw Error(detail::needs(
        bearing,
        detail::message(
            "a joint file, as series {} is lined: "
            "data/joints/spherical_plain_bearing_ge50.toml with (--set) "
            "geometry.diameter_mm={:.6g}, seat.ring_width_mm={}, and the "
            "maker's clearance, liner and friction",
            name.series, sizes[row].ball_mm, sizes[row].ring_mm)));
  }
  throw Error(detail::must_be(
      bearing,
      "of series E, as GE50ES or GE50DO, or G, as GEH50ES or GE50FO, with a "
      "bore of its tables, 6 to 300 mm"));
}

}  // namespace

SphericalBearing::SphericalBearing(std::string_view designation,
                                   ClearanceGroup group, Fit::Clearance taken)
    : designation_(designation),
      group_(group),
      taken_(taken),
      size_(checked_row(designation, group)) {}

double SphericalBearing::ball_diameter() const {
  return sizes[size_].ball_mm / 1e3;
}

double SphericalBearing::ring_width() const {
  return sizes[size_].ring_mm / 1e3;
}

double SphericalBearing::clearance(Fit::Clearance which) const {
  const auto& limits =
      std::ranges::find_if(
          clearances,
          [&](double up_to) { return sizes[size_].ball_mm <= up_to; },
          &Clearances::up_to_ball_mm)
          ->limits_um;
  const int low = limits[static_cast<int>(group_)];
  const int high = limits[static_cast<int>(group_) + 1];
  switch (which) {
    case Fit::Clearance::minimum:
      return low / 1e6;
    case Fit::Clearance::maximum:
      return high / 1e6;
    case Fit::Clearance::mean:
      break;
  }
  return (low + high) / 2.0 / 1e6;
}

std::string to_string(ClearanceGroup group) {
  return std::string(group_names[static_cast<int>(group)]);
}

std::string to_string(const SphericalBearing& bearing) {
  constexpr std::array names = {"minimum", "mean", "maximum"};
  const auto um = [&](Fit::Clearance which) {
    return bearing.clearance(which) * 1e6;
  };
  return detail::message(
      "bearing {} {}: ball of {:.6g} mm, ring of {:.6g} mm, diametral "
      "clearance "
      "{:.6g} to {:.6g} um; {} {:.6g} um taken",
      bearing.designation(), to_string(bearing.group()),
      bearing.ball_diameter() * 1e3, bearing.ring_width() * 1e3,
      um(Fit::Clearance::minimum), um(Fit::Clearance::maximum),
      names[static_cast<int>(bearing.taken())], um(bearing.taken()));
}

}  // namespace contact
