#include "libcontact/pair/fit.hpp"

#include <algorithm>
#include <array>

#include "libcontact/base/check.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace contact {
namespace {

struct SizeRange {
  int up_to_mm;  // from above the one before
  // Tolerances of grades 5 to 9, um.
  std::array<int, 5> tolerances;
  // Deviations of d, e, f, g, h, um: how far a shaft stays below the nominal
  // size; a hole stays as far above it. Letters below d divide some of the
  // ranges, these do not.
  std::array<int, 5> deviations;
};

constexpr std::array<SizeRange, 13> size_ranges = {{
    {3, {4, 6, 10, 14, 25}, {20, 14, 6, 2, 0}},
    {6, {5, 8, 12, 18, 30}, {30, 20, 10, 4, 0}},
    {10, {6, 9, 15, 22, 36}, {40, 25, 13, 5, 0}},
    {18, {8, 11, 18, 27, 43}, {50, 32, 16, 6, 0}},
    {30, {9, 13, 21, 33, 52}, {65, 40, 20, 7, 0}},
    {50, {11, 16, 25, 39, 62}, {80, 50, 25, 9, 0}},
    {80, {13, 19, 30, 46, 74}, {100, 60, 30, 10, 0}},
    {120, {15, 22, 35, 54, 87}, {120, 72, 36, 12, 0}},
    {180, {18, 25, 40, 63, 100}, {145, 85, 43, 14, 0}},
    {250, {20, 29, 46, 72, 115}, {170, 100, 50, 15, 0}},
    {315, {23, 32, 52, 81, 130}, {190, 110, 56, 17, 0}},
    {400, {25, 36, 57, 89, 140}, {210, 125, 62, 18, 0}},
    {500, {27, 40, 63, 97, 155}, {230, 135, 68, 20, 0}},
}};

// Deviations of k, m, n, p, r, s, um: the least height of a shaft above the
// nominal size. -1 stands for limits missing in the published sources
// (data/README.md).
struct PressedRange {
  int up_to_mm;
  std::array<int, 6> deviations;
};

constexpr std::string_view pressed_letters = "kmnprs";
constexpr std::array<PressedRange, 13> pressed_ranges = {{
    {3, {0, 2, 4, 6, 10, 14}},
    {6, {1, 4, 8, 12, 15, 19}},
    {10, {1, 6, 10, 15, 19, 23}},
    {18, {1, 7, 12, 18, 23, 28}},
    {30, {2, 8, 15, 22, 28, 35}},
    {50, {2, 9, 17, 26, 34, 43}},
    {65, {2, 11, 20, 32, 41, 53}},
    {80, {2, 11, 20, 32, 43, 59}},
    {100, {-1, 13, 23, 37, 51, 71}},
    {120, {-1, 13, 23, 37, 54, 79}},
    {140, {-1, 15, 27, 43, 63, 92}},
    {160, {-1, 15, 27, 43, 65, 100}},
    {180, {-1, 15, 27, 43, 68, 108}},
}};

// By division: the doubles nearest to the decimals, as the readers of files and
// options have them.
double from_mm(double length) { return length / 1e3; }
double from_um(double length) { return length / 1e6; }

// How far the two limits of a class are from the nominal size, towards
// clearance.
struct Limits {
  int near_um;
  int far_um;
};

// The first range that reaches a size.
template <class Ranges>
const auto& range_of(const Ranges& ranges, double diameter) {
  return *std::ranges::find_if(
      ranges, [diameter](int up_to) { return diameter <= from_mm(up_to); },
      &Ranges::value_type::up_to_mm);
}

Limits limits_of(double diameter, std::string_view tolerance_class) {
  const SizeRange& range = range_of(size_ranges, diameter);
  const int tolerance = range.tolerances[tolerance_class[1] - '5'];
  if (Fit::shafts.is_other(tolerance_class)) {
    const int above = range_of(pressed_ranges, diameter)
                          .deviations[pressed_letters.find(tolerance_class[0])];
    return {-above - tolerance, -above};
  }
  constexpr std::string_view shafts = "defgh", holes = "DEFGH";
  const auto letter =
      std::min(shafts.find(tolerance_class[0]), holes.find(tolerance_class[0]));
  const int near = range.deviations[letter];
  return {near, near + tolerance};
}

void require_class(const Fit::Classes& classes, const char* what,
                   std::string_view name) {
  if (classes.contains(name)) return;
  throw Error(detail::must_be(
      detail::message("fit: {} = \"{}\"", what, detail::printable(name)),
      classes.rule));
}

}  // namespace

double Fit::largest_size(std::string_view shaft) {
  if (!shafts.is_other(shaft)) return from_mm(size_ranges.back().up_to_mm);
  const auto letter = pressed_letters.find(shaft[0]);
  int largest = 0;
  for (const auto& [up_to_mm, deviations] : pressed_ranges) {
    if (deviations[letter] >= 0) largest = up_to_mm;
  }
  return from_mm(largest);
}

bool Fit::has_size(std::string_view shaft, double diameter) {
  return diameter >= from_mm(size_ranges.front().up_to_mm) &&
         diameter <= largest_size(shaft);
}

Fit::Fit(std::string_view hole, std::string_view shaft, double diameter,
         Fit::Clearance taken)
    : diameter_(diameter), taken_(taken) {
  require_class(Fit::holes, "hole", hole);
  require_class(Fit::shafts, "shaft", shaft);
  detail::require(
      has_size(shaft, diameter), "fit", "diameter", diameter,
      detail::message("0.003 to {} m with {}", largest_size(shaft), shaft));
  name_ = detail::message("{}/{}", hole, shaft);
  const Limits h = limits_of(diameter, hole), s = limits_of(diameter, shaft);
  minimum_um_ = h.near_um + s.near_um;
  maximum_um_ = h.far_um + s.far_um;
  shaft_um_ = -(s.near_um + s.far_um) / 2.0;
}

double Fit::radius() const { return (diameter_ + from_um(shaft_um_)) / 2; }

double Fit::clearance(Fit::Clearance which) const {
  switch (which) {
    case Fit::Clearance::minimum:
      return from_um(minimum_um_);
    case Fit::Clearance::maximum:
      return from_um(maximum_um_);
    case Fit::Clearance::mean:
      break;
  }
  return from_um((minimum_um_ + maximum_um_) / 2.0);
}

std::string to_string(const Fit& fit) {
  constexpr std::array names = {"minimum", "mean", "maximum"};
  const auto um = [&fit](Fit::Clearance which) {
    return fit.clearance(which) * 1e6;
  };
  return detail::message(
      "fit {} at {:.6g} mm: diametral clearance {:.6g} to {:.6g} um; {} {:.6g} "
      "um taken",
      fit.name(), fit.diameter() * 1e3, um(Fit::Clearance::minimum),
      um(Fit::Clearance::maximum), names[static_cast<int>(fit.taken())],
      um(fit.taken()));
}

}  // namespace contact
