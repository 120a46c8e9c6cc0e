#pragma once

#include <map>
#include <string>

#include "libcontact/base/units.hpp"
#include "libcontact/seat/contact.hpp"
#include "support/reference_table.hpp"

// Rows of data/reference/side_face/cups.csv.
namespace contact::test {

/// A ball in a cup of one layer on a rigid backing.
struct Cup {
  double thickness = 0.3;  // over the radius
  double rim = 60;         // deg
  double corner = 90;      // deg
  Material seat = {210e9, 0.3};
  Material ball = {210e9, 0.3};
  double radius = 0.01;

  LayeredBody body() const {
    return {{{thickness * radius, seat}}, Backing::rigid()};
  }
  SeatZone zone() const {
    return SeatZone::cup(rim * degree).with_edge({.angle = corner * degree});
  }
  JointSpec joint() const {
    return {.geometry = JointGeometry::ball(radius, radius / 1000),
            .inner = ball,
            .outer = body()};
  }
  SeatContact contact() const { return {joint(), zone()}; }
};

inline Cup cup_of(const ReferenceTable::Row& row) {
  const std::map<std::string, double> poissons_ratio = {
      {"steel_bronze", 0.34},
      {"steel_steel", 0.3},
      {"steel_pe", 0.46},
      {"cocr_pe_library", 0.4}};
  const std::string seat = row.text("seat");
  Cup cup{row.value("t_over_rho"), row.value("rim_deg"),
          row.value("corner_deg")};
  cup.seat.poissons_ratio = poissons_ratio.at(seat);
  if (seat == "steel_bronze") cup.seat.youngs_modulus = 110e9;
  if (seat.find("pe") != std::string::npos && seat != "steel_bronze") {
    cup.seat.youngs_modulus = 800e6;
    cup.radius = 0.014;
  }
  if (seat == "cocr_pe_library") {
    cup.seat.youngs_modulus = 1e9;
    cup.ball.youngs_modulus = 230e9;
  }
  return cup;
}

}  // namespace contact::test
