#include "libcontact/load_law/load_law.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/load_law/minimax.hpp"
#include "libcontact/load_law/pin_formula.hpp"
#include "load_law/compiled.hpp"
#include "support/error_message.hpp"
#include "support/joints.hpp"
#include "support/numbers.hpp"

// Load laws against the joints that they are made from, as numbers and as the
// C that is written.
namespace contact::test::load_law_test {
namespace {

using Eigen::Vector3d;

JointSpec pin_spec(double clearance, const FrictionModel& friction) {
  return {
      .geometry = JointGeometry::pin(0.02, clearance, 0.04),
      .inner = Material{2.1e11, 0.3},
      .outer = LayeredBody({{0.01, Material{1e11, 0.34}}}, Backing::rigid()),
      .friction = friction};
}

const Joint& loose() {
  static const Joint& pin = *new Joint(pin_spec(2e-5, FrictionLaw(0.12)));
  return pin;
}
const Joint& pressed() {
  static const Joint& pin = *new Joint(pin_spec(-3e-6, FrictionLaw(0.12)));
  return pin;
}
const Joint& sticky() {
  static const Joint& pin = *new Joint(pin_spec(2e-5, FrictionLaw(0.12, 2e4)));
  return pin;
}
using Loads = std::pair<double, double>;
constexpr Loads sticky_loads = {5.0, 5e4};

JointSolution turned(const Joint& pin, double load) {
  return pin.solve({{load, 0, 0}, {0, 0, 1}, {0, 0, 1}});
}

// Points between the points of the law's own comparison.
std::vector<double> between(Loads loads, int count) {
  std::vector<double> all;
  for (int i = 0; i < count; ++i) {
    all.push_back(loads.first *
                  std::pow(loads.second / loads.first, (i + 0.21) / count));
  }
  return all;
}

struct Errors {
  double moment = 0, in_float = 0, slope = 0;
};

// Errors of the moment over the joint's moment, and of the slope against
// differences.
Errors errors_of(const PinLoadLaw& law, const Joint& pin) {
  Errors largest;
  for (const double load : between(law.loads, 700)) {
    const JointSolution s = turned(pin, load);
    const double f = s.friction_force.norm() / s.normal_force;
    const double exact = -s.friction_moment.z();
    const auto [moment, slope] = detail::pin_moment(law, load, f);
    const float in_float =
        detail::pin_moment(law, static_cast<float>(load), static_cast<float>(f))
            .first;
    const double h = 1e-5;
    const auto at = [&](double x) {
      return detail::pin_moment(law, load * x, f).first;
    };
    const double difference = (at(1 + h) - at(1 - h)) / (2 * h * load);
    largest.moment = std::max(largest.moment, std::abs(moment / exact - 1));
    largest.in_float =
        std::max(largest.in_float, std::abs(double(in_float) / exact - 1));
    largest.slope =
        std::max(largest.slope, std::abs(difference - slope) / (exact / load));
  }
  return largest;
}

// 1.2 for loads other than the loads of the claim (load_law.hpp).
void expect_as_said(const PinLoadLaw& law, const Joint& pin, double asked) {
  EXPECT_LE(law.error, asked);
  const Errors found = errors_of(law, pin);
  EXPECT_LE(found.moment, 1.2 * law.error);
  EXPECT_GE(found.moment, 0.5 * law.error);
  EXPECT_LE(found.in_float, 1.2 * law.float_error);
  EXPECT_GE(found.in_float, 0.5 * law.float_error);
  EXPECT_LE(found.slope, 1e-5);  // differences across the kink of lift-off
}

TEST(LoadLaw, OfPinsHasTheErrorThatItSays) {
  for (const double error : {1e-4, 1e-5}) {
    expect_as_said(pin_load_law(loose(), error), loose(), error);
    expect_as_said(pin_load_law(pressed(), error), pressed(), error);
    expect_as_said(pin_load_law(sticky(), error, sticky_loads), sticky(),
                   error);
  }
}

TEST(LoadLaw, HasAFormForEveryPin) {
  using Form = PinLoadLaw::Form;
  const PinLoadLaw law = pin_load_law(loose(), 1e-4);
  EXPECT_EQ(law.form, Form::clearance);
  EXPECT_EQ(law.radius, 0.02);
  EXPECT_EQ(law.numbers.size(), 8u);
  EXPECT_EQ(pin_load_law(loose(), 1e-2).numbers.size(), 4u);
  const double per_force = loose().contact().load_parameter(1);
  EXPECT_NEAR(law.loads.first * per_force, 1e-6, 1e-15);
  EXPECT_NEAR(law.loads.second * per_force, 1e4, 1e-5);
  // Small contacts press on a plane: S is 1.
  EXPECT_NEAR(law.numbers[0], 1, 2e-4);
  EXPECT_GT(pin_load_law(loose(), 1e-5).numbers.size(), 8u);
  const PinLoadLaw lifting = pin_load_law(pressed(), 1e-4);
  EXPECT_EQ(lifting.form, Form::interference);
  EXPECT_EQ(lifting.scale, pressed().contact().lift_off_force());
  const PinLoadLaw with_adhesion = pin_load_law(sticky(), 1e-4);
  EXPECT_EQ(with_adhesion.form, Form::adhesion);
  EXPECT_EQ(with_adhesion.scale, 0);
  EXPECT_NEAR(with_adhesion.loads.second / with_adhesion.loads.first, 1e4,
              1e-8);
}

TEST(LoadLaw, GoesOnOutsideOfItsLoads) {
  const PinLoadLaw law = pin_load_law(sticky(), 1e-4, sticky_loads);
  for (const double share : {0.01, 0.5}) {
    const auto at = detail::pin_moment(law, sticky_loads.first, 0.12);
    const auto below =
        detail::pin_moment(law, share * sticky_loads.first, 0.12);
    EXPECT_NEAR(below.first / at.first, share, 1e-12);
    EXPECT_NEAR(below.second * sticky_loads.first / at.first, 1, 1e-12);
    const auto top = detail::pin_moment(law, sticky_loads.second, 0.12);
    const auto above =
        detail::pin_moment(law, sticky_loads.second / share, 0.12);
    EXPECT_NEAR(above.first / top.first, 1 / share, 1e-10);
  }
  // Halves pressed into each other keep N, and with it M, up to lift-off.
  const PinLoadLaw lifting = pin_load_law(pressed(), 1e-4);
  const auto held = detail::pin_moment(lifting, 0.5 * lifting.scale, 0.12);
  EXPECT_EQ(held, detail::pin_moment(lifting, 0.0, 0.12));
  EXPECT_EQ(held.second, 0);
  EXPECT_NEAR(
      held.first / -turned(pressed(), 0.5 * lifting.scale).friction_moment.z(),
      1, 1e-9);
  EXPECT_GT(detail::pin_moment(lifting, 1.1 * lifting.scale, 0.12).second, 0);
  for (const PinLoadLaw& of : {law, lifting, pin_load_law(loose(), 1e-4)}) {
    EXPECT_TRUE(std::isnan(detail::pin_moment(of, nan, 0.12).first));
  }
}

TEST(LoadLaw, TakesFrictionThatFallsWithSpeed) {
  const auto stribeck = FrictionStress::stribeck(0.15, 0.05, 0.01);
  const Joint pin(pin_spec(2e-5, stribeck));
  const PinLoadLaw law = pin_load_law(pin, 1e-4);
  double largest = 0, least_f = 1, most_f = 0;
  for (const double load : between(law.loads, 60)) {
    for (const double rate : {1e-3, 0.3, 0.7, 4.0, 100.0}) {
      const JointSolution s =
          pin.solve({{load, 0, 0}, {0, 0, rate}, {0, 0, 1}});
      const double f = s.friction_force.norm() / s.normal_force;
      least_f = std::min(least_f, f);
      most_f = std::max(most_f, f);
      largest =
          std::max(largest, std::abs(detail::pin_moment(law, load, f).first /
                                         -s.friction_moment.z() -
                                     1));
    }
  }
  EXPECT_LE(largest, 1.2 * law.error);
  EXPECT_LE(law.error, 1e-4);
  EXPECT_LT(least_f, 0.06);
  EXPECT_GT(most_f, 0.14);
}

TEST(LoadLaw, OfPinsIsWhatIsWrittenInC) {
  for (const Joint* pin : {&loose(), &pressed(), &sticky()}) {
    const bool has_f = pin != &sticky();
    const auto loads = has_f ? std::optional<Loads>() : sticky_loads;
    const PinLoadLaw law = pin_load_law(*pin, 1e-5, loads);
    const LoadLawText text =
        load_law_text(*pin, {.error = 1e-5, .loads = loads});
    EXPECT_EQ(text.error, law.error);
    EXPECT_EQ(text.float_error, law.float_error);
    const CompiledLaw c(text.text, has_f ? pin_wrapper : adhesive_wrapper);
    if (!c.is_there()) GTEST_SKIP() << "no compiler for this machine";
    for (const double load : between(law.loads, 50)) {
      const auto [moment, slope] = detail::pin_moment(law, load, 0.12);
      EXPECT_NEAR(c.pin(load, 0.12).value / moment, 1, 1e-13);
      EXPECT_NEAR(c.pin(load, 0.12).slope, slope, 1e-12 * moment / load);
    }
  }
}

const Joint& ball_on(JointBody inner) {
  static const std::map<JointBody, Joint>& balls =
      *new std::map<JointBody, Joint>{
          {JointBody::body, steel_ball(FrictionLaw(0.2), JointBody::body)},
          {JointBody::carrier, steel_ball(FrictionLaw(0.2))}};
  return balls.at(inner);
}

// Directions that fill the sphere.
Vector3d direction(int i) {
  const double z = 2 * std::fmod(0.754877666 * i + 0.5, 1.0) - 1;
  const double angle = 2 * pi * std::fmod(0.569840290998 * i, 1.0);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

TEST(LoadLaw, OfBallsHasTheErrorThatItSays) {
  for (const JointBody inner : {JointBody::body, JointBody::carrier}) {
    const Joint& ball = ball_on(inner);
    const double unit = 1 / ball.contact().load_parameter(1);
    const LoadLawText text = load_law_text(ball, {.error = 2e-4});
    EXPECT_LE(text.error, 1.3e-4);  // 1.234e-4 measured, 2e-4 asked for
    EXPECT_GT(text.float_error, 0);
    EXPECT_TRUE(has_text(text.text, "of friction, at most 0.5;"));
    EXPECT_TRUE(has_text(text.text, " 116 numbers."));
    EXPECT_TRUE(has_text(text.text, inner == JointBody::body
                                        ? "The body has the ball"
                                        : "The carrier has the ball"));
    const CompiledLaw c(text.text, ball_wrapper);
    if (!c.is_there()) GTEST_SKIP() << "no compiler for this machine";
    double off = 0, off_force = 0, off_hold = 0;
    for (int i = 0; i < 400; ++i) {
      const Vector3d R =
          unit * 1e-3 * std::pow(1e4, (i + 0.5) / 400) * direction(i);
      // A third is close to the load, where the slip axis is in the contact.
      const double near = std::pow(10, -0.01 * i);
      const Vector3d w =
          std::exp(0.02 * i - 4) *
          (i % 3 ? direction(7 * i + 3)
                 : Vector3d(R.normalized() + near * direction(7 * i + 3)));
      const JointSolution s = ball.solve({R, w});
      const auto of = c.ball(R, w, 0.2);
      off = std::max(off, (of.moment - s.friction_moment).norm() /
                              s.friction_moment.norm());
      off_force =
          std::max(off_force, std::abs(of.normal_force / s.normal_force - 1));
      EXPECT_EQ(of.flag, 0);
      if (i % 8) continue;
      const Vector3d m = 0.4 * s.friction_moment.norm() * direction(5 * i + 1);
      const double share =
          ball.at_rest({.reaction = R, .moment = m}).utilisation;
      off_hold = std::max(off_hold, std::abs(c.hold(R, m, 0.2) / share - 1));
    }
    EXPECT_LE(off, 1.2 * text.error);
    EXPECT_GE(off, 0.1 * text.error);
    EXPECT_LE(off_force, 2e-4);
    EXPECT_LE(off_hold, 2e-4);
  }
}

TEST(LoadLaw, OfBallsFlagsWhatIsOutside) {
  const Joint& ball = ball_on(JointBody::body);
  const double unit = 1 / ball.contact().load_parameter(1);
  const CompiledLaw c(
      load_law_text(ball, {.error = 1e-2, .loads = Loads(unit, 5 * unit)}).text,
      ball_wrapper);
  if (!c.is_there()) GTEST_SKIP() << "no compiler for this machine";
  const Vector3d R = unit * Vector3d(0.6, 0, 0.8), w(1, 2, 0.5);
  EXPECT_EQ(c.ball(1.01 * R, w, 0.2).flag, 0);
  const auto least = c.ball(R * (1 + 1e-12), w, 0.2);
  const auto below = c.ball(0.25 * R, w, 0.2);
  EXPECT_EQ(below.flag, 1);
  EXPECT_LT((below.moment - 0.25 * least.moment).norm(),
            1e-9 * least.moment.norm());
  const auto most = c.ball(5 * (1 - 1e-12) * R, w, 0.2);
  const auto above = c.ball(10 * R, w, 0.2);
  EXPECT_EQ(above.flag, 1);
  EXPECT_LT((above.moment - 2 * most.moment).norm(), 1e-9 * most.moment.norm());
  for (const auto& still :
       {c.ball(Vector3d::Zero(), w, 0.2), c.ball(R, Vector3d::Zero(), 0.2)}) {
    EXPECT_EQ(still.flag, 2);
    EXPECT_EQ(still.moment, Vector3d::Zero());
  }
  EXPECT_EQ(c.ball({nan, 0, 0}, w, 0.2).flag, 4);
  // The size of Dw is without influence, however small.
  EXPECT_LT(
      (c.ball(1.5 * R, 1e-300 * w, 0.2).moment - c.ball(1.5 * R, w, 0.2).moment)
          .norm(),
      1e-12 * most.moment.norm());
  EXPECT_EQ(c.hold(1.5 * R, Vector3d::Zero(), 0.2), 0);
}

// The best line through x^2 on [0, 1] is x - 1/8, with an error of 1/8.
TEST(LoadLaw, FitsWithTheLeastLargestError) {
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(401, 0, 1);
  Eigen::MatrixXd a(x.size(), 2);
  a << Eigen::VectorXd::Ones(x.size()), x;
  const auto line = detail::minimax_fit(a, x.cwiseAbs2(), 1, 200);
  EXPECT_NEAR(line.error, 0.125, 0.125 * 0.02);
  EXPECT_NEAR(line.numbers[1], 1, 0.02);
  EXPECT_NEAR(line.error,
              (a * line.numbers - x.cwiseAbs2()).cwiseAbs().maxCoeff(), 1e-12);
  // Squares alone have 1/6 at the ends.
  EXPECT_NEAR(detail::minimax_fit(a, x.cwiseAbs2(), 1, 1).error, 1. / 6, 2e-3);
  // The length of pairs (3 r, 4 r) is 5 r.
  Eigen::MatrixXd pairs(2 * x.size(), 2);
  pairs << 3 * a, 4 * a;
  Eigen::VectorXd b(2 * x.size());
  b << 3 * x.cwiseAbs2(), 4 * x.cwiseAbs2();
  EXPECT_NEAR(detail::minimax_fit(pairs, b, 2, 200).error, 5 * 0.125,
              5 * 0.125 * 0.02);
}

TEST(LoadLaw, SaysWhatItIs) {
  const auto text = [](const Joint& joint, LoadLawOptions options) {
    return load_law_text(joint, options).text;
  };
  const std::string c = text(loose(), {.name = "wheel", .joint = "left hub"});
  EXPECT_EQ(c.rfind("// wheel: friction of the joint \"left hub\"", 0), 0u)
      << c.substr(0, 80);
  EXPECT_TRUE(has_text(c, "KREAL wheel(KREAL load, KREAL f, KREAL *dM)"));
  EXPECT_TRUE(has_text(c, "// to "));
  for (const std::string language :
       {"c", "cuda", "glsl", "jax", "js", "numpy", "st"}) {
    const std::string of = text(loose(), {.language = language});
    const bool was_run =
        language == "c" || language == "js" || language == "numpy";
    EXPECT_EQ(of.find("do not run this language") == of.npos, was_run)
        << language;
    EXPECT_EQ(of.find("NAME"), of.npos) << language;
    EXPECT_EQ(of.find("F0"), of.npos) << language;
    if (language != "st") {
      EXPECT_TRUE(has_text(
          text(ball_on(JointBody::body), {.language = language, .error = 1e-2}),
          "friction_hold"));
    }
  }
  const std::string adhesive = text(sticky(), {.loads = sticky_loads});
  EXPECT_TRUE(has_text(adhesive, "KREAL friction(KREAL load, KREAL *dM)"));
  EXPECT_TRUE(has_text(adhesive, "Coefficient of friction 0.12 and adhesion"));
  // As a default.
  EXPECT_TRUE(has_text(text(loose(), {.language = "numpy"}), "f=0.12"));
  // The joint's warnings are repeated there.
  JointSpec thick = pin_spec(1e-3, FrictionLaw(0.12));
  EXPECT_TRUE(has_text(text(Joint(thick), {}), "// Warning: "));
}

// Values are evaluated without slopes, slopes together with their values.
TEST(LoadLaw, EvaluatesEachPolynomialOnce) {
  const std::string c =
      load_law_text(ball_on(JointBody::body), {.error = 1e-2}).text;
  const std::size_t gradient = c.find("friction_gradient");
  EXPECT_GT(c.find(" ge = "), gradient);
  std::size_t calls = 0;
  for (std::size_t at = 0; (at = c.find(" g = friction_poly(", at)) != c.npos;
       ++at) {
    ++calls;
  }
  // Three sums of each evaluation of the moment, the hold and the gradient's
  // moment; the gradient's own go by Horner's scheme for both.
  EXPECT_EQ(calls, 9u);
}

TEST(LoadLaw, RefusesWhatItIsNotFor) {
  const auto refused = [](const Joint& joint, const LoadLawOptions& options) {
    return error_message([&] { load_law_text(joint, options); });
  };
  const Joint& ball = ball_on(JointBody::body);
  EXPECT_TRUE(has_text(refused(ball, {.language = "st"}),
                       "one that has loops and vectors"));
  EXPECT_TRUE(has_text(refused(ball, {.language = "ada"}), "unknown language"));
  for (const char* name : {"", "1a", "a b", "a-b", "_a", "\xc3\xa4"}) {
    EXPECT_TRUE(
        has_text(refused(loose(), {.name = name}), "of a function must"))
        << name;
  }
  EXPECT_EQ(refused(loose(), {.name = std::string(60, 'a')}), "(no error)");
  EXPECT_TRUE(has_text(refused(loose(), {.name = std::string(61, 'a')}),
                       "of a function must"));
  EXPECT_TRUE(has_text(refused(loose(), {.error = 1e-12}),
                       "an error of 1e-12 of the load law must be at least"));
  for (const Loads& loads : {Loads(0, 1), Loads(2, 1), Loads(1, 1),
                             Loads(-1, 1), Loads(nan, 1), Loads(1, nan)}) {
    EXPECT_TRUE(has_text(refused(loose(), {.loads = loads}),
                         "must be above 0, the first one less"));
    EXPECT_TRUE(has_text(refused(ball, {.loads = loads}),
                         "must be above 0, the first one less"));
  }
  EXPECT_TRUE(has_text(refused(Joint(pin_spec(2e-5, FrictionLaw(0))), {}),
                       "a coefficient above 0"));
  EXPECT_TRUE(has_text(refused(Joint(pin_spec(2e-5, ViscousLaw(1e5, 0))), {}),
                       "Stribeck's law"));
  for (const FrictionModel& friction :
       {FrictionModel(FrictionLaw(0)), FrictionModel(FrictionLaw(1.1)),
        FrictionModel(FrictionLaw(0.1, 1e4)),
        FrictionModel(ViscousLaw(1e5, 0))}) {
    EXPECT_TRUE(has_text(refused(steel_ball(friction), {}),
                         "a clearance, and dry friction without adhesion"));
  }
  EXPECT_TRUE(has_text(error_message([&] { pin_load_law(ball, 1e-4); }),
                       "a pin with dry friction"));
}

// The load alone does not determine the friction of such a joint.
TEST(LoadLaw, RefusesJointsWithRimsAndEnds) {
  const JointSpec cup = {
      .geometry = JointGeometry::ball(0.01, 1e-5, JointBody::body)
                      .with_seat(SeatZone::cup(60 * degree)),
      .inner = Material{2.1e11, 0.3},
      .outer = Material{1e11, 0.34},
      .friction = FrictionLaw(0.1)};
  const auto refused = [](const JointSpec& spec) {
    return error_message([&] { load_law_text(Joint(spec), {.error = 1e-2}); });
  };
  EXPECT_TRUE(has_text(refused(cup), "without a [seat] and a [relief]"));
  EXPECT_EQ(refused(cup.without_seat()), "(no error)");
  JointSpec pin = pin_spec(2e-5, FrictionLaw(0.1));
  pin.relief = Relief::barrel(5e-6);
  EXPECT_TRUE(has_text(refused(pin), "without a [seat] and a [relief]"));
  EXPECT_TRUE(has_text(error_message([&] { pin_load_law(Joint(pin), 1e-4); }),
                       "without a [seat] and a [relief]"));
  EXPECT_EQ(refused(pin.without_relief()), "(no error)");
}

}  // namespace
}  // namespace contact::test::load_law_test
