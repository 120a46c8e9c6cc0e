#include "libcontact/files/worn_seat_file.hpp"

#include <cmath>
#include <numbers>

#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/files/toml_reader.hpp"

namespace contact {
namespace {

KnownKeys worn_seat_keys() {
  return {word_key("kind", {"pin", "ball"}),
          {"radius", Dimension::length},
          {"radial_clearance", Dimension::length},
          number_key("cycles", Interval::non_negative()),
          number_key("pole", {-1, 1}),
          number_key("reach", Dimension::angle,
                     {10 * degree, std::numbers::pi * (1 + 1e-12)}),
          {"depth", Dimension::length}};
}

std::string list_of(const double* begin, std::size_t count) {
  std::string text = "[";
  constexpr std::size_t in_line = 4;
  for (std::size_t i = 0; i < count; ++i) {
    text += i == 0 ? "" : i % in_line == 0 ? ",\n  " : ", ";
    text += detail::message("{}", begin[i]);
  }
  return text + "]\n";
}

void check_length(const TomlTable& table, std::string_view key, double length,
                  const JointGeometry& geometry) {
  const double there = table.number(key);
  if (std::abs(there - length) <= 1e-9 * geometry.radius()) return;
  table.must_be(key, detail::message("{:.9g} m, that of the joint", length));
}

}  // namespace

std::string worn_seat_text(const WornSeat& seat,
                           const JointGeometry& geometry) {
  const bool is_ball = geometry.kind() == JointKind::ball;
  std::string text = detail::message(
      "# What is worn off a seat or hole, in the axes of its body.\n"
      "kind = \"{}\"\nradius = {}\nradial_clearance = {}\ncycles = {}\n",
      to_string(geometry.kind()), geometry.radius(),
      geometry.radial_clearance(), seat.cycles);
  if (is_ball) {
    text += "pole = " + list_of(seat.pole.data(), 3) +
            detail::message("reach = {}\n", seat.reach);
  }
  return text + "depth = " + list_of(seat.depths.data(), seat.depths.size());
}

WornSeat read_worn_seat(const std::filesystem::path& path,
                        const JointGeometry& geometry) {
  const TomlTable table = TomlTable::from_file(path, worn_seat_keys());
  const bool is_ball = geometry.kind() == JointKind::ball;
  const std::string kind = to_string(geometry.kind());
  if (table.choice("kind") != (is_ball ? 1u : 0u)) {
    table.must_be("kind", kind + ", as the joint is");
  }
  check_length(table, "radius", geometry.radius(), geometry);
  check_length(table, "radial_clearance", geometry.radial_clearance(),
               geometry);
  WornSeat seat;
  seat.cycles = table.number("cycles");
  if (is_ball) {
    const auto pole = table.numbers("pole", {3});
    seat.pole = {pole[0], pole[1], pole[2]};
    if (std::abs(seat.pole.norm() - 1) > 1e-6) {
      table.must_be("pole", "a unit vector");
    }
    seat.pole.normalize();
    seat.reach = std::min(table.number("reach"), std::numbers::pi);
  }
  seat.depths = table.numbers("depth", {worn_points(geometry.kind(), seat)},
                              {0, geometry.radius()});
  table.refuse_idle();
  return seat;
}

}  // namespace contact
