#pragma once

/// Sums over the harmonics of open contacts (PinGap, BallGap).
namespace contact::detail {

/// How far sums over the harmonics of an open contact's pressure have to go for
/// a place that is `margin` away from the gap, rad: there the sums are of a
/// smooth function, and terms that fade out over a width s leave exp(-(s
/// margin)^2/2) of the gap's edge.
class HarmonicFade {
 public:
  /// @param corrected  harmonics that walls change: so many terms are there, or
  ///                   400, where the margin is too small for fading
  HarmonicFade(double margin, int corrected);

  int end() const { return end_; }
  /// Weight of term n < end().
  double operator()(int n) const;

 private:
  double middle_;
  double width_;  // 0: none
  int end_;
};

}  // namespace contact::detail
