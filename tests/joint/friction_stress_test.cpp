#include "libcontact/pair/friction_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "libcontact/base/units.hpp"
#include "libcontact/duty/sliding_contact.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/friction/stress_rule.hpp"
#include "libcontact/joint/group.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/factory.hpp"
#include "support/accuracy_report.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/random_slip.hpp"
#include "support/reference_table.hpp"

namespace contact::test::friction_stress_test {
namespace {

using Eigen::Vector3d;

JointSpec bearing() {
  return read_joint(CONTACT_DATA_DIR "/reference/duty/general_bearing.toml");
}

FrictionStress coulomb(double f0, double adhesion) {
  return {[=](double p, double) { return f0 * p + adhesion; },
          FrictionStress::OverSpeed::constant};
}

// The law that a row of the reference data names.
FrictionStress law_of(const std::string& name) {
  if (name.starts_with("stribeck")) {
    return FrictionStress::stribeck(0.15, 0.05, 0.01);
  }
  if (name.starts_with("power")) return FrictionStress::power(0.1, 1e7, 0.25);
  EXPECT_TRUE(name.starts_with("coulomb")) << name;
  return coulomb(0.06, 2e5);
}

JointContact contact_with(const FrictionStress& stress) {
  JointSpec joint = bearing();
  joint.friction = stress;
  return joint.contact();
}

// Errors over this size.
void add_over(double size, AccuracyReport& report,
              const FrictionTriple& computed, const FrictionTriple& expected,
              const std::string& label) {
  for (const auto role : {&FrictionTriple::force, &FrictionTriple::sliding,
                          &FrictionTriple::spinning}) {
    report.add_error(std::abs(computed.*role - expected.*role) / size, label);
  }
}

// Reference: by the definition, 1e-10.
TEST(FrictionStress, IntegralsOfReference) {
  const ReferenceTable table("duty/general_friction.csv");
  ASSERT_EQ(table.size(), 18u);
  AccuracyReport fine("64 points", 1e-10);
  AccuracyReport usual("24 points", 1e-10);
  for (const ReferenceTable::Row row : table) {
    const double rho = row.value("rho_m");
    const auto law = make_pressure_law(row.text("pressure"), JointKind::ball,
                                       bearing().pair());
    const SlipAxis axis = SlipAxis::from_degrees(row.value("alpha_deg"));
    for (const int points : {64, usual_stress_points}) {
      AccuracyReport& report = points == 64 ? fine : usual;
      const FrictionTriple i = stress_integrals(
          *law,
          {row.value("theta0_deg") * degree, row.value("R_n_N") / (rho * rho),
           rho * row.value("w_rad_per_s")},
          axis, law_of(row.text("tau")), points);
      const double force = rho * rho * i.force;
      const double y = rho * rho * rho * i.sliding;
      const double z = rho * rho * rho * i.spinning;
      const double size =
          std::hypot(row.value("M_Y_N_m"), row.value("M_Z_N_m"));
      report.add(force, row.value("R_t_N"), row.label());
      report.add_error(std::abs(y - row.value("M_Y_N_m")) / size, row.label());
      report.add_error(std::abs(z - row.value("M_Z_N_m")) / size, row.label());
      report.add(row.value("w_rad_per_s") * (y * axis.cos + z * axis.sin),
                 row.value("heat_W"), row.label());
    }
  }
}

// Under friction that falls steeply the fast parts of a contact rub less than
// its slow ones, and the moment about n drives the spin. By an independent
// program's sum of tau over 300 x 720 pieces of the contact, right to its six
// digits.
TEST(FrictionStress, MayDriveTheSpin) {
  const Joint ball(parse_joint(R"(name = "ball"
kind = "ball"
geometry = { radius_mm = 25, radial_clearance_um = 25 }
[materials]
inner = { youngs_modulus_GPa = 207, poissons_ratio = 0.3 }
outer = { youngs_modulus_GPa = 111, poissons_ratio = 0.35 }
[friction]
law = "stribeck"
static_coefficient = 0.4
dynamic_coefficient = 0.02
stribeck_velocity_mm_per_s = 10
)",
                               "ball")
                       .contact());
  for (const double side : {1.0, -1.0}) {  // rate of the spin
    const JointSolution s =
        ball.solve_contact({{0, 0, 2e4}, {0, std::sqrt(3), side}});
    EXPECT_NEAR(s.friction_moment.y(), -13.88499, 2e-5);
    EXPECT_NEAR(s.friction_moment.z(), side * 0.069197, 2e-6);
    EXPECT_NEAR(s.power, -23.980, 1e-3);
    // The same contact, found from its reaction.
    const JointSolution found =
        ball.solve({s.reaction, {0, std::sqrt(3), side}});
    EXPECT_NEAR(found.friction_moment.z(), side * 0.069197, 2e-6);
  }
}

// The usual number of points against four times as many: the worst of these
// contacts, some with the slip axis inside, some near the edge.
TEST(FrictionStress, UsualPoints) {
  const auto power = [](double m) { return FrictionStress::power(.1, 1e7, m); };
  const FrictionStress hersey(
      [](double p, double v) { return p * (0.02 + 0.1 * p / (p + 1e9 * v)); },
      FrictionStress::OverSpeed::falls);
  struct Case {
    const char* name;
    FrictionStress stress;
    double budget;
  };
  // Tolerances of stress_integrals(), or a few times the errors seen.
  const Case cases[] = {{"dry with adhesion", coulomb(0.06, 2e5), 2e-11},
                        {"stribeck", law_of("stribeck"), 3e-11},
                        {"v/p", hersey, 1e-9},
                        {"p^0.9", power(0.1), 1e-11},
                        {"p^0.75", power(0.25), 1e-11},
                        {"p^(2/3)", power(1. / 3), 1e-11},
                        {"p^0.5", power(0.5), 1e-11},
                        {"p^0.1", power(0.9), 1e-10}};
  for (const auto& [name, stress, budget] : cases) {
    AccuracyReport report(name, budget);
    for (const char* pressure : {"cosine", "sqrt_tan"}) {
      const auto law =
          make_pressure_law(pressure, JointKind::ball, bearing().pair());
      for (const auto& [theta0, a] : {std::pair(5., 2.),
                                      {20., 30.},
                                      {30., 80.},
                                      {40., 49.5},
                                      {60., 75.},
                                      {71.4, 0.},
                                      {71.5, 40.1},
                                      {77.7, 70.3},
                                      {80., 85.},
                                      {89., 45.}}) {
        const auto at = [&, half_angle = theta0 * degree,
                         axis = SlipAxis::from_degrees(a),
                         &of = stress](int points) {
          return stress_integrals(*law, {half_angle, 3e7, 0.035}, axis, of,
                                  points);
        };
        const FrictionTriple i = at(usual_stress_points);
        const FrictionTriple exact = at(96);
        const std::string label = std::string(pressure) + " " +
                                  std::to_string(theta0) + " " +
                                  std::to_string(a);
        const double size = std::hypot(exact.sliding, exact.spinning);
        report.add(i.force, exact.force, label);
        report.add_error(std::abs(i.sliding - exact.sliding) / size, label);
        report.add_error(std::abs(i.spinning - exact.spinning) / size, label);
      }
    }
  }
}

// Stribeck's curve with the slip axis inside the contact and vs far below the
// rim's speed: beside the axis a layer of the width vs/(rho |Dw|).
TEST(FrictionStress, ThinLayersBesideTheSlipAxis) {
  constexpr double fs = 0.35;
  constexpr double fc = 0.05;
  constexpr double rim = 0.035;
  const auto law =
      make_pressure_law("sqrt_tan", JointKind::ball, bearing().pair());
  AccuracyReport points("usual points", 2e-10);
  // The layer of 1e-4 itself changes the moment by less.
  AccuracyReport dry("layer of 1e-4 against dry friction", 1e-8);
  for (const auto& [theta0, a] : {std::pair(30., 70.),
                                  {30., 61.},
                                  {60., 31.},
                                  {60., 89.},
                                  {80., 85.},
                                  {89., 45.}}) {
    const SlipAxis axis = SlipAxis::from_degrees(a);
    for (const double layer :
         {0.3, 0.1, 0.03, 0.01, 0.005, 0.002, 0.001, 1e-4}) {
      const std::string label = std::to_string(theta0) + " " +
                                std::to_string(a) + " " + std::to_string(layer);
      const auto at = [&, half_angle = theta0 * degree](int count) {
        return stress_integrals(*law, {half_angle, 1, rim}, axis,
                                FrictionStress::stribeck(fs, fc, layer * rim),
                                count);
      };
      const FrictionTriple i = at(usual_stress_points);
      const FrictionTriple exact = at(96);
      const double size = std::hypot(exact.sliding, exact.spinning);
      add_over(size, points, i, exact, label);
      if (layer > 1e-4) continue;
      const FrictionTriple c =
          friction_integrals(*law, theta0 * degree, axis).coefficient;
      add_over(size, dry, i, {fc * c.force, fc * c.sliding, fc * c.spinning},
               label);
    }
  }
}

TEST(FrictionStress, JointsOfReference) {
  const ReferenceTable table("duty/general_joint.csv");
  ASSERT_EQ(table.size(), 9u);
  // With the usual points.
  AccuracyReport forces("R_n, R_t", 1e-10);
  AccuracyReport moments("M_t, heat", 1e-10);
  AccuracyReport angles("theta0, a, rad", 1e-10);
  for (const ReferenceTable::Row row : table) {
    const Joint joint(contact_with(law_of(row.text("tau"))));
    const double b = row.value("b_deg") * degree;
    const JointSolution s =
        joint.solve({row.value("R_N") * Vector3d(std::sin(b), 0, std::cos(b)),
                     {0, 0, row.value("w_rad_per_s")}});
    const std::string label = row.label();
    ASSERT_EQ(s.status, Status::ok) << label;
    const double rho = joint.contact().geometry().radius();
    const double y = rho * s.normal_force * s.sliding_coefficient;
    const double z = rho * s.normal_force * s.spinning_coefficient;
    const double size = std::hypot(row.value("M_Y_N_m"), row.value("M_Z_N_m"));
    forces.add(s.normal_force, row.value("R_n_N"), label);
    forces.add(s.friction_force.norm(), row.value("R_t_N"), label);
    moments.add_error(std::abs(y - row.value("M_Y_N_m")) / size, label);
    moments.add_error(std::abs(z - row.value("M_Z_N_m")) / size, label);
    moments.add(-s.power, row.value("heat_W"), label);
    angles.add_error(std::abs(s.half_angle - row.value("theta0_deg") * degree),
                     label);
    angles.add_error(
        std::abs(s.slip_axis_angle() - row.value("a_deg") * degree), label);
  }
}

// Against the closed forms and integrals of dry friction, up to 120 deg and
// where the slip axis pierces the edge or the centre.
TEST(FrictionStress, DryFrictionByPoints) {
  // friction_integrals() promise 1e-10.
  AccuracyReport usual("up to 90 deg, 24 points", 2e-10);
  AccuracyReport fine("up to 90 deg, 64 points", 2e-10);
  AccuracyReport wide("beyond", 2e-10);
  for (const char* name : {"cosine", "sqrt_tan", "sqrt_theta"}) {
    const auto law = make_pressure_law(name, JointKind::ball, bearing().pair());
    for (const double theta0 :
         {1e-4, 1., 20., 45., 80., 89., 90., 100., 120.}) {
      for (const double a : {0., 1e-7, 3., 45., 60., 88., 89.9999, 90.}) {
        const SlipAxis axis = SlipAxis::from_degrees(a);
        const auto exact = friction_integrals(*law, theta0 * degree, axis);
        for (const int points : {24, 64}) {
          const FrictionTriple i = stress_integrals(
              *law, {theta0 * degree, 1, 1}, axis, coulomb(0.5, 0.25), points);
          AccuracyReport& report = theta0 > 90    ? wide
                                   : points == 24 ? usual
                                                  : fine;
          const std::string label = std::string(name) + " " +
                                    std::to_string(theta0) + " " +
                                    std::to_string(a);
          const double force =
              0.5 * exact.coefficient.force + 0.25 * exact.area.force;
          const double y =
              0.5 * exact.coefficient.sliding + 0.25 * exact.area.sliding;
          const double z =
              0.5 * exact.coefficient.spinning + 0.25 * exact.area.spinning;
          // At a = 90 deg neither is there.
          const double size = std::max(std::abs(force), 1e-6);
          report.add_error(std::abs(i.force - force) / size, label);
          report.add_error(std::abs(i.sliding - y) / std::max(y, 1e-6), label);
          report.add_error(std::abs(i.spinning - z) / std::hypot(y, z), label);
        }
      }
    }
  }
}

// The definition beyond 90 deg goes on where the great circles end.
TEST(FrictionStress, RulesMeetAt90Degrees) {
  AccuracyReport report("Stribeck at 90 deg", 1e-8);
  const auto law =
      make_pressure_law("sqrt_tan", JointKind::ball, bearing().pair());
  for (const double a : {0., 20., 70., 90.}) {
    const auto at = [&](double theta0) {
      return stress_integrals(*law, {theta0, 1e7, 0.03},
                              SlipAxis::from_degrees(a),
                              FrictionStress::stribeck(.15, .05, .01));
    };
    const FrictionTriple below = at(90 * degree);
    const FrictionTriple above = at(std::nextafter(90 * degree, 2));
    const std::string label = std::to_string(a);
    const double size = std::hypot(below.sliding, below.spinning);
    add_over(size, report, above, below, label);
  }
}

// A joint by points is the joint by closed forms: solution, rest, moment set
// and heat, balls and pins.
TEST(FrictionStress, IsDryFriction) {
  for (const char* file : {CONTACT_DATA_DIR "/joints/hip_cocr_uhmwpe.toml",
                           CONTACT_DATA_DIR "/joints/pin_joint.toml"}) {
    JointSpec spec = read_joint(file);
    spec.inner = spec.inner.surface();  // without walls
    spec.outer = spec.outer.surface();
    spec.half_angle_law = "tanh";
    spec.pressure_law = "cosine";
    spec.friction = FrictionLaw(0.12, 3e4);
    const Joint dry(spec.contact());
    spec.friction = coulomb(0.12, 3e4);
    const Joint general(spec.contact());
    AccuracyReport report(std::string("against dry friction, ") + file, 1e-8);
    RandomSlips random(7);
    for (int i = 0; i < 40; ++i) {
      Joint::Slip slip{Vector3d::Random() * 2e3, Vector3d::Random()};
      if (dry.is_pin()) slip.angular_velocity = Vector3d(0, 0, 2);
      const JointSolution a = dry.solve(slip);
      const JointSolution b = general.solve(slip);
      const std::string label = std::to_string(i);
      ASSERT_EQ(b.status, Status::ok);
      report.add(b.friction_moment.norm(), a.friction_moment.norm(), label);
      report.add((b.reaction - b.friction_force).norm(), a.normal_force, label);
      const SlidingContact s(dry.contact(), a, slip.angular_velocity);
      const SlidingContact t(general.contact(), b, slip.angular_velocity);
      report.add(t.heat(), s.heat(), label);
      report.add(t.pv_total(), s.pv_total(), label);
      report.add(t.largest_heat_flux().value, s.largest_heat_flux().value,
                 label);
      report.add(t.heat_flux(t.centre()), s.heat_flux(s.centre()), label);
      const Joint::Hold hold{slip.reaction, slip.angular_velocity};
      report.add(general.at_rest(hold).utilisation,
                 dry.at_rest(hold).utilisation, label);
      if (dry.is_pin()) continue;
      report.add(general.moment_set(b).support(slip.angular_velocity),
                 dry.moment_set(a).support(slip.angular_velocity), label);
      const Vector3d free = Vector3d::Random() * 100;
      const auto inertia = Eigen::Matrix3d::Identity();
      report.add(
          general.moment_set(b).prox(inertia, free).angular_velocity.norm(),
          dry.moment_set(a).prox(inertia, free).angular_velocity.norm(), label);
    }
  }
}

// Rest follows tau(p, 0), or is undefined.
TEST(FrictionStress, Rest) {
  const Joint::Hold hold{{0, 300, 900}, {2, 3, 1}};
  const Joint falls(contact_with(FrictionStress::stribeck(0.15, 0.05, 0.01)));
  const Joint rises(contact_with(FrictionStress::stribeck(0.05, 0.15, 0.01)));
  const Joint dry(contact_with(coulomb(0.05, 0)));
  EXPECT_NE(falls.contact().rest_refusal(), "");
  EXPECT_EQ(falls.at_rest(hold).status, Status::out_of_range);
  EXPECT_TRUE(std::isnan(falls.at_rest(hold).utilisation));
  const JointSolution s = falls.solve({hold.reaction, hold.moment});
  EXPECT_TRUE(all_nan({falls.moment_set(s).support({1, 0, 0}),
                       falls.moment_set(s).utilisation({1, 0, 0}),
                       falls.moment_set(s)
                           .prox(Eigen::Matrix3d::Identity(), {1, 0, 0})
                           .angular_velocity.x()}));
  EXPECT_EQ(rises.contact().rest_refusal(), "");
  EXPECT_NEAR(rises.at_rest(hold).utilisation, dry.at_rest(hold).utilisation,
              1e-8 * dry.at_rest(hold).utilisation);
  const JointGroup group({{falls, 0}, {dry, 1}},
                         JointGroup::Sharing{{1, 1}, {0.5, 0.5}});
  JointGroup::Solution solution = group.make_solution();
  EXPECT_TRUE(std::isnan(group.utilisation({.reaction = {0, 0, 900},
                                            .moment = {0, 0, 0},
                                            .axis = {0, 0, 1},
                                            .needed = 1},
                                           solution)));
}

// The friction of a curve through points of a smooth law over five decades:
// 4e-6 with 32, 1e-8 with 128; with straight lines 1e-3.
TEST(FrictionStress, TablesOfPressure) {
  const auto law = [](double p) { return 0.05 + 0.1 / (1 + p / 2e6); };
  const auto moment = [](const FrictionStress& stress) {
    const Joint joint(contact_with(stress));
    return joint.solve({{0, 2000, 1500}, {0, 0, 1}}).friction_moment.norm();
  };
  const double exact = moment({[&](double p, double) { return p * law(p); },
                               FrictionStress::OverSpeed::constant});
  const auto error = [&](int count, FrictionStress::Table::Curve curve) {
    FrictionStress::Table table{{}, {}, curve};
    for (int i = 0; i < count; ++i) {
      table.points.push_back(1e3 * std::pow(1e5, i / (count - 1.0)));
      table.coefficients.push_back(law(table.points.back()));
    }
    return std::abs(moment(FrictionStress::of_pressure(table)) / exact - 1);
  };
  EXPECT_LT(error(32, FrictionStress::Table::Curve::spline), 1e-5);
  EXPECT_LT(error(128, FrictionStress::Table::Curve::spline), 2e-8);
  EXPECT_GT(error(32, FrictionStress::Table::Curve::linear), 1e-4);
  EXPECT_LT(error(32, FrictionStress::Table::Curve::linear), 3e-3);
}

TEST(FrictionStress, TablesOfHerseyNumbers) {
  // Constant outside, the points themselves inside.
  const FrictionStress falling =
      FrictionStress::of_hersey({{1e-10, 1e-9, 1e-8},
                                 {0.2, 0.1, 0.15},
                                 FrictionStress::Table::Curve::spline});
  EXPECT_EQ(falling.over_speed(), FrictionStress::OverSpeed::falls);
  EXPECT_DOUBLE_EQ(falling.stress_at(1e6, 0), 0.2e6);
  EXPECT_DOUBLE_EQ(falling.stress_at(1e6, 1e-3), 0.1e6);
  EXPECT_DOUBLE_EQ(falling.stress_at(1e6, 1), 0.15e6);
  EXPECT_EQ(falling.stress_at(0, 0), 0);
  EXPECT_EQ(falling.note(), "");
  const FrictionStress rising = FrictionStress::of_hersey(
      {{1e-10, 1e-8}, {0.1, 0.2}, FrictionStress::Table::Curve::linear});
  EXPECT_EQ(rising.over_speed(), FrictionStress::OverSpeed::rises);
  EXPECT_DOUBLE_EQ(rising.stress_at(1e6, 1e-3), 0.15e6);
  EXPECT_NE(rising.note(), "");
}

TEST(FrictionStress, Messages) {
  const auto of_pressure = [](std::vector<double> p, std::vector<double> f) {
    return error_message([&] { FrictionStress::of_pressure({p, f}); });
  };
  EXPECT_EQ(of_pressure({1e6}, {0.1}),
            "friction over pressure: 1 points and 1 coefficients must be as "
            "many of both, 2 or more");
  EXPECT_EQ(of_pressure({2e6, 1e6}, {0.1, 0.1}),
            "friction over pressure: point = 1000000 must be above 2000000, "
            "the point before it");
  EXPECT_EQ(of_pressure({1e6, 2e6}, {0.3, 0.1}),
            "friction over pressure: the curve through the coefficients must "
            "be one whose friction stress p f does not fall with p");
  EXPECT_EQ(of_pressure({1e6, 2e6, 3e6}, {0.1, -0.1, 0.1}),
            "friction over pressure: coefficient = -0.1 must be 0 or above");
  EXPECT_ERROR(FrictionStress::of_hersey({{1e-9, 2e-9}, {0.1, 0.3}}),
               "friction over v/p: the curve through the coefficients must be "
               "one whose friction stress p f does not fall with p");
  EXPECT_ERROR(FrictionStress::power(0.1, 1e6, 1.5),
               "power friction: exponent = 1.5 must be 0 to 1");
  EXPECT_ERROR(FrictionStress::stribeck(0.1, 0.1, 0),
               "stribeck friction: speed = 0 must be above 0 m/s and finite");
}

}  // namespace
}  // namespace contact::test::friction_stress_test
