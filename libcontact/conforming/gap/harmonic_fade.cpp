#include "libcontact/conforming/gap/harmonic_fade.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace contact::detail {
namespace {

// Harmonics of the pressure near the edge, where 1e-7 is enough.
constexpr int most = 400;

}  // namespace

HarmonicFade::HarmonicFade(double margin, int corrected)
    : middle_(0), width_(0), end_(std::max(most, corrected)) {
  // exp(-wide^2/2) and erfc(wide/sqrt 2) are rounding.
  constexpr double wide = 8.5;
  constexpr int first = 2;
  const double width = wide / margin;
  const double end = first + 2 * wide * width;
  if (!(end < end_)) return;
  width_ = width;
  middle_ = first + wide * width;
  end_ = static_cast<int>(std::ceil(end));
}

double HarmonicFade::operator()(int n) const {
  if (width_ == 0) return 1;
  return std::erfc((n - middle_) / (width_ * std::numbers::sqrt2)) / 2;
}

}  // namespace contact::detail
