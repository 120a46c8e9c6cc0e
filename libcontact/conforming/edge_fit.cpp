#include "libcontact/conforming/edge_fit.hpp"

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/linear/solve.hpp"

namespace contact::detail {
namespace {

constexpr int fitted = ContactPressure::logarithms - 1;

}  // namespace

const EdgeFit& EdgeFit::table(int terms) {
  if (terms <= usual_terms) {
    static const EdgeFit& usual = *new EdgeFit(usual_terms);
    return usual;
  }
  if (terms <= wide_terms) {
    static const EdgeFit& wide = *new EdgeFit(wide_terms);
    return wide;
  }
  static const EdgeFit& thin = *new EdgeFit(thin_terms);
  return thin;
}

EdgeFit::EdgeFit(int terms) : terms_(terms) {
  const int count = 2 * terms + 8;
  square.resize(count);
  cosine.resize(count);
  leading_.resize(count);
  // Sums over the points give the sine coefficients of all orders below
  // `count`.
  Eigen::MatrixXd sines(count, count);
  Eigen::MatrixXd logarithms(count, fitted);
  for (int i = 0; i < count; ++i) {
    const double phi = pi * (i + 0.5) / (2 * count);
    const double x = std::sin(phi);
    square(i) = x * x;
    cosine(i) = std::cos(phi);
    for (int k = 0; k < count; ++k) {
      sines(k, i) = 2.0 / count * std::sin((2 * k + 1) * phi);
    }
    leading_(i) = x * x * x * std::log(x);
    for (int j = 0; j < fitted; ++j) {
      logarithms(i, j) = leading_(i) * std::pow(x, 2 * (j + 1));
    }
  }
  sines_ = sines.topRows(terms);
  // With many sines only rounding is left above them.
  if (terms > usual_terms) return;
  logarithms_ = logarithms;
  fit_ = solve_least_squares((sines * logarithms).bottomRows(count - terms),
                             sines.bottomRows(count - terms));
}

double EdgeFit::leading_logarithm(double slope, double coefficient,
                                  double half_angle) {
  return 4 / (3 * pi) * coefficient * std::sin(half_angle / 2) * slope;
}

ContactPressure EdgeFit::operator()(double half_angle, double force_ratio,
                                    const Points& values,
                                    double leading) const {
  std::array<double, ContactPressure::logarithms> b{leading};
  Points rest = values - leading * leading_;
  const double none = 1e-12 * std::abs(values(values.size() - 1));
  if (fit_.size() > 0 && std::abs(leading) > none) {
    // First these and then the sines: the fit is nearly singular.
    Eigen::Map<Eigen::Vector<double, fitted>> next(b.data() + 1);
    next.noalias() = fit_ * rest;
    rest.noalias() -= logarithms_ * next;
  }
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, ContactPressure::max_terms, 1> a(
      terms_);
  a.noalias() = sines_ * rest;
  return {
      half_angle, force_ratio, {a.data(), static_cast<std::size_t>(terms_)}, b};
}

}  // namespace contact::detail
