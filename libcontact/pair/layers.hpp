// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "libcontact/pair/material.hpp"

/// Bodies of finite walls: liners, cups and bushes on a backing, coatings on
/// a ball or pin. docs/explanation/walls.md.
namespace contact {

/// A layer, bonded to its neighbours on both sides.
struct Layer {
  double thickness;   ///< m, > 0
  Material material;  ///< elastic

  friend bool operator==(const Layer&, const Layer&) = default;
};

/// Body behind the layers.
class Backing {
 public:
  enum class Kind {
    rigid,   ///< the last layer is bonded to a body that does not deform
    held,    ///< a free surface, but for a normal traction like cos t on it
             ///< that balances the load
    medium,  ///< elastic: infinite behind a wall, the core of a ball or pin
  };

  static Backing rigid() {
    return Backing(Kind::rigid, {std::numeric_limits<double>::infinity(), 0});
  }
  static Backing held() { return Backing(Kind::held, {}); }
  /// @param material  if it is rigid, the kind is rigid()
  static Backing medium(Material material);

  Kind kind() const { return kind_; }
  /// Material of a medium or a rigid body.
  const Material& material() const { return material_; }

  friend bool operator==(const Backing&, const Backing&) = default;

 private:
  Backing(Kind kind, Material material)
      : kind_(kind), material_(std::move(material)) {}

  Kind kind_;
  Material material_;
};

/// An inner or outer body, seen from the contact: its layers, the one at the
/// contact first, and the body behind them. Without layers it is the backing
/// alone.
struct LayeredBody {
  /// A body of one material.
  LayeredBody(Material material)  // NOLINT(google-explicit-constructor)
      : backing(Backing::medium(std::move(material))) {}
  LayeredBody(std::vector<Layer> of, Backing behind)
      : layers(std::move(of)), backing(std::move(behind)) {}

  std::vector<Layer> layers;
  Backing backing;

  /// The material at the contact. Of a body that is held alone there is none:
  /// Young's modulus 0.
  const Material& surface() const {
    return layers.empty() ? backing.material() : layers.front().material;
  }

  friend bool operator==(const LayeredBody&, const LayeredBody&) = default;
};

/// A sentence for each body that ends in the material of a liner: without
/// layers, or as an elastic medium behind them.
std::vector<std::string> infinite_liner_notes(const LayeredBody& inner,
                                              const LayeredBody& outer);

/// The two bodies of a joint whose walls count, validated once.
class LayeredPair {
 public:
  /// Thinner layers would take more than 2e6 harmonics.
  static constexpr double smallest_relative_thickness = 1e-5;

  /// @param radius  rho of the contact, m, > 0
  /// @param inner   ball or pin: its coatings, from the contact inwards, and
  ///                its core, elastic or rigid
  /// @param outer   seat or hole: its layers, from the contact outwards, and
  ///                their backing
  /// @throws Error if a thickness, a material or a backing is not allowed.
  LayeredPair(double radius, LayeredBody inner, LayeredBody outer);

  double radius() const { return radius_; }
  const LayeredBody& inner() const { return inner_; }
  const LayeredBody& outer() const { return outer_; }
  /// The materials at the two surfaces: E, Ebar, the compliance shares and
  /// beta, and with them the load parameters, refer to this pair.
  const ElasticPair& surfaces() const { return surfaces_; }
  /// Thickness of the thinner one of the two layers at the contact over the
  /// radius; infinite if no body has layers.
  double relative_thickness() const;

  friend bool operator==(const LayeredPair&, const LayeredPair&) = default;

 private:
  double radius_;
  LayeredBody inner_;
  LayeredBody outer_;
  ElasticPair surfaces_;
};

}  // namespace contact
