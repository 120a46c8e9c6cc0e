#include "libcontact/duty/seat_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>

#include "libcontact/base/text.hpp"
#include "libcontact/duty/seat_pv.hpp"

namespace contact {

namespace {

// A table of the loads that reach a rim, if there are many of them. Friction
// makes the force on the seat a little larger or smaller than the reaction.
std::shared_ptr<const SeatTable> table_of(
    const SeatJoint& joint, const std::vector<SeatCycle::Instant>& rows,
    const std::function<void(double)>& progress) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  int count = 0;
  for (const auto& row : rows) {
    const SeatJointSolution& s = row.solution;
    const double load = s.reaction.norm();
    if (!(load > 0) || joint.is_free(s.reaction)) continue;
    ++count;
    least = std::min(least, load);
    most = std::max(most, load);
  }
  if (count < SeatCycle::many) return nullptr;
  return std::make_shared<const SeatTable>(
      joint.contact(),
      SeatTable::Options{.least_load = std::max(0.9 * least, 1e-2 * most),
                         .most_load = 1.1 * most,
                         .progress = progress});
}

}  // namespace

SeatCycle::SeatCycle(const DutyCycle& cycle, const JointSpec& spec,
                     const Options& options) {
  const auto made = std::make_shared<SeatJoint>(spec);
  SeatJoint& joint = *made;
  joint_ = made;
  const std::vector<double>& times = cycle.times();
  const bool turns = spec.geometry.inner_body() == JointBody::carrier;
  const std::size_t count = times.size();
  for (std::size_t i = 0; i < count; ++i) {
    const DutyCycle::State state = cycle.at(times[i]);
    const Eigen::Quaterniond to_seat =
        turns ? state.turn.conjugate() : Eigen::Quaterniond::Identity();
    const double before =
        i == 0 ? times[count - 1] - cycle.period() : times[i - 1];
    const double after =
        i + 1 == count ? times[0] + cycle.period() : times[i + 1];
    Instant row{
        times[i], (after - before) / 2, {}, to_seat * state.angular_velocity};
    row.to_ball = turns ? state.turn : state.turn.conjugate();
    row.solution.reaction = to_seat * state.reaction;
    rows_.push_back(std::move(row));
  }
  std::shared_ptr<const SeatTable> table;
  if (!options.table.empty()) {
    table =
        std::make_shared<const SeatTable>(joint.contact(), spec, options.table);
  } else if ((table = table_of(joint, rows_, options.progress))) {
    table_ = table->bytes(spec);
  }
  if (table) check_ = table->check();
  joint.use(table);
  SeatJointSolution last;
  SeatState near;
  std::set<std::string> said;
  for (Instant& row : rows_) {
    row.solution = joint.solve({.reaction = row.solution.reaction,
                                .angular_velocity = row.angular_velocity},
                               last);
    last = row.solution;
    row.pv = seat_pv(joint, row.solution, row.angular_velocity, near);
    const bool is_kept =
        options.keeps_contacts && !row.solution.contact.is_free;
    row.solution.contact.solution = is_kept ? near.solution : nullptr;
    if (row.solution.contact.status == SeatStatus::no_load) continue;
    for (auto& note : joint.notes(row.solution)) {
      if (said.insert(note).second && said.size() <= 8) {
        notes_.push_back(
            detail::message("from {:.4g} s on: {}", row.time, note));
      }
    }
  }
}

double SeatCycle::rim_share() const {
  double all = 0, at_rim = 0;
  for (const Instant& row : rows_) {
    all += row.weight;
    if (row.solution.contact.intensity() > 0) at_rim += row.weight;
  }
  return at_rim / all;
}

template <class Of>
const SeatCycle::Instant* SeatCycle::largest(const Of& of) const {
  const Instant* found = nullptr;
  double value = -std::numeric_limits<double>::infinity();
  for (const Instant& row : rows_) {
    if (!(of(row) > value)) continue;
    value = of(row);
    found = &row;
  }
  return found;
}

template <class Of, class Mean>
const SeatCycle::Instant* SeatCycle::largest(const Of& of,
                                             const Mean& mean) const {
  const Instant* found = largest(of);
  for (const Instant& row : rows_) {
    if (!found || row.solution.contact.status != SeatStatus::ok) continue;
    if (std::isnan(of(row)) && mean(row) > of(*found)) return nullptr;
  }
  return found;
}

const SeatCycle::Instant* SeatCycle::largest_peak() const {
  return largest(
      [](const Instant& i) { return i.solution.contact.peak_pressure; },
      [](const Instant& i) { return i.solution.contact.mean_pressure(); });
}

const SeatCycle::Instant* SeatCycle::largest_pv() const {
  return largest(
      [](const Instant& i) { return i.pv.largest; },
      [](const Instant& i) { return i.pv.total / i.solution.contact.area; });
}

double SeatCycle::pv_integral() const {
  double sum = 0;
  for (const Instant& row : rows_) {
    if (!std::isnan(row.pv.total)) sum += row.weight * row.pv.total;
  }
  return sum;
}

const SeatCycle::Instant* SeatCycle::least_gap() const {
  return largest([](const Instant& i) { return -i.solution.contact.gap(); });
}

const SeatCycle::Instant* SeatCycle::largest_intensity() const {
  return largest(
      [](const Instant& i) { return i.solution.contact.intensity(); });
}

std::vector<std::string> SeatCycle::notes() const { return notes_; }

}  // namespace contact
