#include "support/joint_sweep.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/joint/fixed_point.hpp"
#include "support/random_slip.hpp"

namespace contact::test {
namespace {

using Eigen::Vector3d;

constexpr double pi = std::numbers::pi;

// f of a contact, by the friction integrals alone.
double friction_coefficient(const Joint& joint, double force, SlipAxis axis) {
  const auto& friction = std::get<FrictionLaw>(joint.contact().friction());
  const double rho = joint.contact().geometry().radius();
  const auto i =
      friction_integrals(joint.contact().half_angle(force).half_angle, axis);
  return friction.coefficient() * i.coefficient.force +
         friction.adhesion() * rho * rho / force * i.area.force;
}

void check_solution(const RandomSlip& input, const JointSolution& s,
                    const std::string& label, JointSweep& sweep) {
  if (s.status != Status::ok) ++sweep.not_ok;
  const double error = true_residual(input.joint, s);
  if (!(error <= sweep.residual)) {
    sweep.residual = error;
    sweep.worst_residual = label;
  }
  const double force = input.reaction.norm();
  const auto largest = [](double& seen, double value) {
    if (!(value <= seen)) seen = value;
  };
  largest(
      sweep.reaction,
      (s.normal_force * s.normal + s.friction_force - input.reaction).norm() /
          force);
  const double rho = input.joint.contact().geometry().radius();
  const double unit = rho * force * input.rate.norm();
  largest(sweep.power,
          std::max(s.power, s.friction_moment.dot(input.rate)) / unit);
  const double b = s.reaction_angle();
  largest(sweep.angle_excess, s.friction_angle() - std::min(b, pi - b));
}

// Index of the first edge that is not below a value.
template <std::size_t size>
std::size_t bin_of(const std::array<double, size>& edges, double value) {
  return std::lower_bound(edges.begin(), edges.end() - 1, value) -
         edges.begin();
}

void run_fixed_point(const RandomSlip& input, const JointSolution& s,
                     JointSweep& sweep) {
  constexpr int limit = 500;
  constexpr int slow = 50;
  const auto result = contact::fixed_point(
      input.joint, input.slip(), {}, {.tolerance = 1e-12, .step_limit = limit});
  if (result.status == Status::ok) sweep.fixed_point.add(result.steps);
  const bool fails = result.status == Status::out_of_range;
  sweep.fixed_point_fails += fails;
  sweep.fixed_point_never += result.status == Status::not_converged;
  sweep.fixed_point_slow += !fails && result.steps > slow;
  auto& bin =
      sweep.map[bin_of(JointSweep::f_edges, s.force_coefficient)][bin_of(
          JointSweep::b_edges_deg, std::abs(s.reaction_angle() / degree - 90))];
  ++bin.inputs;
  bin.fails += fails;
  bin.slow += !fails && result.steps > slow;
}

// Whether tan psi - f/cos a changes its sign once only, where the solver says
// (psi: the angle at Dw of the triangle of Dw, n and R;
// docs/explanation/joint.md): a scan in ln tan psi, dense at the root and 12
// decades wide.
bool has_one_root(const RandomSlip& input, const JointSolution& s) {
  const double sin_b = s.reaction_direction.sin;
  const double cos_b = std::abs(s.reaction_direction.cos);
  const double root = s.force_coefficient / s.slip_axis.cos;
  if (!(root > 0 && root < 1e130) || sin_b == 0) return true;
  constexpr int steps = 20;
  for (int i = -steps; i <= steps; ++i) {
    if (i == 0) continue;
    // 28 at the ends: 1e12.
    const double x = 28 * std::pow(std::abs(i) / double(steps), 3);
    const double tangent = root * std::exp(std::copysign(x, i));
    const double r = std::hypot(1, tangent);
    const double cos_g = std::hypot(sin_b, cos_b * r) / r;
    const SlipAxis axis = {cos_b / cos_g, sin_b / r / cos_g};
    const double f =
        friction_coefficient(input.joint, input.reaction.norm() * cos_g, axis);
    if ((tangent > f / axis.cos) != (i > 0)) return false;
  }
  return true;
}

// Largest change of the parts of a solution.
double change(const JointSolution& s, const JointSolution& t,
              double moment_unit) {
  const double force = s.reaction.norm();
  return std::max(
      {(s.normal - t.normal).norm(),
       (s.friction_force - t.friction_force).norm() / force,
       (s.friction_moment - t.friction_moment).norm() / moment_unit});
}

// A path of inputs: R turns and grows, Dw turns, at the same time.
class Path {
 public:
  Path(RandomSlip start, RandomSlips& random)
      : start_(std::move(start)),
        reaction_axis_(random.direction()),
        rate_axis_(random.direction()),
        reaction_turn_(pi * random.uniform()),
        rate_turn_(pi * random.uniform()),
        growth_(2 * random.uniform() - 1) {}

  JointSolution at(double x) const {
    const Eigen::AngleAxisd turn(x * reaction_turn_, reaction_axis_);
    const Eigen::AngleAxisd rate_turn(x * rate_turn_, rate_axis_);
    return start_.joint.solve({std::exp(growth_ * x) * (turn * start_.reaction),
                               rate_turn * start_.rate});
  }

  // Whether there may be several roots (docs/explanation/joint.md).
  bool may_fold() const {
    return start_.joint.contact().half_angle_law().limit_half_angle() > pi / 2;
  }

 private:
  RandomSlip start_;
  Vector3d reaction_axis_;
  Vector3d rate_axis_;
  double reaction_turn_;
  double rate_turn_;
  double growth_;
};

void follow(const Path& path, JointSweep& sweep) {
  constexpr int steps = 100;
  constexpr double largest_change = 1e-11;
  std::vector<JointSolution> points;
  double moment_unit = 0;
  for (int i = 0; i <= steps; ++i) {
    points.push_back(path.at(i / double(steps)));
    moment_unit = std::max(moment_unit, points.back().friction_moment.norm());
  }
  if (moment_unit == 0) moment_unit = 1;
  // The step with the largest change, halved where it changes more, down to
  // neighbours: a jump would stay.
  double low = 0;
  double high = 0;
  double largest = -1;
  for (int i = 0; i < steps; ++i) {
    const double size = change(points[i], points[i + 1], moment_unit);
    if (size > largest) {
      largest = size;
      low = i / double(steps);
      high = (i + 1) / double(steps);
    }
  }
  JointSolution at_low = path.at(low);
  JointSolution at_high = path.at(high);
  while (high - low > 1e-12) {
    const double middle = low + (high - low) / 2;
    const JointSolution s = path.at(middle);
    if (change(at_low, s, moment_unit) >= change(s, at_high, moment_unit)) {
      high = middle;
      at_high = s;
    } else {
      low = middle;
      at_low = s;
    }
  }
  ++sweep.paths;
  sweep.path_steps += steps;
  const double steepness =
      (1 + std::max(at_low.force_coefficient, at_high.force_coefficient)) /
      std::min({1.0, at_low.half_angle, at_high.half_angle});
  const double jump = change(at_low, at_high, moment_unit) / steepness;
  // Inputs 1e-12 apart change the result by some 1e-12.
  if (jump > largest_change && path.may_fold()) {
    ++sweep.folds;
  } else if (!(jump <= sweep.jump)) {
    sweep.jump = jump;
  }
}

}  // namespace

double true_residual(const Joint& joint, const JointSolution& s) {
  const double f = friction_coefficient(joint, s.normal_force, s.slip_axis);
  return f == s.force_coefficient ? 0 : std::abs(f / s.force_coefficient - 1);
}

void Histogram::add(int value) {
  ++counts_[std::clamp(value, 0, bins - 1)];
  sum_ += value;
  max_ = std::max(max_, value);
}

std::uint64_t Histogram::count() const {
  std::uint64_t all = 0;
  for (const std::uint64_t n : counts_) all += n;
  return all;
}

std::uint64_t Histogram::above(int value) const {
  std::uint64_t all = 0;
  for (int i = value + 1; i < bins; ++i) all += counts_[i];
  return all;
}

std::string Histogram::text() const {
  std::string all;
  for (int i = 0; i < bins; ++i) {
    if (counts_[i] == 0) continue;
    if (!all.empty()) all += ", ";
    all += std::to_string(i) + (i == bins - 1 ? " and more: " : ": ") +
           std::to_string(counts_[i]);
  }
  return all;
}

JointSweep joint_sweep(std::uint64_t inputs, std::uint64_t seed) {
  constexpr std::uint64_t inputs_of_a_path = 100;
  RandomSlips random(seed);
  JointSweep sweep;
  for (std::uint64_t i = 0; i < inputs; ++i) {
    RandomSlip input = random.next();
    const std::string label = "input " + std::to_string(i);
    const JointSolution s = input.joint.solve(input.slip());
    check_solution(input, s, label, sweep);
    sweep.cold.add(s.evaluations);
    run_fixed_point(input, s, sweep);
    ++sweep.scanned;
    if (!has_one_root(input, s)) {
      ++sweep.several_roots;
      sweep.several_roots_limit =
          std::min(sweep.several_roots_limit,
                   input.joint.contact().half_angle_law().limit_half_angle());
    }
    if (i % inputs_of_a_path == 0) follow(Path(input, random), sweep);

    constexpr double move = 1e-3;
    input.reaction += move * input.reaction.norm() * random.direction();
    input.rate += move * input.rate.norm() * random.direction();
    const JointSolution t = input.joint.solve(input.slip(), s);
    check_solution(input, t, label + " moved", sweep);
    sweep.warm.add(t.evaluations);
  }
  sweep.inputs = inputs;
  return sweep;
}

}  // namespace contact::test
