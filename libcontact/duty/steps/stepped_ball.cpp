#include <Eigen/Geometry>
#include <limits>
#include <numbers>

#include "libcontact/base/units.hpp"
#include "libcontact/duty/steps/stepped_joint.hpp"
#include "libcontact/duty/steps/worn_sphere.hpp"

namespace contact::detail {
namespace {

using Eigen::Vector3d;
using Map = WornSphere::Map;

class SteppedBall final : public SteppedJoint {
 public:
  // Worn contacts end below 90 deg about their load, so that the grid, which
  // goes as far beyond the farthest place, has all of them.
  SteppedBall(const JointContact& contact, const WornSeat& seat, double reach)
      : geometry_(contact.geometry()),
        sphere_(bodies_of(contact), seat.pole, reach),
        seat_(seat),
        worn_(Map::Zero(sphere_.latitudes(), sphere_.longitudes())) {
    if (!seat.depths.empty()) {
      worn_ =
          Eigen::Map<const Map>(seat.depths.data(), worn_.rows(), worn_.cols());
    }
  }

  int places() const override { return 16; }
  int looks() const override { return 24; }
  double next_step(bool /*moves*/) const override {
    constexpr double first = 0.02;
    constexpr double growth = 0.2;
    return std::max(first * compliance_, growth * since_);
  }

  Status wear(const SeatPath::Place& place, double seat, double /*inner*/,
              bool /*many*/) override {
    Map springs = slips(place.axis) * seat;
    last_ = sphere_.press(place.load, gap(), springs, last());
    worn_ += springs.cwiseProduct(last_.pressure);
    since_ += seat;
    return last_.status;
  }

  Look look(const SeatPath::Place& place) override {
    seen_ = sphere_.press(place.load, gap(), {},
                          seen_.pressure.size() > 0 ? &seen_ : last());
    const Map& p = seen_.pressure;
    Look look{.status = seen_.status,
              .half_angle = seen_.half_angle,
              .peak_pressure = p.maxCoeff()};
    Vector3d moment = Vector3d::Zero();
    double along = 0;
    for (int i = 0; i < p.rows(); ++i) {
      for (int j = 0; j < p.cols(); ++j) {
        if (!(p(i, j) > 0)) continue;
        const Vector3d r = sphere_.point(i, j);
        const Vector3d slip = place.axis.cross(r);
        const double w = slip.norm();
        const double force = p(i, j) * sphere_.area(i);
        look.peak_slip_pressure =
            std::max(look.peak_slip_pressure, p(i, j) * w);
        if (w > 0) moment += force * r.cross(slip / w);
        along += force * w;
        look.area +=
            w * sphere_.area(i) / geometry_.radius() / geometry_.radius();
      }
    }
    look.beyond = along - place.load.norm();
    look.tilt = along > 0 ? moment.norm() / along : 1;
    return look;
  }

  double volume() const override {
    double sum = 0;
    for (int i = 0; i < worn_.rows(); ++i) {
      sum += worn_.row(i).sum() * sphere_.area(i);
    }
    return sum;
  }
  double depth() const override { return worn_.maxCoeff(); }
  double clearance() const override {
    return std::numeric_limits<double>::quiet_NaN();
  }
  double mean_pressure_of_force() const override {
    const double rho = geometry_.radius();
    return 1 / (4 * std::numbers::pi * rho * rho);
  }
  WornSeat worn() const override {
    WornSeat seat = seat_;
    seat.depths.assign(worn_.data(), worn_.data() + worn_.size());
    return seat;
  }

 private:
  Map gap() const {
    return (worn_.array() + geometry_.radial_clearance()).matrix();
  }
  // w = |Dw x r|/|Dw| at the cells.
  Map slips(const Vector3d& axis) const {
    Map w(worn_.rows(), worn_.cols());
    for (int i = 0; i < w.rows(); ++i) {
      for (int j = 0; j < w.cols(); ++j) {
        w(i, j) = axis.cross(sphere_.point(i, j)).norm();
      }
    }
    return w;
  }
  const WornSphere::Contact* last() const {
    return last_.pressure.size() > 0 ? &last_ : nullptr;
  }

  JointGeometry geometry_;
  WornSphere sphere_;
  WornSeat seat_;
  Map worn_;
  double compliance_ = sphere_.compliance();
  double since_ = 0;
  WornSphere::Contact last_;
  WornSphere::Contact seen_;
};

}  // namespace

std::unique_ptr<SteppedJoint> stepped_ball(const JointContact& contact,
                                           const SeatPath& path,
                                           const WornSeat& before) {
  WornSeat seat = before;
  if (before.depths.empty()) {
    seat.pole = path.middle();
    seat.reach =
        std::min(path.reach(seat.pole) + 90 * degree, std::numbers::pi);
  }
  return std::make_unique<SteppedBall>(contact, seat, seat.reach);
}

}  // namespace contact::detail
