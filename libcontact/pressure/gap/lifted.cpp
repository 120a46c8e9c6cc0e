#include "libcontact/pressure/gap/lifted.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "libcontact/conforming/gap/ball_gap.hpp"
#include "libcontact/conforming/gap/pin_gap.hpp"

namespace contact::detail {
namespace {

constexpr double pi = std::numbers::pi;

// Before the gap's series.
constexpr int leading = 4;

// Order of magnitude of all columns but p(0).
double unit(double opening) {
  const double sine = std::sin(opening / 2);
  return sine * sine;
}

}  // namespace

// One of the two.
struct LiftedPressure::Gap {
  std::optional<PinGap> pin;
  std::optional<BallGap> ball;

  Gap(JointKind kind, const LayeredPair& pair) {
    if (kind == JointKind::pin) {
      pin.emplace(PinGap::coarse(pair));
    } else {
      ball.emplace(pair);
    }
  }
  GapField field(double opening) const {
    return pin ? pin->field(opening) : ball->field(opening);
  }
  double centre(const GapField& field) const {
    return pin ? pin->centre(field) : ball->centre(field);
  }
};

LiftedPressure::LiftedPressure(JointKind kind, const LayeredPair& pair,
                               double largest)
    : gap_(std::make_unique<const Gap>(kind, pair)),
      thickness_(std::min(pair.relative_thickness(), 1.0)),
      range_(std::log1p(largest / thickness_)) {
  const int count = pair.relative_thickness() < 0.3 ? 48 : 24;
  Eigen::MatrixXd chebyshev(count, count);
  Eigen::MatrixXd values;
  for (int i = 0; i < count; ++i) {
    const double phi = pi * (i + 0.5) / count;
    const double cosine = std::cos(phi / 2);
    const double opening = thickness_ * std::expm1(range_ * cosine * cosine);
    const GapField f = gap_->field(opening);
    if (i == 0) values.resize(count, leading + f.series.size());
    values.row(i) << gap_->centre(f), f.contact.mean_deficit / unit(opening),
        f.contact.gap_shift / unit(opening), f.mean_gap / unit(opening),
        f.series.transpose() / unit(opening);
    for (int k = 0; k < count; ++k) {
      chebyshev(k, i) = (k == 0 ? 1.0 : 2.0) / count * std::cos(k * phi);
    }
  }
  coefficients_ = chebyshev * values;
}

LiftedPressure::~LiftedPressure() = default;

Eigen::RowVectorXd LiftedPressure::row(double opening, int columns) const {
  const double v = 2 * std::log1p(opening / thickness_) / range_ - 1;
  Eigen::RowVectorXd b0 = Eigen::RowVectorXd::Zero(columns);
  Eigen::RowVectorXd b1 = b0;
  for (Eigen::Index k = coefficients_.rows() - 1; k > 0; --k) {
    b1 = 2 * v * b0 - b1 + coefficients_.row(k).head(columns);
    b0.swap(b1);
  }
  return v * b0 - b1 + coefficients_.row(0).head(columns);
}

GapField LiftedPressure::field(double opening) const {
  const Eigen::RowVectorXd values =
      row(opening, static_cast<int>(coefficients_.cols()));
  GapField f{};
  f.opening = opening;
  f.contact.mean_deficit = unit(opening) * values(1);
  f.contact.gap_shift = unit(opening) * values(2);
  f.mean_gap = unit(opening) * values(3);
  f.series = unit(opening) * values.tail(values.size() - leading).transpose();
  return f;
}

double LiftedPressure::mean(double opening) const {
  return 1 - unit(opening) * row(opening, 2)(1);
}

double LiftedPressure::centre(double opening) const {
  return row(opening, 1)(0);
}

double LiftedPressure::pressure(double theta, double opening) const {
  if (opening == 0) return 1 + std::cos(theta);
  const GapField f = field(opening);
  return gap_->pin ? gap_->pin->pressure(f, theta)
                   : gap_->ball->pressure(f, theta);
}

void LiftedPressure::harmonics(double opening, std::span<double> out) const {
  gap_->ball->harmonics(field(opening), out);
}

}  // namespace contact::detail
