#include "libcontact/pressure/cosine.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "libcontact/base/cancellation.hpp"
#include "libcontact/base/units.hpp"
#include "support/accuracy_report.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"

namespace contact::test::cosine_test {
namespace {

using Real = boost::multiprecision::cpp_bin_float_100;
// Evaluated literally, the formulas (3.2) to (3.4) lose five times the digits
// of theta0: 100 digits leave 50 down to 1e-10 rad, 800 down to 1e-150 rad.
using LongReal =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<800>>;
constexpr double smallest_for_real = 1e-10;

std::vector<double> half_angles() {
  std::vector<double> values;
  for (double angle = 1e-150; angle < 1e-4; angle *= 3e7) {
    values.push_back(angle);
  }
  for (double angle_deg = 0.01; angle_deg < 5; angle_deg *= 1.6) {
    values.push_back(angle_deg * degree);
  }
  for (double angle_deg = 5; angle_deg <= 170; angle_deg += 2.5) {
    values.push_back(angle_deg * degree);
  }
  // Both sides of the switches from series to closed form: x^2 = 4 at
  // x = 2 theta0 and x^2 = 2 at x = theta0.
  for (const double angle : {1.0, std::sqrt(2.0)}) {
    values.push_back(std::nextafter(angle, 0));
    values.push_back(angle);
    values.push_back(std::nextafter(angle, 2));
  }
  return values;
}

std::string label(JointKind kind, double half_angle, double theta = 0) {
  std::ostringstream text;
  text.precision(17);
  text << to_string(kind) << " theta0 = " << half_angle
       << " rad, theta = " << theta;
  return text.str();
}

// The reports of one run over all half-angles.
struct Reports {
  // Up to 12 roundings of 1.1e-16, among them sines of 1 ulp. Near the edge
  // pressure() multiplies six factors: measured 1.6e-15, the others 8e-16.
  AccuracyReport integral{"cosine_normal_integral", 1e-15};
  AccuracyReport peak{"peak", 1e-15};
  AccuracyReport mean{"mean", 1e-15};
  AccuracyReport force{"force_ratio", 1e-15};
  AccuracyReport pressure{"pressure", 2e-15};
  AccuracyReport slope{"slope", 1e-15};
};

// One half-angle against the formulas as the theory writes them.
template <class R>
void compare(Reports& reports, const CosinePressure& law, double half_angle) {
  const JointKind kind = law.joint_kind();
  const bool ball = kind == JointKind::ball;
  const R& pi_ = boost::math::constants::pi<R>();
  const R t0 = half_angle;
  const R c = cos(t0);
  const R normal =
      ball ? R(pi_ / 3 * (1 - c) * (1 - c) * (2 + c)) : R(t0 - sin(t0) * c);
  const R force = ball ? R(pi_ * (1 - c) * (1 - c) / normal)
                       : R(2 * (sin(t0) - t0 * c) / normal);
  const R area = ball ? R(2 * pi_ * (1 - c)) : R(2 * t0);
  const std::string row = label(kind, half_angle);
  if (half_angle > 1e-70) {  // else below the smallest normal number
    reports.integral.add(R(cosine_normal_integral(kind, half_angle)), normal,
                         row);
  }
  reports.peak.add(R(law.peak(half_angle)), R((1 - c) / normal), row);
  reports.mean.add(R(law.mean(half_angle)), R(force / area), row);
  reports.force.add(R(law.force_ratio(half_angle)), force, row);
  for (const double share : {0.0, 1e-9, 0.25, 0.9, 0.999999, 1 - 1e-15}) {
    const double theta = share * half_angle;
    const R t = theta;
    const std::string point = label(kind, half_angle, theta);
    reports.pressure.add(R(law.pressure(theta, half_angle)),
                         R((cos(t) - c) / normal), point);
    if (half_angle < 1e-100) continue;  // the slope overflows
    reports.slope.add(R(law.slope(theta, half_angle)), R(sin(t) / normal),
                      point);
  }
}

TEST(CosinePressure, AgreesWithTheFormulasInHighPrecision) {
  Reports reports;
  for (const JointKind kind : kinds) {
    const CosinePressure law(kind);
    for (const double half_angle : half_angles()) {
      if (half_angle < smallest_for_real) {
        compare<LongReal>(reports, law, half_angle);
      } else {
        compare<Real>(reports, law, half_angle);
      }
    }
  }
}

TEST(Cancellation, SeriesAndClosedFormsAgreeWithHighPrecision) {
  AccuracyReport sine("x_minus_sin_over_cube", 4e-16);
  AccuracyReport cosine("sin_minus_x_cos_over_cube", 4e-16);
  for (double x = 1e-100; x < 1e-6; x *= 1e11) {
    const LongReal y = x;
    sine.add(LongReal(detail::x_minus_sin_over_cube(x)),
             LongReal((y - sin(y)) / (y * y * y)), std::to_string(x));
    cosine.add(LongReal(detail::sin_minus_x_cos_over_cube(x)),
               LongReal((sin(y) - y * cos(y)) / (y * y * y)),
               std::to_string(x));
  }
  for (double x = 0.01; x <= 2 * pi; x += 0.0137) {
    const Real y = x;
    sine.add(Real(detail::x_minus_sin_over_cube(x)),
             Real((y - sin(y)) / (y * y * y)), std::to_string(x));
    if (x > pi) continue;
    cosine.add(Real(detail::sin_minus_x_cos_over_cube(x)),
               Real((sin(y) - y * cos(y)) / (y * y * y)), std::to_string(x));
  }
  EXPECT_EQ(detail::x_minus_sin_over_cube(0), 1.0 / 6);
  EXPECT_EQ(detail::sin_minus_x_cos_over_cube(0), 1.0 / 3);
  EXPECT_TRUE(all_nan({detail::x_minus_sin_over_cube(nan),
                       detail::sin_minus_x_cos_over_cube(nan)}));
}

TEST(CosinePressure, PeakIsNotTheAmplitude) {
  // theory: at 5 deg the two differ 260 times: 1/(1 - cos 5 deg) = 262.8.
  const double half_angle = 5 * degree;
  for (const JointKind kind : kinds) {
    const double amplitude = 1 / cosine_normal_integral(kind, half_angle);
    const double peak = CosinePressure(kind).peak(half_angle);
    EXPECT_NEAR(amplitude / peak, 262.8, 0.05);
  }
}

TEST(CosinePressure, OverstatesThePeak) {
  // docs/explanation/pressure.md: against exact peaks, by joint.
  const ReferenceTable table("conforming/pressure_friction.csv");
  double least[2] = {1, 1};
  double most[2] = {0, 0};
  for (const ReferenceTable::Row row : table) {
    const bool ball = row.text("joint") == "sphere";
    const CosinePressure law(ball ? JointKind::ball : JointKind::pin);
    const double half_angle = row.value("theta0_deg") * degree;
    const double excess = law.peak(half_angle) / row.value("pmax_exact") - 1;
    least[ball] = std::min(least[ball], excess);
    most[ball] = std::max(most[ball], excess);
  }
  EXPECT_NEAR(most[true], 0.33, 0.005);
  EXPECT_NEAR(least[true], 0.10, 0.005);
  EXPECT_NEAR(most[false], 0.18, 0.005);
  EXPECT_NEAR(least[false], 0.07, 0.005);
}

TEST(CosinePressure, SmallContacts) {
  // theta0 -> 0: I_n -> (pi/4) theta0^4 and (2/3) theta0^3, a paraboloid of
  // pressure with peak 2 (ball) and 1.5 (pin) times its mean.
  const double t = 1e-40;
  const CosinePressure ball(JointKind::ball);
  const CosinePressure pin(JointKind::pin);
  EXPECT_DOUBLE_EQ(ball.peak(t) * pi * t * t, 2);
  EXPECT_DOUBLE_EQ(pin.peak(t) * t, 0.75);
  EXPECT_DOUBLE_EQ(ball.peak(t) / ball.mean(t), 2);
  EXPECT_DOUBLE_EQ(pin.peak(t) / pin.mean(t), 1.5);
  EXPECT_DOUBLE_EQ(ball.pressure(t / 2, t) / ball.peak(t), 0.75);
  EXPECT_DOUBLE_EQ(cosine_normal_integral(JointKind::ball, t) / t / t / t / t,
                   pi / 4);
  EXPECT_DOUBLE_EQ(cosine_normal_integral(JointKind::pin, t) / t / t / t,
                   2.0 / 3);
  for (const CosinePressure& law : {ball, pin}) {
    for (const double bad :
         {nan, -1e-300, -1.0, 3.1415926535897936, infinity}) {
      EXPECT_TRUE(std::isnan(cosine_normal_integral(law.joint_kind(), bad)));
    }
    EXPECT_EQ(law.peak(0), infinity);
    EXPECT_EQ(law.mean(0), infinity);
    EXPECT_EQ(law.pressure(0, 0), infinity);
    EXPECT_EQ(law.pressure(1e-300, 0), 0);
    EXPECT_EQ(law.slope(0, 0), 0);
    EXPECT_DOUBLE_EQ(law.force_ratio(0), 1);
    EXPECT_EQ(cosine_normal_integral(law.joint_kind(), 0), 0);
  }
}

}  // namespace
}  // namespace contact::test::cosine_test
