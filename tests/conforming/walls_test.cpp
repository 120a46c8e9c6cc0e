#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

#include "libcontact/base/units.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/kernel/pin_wall_modes.hpp"
#include "libcontact/conforming/pin.hpp"
#include "support/accuracy_report.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"
#include "support/wall.hpp"

// Balls and pins with finite walls against independent solutions, and their
// limits.
namespace contact::test::walls_test {
namespace {

// Forces in N and N/m at a half-angle, by the units of both solvers.
struct Units {
  double load_per_parameter;  // R_n/mu, P/lambda
  double pressure;            // p over the solver's, per unit load
  double stiffness;           // as ContactApproach's
};

template <class Contact>
Units units(const LayeredPair& pair, double clearance);
template <>
Units units<BallContact>(const LayeredPair& pair, double clearance) {
  const double e = pair.surfaces().effective_modulus();
  const double rho = pair.radius();
  return {2.0 / 3 * clearance * rho * e, 1 / (rho * rho), rho * e};
}
template <>
Units units<PinContact>(const LayeredPair& pair, double clearance) {
  const double e = pair.surfaces().effective_modulus();
  return {pi / 2 * clearance * e, 1 / pair.radius(), e};
}

template <class Contact>
void compare(const std::string& file) {
  const ReferenceTable table(file);
  AccuracyReport load("load", 1e-6);  // asked for, all of them
  AccuracyReport inverse("theta0 at the load", 1e-6);
  AccuracyReport centre("p_centre", 1e-5);
  AccuracyReport peak("p_max", 1e-5);
  AccuracyReport angle("angle of p_max, over theta0", 1e-3);
  AccuracyReport approach("approach", 1e-6);
  AccuracyReport stiffness("stiffness", 1e-6);
  AccuracyReport sum("S", 1e-6);
  for (const ReferenceTable::Row row : table) {
    const std::string label = row.label();
    const LayeredPair pair = reference_pair(row);
    const double clearance = row.value("clearance");
    const double theta0 = row.value("theta0_deg") * degree;
    const Contact contact(pair);
    const Units unit = units<Contact>(pair, clearance);
    const double force = row.value("load");

    const ExactLoad found = contact.load_parameter(theta0);
    EXPECT_EQ(found.status, Status::ok) << label;
    load.add(found.load_parameter * unit.load_per_parameter, force, label);
    const ExactHalfAngle back =
        contact.half_angle(force / unit.load_per_parameter);
    EXPECT_EQ(back.status, Status::ok) << label;
    inverse.add(back.half_angle, theta0, label);

    const ContactPressure p = contact.pressure(theta0);
    const double pressure = force * unit.pressure;
    centre.add(p.pressure(0) * pressure, row.value("p_centre"), label);
    peak.add(p.peak() * pressure, row.value("p_max"), label);
    angle.add_error(
        std::abs(p.peak_angle() / degree - row.value("theta_pmax_deg")) /
            row.value("theta0_deg"),
        label);
    sum.add(p.force_ratio(), row.value("S"), label);

    const ContactApproach a = contact.approach(theta0);
    if (row.text("approach").empty()) {
      EXPECT_TRUE(all_nan({a.approach, a.stiffness})) << label;
      continue;
    }
    approach.add(a.approach * clearance, row.value("approach"), label);
    stiffness.add(a.stiffness * unit.stiffness, row.value("stiffness"), label);
  }
}

TEST(WalledBall, MatchesTheReference) {
  compare<BallContact>("walls/walls_ball.csv");
}

TEST(WalledPin, MatchesTheReference) {
  compare<PinContact>("walls/walls_pin.csv");
}

// A wall of one layer under a rigid ball or pin, radius 1.
LayeredPair single(double thickness, double nu, const Backing& backing,
                   Backing inner = Backing::rigid()) {
  return {1, {{}, std::move(inner)}, {{{thickness, {1, nu}}}, backing}};
}

// Ratio of 1/load parameter of two contacts with walls, less 1.
template <class A, class B>
double change(const A& a, const B& b, double theta0) {
  return b.reciprocal_load(theta0) / a.reciprocal_load(theta0) - 1;
}

template <class Contact>
class Walled : public testing::Test {};
using Both = testing::Types<BallContact, PinContact>;
TYPED_TEST_SUITE(Walled, Both);

TYPED_TEST(Walled, OneMaterialIsTheInfiniteBody) {
  const Material a{1, 0.2};
  const Material b{2, 0.45};
  const LayeredPair pair(1, {{{0.05, a}, {0.1, a}}, Backing::medium(a)},
                         {{{0.03, b}, {0.2, b}}, Backing::medium(b)});
  const TypeParam walled(pair, InnerLoading::centre(), 24);
  const TypeParam plain(ElasticPair(a, b), InnerLoading::centre(), 24);
  for (const double theta0 : {0.01, 0.3, 1.0, 1.4}) {
    EXPECT_NEAR(change(walled, plain, theta0), 0, 1e-11) << theta0;
    const ContactPressure p = walled.pressure(theta0);
    const ContactPressure q = plain.pressure(theta0);
    for (const double share : {0.0, 0.5, 0.9}) {
      EXPECT_NEAR(p.pressure(share * theta0) / q.pressure(share * theta0), 1,
                  1e-7)
          << theta0;
    }
  }
}

TYPED_TEST(Walled, AThickWallIsInfinite) {
  // A ball's load differs by (rho/r_out)^3, a pin's by (rho/r_out)^2.
  const bool ball = std::is_same_v<TypeParam, BallContact>;
  const double thickness = ball ? 1e3 : 1e5;
  const Material inner{2, 0.3};
  for (const bool held : {false, true}) {
    const LayeredPair pair =
        single(thickness, 0.3, held ? Backing::held() : Backing::rigid(),
               Backing::medium(inner));
    const TypeParam plain(ElasticPair(inner, {1, 0.3}));
    for (const double theta0 : {0.1, 0.5, 1.0}) {
      // 1.6 (rho/r_out)^3 for a wide contact in a held wall.
      EXPECT_NEAR(change(TypeParam(pair), plain, theta0), 0,
                  ball && theta0 == 1.0 ? 2e-9 : 1e-9)
          << theta0 << " " << held;
    }
  }
}

TYPED_TEST(Walled, SmallContactsAreHertzian) {
  // Contacts smaller than the wall's thickness, by the surface materials.
  const LayeredPair pair(1, {{{0.05, {1, 0.3}}}, Backing::medium({200, 0.3})},
                         {{{0.1, {2, 0.2}}}, Backing::medium({500, 0.3})});
  const TypeParam walled(pair);
  const TypeParam plain(pair.surfaces());
  for (const double theta0 : {1e-3, 1e-2}) {
    // (theta0 rho/t)^3 and ^2 of order 1.
    EXPECT_NEAR(change(walled, plain, theta0), 0, 2 * theta0 * theta0 / 2.5e-3)
        << theta0;
    EXPECT_GT(std::abs(change(walled, plain, theta0)), 1e-9);
  }
}

TYPED_TEST(Walled, ThinCompressibleLinersAreWinkler) {
  // R over the load of independent columns, less 1, at 60 deg: known values for
  // nu = 0.3, of first order in t.
  const bool ball = std::is_same_v<TypeParam, BallContact>;
  const double nu = 0.3;
  const double theta0 = 60 * degree;
  const double c = std::cos(theta0);
  const double expected[] = {0.0897, 0.0236, 0.00753, 0.00222, 7.4e-4};
  // The last two for pins alone.
  const double thickness[] = {0.1, 0.03, 0.01, 0.003, 0.001, 2e-4, 5e-5};
  for (int i = 0; i < (ball ? 5 : 7); ++i) {
    const double t = thickness[i];
    const LayeredPair pair = single(t, nu, Backing::rigid());
    const double k = t * (1 + nu) * (1 - 2 * nu) / (1 - nu);
    const double winkler =
        ball ? 2 * pi / k * ((1 - c * c * c) / (3 * c) - (1 - c * c) / 2)
             : (theta0 / c - std::sin(theta0)) / k;
    const Units unit = units<TypeParam>(pair, 1);
    const TypeParam contact(pair);
    const double load =
        unit.load_per_parameter / contact.reciprocal_load(theta0);
    const double error = load / winkler - 1;
    EXPECT_GT(error, 0.4 * t);
    EXPECT_LT(error, 1.0 * t);
    if (ball) {
      EXPECT_NEAR(error, expected[i], 0.01 * expected[i]) << t;
    }
    // dR/ddelta = 2 pi rho^2 (1 - c^3)/(3 k); delta = eps (1/c - 1)
    const ContactApproach a = contact.approach(theta0);
    EXPECT_NEAR(a.approach, 1 / c - 1, 1.5 * t);
    const double stiffness = ball ? 2 * pi * (1 - c * c * c) / (3 * k)
                                  : (theta0 + std::sin(theta0) * c) / k;
    EXPECT_NEAR(a.stiffness * unit.stiffness / stiffness, 1, 4 * t);
    // p = E eps (cos x/c - 1)/k
    const ContactPressure p = contact.pressure(theta0);
    for (const double x : {0.0, 0.3, 0.6}) {
      EXPECT_NEAR(p.pressure(x) * load * unit.pressure * k, std::cos(x) / c - 1,
                  3 * t)
          << t << " " << x;
    }
  }
}

// Load of a liner that is squeezed sideways, u = -(t^3/(3 G)) Lap p, G = 1/3.
template <class Contact>
double squeezed_load(double t, double theta0) {
  const double kap = t * t * t;
  const double c = std::cos(theta0);
  const double half = theta0 / 2;
  // By Simpson's rule of the polynomial-like pressures.
  const auto load_density = [&](double x) {
    if (std::is_same_v<Contact, BallContact>) {
      const double d = 1 / (std::cos(half) * std::cos(half));
      const double p = d * (std::cos(x) - c) / 2 -
                       2 * std::log(std::cos(x / 2) / std::cos(half));
      return 2 * pi * p * std::cos(x) * std::sin(x) / kap;
    }
    const double p = theta0 * (std::cos(x) - c) / std::sin(theta0) -
                     (theta0 * theta0 - x * x) / 2;
    return 2 * p * std::cos(x) / kap;
  };
  constexpr int steps = 400;
  double limit = 0;
  for (int k = 0; k <= steps; ++k) {
    const int weight = k == 0 || k == steps ? 1 : (k % 2 == 1 ? 4 : 2);
    limit += weight * load_density(theta0 * k / steps) * theta0 / (3 * steps);
  }
  return limit;
}

TYPED_TEST(Walled, ThinIncompressibleLinersSqueezeSideways) {
  // u = -(t^3/(3 G)) Lap p: R over that, less 1, at 60 deg.
  const bool ball = std::is_same_v<TypeParam, BallContact>;
  const double theta0 = 60 * degree;
  const double expected_ball[] = {1.44, 0.335, 0.103, 0.0301};
  const double expected_pin[] = {1.18, 0.284, 0.0887, 0.0260};
  const double thickness[] = {0.1, 0.03, 0.01, 0.003, 0.001};
  double before = 0;
  for (int i = 0; i < 5; ++i) {
    const double t = thickness[i];
    const LayeredPair pair = single(t, 0.5, Backing::rigid());
    const double limit = squeezed_load<TypeParam>(t, theta0);
    const double load = units<TypeParam>(pair, 1).load_per_parameter /
                        TypeParam(pair).reciprocal_load(theta0);
    const double error = load / limit - 1;
    if (i < 4) {
      const double expected = ball ? expected_ball[i] : expected_pin[i];
      EXPECT_NEAR(error, expected, 0.01 * expected) << t;
    }
    // First order in t.
    if (i > 2) {
      EXPECT_NEAR(error / t, before, 0.04 * before) << t;
    }
    before = error / t;
  }
}

// The least thickness in the message for a rejected pair; 0 if it is accepted.
template <class Contact>
double least_thickness(const LayeredPair& pair) {
  const std::string text = error_message([&] { Contact{pair}; });
  const std::string before = "at least ";
  const std::size_t at = text.find(before);
  return at == std::string::npos ? 0
                                 : std::stod(text.substr(at + before.size()));
}

// Between rigid bodies, layers that yield neither by compression nor by
// squeezing leave no significant digits: peaks were 27 to 1e5 times too large.
TEST(Walled, ThinLayersThatHardlyYieldAreRefused) {
  EXPECT_ERROR(
      BallContact(single(1e-4, 0.5, Backing::rigid())),
      "wall layer 1: thickness = 0.0001 must be at least 0.000996 m: "
      "with Poisson's ratio 0.5 and between bodies this stiff a thinner "
      "one hardly yields, and its pressure cannot be computed");
  for (const auto& [thickness, nu] :
       {std::pair(1e-5, 0.499), {1e-5, 0.4999}, {1e-5, 0.49}, {3e-4, 0.5}}) {
    EXPECT_GT(
        least_thickness<BallContact>(single(thickness, nu, Backing::rigid())),
        thickness);
  }
  EXPECT_GT(least_thickness<PinContact>(single(1e-4, 0.5, Backing::rigid())),
            1e-4);
  const LayeredPair coated(1, {{{1e-4, {1, 0.5}}}, Backing::rigid()},
                           {{}, Backing::rigid()});
  EXPECT_TRUE(error_message([&] {
                BallContact{coated};
              }).starts_with("coating 1: thickness = 0.0001 must be"));
  // An elastic ball yields, and so does a backing.
  for (const auto& [inner, backing] :
       {std::pair(Backing::medium({50, 0.3}), Backing::rigid()),
        {Backing::rigid(), Backing::medium({50, 0.3})}}) {
    EXPECT_EQ(least_thickness<BallContact>(single(1e-3, 0.5, backing, inner)),
              0);
    EXPECT_EQ(least_thickness<BallContact>(single(1e-4, 0.5, backing, inner)),
              0);
  }
}

// Incompressible ones as thin as they may be: the error of the limit is of
// first order in t, a quarter of that at four times the thickness. Measured:
// 6e-4 (ball).
TYPED_TEST(Walled, TheThinnestIncompressibleLinersAreRight) {
  const double t =
      least_thickness<TypeParam>(single(1e-5, 0.5, Backing::rigid()));
  ASSERT_GT(t, 1e-4);
  const TypeParam thin(single(t, 0.5, Backing::rigid()));
  const TypeParam thick(single(4 * t, 0.5, Backing::rigid()));
  const double unit =
      units<TypeParam>(single(t, 0.5, Backing::rigid()), 1).load_per_parameter;
  for (const double theta0_deg : {60.0, 75.0, 85.0}) {
    const double theta0 = theta0_deg * degree;
    const auto error = [&](const TypeParam& contact, double thickness) {
      return unit / contact.reciprocal_load(theta0) /
                 squeezed_load<TypeParam>(thickness, theta0) -
             1;
    };
    EXPECT_NEAR(error(thin, t), error(thick, 4 * t) / 4, 2e-3) << theta0_deg;
  }
}

TYPED_TEST(Walled, LimitHalfAngles) {
  // Rigid inner body; the third decimal comes from the independent solution.
  struct Case {
    double thickness;
    double nu;
    bool held;
    double ball;
    double pin;
  };
  const Case cases[] = {{0.01, 0.3, false, 89.929, 89.929},
                        {0.01, 0.499, false, 96.417, 96.463},
                        {0.03, 0.45, false, 90.864, 90.885},
                        {0.1, 0.3, false, 89.225, 89.238},
                        {0.1, 0.499, false, 127.117, 132.542},
                        {0.3, 0.3, true, 91.019, 100.372},
                        {1, 0.45, false, 87.441, 90.091},
                        {1, 0.3, true, 85.995, 87.908},
                        {3, 0.499, false, 106.004, 126.295},
                        {3, 0.3, true, 83.923, 82.425}};
  const bool ball = std::is_same_v<TypeParam, BallContact>;
  for (const Case& c : cases) {
    const LayeredPair pair =
        single(c.thickness, c.nu, c.held ? Backing::held() : Backing::rigid());
    const ExactHalfAngle limit = TypeParam(pair).limit_half_angle();
    EXPECT_EQ(limit.status, Status::ok);
    EXPECT_NEAR(limit.half_angle / degree, ball ? c.ball : c.pin, 6e-4)
        << c.thickness << " " << c.nu << " " << c.held;
  }
}

TEST(HarmonicSamples, GiveTheSum) {
  // Sum of exp(-2 n t) n cos^2(n theta), theta <= theta0: the fastest terms.
  constexpr int end = 6000;
  constexpr double t = 0.003;
  for (const double theta0 : {1e-4, 0.01, 0.1, 0.5, 0.8, 1.2, 1.3, 2.5}) {
    const detail::HarmonicSamples samples(theta0, end);
    if (theta0 < 1.25) {
      EXPECT_LT(samples.n.size(), 0.6 * end) << theta0;
    }
    for (const double share : {0.0, 0.5, 1.0}) {
      const auto term = [&](double n) {
        const double cosine = std::cos(n * share * theta0);
        return std::exp(-2 * n * t) * n * cosine * cosine;
      };
      double all = 0;
      for (int n = 2; n < end; ++n) all += term(n);
      double sampled = 0;
      for (std::size_t i = 0; i < samples.n.size(); ++i) {
        sampled += samples.weight[i] * term(samples.n[i]);
      }
      EXPECT_NEAR(sampled / all, 1, 1e-12) << theta0 << " " << share;
    }
  }
}

TEST(WalledPin, EndsWithoutALimit) {
  // The limit of this one is 145.807 deg; 8 unknowns end at 117 deg.
  const LayeredPair pair = single(0.3, 0.499, Backing::rigid());
  EXPECT_NEAR(PinContact(pair).limit_half_angle().half_angle / degree, 145.807,
              1e-3);
  const PinContact pin(pair, InnerLoading::centre(), 8);
  const ExactHalfAngle limit = pin.limit_half_angle();
  EXPECT_EQ(limit.status, Status::not_converged);
  EXPECT_EQ(limit.half_angle, pin.largest());
}

// d(D/R)/dtheta0 = -(eps/R^2) d(S R)/dtheta0, D = eps + delta; and
// dR/ddelta. Sixth-order differences.
template <class Contact>
void check_energy(const Contact& contact, double theta0, double tolerance) {
  const double h = 2e-3 * theta0;
  const auto derivative = [&](auto function) {
    const auto pair = [&](int k) {
      return function(theta0 + k * h) - function(theta0 - k * h);
    };
    return (45 * pair(1) - 9 * pair(2) + pair(3)) / (60 * h);
  };
  // Loads in units of the load parameter, eps = 1.
  const auto load = [&](double t) { return 1 / contact.reciprocal_load(t); };
  const auto distance = [&](double t) {
    return 1 + contact.approach(t).approach;
  };
  const auto ratio = [&](double t) {
    return contact.pressure(t).force_ratio();
  };
  const double r = load(theta0);
  const double left =
      derivative([&](double t) { return distance(t) / load(t); });
  const double right =
      -derivative([&](double t) { return ratio(t) * load(t); }) / (r * r);
  EXPECT_NEAR(left / right, 1, tolerance) << theta0;
  const double slope = derivative(load) / derivative(distance);
  const double unit = std::is_same_v<Contact, BallContact> ? 2.0 / 3 : pi / 2;
  EXPECT_NEAR(contact.approach(theta0).stiffness / (unit * slope), 1, tolerance)
      << theta0;
}

TYPED_TEST(Walled, EnergyAndStiffness) {
  const LayeredPair thick(
      1, {{{0.1, {3, 0.45}}}, Backing::medium({1, 0.2})},
      {{{0.2, {1, 0.4}}, {0.15, {5, 0.3}}}, Backing::held()});
  for (const double theta0 : {0.1, 0.6, 1.2}) {
    check_energy(TypeParam(thick, InnerLoading::centre(), 32), theta0, 1e-7);
    check_energy(TypeParam(single(0.03, 0.499, Backing::rigid()),
                           InnerLoading::centre(), 32),
                 theta0, 1e-6);
  }
}

// Harmonics of thin liners are summed on strides that grow with n. At 1.9 rad
// 64 unknowns leave 3e-6.
TEST(WalledPin, EnergyAndStiffnessOfThinLiners) {
  for (const double theta0 : {0.1, 0.6, 1.2, 1.9}) {
    check_energy(PinContact(single(1e-3, 0.4, Backing::rigid())), theta0, 1e-5);
  }
}

TEST(BallContact, EnergyAndStiffnessOfAnInfiniteSeat) {
  for (const double ratio : {0.0, 0.5, infinity}) {
    const BallContact ball(ElasticPair::from_modulus_ratio(ratio, 0.2, 0.4),
                           InnerLoading::centre(), 32);
    for (const double theta0 : {0.1, 0.6, 1.2}) {
      check_energy(ball, theta0, 1e-7);
    }
    // Hertz: R = (4/3) E* sqrt(rho) delta^(3/2) of the radius of curvature
    // rho^2/eps, delta = eps theta0^2, dR/ddelta = 2 E* rho theta0 = rho E
    // theta0.
    const ContactApproach a = ball.approach(1e-4);
    EXPECT_NEAR(a.approach / 1e-8, 1, 1e-3);
    EXPECT_NEAR(a.stiffness / 1e-4, 1, 1e-3);
  }
}

TYPED_TEST(Walled, ThinFreeWallsHaveTheirPeakOffTheCentre) {
  const TypeParam contact(single(0.1, 0.3, Backing::held()));
  const double theta0 = 25 * degree;
  const ContactPressure p = contact.pressure(theta0);
  EXPECT_GT(p.peak_angle(), 0.2 * theta0);
  EXPECT_LT(p.peak_angle(), 0.95 * theta0);
  EXPECT_GT(p.peak(), 1.001 * p.pressure(0));
  for (int i = 0; i <= 200; ++i) {
    EXPECT_LE(p.pressure(theta0 * i / 200), p.peak() * (1 + 1e-12));
  }
  // In a rigid shell the peak is at the centre.
  const TypeParam backed(single(0.1, 0.3, Backing::rigid()));
  EXPECT_EQ(backed.pressure(theta0).peak_angle(), 0);
}

// The strip beside the edge of a thin ring narrows, and its peak lies between
// the points of the scan: no point of the profile exceeds peak().
TEST(WalledPin, TheStripOfAThinRingIsFound) {
  const PinContact contact(single(0.005, 0.3, Backing::held()));
  double before = 0;
  for (double angle = 140; angle < 152; angle += 0.25) {
    const double theta0 = angle * degree;
    const ContactPressure p = contact.pressure(theta0);
    double largest = 0;
    for (int i = 0; i <= 2000; ++i) {
      const double square = std::pow(i / 2000.0, 2);
      largest = std::max(largest, p.pressure(theta0 * (1 - square)));
    }
    EXPECT_LE(largest, p.peak() * (1 + 1e-9)) << angle;
    EXPECT_LE(p.peak(), largest * 1.001) << angle;
    if (before > 0) {
      EXPECT_NEAR(p.peak() / before, 1, 0.25) << angle;
    }
    before = p.peak();
  }
}

// A plate on a soft bed bends as a ring does.
TYPED_TEST(Walled, StiffWallsOnASoftMediumHaveTheirPeakOffTheCentre) {
  const TypeParam contact(single(0.13, 0.3, Backing::medium({0.09, 0.3})));
  const double theta0 = 17.5 * degree;
  const ContactPressure p = contact.pressure(theta0);
  // 12.0 deg and 1.12 (ball), 12.8 deg and 1.16 (pin).
  EXPECT_NEAR(p.peak_angle() / degree, 12.4, 0.6);
  EXPECT_NEAR(p.peak() / p.pressure(0), 1.14, 0.03);
  EXPECT_FALSE(p.falls_outwards());
}

TYPED_TEST(Walled, ThereAndBackAgain) {
  // Liners stiff against their surface, rings soft against it; loads from 0.01
  // deg to near the limit.
  for (const double thickness : {0.01, 0.03, 1.0}) {
    for (const double nu : {0.3, 0.5}) {
      for (const bool held : {false, true}) {
        const TypeParam contact(
            single(thickness, nu, held ? Backing::held() : Backing::rigid()));
        for (const double theta0 : {1e-2 * degree, 0.1, 1.0}) {
          const ExactLoad load = contact.load_parameter(theta0);
          ASSERT_EQ(load.status, Status::ok) << thickness << " " << nu;
          const ExactHalfAngle back = contact.half_angle(load.load_parameter);
          EXPECT_EQ(back.status, Status::ok) << thickness << " " << nu;
          // An incompressible liner is stiff by a difference that costs
          // digits.
          EXPECT_NEAR(back.half_angle, theta0, 1e-9 * theta0)
              << thickness << " " << nu << " " << held;
        }
      }
    }
  }
}

TYPED_TEST(Walled, LoadThroughTheBack) {
  const InnerLoading back = InnerLoading::back(0.3);
  const LayeredPair liner(1, {{}, Backing::medium({5, 0.3})},
                          {{{0.1, {1, 0.4}}}, Backing::rigid()});
  const TypeParam contact(liner, back);
  // The inner body is flattened: a wider contact.
  EXPECT_GT(contact.half_angle(1).half_angle,
            TypeParam(liner).half_angle(1).half_angle);
  EXPECT_TRUE(all_nan(
      {contact.approach(0.5).approach, contact.approach(0.5).stiffness}));
  const LayeredPair coated(1, {{{0.1, {1, 0.4}}}, Backing::medium({5, 0.3})},
                           {{}, Backing::medium({5, 0.3})});
  EXPECT_ERROR(TypeParam(coated, back),
               "loading = back requires an inner body without coatings");
}

TYPED_TEST(Walled, BadArguments) {
  const LayeredPair pair = single(0.1, 0.3, Backing::rigid());
  EXPECT_THROW(TypeParam(pair, InnerLoading::centre(), 7), Error);
  EXPECT_THROW(TypeParam(pair, InnerLoading::centre(), 65), Error);
  const TypeParam contact(pair);
  for (const double bad : {std::nan(""), -1.0, 0.0, 3.2}) {
    EXPECT_TRUE(all_nan(
        {contact.reciprocal_load(bad), contact.approach(bad).approach,
         contact.approach(bad).stiffness, contact.pressure(bad).peak()}));
  }
}

}  // namespace
}  // namespace contact::test::walls_test
