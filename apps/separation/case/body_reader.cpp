#include "separation/case/body_reader.hpp"

#include <Eigen/Eigenvalues>

#include "libcontact/base/error.hpp"
#include "separation/case/reading.hpp"

namespace separation {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Shape read_hull(const TomlTable& table) {
  const auto numbers =
      table.rows("points", 4, 3, Interval::any(), Dimension::length);
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

Shape read_shape(const TomlTable& table) {
  const auto kind = static_cast<ShapeKind>(
      table.choice("kind", {"capsule", "cylinder", "cone", "hull"}));
  if (kind == ShapeKind::hull) return read_hull(table);
  Shape shape{kind};
  shape.from = vector(table, "from", Dimension::length);
  shape.to = vector(table, "to", Dimension::length);
  shape.radius =
      table.number("radius", Interval::positive(), Dimension::length);
  if (!((shape.to - shape.from).norm() > 0) && kind != ShapeKind::capsule) {
    table.fail("to", "allowed: a point apart from \"from\"");
  }
  return shape;
}

// Of the three principal moments none may exceed the sum of the others.
void check_inertia(const TomlTable& table, std::string_view key,
                   const Matrix3d& inertia) {
  const double scale = inertia.cwiseAbs().maxCoeff();
  if ((inertia - inertia.transpose()).cwiseAbs().maxCoeff() > 1e-9 * scale) {
    table.fail(key, "allowed: a symmetric matrix");
  }
  const Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Matrix3d>(inertia).eigenvalues();
  // Rounding of entries with some digits, not of doubles.
  const double slack = 1e-6 * scale;
  if (moments[0] < -slack || moments[2] > moments[0] + moments[1] + slack) {
    table.fail(key,
               "allowed: principal moments of a body: none negative, none "
               "above the sum of the other two");
  }
}

std::optional<Matrix3d> read_inertia(const TomlTable& table) {
  if (const auto m = table.optional_matrix("inertia", 3, 3, Interval::any(),
                                           Dimension::inertia)) {
    if (table.has("principal_inertia", Dimension::inertia)) {
      table.fail("inertia", "allowed: not together with principal_inertia");
    }
    const Matrix3d inertia = Eigen::Map<const Matrix3d>(m->data());
    check_inertia(table, "inertia", inertia);
    return inertia;
  }
  if (const auto moments =
          optional_vector(table, "principal_inertia", Dimension::inertia)) {
    const Matrix3d inertia = moments->asDiagonal();
    check_inertia(table, "principal_inertia", inertia);
    return inertia;
  }
  return {};
}

}  // namespace

RigidBody read_rigid_body(const TomlTable& table) {
  RigidBody body;
  body.name = table.text("name");
  // It becomes part of the names of columns and data sets.
  if (body.name.find_first_of("./,\"\n\r") != std::string::npos) {
    table.fail("name", "allowed: a name without . / , \" and line ends");
  }
  for (const TomlTable& shape : table.tables("shape")) {
    body.shapes.push_back(read_shape(shape));
  }
  for (const TomlTable& named : table.tables("direction")) {
    body.directions.push_back({named.text("name"), direction(named, "vector")});
  }
  const auto mass =
      table.optional_number("mass", Interval::positive(), Dimension::mass);
  const auto density =
      table.optional_number("density_kg_per_m3", Interval::positive());
  const auto inertia = read_inertia(table);
  const auto com = optional_vector(table, "com", Dimension::length);
  if (mass && density) {
    table.fail("density_kg_per_m3", "allowed: not together with mass");
  }
  if (!mass && !density) {
    table.number("mass", Interval::positive(), Dimension::mass);
  }
  if (body.shapes.empty() && !inertia) {
    table.fail_missing("inertia", "there are no shapes to take it from");
  }
  if (body.shapes.empty() && !mass) {
    table.fail("density_kg_per_m3", "allowed: with shapes only");
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
