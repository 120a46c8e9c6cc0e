#include "programs/pressure/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cli/joint/joint_reports.hpp"
#include "cli/output.hpp"
#include "cli/quantity.hpp"
#include "cli/stream/row_blocks.hpp"
#include "cli/table.hpp"
#include "libcontact/base/units.hpp"
#include "programs/angle/input.hpp"
#include "programs/angle/limits.hpp"
#include "programs/pressure/placed_contacts.hpp"
#include "programs/pressure/pressure_plot.hpp"
#include "programs/pressure/pressure_table.hpp"

namespace hinge_pressure {
namespace {

using hinge_angle::Input;

// Special contacts of one joint: loads without a half-angle or without
// convergence, half-angles beyond a pressure law, the largest contact.
class Findings {
 public:
  Findings(const cli::Joint& joint, const PressureTable& table)
      : joint_(joint),
        table_(table),
        limits_(hinge_angle::limits_of(joint)),
        beyond_(joint.pressures.size()),
        peak_(joint.pressures.size()) {}

  void add(const LoadedContact& contact) {
    ++all_;
    if (std::isnan(contact.half_angle)) ++none_;
    if (contact.status == contact::Status::not_converged) ++rough_;
    // Comparisons with NaN are false.
    if (contact.half_angle > half_angle_) half_angle_ = contact.half_angle;
    for (std::size_t i = 0; i < beyond_.size(); ++i) {
      const NamedPressure& law = joint_.pressures[i];
      if (contact.half_angle > largest_half_angle(law)) ++beyond_[i];
      if (!joint_.has_size) continue;
      const double peak = table_.pressure(i, contact, 0);
      if (peak > peak_[i]) peak_[i] = peak;
    }
  }

  cli::ExitStatus report() const {
    const std::string& half_angle_law = joint_.laws[0].name;
    if (none_ > 0) {
      say(
          fmt::format("law {}: no half-angle for {} of {} loads, which are "
                      "outside its range",
                      half_angle_law, none_, all_));
    }
    if (rough_ > 0) {
      say(fmt::format("law {}: {} of {} half-angles have not converged",
                      half_angle_law, rough_, all_));
    }
    for (const auto& note : limits_.notes({half_angle_, 0})) {
      say(fmt::format("law {}: {}", half_angle_law, note));
    }
    for (std::size_t i = 0; i < beyond_.size(); ++i) report_pressure(i);
    const bool good = none_ + rough_ == 0 && std::ranges::max(beyond_) == 0;
    return good ? cli::all_good : cli::some_bad;
  }

 private:
  double largest_half_angle(const NamedPressure& law) const {
    return joint_.spec.conditions().clearance == contact::Clearance::positive
               ? law.law->largest_half_angle()
               : law.law->closing_half_angle();
  }
  void report_pressure(std::size_t i) const {
    const NamedPressure& law = joint_.pressures[i];
    if (beyond_[i] > 0) {
      const double largest = largest_half_angle(law);
      say(
          fmt::format("pressure {}: none for {} of {} loads, whose half-angle "
                      "is above {:.6g} deg",
                      law.name, beyond_[i], all_, largest / contact::degree));
    }
    for (const auto& note : limits_.notes({0, peak_[i]})) {
      say(fmt::format("pressure {}: {}", law.name, note));
    }
  }
  void say(const std::string& text) const {
    cli::warn("hinge-pressure", said_of(joint_, text));
  }

  const cli::Joint& joint_;
  const PressureTable& table_;
  contact::ContactLimits limits_;
  std::size_t all_ = 0;
  std::size_t none_ = 0;
  std::size_t rough_ = 0;
  double half_angle_ = 0;
  std::vector<std::size_t> beyond_;  // for each pressure law
  std::vector<double> peak_;
};

std::vector<std::string> columns(const std::vector<cli::Joint>& joints,
                                 const std::vector<PressureTable>& tables,
                                 bool summary) {
  std::vector<std::vector<std::string>> names;
  for (const PressureTable& table : tables) {
    names.push_back(summary ? table.summary_columns()
                            : table.profile_columns());
  }
  return joint_columns(joints, names);
}

cli::ExitStatus write_table(const std::vector<cli::Joint>& joints,
                            const std::vector<PressureTable>& tables,
                            const std::vector<LoadedContacts>& contacts,
                            const cli::Table& table, const Options& options) {
  cli::Output output(options.output.output);
  std::vector<Findings> findings;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    findings.emplace_back(joints[j], tables[j]);
  }
  const std::size_t each = contacts[0].size();
  // Each load has many rows.
  cli::NumberedRows loads(joints.size() * each, 1);
  cli::write_rows<cli::RowBlock>(
      options.output, output, table, loads, "loads",
      [&](const cli::RowBlock& block, cli::RowWriter& row) {
        const std::size_t j = block.first / each;
        const LoadedContact contact = contacts[j][block.first % each];
        findings[j].add(contact);
        if (options.summary) {
          tables[j].write_summary(contact, row);
        } else {
          tables[j].write_profile(
              contact, options.points > 0 ? options.points : 101, row);
        }
      },
      [](const cli::RowBlock&) {});
  cli::ExitStatus status = cli::all_good;
  for (const Findings& found : findings) {
    status = std::max(status, found.report());
  }
  return status;
}

}  // namespace

cli::ExitStatus run(const Options& options) {
  if (!options.direction.empty() || options.tilt.given()) {
    return run_placed(options);
  }
  // A profile of 101 rows is too long to read.
  if (options.output.format == cli::Format::report && options.points == 0 &&
      !options.summary) {
    Options summary = options;
    summary.summary = true;
    return run(summary);
  }
  const std::vector<cli::Joint> joints = make_joints(options.joint);
  std::vector<Input> inputs;
  for (const cli::Joint& joint : joints) {
    inputs.push_back(make_input(options.load, joint));
  }
  std::vector<LoadedContacts> contacts;
  std::vector<PressureTable> tables;
  const bool preload = cli::JointPreload::any_of(joints);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    contacts.emplace_back(inputs[i], joints[i]);
    tables.emplace_back(joints[i], preload);
  }
  const cli::Table table(options.output.titled(shared_title(joints, "")),
                         columns(joints, tables, options.summary));
  const bool plot = !options.output.plot.empty();
  if (plot) check_curves(joints);
  warn_of_validity("hinge-pressure", joints);
  const cli::ExitStatus status =
      write_table(joints, tables, contacts, table, options);
  if (!plot) return status;
  return cli::drawn("hinge-pressure",
                    draw(tables, joints, contacts, options.output.plot),
                    status);
}

}  // namespace hinge_pressure
