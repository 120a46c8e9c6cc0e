#include "libcontact/conforming/kernel/pin_wall_modes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libcontact/base/constants.hpp"

namespace contact::detail {
namespace {

using Rows = Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

// J_1(x), J_3(x), ..., J_{2 orders - 1}(x) in each row, for x above the
// largest order: forward recurrence, which loses nothing there.
void forward(const Eigen::ArrayXd& x, Rows out, double (*zeroth)(double),
             double (*first)(double)) {
  const Eigen::ArrayXd over = 2 / x;
  Eigen::ArrayXd before = x.unaryExpr([=](double v) { return zeroth(v); });
  Eigen::ArrayXd now = x.unaryExpr([=](double v) { return first(v); });
  const Eigen::Index last = 2 * out.cols() - 1;
  for (Eigen::Index m = 1; m <= last; ++m) {
    if (m % 2 == 1) out.col(m / 2) = now;
    before = static_cast<double>(m) * over * now - before;
    before.swap(now);
  }
}

// The same for one x below it, by Miller's algorithm: backwards from where J
// is below 1e-17, scaled by J_0 + 2 sum J_2m = 1.
void backward(double x, Eigen::VectorXd& out) {
  const int last = 2 * static_cast<int>(out.size()) - 1;
  const int start = static_cast<int>(x + 12 * std::cbrt(x)) + 12;
  out.setZero();
  double after = 0;
  double now = 1e-280;
  double sum = 0;
  for (int m = start; m > 0; --m) {
    if (m % 2 == 0) sum += 2 * now;
    if (m % 2 == 1 && m <= last) out(m / 2) = now;
    const double before = 2 * m / x * now - after;
    after = now;
    now = before;
    if (std::abs(now) > 1e250) {  // small x: what came before is nothing
      constexpr double down = 1e-250;
      now *= down;
      after *= down;
      sum *= down;
      for (Eigen::Index k = m / 2; k < out.size(); ++k) out(k) *= down;
    }
  }
  out /= sum + now;
}

// sin((2k+1) angle), k = 0, 1, ..., by sin^2(angle): the differences of
// successive sines, which keep small angles exact.
void odd_sines(double square, Eigen::Ref<Eigen::RowVectorXd> out) {
  double value = std::sqrt(square);
  double step = 2 * value;  // s_0 - s_{-1}
  for (int k = 0; k < out.size(); ++k) {
    out(k) = value;
    step -= 4 * square * value;
    value += step;
  }
}

}  // namespace

PinWallModes::PinWallModes(double half_angle, int unknowns)
    : half_angle_(half_angle) {
  // phi changes at most sqrt(theta0/sin theta0) times as fast as psi; beyond
  // that order the sums fall faster than exponentially.
  const double stretch =
      half_angle > 1e-8 ? std::sqrt(half_angle / std::sin(half_angle)) : 1;
  const int orders = static_cast<int>(unknowns * stretch) + 16;
  const int points = orders + 4;
  const double b = std::tan(half_angle / 2);
  Eigen::MatrixXd phi(points, unknowns);
  Eigen::MatrixXd psi(points, orders);
  Eigen::RowVectorXd row(orders);
  for (int i = 0; i < points; ++i) {
    const double angle = pi * (i + 0.5) / (2 * points);
    const double t = half_angle * std::cos(angle);
    const double half = std::sin(angle / 2);
    const double rest = 2 * half_angle * half * half;  // theta0 - t
    const double denominator = std::cos(half_angle / 2) * std::cos(t / 2) * b;
    // sin^2 phi = 1 - tan^2(t/2)/b^2
    const double square = std::sin(rest / 2) * std::sin((half_angle + t) / 2) /
                          (denominator * denominator);
    odd_sines(square, row.head(unknowns));
    phi.row(i) = row.head(unknowns);
    odd_sines(std::sin(angle) * std::sin(angle), row);
    psi.row(i) = row;
  }
  transformation_.noalias() = 2.0 / points * psi.transpose() * phi;
}

void PinWallModes::visit_second_kind(
    std::span<const double> n,
    const std::function<void(int, const Block&)>& use) const {
  const Eigen::ArrayXd order = Eigen::Map<const Eigen::ArrayXd>(
      n.data(), static_cast<Eigen::Index>(n.size()));
  Eigen::MatrixXd modes(order.size(), transformation_.rows());
  forward(order * half_angle_, modes, ::y0, ::y1);
  for (int j = 0; j < modes.cols(); ++j) {
    modes.col(j).array() *= (j % 2 == 0 ? pi : -pi) * (2 * j + 1) / order;
  }
  use(0, modes);
}

void PinWallModes::visit(
    std::span<const double> n,
    const std::function<void(int, const Block&)>& use) const {
  constexpr int block = 128;
  const Eigen::Index orders = transformation_.rows();
  Eigen::MatrixXd modes(block, orders);
  Eigen::VectorXd one(orders);
  Eigen::RowVectorXd factor(orders);
  for (int j = 0; j < orders; ++j) {
    factor(j) = (j % 2 == 0 ? pi : -pi) * (2 * j + 1);
  }
  const double last_order = 2.0 * static_cast<double>(orders) - 1;
  const int size = static_cast<int>(n.size());
  for (int first = 0; first < size; first += block) {
    const int count = std::min(block, size - first);
    const Eigen::ArrayXd order =
        Eigen::Map<const Eigen::ArrayXd>(n.data() + first, count);
    int low = 0;
    for (; low < count && order(low) * half_angle_ <= last_order; ++low) {
      backward(order(low) * half_angle_, one);
      modes.row(low) = one.transpose();
    }
    if (low < count) {
      forward(order.tail(count - low) * half_angle_,
              modes.middleRows(low, count - low), ::j0, ::j1);
    }
    modes.topRows(count).array().colwise() /= order;
    modes.topRows(count) *= factor.asDiagonal();
    use(first, modes.topRows(count));
  }
}

HarmonicSamples::HarmonicSamples(double half_angle, int end) {
  // A fade of width s lets exp(-(s margin)^2/2) pass at the first frequency
  // that a stride takes for 0, and is complete at `wide` s.
  constexpr double wide = 8.5;
  const auto width = [half_angle](int stride) {
    return wide / (2 * pi / stride - 2 * half_angle);
  };
  int stride = 1;
  double fewest = end;
  for (int i = 2; i < 64 && i * half_angle < 0.8 * pi; ++i) {
    const int strided = end / i;
    const double count = 2 * wide * width(i) + strided;
    if (count < fewest) {
      fewest = count;
      stride = i;
    }
  }
  const double s = width(stride);
  const double middle = 2 + wide * s;
  const auto add = [&](int order, double share) {
    n.push_back(order);
    weight.push_back(share);
  };
  int i = 2;
  for (; i < end && (stride == 1 || i < middle + wide * s); ++i) {
    const double fade =
        stride > 1 ? std::erfc((middle - i) / (s * std::numbers::sqrt2)) / 2
                   : 0;
    add(i, 1 - fade + (i % stride == 0 ? stride * fade : 0));
  }
  for (i += (stride - i % stride) % stride; i < end; i += stride) {
    add(i, stride);
  }
}

GradedSamples::GradedSamples(double half_angle, int end, double smooth_from)
    : swinging(half_angle, end) {
  constexpr double wide = 8.5;  // as above
  const std::size_t all = swinging.n.size();
  const double stride = all > 1 ? swinging.n[all - 1] - swinging.n[all - 2] : 1;
  // Near the highest order J swings at 0.7 of theta0.
  const double s =
      wide / std::min(1.4 * half_angle, 2 * pi / stride - 2 * half_angle);
  const double start = smooth_from / half_angle;
  const auto step = [](double order, double middle, double width) {
    return std::erfc((middle - order) / (width * std::numbers::sqrt2)) / 2;
  };
  const auto fade = [&](double order) {
    return step(order, start + wide * s, s);
  };
  if (start + 2 * wide * s > end) return;
  std::size_t kept = 0;
  for (; kept < all && swinging.n[kept] < start + 2 * wide * s; ++kept) {
    swinging.weight[kept] *= 1 - fade(swinging.n[kept]);
  }
  swinging.n.resize(kept);
  swinging.weight.resize(kept);
  // Strides m double around 128 m, within +-29 m.
  const auto up = [&](double order, double by) {
    return step(order, 128 * by, 3.4 * by);
  };
  int m = 1;
  while (99 * m < start) m *= 2;
  for (int i = static_cast<int>(start) / m * m + m; i < end; i += m) {
    if (i > 157 * m) {
      m *= 2;
      i += i % m;
      if (i >= end) break;
    }
    const double rising = up(i, m);
    const double share =
        m * (1 - rising) + (i % (2 * m) == 0 ? 2 * m * rising : 0);
    n.push_back(i);
    weight.push_back(share * fade(i) / 2);
  }
}

}  // namespace contact::detail
