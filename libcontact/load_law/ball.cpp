#include "libcontact/load_law/ball.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/load_law/minimax.hpp"

namespace contact::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

void check(const Joint& ball) {
  const FrictionLaw dry = dry_friction(ball);
  if (dry.coefficient() > 0 && dry.coefficient() <= 1 && dry.adhesion() == 0 &&
      ball.contact().geometry().radial_clearance() > 0) {
    return;
  }
  throw Error(needs("the load law of a ball",
                    "a clearance, and dry friction without adhesion with a "
                    "coefficient above 0, up to 1"));
}

double half_angle_at(const JointContact& contact, const BallLaw<double>& law,
                     double t) {
  const double force = std::exp(law.middle + law.half * t);
  const double angle = contact.half_angle(force).half_angle;
  if (std::isfinite(angle)) return angle;
  throw Error(needs(fmt::format("a load law: a load of {} N", force),
                    "a half-angle law that has a value there"));
}

// A contact and its friction.
struct Sample {
  double t, sa, q;
  FrictionTriple exact;
};

// Contacts at nodes of the load, and of x on one side of the rim.
std::vector<Sample> sampled(const JointContact& contact,
                            const BallLaw<double>& law, bool outside) {
  std::vector<Sample> all;
  for (const double t : ArrayXd(2 * nodes(30) - 1)) {
    const double half_angle = half_angle_at(contact, law, t);
    const double T = law.poly(0, law.nT, t);
    const double s = 2 * T / (1 + T * T);
    const double c2 = (1 - s * T) * (1 - s * T);
    for (const double x : ArrayXd(nodes(40).square())) {
      const double z = s * T * (1 - x);
      Sample at = {t, 1 - z, std::sqrt(z * (2 - z)), {}};
      if (outside) {
        at.q = s / std::sqrt(1 - x * c2);
        at.sa = std::sqrt(c2 * (1 - x) / (1 - x * c2));
      }
      const double force = std::exp(law.middle + law.half * t);
      at.exact =
          contact.integrals(half_angle, {at.sa, at.q}, {force, 1}).coefficient;
      all.push_back(at);
    }
  }
  return all;
}

// Parts of the friction over the moment, which an error of any turns by that.
Vector2d moments(const FrictionTriple& of, const FrictionTriple& exact) {
  return Vector2d(of.sliding, of.spinning) /
         std::hypot(exact.sliding, exact.spinning);
}
Vector2d force(const FrictionTriple& of, const FrictionTriple& exact) {
  return Vector2d(of.force, 0) / std::hypot(exact.sliding, exact.spinning);
}

// Fits `count` coefficients from `first` on, which this part of the friction is
// linear in, and returns the error.
double fit(BallLaw<double>& law, int first, int count,
           const std::vector<Sample>& all, decltype(moments) part,
           int rounds = 15) {
  const auto points = Eigen::Index(all.size());
  const auto column = [&](const auto& friction) {
    Eigen::MatrixX2d values(points, 2);
    for (Eigen::Index i = 0; i < points; ++i) {
      const Sample& at = all[std::size_t(i)];
      values.row(i) = part(friction(at), at.exact);
    }
    return values.reshaped().eval();
  };
  const auto to = law.table.begin() + first;
  std::fill_n(to, count, 0);
  Eigen::MatrixXd a(2 * points, count);
  for (int k = 0; k < count; ++k) {
    to[k] = 1;
    a.col(k) = column(
        [&](const Sample& at) { return law.at_axis(at.t, at.sa, at.q); });
    to[k] = 0;
  }
  const VectorXd b = column([](const Sample& at) { return at.exact; });
  const MinimaxFit best = minimax_fit(std::move(a), b, 2, rounds);
  std::ranges::copy(best.numbers, to);
  return best.error;
}

// `law` has the counts and the tolerance of a preset.
BallLaw<double> fitted(const Joint& ball, BallLaw<double> law,
                       std::pair<double, double> loads) {
  const JointContact& contact = ball.contact();
  law.radius = contact.geometry().radius();
  law.side = contact.geometry().side();
  law.low = loads.first;
  law.high = loads.second;
  law.tiny = 1e-30;
  // R_n is less than R by friction, whose force is up to 1.3 f R_n.
  const double least =
      law.low * 0.98 / std::hypot(1, 1.3 * most_friction(ball));
  law.middle = std::log(least * law.high) / 2;
  law.half = std::log(law.high / least) / 2;
  const ArrayXd t = 2 * nodes(120) - 1;
  const ArrayXd T = t.unaryExpr(
      [&](double x) { return std::tan(half_angle_at(contact, law, x) / 2); });
  law.T_middle = (T.maxCoeff() + T.minCoeff()) / 2;
  law.T_half = (T.maxCoeff() - T.minCoeff()) / 2;
  const auto of_t =
      minimax_fit(powers(t, law.nT, T.inverse()), VectorXd::Ones(t.size()));
  law.table.assign(of_t.numbers.begin(), of_t.numbers.end());
  const int powers_of_x = (law.n + law.odd) * law.nh;
  const int ratio = law.nr * law.nrh;
  law.inside = law.nT;
  law.outside = law.inside + powers_of_x + ratio;
  law.table.resize(std::size_t(law.outside + powers_of_x + ratio));
  const auto inside = sampled(contact, law, false);
  const auto outside = sampled(contact, law, true);
  // Picks e: T for half-spaces, t or the mean of both for thin walls.
  double error = std::numeric_limits<double>::infinity();
  double best = 0;
  for (const double share : {0.0, 0.5, 1.0}) {
    law.share = share;
    const double of =
        std::max(fit(law, law.inside, powers_of_x, inside, moments, 3),
                 fit(law, law.outside, powers_of_x, outside, moments, 3));
    if (of < error) best = share;
    error = std::min(error, of);
  }
  law.share = best;
  for (const auto& [first, all] :
       {std::pair(law.inside, &inside), std::pair(law.outside, &outside)}) {
    fit(law, first, powers_of_x, *all, moments);
    fit(law, first + powers_of_x, ratio, *all, force);
  }
  return law;
}

BallLaw<float> in_float(const BallLaw<double>& law) {
  BallLaw<float> to;
#define CONTACT_COPIED(name) to.name = static_cast<decltype(to.name)>(law.name);
  CONTACT_BALL_COUNTS(CONTACT_COPIED)
  CONTACT_BALL_REALS(CONTACT_COPIED)
#undef CONTACT_COPIED
  to.table.assign(law.table.begin(), law.table.end());
  return to;
}

// The largest error of M in this state, which it grows.
template <class Real>
void compare(const BallLaw<Real>& law, const Vector3d& R, const Vector3d& w,
             double f, const Vector3d& exact, double& error) {
  const Eigen::Vector3<Real> load = R.cast<Real>(), rate = w.cast<Real>();
  Eigen::Vector3<Real> M;
  law.friction(load.data(), rate.data(), Real(f), M.data());
  error = std::max(error,
                   (M.template cast<double>() - exact).norm() / exact.norm());
}

// The largest errors over many states, from a sequence that fills the square of
// load and direction evenly; a third of the directions is close to the load.
void measure(const Joint& ball, double enough, BallLoadLaw& of) {
  constexpr int states = 100'000;
  const BallLaw<float> single = in_float(of.law);
  const double f0 = dry_friction(ball).coefficient();
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
    compare(of.law, R, w, f0, exact, of.error);
    compare(single, R, w, f0, exact, of.float_error);
  }
}

}  // namespace

double most_friction(const Joint& ball) {
  return std::max(0.2, 2.5 * dry_friction(ball).coefficient());
}

BallLoadLaw ball_load_law(const Joint& ball, const LoadLawOptions& options) {
  // nT, n, nh, odd, nr, nrh, rounds, and the tolerance: 54, 116, 202 and 460
  // numbers with errors of some 1e-2, 5e-4, 1e-4, 1e-6.
  const BallLaw<double> presets[] = {{10, 4, 4, 0, 3, 2, 5, 0, 0, 1e-3},
                                     {14, 5, 7, 0, 4, 4, 7, 0, 0, 2e-5},
                                     {16, 6, 9, 1, 5, 6, 9, 0, 0, 3e-6},
                                     {20, 8, 14, 2, 8, 10, 11, 0, 0, 3e-8}};
  check(ball);
  const auto range =
      loads_of(options.loads, 1 / ball.contact().load_parameter(1), 1e-3, 10);
  BallLoadLaw law;
  for (const BallLaw<double>& preset : presets) {
    const bool is_last = &preset == std::end(presets) - 1;
    law = {fitted(ball, preset, range)};
    measure(ball, is_last ? 1 : options.error, law);
    if (law.error <= options.error) return law;
  }
  throw out_of_reach(options.error, law.error);
}

}  // namespace contact::detail
