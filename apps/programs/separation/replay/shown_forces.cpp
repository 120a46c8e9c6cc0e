#include "programs/separation/replay/shown_forces.hpp"

#include <cmath>
#include <limits>

#include "libcontact/base/units.hpp"
#include "separation/case/force_law.hpp"

namespace separation {
namespace {

using Eigen::Vector3d;
using multibody::BodyForce;
using multibody::BodyMotion;

// Recomputes the forces from the rows and the times of events.
class ForceRows {
 public:
  ForceRows(const Take& take, const History& history)
      : case_(*take.of), rows_(*take.rows), history_(history), known_(case_) {
    for (int i = 0; i <= static_cast<int>(case_.bodies.size()); ++i) {
      const std::string name = column_name(case_.rigid_body(i).name);
      Columns columns{rows_.column(name + ".x_m")};
      if (i > 0 &&
          case_.bodies[i - 1].hinge.kind == multibody::HingeKind::axis) {
        columns.angle = rows_.column(name + ".angle_deg");
      }
      columns_.push_back(columns);
    }
    bodies_.resize(columns_.size());
  }

  void add(std::size_t row, std::vector<float>& numbers) {
    read_bodies(row);
    // The first of two rows at one time is before the event.
    double time = rows_.at(row, 0);
    const bool before = row + 1 < rows_.size() && rows_.at(row + 1, 0) == time;
    if (before) {
      time = std::nextafter(time, -std::numeric_limits<double>::infinity());
    } else {
      note_strokes();
    }
    note_events(time);
    const CaseForces forces(case_, known_);
    for (std::size_t f = 0; f < case_.forces.size(); ++f) {
      const auto acts = forces.of(static_cast<int>(f), time, bodies_);
      add_force(case_.forces[f], acts, numbers);
    }
  }

 private:
  struct Columns {
    std::size_t motion;     // the first of position, velocity, ...
    std::size_t angle = 0;  // 0: no axis
  };

  void read_bodies(std::size_t row) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const auto vector = [&](std::size_t at) {
        const std::size_t column = columns_[i].motion + at;
        return Vector3d(rows_.at(row, column), rows_.at(row, column + 1),
                        rows_.at(row, column + 2));
      };
      BodyMotion& body = bodies_[i];
      const std::size_t q = columns_[i].motion + 6;
      body.position = vector(0);
      body.velocity = vector(3);
      body.rotation =
          Eigen::Quaterniond(rows_.at(row, q), rows_.at(row, q + 1),
                             rows_.at(row, q + 2), rows_.at(row, q + 3))
              .toRotationMatrix();
      body.angular_velocity = body.rotation * vector(10);
      if (columns_[i].angle > 0) {
        body.hinge_angle = rows_.at(row, columns_[i].angle) * contact::degree;
      }
    }
  }

  void note_strokes() {
    constexpr double rounding = 1e-9;  // m, of places of some 1e3 m
    for (std::size_t f = 0; f < case_.forces.size(); ++f) {
      if (!history_.spent[f] || known_.spent[f]) continue;
      const Force& force = case_.forces[f];
      const auto overrun = force.law->overrun(force.body, bodies_);
      known_.spent[f] = overrun && *overrun >= -rounding;
    }
  }

  void note_events(double time) {
    for (std::size_t e = 0; e < history_.events.size(); ++e) {
      for (std::size_t i = 0; i < history_.events[e].size(); ++i) {
        const double at = history_.events[e][i];
        if (at <= time) known_.events[e][i] = at;
      }
    }
  }

  void add_force(const Force& force, const std::optional<BodyForce>& acts,
                 std::vector<float>& numbers) const {
    if (!acts) {
      numbers.insert(numbers.end(), 6, std::numeric_limits<float>::quiet_NaN());
      return;
    }
    const Vector3d arm = bodies_[force.body].rotation *
                         force.law->where(case_, force.body).point;
    Vector3d moment = acts->moment - arm.cross(acts->force);
    // A force without a moment leaves a moment of rounding.
    if (moment.norm() < 1e-9 * arm.norm() * acts->force.norm()) {
      moment.setZero();
    }
    for (const Vector3d& v : {acts->force, moment}) {
      for (const double x : v) numbers.push_back(static_cast<float>(x));
    }
  }

  const Case& case_;
  const Rows& rows_;
  const History& history_;
  History known_;  // at the row
  std::vector<Columns> columns_;
  std::vector<BodyMotion> bodies_;
};

}  // namespace

std::vector<float> shown_forces(const Take& take, const History& history) {
  std::vector<float> numbers;
  ForceRows rows(take, history);
  for (const std::size_t row : take.kept) rows.add(row, numbers);
  return numbers;
}

}  // namespace separation
