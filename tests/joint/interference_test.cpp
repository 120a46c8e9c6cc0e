#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "libcontact/base/units.hpp"
#include "libcontact/duty/sliding_contact.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/play/published_forces.hpp"
#include "support/accuracy_report.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"
#include "support/wall.hpp"

// Joints without clearance and with interference.
namespace contact::test::interference_test {
namespace {

using Eigen::Vector3d;

JointSpec spec_of(JointKind kind, double clearance,
                  const FrictionModel& friction = FrictionLaw(0.1)) {
  const double rho = 0.02;
  return {.geometry = kind == JointKind::ball
                          ? JointGeometry::ball(rho, clearance)
                          : JointGeometry::pin(rho, clearance, 0.03),
          .inner = Material{2.1e11, 0.3},
          .outer = {{{0.004, Material{1e9, 0.4}}}, Backing::rigid()},
          .friction = friction};
}

void compare_with_rows(JointKind kind) {
  const bool is_ball = kind == JointKind::ball;
  AccuracyReport angle("theta0", 1e-7);
  // With walls and below 120 deg the table of all joints serves: 1e-6.
  AccuracyReport sum("sum of pressures", 1e-6);
  AccuracyReport peak("peak pressure", 1e-6);
  AccuracyReport shift("shift", 1e-6);
  AccuracyReport friction("chi, sigma_Y, sigma_Z", 2e-6);
  SharedLaws laws;  // rows of one pair of bodies stand together
  for (const ReferenceTable::Row row :
       ReferenceTable("preload/preload_" + to_string(kind) + ".csv")) {
    const LayeredPair pair = test::reference_pair(row);
    const double rho = row.value("rho");
    const double eps = row.value("clearance");
    const double length = 0.01;
    const JointContact contact =
        JointSpec{.geometry = is_ball ? JointGeometry::ball(rho, eps)
                                      : JointGeometry::pin(rho, eps, length),
                  .inner = pair.inner(),
                  .outer = pair.outer(),
                  .friction = FrictionLaw(0.1),
                  .half_angle_law = "exact"}
            .contact(laws);
    const double unit = is_ball ? 1 : length;
    const double force = row.value("load") * unit;
    const std::string& state = row.text("state");
    const ContactState expected = state == "closed"   ? ContactState::closed
                                  : state == "lifted" ? ContactState::lifted
                                  : state == "zero"   ? ContactState::zero
                                                      : ContactState::clearance;
    EXPECT_EQ(contact.state(force), expected) << row.label();
    const HalfAngleResult found = contact.half_angle(force);
    EXPECT_EQ(found.status, Status::ok) << row.label();
    const double theta0 = found.half_angle;
    angle.add(theta0, row.value("theta0_deg") * degree, row.label());
    sum.add(contact.sum_of_pressures(force, theta0), row.value("sum_p") * unit,
            row.label());
    peak.add(contact.pressure(0, force, theta0), row.value("p_centre"),
             row.label());
    if (state == "closed") {
      EXPECT_NEAR(contact.pressure(pi, force, theta0) / row.value("p_back"), 1,
                  1e-9)
          << row.label();
    }
    const std::string& known = row.text("shift");
    if (known.empty()) {
      EXPECT_TRUE(std::isnan(contact.shift(force, theta0))) << row.label();
    } else if (force > 0 &&
               !(eps > 0 && !std::isfinite(pair.relative_thickness()))) {
      // (Without layers ExactLaw has no approach for a pin in a rigid hole.)
      shift.add(contact.shift(force, theta0), row.value("shift"), row.label());
    }
    if (!is_ball || force == 0) continue;
    const FrictionIntegrals i =
        contact.integrals(theta0, SlipAxis::from_degrees(30), {force, 1});
    friction.add(i.coefficient.force, row.value("chi_30"), row.label());
    friction.add(i.coefficient.sliding, row.value("sigma_Y_30"), row.label());
    friction.add(i.coefficient.spinning, row.value("sigma_Z_30"), row.label());
  }
  if (!is_ball) friction.may_be_empty();
}

TEST(InterferenceJoint, IsThatOfTheReference) {
  for (const JointKind kind : kinds) compare_with_rows(kind);
}

// Without load: pin rho l (2 pi rho p_0 f0 + 2 pi rho A), ball
// pi^2 rho^3 (f0 p_0 + A), opposite to Dw.
TEST(InterferenceJoint, TurnsHardWithoutLoad) {
  const Vector3d rate(0.3, -0.4, 1.2);
  const double f0 = 0.07, adhesion = 2e5;
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    const Joint joint(spec_of(kind, -20e-6, FrictionLaw(f0, adhesion)));
    const double p0 = joint.contact().interference_pressure();
    const double rho = 0.02;
    const double stress = f0 * p0 + adhesion;
    const double expected = kind == JointKind::ball
                                ? pi * pi * std::pow(rho, 3) * stress
                                : 2 * pi * rho * rho * 0.03 * stress;
    const JointSolution s =
        joint.solve({Vector3d::Zero(), rate, rate.normalized()});
    EXPECT_EQ(s.status, Status::ok);
    EXPECT_EQ(s.state, JointState::sliding);
    EXPECT_EQ(s.contact_state, ContactState::closed);
    EXPECT_EQ(s.half_angle, pi);
    EXPECT_TRUE(s.friction_force.isZero(0));
    EXPECT_NEAR(s.peak_pressure / p0, 1, 1e-15);
    EXPECT_LT((s.friction_moment + expected * rate.normalized()).norm(),
              1e-13 * expected);
    EXPECT_NEAR(s.power, -expected * rate.norm(), 1e-13 * expected);
    EXPECT_NEAR(joint.contact().unloaded_moment(1), expected, 1e-13 * expected);
    // The smallest load is next to none.
    const Vector3d tiny = 1e-9 * rate.unitOrthogonal();
    const JointSolution next = joint.solve({tiny, rate, rate.normalized()});
    EXPECT_EQ(next.status, Status::ok);
    EXPECT_LT((next.friction_moment - s.friction_moment).norm(),
              1e-9 * expected);
    // At rest it holds up to this.
    const Vector3d held = 0.25 * expected * rate.normalized();
    const RestSolution rest =
        joint.at_rest({Vector3d::Zero(), held, rate.normalized()});
    EXPECT_EQ(rest.status, Status::ok);
    EXPECT_NEAR(rest.utilisation, 0.25, 1e-13);
    EXPECT_EQ(joint.solve({Vector3d::Zero(), Vector3d::Zero()}).state,
              JointState::resting);
  }
}

// A pin's torque is constant up to the load at which it lifts off, in the sense
// of the normal force, and rises from 2 rho f0 P_l then; a ball's moment about
// an axis normal to the load as well, by less than its shift of R_n.
TEST(InterferenceJoint, TorqueHasAPlateau) {
  const Joint pin(spec_of(JointKind::pin, -20e-6));
  const double lift_off = pin.contact().lift_off_force();
  const double unloaded = pin.contact().unloaded_moment(1);
  const auto torque = [&](double normal_force) {
    const Vector3d reaction(normal_force * std::hypot(1, 0.1), 0, 0);
    return -pin.solve({reaction, {0, 0, 1}, {0, 0, 1}}).friction_moment.z();
  };
  EXPECT_NEAR(unloaded, 2 * 0.02 * 0.1 * lift_off, 1e-13 * unloaded);
  for (const double share : {1e-6, 0.01, 0.5, 0.999999}) {
    EXPECT_NEAR(torque(share * lift_off), unloaded, 1e-12 * unloaded) << share;
  }
  double last = unloaded;
  for (const double share : {1.01, 1.1, 1.5, 3.0, 10.0}) {
    const double m = torque(share * lift_off);
    EXPECT_GT(m, last) << share;
    EXPECT_LT(m, unloaded * share) << share;
    last = m;
  }
}

// The sign of a load of 0 has no meaning: the load parameter has the sign of
// the clearance.
TEST(InterferenceJoint, NoLoadHasNoSign) {
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    for (const double clearance : {20e-6, -20e-6}) {
      JointSpec spec = spec_of(kind, clearance);
      spec.half_angle_law = "exact";
      const JointContact contact = spec.contact();
      for (const double none : {0.0, -0.0}) {
        EXPECT_EQ(contact.half_angle(none).half_angle,
                  clearance > 0 ? 0 : std::numbers::pi);
      }
    }
  }
}

// Torque is continuous where the contact lifts off, and where the clearance
// changes its sign.
TEST(InterferenceJoint, NothingJumps) {
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    const JointContact contact = spec_of(kind, -20e-6).contact();
    const auto moment = [](const JointContact& c, double force) {
      const JointSolution s =
          Joint(c).solve({{force, 0, 0}, {0.2, 0, 1}, {0, 0, 0}});
      EXPECT_EQ(s.status, Status::ok);
      return s.friction_moment.norm();
    };
    const double lift_off = contact.lift_off_force();
    EXPECT_NEAR(moment(contact, lift_off * (1 - 1e-7)) /
                    moment(contact, lift_off * (1 + 1e-7)),
                1, 1e-6);
    const double force = 3 * lift_off;
    const double none = moment(contact.with_clearance(0), force);
    EXPECT_NEAR(moment(contact.with_clearance(-1e-13), force) / none, 1, 1e-6);
    EXPECT_NEAR(moment(contact.with_clearance(1e-13), force) / none, 1, 1e-6);
    EXPECT_EQ(contact.with_clearance(0).state(force), ContactState::zero);
  }
}

// d(shift)/d(force) is 1/stiffness from closed to lifted.
TEST(InterferenceJoint, StiffnessIsTheSlopeOfTheShift) {
  AccuracyReport report("stiffness", 1e-6);
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    const JointContact contact = spec_of(kind, -20e-6).contact();
    const auto shift = [&](double force) {
      return contact.shift(force, contact.half_angle(force).half_angle);
    };
    for (const double share : {0.5, 1.2, 4.0}) {
      const double force = share * contact.lift_off_force();
      const double h = 1e-4 * force;
      report.add(
          (shift(force + h) - shift(force - h)) / (2 * h),
          1 / contact.approach(contact.half_angle(force).half_angle).stiffness,
          to_string(kind) + " " + std::to_string(share));
    }
  }
}

// A friction stress f0 p + A is dry friction, closed, lifted and without load.
TEST(InterferenceJoint, FrictionStressesAreDryFriction) {
  const double f0 = 0.07, adhesion = 2e5;
  const FrictionStress stress(
      [=](double p, double) { return f0 * p + adhesion; },
      FrictionStress::OverSpeed::constant);
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    const Joint dry(spec_of(kind, -20e-6, FrictionLaw(f0, adhesion)));
    const Joint same(dry.contact().with_friction(stress));
    const double lift_off = dry.contact().lift_off_force();
    EXPECT_NEAR(
        same.contact().unloaded_moment(0) / dry.contact().unloaded_moment(0), 1,
        1e-9);
    for (const double share : {0.0, 0.4, 1.5, 6.0}) {
      const Joint::Slip slip = {
          {share * lift_off, 0, 0},
          {0.2, 0, 1},
          kind == JointKind::pin ? Vector3d(0, 0, 1) : Vector3d(0, 0, 0)};
      const JointSolution a = dry.solve(slip);
      const JointSolution b = same.solve(slip);
      EXPECT_EQ(b.status, Status::ok) << share;
      // The pressure of a lifted contact is tabulated to 1e-6.
      EXPECT_LT((a.friction_moment - b.friction_moment).norm(),
                2e-6 * a.friction_moment.norm())
          << to_string(kind) << share;
    }
  }
}

// Without load, closed and lifted: p v over the contact is the heat over f0,
// the peak equals p_0 + p_1 or the law's, and held moments equal moments of
// sliding.
TEST(InterferenceJoint, RatesSlidingAtEveryLoad) {
  const Vector3d rate(0.2, 0, 1);
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    const bool is_pin = kind == JointKind::pin;
    const Joint joint(spec_of(kind, -20e-6, FrictionLaw(0.07)));
    const JointContact& contact = joint.contact();
    const Vector3d w = is_pin ? Vector3d(0, 0, 1) : rate;
    for (const double share : {0.0, 0.4, 1.5, 6.0}) {
      const Vector3d reaction(share * contact.lift_off_force(), 0, 0);
      const JointSolution s =
          joint.solve({reaction, w, is_pin ? w : Vector3d(0, 0, 0)});
      const SlidingContact sliding(contact, s, w);
      const double heat = -s.friction_moment.dot(w);
      EXPECT_NEAR(sliding.heat() / heat, 1, 1e-12) << share;
      EXPECT_NEAR(sliding.pv_total() * 0.07 / heat, 1, 1e-7) << share;
      const SlidingContact::Peak peak = sliding.largest_pv();
      EXPECT_NEAR(sliding.pressure(sliding.centre()) / s.peak_pressure, 1, 1e-6)
          << share;
      EXPECT_LE(peak.value, s.peak_pressure * 0.02 * w.norm() * (1 + 1e-6));
      EXPECT_GT(peak.value,
                0.9 * sliding.pv_total() / contact.area(s.half_angle))
          << share;
      if (is_pin) continue;
      const MomentSet held = joint.moment_set(s);
      EXPECT_LT((held.moment(w) - s.friction_moment).norm(),
                1e-9 * s.friction_moment.norm())
          << share;
      EXPECT_NEAR(held.utilisation(s.friction_moment), 1, 1e-9) << share;
    }
  }
}

// The whole pressure follows the profile, whose slope is its derivative.
TEST(InterferenceJoint, SlopesAreThoseOfThePressure) {
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    const JointContact contact = spec_of(kind, -20e-6).contact();
    const double theta0 =
        contact.half_angle(1.3 * contact.lift_off_force()).half_angle;
    const PressureLaw& law = contact.pressure_law();
    ASSERT_GT(theta0, law.largest_half_angle());
    for (const double share : {-0.5, 0.1, 0.4, 0.7, 0.9}) {
      const double theta = share * theta0;
      const double h = 1e-3;
      const double expected =
          (law.pressure(theta - h, theta0) - law.pressure(theta + h, theta0)) /
          (2 * h);
      EXPECT_NEAR(law.slope(theta, theta0), expected, 1e-5 * law.peak(theta0))
          << to_string(kind) << share;
    }
  }
}

TEST(InterferenceJoint, NotesWhatItDoesNotSay) {
  const auto notes = [](JointKind kind, double clearance) {
    std::string all;
    for (const std::string& note :
         spec_of(kind, clearance).contact().validity_notes()) {
      all += note + "\n";
    }
    return all;
  };
  EXPECT_EQ(notes(JointKind::pin, 20e-6), "");
  EXPECT_EQ(notes(JointKind::pin, 0), "");
  EXPECT_EQ(notes(JointKind::pin, -20e-6),
            "the hoop stress that interference causes in the two bodies is not "
            "computed\n");
  EXPECT_NE(notes(JointKind::ball, 0).find("nearly complete"),
            std::string::npos);
  EXPECT_NE(notes(JointKind::pin, -4e-4)
                .find("relative interference 0.02 "
                      "exceeds 0.01"),
            std::string::npos);
  JointSpec stiff = spec_of(JointKind::pin, -20e-6);
  stiff.outer =
      LayeredBody({{0.001, Material{1e7, 0.4999999}}}, Backing::rigid());
  EXPECT_NE(stiff.contact().validity_notes().back().find(
                "exceeds Young's modulus of the softer body"),
            std::string::npos);
  // A contact of 180 deg is a state, not an error.
  const JointContact closed = spec_of(JointKind::pin, -20e-6).contact();
  EXPECT_TRUE(closed.limits().notes({pi, 1}).empty());
  JointSpec soft = spec_of(JointKind::pin, -20e-6);
  soft.outer.layers[0].material.limit_pressure = 1e5;
  const JointContact pressed = soft.contact();
  EXPECT_EQ(pressed.limits().notes({pi, pressed.peak_pressure(0, pi)}).size(),
            1U);
}

// The friction of a pin with strong adhesion falls like the root of R_n beyond
// lift-off: so steeply that the last bit of R_n moves it by 1e-11.
TEST(InterferenceJoint, StrongAdhesionLiftsOff) {
  const struct {
    double coefficient, adhesion, interference;
    Material hole;
  } cases[] = {{2.52, 2.345e9, 11.2e-6, {3.9e10, 0.45}},
               {1.19, 2.6e10, 13.2e-6, {3.6e9, 0.45}},
               {0.98, 3.6e6, 0.3e-6, {1.13e9, 0.45}},
               {0.99, 4e8, 2.2e-6, {7.7e9, 0.49}}};
  for (const auto& c : cases) {
    const Joint joint(
        {.geometry = JointGeometry::pin(0.01, -c.interference, 0.02),
         .inner = Material{2.1e11, 0.3},
         .outer = c.hole,
         .friction = FrictionLaw(c.coefficient, c.adhesion)});
    const double lift_off = joint.contact().lift_off_force();
    double last = 0;
    for (double load = 1e-3 * lift_off; load < 1e4 * lift_off; load *= 1.04) {
      const JointSolution s = joint.solve({{load, 0, 0}, Vector3d::UnitZ()});
      ASSERT_EQ(s.status, Status::ok) << c.coefficient << ", " << load;
      EXPECT_GE(s.normal_force, last * (1 - 1e-14)) << load;
      last = s.normal_force;
      // The load that neighbours of R_n belong to, by the friction under them.
      const auto load_of = [&](double normal_force) {
        return joint.solve_contact({{normal_force, 0, 0}, Vector3d::UnitZ()})
            .reaction.norm();
      };
      constexpr double bits = 4e-15;
      const auto [low, high] =
          std::minmax({load_of(last * (1 - bits)), load_of(last * (1 + bits))});
      EXPECT_LE(low, load * (1 + 1e-13));
      EXPECT_GE(high, load * (1 - 1e-13));
    }
  }
}

TEST(InterferenceJoint, RefusesWhatKnowsNone) {
  JointSpec joint = spec_of(JointKind::ball, -20e-6);
  joint.outer = Material{1e9, 0.4};
  for (const char* law : {"fitted", "tanh", "hertz"}) {
    joint.half_angle_law = law;
    EXPECT_ERROR(joint.contact(), "half-angle law " + std::string(law) +
                                      " must be exact with interference");
  }
  joint.half_angle_law = "";
  EXPECT_EQ(joint.half_angle_law_name(), "exact");
  joint.pressure_law = "cosine";
  EXPECT_ERROR(joint.contact(),
               "pressure law cosine must be exact with interference");
  // Made by hand, and without clearance.
  const JointContact hertz = [] {
    JointSpec open = spec_of(JointKind::ball, 20e-6);
    open.outer = Material{1e9, 0.4};
    open.half_angle_law = "hertz";
    open.pressure_law = "worn";
    return open.contact();
  }();
  EXPECT_ERROR(hertz.with_clearance(-1e-6),
               "half-angle law hertz must be exact with interference");
  EXPECT_ERROR(
      hertz.with_clearance(0),
      "half-angle law hertz must be arctan, tanh, blend, paper, fitted or "
      "exact with no clearance");
  joint.geometry = JointGeometry::ball(0.02, 0);
  joint.pressure_law = "worn";
  EXPECT_ERROR(
      joint.contact(),
      "pressure law worn must be cosine, sqrt_tan, sqrt_theta, mixture or "
      "exact with no clearance");
  joint.geometry = JointGeometry::ball(0.02, -20e-6);
  EXPECT_ERROR(
      published_force_laws(joint.geometry, joint.pair()),
      "published force laws requires a radial_clearance above 0 m, not "
      "-2e-05: the half-angle law exact alone knows joints without");
  joint.pressure_law = "";
  joint.outer = LayeredBody({{0.004, Material{1e9, 0.5}}}, Backing::rigid());
  joint.inner = LayeredBody({}, Backing::rigid());
  EXPECT_NE(test::error_message([&] {
              joint.contact();
            }).find("an incompressible layer or body between rigid ones"),
            std::string::npos);
  EXPECT_ERROR(
      spec_of(JointKind::pin, -20e-6).contact().worn(1),
      "a worn joint requires a radial_clearance above 0 m, not -2e-05");
}

}  // namespace
}  // namespace contact::test::interference_test
