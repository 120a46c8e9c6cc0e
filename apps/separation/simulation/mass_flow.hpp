#pragma once

#include <span>
#include <vector>

#include "multibody/system/force_model.hpp"
#include "separation/case/case.hpp"

namespace separation {

struct History;

/// Masses of bodies whose engines burn propellant, from one event to the next.
///
/// With the mass flow q = T/v_e at the nozzle, r the position of the nozzle
/// from the centre of mass, and c' the velocity of the centre of mass within
/// the body,
///
///     F = -2 w x (q r + m c'),  M = -I' w - q r x (w x r)
///
/// act on the body at its centre of mass in addition to the thrust T as
/// measured on a test stand. The flow in the body is assumed steady and does
/// not rotate about the centre of mass. The momentum of the body is m (v + w x
/// c) + q r + m c', where v is the velocity of its material.
class MassFlow {
 public:
  /// @param c  must outlive this object
  MassFlow(const Case& c, const History& history);

  /// Time at which a force of the case has used up its propellant.
  double empty_at(int force) const;
  /// Time at which engines without a known end have burned all of their body,
  /// which then cannot go on; infinite: never.
  double spent_at() const { return spent_at_; }
  /// Mass of a body of the case at a time; 0 is the carrier.
  multibody::BodyMass of(int body, double time) const;
  /// See ForceModel::add_masses().
  void add_masses(double time, std::vector<multibody::BodyMass>& to) const;
  void add_forces(double time, std::span<const multibody::BodyMotion> bodies,
                  std::span<multibody::BodyForce> forces) const;

 private:
  struct Engine {
    int force;
    int body;
    const ForceLaw* law;
    double begin, end, own;  // s
    double empty = 0;        // s
    /// Their decrease for each kg burned, m/kg and m^2.
    Eigen::Vector3d com = Eigen::Vector3d::Zero();
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();

    double rate(double time) const;    // kg/s
    double burned(double time) const;  // kg
  };

  double first_spent() const;

  const Case& case_;
  std::vector<Engine> engines_;
  std::vector<int> bodies_;
  double spent_at_;  // s
};

}  // namespace separation
