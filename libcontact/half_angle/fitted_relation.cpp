#include "libcontact/half_angle/fitted_relation.hpp"

#include <cmath>

#include "libcontact/base/constants.hpp"
#include "libcontact/conforming/kernel/ball_kernel.hpp"
#include "libcontact/half_angle/coefficients.hpp"

namespace contact::detail {
namespace {

// c_n of a ball in a seat.
double compliance(const ElasticPair& pair, int n) {
  return pair.inner_compliance_share() *
             ball_compliance(n, pair.inner().poissons_ratio) +
         pair.outer_compliance_share() *
             cavity_compliance(n, pair.outer().poissons_ratio);
}

// d_n = (n + 1/2) c_n - 1.
double harmonic_excess(const ElasticPair& pair, int n) {
  return (n + 0.5) * compliance(pair, n) - 1;
}

// (1 - 2 nu)^2/(2 (1 - nu)): what n d_n of one body tends to.
double tail(double nu) { return (1 - 2 * nu) * (1 - 2 * nu) / (2 * (1 - nu)); }

// Persson's closed form: c^2 - w_2 (2 s^2 - c^2 ln c), s = sin^2(theta0/2),
// c = cos^2(theta0/2).
RelationValue pin_closed_form(double outer_share, double sine, double cosine) {
  const double s = sine * sine;
  const double c = cosine * cosine;
  const double c_log = c > 0 ? c * std::log(c) : 0;
  return {c * c - outer_share * (2 * s * s - c * c_log),
          -sine * cosine * (2 * c + outer_share * (4 * s + 2 * c_log + c))};
}

// theta - sin theta cos theta and sin theta - theta cos theta.
struct CapTerms {
  double disc, moment;
};

// Coefficients of theta^3, theta^5, ... in their power series,
// (-1)^k 4^(k+1)/(2k+3)! and (-1)^k 2 (k+1)/(2k+3)!. What is left out is below
// 1e-16 of it at theta = 0.5.
constexpr int series_terms = 8;
constexpr std::array<CapTerms, series_terms> cap_series = [] {
  std::array<CapTerms, series_terms> series{};
  double over_factorial = 1;
  double power = -1;  // (-1)^(k+1) 4^k
  for (int k = 0; k < series_terms; ++k) {
    over_factorial /= (2.0 * k + 2) * (2 * k + 3);
    power *= -4;
    const double sign = k % 2 == 0 ? 1 : -1;
    series[k] = {power * over_factorial, sign * 2 * (k + 1) * over_factorial};
  }
  return series;
}();

// Over theta^3.
CapTerms short_cap_terms(double theta) {
  const double t2 = theta * theta;
  CapTerms sum{0, 0};
  for (int k = series_terms - 1; k >= 0; --k) {
    sum.disc = sum.disc * t2 + cap_series[k].disc;
    sum.moment = sum.moment * t2 + cap_series[k].moment;
  }
  return sum;
}

// The solution for d_n = 0, n >= 2: with h = D cos(3f/2) - e cos(f/2) every
// H_n is elementary (docs/explanation/half_angle.md). Short contacts are
// measured in units of theta0, so that nothing underflows or cancels; beyond
// 0.5 rad the differences lose one digit at most.
RelationValue ball_closed_form(double d0, double theta, double sine,
                               double cosine) {
  const bool is_short = theta <= 0.5;
  const double unit = is_short ? theta : 1;
  const double inverse = is_short ? 1 / theta : 1;
  const double sin_theta = 2 * sine * cosine;
  const double versine = 2 * sine * sine;  // 1 - cos theta
  const double cos_theta = 1 - versine;
  const CapTerms terms = is_short ? short_cap_terms(theta)
                                  : CapTerms{theta - sin_theta * cos_theta,
                                             sin_theta - theta * cos_theta};
  const double half_ratio = sine * inverse;
  const double ratio = sin_theta * inverse;
  const double h1 = terms.disc / 2 + ratio * ratio * ratio / 3;
  const double h0 = unit * unit * unit * (terms.disc / 2 + terms.moment);
  const double over_h1 = 1 / h1;
  const double square = 16.0 / 3 * half_ratio * half_ratio * over_h1;
  const double scale = square * half_ratio;
  const double approach = 1 - 2 * versine - 2 / pi * d0 * h0;
  const double approach_slope =
      -2 * sin_theta - 2 / pi * d0 * sin_theta * (sin_theta + theta);
  // dH_1/dtheta0 = sin^2 theta0 (1 + cos theta0)
  const double scale_slope =
      square * inverse *
      (1.5 * cosine - half_ratio * ratio * ratio * (1 + cos_theta) * over_h1);
  return {scale * approach, approach * scale_slope + scale * approach_slope};
}

}  // namespace

double fitted_constant(JointKind kind, const ElasticPair& pair) {
  return kind == JointKind::pin ? pair.outer_compliance_share()
                                : harmonic_excess(pair, 0);
}

std::vector<double> fitted_features(JointKind kind, const ElasticPair& pair) {
  if (kind == JointKind::pin) {
    const double beta = pair.dundurs_beta();
    return {beta, pair.outer_compliance_share() * beta};
  }
  const double d2 = harmonic_excess(pair, 2);
  return {d2, harmonic_excess(pair, 3),
          pair.inner_compliance_share() * tail(pair.inner().poissons_ratio) -
              pair.outer_compliance_share() * tail(pair.outer().poissons_ratio),
          compliance(pair, 0) * d2};
}

RelationValue fitted_closed_form(JointKind kind, double constant,
                                 double half_angle, double sine,
                                 double cosine) {
  return kind == JointKind::pin
             ? pin_closed_form(constant, sine, cosine)
             : ball_closed_form(constant, half_angle, sine, cosine);
}

FittedRelation::FittedRelation(JointKind kind, const ElasticPair& pair)
    : kind_(kind), constant_(fitted_constant(kind, pair)) {
  const std::vector<double> features = fitted_features(kind, pair);
  for (std::size_t i = 0; i < features.size(); ++i) {
    const double* row = kind == JointKind::pin ? fitted_pin[i] : fitted_ball[i];
    for (int k = 0; k < fitted_terms; ++k) {
      coefficients_[k] += features[i] * row[k];
    }
  }
}

template <JointKind kind>
inline RelationValue FittedRelation::at(double half_angle, double sine,
                                        double cosine) const {
  const RelationValue closed =
      fitted_closed_form(kind, constant_, half_angle, sine, cosine);
  double sum = 0;
  double slope = 0;  // d(sum)/dr, dr/dtheta0 = cosine/2
  for (int k = fitted_terms - 1; k >= 0; --k) {
    slope = slope * sine + sum;
    sum = sum * sine + coefficients_[k];
  }
  slope = slope * sine + sum;
  sum *= sine;
  const double weight = fitted_weight(kind, cosine);
  double total = weight * slope * cosine / 2;
  if (kind == JointKind::ball) {
    total -= 2 * sum * sine * cosine * cosine * cosine;
  }
  return {closed.value + weight * sum, closed.slope + total};
}

RelationValue FittedRelation::operator()(double half_angle, double sine,
                                         double cosine) const {
  return kind_ == JointKind::ball
             ? at<JointKind::ball>(half_angle, sine, cosine)
             : at<JointKind::pin>(half_angle, sine, cosine);
}

HalfAngleResult FittedRelation::solve(const HalfAngleStart& start, double limit,
                                      double load_parameter) const {
  // One loop for each kind, with everything inside it.
  const auto with = [&]<JointKind kind>() {
    return solve_half_angle(
        kind,
        [this](double theta, double sine, double cosine) {
          return at<kind>(theta, sine, cosine);
        },
        start, limit, load_parameter);
  };
  return kind_ == JointKind::ball ? with.operator()<JointKind::ball>()
                                  : with.operator()<JointKind::pin>();
}

}  // namespace contact::detail
