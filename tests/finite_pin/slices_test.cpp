// Pins that end behind Joint, against FinitePin, whose numbers are tested by
// finite_pin_test, in frames of their own.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <vector>

#include "libcontact/duty/joint_rating.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"
#include "libcontact/joint/contact_notes.hpp"
#include "libcontact/joint/group.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/joint/step.hpp"
#include "play/reference_joint.hpp"
#include "support/bush.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/random_slip.hpp"

namespace contact::test::slices_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double rho = 0.02;
constexpr double length = 0.05;

JointSpec bush(Relief relief = Relief::none(),
               JointBody inner = JointBody::carrier) {
  return bush_of(FrictionLaw(0.1, 1e6), relief, inner);
}

// Any rotation.
Matrix3d turn(double angle) {
  return Eigen::AngleAxisd(angle, Vector3d(1, -2, 0.5).normalized())
      .toRotationMatrix();
}

void expect_near(const Vector3d& a, const Vector3d& b, double tolerance,
                 const std::string& label) {
  EXPECT_LE((a - b).norm(), tolerance)
      << label << ": " << a.transpose() << " for " << b.transpose();
}

struct Lying {
  Relief relief;
  JointBody inner;
  Vector2d tilt;
  double place;
  double rate, axial_velocity;
};
const Lying lyings[] = {
    {Relief::none(), JointBody::carrier, {8e-4, 0}, nan, 2, 0},
    {Relief::none(), JointBody::body, {8e-4, -3e-4}, nan, -2, 0},
    {Relief::ends(1.5e-5, 0.008), JointBody::carrier, {0, 0}, nan, 1, 0},
    {Relief::ends(1.5e-5, 0.008), JointBody::body, {0, 0}, 0.006, 1, 0.01},
    {Relief::barrel(1e-5), JointBody::carrier, {0, 0}, -0.004, -3, -0.05},
    {Relief::barrel(1e-5), JointBody::body, {5e-4, 5e-4}, nan, 0, 0.1},
    {Relief::barrel(1e-5), JointBody::carrier, {5e-4, 0}, nan, 0, 0},
};

// All numbers of a joint equal FinitePin's, turned.
TEST(Slices, AreThoseOfTheFinitePin) {
  constexpr double size = 4e4;
  int number = 0;
  for (const Lying& l : lyings) {
    const std::string label = "lying " + std::to_string(number++);
    const JointSpec spec = bush(l.relief, l.inner);
    const FinitePin pin(spec);
    const FinitePin::Motion motion{l.rate, l.axial_velocity};
    const FinitePinSolution f = std::isnan(l.place)
                                    ? pin.solve({size, 0}, l.tilt, motion)
                                    : pin.solve_at({size, 0}, l.place, motion);
    ASSERT_EQ(f.contact.status, Status::ok) << label;
    const Joint joint(spec);
    EXPECT_EQ(joint.is_endless(), l.relief == Relief::none()) << label;
    const Matrix3d q = turn(0.7 + number);
    const Placement placement{.tilt = q * Vector3d(l.tilt.x(), l.tilt.y(), 7),
                              .place = l.place,
                              .axial_velocity = l.axial_velocity};
    const Vector3d axis = q.col(2);
    // A part along the axis is left out.
    const JointSolution s = joint.solve(
        {size * q.col(0) + 3e3 * axis, l.rate * axis, axis, &placement});
    ASSERT_EQ(s.status, Status::ok) << label;
    const double side = l.inner == JointBody::carrier ? 1 : -1;
    const auto turned = [&](const Vector2d& v, double z = 0) {
      return Vector3d(q * Vector3d(v.x(), v.y(), z));
    };
    const bool slides = l.rate != 0 || l.axial_velocity != 0;
    EXPECT_EQ(s.state, slides ? JointState::sliding : JointState::resting);
    constexpr double near = 1e-12;
    expect_near(s.reaction, size * q.col(0), near * size, label + " R");
    expect_near(s.normal_force * s.normal, turned(side * f.contact.force),
                near * size, label + " R_n");
    expect_near(s.friction_force,
                turned(f.friction_force, f.axial_friction_force), near * size,
                label + " R_t");
    expect_near(s.friction_moment, f.moment.z() * axis, near * rho * size,
                label + " M_t");
    EXPECT_NEAR(
        s.power,
        f.moment.z() * l.rate + f.axial_friction_force * l.axial_velocity,
        near * size)
        << label;
    EXPECT_NEAR(s.moment_coefficient(), std::abs(f.moment.z()) / (rho * size),
                near)
        << label;
    EXPECT_NEAR(s.peak_pressure / f.contact.peak_pressure, 1, near) << label;
    EXPECT_NEAR(s.contact_area / (f.contact.area_moment / rho), 1, near);
    EXPECT_TRUE(all_nan({s.half_angle, s.load_parameter, s.residual,
                         s.slip_axis.sin, s.sliding_coefficient,
                         s.slip_velocity.x(), s.friction_direction.sin}));

    const std::optional<PinLie> lie = joint.lie(s);
    ASSERT_TRUE(lie) << label;
    expect_near(lie->tilt, turned(f.contact.tilt), near, label + " tilt");
    expect_near(lie->shift, turned(f.contact.shift), near * 1e-4, label);
    expect_near(lie->moment, q * f.moment, near * size * length, label + " M");
    expect_near(lie->tilting_moment, turned(f.contact.force_moment),
                near * size * length, label + " G");
    EXPECT_NEAR(lie->tilting_stiffness / f.contact.stiffness(2, 2), 1, near);
    EXPECT_EQ(lie->pieces, f.contact.pieces);
    EXPECT_NEAR(lie->low, f.contact.low, near);
    EXPECT_NEAR(lie->high, f.contact.high, near);
    EXPECT_NEAR(lie->end_pressure[1], f.contact.end_pressure[1],
                near * s.peak_pressure);
    EXPECT_NEAR(lie->largest_half_angle, f.contact.largest_half_angle, near);
    EXPECT_EQ(joint.lie(s.without_grid())->low, lie->low);

    // The same contact under its normal force.
    if (std::isnan(l.place)) {
      const JointSolution known = joint.solve_contact(
          {s.normal_force * s.normal, l.rate * axis, axis, &placement});
      expect_near(known.reaction, s.reaction, 1e-9 * size, label + " known");
      expect_near(known.friction_moment, s.friction_moment, 1e-9 * rho * size,
                  label + " known");
    }
  }
}

// A tiny tilt, by slices, against the joint without ends.
TEST(Slices, LevelAreTheEndlessJoint) {
  JointSpec spec = bush();
  spec.half_angle_law = "exact";
  const Joint joint(spec);
  const Placement level{.tilt = Vector3d(1e-14, 0, 0)};
  for (const double force : {1e2, 1e4, 3e5}) {
    const Vector3d r(0, force, 0), w(0, 0, -2);
    const JointSolution endless = joint.solve({r, w});
    const JointSolution slices = joint.solve({r, w, Vector3d::Zero(), &level});
    EXPECT_FALSE(std::isnan(endless.half_angle));
    EXPECT_TRUE(std::isnan(slices.half_angle));
    // Tolerances as in finite_pin_test.
    expect_near(slices.friction_moment, endless.friction_moment,
                1e-8 * endless.friction_moment.norm(), "M_t");
    expect_near(slices.normal, endless.normal, 1e-8, "n");
    EXPECT_NEAR(slices.peak_pressure / endless.peak_pressure, 1, 1e-8);
    EXPECT_NEAR(slices.contact_area / endless.contact_area, 1, 1e-8);
    EXPECT_NEAR(slices.power / endless.power, 1, 1e-8);
    EXPECT_NEAR(slices.adhesion_number / endless.adhesion_number, 1, 1e-8);
    EXPECT_EQ(slices.textbook_moment, endless.textbook_moment);
    EXPECT_EQ(slices.reaction_angle(), endless.reaction_angle());
  }
}

// The pin's axis nears the hole's wall where the slope takes it.
TEST(Slices, TiltPressesTheEndThatItNears) {
  for (const JointBody inner : {JointBody::carrier, JointBody::body}) {
    const Joint joint(bush(Relief::none(), inner));
    const bool is_carrier = inner == JointBody::carrier;
    const Vector3d r(3e4, 0, 0), w(0, 0, 1), z(0, 0, 1);
    const Placement up{.tilt = Vector3d(6e-4, 0, 0)};
    const auto ends = [&](const Vector3d& axis, const Placement& p) {
      return joint.lie(joint.solve({r, w, axis, &p}))->end_pressure;
    };
    const auto at = ends(z, up);
    EXPECT_EQ(at[1] > at[0], is_carrier);
    // Counted along the other direction of the axis, the slope is another.
    const Placement down{.tilt = -up.tilt};
    const auto back = ends(-z, down);
    EXPECT_NEAR(back[0], at[1], 1e-9 * std::max(at[0], at[1]));
    EXPECT_NEAR(back[1], at[0], 1e-9 * std::max(at[0], at[1]));
    // A load at a place tilts the pin so that this end is pressed.
    const Placement placed{.place = 0.005};
    const auto off = ends(z, placed);
    EXPECT_GT(off[1], off[0]);
  }
}

TEST(Slices, HoldWhatSlowSlidingHas) {
  const JointSpec spec = bush(Relief::ends(1.5e-5, 0.008));
  const Joint joint(spec);
  const FinitePin pin(spec);
  const Vector3d r(0, 5e4, 0), axis(0, 0, 1);
  for (const double moment : {-40.0, 25.0}) {
    for (const double place : {nan, 0.004}) {
      const Placement placement{.place = place};
      const double rate = moment > 0 ? -1 : 1;
      const FinitePinSolution f = std::isnan(place)
                                      ? pin.solve({5e4, 0}, {0, 0}, rate)
                                      : pin.solve_at({5e4, 0}, place, rate);
      const RestSolution rest =
          joint.at_rest({r, moment * axis, axis, &placement});
      EXPECT_EQ(rest.status, Status::ok);
      EXPECT_NEAR(rest.utilisation, moment / f.moment.z(), 1e-12);
      EXPECT_EQ(rest.direction, rate * axis);
      EXPECT_TRUE(joint.lie(rest.slip));
      // The axis by the moment.
      EXPECT_EQ(joint.at_rest({r, moment * axis, Vector3d::Zero(), &placement})
                    .utilisation,
                rest.utilisation);
    }
  }
  // All friction is along the axis of one that slides along it.
  const Placement slides{.axial_velocity = 1e-3};
  const RestSolution rest = joint.at_rest({r, axis, axis, &slides});
  EXPECT_EQ(rest.status, Status::ok);
  EXPECT_EQ(rest.utilisation, infinity);
  // L is over the speed of turning, which there is none of.
  const JointSolution along = joint.solve({r, Vector3d::Zero(), axis, &slides});
  const auto rated = rating_of(joint, along, Vector3d::Zero());
  EXPECT_GT(rated.pv_total, 0);
  EXPECT_TRUE(std::isnan(rated.slip_coefficient));
  const JointSolution both = joint.solve({r, axis, axis, &slides});
  EXPECT_GT(rating_of(joint, both, axis).slip_coefficient, 1);
  // A step holds up to the limit, and slides beyond it.
  const Matrix3d inertia = 10 * Matrix3d::Identity();
  const double limit = std::abs(pin.solve({5e4, 0}, {0, 0}, 1).moment.z());
  for (const double share : {0.99, 1.01}) {
    const JointStep next = step(
        joint, {r, Vector3d::Zero(), share * limit / 10 * axis, axis}, inertia);
    EXPECT_EQ(next.holds, share < 1);
    EXPECT_NEAR(next.moment.z(), -std::min(share, 1.0) * limit, 1e-10 * limit);
  }
}

// p over angle and length carries the load, and its slip the heat.
TEST(Slices, PressuresSumToWhatTheyCarry) {
  const JointSpec spec = bush(Relief::barrel(1e-5), JointBody::body);
  const Joint joint(spec);
  const Matrix3d q = turn(2);
  const Placement placement{.tilt = q * Vector3d(3e-4, 2e-4, 0),
                            .axial_velocity = 0.02};
  const Vector3d rate = -1.5 * q.col(2);
  const JointSolution s =
      joint.solve({6e4 * q.col(1), rate, q.col(2), &placement});
  ASSERT_EQ(s.status, Status::ok);
  constexpr int rows = 200, angles = 720;
  std::vector<Vector3d> places;
  for (int i = 0; i < rows; ++i) {
    const double z = length * ((i + 0.5) / rows - 0.5);
    for (int k = 0; k < angles; ++k) {
      const double t = 2 * pi * (k + 0.5) / angles;
      places.push_back(
          q * Vector3d(std::cos(t), std::sin(t), z / rho).normalized());
    }
  }
  const std::vector<double> p = joint.pressures(s, places);
  const double area = length / rows * 2 * pi * rho / angles;
  Vector3d force = Vector3d::Zero();
  double sum = 0, most = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector3d across =
        (places[i] - places[i].dot(q.col(2)) * q.col(2)).normalized();
    force += area * p[i] * across;
    sum += area * p[i];
    most = std::max(most, p[i]);
  }
  // On the hole, which the carrier has. The rule is 1e-4 at the contact's end.
  expect_near(force, -s.normal_force * s.normal, 1e-3 * 6e4, "F");
  const double speed = std::hypot(1.5 * rho, 0.02);
  const ContactPv pv = joint.pv(s, rate);
  EXPECT_NEAR(pv.total / (speed * sum), 1, 1e-3);
  EXPECT_NEAR(pv.largest, speed * s.peak_pressure, 1e-9 * pv.largest);
  EXPECT_LE(most, s.peak_pressure * (1 + 1e-12));
  EXPECT_GT(most, s.peak_pressure * (1 - 1e-3));
  EXPECT_NEAR(pv.place.norm(), 1, 1e-14);
  const Vector3d there =
      (rho * pv.place + joint.lie(s)->peak_place * q.col(2)).normalized();
  EXPECT_NEAR(joint.pressures(s, std::vector{there})[0] / s.peak_pressure, 1,
              1e-9);
  // At an end, which rounds to either side of itself, and beyond.
  const double at_end = joint.lie(s)->end_pressure[1];
  ASSERT_GT(at_end, 0);
  const Vector3d middle = joint.lie(s)->shift + length / 2 * joint.lie(s)->tilt;
  for (const double by : {-1e-15, 0.0, 1e-15, 1e-9}) {
    const Vector3d end =
        rho * middle.normalized() + length / 2 * (1 + by) * q.col(2);
    const double p_end = joint.pressures(s, std::vector{end})[0];
    EXPECT_NEAR(p_end, by > 1e-12 ? 0 : at_end, 1e-6 * at_end) << by;
  }
  // Along the axis there is no surface.
  EXPECT_EQ(joint.pressures(s, std::vector<Vector3d>{q.col(2)})[0], 0);
}

// A pin with a placement is a finite-length pin, also when level: a tilt of 0
// is the limit of small tilts. A pin without a placement is bit-identical to
// the pin without ends.
TEST(Slices, LevelPinEndsWhereItsTiltIsGiven) {
  RandomSlips random(3);
  const JointSpec spec =
      bush_of(FrictionLaw(0.1), Relief::none(), JointBody::carrier);
  const Joint joint(spec);
  const Joint endless(spec.contact());
  int answers = 0;
  const Placement level, nearly{.tilt = Vector3d(1e-12, -1e-12, 0)};
  for (int i = 0; i < 100; ++i) {
    const Vector3d axis = random.direction();
    const Vector3d across = random.direction().cross(axis).normalized();
    const Joint::Slip slip{random.log_uniform(1e3, 3e5) * across,
                           (random.uniform() - 0.5) * axis, axis};
    Joint::Slip placed = slip, tilted = slip;
    placed.placement = &level;
    tilted.placement = &nearly;
    const JointSolution a = joint.solve(placed);
    const JointSolution b = joint.solve(tilted);
    ASSERT_EQ(a.status, b.status);
    if (a.status != Status::ok) continue;  // a half-angle beyond 80 deg
    ++answers;
    ASSERT_TRUE(joint.lie(a));
    // 1e-12 over the approach per length at 1 kN.
    EXPECT_NEAR(a.peak_pressure / b.peak_pressure, 1, 1e-6);
    EXPECT_LT((a.friction_moment - b.friction_moment).norm(),
              1e-6 * b.friction_moment.norm());
    const Joint::Hold hold{slip.reaction, axis, axis};
    Joint::Hold placed_hold = hold, tilted_hold = hold;
    placed_hold.placement = &level;
    tilted_hold.placement = &nearly;
    EXPECT_NEAR(joint.at_rest(placed_hold).utilisation /
                    joint.at_rest(tilted_hold).utilisation,
                1, 1e-6);
    const JointSolution c = joint.solve(slip), d = endless.solve(slip);
    EXPECT_EQ(c.friction_moment, d.friction_moment);
    EXPECT_EQ(c.half_angle, d.half_angle);
    EXPECT_EQ(c.peak_pressure, d.peak_pressure);
    EXPECT_FALSE(joint.lie(c));
    EXPECT_EQ(joint.at_rest(hold).utilisation,
              endless.at_rest(hold).utilisation);
    // The same contact, by the same law along the whole length.
    EXPECT_NEAR(a.friction_moment.norm() / c.friction_moment.norm(), 1, 1e-2);
  }
  EXPECT_GE(answers, 90);
}

TEST(Slices, WithoutLoadOrAxis) {
  const Joint joint(bush(Relief::ends(1.5e-5, 0.008)));
  const Vector3d z(0, 0, 1);
  const JointSolution none = joint.solve({Vector3d::Zero(), z});
  EXPECT_EQ(none.status, Status::ok);
  EXPECT_EQ(none.state, JointState::unloaded);
  EXPECT_EQ(none.peak_pressure, 0);
  EXPECT_EQ(none.friction_moment.norm(), 0);
  EXPECT_EQ(joint.lie(none)->pieces, 0);
  // Tilted until it jams, it is pressed at both ends without a load.
  const Placement jammed{.tilt = Vector3d(2.5e-3, 0, 0)};
  const JointSolution pressed = joint.solve({Vector3d::Zero(), z, z, &jammed});
  EXPECT_EQ(pressed.status, Status::ok);
  EXPECT_EQ(joint.lie(pressed)->pieces, 2);
  EXPECT_LT(pressed.friction_moment.z(), 0);
  EXPECT_EQ(pressed.normal_force, 0);
  EXPECT_GT(pressed.peak_pressure, 0);
  // At rest and level any axis is as good as another.
  const Vector3d r(1e3, 2e4, -500);
  const JointSolution rests = joint.solve({r, Vector3d::Zero()});
  EXPECT_EQ(rests.state, JointState::resting);
  EXPECT_EQ(rests.reaction, r);
  EXPECT_NEAR(rests.peak_pressure,
              joint.solve({r.norm() * Vector3d::UnitX(), Vector3d::Zero(), z})
                  .peak_pressure,
              1e-9 * rests.peak_pressure);
  const Placement tilted{.tilt = Vector3d(1e-4, 0, 0)};
  EXPECT_EQ(
      joint.solve({r, Vector3d::Zero(), Vector3d::Zero(), &tilted}).status,
      Status::out_of_range);
}

TEST(Slices, NumbersThatAreNoneHaveNoAnswer) {
  const Joint joint(bush(Relief::barrel(1e-5)));
  const Vector3d r(1e4, 0, 0), z(0, 0, 1);
  struct Case {
    Vector3d r, w, axis;
    Placement placement;
  };
  const Case cases[] = {{{nan, 0, 0}, z, z, {}},
                        {{infinity, 0, 0}, z, z, {}},
                        {r, {0, 0, nan}, z, {}},
                        {r, {0, 0, infinity}, z, {}},
                        {r, z, {0, nan, 0}, {}},
                        {r, z, z, {.tilt = {nan, 0, 0}}},
                        {r, z, z, {.tilt = {infinity, 0, 0}}},
                        {r, z, z, {.place = infinity}},
                        {r, z, z, {.axial_velocity = nan}},
                        {1e12 * r, z, z, {}},
                        {r, z, z, {.tilt = {1, 0, 0}}}};
  for (const Case& c : cases) {
    const std::string label = std::to_string(&c - cases);
    const JointSolution s = joint.solve({c.r, c.w, c.axis, &c.placement});
    EXPECT_EQ(s.status, Status::out_of_range) << label;
    EXPECT_TRUE(all_nan({s.normal_force, s.friction_moment.z(), s.power,
                         s.peak_pressure, s.moment_coefficient(),
                         joint.pv(s, z).largest,
                         joint.pressures(s, std::vector{r})[0]}))
        << label;
    EXPECT_FALSE(joint.lie(s)) << label;
    EXPECT_EQ(joint.notes(s).size(), 1) << label;
    const JointSolution known =
        joint.solve_contact({c.r, c.w, c.axis, &c.placement});
    EXPECT_EQ(known.status, Status::out_of_range) << label;
    const RestSolution rest = joint.at_rest({c.r, c.w, c.axis, &c.placement});
    EXPECT_TRUE(std::isnan(rest.utilisation)) << label;
  }
}

// A joint without slices keeps its unlimited contact, and a note gives the
// reason.
TEST(Slices, AreLeftOutWhereTheyCannotBe) {
  struct Case {
    JointSpec spec;
    std::string why;
  };
  std::vector<Case> cases;
  const auto add = [&](const std::string& why) -> JointSpec& {
    cases.push_back({bush(), why});
    return cases.back().spec;
  };
  add("a pin of finite length requires dry friction: a coefficient and an "
      "adhesion")
      .friction = ViscousLaw(1, 0);
  add("pin joint with play requires a radial_clearance above 0 m").geometry =
      JointGeometry::pin(rho, -2e-6, length);
  {
    JointSpec& back = add(
        "pin joint with play requires loading = centre: a body that is pressed "
        "from behind has no approach");
    back.outer = Material{210e9, 0.3};
    back.half_angle_law = "exact";
    back.loading = InnerLoading::back(0.2);
  }
  const std::string infinite =
      "pin joint with play requires a wall with a backing other than an "
      "infinite body: in an infinite hole the displacement has no limit";
  add(infinite).outer = Material{110e9, 0.3};
  add(infinite).outer = {{{0.004, {110e9, 0.34}}},
                         Backing::medium({210e9, 0.3})};
  {
    JointSpec& coated = add(infinite);
    coated.inner = {{{0.001, {3e9, 0.4}}}, Backing::medium({210e9, 0.3})};
    coated.outer = Material{110e9, 0.3};
  }
  const Vector3d r(2e3, 0, 0), z(0, 0, 1);
  for (const Case& c : cases) {
    EXPECT_EQ(FinitePin::refusal(c.spec), c.why);
    EXPECT_ERROR(FinitePin{c.spec}, c.why);
    JointSpec relieved = c.spec;
    relieved.relief = Relief::barrel(1e-6);
    const Joint joint(relieved);
    EXPECT_TRUE(joint.is_endless());
    EXPECT_EQ(joint.solve({r, z}).friction_moment,
              Joint(c.spec).solve({r, z}).friction_moment);
    const std::vector<std::string> notes = joint.contact().validity_notes();
    const std::string said = "the relief of the ends is ignored: " + c.why;
    EXPECT_EQ(std::count(notes.begin(), notes.end(), said), 1) << c.why;
    for (const std::string& note : notes) {
      EXPECT_TRUE(note == said || note.find("relief") == note.npos) << note;
    }
  }
  cases.push_back({test::steel_ball(), {}});
  cases.back().spec.friction = FrictionLaw(0.1);
  const Placement placements[] = {
      {.tilt = Vector3d(1e-4, 0, 0)}, {.place = 0}, {.axial_velocity = 1}};
  for (const Case& c : cases) {
    const Joint joint(c.spec);
    for (const Placement& placement : placements) {
      const JointSolution s = joint.solve({r, z, z, &placement});
      EXPECT_EQ(s.status, Status::out_of_range);
      EXPECT_FALSE(joint.lie(s));
      const std::vector<std::string> notes = joint.notes(s);
      ASSERT_EQ(notes.size(), 1);
      EXPECT_TRUE(has_text(notes[0], "slides along its axis requires a pin"));
      ContactNotes all;
      all.add(joint, s);
      EXPECT_EQ(all.of_seat().size(), 1);
      EXPECT_EQ(joint.solve_contact({r, z, z, &placement}).status,
                Status::out_of_range);
      EXPECT_EQ(joint.at_rest({r, z, z, &placement}).status,
                Status::out_of_range);
    }
  }
  JointSpec too_long = bush(Relief::ends(1e-5, 0.03));
  EXPECT_ERROR(
      Joint{too_long},
      "relief: length = 0.03 must be at most half of the joint's length");
}

// The relief is none of the notes of a joint that has it; limits refer to the
// largest contact of its slices.
TEST(Slices, NotesAreOfTheSlices) {
  const JointSpec spec = bush(Relief::ends(1.5e-5, 0.008));
  const Joint joint(spec);
  EXPECT_EQ(joint.contact().validity_notes(),
            Joint(bush()).contact().validity_notes());
  EXPECT_TRUE(has_text(spec.own_notes().at(0), "relief of the ends"));
  const Vector3d r(2e5, 0, 0), z(0, 0, 1);
  const Placement tilted{.tilt = Vector3d(2e-3, 0, 0)};
  const JointSolution s = joint.solve({r, z, z, &tilted});
  ASSERT_EQ(s.status, Status::ok);
  EXPECT_TRUE(joint.notes(s).empty());
  ContactNotes notes;
  notes.add(joint, s);
  EXPECT_EQ(notes.largest().half_angle, joint.lie(s)->largest_half_angle);
  EXPECT_EQ(notes.largest().peak_pressure, s.peak_pressure);
  EXPECT_TRUE(has_text(joint.notes(joint.solve({1e9 * r, z}))[0],
                       "half-angle along the pin beyond 80 deg"));
  EXPECT_ERROR(joint.tabulated(RimTableOptions{1, 10}),
               "a table of contacts requires a joint with a [seat]");
  EXPECT_EQ(joint.table(), "");
  EXPECT_ERROR((JointGroup{{{joint, 0}, {joint, 1}}}),
               "joint group requires pins without a [relief], or "
               "without_relief");
}

}  // namespace
}  // namespace contact::test::slices_test
