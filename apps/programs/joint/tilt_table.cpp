#include "programs/joint/tilt_table.hpp"

#include <fmt/format.h>

#include <limits>
#include <string>
#include <vector>

#include "cli/refuse.hpp"
#include "cli/stream/report.hpp"
#include "cli/sweep.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/pressure/validity.hpp"
#include "libcontact/quantities/finite_pin.hpp"

namespace hinge_joint {
namespace {

using contact::Dimension;
using contact::FinitePinSolution;
using Eigen::Vector2d;

// A pin that bends or jams is another joint long before.
constexpr cli::Allowed allowed_tilt{-10, 10, "deg"};

struct Problems {
  contact::LargestContact largest;
  std::size_t out_of_range = 0;
  std::size_t not_converged = 0;

  void add(const FinitePinSolution& s) {
    largest.add(s.contact.largest());
    out_of_range += s.contact.status == contact::Status::out_of_range ? 1 : 0;
    not_converged += s.contact.status == contact::Status::not_converged ? 1 : 0;
  }
};

cli::ExitStatus report(const Problems& problems) {
  if (problems.out_of_range + problems.not_converged == 0) {
    return cli::all_good;
  }
  cli::warn("hinge-joint",
            fmt::format("rows without a value: {}, rows that have not "
                        "converged: {}",
                        problems.out_of_range, problems.not_converged));
  return cli::some_bad;
}

using Columns = std::vector<contact::Column<FinitePinSolution>>;

// The rows of a joint.
class Rows {
 public:
  Rows(const Options& options, const cli::Joint& joint)
      : options_(options),
        differences_(joint.differences),
        spec_(with_friction(options, joint)),
        pin_(spec_),
        forces_("--reaction", options.reaction, allowed_force,
                Dimension::force),
        places_(is_placed() ? "--load-at" : "--tilt",
                is_placed() ? options.load_at : options.tilt,
                is_placed() ? cli::Allowed{-spec_.geometry.length() / 2,
                                           spec_.geometry.length() / 2, "m"}
                            : allowed_tilt,
                is_placed() ? Dimension::length : Dimension::angle) {}

  void write(const Columns& columns, cli::RowWriter& row, Problems& problems) {
    for (std::size_t i = 0; i < forces_.size(); ++i) {
      for (std::size_t k = 0; k < places_.size(); ++k) {
        const FinitePinSolution s = solved(forces_[i], places_[k]);
        problems.add(s);
        cli::write_differences(differences_, row);
        row.number(forces_[i]);
        if (is_placed()) row.number(places_[k]);
        for (const auto& column : columns) row.number(column(s) + 0.0);
        if (options_.pv) row.number(pin_.largest_pv(s.contact, rate()));
        row.end();
      }
    }
    for (const std::string& note :
         spec_.contact().limits().notes(problems.largest)) {
      cli::warn("hinge-joint", note);
    }
  }

 private:
  static contact::JointSpec with_friction(const Options& options,
                                          const cli::Joint& joint) {
    contact::JointSpec spec = joint.spec;
    spec.friction =
        cli::make_friction(options.friction, spec.friction, options.joint);
    return spec;
  }
  bool is_placed() const { return !options_.load_at.empty(); }
  double rate() const { return options_.rate.value_or(1); }
  FinitePinSolution solved(double force, double place) const {
    const Vector2d reaction(force, 0);
    if (is_placed()) return pin_.solve_at(reaction, place, rate());
    const Vector2d tilt(place, options_.twist.value_or(0));
    return pin_.solve(reaction, contact::degree * tilt, rate());
  }

  const Options& options_;
  std::vector<cli::Difference> differences_;
  contact::JointSpec spec_;
  contact::FinitePin pin_;
  cli::Sweep forces_;
  cli::Sweep places_;
};

}  // namespace

cli::ExitStatus run_tilted(const Options& options) {
  const std::vector<cli::Joint> joints = make_joints(options.joint);
  const Columns columns = columns_of(contact::finite_pin_quantities());
  std::vector<std::string> names = {"R_N"};
  if (!options.load_at.empty()) names.emplace_back("load_at_m");
  for (const auto& column : columns) names.push_back(column.name);
  if (options.pv) names.emplace_back("pv_max_W_per_m2");
  // All but that the relief is left out.
  std::vector<cli::Joint> level = joints;
  for (cli::Joint& joint : level) joint.spec.relief = contact::Relief::none();
  warn_of_validity("hinge-joint", level);
  Problems problems;
  cli::write_table(options.output, cli::joint_columns(joints, {names}),
                   [&](cli::RowWriter& row) {
                     for (const cli::Joint& joint : joints) {
                       problems.largest = {};
                       Rows(options, joint).write(columns, row, problems);
                     }
                   });
  return report(problems);
}

}  // namespace hinge_joint
