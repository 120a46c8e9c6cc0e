#include "libcontact/duty/joint_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/duty/joint_rating.hpp"
#include "libcontact/duty/over_cycle.hpp"
#include "libcontact/joint/contact_model.hpp"
#include "libcontact/joint/contact_notes.hpp"

namespace contact {
namespace {

void check(const Joint& joint, const JointCycle::Instant& instant, bool ends) {
  const JointSolution& s = instant.solution;
  if (s.status == Status::ok) return;
  if (dynamic_cast<const detail::PlacementRefused*>(s.work.get())) {
    throw Error(joint.notes(s).front());
  }
  throw Error(detail::must_be(
      detail::message("the reaction at {:.6g} s, {:.6g} N", instant.time,
                      instant.state.reaction.norm()),
      ends ? "one under which the pin that ends has a contact"
           : "one for which the half-angle law and the pressure law have a "
             "value"));
}

// A contact at a rim has no half-angle, nor has one that left its seat.
bool is_round(const JointSolution& s) { return !std::isnan(s.half_angle); }

}  // namespace

JointCycle::JointCycle(DutyCycle cycle, Joint joint, Lies lies,
                       const std::function<void(double)>& progress)
    : cycle_(std::move(cycle)),
      joint_(std::move(joint)),
      lies_(std::move(lies)) {
  if (lies_ && !joint_.is_pin()) {
    throw Error(detail::needs("a tilt, or a place of the load,", "a pin"));
  }
  std::vector<DutyCycle::GaussPoint> rows;
  rows.reserve(cycle_.times().size());
  for (const double time : cycle_.times()) rows.push_back({time, 0});
  auto between = cycle_.gauss_points(joint_.is_pin());
  if (!joint_.is_endless() && !joint_.is_pin()) {
    const auto is_at_rim = [&](const DutyCycle::GaussPoint& point) {
      return !is_round(at(point).solution);
    };
    at_rims_ = std::ranges::any_of(rows, is_at_rim) ||
               std::ranges::any_of(between, is_at_rim);
  }
  if (at_rims_) {
    tabulate(progress);
    rows_ = rows_at_rims();
    return;
  }
  rows_ = series(std::move(rows));
  gauss_points_ = series(std::move(between));
}

// A table of the loads that reach a rim, if there are many of them. Friction
// makes the force on the seat a little larger or smaller than the reaction.
void JointCycle::tabulate(const std::function<void(double)>& progress) {
  if (!joint_.table().empty()) return;
  const SeatZone& zone = *contact().geometry().seat();
  double least = detail::infinity, most = 0;
  int count = 0;
  for (const double time : cycle_.times()) {
    const Instant row{time, 0, cycle_.at(time), {}};
    const double load = row.state.reaction.norm();
    if (!(load > 0)) continue;
    const Eigen::Vector3d force =
        to_seat(row) * (contact().geometry().side() * row.state.reaction);
    const double direction = detail::load_direction(zone, force);
    const HalfAngleResult theta0 = contact().half_angle(load);
    if (theta0.status == Status::ok &&
        zone.margin(direction, theta0.half_angle) >= 0) {
      continue;
    }
    ++count;
    least = std::min(least, load);
    most = std::max(most, load);
  }
  if (count < many) return;
  joint_ = joint_.tabulated({.least_load = std::max(0.9 * least, 1e-2 * most),
                             .most_load = 1.1 * most,
                             .progress = progress});
}

JointCycle::Series JointCycle::rows_at_rims() {
  const std::vector<double>& times = cycle_.times();
  const std::size_t count = times.size();
  std::size_t grids = 0;
  Series made;
  JointSolution last, near;
  std::set<std::string> said;
  for (std::size_t i = 0; i < count; ++i) {
    const double before =
        i == 0 ? times[count - 1] - cycle_.period() : times[i - 1];
    const double after =
        i + 1 == count ? times[0] + cycle_.period() : times[i + 1];
    const DutyCycle::GaussPoint point{times[i], (after - before) / 2};
    Instant row = at(point, last);
    last = row.solution;
    if (!is_round(row.solution)) {
      near = joint_.with_grid(row.solution, near);
      row.at_rim = joint_.pv(near, row.state.angular_velocity);
      row.solution = ++grids <= most_grids ? near : near.without_grid();
    }
    for (auto& note : joint_.notes(row.solution)) {
      if (said.insert(note).second && said.size() <= 8) {
        rim_notes_.push_back(
            detail::message("from {:.4g} s on: {}", row.time, note));
      }
    }
    add(row);
    made.points.push_back(point);
    made.kept.push_back(std::move(row));
  }
  return made;
}

JointCycle::Series JointCycle::series(
    std::vector<DutyCycle::GaussPoint> points) {
  // 8 MB: the Gauss points of some 1500 rows.
  constexpr std::size_t most_kept = 16'000;
  Series made;
  const bool keeps = points.size() <= most_kept;
  if (keeps) made.kept.reserve(points.size());
  for (const DutyCycle::GaussPoint& point : points) {
    const Instant instant = at(point);
    check(joint_, instant, lies_ || !joint_.is_endless());
    is_round_ = is_round_ && is_round(instant.solution);
    if (point.weight > 0) add(instant);
    if (keeps) made.kept.push_back(instant);
  }
  made.points = std::move(points);
  return made;
}

void JointCycle::add(const Instant& instant) {
  const double weight = instant.weight;
  const JointSolution& s = instant.solution;
  const double speed =
      contact().geometry().radius() * instant.state.angular_velocity.norm();
  sums_.energy += weight * -s.power;
  sums_.sliding_path += weight * speed;
  sums_.moment += weight * s.friction_moment.norm();
  if (!is_round(s)) {
    const double total = pv_without_axis(instant).total;
    sums_.effective_distance += weight * (total / s.normal_force);
    sums_.pv += weight * total;
    return;
  }
  const SlidingContact slip = sliding(instant);
  sums_.effective_distance += weight * (speed * slip.slip_coefficient());
  const double pv = weight * slip.pv_total();
  sums_.pv += pv;
  if (!(pv > 0)) return;
  const Eigen::Vector3d centre = to_seat(instant) * slip.centre();
  if (middle_.isZero(0)) first_ = centre;
  middle_ += pv * centre;
}

JointCycle::Instant JointCycle::instant(const Series& series,
                                        std::size_t i) const {
  return series.kept.empty() ? at(series.points[i]) : series.kept[i];
}

JointCycle::Instant JointCycle::at(const DutyCycle::GaussPoint& point,
                                   const JointSolution& last) const noexcept {
  Instant instant{point.time, point.weight, cycle_.at(point.time), {}};
  const DutyCycle::State& state = instant.state;
  Placement placement;
  const bool turns =
      !joint_.is_endless() && contact().geometry().side() > 0;  // with the body
  if (turns) placement.from_seat = state.turn.toRotationMatrix();
  if (lies_) placement = lies_(state, point.time);
  instant.solution =
      joint_.solve({.reaction = state.reaction,
                    .angular_velocity = state.angular_velocity,
                    .axis = Eigen::Vector3d::UnitZ(),
                    .placement = turns || lies_ ? &placement : nullptr},
                   last);
  return instant;
}

JointCycle::Instant JointCycle::at(double time) const noexcept {
  return at(DutyCycle::GaussPoint{time, 0});
}

ContactPv JointCycle::pv(const Instant& instant) const {
  if (!is_round(instant.solution)) return pv_without_axis(instant);
  return joint_.pv(instant.solution, instant.state.angular_velocity);
}

// At rims it takes long, and is kept.
ContactPv JointCycle::pv_without_axis(const Instant& instant) const {
  if (!joint_.is_pin()) return instant.at_rim;
  return joint_.pv(instant.solution, instant.state.angular_velocity);
}

double JointCycle::half_angle(const Instant& instant) const {
  const auto lie = joint_.lie(instant.solution);
  return lie ? lie->largest_half_angle : instant.solution.half_angle;
}

SlidingContact::Rating JointCycle::rating(const Instant& instant) const {
  const JointSolution& s = instant.solution;
  return rating_of(joint_, s, instant.state.angular_velocity,
                   is_round(s) ? ContactPv() : pv_without_axis(instant));
}

double JointCycle::integral(const Quantity& quantity) const {
  return detail::integral_of(gauss_points(), quantity);
}

JointCycle::Instant JointCycle::largest(const Quantity& quantity) const {
  return largest(quantity, {});
}

// At rims the row with the largest value. Where contacts end a row with a
// contact but no value, if its mean is larger or no mean is given.
JointCycle::Instant JointCycle::largest(const Quantity& quantity,
                                        const Quantity& mean) const {
  const Instant found =
      at_rims_ ? detail::largest_row(rows(), quantity)
               : detail::largest_of(
                     rows(), cycle_.period(),
                     [this](double time) { return at(time); }, quantity);
  if (!at_rims_ && is_round_) return found;
  for (const Instant& row : rows()) {
    if (row.solution.state == JointState::unloaded) continue;
    if (!std::isnan(quantity(row))) continue;
    if (!mean || !(mean(row) <= quantity(found))) return row;
  }
  return found;
}

JointCycle::Instant JointCycle::largest_peak() const {
  return largest([](const Instant& i) { return i.solution.peak_pressure; },
                 of_rims(&RimContact::mean_pressure));
}

JointCycle::Instant JointCycle::largest_pv() const {
  return largest([this](const Instant& i) { return pv(i).largest; },
                 [](const Instant& i) {
                   return i.at_rim.total / i.solution.contact_area;
                 });
}

double JointCycle::of_rims(const Instant& instant,
                           double (RimContact::*of)() const) const {
  const auto rims = joint_.rims(instant.solution);
  return rims ? ((*rims).*of)() : detail::nan;
}

double JointCycle::rim_share() const {
  if (!at_rims_) return 0;
  double all = 0, at_rim = 0;
  for (const Instant& row : rows_.kept) {
    all += row.weight;
    const auto rims = joint_.rims(row.solution);
    if (rims && rims->is_at_rim()) at_rim += row.weight;
  }
  return at_rim / all;
}

JointCycle::Instant JointCycle::least_gap() const {
  const Quantity gap = of_rims(&RimContact::gap);
  return detail::largest_row(rows(), [&](const Instant& i) { return -gap(i); });
}

JointCycle::Instant JointCycle::largest_intensity() const {
  // At a rim without K the largest one is not known.
  return detail::largest_row(rows(), [this](const Instant& i) {
    const auto rims = joint_.rims(i.solution);
    if (!rims) return detail::nan;
    const double k = rims->intensity();
    return std::isnan(k) && rims->is_at_rim() ? detail::infinity : k;
  });
}

LargestContact JointCycle::largest_contact() const {
  LargestContact all;
  if (!at_rims_) {
    const Quantity theta0 = [this](const Instant& i) { return half_angle(i); };
    all = {theta0(largest(theta0)), largest_peak().solution.peak_pressure};
  }
  for (const Instant& row : rows()) {
    JointSolution in_seat = row.solution;
    in_seat.normal = to_seat(row) * in_seat.normal;
    all.add(half_angle(row), in_seat.peak_pressure,
            rim_overlap(contact(), in_seat));
  }
  return all;
}

std::vector<std::string> JointCycle::notes() const {
  std::vector<std::string> all = contact().limits().notes(largest_contact());
  all.insert(all.begin(), rim_notes_.begin(), rim_notes_.end());
  return all;
}

Eigen::Quaterniond JointCycle::to_seat(const Instant& instant) const {
  return contact().geometry().side() > 0 ? instant.state.turn.conjugate()
                                         : Eigen::Quaterniond::Identity();
}

double JointCycle::contact_spread() const {
  if (at_rims_ || !is_round_) return detail::nan;
  if (!(sums_.pv > 0)) return 0;
  // A contact that goes round has no middle: any place serves.
  constexpr double rounding = 1e-12;
  const Eigen::Vector3d middle =
      middle_.norm() > rounding * sums_.pv ? middle_.normalized() : first_;
  double squares = 0;
  for (const Instant& i : gauss_points()) {
    const SlidingContact slip = sliding(i);
    const double weight = i.weight * slip.pv_total();
    if (!(weight > 0)) continue;
    const double chord = (to_seat(i) * slip.centre() - middle).norm();
    const double angle = 2 * std::asin(std::min(chord / 2, 1.0));
    squares += weight * angle * angle;
  }
  return std::sqrt(squares / sums_.pv);
}

}  // namespace contact
