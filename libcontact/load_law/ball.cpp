#include "libcontact/load_law/ball.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "libcontact/load_law/minimax.hpp"

namespace contact::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// R_n and theta0.
std::pair<double, double> contact_at(const JointContact& contact,
                                     const BallLaw<double>& law, double t) {
  const double force = std::exp(law.middle + law.half * t);
  return {force, checked(contact.half_angle(force).half_angle, force)};
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
    const auto [force, half_angle] = contact_at(contact, law, t);
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
      at.exact =
          contact.integrals(half_angle, {at.sa, at.q}, {force, 1}).coefficient;
      all.push_back(at);
    }
  }
  return all;
}

using Parts = std::vector<double FrictionTriple::*>;

// Fits `count` coefficients from `first` on, which these parts of the friction
// are linear in, and returns their error over the moment, which an error of any
// turns by that.
double fit(BallLaw<double>& law, int first, int count,
           const std::vector<Sample>& all, const Parts& parts,
           int rounds = 15) {
  const auto column = [&](const auto& friction) {
    Eigen::MatrixXd values(all.size(), parts.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const FrictionTriple of = friction(all[i]);
      const FrictionTriple& exact = all[i].exact;
      for (std::size_t k = 0; k < parts.size(); ++k) {
        values(Eigen::Index(i), Eigen::Index(k)) =
            of.*parts[k] / std::hypot(exact.sliding, exact.spinning);
      }
    }
    return values.reshaped().eval();
  };
  const auto to = law.table.begin() + first;
  std::fill_n(to, count, 0);
  const VectorXd b = column([](const Sample& at) { return at.exact; });
  Eigen::MatrixXd a(b.size(), count);
  for (int k = 0; k < count; ++k) {
    to[k] = 1;
    a.col(k) = column(
        [&](const Sample& at) { return law.at_axis(at.t, at.sa, at.q); });
    to[k] = 0;
  }
  const MinimaxFit best =
      minimax_fit(std::move(a), b, int(parts.size()), rounds);
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
  const ArrayXd T = t.unaryExpr([&](double x) {
    return std::tan(contact_at(contact, law, x).second / 2);
  });
  law.T_middle = (T.maxCoeff() + T.minCoeff()) / 2;
  law.T_half = (T.maxCoeff() - T.minCoeff()) / 2;
  const auto of_t =
      minimax_fit(powers(t, law.nT, T.inverse()), VectorXd::Ones(t.size()));
  law.table.assign(of_t.numbers.begin(), of_t.numbers.end());
  const int powers_of_x = (law.n + law.odd) * law.nh;
  const int ratio = law.nr * law.nrh;
  law.outside = law.nT + powers_of_x + ratio;
  law.table.resize(std::size_t(law.outside + powers_of_x + ratio));
  const std::pair<int, std::vector<Sample>> sides[] = {
      {law.nT, sampled(contact, law, false)},
      {law.outside, sampled(contact, law, true)}};
  const Parts moments = {&FrictionTriple::sliding, &FrictionTriple::spinning};
  // Picks e: T for half-spaces, t or the mean of both for thin walls.
  double error = std::numeric_limits<double>::infinity();
  double best = 0;
  for (const double share : {0.0, 0.5, 1.0}) {
    law.share = share;
    double of = 0;
    for (const auto& [first, all] : sides) {
      of = std::max(of, fit(law, first, powers_of_x, all, moments, 3));
    }
    if (of < error) best = share;
    error = std::min(error, of);
  }
  law.share = best;
  for (const auto& [first, all] : sides) {
    fit(law, first, powers_of_x, all, moments);
    fit(law, first + powers_of_x, ratio, all, {&FrictionTriple::force});
  }
  return law;
}

// The largest errors over many states: a sequence that fills the square of load
// and direction evenly, with a third of the directions close to the load.
void measure(const Joint& ball, double enough, BallLaw<double>& law) {
  constexpr int states = 100'000;
  BallLaw<float> single;
#define CONTACT_COPIED(name) \
  single.name = static_cast<decltype(single.name)>(law.name);
  CONTACT_BALL_NUMBERS(CONTACT_COPIED, CONTACT_COPIED)
#undef CONTACT_COPIED
  single.table.assign(law.table.begin(), law.table.end());
  const double f0 = dry_friction(ball).coefficient();
  for (int i = 0; i < states && law.error <= enough; ++i) {
    double whole;
    const double first = std::modf(0.7548776662466927 * i, &whole);
    const double second = std::modf(0.5698402909980532 * i, &whole);
    const double b =
        i % 3 == 0 ? 1e-4 * std::pow(3e4, second) : std::numbers::pi * second;
    // In some frame, for the roundings of float.
    const Eigen::Quaterniond frame =
        Eigen::Quaterniond(0.5, first, second - 0.5, std::sin(i)).normalized();
    const Vector3d R =
        frame * Vector3d(0, 0, law.low * std::pow(law.high / law.low, first));
    const Vector3d w = frame * Vector3d(std::sin(b), 0, std::cos(b));
    const Vector3d exact = ball.solve({R, w}).friction_moment;
    const auto off = [&]<class Real>(const BallLaw<Real>& of) {
      const Eigen::Vector3<Real> load = R.cast<Real>(), rate = w.cast<Real>();
      Eigen::Vector3<Real> M;
      of.friction(load.data(), rate.data(), Real(f0), M.data());
      return (M.template cast<double>() - exact).norm() / exact.norm();
    };
    law.error = std::max(law.error, off(law));
    law.float_error = std::max(law.float_error, off(single));
  }
}

}  // namespace

double most_friction(const Joint& ball) {
  return std::max(0.2, 2.5 * dry_friction(ball).coefficient());
}

BallLaw<double> ball_load_law(const Joint& ball,
                              const LoadLawOptions& options) {
  // nT, n, nh, odd, nr, nrh, rounds, and the tolerance: 54, 116, 202 and 460
  // numbers with errors of some 1e-2, 5e-4, 1e-4, 1e-6.
  const BallLaw<double> presets[] = {{10, 4, 4, 0, 3, 2, 5, 0, 1e-3},
                                     {14, 5, 7, 0, 4, 4, 7, 0, 2e-5},
                                     {16, 6, 9, 1, 5, 6, 9, 0, 3e-6},
                                     {20, 8, 14, 2, 8, 10, 11, 0, 3e-8}};
  const FrictionLaw dry = dry_friction(ball);
  require(dry.coefficient() > 0 && dry.coefficient() <= 1 &&
              dry.adhesion() == 0 &&
              ball.contact().geometry().radial_clearance() > 0,
          "the load law of a ball",
          "a clearance, and dry friction without adhesion with a coefficient "
          "above 0, up to 1");
  const auto range = loads_of_endless(
      ball, options.loads, 1 / ball.contact().load_parameter(1), 1e-3, 10);
  BallLaw<double> law;
  for (const BallLaw<double>& preset : presets) {
    const bool is_last = &preset == std::end(presets) - 1;
    law = fitted(ball, preset, range);
    measure(ball, is_last ? 1 : options.error, law);
    if (law.error <= options.error) return law;
  }
  throw out_of_reach(options.error, law.error);
}

}  // namespace contact::detail
