#include "libcontact/pair/layers.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "libcontact/base/check.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace contact {
namespace {

using detail::infinity;

void check_layers(const LayeredBody& body, double radius, const char* layer) {
  int number = 0;
  for (const Layer& l : body.layers) {
    const std::string place = detail::message("{} {}", layer, ++number);
    detail::require(l.thickness > 0, place, "thickness", l.thickness,
                    "above 0 m");
    detail::require(
        l.thickness >= LayeredPair::smallest_relative_thickness * radius, place,
        "thickness", l.thickness,
        detail::message("at least 1e-5 of the radius of {:g} m", radius));
    detail::check_material(l.material, place);
    detail::require(std::isfinite(l.material.youngs_modulus), place,
                    "youngs_modulus", l.material.youngs_modulus,
                    "finite; a rigid body is a backing");
  }
  if (body.backing.kind() == Backing::Kind::medium) {
    detail::check_material(body.backing.material(),
                           detail::message("body behind {}s", layer));
  }
}

// The arguments of LayeredPair as they are used by its surfaces.
void check(double radius, const LayeredBody& inner, const LayeredBody& outer) {
  detail::require(radius > 0, "layered pair", "radius", radius, "above 0 m");
  check_layers(inner, radius, "coating");
  check_layers(outer, radius, "wall layer");
  double coatings = 0;
  for (const Layer& l : inner.layers) coatings += l.thickness;
  detail::require(coatings < radius, "coatings", "thickness", coatings,
                  detail::message("below the radius of {:g} m", radius));
  if (inner.backing.kind() == Backing::Kind::held) {
    throw Error(
        detail::must_be("coatings: backing = held", "rigid or a material"));
  }
  if (outer.layers.empty() && outer.backing.kind() == Backing::Kind::held) {
    throw Error(detail::needs("wall: backing = held", "at least one layer"));
  }
}

}  // namespace

Backing Backing::medium(Material material) {
  const bool is_rigid = material.youngs_modulus == infinity;
  return Backing(is_rigid ? Kind::rigid : Kind::medium, std::move(material));
}

LayeredPair::LayeredPair(double radius, LayeredBody inner, LayeredBody outer)
    : radius_((check(radius, inner, outer), radius)),
      inner_(std::move(inner)),
      outer_(std::move(outer)),
      surfaces_(inner_.surface(), outer_.surface()) {}

double LayeredPair::relative_thickness() const {
  double thinnest = infinity;
  for (const LayeredBody* body : {&inner_, &outer_}) {
    if (body->layers.empty()) continue;
    thinnest = std::min(thinnest, body->layers.front().thickness);
  }
  return thinnest / radius_;
}

std::vector<std::string> infinite_liner_notes(const LayeredBody& inner,
                                              const LayeredBody& outer) {
  std::vector<std::string> notes;
  for (const auto& [body, which, key] :
       {std::tuple{&inner, "inner", "coating"}, {&outer, "outer", "wall"}}) {
    const Material& end = body->backing.material();
    if (body->backing.kind() != Backing::Kind::medium || !end.liner) continue;
    notes.push_back(detail::message(
        "the {} body{} is a liner, but modelled as unbounded: unless the "
        "contact is small compared with its thickness, the contact is "
        "overestimated and its pressure underestimated; give its thickness and "
        "backing in a [{}]",
        which, end.name.empty() ? "" : ", " + end.name + ",", key));
  }
  return notes;
}

}  // namespace contact
