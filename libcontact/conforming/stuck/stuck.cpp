#include "libcontact/conforming/stuck/stuck.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <vector>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/base/linear/solve.hpp"
#include "libcontact/conforming/layer_compliance.hpp"

// Stresses are series of few terms that have the square-root edge of the stuck
// contact; the bodies' compliances act on their moments with the harmonics.
// A a = B (motions), stiffness B^T A^-1 B.
namespace contact::detail {
namespace {

using Eigen::Array4d;
using Eigen::ArrayXd;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Side = LayerCompliance::Side;

struct Size {
  int terms;
  int harmonics;
};

// Measured: half of N theta0 changes the stiffness by 1e-4, at 87 by 1e-3; more
// terms, which thin layers need, take more harmonics.
Size size_of(const LayeredPair& pair, double half_angle) {
  const double thin = pair.relative_thickness() / half_angle;
  const int terms = thin < 0.04 ? 18 : thin < 0.3 ? 14 : 12;
  return {terms, static_cast<int>(
                     std::max((thin < 0.04 ? 600 : 300) / half_angle, 64.0))};
}

// Harmonics 1 to N. Where this is accurate enough, one harmonic represents its
// neighbours on either side: moments go round once in pi/theta0 harmonics,
// compliances change with log n.
struct Harmonics {
  ArrayXd n;
  ArrayXd weight;  // harmonics for which it stands
  int last;

  Harmonics(int least, double half_angle) {
    std::vector<double> numbers;
    std::vector<double> weights;
    int first = 1;
    while (first <= least) {
      const int aside =
          static_cast<int>(std::min(first / 96.0, 0.2 / half_angle));
      numbers.push_back(first + aside);
      weights.push_back(1 + 2 * aside);
      first += 1 + 2 * aside;
    }
    last = first - 1;
    n = Eigen::Map<ArrayXd>(numbers.data(), std::ssize(numbers));
    weight = Eigen::Map<ArrayXd>(weights.data(), std::ssize(weights));
  }
  Eigen::Index count() const { return n.size(); }
};

// Compliances of both bodies, times their weight, harmonics in columns: of
// (U, n V) to (S, n T), and of the toroidal ones. Of the moments with harmonics
// beyond N the squares have means that fall as 1/n: sums of C_n/n.
struct Compliances {
  ArrayXd normal;      // C11
  ArrayXd cross;       // C12
  ArrayXd tangential;  // C22
  ArrayXd toroidal;    // W; of pins n = 0 alone
  struct {
    double normal, tangential, toroidal;
  } beyond = {};

  Compliances(JointKind kind, const LayeredPair& pair,
              const Harmonics& harmonics)
      : normal(harmonics.count()),
        cross(harmonics.count()),
        tangential(harmonics.count()),
        toroidal(harmonics.count()) {
    const LayerCompliance inner(kind, Side::inner, pair);
    const LayerCompliance outer(kind, Side::outer, pair);
    const auto around = [&](int n) {
      return inner.toroidal(n) + outer.toroidal(n);
    };
    const bool ball = kind == JointKind::ball;
    const auto at = [&](int n) -> Array4d {
      const Matrix2d c = inner.spheroidal(n) + outer.spheroidal(n);
      return {c(0, 0), c(0, 1), c(1, 1), ball ? around(n) : 0};
    };
    for (Eigen::Index i = 0; i < harmonics.count(); ++i) {
      const Array4d c =
          harmonics.weight(i) * at(static_cast<int>(harmonics.n(i)));
      normal(i) = c(0);
      cross(i) = c(1);
      tangential(i) = c(2);
      toroidal(i) = c(3);
    }
    if (!ball) toroidal(0) = around(0);
    // C_n is smooth, some of each octave do; beyond the layers it is as 1/n.
    const double layers = 24 / pair.relative_thickness();
    Array4d sum = Array4d::Zero();
    double from = harmonics.last + 0.5;
    while (from < layers) {
      const double to = std::ceil(from * 17 / 16) + 0.5;
      sum += std::log(to / from) * at(static_cast<int>((from + to) / 2));
      from = to;
    }
    sum += (1 + 0.5 / from) * at(static_cast<int>(from + 0.5));
    beyond = {sum(0), sum(2), sum(3)};
  }
};

// Moments of the stresses of a contact, a row for each term.
struct Moments {
  MatrixXd normal;      // with the harmonics of sigma
  MatrixXd tangential;  // the shear along t
  MatrixXd toroidal;    // the shear around
};

// J_0 to J_last of x: upwards where that is stable.
VectorXd bessel(int last, double x) {
  using boost::math::cyl_bessel_j;
  VectorXd j(last + 1);
  for (int k = 0; k <= last; ++k) {
    j(k) = k < 2 || x < last ? cyl_bessel_j(k, x)
                             : 2 * (k - 1) / x * j(k - 1) - j(k - 2);
  }
  return j;
}

double stiffness_of(const MatrixXd& a, const VectorXd& b) {
  return b.dot(solve_symmetric(a, b).col(0));
}

// A and B of a contact, and how many of its unknowns are of sigma.
struct Equations {
  MatrixXd a;
  MatrixXd b;
  int terms = 0;
};

// sigma = T_(2k+1)(s)/sqrt(1 - s^2), tau = T_2k(s)/sqrt(1 - s^2), s = t/theta0.
struct Pin : Equations {
  Pin(const LayeredPair& pair, double half_angle) {
    const Size size = size_of(pair, half_angle);
    const Harmonics harmonics(size.harmonics, half_angle);
    const Compliances c(JointKind::pin, pair, harmonics);
    const ArrayXd& n = harmonics.n;
    terms = size.terms;
    MatrixXd odd(terms, n.size());
    MatrixXd even(terms, n.size());
    for (Eigen::Index i = 0; i < n.size(); ++i) {
      const VectorXd j = bessel(2 * terms - 1, n(i) * half_angle);
      for (int k = 0; k < terms; ++k) {
        const double sign = k % 2 == 0 ? half_angle : -half_angle;
        even(k, i) = sign * j(2 * k);
        odd(k, i) = sign * j(2 * k + 1);
      }
    }
    // n V = n C21 S + C22 n T, and n C21 = C12/n.
    const VectorXd normal = pi * c.normal;
    const VectorXd cross = pi * c.cross / n;
    const VectorXd tangential = pi * c.tangential;
    VectorXd turn = VectorXd::Zero(terms);
    turn(0) = half_angle / 2;
    // Means of the products of Bessel functions, over 1/n.
    const MatrixXd tail = MatrixXd::Constant(terms, terms, half_angle);
    a.resize(2 * terms, 2 * terms);
    a.topLeftCorner(terms, terms) =
        odd * normal.asDiagonal() * odd.transpose() + c.beyond.normal * tail;
    a.topRightCorner(terms, terms) =
        odd * cross.asDiagonal() * even.transpose();
    a.bottomLeftCorner(terms, terms) =
        a.topRightCorner(terms, terms).transpose();
    a.bottomRightCorner(terms, terms) =
        even * tangential.asDiagonal() * even.transpose() +
        2 * pi * c.toroidal(0) * turn * turn.transpose() +
        c.beyond.tangential * tail;
    b = MatrixXd::Zero(2 * terms, 2);
    b.col(0) << pi * odd.col(0), pi * even.col(0);
    b.col(1).tail(terms) = 2 * pi * turn;
  }
};

// The nodes of the moments of a ball's stresses: x = sin(t/2)/sin(theta0/2),
// c = sqrt(1 - x^2) on [0, 1], sin t dt/sqrt(1 - x^2) = 4 sin^2(theta0/2) dc.
struct CapNodes {
  ArrayXd cosine;  // cos t
  ArrayXd sine;
  MatrixXd normal;  // terms by nodes: x P_2k(c) with the weight
  MatrixXd plus;    // P_2k(c)
  MatrixXd minus;   // x^2 P_2k(c)

  CapNodes(double half_angle, const Size& size) {
    const int nodes =
        static_cast<int>(size.harmonics * half_angle / 2 + 4 * size.terms + 60);
    const GaussLegendre rule(2 * nodes);
    const ArrayXd c = rule.node.tail(nodes);
    const ArrayXd x = (1 - c * c).sqrt();
    const double s0 = std::sin(half_angle / 2);
    const ArrayXd half = s0 * x;
    cosine = 1 - 2 * half * half;
    sine = 2 * half * (1 - half * half).sqrt();
    const ArrayXd weight = 4 * s0 * s0 * rule.weight.tail(nodes).array();
    plus = (even_legendre(size.terms, c).array().colwise() * weight)
               .matrix()
               .transpose();
    normal = plus * x.matrix().asDiagonal();
    minus = normal * x.matrix().asDiagonal();
  }
};

// P_n^1/sin t at the nodes, normalised, upwards from n = 1.
class Recurrence {
 public:
  explicit Recurrence(Eigen::Index points)
      : value(ArrayXd::Constant(points, std::sqrt(3.0) / 2)),
        before(ArrayXd::Zero(points)) {}

  double n = 1;
  ArrayXd value;
  ArrayXd before;  // value at n - 1

  void step(const ArrayXd& cosine) {
    const double square = n * n;
    const double next = (n + 1) * (n + 1);
    const double up = std::sqrt((4 * next - 1) / (next - 1));
    const double down = n == 1 ? 0
                               : std::sqrt((2 * n + 3) * (square - 1) /
                                           ((2 * n - 1) * (next - 1)));
    before = up * cosine * value - down * before;
    before.swap(value);
    ++n;
  }
  ArrayXd derivative(const ArrayXd& cosine) const {
    const double slope = std::sqrt((2 * n + 1) / (2 * n - 1) * (n * n - 1));
    return n * cosine * value - slope * before;
  }
};

// Moments with the normalised P_n^1, blocks of harmonics at a time.
Moments ball_moments(const CapNodes& nodes, int terms,
                     const Harmonics& harmonics) {
  constexpr Eigen::Index block = 64;
  const Eigen::Index count = harmonics.count();
  const Eigen::Index points = nodes.cosine.size();
  MatrixXd value(points, block);
  MatrixXd sum(points, block);  // the derivative and P/sin t
  MatrixXd difference(points, block);
  Moments m{MatrixXd(terms, count), MatrixXd(terms, count),
            MatrixXd(terms, count)};
  Recurrence p(points);
  for (Eigen::Index first = 0; first < count; first += block) {
    const Eigen::Index width = std::min(block, count - first);
    for (Eigen::Index i = 0; i < width; ++i) {
      while (p.n < harmonics.n(first + i)) p.step(nodes.cosine);
      const ArrayXd derivative = p.derivative(nodes.cosine);
      value.col(i) = nodes.sine * p.value;
      sum.col(i) = derivative + p.value;
      difference.col(i) = derivative - p.value;
    }
    const auto at = [&](MatrixXd& to) { return to.middleCols(first, width); };
    at(m.normal).noalias() = nodes.normal * value.leftCols(width);
    at(m.tangential).noalias() = nodes.plus * sum.leftCols(width);
    at(m.toroidal).noalias() = nodes.minus * difference.leftCols(width);
  }
  return m;
}

// sigma = x P_2k(c)/c, tau_t + tau_phi = P_2k(c)/c, tau_t - tau_phi =
// x^2 P_2k(c)/c.
struct Ball : Equations {
  MatrixXd spin_a;
  VectorXd spin_b;

  Ball(const LayeredPair& pair, double half_angle) {
    const Size size = size_of(pair, half_angle);
    const Harmonics harmonics(size.harmonics, half_angle);
    const Compliances c(JointKind::ball, pair, harmonics);
    const CapNodes nodes(half_angle, size);
    terms = size.terms;
    const Moments m = ball_moments(nodes, terms, harmonics);
    const ArrayXd l = harmonics.n * (harmonics.n + 1);
    MatrixXd t(2 * terms, harmonics.count());
    t << m.tangential / 2, m.toroidal / 2;
    MatrixXd q = t;
    q.bottomRows(terms) *= -1;
    // Stresses at the edge, and the mean of the squares of P_n^1 there.
    const ArrayXd edge =
        even_legendre(terms, VectorXd::Zero(1)).row(0).transpose().array() *
        std::sqrt(std::tan(half_angle / 2));
    const MatrixXd tail =
        edge.matrix() * edge.matrix().transpose() * std::sin(half_angle);
    const auto product = [](const MatrixXd& x, const ArrayXd& w,
                            const MatrixXd& y) -> MatrixXd {
      return x * w.matrix().asDiagonal() * y.transpose();
    };
    a.resize(3 * terms, 3 * terms);
    a.topLeftCorner(terms, terms) =
        product(m.normal, c.normal, m.normal) + c.beyond.normal * tail;
    a.topRightCorner(terms, 2 * terms) = product(m.normal, c.cross / l, t);
    a.bottomLeftCorner(2 * terms, terms) =
        a.topRightCorner(terms, 2 * terms).transpose();
    auto shear = a.bottomRightCorner(2 * terms, 2 * terms);
    shear = product(t, c.tangential / l, t) + product(q, c.toroidal / l, q);
    const double same = (c.beyond.tangential + c.beyond.toroidal) / 4;
    const double mixed = (c.beyond.tangential - c.beyond.toroidal) / 4;
    shear.topLeftCorner(terms, terms) += same * tail;
    shear.bottomRightCorner(terms, terms) += same * tail;
    shear.topRightCorner(terms, terms) += mixed * tail;
    shear.bottomLeftCorner(terms, terms) += mixed * tail;
    const VectorXd z = nodes.cosine;
    const VectorXd s = nodes.sine;
    const VectorXd one = VectorXd::Ones(z.size());
    b = MatrixXd::Zero(3 * terms, 2);
    b.col(0) << nodes.normal * s, nodes.plus * (z + one) / 2,
        nodes.minus * (z - one) / 2;
    b.col(1).tail(2 * terms) << nodes.plus * (one + z) / 2,
        nodes.minus * (one - z) / 2;
    spin_a = product(m.normal, c.toroidal, m.normal) + c.beyond.toroidal * tail;
    spin_b = nodes.normal * s;
  }
};

}  // namespace

StuckStiffness stuck_stiffness(JointKind kind, const LayeredPair& pair,
                               double half_angle) {
  const bool is_known = half_angle >= narrowest_stuck &&
                        half_angle <= widest_stuck &&
                        pair.relative_thickness() >= thinnest_stuck;
  if (!is_known) return {nan, nan, nan, nan, nan};
  const auto of = [](const Equations& contact, double unit, double spin) {
    const int k = contact.terms;
    const Matrix2d all =
        contact.b.transpose() * solve_symmetric(contact.a, contact.b);
    return StuckStiffness{unit * all(0, 0), unit * all(0, 1), unit * all(1, 1),
                          spin,
                          unit * stiffness_of(contact.a.topLeftCorner(k, k),
                                              contact.b.col(0).head(k))};
  };
  if (kind == JointKind::pin) return of(Pin(pair, half_angle), 1, nan);
  const Ball ball(pair, half_angle);
  return of(ball, pi, 2 * pi * stiffness_of(ball.spin_a, ball.spin_b));
}

}  // namespace contact::detail
