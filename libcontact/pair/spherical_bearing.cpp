#include "libcontact/pair/spherical_bearing.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace contact {
namespace {

// A ball and its ring are those of one bore in series E and of a smaller one in
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

// The row of a designation; -1 if there is none.
int row_of(std::string_view designation) {
  std::string name;
  for (const char c : designation.substr(0, designation.find('-'))) {
    if (c != ' ') name += c;
  }
  const bool wide = name.starts_with("GEH");
  if (!wide && !name.starts_with("GE")) return -1;
  const char* const first = name.data() + (wide ? 3 : 2);
  int bore = 0;
  const auto [end, error] =
      std::from_chars(first, name.data() + name.size(), bore);
  if (error != std::errc() || bore <= 0) return -1;
  const std::string_view suffix(end);
  const bool g = wide ? suffix == "ES" : suffix == "FO";
  constexpr std::array<std::string_view, 4> of_e = {"", "E", "ES", "DO"};
  if (!g && (wide || std::ranges::find(of_e, suffix) == of_e.end())) return -1;
  const auto found =
      std::ranges::find(sizes, bore, g ? &Size::bore_g : &Size::bore_e);
  return found == sizes.end() ? -1 : static_cast<int>(found - sizes.begin());
}

}  // namespace

SphericalBearing::SphericalBearing(std::string_view designation,
                                   ClearanceGroup group, Fit::Clearance taken)
    : designation_(designation),
      group_(group),
      taken_(taken),
      size_(row_of(designation)) {
  if (size_ >= 0) return;
  throw Error(detail::must_be(
      detail::message("bearing {}", detail::printable(designation)),
      "of series E, as GE50ES or GE50DO, or G, as GEH50ES or GE50FO, with a "
      "bore of its tables, 6 to 300 mm"));
}

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
  constexpr std::array names = {"C2", "CN", "C3"};
  return names[static_cast<int>(group)];
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
