#include "libcontact/joint/joint.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <boost/crc.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string>

#include "libcontact/base/units.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/joint/contact_notes.hpp"
#include "libcontact/joint/derivatives.hpp"
#include "libcontact/joint/step.hpp"
#include "libcontact/seat/seat_model.hpp"
#include "libcontact/seat/table.hpp"
#include "support/accuracy_report.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/random_slip.hpp"
#include "support/reference_table.hpp"
#include "support/seat.hpp"

// Joints in seats that end, under a reaction, against a program of its own.
namespace contact::test::joint_test {
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

// A joint on a grid of one's own.
struct Gridded {
  Gridded(const JointSpec& of, const SeatContact::Grid& grid)
      : spec(of),
        grids(std::make_shared<const detail::SeatGrids>(of, grid)),
        endless([&] {
          JointSpec exact = of.without_seat();
          exact.half_angle_law = "exact";
          return exact;
        }()) {}
  detail::SeatModel with(std::shared_ptr<const SeatTable> table) const {
    return {spec, grids, endless, std::move(table)};
  }
  const SeatContact& contact() const { return grids->contact; }

  JointSpec spec;
  std::shared_ptr<const detail::SeatGrids> grids;
  Joint endless;
};

TEST(JointInSeat, MatchesTheReference) {
  const ReferenceTable rows("edges/edges_ball_joint.csv");
  const ReferenceTable seats("edges/edges_ball.csv");
  // The usual grid's errors, as in docs/internals/seat_methods.md: friction
  // where the slip axis pierces the contact at a rim, row 3.
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
    const Joint joint(spec);
    const Vector3d reaction = vector(row, "R");
    const JointSolution s = joint.solve(
        {.reaction = reaction, .angular_velocity = vector(row, "w")});
    ASSERT_EQ(s.status, Status::ok) << row.label();
    const RimContact at = *joint.rims(s);
    EXPECT_LT((at.force - side * s.normal_force * s.normal).norm(),
              1e-12 * s.normal_force);
    const double size = reaction.norm();
    const double rho = spec.geometry.radius();
    force.add_error((at.force - vector(row, "F")).norm() / size, row.label());
    moment.add_error((s.friction_moment - vector(row, "M")).norm() / size / rho,
                     row.label());
    shift.add_error((at.shift - vector(row, "D")).norm() / at.shift.norm(),
                    row.label());
    peak.add_error(std::abs(at.peak_pressure / row.value("p_max") - 1),
                   row.label());
    sum.add_error((reaction - side * at.force - s.friction_force).norm() / size,
                  row.label());
    EXPECT_LT(s.power, 0);
    EXPECT_LT(s.evaluations, 12);
  }
}

// To the last bit, also where the axes are others.
TEST(JointInSeat, FreeContactIsTheJointWithoutEnd) {
  const Joint joint(bearing());
  const Joint::Slip slip{.reaction = {2e3, 1e3, 2e4},
                         .angular_velocity = {0.3, 0.4, -0.2}};
  JointSpec spec = bearing().without_seat();
  spec.half_angle_law = "exact";
  const Joint endless(spec);
  ASSERT_FALSE(joint.is_endless());
  ASSERT_TRUE(endless.is_endless());
  const JointSolution exact = endless.solve(slip);
  const JointSolution s = joint.solve(slip);
  EXPECT_TRUE(joint.rims(s)->is_free);
  EXPECT_FALSE(endless.rims(exact));
  EXPECT_FALSE(s.work);
  for (const auto& [is, was] :
       {std::pair(s, exact),
        std::pair(joint.solve(slip, s), endless.solve(slip, exact))}) {
    EXPECT_EQ(is.friction_moment, was.friction_moment);
    EXPECT_EQ(is.friction_force, was.friction_force);
    EXPECT_EQ(is.half_angle, was.half_angle);
    EXPECT_EQ(is.moment_coefficient(), was.moment_coefficient());
  }
  const ContactPv pv = joint.pv(s, slip.angular_velocity);
  EXPECT_EQ(pv.total, endless.pv(exact, slip.angular_velocity).total);
  const Joint::Hold hold{.reaction = slip.reaction, .moment = {5, 10, 3}};
  const RestSolution held = endless.at_rest(hold);
  const RestSolution rest = joint.at_rest(hold);
  EXPECT_EQ(rest.utilisation, held.utilisation);
  EXPECT_EQ(rest.direction, held.direction);
  const Joint::KnownContact known{.normal_force = slip.reaction,
                                  .angular_velocity = slip.angular_velocity};
  EXPECT_EQ(joint.solve_contact(known).friction_moment,
            endless.solve_contact(known).friction_moment);
}

// Friction too is continuous where the contact reaches the rim: dry, with
// adhesion, and viscous. The tolerance is the grid's accuracy; for the area it
// is the accuracy of the ends.
TEST(JointInSeat, ReachesTheRimWithoutAJump) {
  const struct {
    FrictionModel friction;
    double allowed;
  } cases[] = {{FrictionLaw(0.1), 2e-4},
               {FrictionLaw(0.1, 1e6), 2e-3},
               {ViscousLaw(1e6, 0.05), 2e-3}};
  for (const auto& [friction, allowed] : cases) {
    JointSpec spec = bearing();
    spec.friction = friction;
    const Joint joint(spec);
    const double load = 2e4;
    const double theta0 = joint.contact().half_angle(load).half_angle;
    const auto at = [&](double more) {
      const double v = 60 * degree - theta0 + more;
      const Vector3d w(0.02, -0.01, 0.03);
      // R for which F has this direction, by the joint without rims.
      const Vector3d force = load * Vector3d(std::sin(v), 0, std::cos(v));
      JointSpec endless = spec.without_seat();
      endless.half_angle_law = "exact";
      const JointSolution of = Joint(endless).solve_contact(
          {.normal_force = force, .angular_velocity = w});
      return joint.solve({.reaction = of.reaction, .angular_velocity = w});
    };
    const JointSolution in = at(-1e-5), out = at(1e-5);
    EXPECT_TRUE(joint.rims(in)->is_free);
    EXPECT_FALSE(joint.rims(out)->is_free);
    EXPECT_LT((in.friction_moment - out.friction_moment).norm() /
                  in.friction_moment.norm(),
              allowed);
    EXPECT_LT((in.friction_force - out.friction_force).norm() / load,
              allowed * 0.1);
    EXPECT_NEAR(out.moment_coefficient() / in.moment_coefficient(), 1,
                allowed * 10);
    EXPECT_NEAR(out.adhesion_number, in.adhesion_number,
                allowed * in.adhesion_number);
  }
}

// M = tau M_t(R, u) gives back u and tau.
TEST(JointInSeat, RestGivesBackTheMomentOfSlip) {
  const Joint joint(bearing());
  for (const Vector3d& u :
       {Vector3d(0.3, 0.5, 0.8), Vector3d(0, 1, 0), Vector3d(-0.6, 0.2, 0.1)}) {
    const Joint::Slip slip{.reaction = {6e4, 1e4, 8e4},
                           .angular_velocity = u.normalized()};
    const JointSolution s = joint.solve(slip);
    ASSERT_EQ(s.status, Status::ok);
    ASSERT_FALSE(joint.rims(s)->is_free);
    const Joint::Hold hold{.reaction = slip.reaction,
                           .moment = 0.6 * s.friction_moment};
    RestSolution rest = joint.at_rest(hold);
    for (const bool again : {false, true}) {
      if (again) rest = joint.at_rest(hold, rest);
      ASSERT_EQ(rest.status, Status::ok);
      // Ten times the tolerances of slip and rest.
      EXPECT_NEAR(rest.utilisation, 0.6, 1e-5);
      EXPECT_LT((rest.direction - u.normalized()).norm(), 1e-4);
    }
  }
}

TEST(JointInSeat, ViscousFrictionHoldsNothing) {
  JointSpec viscous = bearing();
  viscous.friction = ViscousLaw(1e6, 0.05);
  const RestSolution rest = Joint(viscous).at_rest(
      {.reaction = {6e4, 1e4, 8e4}, .moment = {0, 0, 1}});
  EXPECT_EQ(rest.utilisation, INFINITY);
  EXPECT_EQ(rest.slip.status, Status::ok);
}

// The seat's axis turns everything.
TEST(JointInSeat, TurnsWithTheAxis) {
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()))
          .toRotationMatrix();
  const Vector3d axis = turn * Vector3d::UnitZ();
  JointSpec turned = bearing();
  turned.geometry = turned.geometry.with_seat(
      turned.geometry.seat()->about({axis.x(), axis.y(), axis.z()}));
  const Vector3d reaction(6e4, 1e4, 8e4), rate(0.1, 0.2, 0.3);
  const Joint straight(bearing()), aside(turned);
  const JointSolution s =
      straight.solve({.reaction = reaction, .angular_velocity = rate});
  const JointSolution t = aside.solve(
      {.reaction = turn * reaction, .angular_velocity = turn * rate});
  const RimContact of_s = *straight.rims(s), of_t = *aside.rims(t);
  ASSERT_FALSE(of_s.is_free);
  EXPECT_LT((t.friction_moment - turn * s.friction_moment).norm() /
                s.friction_moment.norm(),
            1e-6);
  EXPECT_LT((of_t.shift - turn * of_s.shift).norm() / of_s.shift.norm(), 1e-6);
}

// At rest too, with the direction in which it would slip.
TEST(JointInSeat, RestTurnsWithTheAxis) {
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()))
          .toRotationMatrix();
  const Vector3d axis = turn * Vector3d::UnitZ();
  JointSpec turned = bearing();
  turned.geometry = turned.geometry.with_seat(
      turned.geometry.seat()->about({axis.x(), axis.y(), axis.z()}));
  const Joint upright(bearing()), aside(turned);
  // At the rim, and free.
  for (const Vector3d& reaction :
       {Vector3d(6e4, 1e4, 8e4), Vector3d(2e3, 1e3, 2e4)}) {
    const Vector3d moment(10, 30, 5);
    const RestSolution s =
        upright.at_rest({.reaction = reaction, .moment = moment});
    const RestSolution t =
        aside.at_rest({.reaction = turn * reaction, .moment = turn * moment});
    ASSERT_EQ(s.status, Status::ok);
    EXPECT_EQ(upright.rims(s.slip)->is_free, reaction.z() < 5e4);
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
TEST(JointInSeat, TurnsTheLoadWithoutAJump) {
  for (const char* name :
       {"hip_cup", "ball_stud", "spherical_plain_bearing_ge50",
        "spherical_plain_thrust_bearing"}) {
    JointSpec spec =
        read_joint(CONTACT_DATA_DIR "/joints/" + std::string(name) + ".toml");
    if (!spec.friction) spec.friction = FrictionLaw(0.1);
    const SeatZone zone = *spec.geometry.seat();
    const detail::SeatModel joint =
        Gridded(spec, {.cells = 14, .longitudes = 48}).with(nullptr);
    const Vector3d axis(zone.axis()[0], zone.axis()[1], zone.axis()[2]);
    const Vector3d across = axis.unitOrthogonal();
    const double side =
        spec.geometry.inner_body() == JointBody::carrier ? 1 : -1;
    // Towards the last direction that a cup carries, about which steps are
    // 0.1 deg, else 2, the shift is without bound.
    const double limit = std::min(zone.to() / degree, 90.0);
    std::optional<std::pair<JointSolution, RimContact>> last;
    int found = 0;
    double step = 0;
    for (double deg = 0; deg <= 180; deg += step) {
      const double b = deg * degree;
      const JointSolution s =
          joint.solve({.reaction = side * 2000 *
                                   (std::cos(b) * axis + std::sin(b) * across),
                       .angular_velocity = {0.3, -0.5, 0.4}},
                      {}, {});
      const RimContact at = *joint.rims(s);
      if (s.status != Status::ok) {
        EXPECT_TRUE(at.force.array().isNaN().all()) << name << " " << deg;
        EXPECT_TRUE(at.shift.array().isNaN().all());
        EXPECT_TRUE(s.friction_moment.array().isNaN().all());
        EXPECT_TRUE(s.friction_force.array().isNaN().all());
        EXPECT_TRUE(std::isnan(s.peak_pressure) && std::isnan(s.power));
        EXPECT_TRUE(std::isnan(at.gap()) && std::isnan(at.intensity()));
      } else if (++found; last) {
        const auto& [before, at_before] = *last;
        const double allowed = step < 1 ? 0.5 : 1.0;
        EXPECT_LT((at.shift - at_before.shift).norm() / at.shift.norm(),
                  allowed)
            << name << " " << deg;
        EXPECT_FALSE(std::abs(std::log(s.peak_pressure /
                                       before.peak_pressure)) > allowed)
            << name << " " << deg;
        EXPECT_LT((s.friction_moment - before.friction_moment).norm() /
                      s.friction_moment.norm(),
                  allowed)
            << name << " " << deg;
      }
      last.reset();
      if (s.status == Status::ok) last.emplace(s, at);
      step = std::abs(deg - limit) < 3 ? 0.1 : 2;
    }
    EXPECT_GT(found, 40) << name;
  }
}

// A joint without the seat of its file can say where that is wrong: as far as
// the contact of the seat is not free.
TEST(JointInSeat, WithoutItAnOverlapIsKnown) {
  for (const char* name : {"hip_cup", "ball_stud"}) {
    JointSpec spec =
        read_joint(CONTACT_DATA_DIR "/joints/" + std::string(name) + ".toml");
    spec.half_angle_law = "exact";
    const Joint confined(spec), endless(spec.without_seat());
    int over = 0;
    RandomSlips random(5);
    for (int i = 0; i < 60; ++i) {
      const Joint::Slip slip = {.reaction = 1000 * random.direction(),
                                .angular_velocity = {0.3, -0.5, 0.4}};
      const JointSolution s = endless.solve(slip);
      const double overlap = rim_overlap(endless.contact(), s);
      const JointSolution in_seat = confined.solve(slip);
      over += overlap > 0;
      // By friction a contact that would lie at a rim may be free.
      EXPECT_EQ(overlap <= 0, in_seat.half_angle == s.half_angle)
          << name << " " << i;
      LargestContact largest;
      largest.add(0, 0, overlap);
      EXPECT_EQ(endless.contact().limits().notes(largest).size(),
                overlap > 0.1 * degree ? 1U : 0U);
    }
    EXPECT_GT(over, 10) << name;
    EXPECT_LT(over, 60) << name;
  }
}

// Vectors in other axes than the axes of the body with the seat give the same
// results in these axes, at a rim and free.
TEST(JointInSeat, TakesVectorsInAnyAxes) {
  const Joint joint(bearing());
  const Placement placement{
      Eigen::Quaterniond(0.3, 0.1, -0.7, 0.2).normalized().toRotationMatrix()};
  const Eigen::Matrix3d& turn = placement.from_seat;
  const Vector3d rate(0.1, 0.2, 0.3);
  const std::vector<Vector3d> places = {Vector3d(0.5, 0.1, 0.8).normalized()};
  const std::vector<Vector3d> turned = {turn * places[0]};
  for (const Vector3d& reaction :
       {Vector3d(6e4, 1e4, 8e4), Vector3d(2e3, 1e3, 2e4)}) {
    // Rounding of the axes, over the size.
    const auto expect_turned = [&](const Vector3d& is, const Vector3d& was) {
      EXPECT_LT((is - turn * was).norm(), 1e-12 * was.norm());
    };
    const JointSolution s =
        joint.solve({.reaction = reaction, .angular_velocity = rate});
    const JointSolution t = joint.solve({.reaction = turn * reaction,
                                         .angular_velocity = turn * rate,
                                         .placement = &placement});
    ASSERT_EQ(t.status, Status::ok);
    const RimContact of_s = *joint.rims(s), of_t = *joint.rims(t);
    EXPECT_EQ(of_s.is_free, reaction.norm() < 5e4);
    EXPECT_EQ(of_t.is_free, of_s.is_free);
    expect_turned(t.friction_moment, s.friction_moment);
    expect_turned(t.friction_force, s.friction_force);
    expect_turned(t.normal, s.normal);
    expect_turned(of_t.force, of_s.force);
    expect_turned(of_t.shift, of_s.shift);
    EXPECT_NEAR(of_t.upper_end, of_s.upper_end, 1e-12);
    expect_turned(joint.pv(t, turn * rate).place, joint.pv(s, rate).place);
    EXPECT_NEAR(joint.pressures(t, turned)[0], joint.pressures(s, places)[0],
                1e-9 * s.peak_pressure);
    expect_turned(joint.moment_set(t).moment(turn * Vector3d(1, 2, 3)),
                  joint.moment_set(s).moment({1, 2, 3}));
    const Vector3d held = 0.5 * s.friction_moment;
    const RestSolution r =
        joint.at_rest({.reaction = reaction, .moment = held});
    const RestSolution q = joint.at_rest({.reaction = turn * reaction,
                                          .moment = turn * held,
                                          .placement = &placement});
    EXPECT_NEAR(q.utilisation, r.utilisation, 1e-9);
    EXPECT_LT((q.direction - turn * r.direction).norm(), 1e-6);
    EXPECT_EQ(joint.notes(t), joint.notes(s));
  }
}

// A contact at a rim has no axis of symmetry: what is reckoned from one is NaN,
// not a number of another contact.
TEST(JointInSeat, HasNoNumbersAboutAnAxisAtARim) {
  const Joint joint(bearing());
  const JointSolution s = joint.solve(
      {.reaction = {6e4, 1e4, 8e4}, .angular_velocity = {0.1, 0.2, 0.3}});
  ASSERT_EQ(s.status, Status::ok);
  for (const double number :
       {s.half_angle, s.load_parameter, s.residual, s.slip_axis.sin,
        s.slip_axis.cos, s.sliding_coefficient, s.spinning_coefficient,
        s.slip_velocity.x(), s.friction_angle(),
        joint.contact().peak_pressure(s.normal_force, s.half_angle),
        derivatives(joint, {{6e4, 1e4, 8e4}, {0.1, 0.2, 0.3}}, s)
            .over_rate(0, 0)}) {
    EXPECT_TRUE(std::isnan(number));
  }
  EXPECT_NEAR(s.reaction_angle(),
              std::acos(Vector3d(6, 1, 8).normalized().dot(
                  Vector3d(1, 2, 3).normalized())),
              1e-12);
  EXPECT_NEAR(s.power, s.friction_moment.dot(Vector3d(0.1, 0.2, 0.3)),
              1e-12 * std::abs(s.power));
  EXPECT_NEAR(s.moment_coefficient(),
              s.friction_moment.norm() / (0.025 * s.reaction.norm()), 1e-12);
  EXPECT_NEAR(s.force_coefficient, s.friction_force.norm() / s.normal_force,
              1e-12);
}

TEST(JointInSeat, KeepsItsContactOrNot) {
  const Joint joint(bearing());
  const Vector3d rate(0.1, 0.2, 0.3);
  const JointSolution s =
      joint.solve({.reaction = {6e4, 1e4, 8e4}, .angular_velocity = rate});
  const JointSolution bare = s.without_grid();
  EXPECT_EQ(joint.rims(bare)->lower_end, joint.rims(s)->lower_end);
  EXPECT_EQ(bare.moment_coefficient(), s.moment_coefficient());
  // Found again from the same force, to the tolerance of the balance.
  EXPECT_NEAR(joint.pv(bare, rate).total / joint.pv(s, rate).total, 1, 1e-6);
  const JointSolution again = joint.with_grid(bare, s);
  EXPECT_NEAR(joint.pv(again, rate).total / joint.pv(s, rate).total, 1, 1e-6);
  EXPECT_LT((joint.moment_set(bare).moment(rate) - s.friction_moment).norm(),
            1e-6 * s.friction_moment.norm());
  // A copy of the joint answers for it.
  const auto copy = std::make_unique<const Joint>(joint);
  EXPECT_EQ(copy->pv(s, rate).total, joint.pv(s, rate).total);
  // A warm start finds the same.
  const JointSolution warm = joint.solve(
      {.reaction = {6e4, 1e4, 8e4}, .angular_velocity = rate}, bare);
  EXPECT_LT((warm.friction_moment - s.friction_moment).norm(),
            1e-6 * s.friction_moment.norm());
}

// Grids take most of the time; friction, name and law are without influence.
TEST(JointInSeat, SharesGridsOfJointsThatDifferInFriction) {
  SharedLaws laws;
  JointSpec other = bearing();
  other.friction = FrictionLaw(0.2);
  EXPECT_EQ(laws.seat(bearing()), laws.seat(other));
  other.geometry = other.geometry.with_clearance(2.6e-5);
  EXPECT_NE(laws.seat(bearing()), laws.seat(other));
}

TEST(JointInSeat, StepHoldsAndLetsGo) {
  for (const FrictionModel& friction : {FrictionModel(FrictionLaw(0.1)),
                                        FrictionModel(ViscousLaw(1e6, 0.05))}) {
    JointSpec spec = bearing();
    spec.friction = friction;
    const Joint joint(spec);
    const Placement placement{Eigen::Quaterniond(0.3, 0.1, -0.7, 0.2)
                                  .normalized()
                                  .toRotationMatrix()};
    const Eigen::Matrix3d& turn = placement.from_seat;
    const Eigen::Matrix3d inertia = 300 * Eigen::Matrix3d::Identity();
    const bool is_dry = std::holds_alternative<FrictionLaw>(friction);
    for (const double free : {0.1, 3.0}) {
      const StepStart start{.reaction = turn * Vector3d(6e4, 1e4, 8e4),
                            .angular_velocity = turn * Vector3d(0.2, 0.1, 0.3),
                            .free = free * (turn * Vector3d(0.2, 0.1, 0.3)),
                            .placement = &placement};
      const JointStep moved = step(joint, start, inertia);
      ASSERT_EQ(moved.status, Status::ok);
      ASSERT_FALSE(joint.rims(moved.solution)->is_free);
      EXPECT_EQ(moved.holds, is_dry && free < 1);
      EXPECT_LT((inertia * (moved.angular_velocity - start.free) - moved.moment)
                    .norm(),
                1e-9 * moved.moment.norm());
      if (moved.holds) continue;
      // The moment equals the moment of the contact at the final rate.
      const JointSolution at_end = joint.solve_contact(
          {.normal_force = moved.solution.normal_force * moved.solution.normal,
           .angular_velocity = moved.angular_velocity,
           .placement = &placement});
      EXPECT_LT((at_end.friction_moment - moved.moment).norm(),
                1e-5 * moved.moment.norm());
    }
    StepStart out{.reaction = {1e4, 0, -1e3},
                  .angular_velocity = {0, 0, 1},
                  .free = {0, 0, 1}};
    EXPECT_EQ(step(joint, out, inertia).status, Status::out_of_seat);
    EXPECT_TRUE(std::isnan(step(joint, out, inertia).moment.x()));
  }
}

TEST(JointInSeat, SaysWhatItCannotCarry) {
  const Joint joint(bearing());
  const JointSolution s =
      joint.solve({.reaction = {1e4, 0, -1e3}, .angular_velocity = {0, 0, 1}});
  EXPECT_EQ(s.status, Status::out_of_seat);
  EXPECT_EQ(to_string(s.status), "out_of_seat");
  EXPECT_TRUE(std::isnan(s.peak_pressure) && std::isnan(s.normal_force) &&
              std::isnan(s.power) && std::isnan(s.friction_moment.x()) &&
              std::isnan(joint.pv(s, {0, 0, 1}).total) &&
              std::isnan(joint.moment_set(s).support({0, 0, 1})));
  EXPECT_TRUE(joint.rims(s)->force.array().isNaN().all());
  EXPECT_TRUE(
      std::isnan(joint.pressures(s, std::vector{Vector3d(0, 0, 1)})[0]));
  EXPECT_TRUE(has_text(joint.notes(s).at(0), "the ball leaves it"));
  const RestSolution rest =
      joint.at_rest({.reaction = {1e4, 0, -1e3}, .moment = {0, 0, 1}});
  EXPECT_EQ(rest.status, Status::out_of_seat);
  EXPECT_TRUE(std::isnan(rest.utilisation));
  // The angle is counted from the seat's axis, wherever that points.
  JointSpec turned = bearing();
  turned.geometry =
      turned.geometry.with_seat(turned.geometry.seat()->about({0, 1, -1}));
  const Joint aside(turned);
  EXPECT_TRUE(has_text(aside
                           .notes(aside.solve({.reaction = {1e4, 0, 0},
                                               .angular_velocity = {0, 0, 1}}))
                           .at(0),
                       "points 90 deg from the seat's axis"));
  const Joint::Slip none{.reaction = Vector3d::Zero(),
                         .angular_velocity = {0, 0, 1}};
  EXPECT_EQ(joint.solve(none).state, JointState::unloaded);
  EXPECT_FALSE(joint.rims(joint.solve(none)));
  EXPECT_TRUE(joint.notes(joint.solve(none)).empty());
  EXPECT_EQ(
      joint.solve({.reaction = {NAN, 0, 0}, .angular_velocity = {0, 0, 1}})
          .status,
      Status::out_of_range);
}

TEST(JointInSeat, RefusesWhatItsModelDoesNotKnow) {
  const auto refusal = [](const auto& change) {
    JointSpec spec = bearing();
    change(spec);
    return error_message([&] { Joint{spec}; });
  };
  EXPECT_EQ(refusal([](JointSpec& s) { s.half_angle_law = "fitted"; }),
            "a joint in a seat that ends requires the laws exact, or "
            "without_seat");
  EXPECT_EQ(refusal([](JointSpec& s) { s.pressure_law = "cosine"; }),
            "a joint in a seat that ends requires the laws exact, or "
            "without_seat");
  EXPECT_EQ(refusal([](JointSpec& s) {
              s.friction = FrictionStress::stribeck(0.1, 0.05, 1e-3);
            }),
            "a joint in a seat that ends requires dry or viscous friction, or "
            "without_seat (left_out = true in its [seat])");
  EXPECT_EQ(refusal([](JointSpec& s) {
              s.outer.layers = {{1e-6, Material{1e9, 0.4}}};
            }),
            "seat: thickness of the surface layer = 1e-06 must be at least "
            "0.001 radii (2.5e-05 m), or without_seat");
  // Without its spec a contact has no seat.
  EXPECT_TRUE(has_text(error_message([&] { Joint(bearing().contact()); }),
                       "without_seat()"));
  EXPECT_TRUE(has_text(error_message([&] {
                         Joint(bearing().without_seat())
                             .tabulated({.least_load = 1, .most_load = 2});
                       }),
                       "requires a joint with a [seat]"));
}

TEST(SeatTable, AnswersAsTheContact) {
  for (const SeatZone& zone :
       {SeatZone::cup(60 * degree), SeatZone(65 * degree, 115 * degree)}) {
    JointSpec spec = bearing();
    spec.geometry = spec.geometry.with_seat(zone);
    const Gridded joint(spec, {.cells = 16, .longitudes = 48});
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
      const detail::SeatModel without = joint.with(nullptr);
      const detail::SeatModel with = joint.with(table);
      const JointSolution exact = without.solve(slip, {}, {});
      const JointSolution read = with.solve(slip, {}, {});
      const RimContact of_exact = *without.rims(exact);
      const RimContact of_read = *with.rims(read);
      ASSERT_FALSE(of_exact.is_free);
      // Not solved again.
      EXPECT_NE(of_read.shift, of_exact.shift);
      EXPECT_LT((read.friction_moment - exact.friction_moment).norm() /
                    exact.friction_moment.norm(),
                2e-3);
      EXPECT_NEAR(read.peak_pressure / exact.peak_pressure, 1, 2e-2);
      EXPECT_LT((of_read.shift - of_exact.shift).norm() / of_exact.shift.norm(),
                2e-3);
      // The grid does what the table does not know, from a contact near by.
      const JointSolution whole = with.with_grid(read, exact);
      EXPECT_NEAR(with.pv(whole, w).total / without.pv(exact, w).total, 1,
                  2e-3);
      EXPECT_NEAR(with.pv(read, w).total / without.pv(exact, w).total, 1, 2e-3);
    }
  }
}

// A table read again is bit-identical; a table of another joint and a truncated
// one are rejected.
TEST(SeatTable, IsReadAgain) {
  const JointSpec spec = bearing();
  const Gridded joint(spec, {.cells = 10, .longitudes = 30});
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
  const JointSolution s = joint.with(made).solve(slip, {}, {});
  const JointSolution t = joint.with(read).solve(slip, {}, {});
  ASSERT_NE(s.friction_moment,
            joint.with(nullptr).solve(slip, {}, {}).friction_moment);
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
  const Gridded joint(spec, {.cells = 10, .longitudes = 30});
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

TEST(SeatTable, GoesWithItsJoint) {
  const Joint joint(bearing());
  const Joint tabulated = joint.tabulated(
      {.least_load = 1.4e5, .most_load = 1.6e5, .accuracy = 0.05, .checks = 3});
  EXPECT_EQ(joint.table(), "");
  EXPECT_FALSE(joint.table_check());
  EXPECT_EQ(tabulated.table_check()->states, 3);
  const Joint read = joint.tabulated(tabulated.table());
  const Joint::Slip slip{.reaction = {5e4, 2e4, 1.4e5},
                         .angular_velocity = {0.2, 0.1, 0.3}};
  const JointSolution s = tabulated.solve(slip);
  EXPECT_EQ(read.solve(slip).friction_moment, s.friction_moment);
  EXPECT_NEAR(
      s.friction_moment.norm() / joint.solve(slip).friction_moment.norm(), 1,
      0.05);
  EXPECT_NEAR(tabulated.moment_set(s).moment(slip.angular_velocity).norm() /
                  s.friction_moment.norm(),
              1, 1e-6);
}

// Loads on both sides of a symmetric ring.
TEST(SeatTable, MirrorsAcrossTheEquator) {
  JointSpec spec = bearing();
  spec.geometry = spec.geometry.with_seat({65 * degree, 115 * degree});
  const Gridded joint(spec, {.cells = 12, .longitudes = 40});
  const detail::SeatModel model = joint.with(std::make_shared<const SeatTable>(
      joint.contact(), SeatTable::Options{.least_load = 6e4,
                                          .most_load = 1.2e5,
                                          .accuracy = 1e-2,
                                          .checks = 5}));
  const auto solve = [&](double up) {
    return model.solve({.reaction = {8e4, 1e4, up * 4e4},
                        .angular_velocity = {up * 0.2, up * 0.5, 0.3}},
                       {}, {});
  };
  const JointSolution s = solve(1), t = solve(-1);
  const RimContact of_s = *model.rims(s), of_t = *model.rims(t);
  for (const JointSolution& of : {s, t}) {
    ASSERT_FALSE(model.rims(of)->is_free);
    ASSERT_NE(model.with_grid(of, {}).work, of.work);  // the table has none
  }
  // Rounding of the direction.
  EXPECT_NEAR(of_s.rims[0].intensity / of_t.rims[1].intensity, 1, 1e-9);
  EXPECT_NEAR(of_s.lower_end, pi - of_t.upper_end, 1e-9);
  EXPECT_NEAR(of_s.shift.z() / -of_t.shift.z(), 1, 1e-9);
  EXPECT_NEAR(s.friction_moment.x(), -t.friction_moment.x(),
              1e-9 * s.friction_moment.norm());
  EXPECT_NEAR(s.friction_moment.z(), t.friction_moment.z(),
              1e-9 * s.friction_moment.norm());
}

}  // namespace
}  // namespace contact::test::joint_test
