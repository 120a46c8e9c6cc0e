#include "libcontact/pressure/gap/lifted.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "libcontact/conforming/gap/ball_gap.hpp"
#include "libcontact/conforming/gap/pin_gap.hpp"

namespace contact::detail {
namespace {

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
      series_(std::min(pair.relative_thickness(), 1.0), largest) {
  series_.tabulate(
      pair.relative_thickness() < 0.3 ? 48 : 24, [this](double opening) {
        const GapField f = gap_->field(opening);
        Eigen::RowVectorXd row(leading + f.series.size());
        row << gap_->centre(f), f.contact.mean_deficit / unit(opening),
            f.contact.gap_shift / unit(opening), f.mean_gap / unit(opening),
            f.series.transpose() / unit(opening);
        return row;
      });
}

LiftedPressure::~LiftedPressure() = default;

GapField LiftedPressure::field(double opening) const {
  const Eigen::RowVectorXd values = series_.at(opening, series_.columns());
  GapField f{};
  f.opening = opening;
  f.contact.mean_deficit = unit(opening) * values(1);
  f.contact.gap_shift = unit(opening) * values(2);
  f.mean_gap = unit(opening) * values(3);
  f.series = unit(opening) * values.tail(values.size() - leading).transpose();
  return f;
}

double LiftedPressure::mean(double opening) const {
  return 1 - unit(opening) * series_.at(opening, 2)(1);
}

double LiftedPressure::centre(double opening) const {
  return series_.at(opening, 1)(0);
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
