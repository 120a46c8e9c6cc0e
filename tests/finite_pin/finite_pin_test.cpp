// Pins of finite length against independent solutions, limits and identities.
#include "libcontact/finite_pin/finite_pin.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "libcontact/base/units.hpp"
#include "play/reference_joint.hpp"
#include "support/accuracy_report.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"

namespace contact::test::finite_pin_test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector4d;

Relief relief_of(const ReferenceTable::Row& row) {
  const std::string& kind = row.text("crown");
  if (kind == "none") return Relief::none();
  if (kind == "parabola") return Relief::barrel(row.value("crown_c"));
  return Relief::ends(row.value("crown_c"), row.value("crown_b"));
}

JointSpec joint_of(const ReferenceTable::Row& row) {
  const test::ReferenceBodies bodies = test::reference_bodies(row);
  return {.geometry = JointGeometry::pin(
              row.value("rho"), row.value("clearance"), row.value("length")),
          .inner = bodies.inner,
          .outer = bodies.outer,
          .relief = relief_of(row)};
}

Vector2d vector(const ReferenceTable::Row& row, const std::string& name) {
  return {row.value(name + "_x"), row.value(name + "_y")};
}

JointSpec bush(Relief relief = Relief::none()) {
  const Material steel = {210e9, 0.3};
  return {.geometry = JointGeometry::pin(0.02, 2e-5, 0.05),
          .inner = steel,
          .outer = {{{0.004, {110e9, 0.34}}, {0.02, steel}}, Backing::held()},
          .relief = relief};
}

// Required accuracy: the row's, or 1e-7.
double budget(const ReferenceTable::Row& row) {
  return std::max(row.value("acc"), 1e-7);
}

void compare(const FinitePinState& at, const ReferenceTable::Row& row,
             double length) {
  AccuracyReport report("all", budget(row));
  const std::string label = row.label();
  const auto add = [&](const std::string& what, double value, double size) {
    report.add_error(std::abs(value - row.value(what)) / size,
                     what + ", " + label);
  };
  const double shift = vector(row, "a").norm();
  const double force = row.value("F_x");
  const double half = length / 2;
  add("a_x", at.shift.x(), shift);
  add("a_y", at.shift.y(), shift);
  const double slope = std::max(vector(row, "psi").norm(), shift / half);
  add("psi_x", at.tilt.x(), slope);
  add("psi_y", at.tilt.y(), slope);
  add("G_x", at.force_moment.x(), force * half);
  add("G_y", at.force_moment.y(), force * half);
  const char* names[] = {"ax", "ay", "px", "py"};
  const Eigen::Matrix4d& k = at.stiffness;
  for (int i = 0; i < 4; ++i) {
    for (int j = i; j < 4; ++j) {
      if (i == 1 && j == 2) continue;  // k_aypx is k_axpy
      const double unit = (i > 1 ? half : 1) * (j > 1 ? half : 1);
      add(std::string("k_") + names[i] + names[j], k(i, j), k(0, 0) * unit);
    }
  }
  add("T_x", -at.force.y(), force);
  add("T_y", at.force.x(), force);
  add("H_x", -at.force_moment.y(), force * half);
  add("H_y", at.force_moment.x(), force * half);
  add("N", at.pressure_moment, row.value("N"));
  const double area = row.value("Na") / row.value("rho");
  add("Ta_x", at.area_tangent.x(), area);
  add("Ta_y", at.area_tangent.y(), area);
  add("Ha_x", at.area_tangent_moment.x(), area * half);
  add("Ha_y", at.area_tangent_moment.y(), area * half);
  add("Na", at.area_moment, row.value("Na"));
  add("p_max", at.peak_pressure, row.value("p_max"));
  add("p_end_low", at.end_pressure[0], row.value("p_max"));
  add("p_end_high", at.end_pressure[1], row.value("p_max"));
  add("theta0_end_low_deg", at.end_half_angle[0] / degree, 90);
  add("theta0_end_high_deg", at.end_half_angle[1] / degree, 90);
  add("z_low", at.low, half);
  add("z_high", at.high, half);
}

TEST(FinitePinAccuracy, UnderTheLoadsOfTheReference) {
  const ReferenceTable table("finite_pin/pins.csv");
  for (const ReferenceTable::Row row : table) {
    const double length = row.value("length");
    const FinitePin pin(joint_of(row));
    const Vector2d force(row.value("F_x"), 0);
    const FinitePinState at = row.text("given") == "tilt"
                                  ? pin.under(force, vector(row, "psi"))
                                  : pin.under_moment(force, vector(row, "G"));
    EXPECT_EQ(at.status, Status::ok) << row.label();
    EXPECT_EQ(at.pieces, row.value("intervals")) << row.label();
    // The maximum is flat: the root of the accuracy of pressures. Without tilt
    // it is everywhere, and one place is as good as another.
    if (vector(row, "psi").norm() > 0) {
      EXPECT_NEAR(at.peak_place, row.value("z_p_max"), 1e-4 * length)
          << row.label();
    }
    compare(at, row, length);
  }
}

TEST(FinitePinAccuracy, UnderTheReactionsOfTheReference) {
  const ReferenceTable table("finite_pin/reactions.csv");
  const ReferenceTable pins("finite_pin/pins.csv");
  const auto pin_of = [&](const std::string& id) {
    std::size_t i = 0;
    while (pins[i].text("id") != id) ++i;
    return pins[i];
  };
  AccuracyReport report("all", 1e-7);
  for (const ReferenceTable::Row row : table) {
    const ReferenceTable::Row of = pin_of(row.text("row"));
    JointSpec joint = joint_of(of);
    const JointGeometry& g = joint.geometry;
    joint.geometry = JointGeometry::pin(
        g.radius(), g.radial_clearance(), g.length(),
        row.value("s") > 0 ? JointBody::carrier : JointBody::body);
    joint.friction = FrictionLaw(row.value("f0"), row.value("A"));
    const FinitePin pin(joint);
    const Vector2d reaction = vector(row, "R");
    const FinitePinSolution s = pin.solve(reaction, vector(row, "psi"), 2.5);
    EXPECT_EQ(s.contact.status, Status::ok) << row.label();
    const double force = reaction.norm();
    const double moment = force * g.radius();
    const auto add = [&](const std::string& what, double value, double size) {
      report.add_error(std::abs(value - row.value(what)) / size,
                       what + ", " + row.label());
    };
    add("a_x", s.contact.shift.x(), vector(row, "a").norm());
    add("a_y", s.contact.shift.y(), vector(row, "a").norm());
    add("F_x", s.contact.force.x(), force);
    add("F_y", s.contact.force.y(), force);
    add("R_t_x", s.friction_force.x(), force);
    add("R_t_y", s.friction_force.y(), force);
    add("M_x", s.moment.x(), moment);
    add("M_y", s.moment.y(), moment);
    add("M_z", s.moment.z(), moment);
    // The reaction is the sum of its parts.
    const double side = row.value("s");
    EXPECT_LT((side * s.contact.force + s.friction_force - reaction).norm(),
              1e-9 * force);
    // Turning back turns the friction round; at rest there is none.
    const FinitePinSolution back = pin.solve(reaction, vector(row, "psi"), -1);
    EXPECT_LT(s.moment.z() * back.moment.z(), 0);
    EXPECT_EQ(pin.solve(reaction, vector(row, "psi"), 0).friction_force.norm(),
              0);
  }
}

// A level pin without relief equals the unlimited pin. The force law of the
// second one ends half a clearance deep.
TEST(FinitePin, LevelIsTheJoint) {
  JointSpec lined = bush();
  lined.geometry = JointGeometry::pin(0.02, 4e-5, 0.05);
  lined.inner = Material{infinity, 0};
  lined.outer = {{{0.0015, {5e8, 0.5}}}, Backing::rigid()};
  for (JointSpec spec : {bush(), lined}) {
    spec.friction = FrictionLaw(0.1, 1e6);
    spec.half_angle_law = "exact";
    const FinitePin pin(spec);
    const JointContact joint = spec.contact();
    for (const double force : {1e2, 1e4, 2e5}) {
      const FinitePinState at = pin.under({0, force}, {0, 0});
      ASSERT_EQ(at.status, Status::ok) << force;
      const double theta0 = joint.half_angle(force).half_angle;
      // The force law is within 5e-11 of solutions, the joint's table 1e-9.
      EXPECT_NEAR(at.end_half_angle[0] / theta0, 1, 1e-8);
      EXPECT_NEAR(at.peak_pressure / joint.peak_pressure(force, theta0), 1,
                  1e-8);
      EXPECT_NEAR(
          at.pressure_moment / (0.02 * joint.sum_of_pressures(force, theta0)),
          1, 1e-8);
      // 5e-8 of a liner that cannot be compressed.
      EXPECT_NEAR(at.shift.y() / joint.shift(force, theta0), 1, 1e-7);
      EXPECT_NEAR(at.low, -0.025, 1e-15);
      EXPECT_NEAR(at.high, 0.025, 1e-15);
      EXPECT_EQ(at.pieces, 1);
      EXPECT_NEAR(at.force_moment.norm(), 0, 1e-12 * force);
    }
  }
}

// F and G are derivatives of the energy, the stiffness theirs.
TEST(FinitePin, IsTheDerivativeOfItsEnergy) {
  const FinitePin pin(bush(Relief::ends(1.5e-5, 0.008)));
  const Vector2d shift(3.5e-5, 1e-5);
  const Vector2d tilt(1e-3, -4e-4);
  const FinitePinState at = pin.at(shift, tilt);
  const Vector4d steps(1e-9, 1e-9, 4e-8, 4e-8);
  const auto moved = [&](int i, double by) {
    Vector4d place;
    place << shift, tilt;
    place[i] += by;
    return pin.at(place.head<2>(), place.tail<2>());
  };
  Vector4d load;
  load << at.force, at.force_moment;
  for (int i = 0; i < 4; ++i) {
    const FinitePinState up = moved(i, steps[i]);
    const FinitePinState down = moved(i, -steps[i]);
    // Rounding of the energy over the step; squares of the step.
    const double slope = (up.energy - down.energy) / (2 * steps[i]);
    EXPECT_NEAR(slope / load[i], 1, 2e-7) << i;
    Vector4d change;
    change << up.force - down.force, up.force_moment - down.force_moment;
    change /= 2 * steps[i];
    EXPECT_LT((change - at.stiffness.col(i)).norm(),
              1e-6 * at.stiffness.col(i).norm())
        << i;
  }
  EXPECT_EQ(at.stiffness, at.stiffness.transpose());
}

// The hole has no preferred direction: a rotation of all inputs rotates the
// results.
TEST(FinitePin, TurnsWithItsLoad) {
  const FinitePin pin(bush(Relief::barrel(1e-5)));
  const Eigen::Rotation2D<double> turn(0.7);
  const FinitePinState a = pin.under({1e5, 0}, {1.2e-3, 4e-4});
  const FinitePinState b =
      pin.under(turn * Vector2d(1e5, 0), turn * Vector2d(1.2e-3, 4e-4));
  EXPECT_LT((b.shift - turn * a.shift).norm(), 1e-11 * a.shift.norm());
  EXPECT_NEAR(b.peak_pressure / a.peak_pressure, 1, 1e-10);
  // Upside down the ends change places.
  const FinitePinState c = pin.under({1e5, 0}, {-1.2e-3, -4e-4});
  EXPECT_NEAR(c.low, -a.high, 1e-12);
  EXPECT_NEAR(c.end_pressure[0] / a.end_pressure[1], 1, 1e-10);
  EXPECT_LT((c.force_moment + a.force_moment).norm(), 1e-9 * 1e5 * 0.025);
}

// Sums over the surface of the hole, by midpoints in the sines of angle and
// place, for integrands with square roots at the edges.
struct Surface {
  Vector2d force = Vector2d::Zero(), force_moment = Vector2d::Zero();
  double pressure = 0;  ///< sum of all pressures, N
  /// Friction per f0 of slip along the axis: force and moment on the body.
  double axial_force = 0;
  Eigen::Vector3d axial_moment = Eigen::Vector3d::Zero();
};

Surface surface(const FinitePin& pin, const FinitePinState& at, double low,
                double high, double adhesion_per_f0) {
  constexpr int count = 400;
  const double rho = 0.02;
  Surface sum;
  const auto sine = [&](int i) { return std::sin(pi * (i + 0.5) / count); };
  const auto place = [&](int i) { return -std::cos(pi * (i + 0.5) / count); };
  for (int i = 0; i < count; ++i) {
    const double z = (low + high) / 2 + (high - low) / 2 * place(i);
    const double dz = (high - low) / 2 * sine(i) * pi / count;
    const FinitePin::Slice slice = pin.slice(at, z);
    const double middle = std::atan2(slice.direction.y(), slice.direction.x());
    for (int j = 0; j < count; ++j) {
      // Turned by a whole turn: the same place.
      const double theta = middle + 2 * pi + slice.half_angle * place(j);
      const double area = rho * slice.half_angle * sine(j) * pi / count * dz;
      const double p = pin.pressure(at, z, theta);
      const Eigen::Vector3d normal(std::cos(theta), std::sin(theta), 0);
      sum.force += p * area * normal.head<2>();
      sum.force_moment += z * p * area * normal.head<2>();
      sum.pressure += p * area;
      const double stress = (p + adhesion_per_f0) * area;
      sum.axial_force -= stress;
      sum.axial_moment -= stress * (rho * normal + z * Eigen::Vector3d::UnitZ())
                                       .cross(Eigen::Vector3d::UnitZ());
    }
  }
  return sum;
}

// The pressure over angle and length carries the load, twisted and relieved.
TEST(FinitePin, PressuresAddUpToTheLoad) {
  JointSpec spec = bush(Relief::barrel(1e-5));
  const double f0 = 0.1;
  const double adhesion = 2e6;
  spec.friction = FrictionLaw(f0, adhesion);
  const FinitePin pin(spec);
  const Vector2d tilt(1.2e-3, 6e-4);
  const Vector2d reaction(8e4, 0);
  const FinitePinSolution s = pin.solve(reaction, tilt, {0, -0.3});
  const FinitePinState& at = s.contact;
  ASSERT_EQ(at.pieces, 1);
  const Surface sum = surface(pin, at, at.low, at.high, adhesion / f0);
  // Midpoints leave 1/count^2, a little more at ends with logarithms.
  constexpr double budget = 2e-5;
  EXPECT_LT((sum.force - at.force).norm(), budget * 8e4);
  EXPECT_LT((sum.force_moment - at.force_moment).norm(), budget * 8e4 * 0.025);
  EXPECT_NEAR(sum.pressure * 0.02 / at.pressure_moment, 1, budget);
  // The body slides towards -z: friction on it points to +z. Across the axis
  // there is none.
  EXPECT_NEAR(s.axial_friction_force / (-f0 * sum.axial_force), 1, budget);
  EXPECT_EQ(s.friction_force.norm(), 0);
  EXPECT_EQ(s.moment.z(), 0);
  ASSERT_LT((at.force - reaction).norm(), 1e-9 * 8e4);
  const Vector2d normal_moment(-at.force_moment.y(), at.force_moment.x());
  EXPECT_LT(
      (s.moment.head<2>() - normal_moment + f0 * sum.axial_moment.head<2>())
          .norm(),
      budget * s.moment.norm());
  // A reaction at a place has its moment, friction along the axis included.
  const FinitePinSolution placed = pin.solve_at(reaction, 1e-3, {0.5, -0.01});
  EXPECT_EQ(placed.contact.status, Status::ok);
  EXPECT_NEAR(placed.moment.y(), 1e-3 * 8e4, 1e-8 * 8e4 * 0.025);
  EXPECT_NEAR(placed.moment.x(), 0, 1e-8 * 8e4 * 0.025);
  // Both parts of friction follow one slip: rho rate against velocity.
  EXPECT_NEAR(placed.moment.z() / placed.axial_friction_force / 0.02,
              -0.02 * 0.5 / 0.01, 1e-12);
}

// They are the largest among many places.
TEST(FinitePin, LargestHalfAngleAndPressureAlongThePin) {
  for (const Relief& relief :
       {Relief::none(), Relief::barrel(1e-5), Relief::ends(1.5e-5, 0.008)}) {
    const FinitePin pin(bush(relief));
    for (const Vector2d& tilt :
         {Vector2d(0, 0), Vector2d(8e-4, 0), Vector2d(-2e-4, 1e-3),
          // The largest lies just beyond where the relief begins.
          Vector2d(4e-5, 0), Vector2d(-1e-4, 0)}) {
      const FinitePinState at = pin.under({1e5, 2e4}, tilt);
      ASSERT_EQ(at.status, Status::ok);
      double half_angle = 0;
      double peak = 0;
      constexpr int count = 2000;
      for (int i = 0; i <= count; ++i) {
        const FinitePin::Slice s =
            pin.slice(at, 0.05 * (double(i) / count - 0.5));
        half_angle = std::max(half_angle, s.half_angle);
        peak = std::max(peak, s.peak);
      }
      // Squares of the steps over the length of the relief.
      EXPECT_NEAR(at.largest_half_angle / half_angle, 1, 1e-5);
      EXPECT_NEAR(at.peak_pressure / peak, 1, 1e-5);
      EXPECT_GE(at.largest_half_angle, half_angle * (1 - 1e-14));
      EXPECT_GE(at.peak_pressure, peak * (1 - 1e-14));
      EXPECT_EQ(pin.slice(at, at.half_angle_place).half_angle,
                at.largest_half_angle);
    }
  }
  const FinitePin pin(bush());
  const FinitePinState at = pin.under({1e5, 0}, {8e-4, 0});
  EXPECT_EQ(pin.pressure(at, at.high + 1e-9, 0), 0);
  EXPECT_EQ(pin.pressure(at, at.peak_place, pi), 0);
  EXPECT_TRUE(std::isnan(pin.pressure(at, 0, nan)));
  EXPECT_TRUE(std::isnan(pin.pressure(pin.at({1, 0}, {0, 0}), 0, 0)));
}

// A load at z has the moment z F: under that moment the tilt is such that it
// comes back, and a load in the middle leaves the pin level.
TEST(FinitePin, MomentAndTiltAreInverse) {
  const FinitePin pin(bush(Relief::ends(1e-5, 0.01)));
  const Vector2d force(6e4, -2e4);
  for (const double z : {0.0, 0.004, -0.012, 0.02}) {
    const FinitePinState given = pin.under_moment(force, z * force);
    ASSERT_EQ(given.status, Status::ok) << z;
    EXPECT_LT(given.residual, 1e-10) << z;
    const FinitePinState back = pin.under(force, given.tilt);
    EXPECT_LT((back.force_moment - z * force).norm(),
              1e-9 * force.norm() * 0.025)
        << z;
    if (z == 0) {
      EXPECT_LT(given.tilt.norm(), 1e-12);
    }
    EXPECT_GE(given.tilt.dot(z * force), 0) << z;
  }
}

TEST(FinitePin, ReliefIsWhatItSays) {
  const auto at = [](const Relief& relief, double z) {
    for (const Relief::Piece& piece : relief.pieces(0.05)) {
      if (z >= piece.from && z <= piece.to) return piece.at(z);
    }
    return nan;
  };
  EXPECT_EQ(at(Relief::none(), 0.01), 0);
  EXPECT_NEAR(at(Relief::barrel(1e-5), 0.025), 1e-5, 1e-20);
  EXPECT_NEAR(at(Relief::barrel(1e-5), -0.0125), 2.5e-6, 1e-20);
  const Relief ends = Relief::ends(1e-5, 0.01);
  EXPECT_NEAR(at(ends, -0.025), 1e-5, 1e-20);
  EXPECT_NEAR(at(ends, 0.02), 2.5e-6, 1e-20);
  EXPECT_EQ(at(ends, 0.014), 0);
  EXPECT_ERROR(Relief::barrel(0), "relief: depth = 0 must be above 0 m");
  EXPECT_ERROR(Relief::ends(1e-5, nan),
               "relief: length = nan must be above 0 m");
  EXPECT_ERROR(
      FinitePin(bush(Relief::ends(1e-5, 0.03))),
      "relief: length = 0.03 must be at most half of the joint's length");
}

TEST(FinitePin, SaysWhereItEnds) {
  const FinitePin pin(bush());
  const FinitePinState far = pin.at({1, 0}, {0, 0});
  EXPECT_EQ(far.status, Status::out_of_range);
  EXPECT_TRUE(std::isnan(far.force.x()));
  for (const double force : {2e6, 1e9, 1e12}) {
    const FinitePinState beyond = pin.under({force, 0}, {0, 0});
    EXPECT_EQ(beyond.status, Status::out_of_range) << force;
    EXPECT_TRUE(std::isnan(beyond.peak_pressure)) << force;
  }
  EXPECT_NE(pin.under({nan, 0}, {0, 0}).status, Status::ok);
  EXPECT_NE(pin.at({0, nan}, {0, 0}).status, Status::ok);
  // Without a load and without contact.
  const FinitePinState none = pin.under({0, 0}, {0, 0});
  EXPECT_EQ(none.status, Status::ok);
  EXPECT_EQ(none.pieces, 0);
  EXPECT_EQ(none.peak_pressure, 0);
  EXPECT_TRUE(std::isnan(none.low));
  JointSpec ball = test::steel_ball();
  EXPECT_ERROR(FinitePin{ball}, "a pin of finite length requires kind = pin");
  JointSpec wet = bush();
  wet.friction = ViscousLaw(1, 0);
  EXPECT_ERROR(
      FinitePin{wet},
      "a pin of finite length requires dry friction: a coefficient and "
      "an adhesion");
}

}  // namespace
}  // namespace contact::test::finite_pin_test
