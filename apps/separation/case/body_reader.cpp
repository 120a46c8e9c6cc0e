#include "separation/case/body_reader.hpp"

#include "libcontact/base/error.hpp"
#include "libcontact/base/linear/parts.hpp"
#include "separation/case/reading.hpp"

namespace separation {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Shape read_hull(const TomlTable& table) {
  const auto numbers = table.numbers("points", {4, 3, true});
  std::vector<Vector3d> points;
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  try {
    return convex_hull(points);
  } catch (const contact::Error& error) {
    table.fail("points", error.what());
  }
}

Shape read_box(const TomlTable& table) {
  const auto size = table.numbers("size", {3});
  return box(
      vector_or_zero(table, "centre"), {size[0], size[1], size[2]},
      optional_rotation(table, "rotation").value_or(Matrix3d::Identity()));
}

Shape read_shape(const TomlTable& table) {
  constexpr std::size_t box_choice = 4;  // a hull by other keys
  const std::size_t choice = table.choice("kind");
  if (choice == box_choice) return read_box(table);
  const auto kind = static_cast<ShapeKind>(choice);
  if (kind == ShapeKind::hull) return read_hull(table);
  Shape shape{kind};
  shape.from = vector(table, "from");
  shape.to = vector(table, "to");
  shape.radius = table.number("radius");
  if (!((shape.to - shape.from).norm() > 0) && kind != ShapeKind::capsule) {
    table.must_be("to", "a point apart from \"from\"");
  }
  return shape;
}

// Checks that no principal moment exceeds the sum of the other two.
void check_inertia(const TomlTable& table, std::string_view key,
                   const Matrix3d& inertia) {
  const double scale = inertia.cwiseAbs().maxCoeff();
  if ((inertia - inertia.transpose()).cwiseAbs().maxCoeff() > 1e-9 * scale) {
    table.must_be(key, "a symmetric matrix");
  }
  const Vector3d moments = contact::detail::symmetric_parts(inertia).values;
  // Rounding of entries with some digits, not of doubles.
  const double slack = 1e-6 * scale;
  if (moments[0] < -slack || moments[2] > moments[0] + moments[1] + slack) {
    table.must_be(key,
                  "principal moments of a body: none negative, none "
                  "above the sum of the other two");
  }
}

// Name, shapes and directions.
RigidBody read_form(const TomlTable& table) {
  RigidBody body;
  body.name = column_text(table, "name");
  for (const TomlTable& shape : table.tables("shape")) {
    body.shapes.push_back(read_shape(shape));
    body.shapes.back().name = shape.optional_text("name").value_or("");
  }
  for (const TomlTable& named : table.tables("direction")) {
    body.directions.push_back({named.text("name"), direction(named, "vector")});
  }
  return body;
}

}  // namespace

bool is_below(const Matrix3d& inertia, const Matrix3d& other) {
  const Matrix3d rest = other - inertia;
  return contact::detail::symmetric_parts(rest).values[0] >=
         -1e-9 * other.norm();
}

std::string inertia_key(const TomlTable& table, const std::string& prefix) {
  const std::string principal = prefix + "principal_inertia";
  return table.has(principal) ? principal : prefix + "inertia";
}

std::optional<Matrix3d> read_inertia(const TomlTable& table,
                                     const std::string& prefix) {
  const std::string rows = prefix + "inertia";
  const std::string principal = prefix + "principal_inertia";
  if (const auto m = table.optional_numbers(rows, {3, 3})) {
    table.refuse_both(rows, principal);
    const Matrix3d inertia = Eigen::Map<const Matrix3d>(m->data());
    check_inertia(table, rows, inertia);
    return inertia;
  }
  if (const auto moments = optional_vector(table, principal)) {
    const Matrix3d inertia = moments->asDiagonal();
    check_inertia(table, principal, inertia);
    return inertia;
  }
  return {};
}

RigidBody read_carrier(const TomlTable& table) {
  if (!table.flag("fixed")) return read_rigid_body(table);
  for (const char* key : {"mass", "density_kg_per_m3", "com", "inertia",
                          "principal_inertia", "drive"}) {
    table.refuse_both(key, "fixed");
  }
  RigidBody carrier = read_form(table);
  carrier.fixed = true;
  return carrier;
}

RigidBody read_rigid_body(const TomlTable& table) {
  RigidBody body = read_form(table);
  const auto mass = table.optional_number("mass");
  const auto density = table.optional_number("density_kg_per_m3");
  const auto inertia = read_inertia(table);
  const auto com = optional_vector(table, "com");
  table.refuse_both("density_kg_per_m3", "mass");
  if (!mass && !density) table.number("mass");
  if (body.shapes.empty() && !inertia) {
    table.needs("inertia, or shapes to take it from");
  }
  if (body.shapes.empty() && !mass) {
    table.needs("density_kg_per_m3", "shapes");
  }
  body.com = com.value_or(Vector3d::Zero());
  if (body.shapes.empty()) {
    body.mass = *mass;
    body.inertia = *inertia;
    return body;
  }
  const SolidProperties solid = solid_properties(body.shapes);
  body.mass = mass ? *mass : *density * solid.volume;
  body.inertia =
      inertia ? *inertia : Matrix3d(body.mass / solid.volume * solid.inertia);
  if (!inertia && !com) body.com = solid.centroid;
  for (Shape& shape : body.shapes) shape.move(-body.com);
  return body;
}

}  // namespace separation
