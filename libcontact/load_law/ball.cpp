#include "libcontact/load_law/ball.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/load_law/minimax.hpp"

namespace contact::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// 54, 116, 202 and 460 numbers: errors of some 1e-2, 5e-4, 1e-4, 1e-6.
constexpr BallCounts presets[] = {{10, 4, 4, 0, 3, 2, 5, 1e-3},
                                  {14, 5, 7, 0, 4, 4, 7, 2e-5},
                                  {16, 6, 9, 1, 5, 6, 9, 3e-6},
                                  {20, 8, 14, 2, 8, 10, 11, 3e-8}};

double coefficient_of(const Joint& ball) {
  return std::get<FrictionLaw>(ball.contact().friction()).coefficient();
}

void check(const Joint& ball) {
  const JointContact& contact = ball.contact();
  const auto* dry = std::get_if<FrictionLaw>(&contact.friction());
  if (dry == nullptr || !(dry->coefficient() > 0 && dry->coefficient() <= 1) ||
      dry->adhesion() > 0 || contact.geometry().radial_clearance() <= 0) {
    throw Error(needs("the load law of a ball",
                      "a clearance, and dry friction without adhesion with a "
                      "coefficient above 0, up to 1"));
  }
}

// Points of (0, 1), denser at both ends.
ArrayXd nodes(int count) {
  return 0.5 - 0.5 * ((ArrayXd::LinSpaced(count, 0, count - 1) + 0.5) *
                      (std::numbers::pi / count))
                         .cos();
}

// Columns 1, x, x^2, ... and x^(7/2), x^(9/2), ...; their derivatives.
std::pair<MatrixXd, MatrixXd> powers(const ArrayXd& x, int n, int odd) {
  MatrixXd value(x.size(), n + odd);
  MatrixXd slope(x.size(), n + odd);
  for (int i = 0; i < n + odd; ++i) {
    const double power = i < n ? i : 3.5 + i - n;
    value.col(i) = x.pow(power);
    slope.col(i) = power * x.pow(power == 0 ? 0 : power - 1);
  }
  return {value, slope};
}

// All products of a column of `a` and one of `b`, those of b together.
MatrixXd products(const MatrixXd& a, const MatrixXd& b) {
  MatrixXd all(a.rows(), a.cols() * b.cols());
  for (Eigen::Index i = 0; i < a.cols(); ++i) {
    all.middleCols(i * b.cols(), b.cols()) =
        b.array().colwise() * a.col(i).array();
  }
  return all;
}

// Contacts on one side of the rim, and their friction.
struct Samples {
  bool outside = false;
  ArrayXd t = {}, T = {}, x = {}, s = {}, drop = {}, q = {}, sa = {};
  ArrayXd sliding = {}, spinning = {}, ratio = {};
};

constexpr int loads = 30;
constexpr int axes = 40;

Samples sampled(const JointContact& contact, const BallLaw<double>& law,
                const ArrayXd& t, const ArrayXd& half_angle, bool outside) {
  Samples all{.outside = outside};
  const ArrayXd T = (half_angle / 2).tan();
  all.t = t.transpose().replicate(axes, 1).reshaped();
  all.T = T.transpose().replicate(axes, 1).reshaped();
  all.x = nodes(axes).square().replicate(loads, 1);
  all.s = 2 * all.T / (1 + all.T.square());
  all.drop = all.s * all.T;
  const ArrayXd c2 = (1 - all.drop).square();
  if (outside) {
    all.q = all.s / (1 - all.x * c2).sqrt();
    all.sa = (c2 * (1 - all.x) / (1 - all.x * c2)).sqrt();
  } else {
    const ArrayXd z = all.drop * (1 - all.x);
    all.q = (z * (2 - z)).sqrt();
    all.sa = 1 - z;
  }
  all.sliding = all.spinning = all.ratio = all.x;
  for (Eigen::Index i = 0; i < all.x.size(); ++i) {
    const double normal_force = std::exp(law.middle + law.half * all.t[i]);
    const FrictionTriple f =
        contact
            .integrals(half_angle[i / axes], {all.sa[i], all.q[i]},
                       {normal_force, 1})
            .coefficient;
    all.sliding[i] = f.sliding;
    all.spinning[i] = f.spinning;
    all.ratio[i] = f.force / f.sliding;
  }
  return all;
}

// Both moments of the powers of Phi, over |moment|.
MinimaxFit fit_power(const Samples& at, const BallCounts& counts,
                     const MatrixXd& in_e, int rounds) {
  const auto [value, slope] = powers(at.x, counts.n, counts.odd);
  const MatrixXd V = products(value, in_e);
  const MatrixXd Vx = products(slope, in_e);
  const ArrayXd size = (at.sliding.square() + at.spinning.square()).sqrt();
  const auto scaled = [&](const MatrixXd& rows, const ArrayXd& by) {
    return (rows.array().colwise() * (by / size)).matrix();
  };
  MatrixXd a(2 * size.size(), V.cols());
  if (at.outside) {
    // b = wide Gx of the formula.
    const ArrayXd wide = (at.s / at.q / (1 - at.drop)).square();
    a << scaled(V, ArrayXd::Ones(size.size())) +
             scaled(Vx, 2 * at.sa.square() * wide),
        scaled(Vx, -2 * at.q * at.sa * wide);
  } else {
    a << scaled(V, at.q * at.s) + scaled(Vx, -at.q * at.sa * at.s / at.drop),
        scaled(V, at.sa * at.s) + scaled(Vx, at.q.square() * at.s / at.drop);
  }
  VectorXd b(2 * size.size());
  b << (at.sliding / size).matrix(), (at.spinning / size).matrix();
  return minimax_fit(std::move(a), b, 2, rounds);
}

// e of the formula.
ArrayXd load_variable(const BallLaw<double>& law, const Samples& at) {
  return law.share * (at.T - law.T_middle) / law.T_half + law.other * at.t;
}

void append(const VectorXd& numbers, std::vector<double>& to) {
  to.insert(to.end(), numbers.begin(), numbers.end());
}

// Picks e: T for half-spaces, t or the mean of both for thin walls.
void choose_variable(const std::array<Samples, 2>& sides,
                     BallLaw<double>& law) {
  double least = std::numeric_limits<double>::infinity();
  double best = 0;
  for (const double share : {0.0, 0.5, 1.0}) {
    law.share = share;
    law.other = 1 - share;
    double error = 0;
    for (const Samples& at : sides) {
      const MatrixXd in_e = powers(load_variable(law, at), law.nh, 0).first;
      error = std::max(error, fit_power(at, law, in_e, 3).error);
    }
    if (error < least) {
      least = error;
      best = share;
    }
  }
  law.share = best;
  law.other = 1 - best;
}

BallLaw<double> fitted(const Joint& ball, const BallCounts& counts, double low,
                       double high) {
  const JointContact& contact = ball.contact();
  BallLaw<double> law{counts};
  law.radius = contact.geometry().radius();
  law.side = contact.geometry().side();
  law.low = low;
  law.high = high;
  law.top = (law.n - 1) * law.nh;
  law.past = (law.n + 1) * law.nh;
  law.r_top = (law.nr - 1) * law.nrh;
  law.seven_halves = 3.5;
  law.tiny = 1e-30;
  law.largest = 1e12;
  law.tolerance = counts.residual;
  // R_n is less than R by friction, whose force is up to 1.3 f R_n.
  const double least = 0.98 * low / std::hypot(1, 1.3 * most_friction(ball));
  law.middle = std::log(least * high) / 2;
  law.half = std::log(high / least) / 2;
  const auto half_angles = [&](const ArrayXd& t) -> ArrayXd {
    return t.unaryExpr([&](double x) {
      const double force = std::exp(law.middle + law.half * x);
      const double angle = contact.half_angle(force).half_angle;
      if (std::isfinite(angle)) return angle;
      throw Error(needs(fmt::format("a load law: a load of {} N", force),
                        "a half-angle law that has a value there"));
    });
  };
  const ArrayXd fine = 2 * nodes(4 * loads) - 1;
  const ArrayXd T = (half_angles(fine) / 2).tan();
  law.T_middle = (T.maxCoeff() + T.minCoeff()) / 2;
  law.T_half = (T.maxCoeff() - T.minCoeff()) / 2;
  append(minimax_fit(powers(fine, law.nT, 0).first.array().colwise() / T,
                     VectorXd::Ones(fine.size()))
             .numbers,
         law.table);
  const ArrayXd t = 2 * nodes(loads) - 1;
  const ArrayXd half_angle = half_angles(t);
  const std::array<Samples, 2> sides = {
      sampled(contact, law, t, half_angle, false),
      sampled(contact, law, t, half_angle, true)};
  choose_variable(sides, law);
  for (const Samples& at : sides) {
    (at.outside ? law.outside : law.inside) = int(law.table.size());
    const ArrayXd e = load_variable(law, at);
    append(fit_power(at, law, powers(e, law.nh, 0).first, 15).numbers,
           law.table);
    append(minimax_fit(products(powers(at.x, law.nr, 0).first,
                                powers(e, law.nrh, 0).first),
                       at.ratio)
               .numbers,
           law.table);
  }
  return law;
}

// The largest errors over many states, those of a sequence that fills the
// square of load and direction evenly; a third of the directions is close to
// the load.
void measure(const Joint& ball, double enough, BallLoadLaw& of) {
  constexpr int states = 100'000;
  const BallLaw<float> in_float = ball_law_in<float>(of.law);
  const double f0 = coefficient_of(ball);
  for (int i = 0; i < states && of.error <= enough; ++i) {
    double whole;
    const double first = std::modf(0.7548776662466927 * i, &whole);
    const double second = std::modf(0.5698402909980532 * i, &whole);
    const double load = of.law.low * std::pow(of.law.high / of.law.low, first);
    const double b =
        i % 3 == 0 ? 1e-4 * std::pow(3e4, second) : std::numbers::pi * second;
    // In some frame, for the roundings of float.
    const Eigen::Quaterniond frame =
        Eigen::Quaterniond(0.5, first, second - 0.5, std::sin(i)).normalized();
    const Vector3d R = frame * Vector3d(0, 0, load);
    const Vector3d w = frame * Vector3d(std::sin(b), 0, std::cos(b));
    const Vector3d exact = ball.solve({R, w}).friction_moment;
    Vector3d M;
    of.law.friction(R.data(), w.data(), f0, M.data());
    of.error = std::max(of.error, (M - exact).norm() / exact.norm());
    Eigen::Vector3f M_float;
    in_float.friction(R.cast<float>().eval().data(),
                      w.cast<float>().eval().data(), float(f0), M_float.data());
    of.float_error = std::max(
        of.float_error, (M_float.cast<double>() - exact).norm() / exact.norm());
  }
}

}  // namespace

double most_friction(const Joint& ball) {
  return std::max(0.2, 2.5 * coefficient_of(ball));
}

BallLoadLaw ball_load_law(const Joint& ball, const LoadLawOptions& options) {
  check(ball);
  const double unit = 1 / ball.contact().load_parameter(1);
  const auto [low, high] =
      options.loads.value_or(std::pair(1e-3 * unit, 10 * unit));
  check_loads(low, high);
  BallLoadLaw law;
  for (const BallCounts& counts : presets) {
    const bool last = &counts == std::end(presets) - 1;
    law = {fitted(ball, counts, low, high)};
    measure(ball, last ? 1 : options.error, law);
    if (law.error <= options.error) return law;
  }
  throw out_of_reach(options.error, law.error);
}

}  // namespace contact::detail
