#include "libcontact/duty/pin_wear.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace contact::detail {
namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

PinWear::PinWear(const LayeredPair& pair, double clearance)
    : circle_(pair),
      gap_(Eigen::VectorXd::Constant(circle_.size(), clearance)),
      worn_(Eigen::VectorXd::Zero(circle_.size())),
      has_lifted_(!(clearance < 0)) {}

double PinWear::next_step() const {
  // Of steps half as long S differs by 2e-5 (duty/pin_wear_test.cpp).
  constexpr double first = 0.004;
  constexpr double growth = 0.1;
  const double unit = circle_.mean_compliance();
  return has_lifted_ ? std::max(first * unit, growth * since_) : growth * unit;
}

const WornCircle::Contact* PinWear::last() const {
  return last_.pressure.size() > 0 ? &last_ : nullptr;
}

// Until p_0 = p_1: C_0 ln(p_0/p_1).
double PinWear::path_to_lift_off(double load) const {
  const double first = load / (pi * circle_.radius());
  const double ratio = -clearance() / circle_.mean_compliance() / first;
  return circle_.mean_compliance() * std::log(std::max(ratio, 1.0));
}

Status PinWear::slide(double load, Path path) {
  if (!has_lifted_) {
    const double to_lift_off = path_to_lift_off(load);
    has_lifted_ = path.both() >= to_lift_off;
    const double share = has_lifted_ ? to_lift_off / path.both() : 1;
    const double hole = share * path.hole;
    const double pin = share * path.pin;
    // Harmonic 0 falls by both, harmonic 1 shifts the centres.
    const double i = -clearance();
    const double fall =
        -i * std::expm1(-(hole + pin) / circle_.mean_compliance());
    Eigen::VectorXd worn =
        hole * load / (pi * circle_.radius()) * circle_.angle().array().cos();
    gap_ += worn;
    gap_.array() += fall;
    worn_ += worn;
    if (hole > 0) worn_.array() += fall * hole / (hole + pin);
    path.hole -= hole;
    path.pin -= pin;
  }
  Status status = Status::ok;
  while (path.both() > 0) {
    const double share = std::min(1.0, next_step() / path.both());
    const CircleSprings step{share * path.hole, share * path.pin};
    const Eigen::VectorXd before = gap_;
    last_ = circle_.wear(load, gap_, step, last());
    if (last_.status != Status::ok) status = last_.status;
    if (step.local > 0) {
      Eigen::VectorXd worn = gap_ - before;
      // Of the mean both have their share.
      worn.array() -= circle_.mean(worn) * step.mean / (step.local + step.mean);
      worn_ += worn;
    }
    since_ += step.local + step.mean;
    if (share == 1) break;
    path.hole -= step.local;
    path.pin -= step.mean;
  }
  return status;
}

WornCircle::Contact PinWear::contact(double load) const {
  return circle_.press(load, gap_, {}, last());
}

double PinWear::worn_area() const {
  return 2 * pi * circle_.radius() * circle_.mean(worn_);
}

}  // namespace contact::detail
