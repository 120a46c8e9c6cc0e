// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libcontact/half_angle/factory.hpp"
#include "libcontact/joint/contact.hpp"
#include "libcontact/pair/contact_conditions.hpp"
#include "libcontact/pair/fit.hpp"
#include "libcontact/pair/friction_law.hpp"
#include "libcontact/pair/inner_loading.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/layers.hpp"
#include "libcontact/pair/relief.hpp"
#include "libcontact/pair/spherical_bearing.hpp"
#include "libcontact/pair/temperatures.hpp"
#include "libcontact/pressure/factory.hpp"

namespace contact {

class SharedLaws;

namespace detail {
struct SeatGrids;
}  // namespace detail

/// Growth of the clearance of a joint that is warmer or colder than when its
/// clearance was measured: docs/how-to/interference.md.
struct ThermalGrowth {
  Temperatures temperatures;
  double reference_clearance;  ///< at temperatures.reference, m
  double inner;  ///< how far the surface of the ball or pin has grown, m
  double outer;  ///< the same for the seat or hole, m
  /// Largest strain alpha dT of all materials, in size.
  double largest_strain;

  /// A sentence if largest_strain is beyond 0.5 %.
  std::vector<std::string> validity_notes() const;

  friend bool operator==(const ThermalGrowth&, const ThermalGrowth&) = default;
};

/// A joint as a person describes it, each fact once: a value. Files, options, C
/// and Python make one of these.
///
///     const contact::Joint hip({.geometry = JointGeometry::ball(0.014, 1e-4),
///                               .inner = cobalt,
///                               .outer = {{{0.008, polyethylene}},
///                                         Backing::rigid()},
///                               .friction = FrictionLaw(0.0587)});
///
/// The functions throw Error for numbers and laws that do not go together.
struct JointSpec {
  std::string name = {};  ///< for people
  JointGeometry geometry;
  /// Fit that the geometry comes from, if any.
  std::optional<Fit> fit = {};
  /// Bearing that the geometry comes from, if any.
  std::optional<SphericalBearing> bearing = {};
  /// Growth that at() has added to the clearance, if any.
  std::optional<ThermalGrowth> thermal_growth = {};
  /// Ball or pin: its material, or coatings and a core.
  LayeredBody inner;
  /// Seat or hole: its material, which then has no end, or layers and their
  /// backing.
  LayeredBody outer;
  std::optional<FrictionModel> friction = {};
  InnerLoading loading = InnerLoading::centre();
  /// Relief of the ends of a pin or its hole.
  Relief relief = Relief::none();
  /// For make_half_angle_law(); "": exact with layers, with interference and in
  /// a seat that ends, else fitted.
  std::string half_angle_law = {};
  HalfAngleOptions half_angle_options = {};
  /// For make_pressure_law(); "": exact.
  std::string pressure_law = {};

  /// The joint at these temperatures: the clearance of the geometry, or the one
  /// from which it had grown, plus the free growth of both surfaces. Linear in
  /// the differences of temperature; moduli do not change.
  /// @throws Error if a material that grows has no thermal_expansion.
  JointSpec at(Temperatures temperatures) const;

  /// The joint in a seat without end, for comparison and where a load has no
  /// direction. A bearing is left out with its ring; ContactLimits still notes
  /// contacts that would reach a rim.
  JointSpec without_seat() const;

  /// The joint with a straight pin in a straight hole.
  JointSpec without_relief() const;

  /// contact() is all of it: no seat that ends, no relief.
  bool is_endless() const;
  /// What contact() has of it.
  JointSpec endless() const;

  /// The materials at the surfaces.
  ElasticPair pair() const { return {inner.surface(), outer.surface()}; }
  /// Loading, and walls where a body has layers.
  ContactConditions conditions() const;
  /// The laws by their names, where there is none the one that is taken.
  std::string half_angle_law_name() const;
  std::string pressure_law_name() const;

  /// Contact that a Joint is made from.
  /// @throws Error if there is no friction
  JointContact contact() const;
  /// The same, of several joints that share their laws.
  JointContact contact(SharedLaws& laws) const;

  std::unique_ptr<HalfAngleLaw> make_half_angle_law() const;
  std::unique_ptr<PressureLaw> make_pressure_law() const;
  /// Load from and to load parameter.
  LoadScale load_scale() const { return {geometry, pair()}; }
  /// Origin of a clearance that is not given itself, a sentence each: fit and
  /// temperatures.
  std::vector<std::string> clearance_notes() const;
  /// Notes of the description alone: of its growth, and of a relief, which a
  /// contact without end leaves out.
  std::vector<std::string> own_notes() const;
  /// Notes of the geometry, own_notes(), and notes of the half-angle law.
  std::vector<std::string> validity_notes() const;

  /// The joint as the text of a joint file (docs/reference/joint_file.md) that
  /// needs no other file, in SI units and with all digits: read again it gives
  /// an equal joint, and joints whose texts are equal are equal. A friction
  /// stress that is one's own function has no keys; it stands there as law =
  /// "own", which cannot be read.
  std::string canonical_text() const;

  friend bool operator==(const JointSpec&, const JointSpec&) = default;
};

/// The laws of joints that belong together: one for all that it is made for, as
/// MadeFor says. Friction, clearance and radius do not count (the latter only
/// where there are walls), nor do moduli of the same ratio.
class SharedLaws {
 public:
  /// As the functions of JointSpec make them.
  std::shared_ptr<const HalfAngleLaw> half_angle(const JointSpec& joint);
  std::shared_ptr<const PressureLaw> pressure(const JointSpec& joint);

  /// The grids of a joint in a seat that ends: alike for all frictions.
  /// @throws Error as SeatContact
  std::shared_ptr<const detail::SeatGrids> seat(const JointSpec& joint);

  /// How many laws there are, of both kinds.
  std::size_t size() const { return half_angle_.size() + pressure_.size(); }

 private:
  struct HalfAngle {
    std::string name;
    HalfAngleOptions options;
    std::shared_ptr<const HalfAngleLaw> law;
  };
  struct Pressure {
    std::string name;
    std::shared_ptr<const PressureLaw> law;
  };

  struct Seat {
    JointSpec of;
    std::shared_ptr<const detail::SeatGrids> grids;
  };

  std::vector<HalfAngle> half_angle_;
  std::vector<Pressure> pressure_;
  std::vector<Seat> seats_;
};

}  // namespace contact
