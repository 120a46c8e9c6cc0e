#include "libcontact/conforming/pin.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "libcontact/base/check.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/base/linear/solve.hpp"
#include "libcontact/conforming/edge_fit.hpp"
#include "libcontact/conforming/gap/signed_contact.hpp"
#include "libcontact/conforming/half_angle_root.hpp"
#include "libcontact/conforming/kernel/pin_wall_modes.hpp"
#include "libcontact/conforming/pin_integrals.hpp"
#include "libcontact/conforming/wall_harmonics.hpp"
#include "libcontact/conforming/wide_edge.hpp"

// Letters as in docs/internals/conforming_methods.md: b = tan(theta0/2), q =
// tan(theta0/4).
namespace contact {
namespace {

using detail::ChebyshevMoments;

using detail::infinity;
using detail::nan;
using detail::pi;

constexpr int most_unknowns = PinContact::max_walled_unknowns;
// Terms of the pressure's own series: a_k falls like k^-6 after its leading
// logarithm, and like q^(2k).
constexpr int max_terms = 96;
constexpr int usual_terms = 48;
static_assert(max_terms >= most_unknowns);
static_assert(ChebyshevMoments::max_count >= most_unknowns + max_terms);

template <int max>
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max, 1>;
using Unknowns = Vector<most_unknowns>;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0,
                             most_unknowns, most_unknowns>;

// ∫ sqrt(1 - s^2) U_{2k} g/(1 + b^2 s^2) ds, k < count, for the functions g
// on the right of the equation.
struct RightSides {
  RightSides(double half_angle, const PinConstants& constants,
             InnerLoading loading, int count)
      : constant(count), cosine(count), load(count) {
    detail::project_first_harmonics(half_angle, constant, cosine);
    load = (1 + constants.beta) * cosine;
    if (loading.is_back()) add_back(half_angle, constants, loading);
  }

  Vector<max_terms> constant;  // g = 1: what C multiplies
  Vector<max_terms> cosine;    // g = cos t
  Vector<max_terms> load;      // all that p_1 multiplies

 private:
  void add_back(double half_angle, const PinConstants& constants,
                InnerLoading loading) {
    const double half_patch = loading.patch_half_angle() / 2;
    const double c = std::tan(half_angle / 2) * std::tan(half_patch);
    const double root = std::sqrt((1 - c) * (1 + c));
    const double r2 = (1 - root) / (1 + root);
    const double cosine_patch = std::cos(half_patch);
    double term = constants.inner_share * pi / (1 + root) /
                  (4 * cosine_patch * cosine_patch);
    load -= constants.inner_share * (1 - constants.inner_beta_part) * cosine;
    for (int k = 0; k < load.size(); ++k) {
      load(k) += term;
      term *= r2;
    }
  }
};

// Coefficients of y^3 ln y = sum l_k sin((2k+1) phi), y = sin(phi), by
//   ln sin(phi) = -ln 2 - sum cos(2 m phi)/m.
struct LeadingLogarithm {
  LeadingLogarithm() {
    const auto with_sine = [](int order) {  // sin(order phi) ln sin(phi)
      // sin(n phi) cos(2 m phi) = (sin((n+2m) phi) + sin((n-2m) phi))/2
      std::array<double, max_terms> c{};
      c[order / 2] -= std::numbers::ln2;
      for (int m = 1; m <= max_terms + 1; ++m) {
        const int up = order + 2 * m;
        const int down = order - 2 * m;
        if (up / 2 < max_terms) c[up / 2] -= 0.5 / m;
        const int index = std::abs(down) / 2;
        if (index < max_terms) c[index] -= (down > 0 ? 0.5 : -0.5) / m;
      }
      return c;
    };
    const auto first = with_sine(1);
    const auto third = with_sine(3);
    for (int k = 0; k < max_terms; ++k) {
      coefficient[k] = (3 * first[k] - third[k]) / 4;
    }
  }
  std::array<double, max_terms> coefficient;
};

}  // namespace

// Contribution of the walls: sum weight_n p_n cos nt on the left of (2).
struct PinContact::Wall {
  explicit Wall(const detail::WallHarmonics& harmonics)
      : correction(harmonics.correction), first(harmonics.first) {}

  int end() const { return static_cast<int>(correction.size()); }
  // Calls add(n, weight, g, second) block by block: a sum over Dc_n (n^2 - 1)
  // times the product of two harmonics equals the sum over `weight` times
  // theirs, both of the second kind if `second`.
  void visit(double half_angle, const detail::PinWallModes& modes,
             const auto& add) const {
    const detail::GradedSamples samples(half_angle, end(), modes.smooth_from());
    const auto adder = [&](const auto& some, bool second) {
      Eigen::VectorXd weight(some.n.size());
      for (Eigen::Index i = 0; i < weight.size(); ++i) {
        const double n = some.n[i];
        weight(i) = some.weight[i] * (n - 1) * (n + 1) *
                    correction[static_cast<std::size_t>(n)];
      }
      return [&, weight, second](int i, const auto& g) {
        add(&some.n[i], weight.segment(i, g.rows()), g, second);
      };
    };
    modes.visit(samples.swinging.n, adder(samples.swinging, false));
    if (samples.n.empty()) return;
    modes.visit(samples.n, adder(samples, false));
    modes.visit_second_kind(samples.n, adder(samples, true));
  }

  // sum weight_n p_n G_n(k), k < count, of a solution.
  Vector<max_terms> sums(double half_angle, const Unknowns& y,
                         int count) const {
    const detail::PinWallModes modes(half_angle, count);
    const Eigen::MatrixXd& t = modes.transformation();
    const Eigen::VectorXd series = t.leftCols(y.size()) * y;
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(t.rows());
    visit(half_angle, modes,
          [&](const double*, const auto& weight, const auto& g, bool) {
            const Eigen::VectorXd p = g * series;
            sum += g.transpose() * weight.cwiseProduct(p);
          });
    return t.transpose() * sum / (2 * pi);
  }

  std::vector<double> correction;  // Dc_n
  double first;                    // c_1
};

// Solution with p_1 = 1: the pressure is p = b sum y_k sin((2k+1) phi).
struct PinContact::Solution {
  Unknowns y;
  double constant;    // C = ebar E/4 + (c_0 + beta) p_0
  double mean;        // p_0
  double reciprocal;  // 1/lambda
};

// The equation at one half-angle, ready for any number of unknowns up to the
// contact's.
struct PinContact::System {
  System(const PinContact& pin, double half_angle);
  Solution solve(int unknowns) const;

  double b2;
  double mean_share;
  RightSides given;
  ChebyshevMoments moments;
  std::optional<detail::PinWallModes> modes;
  Matrix matrix;
};

namespace {

PinConstants constants_of(const ElasticPair& pair) {
  const double nu = pair.inner().poissons_ratio;
  return {pair.outer_compliance_share(), pair.dundurs_beta(),
          pair.inner_compliance_share(), (1 - 2 * nu) / (2 * (1 - nu))};
}

}  // namespace

PinContact::PinContact(const ElasticPair& pair, InnerLoading loading,
                       int unknowns)
    : PinContact(constants_of(pair), loading, unknowns, max_unknowns) {}

PinContact::PinContact(const LayeredPair& pair, InnerLoading loading,
                       int unknowns)
    : PinContact(constants_of(pair.surfaces()), loading,
                 unknowns == 0 ? detail::walled_unknowns(pair) : unknowns,
                 max_walled_unknowns) {
  detail::require_uncoated(pair, loading);
  const detail::WallHarmonics walls(JointKind::pin, pair);
  const bool has_layers = !walls.correction.empty();
  // In a rigid hole too the centres have a shift.
  if (!has_layers && std::isnan(walls.first)) return;
  wall_ = std::make_shared<const Wall>(walls);
  if (has_layers) constants_.mean_share += walls.correction[0];
}

PinContact PinContact::from_dundurs(double outer_compliance_share,
                                    double dundurs_beta, int unknowns) {
  detail::require(outer_compliance_share >= 0 && outer_compliance_share <= 1,
                  "pin contact", "outer_compliance_share",
                  outer_compliance_share, "0 to 1");
  detail::require(dundurs_beta >= -0.5 && dundurs_beta <= 0.5, "pin contact",
                  "dundurs_beta", dundurs_beta, "-0.5 to 0.5");
  return {PinConstants{outer_compliance_share, dundurs_beta, nan, nan},
          InnerLoading::centre(), unknowns, max_unknowns};
}

PinContact::PinContact(PinConstants constants, InnerLoading loading,
                       int unknowns, int most)
    : constants_(constants), loading_(loading), unknowns_(unknowns) {
  detail::require(unknowns >= 8 && unknowns <= most, "pin contact", "unknowns",
                  unknowns, most == max_unknowns ? "8 to 32" : "8 to 64");
  // Nor beyond what the moments are good for.
  largest_ =
      4 * std::atan(std::pow(10, -2.0 / std::min(unknowns, max_unknowns)));
  if (loading.is_back()) {
    // The edges of the contact and of the loaded patch must not touch.
    largest_ = std::min(largest_, pi - loading.patch_half_angle() - 1e-3);
  }
}

PinContact::System::System(const PinContact& pin, double half_angle)
    : b2(std::tan(half_angle / 2) * std::tan(half_angle / 2)),
      mean_share(pin.constants_.mean_share),
      given(half_angle, pin.constants_, pin.loading_, pin.unknowns_),
      moments(b2, 2 * pin.unknowns_),
      matrix(pin.unknowns_, pin.unknowns_) {
  const double scale = pin.constants_.beta * std::tan(half_angle / 2);
  for (int k = 0; k < pin.unknowns_; ++k) {
    for (int j = 0; j <= k; ++j) {
      matrix(j, k) = matrix(k, j) = scale * moments.matrix_element(j, k);
    }
    matrix(k, k) += (2 * k + 1) * pi / 4;
  }
  if (!pin.wall_) return;
  modes.emplace(half_angle, pin.unknowns_);
  const Eigen::MatrixXd& t = modes->transformation();
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(t.rows(), t.rows());
  pin.wall_->visit(half_angle, *modes,
                   [&](const double*, const auto& weight, const auto& g, bool) {
                     const Eigen::MatrixXd weighted = weight.asDiagonal() * g;
                     sum.triangularView<Eigen::Lower>() +=
                         weighted.transpose() * g;
                   });
  const Eigen::MatrixXd all = sum.selfadjointView<Eigen::Lower>() * t;
  matrix.noalias() += t.transpose() * all / (2 * pi);
}

PinContact::Solution PinContact::System::solve(int n) const {
  Eigen::Matrix<double, Eigen::Dynamic, 2, 0, most_unknowns, 2> right(n, 2);
  right << given.constant.head(n), given.load.head(n);
  // LU: the matrix is not definite for beta < 0 and wide contacts. In place: a
  // copy and its work space take 70 kB of the stack.
  Matrix leading = matrix.topLeftCorner(n, n);
  detail::solve_in_place(leading, right);
  const auto& solved = right;

  // p_0 = (b/pi) ∫ sqrt(1 - s^2) sum a_k U_2k/(1 + b^2 s^2) ds, a = b y;
  // p_1 = 1 fixes C.
  const double scale = 2 * b2 / pi;
  Solution result;
  result.constant = (1 - scale * given.cosine.head(n).dot(solved.col(1))) /
                    (scale * given.cosine.head(n).dot(solved.col(0)));
  result.y = result.constant * solved.col(0) + solved.col(1);
  result.mean = b2 / pi * given.constant.head(n).dot(result.y);
  result.reciprocal = 2 * (result.constant - mean_share * result.mean);
  return result;
}

double PinContact::reciprocal(double half_angle) const noexcept {
  return System(*this, half_angle).solve(unknowns_).reciprocal;
}

double PinContact::reciprocal_load(double half_angle) const noexcept {
  if (!(half_angle > 0 && half_angle <= largest_)) return nan;
  return reciprocal(half_angle);
}

ExactLoad PinContact::load_parameter(double half_angle) const noexcept {
  if (half_angle == 0) return {0, Status::ok, 0};
  if (!(half_angle > 0 && half_angle <= largest_)) {
    return {nan, Status::out_of_range, nan};
  }
  const System system(*this, half_angle);
  const double reciprocal = system.solve(unknowns_).reciprocal;
  if (!(reciprocal >= 0)) return {nan, Status::out_of_range, nan};
  const double coarse = system.solve(unknowns_ - 4).reciprocal;
  return {1 / reciprocal, Status::ok, std::abs(reciprocal - coarse)};
}

ExactHalfAngle PinContact::half_angle(double load_parameter) const noexcept {
  if (!(load_parameter >= 0)) return {nan, Status::out_of_range, nan, 0};
  if (load_parameter == 0) return {0, Status::ok, 0, 0};
  return detail::half_angle_root(
      [this](double theta) { return reciprocal(theta); }, 1 / load_parameter,
      2 * std::sqrt(load_parameter), 2, largest_);
}

ExactHalfAngle PinContact::limit_half_angle() const noexcept {
  return half_angle(infinity);
}

namespace {

// sum (c_n - 1/n) p_n cos nt, n >= 2, of homogeneous bodies, averaged with the
// weight of approach(): of p = b sum y_k sin((2k+1) phi) with the kernel
// sum (beta n + 1)/(n (n^2 - 1)) cos nx, which is smooth but for x = 0.
double average_without_walls(double half_angle, double beta,
                             const Unknowns& y) {
  static const detail::GaussLegendre& usual = *new detail::GaussLegendre(56);
  static const detail::GaussLegendre& fine = *new detail::GaussLegendre(96);
  const detail::GaussLegendre& rule =
      y.size() > PinContact::default_unknowns ? fine : usual;
  // Points in psi, sin(t/2) = sin(theta0/2) cos psi.
  const int points = static_cast<int>(y.size()) + 8;
  const double b = std::tan(half_angle / 2);
  const auto kernel = [beta](double x) {
    const double half = std::sin(x / 2);
    return beta * (0.5 + std::cos(x) / 4 - (pi - x) / 2 * std::sin(x)) +
           2 * half * half * std::log(2 * half) + 0.75 * std::cos(x) - 0.5;
  };
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    const double psi = pi / 2 * (i + 0.5) / points;
    const double t = 2 * std::asin(std::sin(half_angle / 2) * std::cos(psi));
    const double middle = std::acos(std::tan(t / 2) / b);  // phi of t
    for (const auto& [from, to] : {std::pair(0.0, middle), {middle, pi}}) {
      for (int k = 0; k < rule.node.size(); ++k) {
        const double phi = (from + to) / 2 + (to - from) / 2 * rule.node(k);
        const double tangent = b * std::cos(phi);
        const double x = std::abs(t - 2 * std::atan(tangent));
        double b0 = 0;
        double b1 = 0;
        for (auto j = y.size() - 1; j >= 0; --j) {
          b1 = std::exchange(b0, 2 * std::cos(2 * phi) * b0 - b1 + y(j));
        }
        const double sine = std::sin(phi);
        sum += (to - from) / 2 * rule.weight(k) * kernel(x) * (b0 + b1) * sine *
               sine / (1 + tangent * tangent);
      }
    }
  }
  return 2 * b * b * sum / (pi * points);
}

// S - 1 = 2 p_0/p_1 - 1, from the difference of the two harmonics' weights.
double excess_of(double half_angle, const Unknowns& y) {
  const double b = std::tan(half_angle / 2);
  const double q = std::tan(half_angle / 4);
  const double q2 = q * q;
  double term = b * b * (1 - q2) / (1 + q2);
  double sum = 0;
  for (int k = 0; k < y.size(); ++k) {
    sum += term * ((2 * k + 2) * q2 - 2 * k) * y(k);
    term *= -q2;
  }
  return sum;
}

}  // namespace

// How the bodies yield, all over 2 K_1: the approach D - eps, and its rate over
// the load at constant clearance.
struct PinContact::Yield {
  double approach;
  double rate;
};

PinContact::Yield PinContact::yield(double half_angle, const System& system,
                                    const Solution& solution) const noexcept {
  if (!wall_ || loading_.is_back() || std::isnan(wall_->first)) {
    return {nan, nan};
  }
  const Eigen::MatrixXd& t = system.modes->transformation();
  const double beta = constants_.beta;
  const double mean_share = constants_.mean_share;
  const double b = std::tan(half_angle / 2);
  const double sine = std::sin(half_angle / 2);

  // The equation before its differentiation, averaged with the weight that
  // turns cos nt into (P_n + P_{n-1})(cos theta0)/2.
  const Eigen::VectorXd series = t * solution.y;
  double sum = (mean_share - beta - 2 * std::log(sine)) * solution.mean +
               average_without_walls(half_angle, beta, solution.y);
  const double first_average = (1 + std::cos(half_angle)) / 2;
  sum += (wall_->first - 1) * first_average;
  const std::vector<double> average[] = {
      detail::edge_averages(half_angle, wall_->end()),
      detail::second_edge_averages(half_angle, wall_->end())};
  Eigen::VectorXd singular = Eigen::VectorXd::Zero(t.rows());
  wall_->visit(
      half_angle, *system.modes,
      [&](const double* order, const auto& weight, const auto& g, bool second) {
        Eigen::VectorXd part = weight;
        const Eigen::VectorXd p = b / pi * (g * series);
        for (int i = 0; i < g.rows(); ++i) {
          const double n = order[i];
          part(i) *= average[second][static_cast<std::size_t>(n)];
          sum += part(i) / ((n - 1) * (n + 1)) * p(i);
        }
        singular += g.transpose() * part;
      });

  // The rate of the pressure as the load grows is g_s + h, g_s with a
  // square-root infinity at the edge; both are 0 in the equation's clearance.
  const int n = unknowns_;
  Unknowns second(n);
  system.moments.second_kind(second);
  Eigen::Matrix<double, Eigen::Dynamic, 3, 0, most_unknowns, 3> right(n, 3);
  right << -beta * std::sqrt(1 + b * b) / b * second -
               t.transpose() * singular / b,
      mean_share * system.given.constant, (1 + beta) * system.given.cosine;
  Matrix leading = system.matrix;
  detail::solve_in_place(leading, right);
  const auto& solved = right;
  Eigen::Matrix<double, 2, 3> harmonic;  // h_0, h_1 of the columns
  harmonic << b * b / pi * system.given.constant.transpose() * solved,
      2 * b * b / pi * system.given.cosine.transpose() * solved;
  const Eigen::Matrix2d factors = harmonic.rightCols<2>();
  const Eigen::Vector2d h =
      (Eigen::Matrix2d::Identity() - factors).inverse() *
      (harmonic.col(0) + factors.col(0) + 2 * first_average * factors.col(1));
  const double rate =
      (-2 * sine * sine + h(1) - 2 * h(0)) / (2 * first_average + h(1));

  const double reciprocal = solution.reciprocal;
  const double cosine = std::cos(half_angle / 2);
  const double approach =
      (2 * sum + reciprocal * sine * sine) / (cosine * cosine);
  return {approach, approach + reciprocal * rate};
}

ForcePoint PinContact::force_point(double half_angle) const noexcept {
  if (!(half_angle > 0 && half_angle <= largest_) || !wall_ ||
      loading_.is_back() || std::isnan(wall_->first)) {
    return {nan, {nan, nan}, nan};
  }
  const System system(*this, half_angle);
  const Solution solution = system.solve(unknowns_);
  const Yield yielding = yield(half_angle, system, solution);
  return {solution.reciprocal,
          {yielding.approach / solution.reciprocal, pi / 2 / yielding.rate},
          excess_of(half_angle, solution.y)};
}

detail::SignedContact PinContact::signed_contact(
    double half_angle) const noexcept {
  if (!(half_angle > 0 && half_angle <= largest_) || loading_.is_back()) {
    return {nan, nan, nan, nan, nan};
  }
  const System system(*this, half_angle);
  const Solution solution = system.solve(unknowns_);
  const Yield yielding = yield(half_angle, system, solution);
  const double inverse = solution.reciprocal / 2;
  const double first = wall_ ? wall_->first : nan;
  // P = pi rho p_1
  return {inverse, inverse + (constants_.mean_share - constants_.beta),
          1 - solution.mean, yielding.approach / 2 + inverse - first,
          yielding.rate / 2 - first};
}

int PinContact::terms() const noexcept {
  return detail::EdgeFit::terms_for(unknowns_);
}

ContactPressure PinContact::pressure(double half_angle,
                                     int terms) const noexcept {
  static const LeadingLogarithm logarithm;
  const detail::EdgeFit& fit =
      detail::EdgeFit::table(terms == 0 ? this->terms() : terms);
  if (!(half_angle > 0 && half_angle <= largest_)) return {nan, nan, {}, {}};
  const Solution solution = System(*this, half_angle).solve(unknowns_);
  const double b = std::tan(half_angle / 2);
  const detail::WideEdge edge(half_angle);
  const int count = half_angle > 2.1 || wall_ ? max_terms : usual_terms;
  const RightSides given(half_angle, constants_, loading_, count);
  const ChebyshevMoments moments(b * b, unknowns_ + count);
  // One step of iteration through the equation, whose singular part is
  // diagonal, doubles the order of the coefficients and reaches beyond the
  // unknowns.
  const Vector<max_terms> wall =
      wall_ ? wall_->sums(half_angle, solution.y, count)
            : Vector<max_terms>::Zero(count);
  std::array<double, max_terms> a;
  double slope = 0;
  double slope_of_logarithm = 0;
  for (int k = 0; k < count; ++k) {
    double right =
        solution.constant * given.constant(k) + given.load(k) - wall(k);
    for (int j = 0; j < unknowns_; ++j) {
      right -=
          constants_.beta * b * moments.matrix_element(j, k) * solution.y(j);
    }
    // p/pi because P = pi rho p_1.
    a[k] = 4 * b * right / (pi * pi * (2 * k + 1));
    slope += (2 * k + 1) * a[k];
    slope_of_logarithm += (2 * k + 1) * logarithm.coefficient[k];
  }
  // Near the edge p = slope (y + share y^3 ln y + ...) in the edge variable y
  // of this series.
  const double root = std::sqrt(edge.cosine());
  const double share =
      detail::EdgeFit::leading_logarithm(1, constants_.beta, half_angle) *
      edge.cosine();
  slope /= 1 + share * slope_of_logarithm;
  for (int k = 0; k < count; ++k) {
    a[k] -= share * slope * logarithm.coefficient[k];
  }

  detail::EdgeFit::Points values(fit.points());
  using Lanes = Eigen::Array<double, 8, 1>;
  constexpr int lanes = Lanes::SizeAtCompileTime;
  for (int i = 0; i < fit.points(); i += lanes) {
    Lanes square = fit.square.segment<lanes>(i);
    square *= edge.tangent_share(square);
    const Lanes twice = 2 - 4 * square;
    Lanes b0 = Lanes::Zero();
    Lanes b1 = Lanes::Zero();
    for (int k = count - 1; k >= 0; --k) {
      const Lanes next = twice * b0 - b1 + a[k];
      b1 = b0;
      b0 = next;
    }
    values.segment<lanes>(i) =
        square.sqrt() * (b0 + b1 + share * slope / 2 * square * square.log());
  }
  return fit(half_angle, 2 * solution.mean, values,
             detail::EdgeFit::leading_logarithm(slope / root, constants_.beta,
                                                half_angle));
}

}  // namespace contact
