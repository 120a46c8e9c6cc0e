#include "libcontact/tools/reference/friction_rules.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>

#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/friction/kernel/cap_rule.hpp"

namespace contact::reference {
namespace {

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                  boost::multiprecision::et_off>;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

const Real half_pi = boost::math::constants::half_pi<Real>();

struct Node {
  Real cosine, weight;
  Real log_cosine_squared = 0;
};

RuleNodes rounded(const std::vector<Node>& nodes) {
  RuleNodes result;
  for (const Node& n : nodes) {
    const Real square = n.cosine * n.cosine;
    result.push_back({static_cast<double>(square),
                      static_cast<double>(Real(1 - square)),
                      static_cast<double>(n.weight),
                      static_cast<double>(n.log_cosine_squared)});
  }
  return result;
}

class Modulus {
 public:
  explicit Modulus(int index) {
    const Real lower = detail::cap_rule_ends[index];
    const Real upper = index == 0 ? 1 : detail::cap_rule_ends[index - 1];
    m = lower + 3 * (upper - lower) / 20;
    Real kc = sqrt(m);
    do {
      moduli_.push_back((1 - kc) / (1 + kc));
      kc = 2 * sqrt(kc) / (1 + kc);
      scale_ *= 1 + moduli_.back();
    } while (moduli_.back() > 1e-25);
  }
  Real quarter_period() const { return half_pi * scale_; }

  /// cn and dn du.
  Node node(const Real& u, const Real& du) const {
    Real s = sin(u / scale_);
    Real c = cos(u / scale_);
    Real d = 1;
    for (auto k = moduli_.rbegin(); k != moduli_.rend(); ++k) {
      const Real part = *k * s * s;
      c *= d / (1 + part);
      d = (1 - part) / (1 + part);
      s *= (1 + *k) / (1 + part);
    }
    return {c, d * du};
  }
  Node chord_node(const Real& u, const Real& du) const {
    const Node n = node(u, du);
    return {n.cosine, n.weight * n.cosine};
  }

  Real m;  // k'^2

 private:
  std::vector<Real> moduli_;
  Real scale_ = 1;
};

/// The upper half of a Gauss rule: two of Newton's steps from doubles.
struct HalfGauss {
  explicit HalfGauss(int n) {
    const detail::GaussLegendre start(2 * n);
    for (int i = n; i < 2 * n; ++i) {
      Real v = start.node(i);
      Real before, at;
      for (int evaluation = 0; evaluation < 3; ++evaluation) {
        before = 1;
        at = v;
        for (int j = 2; j <= 2 * n; ++j) {
          const Real next = ((2 * j - 1) * v * at - (j - 1) * before) / j;
          before = at;
          at = next;
        }
        if (evaluation < 2) v -= at * (1 - v * v) / (2 * n * before);
      }
      x.push_back(v);
      weight.push_back(2 * (1 - v * v) / pow(2 * n * before, 2));
    }
  }
  std::vector<Real> x, weight;
};

/// Corrections of the last ln T, seven at most, with which sum weight T^j ln T
/// is moment(j) for j = 2, 3, ...
template <class Moment>
std::vector<Real> corrections(const std::vector<Real>& t,
                              const std::vector<Real>& weight, Moment moment) {
  const int n = static_cast<int>(t.size());
  const int count = std::min(7, n - 1);
  Matrix powers(count, count);
  Vector missing(count);
  for (int row = 0; row < count; ++row) {
    missing[row] = moment(row + 2);
    for (int i = 0; i < n; ++i) {
      const Real value = weight[i] * pow(t[i], row + 2);
      missing[row] -= value * log(t[i]);
      if (i >= n - count) powers(row, i - n + count) = value;
    }
  }
  const Vector found = powers.partialPivLu().solve(missing);
  std::vector<Real> result(n - count, Real(0));
  result.insert(result.end(), found.begin(), found.end());
  return result;
}

/// The derivative of B(x, y)/2 with respect to the one of x and y that is given
/// once more.
Real log_moment(const Real& x, const Real& y, const Real& differentiated) {
  using boost::math::digamma;
  return boost::math::beta(x, y) / 2 *
         (digamma(differentiated) - digamma(Real(x + y)));
}

}  // namespace

RuleNodes midpoint_rule(int index, int size) {
  const Modulus modulus(index);
  const Real step = modulus.quarter_period() / size;
  std::vector<Node> nodes;
  for (int i = 0; i < size; ++i) {
    nodes.push_back(modulus.node(step * (2 * i + 1) / 2, step));
  }
  return rounded(nodes);
}

RuleNodes arc_rule(int index, int size) {
  const Modulus modulus(index);
  const Real steps = size + Real(1) / 2;
  const Real half = Real(1) / 2;
  std::vector<Real> t, weight(size, half_pi / steps);
  for (int i = 0; i < size; ++i) {
    t.push_back(pow(cos(half_pi * (i + half) / steps), 2));
  }
  const auto more = corrections(
      t, weight, [&](int j) { return log_moment(j + half, half, j + half); });
  std::vector<Node> nodes;
  const Real step = modulus.quarter_period() / steps;
  for (int i = 0; i < size; ++i) {
    Node node = modulus.node(step * (i + half), step);
    node.weight *= node.cosine * node.cosine;
    node.log_cosine_squared = 2 * log(node.cosine) + more[i];
    nodes.push_back(node);
  }
  return rounded(nodes);
}

RuleNodes chord_rule(int index, int size) {
  const Modulus modulus(index);
  const Real k = modulus.quarter_period();
  const HalfGauss gauss(size);
  std::vector<Node> nodes;
  // sn u where k'^2 > 0.5, u elsewhere: whichever converges faster.
  if (modulus.m < 0.5) {
    for (int i = 0; i < size; ++i) {
      Node node = modulus.chord_node(k * gauss.x[i], k * gauss.weight[i]);
      node.log_cosine_squared = 2 * log(node.cosine);
      nodes.push_back(node);
    }
    return rounded(nodes);
  }
  std::vector<Real> t;
  for (const Real& x : gauss.x) t.push_back(1 - x * x);
  const auto more = corrections(t, gauss.weight, [](int j) {
    return log_moment(Real(1) / 2, j + 1, j + 1);
  });
  for (int i = 0; i < size; ++i) {
    nodes.push_back({sqrt(t[i]), gauss.weight[i], log(t[i]) + more[i]});
  }
  return rounded(nodes);
}

RuleNodes whole_chord_rule(int index, int size) {
  const Modulus modulus(index);
  const Real k = modulus.quarter_period();
  const HalfGauss gauss(size);
  std::vector<Node> nodes;
  for (int i = 0; i < size; ++i) {
    const Real& x = gauss.x[i];
    nodes.push_back(modulus.chord_node(
        k * x * (3 - x * x) / 2, k * gauss.weight[i] * 3 * (1 - x * x) / 2));
  }
  return rounded(nodes);
}

}  // namespace contact::reference
