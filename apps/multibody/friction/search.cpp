#include "multibody/friction/search.hpp"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/NonLinearOptimization>

#include "libcontact/base/root_finding.hpp"
#include "multibody/system/eigen_conversion.hpp"

namespace multibody {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// Solutions closer than this count as one.
constexpr double same = 1e-6;
// Tolerance of consistent moments, limited by rounding.
constexpr double tolerance = 1e-10;

void add_new(std::vector<VectorXd>& found, const VectorXd& x) {
  const auto is_same = [&](const VectorXd& y) {
    return (x - y).norm() <= same * (x.norm() + y.norm());
  };
  if (std::ranges::none_of(found, is_same)) found.push_back(x);
}

class Search {
 public:
  explicit Search(Hinges& hinges) : hinges_(hinges), active_(hinges.active()) {}

  VectorXd moments() const {
    VectorXd x(3 * active_.size());
    for (std::size_t k = 0; k < active_.size(); ++k) {
      x.segment<3>(3 * k) = hinges_.memory(active_[k]).moment;
    }
    return x;
  }

  // Starts from the initial state: a change would lose digits of small moments
  // to earlier large ones, and all digits to NaN.
  void set_moments(const VectorXd& x) {
    for (std::size_t k = 0; k < active_.size(); ++k) {
      hinges_.memory(active_[k]).moment = x.segment<3>(3 * k);
    }
    ++hinges_.evaluation().number;
    hinges_.memory().tracked.forget_applied();
    hinges_.start();
  }

  // M_t(R(x)) - x
  VectorXd mismatch(const VectorXd& x) {
    set_moments(x);
    hinges_.solve();
    VectorXd f(x.size());
    for (std::size_t k = 0; k < active_.size(); ++k) {
      f.segment<3>(3 * k) =
          hinges_.now(active_[k]).solved - x.segment<3>(3 * k);
    }
    return f;
  }

  // True if all moments are examined.
  bool is_scan() const {
    return active_.size() == 1 && hinges_[active_[0]].is_axis;
  }
  // Starts from the last moments of the outer loop.
  std::vector<VectorXd> scan(const VectorXd& before) {
    return is_scan() ? scan_axis() : scan_starts(before);
  }

 private:
  bool solve_from(VectorXd& x) {
    return hinges_.is_tree() ? solve_tree_from(x) : solve_star_from(x);
  }

  // Newton's method through the tree, with steps limited to the validity of the
  // slopes: one evaluation for each, independent of the number of hinges.
  bool solve_tree_from(VectorXd& x) {
    constexpr int limit = 60;
    constexpr double longest = 0.3;
    for (int step = 0; step < limit; ++step) {
      const VectorXd f = mismatch(x);
      if (!f.allFinite()) return false;
      if (f.norm() <= tolerance * (x.norm() + (f + x).norm())) return true;
      hinges_.set_tree_steps(true);
      VectorXd by(x.size());
      for (std::size_t k = 0; k < active_.size(); ++k) {
        by.segment<3>(3 * k) = vec3(hinges_.change(active_[k]));
      }
      const double most = longest * std::max(x.norm(), f.norm());
      x += std::min(1.0, most / by.norm()) * by;
    }
    return false;
  }

  // Powell's hybrid method (MINPACK). Newton's method alone stalls where
  // friction near its limit turns with the reaction.
  bool solve_star_from(VectorXd& x) {
    struct Function {
      Search* search;
      int operator()(const VectorXd& at, VectorXd& f) const {
        f = search->mismatch(at);
        return f.allFinite() ? 0 : -1;
      }
    };
    Function function{this};
    Eigen::HybridNonLinearSolver<Function> solver(function);
    solver.parameters.xtol = 1e-14;
    solver.parameters.maxfev = 100 * (x.size() + 1);
    solver.solveNumericalDiff(x);
    // Decides by the residual, not by the method's report on its steps.
    const VectorXd f = mismatch(x);
    return f.norm() <= tolerance * (x.norm() + (f + x).norm());
  }

  // One axis: every change of sign of the mismatch over all moments that oppose
  // the sliding, from 0 to far beyond any that could fit.
  std::vector<VectorXd> scan_axis() {
    std::vector<VectorXd> found;
    const double sign = -hinges_.now(active_[0]).rate.z();
    const auto value = [&](double size) {
      VectorXd x = VectorXd::Zero(3);
      x[2] = std::copysign(size, sign);
      const double f = mismatch(x)[2];
      return sign > 0 ? f : -f;  // > 0: more friction than x
    };
    const double at_zero = value(0);
    if (!(at_zero > 0)) {
      if (at_zero == 0) found.push_back(VectorXd::Zero(3));
      return found;
    }
    // The mismatch is nearly the difference of a norm and a line: it has at
    // most two roots, and is straight far from 0. Two roots between neighbours
    // 1 % apart differ by less than 1 %.
    constexpr double factor = 1.01;
    constexpr double furthest = 1e6;
    double low = 0;
    double low_value = at_zero;
    for (double size = 1e-3 * at_zero; size < furthest * at_zero;
         size *= factor) {
      const double f = value(size);
      if (!std::isfinite(f)) break;
      if ((f <= 0) != (low_value <= 0)) {
        const double root =
            contact::shrink_bracket(value, low, size, low_value, f, 50)
                .middle();
        VectorXd x = VectorXd::Zero(3);
        x[2] = std::copysign(root, sign);
        found.push_back(x);
      }
      low = size;
      low_value = f;
    }
    return found;
  }

  // Moments against the sliding, of sizes from 0.1 to 1e6 times those without
  // friction, which fill the space of their logarithms evenly (Roberts' R_d
  // sequence, g^(d + 1) = g + 1).
  VectorXd spread(int number, const VectorXd& slid) const {
    VectorXd x(slid.size());
    double g = 1.5;
    for (int i = 0; i < 60; ++i)
      g = std::pow(1 + g, 1 / static_cast<double>(active_.size() + 1));
    double step = 1;
    for (std::size_t k = 0; k < active_.size(); ++k) {
      step /= g;
      const double share = std::fmod(number * step, 1);
      const Vector3d& rate = hinges_.now(active_[k]).rate;
      x.segment<3>(3 * k) = -rate.normalized() *
                            slid.lpNorm<Eigen::Infinity>() *
                            std::pow(10, 7 * share - 1);
    }
    return x;
  }

  // Newton's method is cheap.
  void add_tree_starts(const VectorXd& before, const VectorXd& slid,
                       std::vector<VectorXd>& starts) const {
    if (before.allFinite()) {
      for (double share = 10; share <= 1e6; share *= 10) {
        starts.push_back(share * before);
      }
    }
    constexpr int more = 60;
    for (int k = 1; k <= more; ++k) starts.push_back(spread(k, slid));
  }

  // Several hinges: starts from the last moments of the outer loop, and from
  // moments of many sizes.
  std::vector<VectorXd> scan_starts(const VectorXd& before) {
    std::vector<VectorXd> found;
    const VectorXd zero = VectorXd::Zero(3 * active_.size());
    const VectorXd slid = mismatch(zero);
    std::vector<VectorXd> starts;
    if (before.allFinite()) starts.push_back(before);
    for (const double share : {0., 0.3, 1., 3., 10., 30., 100.}) {
      starts.push_back(share * slid);
    }
    if (hinges_.is_tree()) add_tree_starts(before, slid, starts);
    for (VectorXd& x : starts) {
      if (solve_from(x)) add_new(found, x);
    }
    return found;
  }

  Hinges& hinges_;
  const std::vector<int>& active_;
};

}  // namespace

void search(Hinges& hinges) {
  CoupledReport& report = hinges.report();
  Search search(hinges);
  const std::vector<int>& active = hinges.active();
  const VectorXd before = search.moments();
  std::vector<VectorXd> found = search.scan(before);
  if (report.status == CoupledStatus::ok) add_new(found, before);

  std::vector<CoupledSolution>& solutions = hinges.evaluation().solutions;
  for (const VectorXd& x : found) {
    CoupledSolution& s = solutions.emplace_back();
    s.moments.assign(hinges.size(), Vector3d::Zero());
    for (std::size_t k = 0; k < active.size(); ++k) {
      s.moments[active[k]] = x.segment<3>(3 * k);
    }
  }
  if (found.size() == 1) {
    search.mismatch(found[0]);
    report.status = CoupledStatus::ok;
    report.others_possible = !search.is_scan();
    report.residual = hinges.solve();
    report.body = -1;
    return;
  }
  report.status = found.empty() ? CoupledStatus::no_solution
                                : CoupledStatus::several_solutions;
  if (report.body < 0) report.body = active[0];
  // The next evaluation must not start from these moments.
  search.set_moments(VectorXd::Zero(before.size()));
}

}  // namespace multibody
