#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/layers.hpp"

namespace contact::detail {

/// Displacement of a surface into its body under a unit pressure of one
/// harmonic, P_n(cos t) or cos nt, in units of 4 rho/E.
struct HarmonicCompliance {
  /// c_n; for n = 1 by a normal traction that the body's far end, a uniform
  /// body force (solid inner body) or infinity (outer one) balances. NaN for
  /// a pin in an infinite body and n = 1, which has no value.
  double total;
  /// Dc_n = c_n less the c_n of a homogeneous body of the surface's material;
  /// keeps its relative accuracy even where it is tiny. 0 for n = 1.
  double correction;
};

/// Compliances of one body of bonded layers
/// (docs/internals/conforming_methods.md). Poisson's ratio 1/2 is an ordinary
/// value everywhere.
///
/// Accuracy (conforming/layer_compliance_test.cpp): relative error of c_n below
/// 1e-10 on 311 values of a 60-digit solution, layers of 1e-4 to 0.5 radii.
class LayerCompliance {
 public:
  enum class Side { inner, outer };

  /// @param radius   rho, m
  /// @param modulus  E that the results are scaled with, Pa
  LayerCompliance(JointKind kind, Side side, const LayeredBody& body,
                  double radius, double modulus);
  /// Compliance of a body, scaled with the pair's radius and effective modulus.
  LayerCompliance(JointKind kind, Side side, const LayeredPair& pair);

  /// @param n  harmonic, 0, 1, 2, ...
  HarmonicCompliance operator()(int n) const;

  /// The displacement (U, V) of the surface, over rho, to tractions (S, T) of
  /// one harmonic on it from the side of the contact, positive along the radius
  /// and dY/dt, of size E: u_r = U Y, u_t = V dY/dt with Y = P_n^1(cos t)
  /// cos(phi) or cos nt. The first is 4 c_n. n = 1 of a solid inner body:
  /// balanced by a uniform body force, against the mean over its volume; of a
  /// pin's infinite hole against 10 radii.
  /// @param n  harmonic, 1, 2, ...
  Eigen::Matrix2d spheroidal(int n) const;

  /// The displacement along the circles to a toroidal traction; of balls n = 1,
  /// 2, ..., of pins n = 0. The turn of a solid inner body is due to a uniform
  /// angular acceleration, against its mean.
  double toroidal(int n) const;

  /// Number of the first harmonics whose Dc_n count: what is beyond changes
  /// the load by less than 1e-12. 0 for a homogeneous body.
  int corrected() const;

  /// How far the surface moves from the centre, over rho, when the body grows
  /// without contact.
  ///
  /// @param layers  e* of each: the strain around the axis or centre with which
  ///                it would grow by itself
  /// @param behind e* of the body behind them; of a rigid body, how far its
  ///                surface grows, over its radius
  ///
  /// Accuracy (joint/thermal_growth_test.cpp): relative error below 1e-13
  /// of bodies of two layers.
  double free_growth(std::span<const double> layers, double behind) const;

 private:
  using States = Eigen::Matrix<double, 4, 2>;
  /// A material with its modulus in units of E, as the equations need it.
  struct Elastic {
    Elastic(const Material& material, double unit);
    double nu;
    double shear;  // G
    double a;      // nu/(1 - nu)
    double m;      // (1 - 2 nu)/(2 G (1 - nu))
  };
  struct Shell {
    Elastic elastic;
    double width;  // ln of the ratio of its radii
  };
  struct Harmonic;

  double homogeneous(int n) const;
  double mean() const;
  Eigen::Vector2d admissible_mean() const;
  Eigen::Vector2d cross_mean(const Shell& shell, Eigen::Vector2d y) const;
  HarmonicCompliance layered(int n) const;
  double body_force() const;
  Eigen::Matrix<double, 6, 3> body_columns() const;
  double turn_of_body() const;
  States line_force(const Harmonic& harmonic) const;
  States far_end(const Harmonic& harmonic) const;

  JointKind kind_;
  Side side_;
  Backing::Kind backing_;
  std::optional<Elastic> medium_;
  std::vector<Shell> shells_;  // the one at the contact first
  double medium_radius_ = 1;   // inner end, over rho
  double poisson_ = 0;         // at the surface
  double share_ = 0;  // its n c_n for large n: (1 - nu^2) E/(2 E_surface)
};

}  // namespace contact::detail
