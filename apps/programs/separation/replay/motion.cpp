#include "programs/separation/replay/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libcontact/base/units.hpp"

namespace separation {
namespace {

using contact::degree;
using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using multibody::HingeKind;
using multibody::HingeMode;

// The cubic with these end values and slopes (times the interval), at a
// fraction of the interval.
template <class Value>
Value cubic(const Value& from, const Value& slope, const Value& to,
            const Value& slope_there, double part) {
  const double rest = 1 - part;
  return (1 + 2 * part) * rest * rest * from +
         part * part * (3 - 2 * part) * to + part * rest * rest * slope -
         part * part * rest * slope_there;
}

Vector3d turn_vector(const Quaterniond& q) {
  const AngleAxisd turn(q.w() < 0 ? Quaterniond(-q.coeffs()) : q);
  return turn.angle() * turn.axis();
}

Quaterniond turn_by(const Vector3d& v) {
  const double angle = v.norm();
  if (angle == 0) return Quaterniond::Identity();
  return Quaterniond(AngleAxisd(angle, v / angle));
}

// Pose between two key frames, as viewers interpolate it.
Pose between(const Pose& a, const Pose& b, double part) {
  return {a.position + part * (b.position - a.position),
          a.rotation.slerp(part, b.rotation)};
}

}  // namespace

std::vector<std::size_t> replay_rows(const Rows& rows, int every) {
  const auto same_time = [&](std::size_t i) {
    return rows.at(i, 0) == rows.at(i - 1, 0);
  };
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool last = i + 1 == rows.size();
    if (i % every == 0 || last || same_time(i) || same_time(i + 1)) {
      kept.push_back(i);
    }
  }
  return kept;
}

BodyPath::BodyPath(const Case& c, const Rows& rows,
                   const std::vector<std::size_t>& kept, int body)
    : case_(c), rows_(rows) {
  for (const std::size_t row : kept) {
    if (!kept_.empty() && rows.at(kept_.back(), 0) == rows.at(row, 0)) {
      kept_.pop_back();
    }
    kept_.push_back(row);
  }
  std::vector<int> chain = {body};
  while (chain.back() > 0) {
    chain.push_back(c.bodies[chain.back() - 1].hinge.on);
  }
  std::ranges::reverse(chain);
  for (const int i : chain) {
    const std::string name = column_name(c.rigid_body(i).name);
    Columns columns{i, rows.column(name + ".x_m")};
    if (i > 0 && c.bodies[i - 1].hinge.kind != HingeKind::none) {
      columns.mode = rows.column(name + ".mode");
      if (c.bodies[i - 1].hinge.kind == HingeKind::axis) {
        columns.angle = rows.column(name + ".angle_deg");
      }
    }
    columns_.push_back(columns);
  }
}

BodyPath::State BodyPath::state(std::size_t i, int link) const {
  const std::size_t c = columns_[link].motion;
  const auto vector = [&](std::size_t at) {
    return Vector3d(value(i, c + at), value(i, c + at + 1),
                    value(i, c + at + 2));
  };
  return {value(i, 0), vector(0), vector(3),
          Quaterniond(value(i, c + 6), value(i, c + 7), value(i, c + 8),
                      value(i, c + 9)),
          vector(10)};
}

bool BodyPath::is_held(std::size_t i, int link) const {
  const std::size_t mode = columns_[link].mode;
  return mode > 0 && value(i, mode) != static_cast<double>(HingeMode::released);
}

// Rotation after row i; the last row has no successor.
Quaterniond BodyPath::rotation(std::size_t i, double part, int link) const {
  const State from = state(i, link);
  if (part == 0) return from.rotation;
  const State to = state(i + 1, link);
  const double h = to.time - from.time;
  if (columns_[link].angle > 0 && is_held(i, link)) {
    const Hinge& hinge = this->hinge(link);
    const std::size_t angle = columns_[link].angle;
    const std::size_t rate = angle + 1;
    const double turn =
        cubic(value(i, angle), h * value(i, rate), value(i + 1, angle),
              h * value(i + 1, rate), part);
    return rotation(i, part, link - 1) * AngleAxisd(turn * degree, hinge.axis) *
           Quaterniond(hinge.zero_rotation);
  }
  // Slope of the vector v of the rotation since row i. The rates in body axes
  // are v' - v x v'/2 + v x (v x v')/6 - ...; this inverts the series.
  const Vector3d all = turn_vector(from.rotation.conjugate() * to.rotation);
  const Vector3d across = all.cross(to.rates);
  const Vector3d slope = to.rates + across / 2 + all.cross(across) / 12;
  return from.rotation *
         turn_by(cubic<Vector3d>(Vector3d::Zero(), h * from.rates, all,
                                 h * slope, part));
}

double BodyPath::time(double place) const {
  const auto i = static_cast<std::size_t>(place);
  const double part = place - static_cast<double>(i);
  if (part == 0) return value(i, 0);
  return value(i, 0) + part * (value(i + 1, 0) - value(i, 0));
}

// Relative to the carrier's centre of mass.
Vector3d BodyPath::position(std::size_t i, double part, int link) const {
  if (link == 0) return Vector3d::Zero();
  if (is_held(i, link)) {
    return position(i, part, link - 1) +
           rotation(i, part, link - 1) * hinge(link).parent_point -
           rotation(i, part, link) * hinge(link).body_point;
  }
  const State from = state(i, link);
  const State carrier = state(i, 0);
  if (part == 0) return from.position - carrier.position;
  const State to = state(i + 1, link);
  const State carrier_to = state(i + 1, 0);
  const double h = to.time - from.time;
  return cubic<Vector3d>(from.position - carrier.position,
                         h * (from.velocity - carrier.velocity),
                         to.position - carrier_to.position,
                         h * (to.velocity - carrier_to.velocity), part);
}

Pose BodyPath::pose(double place) const {
  const auto i = static_cast<std::size_t>(place);
  const double part = place - static_cast<double>(i);
  return {position(i, part, last()), rotation(i, part, last())};
}

double BodyPath::largest_turn() const {
  double largest = 0;
  for (std::size_t i = 0; i + 1 < size(); ++i) {
    if (columns_[last()].angle > 0 && is_held(i, last())) continue;
    const State from = state(i, last());
    const State to = state(i + 1, last());
    largest =
        std::max(largest, (to.time - from.time) *
                              std::max(from.rates.norm(), to.rates.norm()));
  }
  return largest;
}

namespace {

// Bisects a piece of the path until it is straight enough.
class Splitter {
 public:
  Splitter(const BodyPath& path, double length, double angle)
      : path_(path), length_(length), angle_(angle) {}

  KeyFrames run() {
    add(0, path_.pose(0));
    const auto last = static_cast<double>(path_.size() - 1);
    if (last > 0) split(0, path_.pose(0), last, path_.pose(last));
    return std::move(keys_);
  }

 private:
  void add(double place, const Pose& pose) {
    keys_.times.push_back(path_.time(place));
    keys_.poses.push_back(pose);
  }

  // Checks the rows between, and three times between each two of them.
  bool fits(double a, const Pose& from, double b, const Pose& to) const {
    // A rotation by more than half a turn would go the other way.
    constexpr double most = std::numbers::pi / 2;
    if (from.rotation.angularDistance(to.rotation) > most) return false;
    const double start = path_.time(a);
    const double step = std::min(1.0, b - a) / 4;
    const double whole = path_.time(b) - start;
    Pose before = from;
    for (double place = a + step; place < b - step / 2; place += step) {
      const Pose is = path_.pose(place);
      const double part = (path_.time(place) - start) / whole;
      const Pose shown = between(from, to, part);
      if ((is.position - shown.position).norm() > length_ ||
          is.rotation.angularDistance(shown.rotation) > angle_ ||
          is.rotation.angularDistance(before.rotation) > most) {
        return false;
      }
      before = is;
    }
    return true;
  }

  void split(double a, const Pose& from, double b, const Pose& to) {
    constexpr double least = 1.0 / (1 << 20);  // in rows: never reached
    if (b - a < least || fits(a, from, b, to)) return add(b, to);
    const double half = (a + b) / 2;
    const double middle = b - a > 1 ? std::floor(half) : half;
    const double at = middle > a ? middle : half;
    const Pose pose = path_.pose(at);
    split(a, from, at, pose);
    split(at, pose, b, to);
  }

  const BodyPath& path_;
  double length_;
  double angle_;
  KeyFrames keys_;
};

}  // namespace

KeyFrames key_frames(const BodyPath& path, double length, double angle) {
  return Splitter(path, length, angle).run();
}

}  // namespace separation
