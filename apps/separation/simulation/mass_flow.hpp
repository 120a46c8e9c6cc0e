#pragma once

#include <span>
#include <vector>

#include "multibody/system/force_model.hpp"
#include "separation/case/case.hpp"

namespace separation {

struct History;

/// Masses of bodies whose engines burn something, from one event to the next.
///
/// With q = T/v_e the mass that leaves in a second, at the nozzle, r from the
/// centre of mass, and c' the rate of that in the body,
///
///     F = -2 w x (q r + m c'),  M = -I' w - q r x (w x r)
///
/// act on the body at its centre of mass beside the thrust T, which is what a
/// test stand measures: the flow in the body is steady and does not turn about
/// the centre of mass. Its momentum is m (v + w x c) + q r + m c', v that of
/// the body's material.
class MassFlow {
 public:
  /// @param c  has to outlive this object
  MassFlow(const Case& c, const History& history);

  /// When a force of the case has used up what it burns.
  double empty_at(int force) const;
  /// When engines without a known end have burned all of their body, which can
  /// not go on then; infinite: never.
  double spent_at() const;
  /// A body of the case, (0) the carrier, at a time.
  multibody::BodyMass of(int body, double time) const;
  /// As ForceModel has them.
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
    /// By how much these fall with each kg, m/kg and m^2.
    Eigen::Vector3d com = Eigen::Vector3d::Zero();
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();

    double rate(double time) const;    // kg/s
    double burned(double time) const;  // kg
  };

  const Case& case_;
  std::vector<Engine> engines_;
  std::vector<int> bodies_;
};

}  // namespace separation
