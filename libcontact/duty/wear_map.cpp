#include "libcontact/duty/wear_map.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/duty/wear_check.hpp"
#include "libcontact/pressure/profile.hpp"

namespace contact {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

// Cross-shear of work done along directions, sum of |f| d d^T: one eigenvalue
// is 0, the others have this sum and product.
double cross_shear(const Matrix3d& work) {
  const double sum = work.trace();
  if (sum == 0) return std::numeric_limits<double>::quiet_NaN();
  const double product = (sum * sum - work.squaredNorm()) / 2;
  const double root = std::sqrt(std::max(sum * sum - 4 * product, 0.0));
  return std::max(2 * product / (sum + root), 0.0) / sum;
}

}  // namespace

struct WearMap::Instant {
  detail::PressureProfile profile;
  Vector3d centre;          // centre of the contact
  double chord;             // from there to the edge
  Vector3d slip;            // times a point: slip, m
  double pressure_unit;     // Pa
  double uniform_pressure;  // Pa, all round: of an interference
  /// p at a place, Pa, of a contact at a rim, instead of all but the slip.
  std::function<double(const Vector3d&)> confined = {};

  double pressure(const Vector3d& point) const {
    if (confined) return confined(point);
    const double from_centre = (point - centre).norm();
    if (from_centre >= chord && uniform_pressure == 0) return 0;
    const double theta = 2 * std::asin(std::min(from_centre / 2, 1.0));
    return pressure_unit * profile.pressure(theta) + uniform_pressure;
  }
};

void detail::check_wear(const JointCycle& cycle) {
  const JointCycle::Instant widest = cycle.largest(
      [](const JointCycle::Instant& i) { return i.solution.half_angle; });
  const double half_angle = widest.solution.half_angle;
  if (half_angle <= pi / 2) return;
  throw Error(
      must_be(message("the half-angle of a joint that wears, {:.4g} deg at "
                      "{:.4g} s,",
                      half_angle / degree, widest.time),
              "at most 90 deg"));
}

// The instant of a contact about a centre that slides by `turn`, both in the
// body's axes.
WearMap::Instant WearMap::instant(const JointContact& contact,
                                  const JointSolution& s,
                                  const Vector3d& centre,
                                  const Vector3d& turn) {
  return {{contact.pressure_law(), s.half_angle},
          centre,
          2 * std::sin(s.half_angle / 2),
          contact.geometry().radius() * turn,
          contact.pressure_unit(s.normal_force),
          contact.uniform_pressure(s.normal_force, s.half_angle)};
}

WearMap::WearMap(const JointCycle& cycle, JointBody body)
    : geometry_(cycle.contact().geometry()), total_(cycle.sums().pv) {
  if (geometry_.radial_clearance() > 0) detail::check_wear(cycle);
  std::vector<Instant> instants;
  for (const JointCycle::Instant& point : cycle.gauss_points()) {
    const JointSolution& s = point.solution;
    if (s.state != JointState::sliding) continue;
    const Eigen::Quaterniond to_body = body == JointBody::body
                                           ? point.state.turn.conjugate()
                                           : Eigen::Quaterniond::Identity();
    instants.push_back(
        instant(cycle.contact(), s, to_body * cycle.sliding(point).centre(),
                point.weight * (to_body * point.state.angular_velocity)));
  }
  instants_ = std::make_shared<const std::vector<Instant>>(std::move(instants));
}

WearMap::WearMap(const SeatCycle& cycle, JointBody body)
    : geometry_(cycle.joint()->unbounded().contact().geometry()),
      total_(cycle.pv_integral()) {
  const auto joint = cycle.joint();
  const Joint& unbounded = joint->unbounded();
  std::vector<Instant> instants;
  for (const SeatCycle::Instant& row : cycle.rows()) {
    const SeatJointSolution& s = row.solution;
    if (s.contact.status != SeatStatus::ok) continue;
    const Eigen::Quaterniond to_body = body == geometry_.inner_body()
                                           ? row.to_ball
                                           : Eigen::Quaterniond::Identity();
    const JointSolution free = unbounded.solve(
        {.reaction = s.reaction, .angular_velocity = row.angular_velocity});
    const Vector3d centre =
        SlidingContact(unbounded.contact(), free, row.angular_velocity)
            .centre();
    Instant& added = instants.emplace_back(
        instant(unbounded.contact(), free, to_body * centre,
                row.weight * (to_body * row.angular_velocity)));
    if (s.contact.is_free) continue;
    added.confined = [joint, s, to_body](const Vector3d& point) {
      return joint->pressure_off_rims(s, to_body.conjugate() * point);
    };
  }
  instants_ = std::make_shared<const std::vector<Instant>>(std::move(instants));
}

WearMap::Wear WearMap::at(const Vector3d& point) const {
  double pv = 0;
  Matrix3d work = Matrix3d::Zero();
  for (const Instant& i : *instants_) {
    const double p = i.pressure(point);
    if (p == 0) continue;
    const Vector3d slip = i.slip.cross(point);
    const double length = slip.norm();
    if (length == 0) continue;
    pv += p * length;
    work += p / length * slip * slip.transpose();
  }
  return {pv, cross_shear(work)};
}

std::vector<Vector3d> WearMap::grid(int count) const {
  const bool is_pin = geometry_.kind() == JointKind::pin;
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double turn =
        is_pin ? 2 * pi * i / count - pi : i * pi * (3 - std::sqrt(5.0));
    const double z = is_pin ? 0 : 1 - (2 * i + 1.0) / count;
    const double r = std::sqrt(1 - z * z);
    points.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
  }
  return points;
}

double WearMap::cell_area(int count) const {
  const double rho = geometry_.radius();
  return geometry_.kind() == JointKind::pin
             ? 2 * pi * rho * geometry_.length() / count
             : 4 * pi * rho * rho / count;
}

double WearMap::volume_defect(const std::vector<Wear>& wear) const {
  double sum = 0;
  for (const Wear& w : wear) sum += w.pv;
  return sum * cell_area(static_cast<int>(wear.size())) / total_ - 1;
}

WearMap::Deepest WearMap::deepest(const std::vector<Vector3d>& points,
                                  const std::vector<Wear>& wear) const {
  const auto best = std::ranges::max_element(wear, {}, &Wear::pv);
  Deepest found{points[static_cast<std::size_t>(best - wear.begin())], *best};
  const bool is_pin = geometry_.kind() == JointKind::pin;
  const double count = static_cast<double>(points.size());
  // Steps in four directions (of a pin two), halved where none leads up: the
  // map has kinks, on which methods that use slopes stick.
  double step = is_pin ? 2 * pi / count : std::sqrt(4 * pi / count);
  while (step > 1e-6) {
    const Vector3d across = is_pin
                                ? Vector3d(Vector3d::UnitZ().cross(found.point))
                                : found.point.unitOrthogonal();
    const Vector3d other = found.point.cross(across);
    Deepest next = found;
    for (const Vector3d& to :
         {across, Vector3d(-across), other, Vector3d(-other)}) {
      if (is_pin && to.z() != 0) continue;
      const Vector3d point = (found.point + step * to).normalized();
      const Wear there = at(point);
      if (there.pv > next.wear.pv) next = {point, there};
    }
    if (next.wear.pv == found.wear.pv) step /= 2;
    found = next;
  }
  return found;
}

}  // namespace contact
