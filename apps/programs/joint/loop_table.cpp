#include "programs/joint/loop_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "cli/stream/report.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/magnitude.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/joint/fixed_point.hpp"
#include "libcontact/quantities/tables.hpp"

namespace hinge_joint {
namespace {

using contact::degree;
using contact::FixedPointStep;
using contact::JointSolution;
using contact::Status;
using Eigen::Vector3d;

using contact::detail::nan;
constexpr int step_limit = 1000;
constexpr int round_limit = 200;
// Change of M from round to round, relative.
constexpr double outer_tolerance = 1e-12;

// Writes a table of numbers of one joint.
// @param write  given the function that writes a row of values; how many of
// them, from
//               the first, are whole numbers
template <class Rows>
void write_numbers(const NamedJoint& joint,
                   const std::vector<std::string>& columns,
                   const Beside& beside, const cli::OutputOptions& options,
                   const Rows& write) {
  std::vector<std::string> names = with_beside(columns, beside);
  names.insert(names.begin(), {"law", "pressure"});
  cli::write_table(options, names, [&](cli::RowWriter& row) {
    std::size_t number = 0;
    write([&](std::span<const double> values, std::size_t counts) {
      ++number;
      row.text(joint.law);
      row.text(joint.pressure);
      for (std::size_t i = 0; i < counts; ++i) {
        row.count(static_cast<std::size_t>(values[i]));
      }
      for (std::size_t i = counts; i < columns.size(); ++i) {
        write_number(row, values[i], columns[i], number, beside);
      }
      row.end();
    });
  });
}

// Keys of the contact's quantities that both loops print, in order.
constexpr const char* contact_keys[] = {"friction_angle", "slip_axis_angle",
                                        "normal_force",   "adhesion_number",
                                        "load_parameter", "half_angle"};

void add_columns(std::span<const char* const> keys,
                 std::vector<std::string>& to) {
  for (const char* key : keys) {
    const auto& q = *find_quantity(contact::solution_quantities(), key);
    for (const auto& column : contact::columns_of(q)) to.push_back(column.name);
  }
}

std::vector<std::string> step_columns() {
  std::vector<std::string> names = {"step"};
  add_columns(contact_keys, names);
  constexpr const char* coefficient[] = {"force_coefficient"};
  add_columns(coefficient, names);
  return names;
}

std::vector<double> step_values(const FixedPointStep& step) {
  return {static_cast<double>(step.step), step.friction_angle / degree,
          step.slip_axis_angle / degree,  step.normal_force,
          step.adhesion_number,           step.load_parameter,
          step.half_angle / degree,       step.friction_coefficient};
}

void warn_of(const contact::FixedPointResult& result) {
  cli::warn("hinge-joint",
            result.status == Status::not_converged
                ? fmt::format("the inner loop has not converged in {} steps: "
                              "|f/tan g - 1| is still {:.1e}",
                              result.steps, result.residual)
                : fmt::format("the inner loop fails after step {}: g is above "
                              "b, and (4.2) then has no solution a",
                              result.steps));
}

// Contact under R at the friction angle of f, with M_t of an unfinished state
// of the inner loop.
JointSolution contact_at(const contact::Joint& joint,
                         const contact::Joint::Slip& slip, double f) {
  const Vector3d& reaction = slip.reaction;
  const Vector3d& rate = slip.angular_velocity;
  const double force = contact::magnitude(reaction);
  const double cos_b =
      joint.is_pin() ? 0
                     : reaction.dot(rate) / force / contact::magnitude(rate);
  const double cos_g = 1 / std::hypot(1, f);
  const double sin_a = cos_b / cos_g;
  const double cos_a = std::sqrt((1 - sin_a) * (1 + sin_a));
  return joint.solve_contact(
      {.normal_force = force * cos_g * Vector3d(cos_a, 0, sin_a),
       .angular_velocity = {0, 0, contact::magnitude(rate)}});
}

// Runs the rounds of the outer loop.
class OuterLoop {
 public:
  OuterLoop(const NamedJoint& joint, const Input& input, const Options& options)
      : joint_(joint), input_(input), law_(options) {}

  double moment() const { return moment_; }
  Vector3d reaction() const { return input_.force + moment_ * *law_.outer; }
  /// The contact of the previous round, to which moment() belongs.
  const JointSolution& contact() const { return contact_; }
  /// Its g, from R_n = R cos g; the contact itself may give another value.
  double friction_angle() const { return std::atan(friction_); }
  const std::vector<FixedPointStep>& steps() const { return steps_; }
  bool converged() const { return converged_; }

  /// Runs one round. With `trace` it uses the inner loop, else the solver
  /// unless a number of steps is given.
  contact::FixedPointResult next(std::size_t round, bool trace) {
    contact::FixedPointResult result = {Status::ok, 0, 0};
    const contact::Joint::Slip slip = {.reaction = reaction(),
                                       .angular_velocity = input_.turn};
    if (trace || !law_.inner_steps.empty()) {
      steps_.resize(
          law_.inner_steps.empty()
              ? step_limit
              : law_.inner_steps[std::min(round, law_.inner_steps.size() - 1)]);
      result = contact::fixed_point(
          joint_.joint, slip, steps_,
          {.step_limit = static_cast<int>(steps_.size()), .start = friction_});
      steps_.resize(result.steps);
      if (!steps_.empty()) friction_ = steps_.back().friction_coefficient;
      contact_ = contact_at(joint_.joint, slip, friction_);
      // Reaching a requested number of steps is not a failure.
      if (!law_.inner_steps.empty() && result.status == Status::not_converged) {
        result.status = Status::ok;
      }
    } else {
      contact_ = joint_.joint.solve(slip);
      friction_ = contact_.force_coefficient;
      result.status = contact_.status;
    }
    const double before = moment_;
    // M about Dw of all joints; power = M_t . Dw.
    moment_ = -law_.joints * contact_.power / contact::magnitude(input_.turn);
    converged_ = std::abs(moment_ - before) <= outer_tolerance * moment_;
    return result;
  }

 private:
  const NamedJoint& joint_;
  const Input& input_;
  const Options& law_;
  double moment_ = 0;
  double friction_ = 0;
  bool converged_ = false;
  JointSolution contact_;
  std::vector<FixedPointStep> steps_;
};

std::vector<double> round_values(const OuterLoop& loop, std::size_t round,
                                 const std::optional<double>& braking) {
  const Vector3d r = loop.reaction();
  std::vector<double> values = {static_cast<double>(round + 1), loop.moment()};
  if (braking) values.push_back(*braking * loop.moment());
  for (const double value : {contact::magnitude(r), r.x(), r.y(), r.z()}) {
    values.push_back(value);
  }
  const JointSolution& s = loop.contact();
  for (const double value :
       {loop.friction_angle() / degree, s.slip_axis_angle() / degree,
        s.normal_force, s.adhesion_number, s.load_parameter,
        s.half_angle / degree}) {
    values.push_back(round == 0 ? nan : value);
  }
  return values;
}

}  // namespace

cli::ExitStatus write_trace(const NamedJoint& joint, const Input& input,
                            const Beside& beside,
                            const cli::OutputOptions& options) {
  std::vector<FixedPointStep> steps(step_limit);
  const auto result =
      contact::fixed_point(joint.joint, {input.force, input.turn}, steps,
                           {.step_limit = step_limit});
  write_numbers(joint, step_columns(), beside, options, [&](const auto& row) {
    for (int i = 0; i < result.steps; ++i) row(step_values(steps[i]), 1);
  });
  if (result.status == Status::ok) return cli::all_good;
  warn_of(result);
  return cli::some_bad;
}

cli::ExitStatus write_outer(const NamedJoint& joint, const Input& input,
                            const Options& options, const Beside& beside) {
  const bool inner = options.trace;
  std::vector<std::string> columns = {"round"};
  if (inner) {
    for (std::string& name : step_columns()) {
      columns.push_back(std::move(name));
    }
  } else {
    columns.emplace_back("M_N_m");
    if (options.braking) columns.emplace_back("braking_deg_per_s2");
    constexpr const char* reaction[] = {"reaction"};
    add_columns(reaction, columns);
    add_columns(contact_keys, columns);
  }
  OuterLoop loop(joint, input, options);
  contact::FixedPointResult result = {Status::ok, 0, 0};
  const auto write = [&](const auto& row) {
    for (std::size_t round = 0; round < round_limit; ++round) {
      if (!inner) row(round_values(loop, round, options.braking), 1);
      if (loop.converged()) return;
      result = loop.next(round, inner);
      if (inner) {
        for (const FixedPointStep& step : loop.steps()) {
          std::vector<double> values = step_values(step);
          values.insert(values.begin(), static_cast<double>(round + 1));
          row(values, 2);
        }
      }
      if (result.status != Status::ok) return;
    }
  };
  write_numbers(joint, columns, beside, options.output, write);
  if (result.status != Status::ok) {
    warn_of(result);
    return cli::some_bad;
  }
  if (loop.converged()) return cli::all_good;
  cli::warn("hinge-joint",
            fmt::format("the outer loop has not converged in {} rounds",
                        round_limit));
  return cli::some_bad;
}

}  // namespace hinge_joint
