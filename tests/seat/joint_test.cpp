#include "libcontact/seat/joint.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <boost/crc.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>

#include "libcontact/base/units.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/seat/table.hpp"
#include "support/accuracy_report.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"
#include "support/seat.hpp"

// Joints in seats that end, under a reaction, against a program of its own.
namespace contact::test {
namespace {

using Eigen::Vector3d;

Vector3d vector(const ReferenceTable::Row& row, const std::string& name) {
  return {row.value(name + "_x"), row.value(name + "_y"),
          row.value(name + "_z")};
}

// The first row of a seat in the table of contacts.
ReferenceTable::Row seat_row(const ReferenceTable& seats,
                             const std::string& id) {
  std::size_t i = 0;
  while (seats[i].text("id") != id) ++i;
  return seats[i];
}

JointSpec with_seat(JointSpec joint, const SeatZone& zone, double side) {
  joint.geometry =
      JointGeometry::ball(joint.geometry.radius(),
                          joint.geometry.radial_clearance(),
                          side > 0 ? JointBody::carrier : JointBody::body)
          .with_seat(zone);
  return joint;
}

JointSpec bearing() {
  return with_seat({.geometry = JointGeometry::ball(0.025, 2.5e-5),
                    .inner = Material{2.1e11, 0.3},
                    .outer = Material{1.1e11, 0.34},
                    .friction = FrictionLaw(0.1)},
                   SeatZone::cup(60 * degree), 1);
}

TEST(SeatJoint, MatchesTheReference) {
  const ReferenceTable rows("edges/edges_ball_joint.csv");
  const ReferenceTable seats("edges/edges_ball.csv");
  // The usual grid's errors, as in docs/seat_joint.md: friction where the
  // slip axis pierces the contact at a rim, row 3.
  AccuracyReport force("F over R", 2e-4);
  AccuracyReport moment("M over R rho", 5e-4);
  AccuracyReport shift("D over its length", 1e-3);
  AccuracyReport peak("p_max", 5e-3);
  AccuracyReport sum("R - s F - R_t over R", 1e-15);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ReferenceTable::Row row = rows[i];
    const ReferenceTable::Row seat = seat_row(seats, row.text("seat"));
    const double side = row.value("s");
    JointSpec spec = with_seat(joint_of(seat), zone_of(seat), side);
    spec.friction = FrictionLaw(row.value("f0"), row.value("A"));
    const SeatJoint joint(spec);
    const Vector3d reaction = vector(row, "R");
    const SeatJointSolution s = joint.solve(
        {.reaction = reaction, .angular_velocity = vector(row, "w")});
    ASSERT_EQ(s.contact.status, SeatStatus::ok) << row.label();
    const double size = reaction.norm();
    const double rho = spec.geometry.radius();
    force.add_error((s.contact.force - vector(row, "F")).norm() / size,
                    row.label());
    moment.add_error((s.friction_moment - vector(row, "M")).norm() / size / rho,
                     row.label());
    shift.add_error(
        (s.contact.shift - vector(row, "D")).norm() / s.contact.shift.norm(),
        row.label());
    peak.add_error(std::abs(s.contact.peak_pressure / row.value("p_max") - 1),
                   row.label());
    sum.add_error(
        (reaction - side * s.contact.force - s.friction_force).norm() / size,
        row.label());
    EXPECT_LT(s.power, 0);
    EXPECT_LT(s.evaluations, 12);
  }
}

// To the last bit.
TEST(SeatJoint, FreeContactIsTheJointWithoutEnd) {
  const SeatJoint joint(bearing());
  const Joint::Slip slip{.reaction = {2e3, 1e3, 2e4},
                         .angular_velocity = {0.3, 0.4, -0.2}};
  const SeatJointSolution s = joint.solve(slip);
  JointSpec spec = bearing();
  spec.half_angle_law = "exact";
  const JointSolution exact = Joint(spec).solve(slip);
  EXPECT_TRUE(s.contact.is_free);
  EXPECT_EQ(s.friction_moment, exact.friction_moment);
  EXPECT_EQ(s.friction_force, exact.friction_force);
  const RestSolution held =
      Joint(spec).at_rest({.reaction = slip.reaction, .moment = {5, 10, 3}});
  const SeatRestSolution rest =
      joint.at_rest({.reaction = slip.reaction, .moment = {5, 10, 3}});
  EXPECT_EQ(rest.utilisation, held.utilisation);
  EXPECT_EQ(rest.direction, held.direction);
}

// Friction too is continuous where the contact reaches the rim, dry, with
// adhesion and viscous: within the grid's accuracy, for the area that of its
// ends.
TEST(SeatJoint, ReachesTheRimWithoutAJump) {
  const struct {
    FrictionModel friction;
    double allowed;
  } cases[] = {{FrictionLaw(0.1), 2e-4},
               {FrictionLaw(0.1, 1e6), 2e-3},
               {ViscousLaw(1e6, 0.05), 2e-3}};
  for (const auto& [friction, allowed] : cases) {
    JointSpec spec = bearing();
    spec.friction = friction;
    const SeatJoint joint(spec);
    const double load = 2e4;
    const double theta0 =
        joint.contact().unbounded().half_angle(load).half_angle;
    const auto at = [&](double more) {
      const double v = 60 * degree - theta0 + more;
      const Vector3d w(0.02, -0.01, 0.03);
      // R for which F has this direction, by the joint without end.
      const Vector3d force = load * Vector3d(std::sin(v), 0, std::cos(v));
      const JointSolution of = joint.unbounded().solve_contact(
          {.normal_force = force, .angular_velocity = w});
      return joint.solve({.reaction = of.reaction, .angular_velocity = w});
    };
    const SeatJointSolution in = at(-1e-5), out = at(1e-5);
    EXPECT_TRUE(in.contact.is_free);
    EXPECT_FALSE(out.contact.is_free);
    EXPECT_LT((in.friction_moment - out.friction_moment).norm() /
                  in.friction_moment.norm(),
              allowed);
    EXPECT_LT((in.friction_force - out.friction_force).norm() / load,
              allowed * 0.1);
  }
}

// M = tau M_t(R, u) gives back u and tau.
TEST(SeatJoint, RestGivesBackTheMomentOfSlip) {
  const SeatJoint joint(bearing());
  for (const Vector3d& u :
       {Vector3d(0.3, 0.5, 0.8), Vector3d(0, 1, 0), Vector3d(-0.6, 0.2, 0.1)}) {
    const Joint::Slip slip{.reaction = {6e4, 1e4, 8e4},
                           .angular_velocity = u.normalized()};
    const SeatJointSolution s = joint.solve(slip);
    ASSERT_EQ(s.contact.status, SeatStatus::ok);
    ASSERT_FALSE(s.contact.is_free);
    const SeatRestSolution rest = joint.at_rest(
        {.reaction = slip.reaction, .moment = 0.6 * s.friction_moment});
    ASSERT_EQ(rest.slip.contact.status, SeatStatus::ok);
    // Ten times the tolerances of slip and rest.
    EXPECT_NEAR(rest.utilisation, 0.6, 1e-5);
    EXPECT_LT((rest.direction - u.normalized()).norm(), 1e-4);
  }
}

TEST(SeatJoint, ViscousFrictionHoldsNothing) {
  JointSpec viscous = bearing();
  viscous.friction = ViscousLaw(1e6, 0.05);
  const SeatRestSolution rest = SeatJoint(viscous).at_rest(
      {.reaction = {6e4, 1e4, 8e4}, .moment = {0, 0, 1}});
  EXPECT_EQ(rest.utilisation, INFINITY);
  EXPECT_EQ(rest.slip.contact.status, SeatStatus::ok);
}

// The seat's axis turns everything.
TEST(SeatJoint, TurnsWithTheAxis) {
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()))
          .toRotationMatrix();
  const Vector3d axis = turn * Vector3d::UnitZ();
  JointSpec turned = bearing();
  turned.geometry = turned.geometry.with_seat(
      turned.geometry.seat()->about({axis.x(), axis.y(), axis.z()}));
  const Vector3d reaction(6e4, 1e4, 8e4), rate(0.1, 0.2, 0.3);
  const SeatJointSolution s = SeatJoint(bearing()).solve(
      {.reaction = reaction, .angular_velocity = rate});
  const SeatJointSolution t = SeatJoint(turned).solve(
      {.reaction = turn * reaction, .angular_velocity = turn * rate});
  ASSERT_FALSE(s.contact.is_free);
  EXPECT_LT((t.friction_moment - turn * s.friction_moment).norm() /
                s.friction_moment.norm(),
            1e-6);
  EXPECT_LT((t.contact.shift - turn * s.contact.shift).norm() /
                s.contact.shift.norm(),
            1e-6);
}

// At rest too, with the direction in which it would slip.
TEST(SeatJoint, RestTurnsWithTheAxis) {
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()))
          .toRotationMatrix();
  const Vector3d axis = turn * Vector3d::UnitZ();
  JointSpec turned = bearing();
  turned.geometry = turned.geometry.with_seat(
      turned.geometry.seat()->about({axis.x(), axis.y(), axis.z()}));
  const SeatJoint upright(bearing()), aside(turned);
  // At the rim, and free.
  for (const Vector3d& reaction :
       {Vector3d(6e4, 1e4, 8e4), Vector3d(2e3, 1e3, 2e4)}) {
    const Vector3d moment(10, 30, 5);
    const SeatRestSolution s =
        upright.at_rest({.reaction = reaction, .moment = moment});
    const SeatRestSolution t =
        aside.at_rest({.reaction = turn * reaction, .moment = turn * moment});
    ASSERT_EQ(s.slip.contact.status, SeatStatus::ok);
    EXPECT_EQ(s.slip.contact.is_free, reaction.z() < 5e4);
    // Ten times the tolerance of rest.
    EXPECT_LT((t.direction - turn * s.direction).norm(), 1e-5);
    EXPECT_NEAR(t.utilisation / s.utilisation, 1, 1e-5);
    EXPECT_LT((t.slip.friction_moment - turn * s.slip.friction_moment).norm() /
                  s.slip.friction_moment.norm(),
              1e-5);
  }
}

// The load turns through all directions: from one to the next results change
// by little, or there is a status without numbers. At 90 deg of a cup, where it
// pointed along the rim, the shift was 2 km and the peak 7 GPa.
TEST(SeatJoint, TurnsTheLoadWithoutAJump) {
  for (const char* name :
       {"hip_cup", "ball_stud", "spherical_plain_bearing_ge50",
        "spherical_plain_thrust_bearing"}) {
    JointSpec spec =
        read_joint(CONTACT_DATA_DIR "/joints/" + std::string(name) + ".toml");
    if (!spec.friction) spec.friction = FrictionLaw(0.1);
    const SeatZone zone = *spec.geometry.seat();
    const SeatJoint joint(spec, {.cells = 14, .longitudes = 48});
    const Vector3d axis(zone.axis()[0], zone.axis()[1], zone.axis()[2]);
    const Vector3d across = axis.unitOrthogonal();
    const double side =
        spec.geometry.inner_body() == JointBody::carrier ? 1 : -1;
    // Towards the last direction that a cup carries, about which steps are
    // 0.1 deg, else 2, the shift is without bound.
    const double limit = std::min(zone.to() / degree, 90.0);
    SeatJointSolution last;
    int found = 0;
    double step = 0;
    for (double deg = 0; deg <= 180; deg += step) {
      const double b = deg * degree;
      const SeatJointSolution s =
          joint.solve({.reaction = side * 2000 *
                                   (std::cos(b) * axis + std::sin(b) * across),
                       .angular_velocity = {0.3, -0.5, 0.4}});
      const SeatState& at = s.contact;
      if (at.status != SeatStatus::ok) {
        EXPECT_TRUE(at.force.array().isNaN().all()) << name << " " << deg;
        EXPECT_TRUE(at.shift.array().isNaN().all());
        EXPECT_TRUE(s.friction_moment.array().isNaN().all());
        EXPECT_TRUE(s.friction_force.array().isNaN().all());
        EXPECT_TRUE(std::isnan(at.peak_pressure) && std::isnan(s.power));
        EXPECT_TRUE(std::isnan(at.gap()) && std::isnan(at.intensity()));
      } else if (++found; last.contact.status == SeatStatus::ok) {
        const double allowed = step < 1 ? 0.5 : 1.0;
        EXPECT_LT((at.shift - last.contact.shift).norm() / at.shift.norm(),
                  allowed)
            << name << " " << deg;
        EXPECT_FALSE(std::abs(std::log(at.peak_pressure /
                                       last.contact.peak_pressure)) > allowed)
            << name << " " << deg;
        EXPECT_LT((s.friction_moment - last.friction_moment).norm() /
                      s.friction_moment.norm(),
                  allowed)
            << name << " " << deg;
      }
      last = s;
      step = std::abs(deg - limit) < 3 ? 0.1 : 2;
    }
    EXPECT_GT(found, 40) << name;
  }
}

TEST(SeatJoint, SaysWhatItCannotCarry) {
  const SeatJoint joint(bearing());
  const SeatJointSolution s =
      joint.solve({.reaction = {1e4, 0, -1e3}, .angular_velocity = {0, 0, 1}});
  EXPECT_EQ(s.contact.status, SeatStatus::out_of_seat);
  EXPECT_TRUE(has_text(joint.notes(s).at(0), "the ball leaves it"));
  // The angle is counted from the seat's axis, wherever that points.
  JointSpec turned = bearing();
  turned.geometry =
      turned.geometry.with_seat(turned.geometry.seat()->about({0, 1, -1}));
  const SeatJoint aside(turned);
  EXPECT_TRUE(has_text(aside
                           .notes(aside.solve({.reaction = {1e4, 0, 0},
                                               .angular_velocity = {0, 0, 1}}))
                           .at(0),
                       "points 90 deg from the seat's axis"));
  // Beside friction's numbers there is none of the contact either, at rest too.
  EXPECT_TRUE(s.contact.force.array().isNaN().all());
  EXPECT_TRUE(
      std::isnan(joint.pressures(s, std::vector{Vector3d(0, 0, 1)})[0]));
  const SeatRestSolution rest =
      joint.at_rest({.reaction = {1e4, 0, -1e3}, .moment = {0, 1, 1}});
  EXPECT_TRUE(std::isnan(rest.utilisation));
  EXPECT_TRUE(rest.slip.contact.force.array().isNaN().all());
  JointSpec none = bearing();
  none.geometry = JointGeometry::ball(0.025, 2.5e-5);
  EXPECT_TRUE(
      has_text(error_message([&] { SeatJoint{none}; }), "requires [seat]"));
}

TEST(SeatTable, AnswersAsTheContact) {
  for (const SeatZone& zone :
       {SeatZone::cup(60 * degree), SeatZone(65 * degree, 115 * degree)}) {
    JointSpec spec = bearing();
    spec.geometry = spec.geometry.with_seat(zone);
    SeatJoint joint(spec, {.cells = 16, .longitudes = 48});
    const auto table = std::make_shared<const SeatTable>(
        joint.contact(),
        SeatTable::Options{.least_load = 5e4, .most_load = 2e5, .checks = 30});
    EXPECT_EQ(table->check().states, 30);
    EXPECT_LE(table->check().load, 1e-3);
    EXPECT_LE(table->check().friction, 1e-3);
    const Vector3d w(0.3, -0.5, 0.4);
    for (const Vector3d& reaction :
         {Vector3d(3e4, 2e4, 9e4), Vector3d(-8e4, 3e4, 8e4)}) {
      const Joint::Slip slip{.reaction = reaction, .angular_velocity = w};
      joint.use(nullptr);
      const SeatJointSolution exact = joint.solve(slip);
      joint.use(table);
      const SeatJointSolution read = joint.solve(slip);
      ASSERT_FALSE(exact.contact.is_free);
      EXPECT_FALSE(read.contact.solution);
      EXPECT_LT((read.friction_moment - exact.friction_moment).norm() /
                    exact.friction_moment.norm(),
                2e-3);
      EXPECT_NEAR(read.contact.peak_pressure / exact.contact.peak_pressure, 1,
                  2e-2);
      EXPECT_LT((read.contact.shift - exact.contact.shift).norm() /
                    exact.contact.shift.norm(),
                2e-3);
    }
  }
}

// A table read again is the same table, to the last bit; that of another joint
// and half of one are refused.
TEST(SeatTable, IsReadAgain) {
  const JointSpec spec = bearing();
  SeatJoint joint(spec, {.cells = 10, .longitudes = 30});
  const auto made = std::make_shared<const SeatTable>(
      joint.contact(), SeatTable::Options{.least_load = 1.4e5,
                                          .most_load = 1.6e5,
                                          .accuracy = 0.05,
                                          .checks = 3});
  const std::string bytes = made->bytes(spec);
  EXPECT_TRUE(has_text(bytes.substr(0, 300), "radius_m"));
  const auto read =
      std::make_shared<const SeatTable>(joint.contact(), spec, bytes);
  const Joint::Slip slip{.reaction = {5e4, 2e4, 1.4e5},
                         .angular_velocity = {0.2, 0.1, 0.3}};
  joint.use(made);
  const SeatJointSolution s = joint.solve(slip);
  joint.use(read);
  const SeatJointSolution t = joint.solve(slip);
  ASSERT_FALSE(s.contact.is_free || s.contact.solution);
  EXPECT_EQ(s.friction_moment, t.friction_moment);
  EXPECT_EQ(read->check().load, made->check().load);
  EXPECT_EQ(read->bytes(spec), bytes);
  const auto message = [&](const JointSpec& of, const std::string& text) {
    return error_message([&] { SeatTable(joint.contact(), of, text); });
  };
  JointSpec other = spec;
  other.geometry = other.geometry.with_clearance(2.6e-5);
  EXPECT_EQ(message(other, bytes), "a table of another joint");
  EXPECT_EQ(message(spec, bytes.substr(0, bytes.size() - 1)),
            "a table that is damaged or cut off");
  EXPECT_EQ(message(spec, bytes + '1'), "a table that is damaged or cut off");
  EXPECT_EQ(message(spec, "name = 1"), "not a table of a seat");
  std::string old = bytes;
  old[bytes.find('2')] = '1';
  EXPECT_EQ(message(spec, old),
            "a table of another version, which has to be made again");
  // One bit anywhere; and places of squares and states, with their check sum.
  for (std::size_t i = 800; i < bytes.size(); i += bytes.size() / 7) {
    std::string flipped = bytes;
    flipped[i] = static_cast<char>(flipped[i] ^ 0x40);
    EXPECT_EQ(message(spec, flipped), "a table that is damaged or cut off");
  }
  // The number of squares, and where the parts of the first one are, wrong but
  // with a check sum of their own: also if only the last of them is not there.
  JointSpec bare = spec;
  bare.friction = {};
  bare.name = "";
  const std::size_t head =
      bytes.find('\n') + 1 + bare.canonical_text().size() + 1;
  const std::size_t squares = head + 76;
  std::uint64_t count = 0;
  std::memcpy(&count, bytes.data() + squares - 8, 8);
  const int halves_end = static_cast<int>(count) - 3;
  for (const std::size_t place : {head + 32, squares + 19 * 4}) {
    for (const int number : {1 << 30, 0, halves_end}) {
      if (number == halves_end && place == head + 32) continue;
      std::string forged = bytes.substr(0, bytes.size() - 4);
      std::memcpy(forged.data() + place, &number, 4);
      boost::crc_32_type crc;
      crc.process_bytes(forged.data(), forged.size());
      const std::uint32_t sum = crc.checksum();
      forged.append(reinterpret_cast<const char*>(&sum), 4);
      EXPECT_EQ(message(spec, forged), "a table that is damaged") << place;
    }
  }
  EXPECT_TRUE(has_text(error_message([&] {
                         SeatTable(joint.contact(),
                                   {.least_load = 2, .most_load = 1});
                       }),
                       "most_load = 1 must be above least_load"));
  // It was made, empty, with an error of 0.
  EXPECT_TRUE(has_text(error_message([&] {
                         SeatTable(joint.contact(),
                                   {.least_load = 1, .most_load = INFINITY});
                       }),
                       "most_load = inf must be finite"));
  EXPECT_TRUE(std::isnan(SeatTable::Check().error()));
}

// As of contacts on the grid.
TEST(SeatTable, PeaksAreAboveTheMeanOrThereIsNone) {
  JointSpec spec = bearing();
  spec.geometry = spec.geometry.with_seat(
      SeatZone::cup(60 * degree).with_edge({.report_distance = 0.3}));
  const SeatJoint joint(spec, {.cells = 10, .longitudes = 30});
  const SeatTable table(
      joint.contact(),
      {.least_load = 2e4, .most_load = 3e4, .accuracy = 0.05, .checks = 3});
  int there = 0, hidden = 0;
  for (double v = 30; v < 53; ++v) {
    SeatState state;
    if (!table.find(
            2.5e4 * Vector3d(std::sin(v * degree), 0, std::cos(v * degree)),
            state)) {
      continue;
    }
    EXPECT_FALSE(state.peak_pressure < state.mean_pressure()) << v;
    const bool is_hidden = std::isnan(state.peak_pressure);
    EXPECT_EQ(std::isnan(state.peak_place.polar_angle), is_hidden);
    (is_hidden ? hidden : there) += 1;
  }
  EXPECT_GT(there, 2);
  EXPECT_GT(hidden, 2);
}

// Loads on both sides of a symmetric ring.
TEST(SeatTable, MirrorsAcrossTheEquator) {
  JointSpec spec = bearing();
  spec.geometry = spec.geometry.with_seat({65 * degree, 115 * degree});
  SeatJoint joint(spec, {.cells = 12, .longitudes = 40});
  joint.use(std::make_shared<const SeatTable>(
      joint.contact(), SeatTable::Options{.least_load = 6e4,
                                          .most_load = 1.2e5,
                                          .accuracy = 1e-2,
                                          .checks = 5}));
  const auto solve = [&](double up) {
    return joint.solve({.reaction = {8e4, 1e4, up * 4e4},
                        .angular_velocity = {up * 0.2, up * 0.5, 0.3}});
  };
  const SeatJointSolution s = solve(1), t = solve(-1);
  for (const SeatJointSolution& of : {s, t}) {
    ASSERT_FALSE(of.contact.is_free || of.contact.solution);
  }
  // Rounding of the direction.
  EXPECT_NEAR(s.contact.rims[0].intensity / t.contact.rims[1].intensity, 1,
              1e-9);
  EXPECT_NEAR(s.contact.lower_end, pi - t.contact.upper_end, 1e-9);
  EXPECT_NEAR(s.contact.shift.z() / -t.contact.shift.z(), 1, 1e-9);
  EXPECT_NEAR(s.friction_moment.x(), -t.friction_moment.x(),
              1e-9 * s.friction_moment.norm());
  EXPECT_NEAR(s.friction_moment.z(), t.friction_moment.z(),
              1e-9 * s.friction_moment.norm());
}

}  // namespace
}  // namespace contact::test
