// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "separation/clearance/clearance.hpp"
#include "separation/clearance/pair_way.hpp"
#include "separation/results/peaks.hpp"
#include "separation/simulation/force_watch.hpp"
#include "separation/simulation/simulation.hpp"

namespace separation {

/// A time history: rows of numbers under named columns. A column that ends in
/// "mode" holds the number of a multibody::HingeMode.
struct Rows {
  std::vector<std::string> columns;
  std::vector<double> numbers;  ///< row by row

  std::size_t size() const { return numbers.size() / columns.size(); }
  double at(std::size_t row, std::size_t column) const {
    return numbers[row * columns.size() + column];
  }
  /// Throws contact::Error if there is none.
  std::size_t column(const std::string& name) const;
};

/// Distances of the bodies that a case watches, Case::clearance.
Clearance clearance_of(const Case& c);

/// Columns of the rows of a case.
/// @param clearance  whether distances are computed
std::vector<std::string> history_columns(const Case& c, bool clearance);

/// Largest values of one joint.
struct JointPeaks {
  double reaction = 0;       ///< N
  double reaction_time = 0;  ///< s
  double pressure = 0;       ///< peak of contacts with a peak, Pa
  double hidden = 0;         ///< mean of contacts without a peak, Pa
  double half_angle = 0;     ///< theta0 of contacts at no rim, rad
  double moment = 0;         ///< friction moment, N m
  /// Least distances of the contact to the rims of its seat, m.
  double lower_gap = History::not_yet;
  double upper_gap = History::not_yet;
  double rim_time = 0;  ///< at a rim, s; to a step at its beginning and end

  double least_gap() const { return std::min(lower_gap, upper_gap); }
  /// NaN if a contact at a rim has no peak, and its mean is above all other
  /// peaks (contact::RimContact::peak_pressure), Pa.
  double peak_pressure() const { return hidden > pressure ? NAN : pressure; }
  /// NaN once a contact was at a rim, where no half-angle exists, rad.
  double largest_half_angle() const {
    return least_gap() > 0 ? half_angle : NAN;
  }
};

/// Results of one body.
struct BodyRecord {
  double peak_reaction = 0;  ///< at the hinge, N
  double peak_reaction_time = 0;
  double peak_lock = 0;  ///< at the lock, N
  double peak_lock_time = 0;
  double work = 0;       ///< work of friction, J
  double rest_time = 0;  ///< s
  double peak_stop = 0;  ///< moment of a stop, N m
  double peak_stop_time = 0;
  double impacts = 0;          ///< on stops
  double stop_impulses = 0;    ///< sum over rigid stops, N m s
  double largest_impulse = 0;  ///< the largest of them, N m s
  double stop_loss = 0;        ///< energy dissipated by stops, J
  double rest_on_stop = 0;     ///< s
  int on_stop = 0;             ///< 1: rests on a stop at the last evaluation
  double peak_latch = 0;       ///< moment of a latch, N m
  double peak_latch_time = 0;
  double latch_impulse = 0;  ///< the largest, N m s
  double latch_loss = 0;     ///< energy dissipated by latches, J
  std::vector<JointPeaks> joints;
  /// At the release of the hinge; time infinite if there was none.
  struct Release {
    double time = History::not_yet;
    double angle = 0;  ///< rad
    double rate = 0;   ///< rate of the angle on an axis, else |Dw|
    /// Dw, body axes, rad/s.
    Eigen::Vector3d rates = Eigen::Vector3d::Zero();
    /// Velocity of the centre of mass from the parent's, parent axes, m/s.
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  } release;
};

/// Motion of a body just before an event takes effect, or at the end.
struct TipOffRecord {
  double time = History::not_yet;
  Eigen::Vector3d rates = Eigen::Vector3d::Zero();     ///< body axes, rad/s
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< inertial axes, m/s
  /// Axis times angle, body axes to inertial ones, rad.
  Eigen::Vector3d attitude = Eigen::Vector3d::Zero();
  double across = NAN;  ///< rate across TipOff::direction, rad/s
  double mass = NAN;    ///< only if mass flows, kg
};

/// Something that happened, in words.
struct Note {
  double time;
  std::string body;
  std::string what;
  // Impacts only, else 0.
  double rate = 0;      ///< hinge's before it, on an axis with sign
  double impulse = 0;   ///< N m s; 0 on a compliant stop
  double loss = 0;      ///< energy lost, J
  double approach = 0;  ///< speed of approaching bodies, m/s
};

/// True if a run of the case can have such a note.
bool can_be_noted(const Note& note, const Case& c);

/// The smallest distance of two bodies.
struct PairRecord {
  double smallest = History::not_yet;  ///< m
  double time = 0;
  double overlap_from = History::not_yet;  ///< first and last time of overlap
  double overlap_to = 0;
};

/// Records a simulation at given times.
class Recorder {
 public:
  /// @param rows       keep the time history
  /// @param clearance  compute distances
  /// @param refine     search for peaks and smallest distances between these
  ///                   times
  Recorder(const Case& c, bool rows, bool clearance, bool refine);

  /// Records the present state as a row.
  void look(const Simulation& simulation);
  /// Records peaks and distances, without a row.
  void look_between(const Simulation& simulation);
  /// Records changes and peaks up to now, without a row.
  void catch_up(const Simulation& simulation) {
    look_at_changes(simulation);
    look_between(simulation);
  }
  /// Records due events: call before Simulation::apply().
  void before(const Simulation& simulation,
              const std::vector<Happening>& happenings);
  /// "", or the distance that could not be certified, with its time.
  const std::string& fault() const { return fault_; }
  /// Everything that must survive an interruption.
  struct Memory {
    Rows rows;
    std::vector<BodyRecord> bodies;
    std::vector<Note> notes;
    std::vector<PairRecord> pairs;
    std::vector<ForceRecord> forces;
    std::vector<TipOffRecord> tip_offs;
    std::vector<int> modes;  ///< mode of each body at the last look
    double last_time = 0;
    double first_balance = 0;
    double largest_drift = 0;   ///< drift of the energy balance, J
    double largest_energy = 0;  ///< scale of the drift, J
    bool begun = false;
  };
  const Memory& memory() const { return memory_; }
  /// Call at the end.
  Memory take_memory() { return std::move(memory_); }
  /// Continues from the state of another recorder.
  void restore(Memory memory) { memory_ = std::move(memory); }
  /// Continues with a restored simulation.
  void go_on_with(const Simulation& simulation);

 private:
  void look_at_peaks(const Simulation& simulation,
                     const multibody::MotionSample& sample, int body);
  Look look_back(const Simulation& simulation, double time);
  std::vector<double> known_peaks() const;
  void refine_peaks(const Simulation& simulation);
  void refine_between(const Simulation& simulation, const Look& from,
                      const Look& to);
  void add_hinge(const Simulation& simulation, int body);
  void look_at_changes(const Simulation& simulation);
  void note_change(const multibody::HingeChange& change, bool was_on_stop);
  void note_impact(const multibody::HingeImpact& impact);
  void look_at_distances(const Simulation& simulation, bool keep);
  void note_distance(std::size_t pair, double distance, double time);
  void search_distance(const Simulation& simulation, std::size_t pair);
  bool breaks(const Simulation& simulation,
              const std::vector<Happening>& happenings, std::size_t i) const;
  void look_at_energy(const Simulation& simulation, bool first);
  void add_motion(const Simulation& simulation, int number);
  void look_at_tip_offs(const Simulation& simulation, const Happening& h);
  void note_empty(const Simulation& simulation);
  void add(double number) { memory_.rows.numbers.push_back(number); }

  const Case& case_;
  bool keep_rows_;
  bool refine_;
  std::optional<Clearance> clearance_;
  std::vector<PairWay> ways_;  ///< one for each pair
  std::vector<double> seen_;   ///< peaks found by look_at_peaks()
  std::vector<Look> looks_;    ///< the last two on a smooth way
  std::size_t changes_seen_ = 0;
  std::size_t impacts_seen_ = 0;
  std::string fault_;
  Memory memory_;
};

}  // namespace separation
