#include "libcontact/conforming/layer_compliance.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "libcontact/base/constants.hpp"
#include "libcontact/conforming/kernel/ball_kernel.hpp"

// Letters as in docs/internals/conforming_methods.md. The state of a harmonic
// is y = (U, V, rS, rT); dy/d(ln r) = A y with A constant in a layer.
namespace contact::detail {
namespace {

// Balanced for large n: (U, n V, rS/(n G0), rT/G0), G0 the shear modulus of the
// surface.
using System = Eigen::Matrix4d;
using States = Eigen::Matrix<double, 4, 2>;
enum { u, v, s, t, square_row, mean_row };

// a y, summed in one order on all machines: roundings of the harmonics are the
// largest in a contact with walls, and numbers should not depend on lanes.
template <class A, class Y>
Y in_order(const A& a, const Y& y) {
  Y sum = a.col(0) * y.row(0);
  for (int k = 1; k < a.cols(); ++k) sum += a.col(k) * y.row(k);
  return sum;
}

// exp(a) y. Keeps the relative accuracy of thin layers, where closed forms
// subtract large numbers.
template <class A, class Y>
Y exponential(const A& a, Y y) {
  // |a| is 4 or so; 30 terms leave 1e-17 of exp(4).
  constexpr int terms = 30;
  Y term = y;
  for (int k = 1; k <= terms; ++k) {
    term = in_order(a, term) / k;
    y += term;
  }
  return y;
}

// Sums of two states that differ, which they hardly do after a long way.
States parted(States y) {
  for (int j = 0; j < 2; ++j) {
    int row;
    y.col(j).cwiseAbs().maxCoeff(&row);
    y.col(j) /= y(row, j);
    if (j == 0) y.col(1) -= y(row, 1) * y.col(0);
  }
  return y;
}

// <X, Y> = X_r1 Y_T2 - X_r2 Y_T1
double product(const States& x, const States& y, int row) {
  return x(row, 0) * y(t, 1) - x(row, 1) * y(t, 0);
}

}  // namespace

LayerCompliance::Elastic::Elastic(const Material& material, double unit)
    : nu(material.poissons_ratio),
      shear(material.youngs_modulus / unit / (2 * (1 + nu))),
      a(nu / (1 - nu)),
      m((1 - 2 * nu) / (2 * shear * (1 - nu))) {}

// Coefficients of one harmonic n >= 1.
struct LayerCompliance::Harmonic {
  JointKind kind;
  int n;
  double reference;  // G0
  bool ball = kind == JointKind::ball;
  double l = ball ? n * (n + 1.0) : static_cast<double>(n) * n;

  Eigen::Vector4d balance() const {
    return {1.0, 1.0 * n, 1 / (n * reference), 1 / reference};
  }

  // A, of (U, V, rS, rT).
  System plain_system(const Elastic& e) const {
    System a;
    if (ball) {
      const double g = e.shear * (1 + e.nu) / (1 - e.nu);
      a << -2 * e.a, e.a * l, e.m, 0,                   //
          -1, 1, 0, 1 / e.shear,                        //
          4 * g, -2 * g * l, 1 - 4 * e.shear * e.m, l,  //
          -2 * g, 2 * e.shear * (l / (1 - e.nu) - 1), -e.a, -2;
    } else {
      const double g = 2 * e.shear / (1 - e.nu);
      a << -e.a, e.a * l, e.m, 0,  //
          -1, 1, 0, 1 / e.shear,   //
          g, -g * l, e.a, l,       //
          -g, g * l, -e.a, -1;
    }
    return a;
  }
  System system(const Elastic& e) const {
    return balance().asDiagonal() * plain_system(e) *
           balance().cwiseInverse().asDiagonal();
  }

  // Two solutions r^k y, those that grow with r or those that decay.
  struct Modes {
    States y;
    std::array<double, 2> exponent;
  };
  Modes modes(const Elastic& e, bool growing) const {
    const double order = growing ? n : (ball ? -n - 1 : -n);  // M
    const double k = order + 1;
    const double nu = e.nu;
    Eigen::Vector4d upper;  // rS/2G and rT/G
    if (ball) {
      upper << k * (order - 2 + 4 * nu), order + 5 - 4 * nu,
          k * (order * order - order - 2 - 2 * nu), 0;
    } else {
      upper << order - 2 + 4 * nu, (order + 4 - 4 * nu) / order,
          k * (order - 2), 0;
    }
    upper(t) = (k - 1) * upper(v) + upper(u);
    Eigen::Vector4d lower(order, 1, order * (order - 1), 2 * (order - 1));
    Modes result;
    result.y << upper / (ball ? 1.0 * n * n : 1.0 * n), lower / n;
    result.y.row(s) *= 2 * e.shear;
    result.y.row(t) *= e.shear;
    result.y = (balance().asDiagonal() * result.y).eval();
    result.exponent = {k, order - 1};
    return result;
  }

  // A layer that these modes can cross: exp(2 n width) must be large enough
  // for their amplitudes to lose nothing that counts. The pin's n = 1 has a
  // double exponent.
  bool crossed_by_modes(const Shell& shell) const {
    return n * shell.width >= 4 && (ball || n > 1);
  }

  // The wall's states at a layer's near side by those at its far side: regular
  // modes, and the share of the others that the far end adds to them.
  struct Crossing {
    States regular;
    States added;
  };
  Crossing cross(const Shell& shell, Side side, const States& far) const {
    const bool inner = side == Side::inner;
    const Modes regular = modes(shell.elastic, inner);
    const Modes other = modes(shell.elastic, !inner);
    System all;
    all << regular.y, other.y;
    const States amplitude = all.partialPivLu().solve(far);
    Eigen::Matrix2d ratio =
        amplitude.bottomRows<2>() * amplitude.topRows<2>().inverse();
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        ratio(i, j) *= std::exp(
            -shell.width * std::abs(other.exponent[i] - regular.exponent[j]));
      }
    }
    return {regular.y, other.y * ratio};
  }

  States advance(const Shell& shell, Side side, const States& far) const {
    States near;
    if (crossed_by_modes(shell)) {
      const Crossing c = cross(shell, side, far);
      near = c.regular + c.added;
    } else {
      // States grow like exp(n width), the more alike the further.
      const int pieces = 1 + static_cast<int>(n * shell.width);
      const double width = side == Side::inner ? shell.width : -shell.width;
      const System step =
          exponential(System(system(shell.elastic) * (width / pieces)),
                      System(System::Identity()));
      near = far;
      for (int i = 0; i < pieces; ++i) near = parted(in_order(step, near));
    }
    for (int j = 0; j < 2; ++j)
      near.col(j) /= near.col(j).lpNorm<Eigen::Infinity>();
    return near;
  }
};

LayerCompliance::LayerCompliance(JointKind kind, Side side,
                                 const LayeredPair& pair)
    : LayerCompliance(kind, side,
                      side == Side::inner ? pair.inner() : pair.outer(),
                      pair.radius(), pair.surfaces().effective_modulus()) {}

LayerCompliance::LayerCompliance(JointKind kind, Side side,
                                 const LayeredBody& body, double radius,
                                 double modulus)
    : kind_(kind), side_(side), backing_(body.backing.kind()) {
  const double sign = side == Side::inner ? -1 : 1;
  for (const Layer& layer : body.layers) {
    const double step = sign * layer.thickness / radius;
    shells_.push_back({Elastic(layer.material, modulus),
                       std::abs(std::log1p(step / medium_radius_))});
    medium_radius_ += step;
  }
  if (backing_ == Backing::Kind::medium) {
    medium_.emplace(body.backing.material(), modulus);
  }
  if (shells_.empty() && !medium_) return;  // rigid
  const Elastic& surface = shells_.empty() ? *medium_ : shells_.front().elastic;
  poisson_ = surface.nu;
  share_ = (1 - poisson_) / (4 * surface.shear);
}

int LayerCompliance::corrected() const {
  if (shells_.empty()) return 0;
  // Dc_n/c_n is 4 x^2 exp(-2 x) or so, x = n width. By measurement: with 13 the
  // loads of pins are good to 1e-10, but loads of balls on a nearly
  // incompressible thin liner to 1e-5 only.
  const double last = kind_ == JointKind::ball ? 18 : 13;
  return std::max(3, static_cast<int>(last / shells_.front().width) + 1);
}

HarmonicCompliance LayerCompliance::operator()(int n) const {
  if (shells_.empty()) return {homogeneous(n), 0};
  if (n == 0) {
    const double total = mean();
    return {total, total - homogeneous(0)};
  }
  if (n > 1) return layered(n);
  const bool inner = side_ == Side::inner;
  if (inner && backing_ == Backing::Kind::medium) return {body_force(), 0};
  const bool nothing_holds_it = inner ? backing_ == Backing::Kind::held
                                      : medium_ && kind_ == JointKind::pin;
  return {nothing_holds_it ? nan : layered(1).total, 0};
}

// s_n, e_n of docs/explanation/conforming.md; n = 1 of an inner body: a uniform
// body force, and the displacement relative to the mean over the volume.
double LayerCompliance::homogeneous(int n) const {
  if (shells_.empty() && !medium_) return 0;
  const double nu = poisson_;
  const double k = (1 - 2 * nu) / (2 * (1 - nu));
  const bool inner = side_ == Side::inner;
  if (kind_ == JointKind::ball) {
    if (inner && n == 1) return share_ * 0.6 * k / (1 + nu);
    return share_ * (inner ? ball_compliance(n, nu) : cavity_compliance(n, nu));
  }
  if (n == 1) return inner ? share_ * k / 2 : nan;
  if (n == 0) return share_ * (inner ? k : 1 - k);
  return share_ * (inner ? n - k : n + k) / ((n - 1.0) * (n + 1.0));
}

// n = 0 has (U, rS) alone. What the far end allows.
Eigen::Vector2d LayerCompliance::admissible_mean() const {
  if (medium_) {
    const double nu = medium_->nu;
    const double g2 = 2 * medium_->shear;
    const bool ball = kind_ == JointKind::ball;
    if (side_ == Side::outer) return {1, ball ? -2 * g2 : -g2};
    return {1 - 2 * nu, g2 * (1 - 2 * nu + nu * (ball ? 3 : 2))};
  }
  if (backing_ == Backing::Kind::held) return {1, 0};
  return {0, 1};
}

// From the far side of a layer to its near side, by the exponents 1 and -2
// (ball) or -1 (pin).
Eigen::Vector2d LayerCompliance::cross_mean(const Shell& shell,
                                            Eigen::Vector2d y) const {
  const bool ball = kind_ == JointKind::ball;
  const double upper = 1;
  const double lower = ball ? -2 : -1;
  const Elastic& e = shell.elastic;
  Eigen::Matrix2d b;
  if (ball) {
    b << -2 * e.a, e.m,  //
        4 * e.shear * (1 + e.nu) / (1 - e.nu), 1 - 4 * e.shear * e.m;
  } else {
    b << -e.a, e.m,  //
        2 * e.shear / (1 - e.nu), e.a;
  }
  const double x = side_ == Side::inner ? shell.width : -shell.width;
  const double factor =
      std::exp(lower * x) * std::expm1((upper - lower) * x) / (upper - lower);
  return std::exp(upper * x) * y + factor * (b * y - upper * y);
}

double LayerCompliance::mean() const {
  Eigen::Vector2d y = admissible_mean();
  for (auto shell = shells_.rbegin(); shell != shells_.rend(); ++shell) {
    y = cross_mean(*shell, y);
  }
  return (side_ == Side::inner ? 1 : -1) * y(0) / y(1) / 4;
}

// W = U - e* r has the equations of U without growth; U and S are continuous,
// and S is 0 at the surface.
double LayerCompliance::free_growth(std::span<const double> layers,
                                    double behind) const {
  double radius = medium_radius_;
  Eigen::Vector2d free = admissible_mean();
  Eigen::Vector2d grown(
      backing_ == Backing::Kind::held ? 0 : behind * medium_radius_, 0);
  for (std::size_t i = shells_.size(); i-- > 0;) {
    grown(0) -= layers[i] * radius;
    grown = cross_mean(shells_[i], grown);
    free = cross_mean(shells_[i], free);
    radius *= std::exp((side_ == Side::inner ? 1 : -1) * shells_[i].width);
    grown(0) += layers[i] * radius;
  }
  return grown(0) - grown(1) / free(1) * free(0);
}

// The infinite hole of a pin, n = 1: r^-2, and a line force, whose displacement
// is counted against 10 radii.
LayerCompliance::States LayerCompliance::line_force(
    const Harmonic& harmonic) const {
  const double k = 3 - 4 * medium_->nu;
  const double l = std::log(medium_radius_ / 10);
  const double g2 = 2 * medium_->shear;
  States y;
  y.col(0) << -k * l + 1, -k * l, -g2 * (k + 2 * medium_->nu),
      -g2 * (1 - 2 * medium_->nu);
  y.col(1) << -1, 1, 2 * g2, -2 * g2;
  return harmonic.balance().asDiagonal() * y;
}

// The two states that the far end allows.
LayerCompliance::States LayerCompliance::far_end(
    const Harmonic& harmonic) const {
  States y = States::Zero();
  if (medium_ && kind_ == JointKind::pin && harmonic.n == 1) {
    y = line_force(harmonic);
  } else if (medium_) {
    y = harmonic.modes(*medium_, side_ == Side::inner).y;
  } else if (backing_ == Backing::Kind::rigid) {
    y(s, 0) = y(t, 1) = 1;
  } else if (harmonic.n == 1) {
    // Held: no displacement along the normal, no shear.
    y(v, 0) = y(s, 1) = 1;
  } else {
    y(u, 0) = y(v, 1) = 1;
  }
  return y;
}

// From the far end to the contact, and there the state without shear.
HarmonicCompliance LayerCompliance::layered(int n) const {
  const Shell& surface = shells_.front();
  const Harmonic harmonic{kind_, n, surface.elastic.shear};
  const double sign =
      (side_ == Side::inner ? 1 : -1) / (4 * n * harmonic.reference);
  States y = far_end(harmonic);
  for (std::size_t i = shells_.size() - 1; i > 0; --i) {
    y = harmonic.advance(shells_[i], side_, y);
  }
  if (n == 1 || !harmonic.crossed_by_modes(surface)) {
    y = harmonic.advance(surface, side_, y);
    const double total = sign * product(y, y, u) / product(y, y, s);
    return {total, n == 1 ? 0 : total - homogeneous(n)};
  }
  // The correction itself: as a difference it would leave 1e-13/n of noise in
  // thousands of harmonics.
  const Harmonic::Crossing crossing = harmonic.cross(surface, side_, y);
  const States& d = crossing.regular;
  const States& p = crossing.added;
  const auto change = [&](int row) {
    return product(d, p, row) + product(p, d, row) + product(p, p, row);
  };
  const double n0 = product(d, d, u);
  const double m0 = product(d, d, s);
  const double correction =
      sign * (change(u) - n0 / m0 * change(s)) / (m0 + change(s));
  return {homogeneous(n) + correction, correction};
}

// n = 1 of a solid inner body: a pressure cos t, balanced by a uniform body
// force of size 1/rho, which a row r^2 carries; the last is the mean over the
// volume within r of the displacement along the force, over the dimension.
// The regular solution, a translation, the particular solution.
Eigen::Matrix<double, 6, 3> LayerCompliance::body_columns() const {
  const bool ball = kind_ == JointKind::ball;
  const double dimension = ball ? 3 : 2;
  const Harmonic harmonic{kind_, 1, 1};
  const Elastic& e = *medium_;
  const double square = medium_radius_ * medium_radius_;
  const double g = e.shear;
  Eigen::Matrix<double, 6, 3> y = Eigen::Matrix<double, 6, 3>::Zero();
  if (ball) {
    y.col(0) << -2 + 8 * e.nu, 6 - 4 * e.nu, -8 * g * (1 + e.nu),
        4 * g * (1 + e.nu), 0, 0;
    y.col(2) << -0.3 * e.m, -0.1 * e.m, -(0.6 + 0.4 * e.a), -0.4 * g * e.m, 1,
        0;
  } else {
    y.col(0) << -1 + 4 * e.nu, 5 - 4 * e.nu, -4 * g, 4 * g, 0, 0;
    y.col(2) << -0.375 * e.m, -0.125 * e.m, -(0.75 + 0.25 * e.a),
        -0.5 * g * e.m, 1, 0;
  }
  y *= square;
  y.col(1) << 1, 1, 0, 0, 0, 0;
  const auto along = [&](int column) {
    return (y(u, column) + (dimension - 1) * y(v, column)) / dimension;
  };
  for (const int column : {0, 2})
    y(mean_row, column) = along(column) / (dimension + 2);
  y(mean_row, 1) = 1 / dimension;
  for (auto shell = shells_.rbegin(); shell != shells_.rend(); ++shell) {
    Eigen::Matrix<double, 6, 6> a = Eigen::Matrix<double, 6, 6>::Zero();
    a.topLeftCorner<4, 4>() = harmonic.plain_system(shell->elastic);
    a(s, square_row) = a(t, square_row) = -1;
    a(square_row, square_row) = 2;
    a(mean_row, u) = 1 / dimension;
    a(mean_row, v) = (dimension - 1) / dimension;
    a(mean_row, mean_row) = -dimension;
    const int pieces = 1 + static_cast<int>(shell->width);
    a *= shell->width / pieces;
    for (int i = 0; i < pieces; ++i) y = exponential(a, y);
  }
  return y;
}

double LayerCompliance::body_force() const {
  if (shells_.empty()) return homogeneous(1);
  const Eigen::Matrix<double, 6, 3> y = body_columns();
  const double dimension = kind_ == JointKind::ball ? 3 : 2;
  const double regular = -y(t, 2) / y(t, 0);
  const double translation =
      -dimension * (regular * y(mean_row, 0) + y(mean_row, 2));
  return -(regular * y(u, 0) + y(u, 2) + translation) / 4;
}

Eigen::Matrix2d LayerCompliance::spheroidal(int n) const {
  if (shells_.empty() && !medium_) return Eigen::Matrix2d::Zero();
  const bool inner = side_ == Side::inner;
  if (n == 1 && inner && medium_) {
    const Eigen::Matrix<double, 6, 3> y = body_columns();
    const double dimension = kind_ == JointKind::ball ? 3 : 2;
    Eigen::Matrix2d displacement;
    Eigen::Matrix2d traction;
    for (const int i : {0, 1}) {
      const auto of = y.col(2 * i);
      traction.col(i) << of(s), of(t);
      displacement.col(i).setConstant(-dimension *
                                      of(mean_row));  // translation
      displacement.col(i) += of.head<2>();
    }
    return displacement * traction.inverse();
  }
  const double shear =
      shells_.empty() ? medium_->shear : shells_.front().elastic.shear;
  const Harmonic harmonic{kind_, n, shear};
  States y = far_end(harmonic);
  for (auto shell = shells_.rbegin(); shell != shells_.rend(); ++shell) {
    y = harmonic.advance(*shell, side_, y);
  }
  const Eigen::Vector4d unit = harmonic.balance().cwiseInverse();
  const Eigen::Matrix2d c = unit.head<2>().asDiagonal() * y.topRows<2>() *
                            y.bottomRows<2>().inverse() *
                            unit.tail<2>().cwiseInverse().asDiagonal();
  return inner ? c : -c;
}

// W = d r^own + g r^other, rQ = G (k - 1) W for r^k; amplitudes at the far
// side.
double LayerCompliance::toroidal(int n) const {
  if (shells_.empty() && !medium_) return 0;
  const bool ball = kind_ == JointKind::ball;
  const bool inner = side_ == Side::inner;
  const bool turns = ball ? n == 1 : true;
  if (turns && inner && medium_) return turn_of_body();
  const double growing = ball ? n : 1;
  const double decaying = ball ? -n - 1 : -1;
  const double own = inner ? growing : decaying;
  const double other = inner ? decaying : growing;
  double w = 1;
  double rq = 0;
  if (medium_) {
    rq = medium_->shear * (own - 1);
  } else if (backing_ == Backing::Kind::rigid || turns) {
    w = 0;  // a held body by its outer surface
    rq = 1;
  }
  for (auto shell = shells_.rbegin(); shell != shells_.rend(); ++shell) {
    const double g = shell->elastic.shear;
    const double q_own = g * (own - 1);
    const double q_other = g * (other - 1);
    const double regular = (q_other * w - rq) / (q_other - q_own);
    const double added = (rq - q_own * w) / (q_other - q_own) *
                         std::exp(-shell->width * std::abs(own - other));
    w = regular + added;
    rq = regular * q_own + added * q_other;
  }
  return (inner ? w : -w) / rq;
}

// A torque through the surface that an angular acceleration balances: the turn
// W/r grows by Q r/G, Q in proportion to r^2; its mean over the moment of
// inertia.
double LayerCompliance::turn_of_body() const {
  const double power = kind_ == JointKind::ball ? 7 : 6;
  double radius = medium_radius_;
  double within = std::pow(radius, power);
  double sum = within / medium_->shear;
  for (auto shell = shells_.rbegin(); shell != shells_.rend(); ++shell) {
    radius *= std::exp(shell->width);
    const double to = std::pow(radius, power);
    sum += (to - within) / shell->elastic.shear;
    within = to;
  }
  return sum / power;
}

}  // namespace contact::detail
