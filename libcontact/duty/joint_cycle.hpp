// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "libcontact/duty/duty_cycle.hpp"
#include "libcontact/duty/lies.hpp"
#include "libcontact/duty/sliding_contact.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/validity.hpp"

namespace contact {

/// A joint on its duty cycle: friction at the times of the cycle and at the
/// Gauss points of its integrals. It has a cycle and a joint of its own; what
/// sliding() gives refers to the latter. Vectors are in carrier axes.
///
/// A cycle whose contact reaches a rim of its seat, is_at_rims(), is not smooth
/// in time: its integrals are sums over the rows by the trapezoidal rule, and
/// its largest values are taken over the rows.
///
/// A pin with a relief, or that Lies tilt or load at a place, ends: it is by
/// slices (Joint::lie()), and all is as smooth as without end. What needs an
/// axis of symmetry is NaN; the part of the reaction along the pin is left out.
///
/// Instants are large: short cycles keep them, long ones solve them again,
/// bit-identically, on request. Rows of cycles at rims are kept, the first
/// most_grids with the grids of their contacts, of 20 to 100 kB each;
/// Joint::with_grid() solves the grids of the others again.
class JointCycle {
  struct Series;

 public:
  /// Friction of the joint at one time of its cycle.
  struct Instant {
    double time;    ///< s
    double weight;  ///< in integrals over the period, s
    DutyCycle::State state;
    JointSolution solution;
    /// p v of a row at a rim; NaN of all other instants, see pv().
    ContactPv at_rim = {};
  };

  /// Instants one after the other; refers to the cycle.
  class Instants {
   public:
    struct Iterator {
      using value_type = Instant;
      using difference_type = std::ptrdiff_t;
      const JointCycle* cycle = nullptr;
      const Series* series = nullptr;
      std::size_t i = 0;

      Instant operator*() const { return cycle->instant(*series, i); }
      Iterator& operator++() {
        ++i;
        return *this;
      }
      Iterator operator++(int) {
        const Iterator before = *this;
        ++i;
        return before;
      }
      bool operator==(const Iterator& other) const { return i == other.i; }
    };

    std::size_t size() const { return series_->points.size(); }
    Instant operator[](std::size_t i) const {
      return cycle_->instant(*series_, i);
    }
    Iterator begin() const { return {cycle_, series_, 0}; }
    Iterator end() const { return {cycle_, series_, size()}; }

   private:
    friend class JointCycle;
    Instants(const JointCycle* cycle, const Series* series)
        : cycle_(cycle), series_(series) {}
    const JointCycle* cycle_;
    const Series* series_;
  };

  /// Least number of rows at rims for which a table of them is made.
  static constexpr int many = 60;
  /// Largest number of grids that are kept.
  static constexpr std::size_t most_grids = 300;

  /// @param joint  a pin turns about Z; without a table it gets one where
  ///               `many` rows or more reach a rim
  /// @param lies  of a pin; none: it is level
  /// @param progress  as of RimTableOptions
  /// @throws Error for lies of a ball, if the joint has no solution at some
  ///         time, and as Joint::tabulated(). Rows that leave their seat have
  ///         no numbers, nor have integrals over them, which notes() says.
  JointCycle(DutyCycle cycle, Joint joint, Lies lies = {},
             const std::function<void(double)>& progress = {});

  const DutyCycle& cycle() const { return cycle_; }
  /// The joint, with its table if one was made.
  const Joint& joint() const { return joint_; }
  const JointContact& contact() const { return joint_.contact(); }
  /// Whether an instant reaches a rim of its seat, or leaves the seat.
  bool is_at_rims() const { return at_rims_; }
  /// Instants at the times of the cycle; their weight is 0, in cycles at rims
  /// the weight of the trapezoidal rule.
  Instants rows() const& { return {this, &rows_}; }
  /// Instants of the integrals; the rows of a cycle at rims.
  Instants gauss_points() const& {
    return {this, at_rims_ ? &rows_ : &gauss_points_};
  }
  /// Would refer to a cycle that is gone.
  Instants rows() const&& = delete;
  Instants gauss_points() const&& = delete;
  /// The instant at any time. Its solution has the status out_of_range where
  /// the laws have no value, and out_of_seat where the ball leaves its seat.
  Instant at(double time) const noexcept;
  SlidingContact sliding(const Instant& instant) const& {
    return {contact(), instant.solution, instant.state.angular_velocity};
  }

  /// Deleted for temporaries: the result would refer to a destroyed joint.
  SlidingContact sliding(const Instant&) const&& = delete;
  /// p v over the contact of an instant; at a rim of rows alone.
  ContactPv pv(const Instant& instant) const;
  /// theta0, of a pin by slices the largest along it, rad; NaN at rims.
  double half_angle(const Instant& instant) const;
  /// rating_of() an instant; at a rim of rows alone.
  SlidingContact::Rating rating(const Instant& instant) const;

  /// Integrals over one period, made with the cycle; those by integral() are
  /// the same, to the last bit, and of a long cycle solve every instant again.
  struct Sums {
    double energy = 0;              ///< dissipated by friction, J
    double sliding_path = 0;        ///< integral of rho |Dw|, m
    double effective_distance = 0;  ///< integral of rho |Dw| L, m
    double pv = 0;      ///< integral of p v over contact and time, J
    double moment = 0;  ///< integral of |M_t|, N m s
  };
  const Sums& sums() const { return sums_; }

  using Quantity = std::function<double(const Instant&)>;
  /// Integral over one period, within 1e-9 for smooth cycles of 100 times
  /// (duty/joint_cycle_test.cpp).
  double integral(const Quantity& quantity) const;
  /// The instant with the largest value, to 1e-8: the largest of the rows,
  /// improved between its neighbours; a cycle at rims has the row as it is.
  /// Where contacts end a row with a contact but a value of NaN counts as the
  /// largest, for it may be.
  Instant largest(const Quantity& quantity) const;
  /// Instants of the largest peak pressure and p v: at rims those at
  /// report_distance or more from them, NaN if a row without has a larger mean.
  Instant largest_peak() const;
  Instant largest_pv() const;
  /// A number of the contact at the rims, as RimContact::gap(); NaN without a
  /// seat that ends, and without load.
  double of_rims(const Instant& instant,
                 double (RimContact::*of)() const) const;
  /// Share of the time in which the contact is at a rim.
  double rim_share() const;
  /// The row whose contact is nearest to a rim, and that with the largest K; of
  /// joints without a seat, and without load, one that has none.
  Instant least_gap() const;
  Instant largest_intensity() const;
  /// Largest half-angle and peak pressure of the cycle, for ContactLimits, each
  /// found as by largest(), and overlap with rims that were left out, of the
  /// rows.
  LargestContact largest_contact() const;
  /// A sentence for each reason to doubt rows at rims, and each limit that the
  /// largest contact passes.
  std::vector<std::string> notes() const;
  /// The sentences on rows at rims alone.
  const std::vector<std::string>& rim_notes() const { return rim_notes_; }
  /// Rotation from carrier axes to the axes of the body with the seat or hole.
  Eigen::Quaterniond to_seat(const Instant& instant) const;
  /// How far the contact wanders over the seat or hole in a cycle: root mean
  /// square of the angle between its centre and the middle of its places, in
  /// the seat's axes and with the weight of p v, rad; 0 without p v, NaN at
  /// rims and of pins by slices.
  double contact_spread() const;

 private:
  struct Series {
    std::vector<DutyCycle::GaussPoint> points;
    std::vector<Instant> kept;  // all of them, or none
  };
  Instant at(const DutyCycle::GaussPoint& point,
             const JointSolution& last = {}) const noexcept;
  Instant instant(const Series& series, std::size_t i) const;
  Series series(std::vector<DutyCycle::GaussPoint> points);
  Series rows_at_rims();
  void tabulate(const std::function<void(double)>& progress);
  Instant largest(const Quantity& quantity, const Quantity& mean) const;
  Quantity of_rims(double (RimContact::*of)() const) const {
    return [this, of](const Instant& i) { return of_rims(i, of); };
  }

  void add(const Instant& instant);
  ContactPv pv_without_axis(const Instant& instant) const;

  DutyCycle cycle_;
  Joint joint_;
  Lies lies_;
  bool at_rims_ = false;
  bool is_round_ = true;  // every contact has an axis of symmetry
  std::vector<std::string> rim_notes_;
  Sums sums_;
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();  // centres by p v, summed
  Eigen::Vector3d first_ = Eigen::Vector3d::Zero();   // the first of them
  Series rows_;
  Series gauss_points_;
};

}  // namespace contact
