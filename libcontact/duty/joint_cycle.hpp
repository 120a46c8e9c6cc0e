#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "libcontact/duty/duty_cycle.hpp"
#include "libcontact/duty/sliding_contact.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/validity.hpp"

namespace contact {

/// A joint on its duty cycle: friction at the times of the cycle and at the
/// Gauss points of its integrals. It has a cycle and a joint of its own; what
/// sliding() gives refers to the latter.
///
/// Instants are large: those of short cycles are kept, those of long ones are
/// solved again, to the same bits, whenever they are asked for.
class JointCycle {
  struct Series;

 public:
  /// Friction of the joint at one time of its cycle.
  struct Instant {
    double time;    ///< s
    double weight;  ///< in integrals over the period, s
    DutyCycle::State state;
    JointSolution solution;
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

  /// @param joint  a pin turns about Z
  /// @throws Error if the laws of the contact have no value at some time.
  JointCycle(DutyCycle cycle, Joint joint);

  const DutyCycle& cycle() const { return cycle_; }
  const JointContact& contact() const { return joint_.contact(); }
  /// Instants at the times of the cycle; their weight is 0.
  Instants rows() const& { return {this, &rows_}; }
  Instants gauss_points() const& { return {this, &gauss_points_}; }
  /// Would refer to a cycle that is gone.
  Instants rows() const&& = delete;
  Instants gauss_points() const&& = delete;
  /// Its solution has the status out_of_range where the laws have no value.
  Instant at(double time) const noexcept;
  SlidingContact sliding(const Instant& instant) const& {
    return {contact(), instant.solution, instant.state.angular_velocity};
  }

  /// Would refer to a joint that is gone.
  SlidingContact sliding(const Instant&) const&& = delete;

  /// Integrals over one period, made with the cycle; those by integral() are
  /// the same, to the last bit, and of a long cycle solve every instant again.
  struct Sums {
    double energy = 0;              ///< dissipated by friction, J
    double sliding_path = 0;        ///< integral of rho |Dw|, m
    double effective_distance = 0;  ///< integral of rho |Dw| L, m
    double pv = 0;      ///< integral of SlidingContact::pv_total(), J
    double moment = 0;  ///< integral of |M_t|, N m s
  };
  const Sums& sums() const { return sums_; }

  using Quantity = std::function<double(const Instant&)>;
  /// Integral over one period, within 1e-9 for smooth cycles of 100 times
  /// (duty/joint_cycle_test.cpp).
  double integral(const Quantity& quantity) const;
  /// The largest value, to 1e-8: the largest of the rows, improved between its
  /// neighbours.
  Instant largest(const Quantity& quantity) const;
  /// Largest half-angle and peak pressure of the cycle, for ContactLimits, each
  /// found as by largest(), and overlap with rims, of the rows.
  LargestContact largest_contact() const;
  /// Turn from carrier axes to those of the body that has the seat or hole.
  Eigen::Quaterniond to_seat(const Instant& instant) const;
  /// How far the contact wanders over the seat or hole in a cycle: root mean
  /// square of the angle between its centre and the middle of its places, in
  /// the seat's axes and with the weight of p v, rad; 0 without p v.
  double contact_spread() const;

 private:
  struct Series {
    std::vector<DutyCycle::GaussPoint> points;
    std::vector<Instant> kept;  // all of them, or none
  };
  Instant at(const DutyCycle::GaussPoint& point) const noexcept;
  Instant instant(const Series& series, std::size_t i) const;
  Series series(std::vector<DutyCycle::GaussPoint> points);

  void add(const Instant& instant);

  DutyCycle cycle_;
  Joint joint_;
  Sums sums_;
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();  // centres by p v, summed
  Eigen::Vector3d first_ = Eigen::Vector3d::Zero();   // the first of them
  Series rows_;
  Series gauss_points_;
};

}  // namespace contact
