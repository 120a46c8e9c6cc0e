
#include "libcontact/base/constants.hpp"
#include "libcontact/duty/steps/pin_wear.hpp"
#include "libcontact/duty/steps/stepped_joint.hpp"

namespace contact::detail {
namespace {

class SteppedPin final : public SteppedJoint {
 public:
  SteppedPin(const JointContact& contact, const WornSeat& before)
      : geometry_(contact.geometry()),
        wear_(bodies_of(contact), geometry_.radial_clearance(),
              Eigen::Map<const Eigen::VectorXd>(
                  before.depths.data(),
                  static_cast<Eigen::Index>(before.depths.size()))),
        before_(before) {}

  int places() const override { return 32; }
  int looks() const override { return 36; }
  // Under a load that moves, whole steps change half-angles by up to 1 deg;
  // more places change nothing.
  double next_step(bool moves) const override {
    return wear_.next_step() * (moves ? 0.5 : 1);
  }

  Status wear(const SeatPath::Place& place, double seat, double inner,
              bool many) override {
    const PinWear::Path path{.hole = seat, .pin = inner};
    return many ? wear_.pass(load_of(place), path)
                : wear_.slide(load_of(place), path);
  }

  Look look(const SeatPath::Place& place) override {
    const Eigen::Vector2d load = load_of(place);
    if (seen_.pressure.size() == 0 || load != seen_load_) {
      seen_ = wear_.contact(load, seen_.pressure.size() > 0 ? &seen_ : nullptr);
      seen_load_ = load;
    }
    const double peak = seen_.pressure.maxCoeff();
    const double sum = 2 * pi * geometry_.radius() * geometry_.length() *
                       seen_.pressure.mean();
    return {.status = seen_.status,
            .half_angle = seen_.half_angle,
            .peak_pressure = peak,
            .peak_slip_pressure = peak,
            .beyond = sum - place.load.norm(),
            .area = 2 * seen_.half_angle * geometry_.length()};
  }

  double volume() const override {
    return wear_.worn_area() * geometry_.length();
  }
  double depth() const override { return wear_.depth(); }
  double clearance() const override { return wear_.clearance(); }
  double mean_pressure_of_force() const override {
    return 1 / (2 * pi * geometry_.radius() * geometry_.length());
  }
  WornSeat worn() const override {
    WornSeat seat = before_;
    seat.depths.assign(wear_.worn().begin(), wear_.worn().end());
    return seat;
  }

 private:
  Eigen::Vector2d load_of(const SeatPath::Place& place) const {
    return place.load.head<2>() / geometry_.length();
  }

  JointGeometry geometry_;
  PinWear wear_;
  WornSeat before_;
  WornCircle::Contact seen_;
  Eigen::Vector2d seen_load_ = {0, 0};
};

}  // namespace

std::unique_ptr<SteppedJoint> stepped_pin(const JointContact& contact,
                                          const WornSeat& before) {
  return std::make_unique<SteppedPin>(contact, before);
}

}  // namespace contact::detail
