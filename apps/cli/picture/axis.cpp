#include "cli/picture/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/gnuplot.hpp"
#include "cli/number.hpp"
#include "cli/picture/text_size.hpp"
#include "libcontact/base/constants.hpp"

namespace cli {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 10>
    symbols = {{{"theta0", "θ₀"},
                {"M_t", "Mₜ"},
                {"R_n", "Rₙ"},
                {"R_t", "Rₜ"},
                {"a", "α"},
                {"b", "β"},
                {"w", "Δω"},
                {"p_peak", "peak p"},
                {"pv_max", "peak p v"},
                {"load_parameter", "load parameter"}}};

// Units that take a prefix: not m² (the prefix would be squared), s (ks is
// unusual) or kg (already has one).
bool takes_prefix(std::string_view unit) {
  const std::string_view first = unit.substr(0, unit.find_first_of(" /"));
  return first == "N" || first == "Pa" || first == "W" || first == "J" ||
         first == "m";
}

std::string plain(double value) { return fmt::format("{:.12g}", value); }

// True if no label touches the next one or leaves the canvas' margin.
bool fit(const Ticks& ticks, Run run, double room, bool logarithmic) {
  constexpr double apart = 0.8;    // distance of neighbours' ends
  constexpr double height = 1.15;  // distance of lines
  for (std::size_t i = 1; i < ticks.places.size(); ++i) {
    const double distance =
        room * (ticks.share(ticks.places[i], logarithmic) -
                ticks.share(ticks.places[i - 1], logarithmic));
    const double needed =
        run == Run::up
            ? height
            : (text_width(ticks.labels[i]) + text_width(ticks.labels[i - 1])) /
                      2 +
                  apart;
    if (distance < needed) return false;
  }
  return true;
}

Ticks labelled(const Extent& range, std::vector<double> places) {
  Ticks ticks{range, std::move(places), {}};
  for (const double x : ticks.places) {
    ticks.labels.push_back(fmt::format("{:.6g}", x));
  }
  return ticks;
}

// Multiples of a step.
Ticks stepped(const Extent& extent, double step, bool whole) {
  constexpr double rounding = 1e-9;  // in steps: an end that is one
  const double first = whole ? std::floor(extent.low / step + rounding)
                             : std::ceil(extent.low / step - rounding);
  const double last = whole ? std::ceil(extent.high / step - rounding)
                            : std::floor(extent.high / step + rounding);
  std::vector<double> places;
  for (double n = first; n <= last; ++n)
    places.push_back(n * step + 0.0);  // no -0
  return labelled(whole ? joined(extent, {first * step, last * step}) : extent,
                  std::move(places));
}

// The finest of the round steps that leaves room; at most ten.
Ticks linear_ticks(const Axis& axis, const Extent& extent, Run run, double room,
                   bool whole) {
  constexpr double most = 10;
  const double span = extent.high - extent.low;
  const double power = std::pow(10, std::floor(std::log10(span / most)));
  std::vector<double> steps;
  for (const double n : {1., 2., 5., 10., 20., 50., 100., 200.}) {
    steps.push_back(n * power);
  }
  if (axis.unit == "deg" && span > 100 && span <= 180 * most) {
    steps = {10, 15, 20, 30, 60, 90, 180};
  }
  Ticks ticks;
  for (const double step : steps) {
    if (step * most < span) continue;
    ticks = stepped(extent, step, whole);
    if (fit(ticks, run, room, false)) break;
  }
  return ticks;
}

// Numbered digits in each decade, or only every n-th power of ten.
std::vector<double> in_decades(const Extent& e, std::span<const double> digits,
                               int each) {
  std::vector<double> places;
  const int first = static_cast<int>(std::floor(std::log10(e.low)));
  const int last = static_cast<int>(std::ceil(std::log10(e.high)));
  for (int decade = first; decade <= last; ++decade) {
    if (decade % each != 0) continue;
    for (const double digit : digits) {
      const double x = digit * std::pow(10, decade);
      constexpr double rounding = 1e-9;
      if (x >= (1 - rounding) * e.low && x <= (1 + rounding) * e.high) {
        places.push_back(x);
      }
    }
  }
  return places;
}

// Ticks over the data and no further. gnuplot drops labels exactly at the
// ends: widen the range by 1e-9, which is invisible.
Ticks logarithmic_ticks(const Axis& axis, const Extent& extent, Run run,
                        double room) {
  constexpr double beyond = 1e-9;
  const Extent range{(1 - beyond) * extent.low, (1 + beyond) * extent.high};
  Ticks ticks;
  if (extent.high < 10 * extent.low) {
    ticks = linear_ticks(axis, extent, run, room, false);
    ticks.range = range;
    if (ticks.places.size() >= 3 && fit(ticks, run, room, true)) return ticks;
  }
  constexpr double all[] = {1, 2, 5};
  const auto powers = std::span(all).first(1);
  if (extent.high < 1000 * extent.low) {
    ticks = labelled(range, in_decades(extent, all, 1));
    if (fit(ticks, run, room, true)) return ticks;
  }
  for (int each = 1; each < 100; ++each) {
    ticks = labelled(range, in_decades(extent, powers, each));
    if (fit(ticks, run, room, true)) break;
  }
  return ticks;
}

}  // namespace

std::string shown_symbol(std::string_view symbol) {
  for (const auto& [plain_symbol, shown] : symbols) {
    if (symbol == plain_symbol) return std::string(shown);
  }
  std::string text(symbol);
  std::ranges::replace(text, '_', ' ');
  return text;
}

std::string with_micro(std::string unit) {
  if (unit.starts_with("um")) unit.replace(0, 1, "µ");
  return unit;
}

Axis axis_of(std::string_view symbol, std::string_view meaning,
             contact::Dimension dimension) {
  std::string unit =
      contact::unit_symbol(contact::printed_unit(dimension).ending);
  if (unit.ends_with("^2")) unit.replace(unit.size() - 2, 2, "²");
  const std::string shown = shown_symbol(symbol);
  if (meaning.empty()) return {shown, unit};
  const std::string_view first =
      meaning.substr(0, meaning.find_first_of(",;:"));
  constexpr double longest_letter = 1.6;  // longer texts are words
  return {std::string(first) +
              (text_width(shown) < longest_letter ? ' ' + shown : ""),
          unit};
}

Extent extent_of(std::span<const double> values, bool logarithmic) {
  using contact::detail::infinity;
  Extent all{infinity, -infinity};
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (logarithmic && !(value > 0 && std::isnormal(value))) continue;
    all.low = std::min(all.low, value);
    all.high = std::max(all.high, value);
  }
  return all;
}

Extent joined(const Extent& a, const Extent& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

Prefix prefix_of(const Axis& axis, const Extent& extent) {
  if (!takes_prefix(axis.unit) || extent.is_empty()) return {};
  const double size =
      axis.logarithmic ? std::sqrt(extent.low) * std::sqrt(extent.high)
                       : std::max(std::abs(extent.low), std::abs(extent.high));
  if (size >= 1e9) return {"G", 1e-9};
  if (size >= 1e6) return {"M", 1e-6};
  if (size >= 1e4) return {"k", 1e-3};
  if (size >= 1e-2 || size == 0) return {};
  if (size >= 1e-3) return {"m", 1e3};
  if (size >= 1e-6) return {"µ", 1e6};
  return {"n", 1e9};
}

std::string label_of(const Axis& axis, const Prefix& prefix) {
  if (axis.unit.empty()) return axis.name;
  return fmt::format("{}, {}{}", axis.name, prefix.name, axis.unit);
}

double Ticks::share(double number, bool logarithmic) const {
  const auto [low, high] = range;
  const double share = logarithmic
                           ? std::log(number / low) / std::log(high / low)
                           : (number - low) / (high - low);
  return std::isfinite(share) ? std::clamp(share, 0., 1.) : 0.5;
}

double Ticks::width() const {
  double widest = 0;
  for (const std::string& label : labels) {
    widest = std::max(widest, text_width(label));
  }
  return widest;
}

std::string Ticks::script(std::string_view axis, bool labels_too) const {
  std::string text =
      fmt::format("set {}range [{}:{}]\nset {}tics (", axis,
                  number_text(range.low), number_text(range.high), axis);
  for (std::size_t i = 0; i < places.size(); ++i) {
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ",
                        gnuplot_text(labels_too ? labels[i] : ""),
                        plain(places[i]));
  }
  return text + ")\n";
}

Ticks ticks_of(const Axis& axis, const Extent& extent, Run run, double room,
               bool whole) {
  if (extent.is_empty()) return {{0, 1}};
  // Widens the range of a single value, or of nearly equal values.
  const double span = extent.high - extent.low;
  const double size = std::max(std::abs(extent.low), std::abs(extent.high));
  if (!(span > 1e-9 * size)) {
    const double margin = size > 0 ? 0.1 * size : 1;
    return linear_ticks(axis, {extent.low - margin, extent.high + margin}, run,
                        room, whole);
  }
  return axis.logarithmic ? logarithmic_ticks(axis, extent, run, room)
                          : linear_ticks(axis, extent, run, room, whole);
}

}  // namespace cli
