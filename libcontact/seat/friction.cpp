#include "libcontact/seat/friction.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "libcontact/base/constants.hpp"
#include "libcontact/seat/readout.hpp"

namespace contact::detail {
namespace {

constexpr int lanes = SeatBasis::lanes;
using Lanes = SeatBasis::Lanes;

// lambda_n of Phi for even n, kappa_n of Xi for odd ones.
Eigen::VectorXd funk_hecke(int degrees) {
  Eigen::VectorXd factor(degrees);
  double even = 1;   // (n - 1)!!/n!!
  double odd = 0.5;  // (n - 2)!!/(n + 1)!!
  for (int n = 0; n < degrees; ++n) {
    if (n % 2 == 0) {
      if (n > 0) even *= (n - 1.0) / n;
      factor(n) = -2 * pi * pi * even * even / ((n - 1.0) * (n + 2));
    } else {
      if (n > 1) odd *= (n - 2.0) / (n + 1);
      factor(n) = 2 * pi * pi * odd * odd;
    }
  }
  return factor;
}

// sqrt((n^2 - m^2)/(4 n^2 - 1))
double ratio(double n, double m) {
  return std::sqrt((n - m) * (n + m) / ((2 * n - 1) * (2 * n + 1)));
}

// Q_mm for m from the first on: N_00, and N_mm over sin v. Those that are below
// the doubles are 0, and so are all N_nm of that order.
class Sectoral {
 public:
  explicit Sectoral(double sine) : sine_(sine) {}
  double next() {
    if (m_ > 0) last_ *= std::sqrt((2 * m_ + 1) / (2.0 * m_));
    if (m_ > 1) last_ *= sine_;
    ++m_;
    return last_;
  }

 private:
  double sine_;
  int m_ = 0;
  double last_ = std::sqrt(0.5);
};

// Sums over one block of orders and the degrees of one parity: c Q, n c Q and
// c slope Q_(n-1).
struct Sums {
  Lanes value = Lanes::Zero(), along = Lanes::Zero(), before = Lanes::Zero();
  double pole = 0;  // sum of c_n0 sqrt(n(n+1)) Q_n1
};

// Value and gradient on the sphere, e_v and e_phi.
struct Expansion {
  double value = 0, along = 0, across = 0;

  void add(const Sums& s, int first, double z, double sine,
           const Lanes& cosines, const Lanes& sines) {
    const Lanes m = Lanes::LinSpaced(first, first + lanes - 1);
    Lanes part = cosines;
    if (first == 0) part(0) = 0;
    value += sine * (s.value * part).sum();
    along += ((z * s.along - s.before) * part).sum();
    across -= (m * s.value * sines).sum();
    if (first > 0) return;
    value += s.value(0);
    along -= sine * s.pole;
  }
};

// p = sum a_im cos(m phi) in each cell, (i, m), m < count.
Eigen::MatrixXd by_order(const Eigen::MatrixXd& at_longitudes, int count) {
  const int last = static_cast<int>(at_longitudes.cols()) - 1;
  Eigen::MatrixXd transform = Eigen::MatrixXd::Zero(last + 1, count);
  for (int j = 0; j <= last; ++j) {
    for (int m = 0; m < std::min(count, last + 1); ++m) {
      const double ends =
          (j == 0 || j == last ? 0.5 : 1) * (m == 0 || m == last ? 0.5 : 1);
      transform(j, m) =
          2.0 / last * ends * std::cos(pi * ((j * m) % (2 * last)) / last);
    }
  }
  return at_longitudes * transform;
}

}  // namespace

SeatBasis::SeatBasis(int degrees) : degrees_(degrees) {
  const int blocks = (degrees + lanes - 1) / lanes;
  const Eigen::Index size = index(degrees, (blocks - 1) * lanes);
  up_ = down_ = slope_ = factors_ = Eigen::ArrayXd::Zero(size);
  const Eigen::VectorXd factor = funk_hecke(degrees);
  for (int m = 0; m < degrees; ++m) {
    for (int n = m; n < degrees; ++n) {
      const Eigen::Index i = index(n, m);
      up_(i) = 1 / ratio(n + 1, m);
      down_(i) = n == 0 ? 0 : ratio(n, m) / ratio(n + 1, m);
      slope_(i) = n == 0 ? 0 : (2 * n + 1) * ratio(n, m);
      factors_(i) = factor(n);
    }
  }
}

Eigen::Index SeatBasis::index(int n, int m) const {
  const int block = m / lanes, first = block * lanes;
  const Eigen::Index before =
      block * degrees_ - lanes * block * (block - 1) / 2;
  return lanes * (before + n - first) + m - first;
}

Eigen::ArrayXd SeatBasis::functions(double v) const {
  const double z = std::cos(v), sine = std::sin(v);
  Eigen::ArrayXd all = Eigen::ArrayXd::Zero(size());
  Sectoral sectoral(sine);
  for (int first = 0; first < degrees_; first += lanes) {
    Lanes now = Lanes::Zero(), before = now;
    for (int n = first; n < degrees_; ++n) {
      if (n < first + lanes) now(n - first) = sectoral.next();
      const Eigen::Index i = index(n, first);
      all.segment<lanes>(i) = sine * now;
      if (first == 0) all(i) = now(0);
      const Lanes next =
          z * up_.segment<lanes>(i) * now - down_.segment<lanes>(i) * before;
      before = now;
      now = next;
    }
  }
  return all;
}

void SeatBasis::mirror(Eigen::ArrayXd& c) const {
  for (int first = 0; first < degrees_; first += lanes) {
    for (int n = first; n < degrees_; ++n) {
      auto some = c.segment<lanes>(index(n, first));
      // (-1)^(n + m)
      for (int k = n % 2 == 0 ? 1 : 0; k < lanes; k += 2) some(k) = -some(k);
    }
  }
}

SeatSlip SeatBasis::dry(const Eigen::ArrayXd& c,
                        const Eigen::Vector3d& axis) const {
  const double z = axis.z(), sine = std::hypot(axis.x(), axis.y());
  const double cos_phi = sine > 0 ? axis.x() / sine : 1;
  const double sin_phi = sine > 0 ? axis.y() / sine : 0;
  Expansion power, angle;
  Sectoral sectoral(sine);
  double turn_x = 1, turn_y = 0;  // cosine and sine of m phi
  Eigen::Index i = 0;
  for (int first = 0; first < degrees_; first += lanes) {
    Lanes now = Lanes::Zero(), before = now, cosines, sines;
    Sums even, odd;
    const auto add = [&](int n, Sums& to) {
      if (n < first + lanes) now(n - first) = sectoral.next();
      const auto of = c.segment<lanes>(i);
      const Lanes product = of * now;
      to.value += product;
      to.along += n * product;
      to.before += of * slope_.segment<lanes>(i) * before;
      if (first == 0) to.pole += of(0) * std::sqrt(n * (n + 1.0)) * now(1);
      const Lanes next =
          z * up_.segment<lanes>(i) * now - down_.segment<lanes>(i) * before;
      before = now;
      now = next;
      i += lanes;
    };
    for (int n = first; n < degrees_; n += 2) {
      add(n, even);
      add(n + 1, odd);
    }
    for (int k = 0; k < lanes; ++k) {
      cosines(k) = turn_x;
      sines(k) = turn_y;
      const double x = turn_x * cos_phi - turn_y * sin_phi;
      turn_y = turn_x * sin_phi + turn_y * cos_phi;
      turn_x = x;
    }
    power.add(even, first, z, sine, cosines, sines);
    angle.add(odd, first, z, sine, cosines, sines);
  }
  const Eigen::Vector3d e_v(z * cos_phi, z * sin_phi, -sine);
  const Eigen::Vector3d e_phi(-sin_phi, cos_phi, 0);
  // w x e_v = e_phi, w x e_phi = -e_v.
  return {angle.along * e_phi - angle.across * e_v,
          power.value * axis + power.along * e_v + power.across * e_phi};
}

SeatSlip SeatBasis::viscous(const Eigen::ArrayXd& c,
                            const Eigen::Vector3d& axis) const {
  // ∫ N_nm cos(m phi) dm
  const auto sum = [&](int n, int m) {
    const Eigen::Index i = index(n, m);
    return (m == 0 ? 2 : 1) * pi * c(i) / factors_(i);
  };
  const double all = sum(0, 0) * std::sqrt(2.0);
  const Eigen::Vector3d first(sum(1, 1) * std::sqrt(4 / 3.0), 0,
                              sum(1, 0) * std::sqrt(2 / 3.0));
  const double zz = (2 * sum(2, 0) * std::sqrt(0.4) + all) / 3;
  const double xz = sum(2, 1) * std::sqrt(4 / 15.0);
  const double xx_yy = sum(2, 2) * std::sqrt(16 / 15.0);
  Eigen::Matrix3d second;
  second << (all - zz + xx_yy) / 2, 0, xz,  //
      0, (all - zz - xx_yy) / 2, 0,         //
      xz, 0, zz;
  return {axis.cross(first), all * axis - second * axis};
}

SeatMoments::SeatMoments(const SeatCells& cells, const SeatBasis& of)
    : basis(of),
      pressure(Eigen::MatrixXd::Zero(cells.size(), of.size())),
      area(pressure) {
  const SeatCells::Rule rule = cells.rule(of.degrees());
  for (Eigen::Index k = 0; k < rule.angle.size(); ++k) {
    const int i = rule.cell(k);
    const double v = rule.angle(k);
    const Eigen::RowVectorXd functions = of.functions(v).matrix();
    const double shape = cells.mean_shape(i) * cells.shape(v);
    pressure.row(i) += rule.weight(k) * functions;
    area.row(i) += rule.weight(k) / shape * functions;
  }
}

Eigen::ArrayXd SeatMoments::harmonics(const Eigen::MatrixXd& cells,
                                      const Eigen::MatrixXd& of) const {
  const Eigen::MatrixXd orders = by_order(of, basis.degrees());
  Eigen::ArrayXd c = Eigen::ArrayXd::Zero(basis.size());
  for (int m = 0; m < basis.degrees(); ++m) {
    for (int n = m; n < basis.degrees(); ++n) {
      const Eigen::Index i = basis.index(n, m);
      c(i) = basis.factors()(i) * cells.col(i).dot(orders.col(m));
    }
  }
  return c;
}

SeatHarmonics SeatSums::of(const SeatSolution& solution,
                           double unit_force) const {
  const SeatMoments* moments = nullptr;
  {
    const std::lock_guard lock(making_);
    auto& one = moments_[solution.solver];
    if (!one) {
      one =
          std::make_unique<const SeatMoments>(solution.solver->cells(), basis_);
    }
    moments = one.get();
  }
  const SeatReadout read(*solution.solver, solution.patch);
  return {unit_force * moments->of_pressure(solution.patch.pressure),
          moments->of_area(read.covered())};
}

}  // namespace contact::detail
