#include "libcontact/duty/steps/worn_sphere.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/linear/solve.hpp"

namespace contact::detail {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

double dot(const MatrixXd& a, const MatrixXd& b) {
  return a.cwiseProduct(b).sum();
}

SeatWindow window_to(double reach) {
  SeatWindow window(SeatZone::cup(pi));
  window.to = reach;
  window.rim = {false, false};
  return window;
}

int latitudes_of(double reach, double step) {
  // The reach may be a rounded number.
  return std::max(static_cast<int>(std::ceil(reach / step - 1e-9)), 1);
}
// Even, as the longitudes are twice as many.
int order_for(double step) {
  return static_cast<int>(std::ceil(0.8 * pi / step));
}

// The harmonic in a column of the transform: 1, cos, sin, cos 2, ...
int order_of(int column) { return (column + 1) / 2; }

}  // namespace

WornSphere::WornSphere(const LayeredPair& pair, const Vector3d& pole,
                       double reach, double step)
    : radius_(pair.radius()),
      modulus_(pair.surfaces().effective_modulus()),
      order_(order_for(step)),
      cells_(window_to(reach), latitudes_of(reach, step),
             pair.relative_thickness()),
      compliance_(pair, cells_, order_),
      transform_(2 * order_, 2 * order_) {
  axes_.col(2) = pole;
  axes_.col(0) = pole.unitOrthogonal();
  axes_.col(1) = pole.cross(axes_.col(0));
  const int count = longitudes();
  for (int j = 0; j < count; ++j) {
    for (int k = 0; k < count; ++k) {
      const int m = order_of(k);
      const double turn = pi * ((j * m) % count) / order_;
      const double scale =
          std::sqrt((k == 0 || m == order_ ? 1.0 : 2.0) / count);
      transform_(j, k) =
          scale * (k % 2 == 0 && k > 0 ? std::sin(turn) : std::cos(turn));
    }
  }
  Eigen::RowVectorXd cosine(count), sine(count);
  for (int j = 0; j < count; ++j) {
    cosine(j) = std::cos(pi * j / order_);
    sine(j) = std::sin(pi * j / order_);
  }
  const Eigen::RowVectorXd one = Eigen::RowVectorXd::Ones(count);
  lever_ = {cells_.sine.matrix() * cosine, cells_.sine.matrix() * sine,
            cells_.cosine.matrix() * one};
  unit_ = cells_.unit.matrix() * one;
}

std::size_t WornSphere::points(double reach, double step) {
  return static_cast<std::size_t>(latitudes_of(reach, step) * 2 *
                                  order_for(step));
}

double WornSphere::compliance() const {
  Eigen::VectorXd cap = Eigen::VectorXd::Zero(latitudes());
  for (int i = 0; i < latitudes(); ++i) {
    if (cells_.bound(i) < pi / 4) cap(i) = 1;
  }
  const double pressed = cap.dot(compliance_.matrix[0] * cap);
  return 4 * radius_ / modulus_ * pressed / cap.dot(cells_.unit.matrix());
}

Vector3d WornSphere::point(int latitude, int longitude) const {
  const double v = (cells_.bound(latitude) + cells_.bound(latitude + 1)) / 2;
  const double phi = pi * longitude / order_;
  return axes_ * Vector3d(std::sin(v) * std::cos(phi),
                          std::sin(v) * std::sin(phi), std::cos(v));
}

double WornSphere::area(int latitude) const {
  return radius_ * radius_ * cells_.unit(latitude) * pi / order_;
}

WornSphere::Map WornSphere::turned(const std::vector<Map>& by_order,
                                   const Map& of) const {
  Map harmonics = of * transform_;
  Map result(of.rows(), of.cols());
  for (int k = 0; k < of.cols(); ++k) {
    result.col(k).noalias() =
        by_order[static_cast<std::size_t>(order_of(k))] * harmonics.col(k);
  }
  harmonics.noalias() = result * transform_.transpose();
  return harmonics;
}

// Equations of one set in contact: A y - L D = -gap, L^T y = goal.
struct WornSphere::Problem {
  const WornSphere& of;
  Map gap;      // times the cells' unit
  Map springs;  // the same; may be empty
  Vector3d goal;
  std::vector<Map> inverse;  // inverse of A_m with the mean spring
  Map contact;               // 1 inside

  Map compliance(const Map& y) const {
    Map u = of.turned(of.compliance_.matrix, y);
    if (springs.size() > 0) u += springs.cwiseProduct(y);
    return u;
  }
  Map better(const Map& residual) const {
    return of.turned(inverse, residual.cwiseProduct(contact))
        .cwiseProduct(contact);
  }
  Vector3d force(const Map& y) const {
    return {dot(of.lever_[0], y), dot(of.lever_[1], y), dot(of.lever_[2], y)};
  }
  Map lever(const Vector3d& d) const {
    return d[0] * of.lever_[0] + d[1] * of.lever_[1] + d[2] * of.lever_[2];
  }
};

// Conjugate gradients whose directions carry no load (Gould, Hribar and
// Nocedal, SIAM J. Sci. Comput. 23, 2001).
int WornSphere::solve(const Problem& problem, double tolerance, Map& y,
                      Vector3d& shift) const {
  std::vector<Map> by_lever;
  Eigen::Matrix3d stiffness;
  for (int k = 0; k < 3; ++k) {
    by_lever.push_back(problem.better(lever_[static_cast<std::size_t>(k)]));
    stiffness.col(k) = problem.force(by_lever.back());
  }
  const auto along = [&](const Vector3d& d) -> Map {
    return d[0] * by_lever[0] + d[1] * by_lever[1] + d[2] * by_lever[2];
  };
  y = y.cwiseProduct(problem.contact).eval();
  const Eigen::Matrix3d by_force =
      solve_symmetric(stiffness, Eigen::Matrix3d::Identity());
  y += along(by_force * (problem.goal - problem.force(y)));
  Map residual = problem.compliance(y) + problem.gap;
  const double goal =
      tolerance *
      std::sqrt(dot(problem.gap.cwiseProduct(problem.contact), problem.gap));
  Map direction;
  double before = 1;
  int count = 0;
  for (;; ++count) {
    Map z = problem.better(residual);
    const Vector3d d = by_force * problem.force(z);
    z -= along(d);
    shift = d;
    const Map rest =
        (residual - problem.lever(d)).cwiseProduct(problem.contact);
    const double now = dot(rest, z);
    if (rest.norm() <= goal || !(now > 0) || count == 200) return count;
    direction = count == 0 ? Map(-z) : Map(-z + now / before * direction);
    before = now;
    const Map image = problem.compliance(direction);
    const double length = now / dot(direction, image);
    y += length * direction;
    residual += length * image;
  }
}

WornSphere::Contact WornSphere::press(const Vector3d& load, const Map& gap,
                                      const Map& springs,
                                      const Contact* last) const {
  Contact contact;
  contact.pressure = Map::Zero(gap.rows(), gap.cols());
  if (!(load.norm() > 0)) {
    contact.status = Status::ok;
    return contact;
  }
  const double unit = modulus_ / (4 * radius_);  // Pa/m
  const Vector3d local = axes_.transpose() * load;
  Problem problem{*this,
                  gap.cwiseProduct(unit_),
                  {},
                  local * 4 / (modulus_ * radius_) * order_ / pi,
                  compliance_.inverse,
                  Map::Zero(gap.rows(), gap.cols())};
  if (springs.size() > 0) {
    problem.springs = unit * springs.cwiseProduct(unit_);
    const double mean = unit * springs.mean();
    for (std::size_t m = 0; m < problem.inverse.size(); ++m) {
      Map a = compliance_.matrix[m];
      a.diagonal() +=
          mean * cells_.unit.matrix() +
          1e-3 * a.diagonal().mean() * Eigen::VectorXd::Ones(a.rows());
      problem.inverse[m] = inverse_of_positive(std::move(a));
    }
  }
  Map y = Map::Zero(gap.rows(), gap.cols());
  if (last != nullptr && last->pressure.size() > 0) {
    y = last->pressure / unit;
    problem.contact = (y.array() > 0).cast<double>();
  } else {  // in front
    problem.contact =
        (problem.lever(local.normalized()).array() > 0.8 * unit_.array())
            .cast<double>();
  }
  Map open;
  constexpr double finest = 1e-5;
  // Sets that come back are left by one cell at a time (Murty).
  constexpr int all_at_once = 20;
  constexpr int most = 200;
  for (int round = 0; round < most; ++round) {
    const double tolerance = round == 0 ? 1e-3 : finest;
    solve(problem, tolerance, y, contact.shift);
    open = problem.compliance(y) + problem.gap - problem.lever(contact.shift);
    // Above what `finest` leaves, or cells would come and go.
    const Map overlap = -1e-4 * contact.shift.norm() * unit_;
    // A cell that has joined may be left at 0, or by rounding below.
    const double pull = -1e-5 * y.maxCoeff();
    const auto inside = problem.contact.array() > 0;
    const Eigen::ArrayXXd next =
        (inside && y.array() >= pull)
            .select(1.0,
                    (!inside && open.array() < overlap.array()).cast<double>());
    const bool is_same = (next == problem.contact.array()).all();
    if (is_same && tolerance == finest) {
      contact.status = Status::ok;
      break;
    }
    if (round < all_at_once) {
      problem.contact = next.matrix();
      continue;
    }
    const Eigen::ArrayXXd changed = next - problem.contact.array();
    Eigen::Index i = 0, j = 0;
    changed.abs().maxCoeff(&i, &j);  // the first of them
    problem.contact(i, j) = next(i, j);
  }
  contact.pressure = unit * y.cwiseProduct(problem.contact).cwiseMax(0);
  // A grid that ends before the sphere does must not cut a contact.
  if (cells_.window.to < pi && problem.contact.bottomRows(1).any()) {
    contact.status = Status::out_of_range;
  }
  contact.half_angle = cap(contact.pressure, open.cwiseQuotient(unit_));
  contact.shift = axes_ * contact.shift;
  return contact;
}

// How many cells before the first of three gaps they begin, (0, 1]. Beyond the
// end of an elastic contact a gap grows as s^(3/2), beyond a worn bed or on a
// thin layer as s: these are a s^(3/2) + b s.
double begin_of(double first, double second, double third) {
  const auto excess = [&](double s) {
    const double one = second / (s + 1) - first / s;
    const double two = third / (s + 2) - second / (s + 1);
    return one * (std::sqrt(s + 2) - std::sqrt(s + 1)) -
           two * (std::sqrt(s + 1) - std::sqrt(s));
  };
  double low = 0, high = 1;
  for (int k = 0; k < 20; ++k) {
    const double middle = (low + high) / 2;
    (excess(middle) < 0 ? low : high) = middle;
  }
  return high;
}

// On every meridian to where the gap begins.
double WornSphere::cap(const Map& pressure, const Map& open) const {
  const auto rows = static_cast<int>(pressure.rows());
  const auto middle = [&](int i) {
    return (cells_.bound(i) + cells_.bound(i + 1)) / 2;
  };
  const auto edge = [&](int i, int j, int side) {
    const int first = i + side;
    if (first < 0) return 0.0;
    if (first >= rows) return cells_.window.to;
    const auto gap = [&](int k) {
      const int at = first + k * side;
      const bool is_open = at >= 0 && at < rows && !(pressure(at, j) > 0);
      return is_open ? std::max(open(at, j), 0.0) : -1;
    };
    const double near = std::max(gap(0), 1e-300);
    const double next = gap(1) > near ? gap(1) : 3 * near;
    const double far = gap(2) > next ? gap(2) : 2 * next - near;
    return middle(first) -
           begin_of(near, next, far) * (middle(first) - middle(i));
  };
  double sum = 0;
  for (int j = 0; j < pressure.cols(); ++j) {
    for (int i = 0; i < rows; ++i) {
      if (!(pressure(i, j) > 0)) continue;
      const int begin = i;
      while (i + 1 < rows && pressure(i + 1, j) > 0) ++i;
      sum += std::cos(edge(begin, j, -1)) - std::cos(edge(i, j, 1));
    }
  }
  const double over_sphere = sum * pi / order_ / (4 * pi);
  return 2 * std::asin(std::sqrt(std::min(over_sphere, 1.0)));
}

}  // namespace contact::detail
