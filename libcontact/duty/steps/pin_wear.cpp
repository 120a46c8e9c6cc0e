#include "libcontact/duty/steps/pin_wear.hpp"

#include <algorithm>
#include <cmath>

#include "libcontact/base/constants.hpp"

namespace contact::detail {
PinWear::PinWear(const LayeredPair& pair, double clearance,
                 const Eigen::VectorXd& worn)
    : circle_(pair),
      worn_(worn.size() > 0 ? worn : Eigen::VectorXd::Zero(circle_.size())),
      has_lifted_(!(clearance < 0) || worn.size() > 0) {
  gap_ = worn_.array() + clearance;
}

double PinWear::next_step() const {
  // Halving these steps changes S by 2e-5 (duty/pin_wear_test.cpp).
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

// While it is closed all round, and takes that from the path.
void PinWear::close(const Eigen::Vector2d& load, Path& path) {
  if (has_lifted_) return;
  const double to_lift_off = path_to_lift_off(load.norm());
  has_lifted_ = path.both() >= to_lift_off;
  const double share = has_lifted_ ? to_lift_off / path.both() : 1;
  const double hole = share * path.hole;
  const double pin = share * path.pin;
  // Harmonic 0 falls by both, harmonic 1 shifts the centres.
  const double i = -clearance();
  const double fall =
      -i * std::expm1(-(hole + pin) / circle_.mean_compliance());
  const Eigen::VectorXd worn =
      hole / (pi * circle_.radius()) * circle_.lever() * load;
  gap_ += worn;
  gap_.array() += fall;
  worn_ += worn;
  if (hole > 0) worn_.array() += fall * hole / (hole + pin);
  path.hole -= hole;
  path.pin -= pin;
}

template <class Step>
Status PinWear::step(const CircleSprings& growth, const Step& contact) {
  const Eigen::VectorXd before = gap_;
  last_ = contact();
  if (growth.local > 0) {
    Eigen::VectorXd worn = gap_ - before;
    // Both have their share of the mean.
    worn.array() -= worn.mean() * growth.mean / (growth.local + growth.mean);
    worn_ += worn;
  }
  since_ += growth.local + growth.mean;
  return last_.status;
}

Status PinWear::slide(const Eigen::Vector2d& load, Path path) {
  close(load, path);
  Status status = Status::ok;
  while (path.both() > 0) {
    const double share = std::min(1.0, next_step() / path.both());
    const CircleSprings part{share * path.hole, share * path.pin};
    const Status now =
        step(part, [&] { return circle_.wear(load, gap_, part, last()); });
    if (now != Status::ok) status = now;
    if (share == 1) break;
    path.hole -= part.local;
    path.pin -= part.mean;
  }
  return status;
}

Status PinWear::pass(const Eigen::Vector2d& load, Path path) {
  close(load, path);
  if (!(path.both() > 0)) return Status::ok;
  const CircleSprings part{path.hole, path.pin};
  return step(part, [&] {
    WornCircle::Contact contact = circle_.press(load, gap_, part, last());
    gap_ += part.local * contact.pressure;
    gap_.array() += part.mean * contact.pressure.mean();
    return contact;
  });
}

WornCircle::Contact PinWear::contact(const Eigen::Vector2d& load,
                                     const WornCircle::Contact* last) const {
  return circle_.press(load, gap_, {}, last != nullptr ? last : this->last());
}

double PinWear::worn_area() const {
  return 2 * pi * circle_.radius() * worn_.mean();
}

}  // namespace contact::detail
