#include "cli/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "cli/quantity.hpp"
#include "cli/refuse.hpp"

namespace cli {
namespace {

// More values than a table can use: this detects a mistyped step.
constexpr double most_values = 1e9;

// True if value is a decimal with at most the digits of 10^-k, 1/scale = 10^-k.
// The quotient of two exact integers is rounded like the decimal text.
bool is_decimal(double value, double scale) {
  const double integer = std::nearbyint(value * scale);
  return std::abs(integer) <= 0x1p52 && integer / scale == value;
}

// 1kN:10kN:5, whose 5 may be meant as a step or as a number of values.
void refuse_bare_step(std::string_view option, std::string_view item) {
  const auto parts = split(item, ":");
  if (parts.size() != 3) return;
  const double step = parse_number(parts[2]).value_or(0);
  std::string_view unit = parts[1];
  if (step == 0 || !take_number(unit) || unit.empty()) return;
  const bool is_count = step >= 2 && step == std::floor(step);
  refuse(option, item,
         fmt::format("a range whose step has a unit, as {0}:{1}:{2}{3}{4}",
                     parts[0], parts[1], parts[2], unit,
                     is_count ? fmt::format("; {0}:{1}:log{2} has {2} values "
                                            "in equal ratios",
                                            parts[0], parts[1], parts[2])
                              : ""));
}

}  // namespace

double Sweep::Piece::value(std::size_t i) const {
  if (i == 0) return first;
  if (i + 1 == count) return last;
  const double x = (start + static_cast<double>(i) * step) / scale;
  return kind == Kind::linear ? x : std::pow(10, x);
}

Sweep::Piece Sweep::linear(double start, double stop, double step) {
  double scale = 1;
  bool exact = false;
  // Up to 15 decimals: more do not fit a double.
  for (int k = 0; k <= 15 && !exact; ++k) {
    if (k > 0) scale *= 10;
    exact = is_decimal(start, scale) && is_decimal(stop, scale) &&
            is_decimal(step, scale);
  }
  if (!exact) scale = 1;
  Piece piece;
  piece.start = exact ? std::nearbyint(start * scale) : start;
  piece.step = exact ? std::nearbyint(step * scale) : step;
  piece.scale = scale;

  const double span =
      exact ? std::nearbyint(stop * scale) - piece.start : stop - start;
  // Without exact decimals: rounding of the inputs and the quotient, in steps.
  const double slack =
      exact ? 0
            : 2 * std::numeric_limits<double>::epsilon() *
                  ((std::abs(start) + std::abs(stop)) / std::abs(step));
  const double steps = std::floor(
      (span - (exact ? std::fmod(span, piece.step) : 0)) / piece.step + slack);
  piece.count = static_cast<std::size_t>(std::min(steps, most_values)) + 1;
  piece.first = start;
  piece.last = (piece.start + steps * piece.step) / scale;
  return piece;
}

Sweep::Piece Sweep::logarithmic(double start, double stop, double count) {
  Piece piece;
  piece.kind = Kind::logarithmic;
  // Scaled so that the exponents of round powers of ten are exact.
  piece.start = std::log10(start) * (count - 1);
  piece.step = std::log10(stop) - std::log10(start);
  piece.scale = count - 1;
  piece.first = start;
  piece.last = stop;
  piece.count = static_cast<std::size_t>(std::min(count, 2 * most_values));
  return piece;
}

Sweep::Piece Sweep::parse_piece(std::string_view option, std::string_view text,
                                contact::Dimension dimension) {
  const auto parts = split(text, ":");
  const bool is_log = parts.size() == 3 && parts[2].starts_with("log");
  std::array<double, 3> numbers{};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto number = i == 2 && is_log
                            ? parse_number(parts[2].substr(3))
                            : read_quantity(option, parts[i], dimension);
    if (!number || parts.size() == 2 || parts.size() > 3) {
      refuse(option, text.empty() ? "(empty item)" : text,
             "a value, a list a,b,c, start:stop:step or start:stop:logN");
    }
    numbers[i] = *number;
  }
  const auto [start, stop, step] = numbers;
  if (parts.size() == 1) {
    Piece value;
    value.first = value.last = start;
    return value;
  }
  if (!std::isfinite(start) || !std::isfinite(stop) || !std::isfinite(step)) {
    refuse(option, text, "a range of finite numbers");
  }
  if (is_log) {
    if (!(start > 0 && stop > 0)) {
      refuse(option, text, "a logarithmic range with ends above 0");
    }
    if (step < 2 || step != std::floor(step)) {
      refuse(option, text, "logN with a whole number of values, 2 or more");
    }
    return logarithmic(start, stop, step);
  }
  if (step == 0 || (stop - start) / step < 0) {
    refuse(option, text, "a range whose step leads from start to stop");
  }
  return linear(start, stop, step);
}

Sweep::Sweep(std::string_view option, std::string_view text,
             const Allowed& allowed, contact::Dimension dimension) {
  if (dimension != contact::Dimension::number) {
    for (const auto item : split(text, ",")) refuse_bare_step(option, item);
    refuse_some_units(option, text);
  }
  std::size_t end = 0;
  for (const std::string_view item : split(text, ",")) {
    Piece piece = parse_piece(option, item, dimension);
    if (static_cast<double>(end + piece.count) > most_values) {
      refuse(option, text, "at most 1e9 values");
    }
    for (const double value : {piece.first, piece.last}) {
      if (!allowed.contains(value)) {
        refuse(option, number_text(value), allowed.text());
      }
    }
    piece.end = end += piece.count;
    pieces_.push_back(piece);
  }
}

double Sweep::operator[](std::size_t index) const {
  const auto piece =
      std::upper_bound(pieces_.begin(), pieces_.end(), index,
                       [](std::size_t i, const Piece& p) { return i < p.end; });
  return piece->value(index - (piece->end - piece->count));
}

std::vector<int> whole_numbers(std::string_view option, std::string_view text,
                               int most) {
  const Sweep sweep(option, text, {1, double(most), ""});
  std::vector<int> values;
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    values.push_back(parse_count(option, number_text(sweep[i]), 1, most));
  }
  return values;
}

std::vector<double> spread(const Sweep& sweep, std::size_t most) {
  const std::size_t size = std::min(sweep.size(), most);
  std::vector<double> values;
  for (std::size_t i = 0; i < size; ++i) {
    values.push_back(
        sweep[size == 1 ? 0 : i * (sweep.size() - 1) / (size - 1)]);
  }
  return values;
}

}  // namespace cli
