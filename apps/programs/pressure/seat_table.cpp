#include "programs/pressure/seat_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "cli/refuse.hpp"
#include "cli/stream/report.hpp"
#include "cli/sweep.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/pressure/validity.hpp"
#include "libcontact/quantities/seat.hpp"
#include "libcontact/seat/contact.hpp"

namespace hinge_pressure {
namespace {

using contact::Dimension;
using contact::SeatState;

using Columns = std::vector<contact::Column<contact::RimContact>>;

// The limits of the materials: the contact is confined here.
contact::ContactLimits limits_of(const cli::Joint& joint) {
  return {*joint.laws[0].law, joint.pair};
}

// Rows of a joint; what is to be said of them.
class Rows {
 public:
  Rows(const Options& options, const cli::Joint& joint)
      : joint_(joint),
        seat_(joint.spec, zone_of(joint)),
        loads_("--load", options.load.load, {0, 1e100, "N"}, Dimension::force),
        directions_("--direction", options.direction, {0, 180, "deg"},
                    Dimension::angle) {}

  cli::ExitStatus write(const Columns& columns, int points,
                        cli::RowWriter& row) const {
    contact::LargestContact largest;
    std::set<std::string> notes;
    bool all_good = true;
    for (std::size_t i = 0; i < loads_.size(); ++i) {
      for (std::size_t k = 0; k < directions_.size(); ++k) {
        const double direction = directions_[k] * contact::degree;
        const SeatState s =
            seat_.under(loads_[i] * Eigen::Vector3d(std::sin(direction), 0,
                                                    std::cos(direction)));
        const auto begin = [&] {
          cli::write_differences(joint_.differences, row);
          row.number(loads_[i]);
          row.number(directions_[k]);
        };
        if (points > 0) {
          write_map(s, points, begin, row);
        } else {
          begin();
          row.number(seat_.nominal_area());
          row.number(loads_[i] / seat_.nominal_area());
          for (const auto& column : columns) row.number(column(s) + 0.0);
          row.end();
        }
        largest.add(0, s.peak_pressure);
        for (const std::string& note : seat_.notes(s)) notes.insert(note);
        all_good = all_good && seat_.note(s).empty();
      }
    }
    for (const std::string& note : notes) cli::warn("hinge-pressure", note);
    for (const std::string& note : limits_of(joint_).notes(largest)) {
      cli::warn("hinge-pressure", note);
    }
    return all_good ? cli::all_good : cli::some_bad;
  }

 private:
  static contact::SeatZone zone_of(const cli::Joint& joint) {
    const auto& zone = joint.spec.geometry.seat();
    if (!zone) cli::refuse_without("--direction", "a joint with a [seat]");
    return *zone;
  }

  // From rim to rim, as far from them as largest pressures are looked for.
  template <class Begin>
  void write_map(const SeatState& state, int points, const Begin& begin,
                 cli::RowWriter& row) const {
    const contact::SeatZone& zone = seat_.zone();
    const double near = zone.edge().report_distance;
    const double from = zone.from() + (zone.has_lower_rim() ? near : 0);
    const double to = zone.to() - (zone.has_upper_rim() ? near : 0);
    for (int i = 0; i < points; ++i) {
      for (int j = 0; j < points; ++j) {
        const contact::SeatPlace place{from + (to - from) * i / (points - 1),
                                       std::numbers::pi * j / (points - 1)};
        begin();
        row.number(place.polar_angle / contact::degree);
        row.number(place.longitude / contact::degree);
        row.number(seat_.pressure(state, place));
        row.end();
      }
    }
  }

  const cli::Joint& joint_;
  contact::SeatContact seat_;
  cli::Sweep loads_;
  cli::Sweep directions_;
};

}  // namespace

cli::ExitStatus run_in_seat(const Options& options) {
  const std::vector<cli::Joint> joints = make_joints(options.joint);
  const Columns columns = columns_of(contact::seat_quantities());
  std::vector<std::string> names = {"load_N", "direction_deg"};
  if (options.points > 0) {
    names.insert(names.end(), {"v_deg", "phi_deg", "p_Pa"});
  } else {
    names.insert(names.end(), {"nominal_area_m2", "p_nominal_Pa"});
    for (const auto& column : columns) names.push_back(column.name);
  }
  warn_of_validity("hinge-pressure", joints);
  cli::ExitStatus status = cli::all_good;
  cli::write_table(options.output, cli::joint_columns(joints, {names}),
                   [&](cli::RowWriter& row) {
                     for (const cli::Joint& joint : joints) {
                       const Rows rows(options, joint);
                       status = std::max(
                           status, rows.write(columns, options.points, row));
                     }
                   });
  return status;
}

}  // namespace hinge_pressure
