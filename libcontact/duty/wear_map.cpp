#include "libcontact/duty/wear_map.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/duty/wear_check.hpp"
#include "libcontact/pressure/profile.hpp"

namespace contact {
namespace {

using detail::pi;
using Eigen::Matrix3d;
using Eigen::Vector3d;

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

  double pressure(const Vector3d& point) const {
    const double from_centre = (point - centre).norm();
    if (from_centre >= chord && uniform_pressure == 0) return 0;
    const double theta = 2 * std::asin(std::min(from_centre / 2, 1.0));
    return pressure_unit * profile.pressure(theta) + uniform_pressure;
  }
};

struct WearMap::AtRim {
  JointSolution solution;
  Eigen::Quaterniond from_body;  // to the axes of the solution
  Vector3d slip;                 // in axes of the body
};

void detail::check_wear(const JointCycle& cycle) {
  const JointCycle::Instant widest = cycle.largest(
      [](const JointCycle::Instant& i) { return i.solution.half_angle; });
  const double half_angle = widest.solution.half_angle;
  // NaN at rims, which the contact does not leave.
  if (!(half_angle > pi / 2)) return;
  throw Error(
      must_be(message("the half-angle of a joint that wears, {:.4g} deg at "
                      "{:.4g} s,",
                      half_angle / degree, widest.time),
              "at most 90 deg"));
}

WearMap::WearMap(const JointCycle& cycle, JointBody body)
    : geometry_(cycle.contact().geometry()),
      total_(cycle.sums().pv),
      joint_(cycle.joint()) {
  if (geometry_.radial_clearance() > 0) detail::check_wear(cycle);
  const JointContact& contact = cycle.contact();
  std::vector<Instant> instants;
  std::vector<AtRim> at_rims;
  for (const JointCycle::Instant& point : cycle.gauss_points()) {
    const JointSolution& s = point.solution;
    if (s.status != Status::ok) {
      throw Error(detail::message("wear at {:.4g} s: {}", point.time,
                                  joint_.notes(s).front()));
    }
    if (s.state != JointState::sliding) continue;
    const Eigen::Quaterniond to_body = body == JointBody::body
                                           ? point.state.turn.conjugate()
                                           : Eigen::Quaterniond::Identity();
    const Vector3d turn =
        point.weight * (to_body * point.state.angular_velocity);
    const Vector3d slip = geometry_.radius() * turn;
    if (std::isnan(s.half_angle)) {
      if (joint_.is_pin()) {
        throw Error(detail::needs("the wear of a pin that ends",
                                  "a place along it: hinge-duty --along-map"));
      }
      at_rims.push_back({s, to_body.conjugate(), slip});
      continue;
    }
    instants.push_back(
        {{contact.pressure_law(), s.half_angle},
         to_body * cycle.sliding(point).centre(),
         2 * std::sin(s.half_angle / 2),
         slip,
         contact.pressure_unit(s.normal_force),
         contact.uniform_pressure(s.normal_force, s.half_angle)});
  }
  instants_ = std::make_shared<const std::vector<Instant>>(std::move(instants));
  at_rims_ = std::make_shared<const std::vector<AtRim>>(std::move(at_rims));
}

namespace {

// Wear that is summed up over the time.
struct Sum {
  double pv = 0;
  Matrix3d work = Matrix3d::Zero();

  void add(double pressure, const Vector3d& slip) {
    if (pressure == 0) return;
    const double length = slip.norm();
    if (length == 0) return;
    pv += pressure * length;
    work += pressure / length * slip * slip.transpose();
  }
};

}  // namespace

std::vector<WearMap::Wear> WearMap::at(std::span<const Vector3d> points) const {
  std::vector<Sum> sums(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (const Instant& i : *instants_) {
      sums[k].add(i.pressure(points[k]), i.slip.cross(points[k]));
    }
  }
  std::vector<Vector3d> places(points.size());
  JointSolution whole;
  for (const AtRim& i : *at_rims_) {
    whole = joint_.with_grid(i.solution, whole);
    std::transform(points.begin(), points.end(), places.begin(),
                   [&](const Vector3d& point) { return i.from_body * point; });
    const std::vector<double> pressures =
        joint_.pressures(whole, places, Joint::RimPressure::reported);
    for (std::size_t k = 0; k < points.size(); ++k) {
      sums[k].add(pressures[k], i.slip.cross(points[k]));
    }
  }
  std::vector<Wear> all;
  for (const Sum& sum : sums) all.push_back({sum.pv, cross_shear(sum.work)});
  return all;
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
  if (at_rims_->size() > JointCycle::most_grids) return found;
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
