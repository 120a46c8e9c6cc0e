#include "libcontact/load_law/minimax.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/linear/solve.hpp"
#include "libcontact/base/text.hpp"

namespace contact::detail {

MinimaxFit minimax_fit(Eigen::MatrixXd a, const Eigen::VectorXd& b,
                       int rows_of_one, int rounds) {
  const Eigen::Index points = b.size() / rows_of_one;
  const Eigen::RowVectorXd scale = a.colwise().norm();
  a.array().rowwise() /= scale.array();
  Eigen::ArrayXd weight = Eigen::ArrayXd::Ones(points);
  MinimaxFit best = {{}, std::numeric_limits<double>::infinity()};
  for (int round = 0; round < rounds; ++round) {
    const Eigen::ArrayXd root = weight.sqrt().replicate(rows_of_one, 1);
    const Eigen::VectorXd x = solve_least_squares(
        (a.array().colwise() * root).matrix(), (b.array() * root).matrix());
    const Eigen::VectorXd all = a * x - b;
    const Eigen::ArrayXd residual =
        all.reshaped(points, rows_of_one).rowwise().norm();
    const double error = residual.maxCoeff();
    if (error < best.error) {
      best = {(x.array() / scale.transpose().array()).matrix(), error};
    }
    weight *= residual / error + 0.03;  // none is forgotten
    weight /= weight.mean();
  }
  return best;
}

Eigen::MatrixXd powers(const Eigen::ArrayXd& x, int count,
                       const Eigen::ArrayXd& y) {
  Eigen::MatrixXd a(x.size(), count);
  a.col(0) = y;
  for (int i = 1; i < count; ++i) a.col(i) = a.col(i - 1).array() * x;
  return a;
}

Eigen::ArrayXd nodes(int count) {
  return 0.5 - 0.5 * ((Eigen::ArrayXd::LinSpaced(count, 0, count - 1) + 0.5) *
                      (std::numbers::pi / count))
                         .cos();
}

FrictionLaw dry_friction(const Joint& joint) {
  const auto* dry = std::get_if<FrictionLaw>(&joint.contact().friction());
  return dry == nullptr ? FrictionLaw(0) : *dry;
}

std::pair<double, double> loads_of_endless(
    const Joint& joint, const std::optional<std::pair<double, double>>& given,
    double unit, double low, double high) {
  require(joint.is_endless(), "a load law",
          "a joint without a [seat] and a [relief], or without_seat() and "
          "without_relief()");
  const auto loads = given.value_or(std::pair(low * unit, high * unit));
  if (loads.first > 0 && loads.first < loads.second) return loads;
  throw Error(must_be(
      message("the loads {} and {} N of a load law", loads.first, loads.second),
      "above 0, the first one less"));
}

void require(bool is_met, std::string_view what, std::string_view other) {
  if (!is_met) throw Error(needs(what, other));
}

double checked(double number, double load) {
  require(std::isfinite(number), message("a load law: a load of {} N", load),
          "a half-angle law and a pressure law that have a value there");
  return number;
}

Error out_of_reach(double wanted, double best) {
  return Error(must_be(
      fmt::format("an error of {} of the load law", wanted),
      fmt::format("at least {:.2g}, which is what all its numbers reach",
                  best)));
}

}  // namespace contact::detail
