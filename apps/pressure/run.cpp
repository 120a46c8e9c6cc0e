#include "pressure/run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "angle/input.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/quantity.hpp"
#include "cli/table.hpp"
#include "libcontact/base/units.hpp"
#include "pressure/pressure_plot.hpp"
#include "pressure/pressure_table.hpp"

namespace hinge_pressure {
namespace {

using hinge_angle::Input;

// Loads without a half-angle, or one that has not converged, and half-angles
// beyond a pressure law.
class Gaps {
 public:
  explicit Gaps(const std::vector<NamedPressure>& pressures)
      : pressures_(pressures), beyond_(pressures.size()) {}

  void add(const LoadedContact& contact) {
    ++all_;
    if (std::isnan(contact.half_angle)) ++none_;
    if (contact.status == contact::Status::not_converged) ++rough_;
    for (std::size_t i = 0; i < beyond_.size(); ++i) {
      const double largest = pressures_[i].law->largest_half_angle();
      if (contact.half_angle > largest) ++beyond_[i];
    }
  }

  cli::ExitStatus report(const std::string& half_angle_law) const {
    const auto say = [](const std::string& text) {
      cli::warn("hinge-pressure", text);
    };
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
    for (std::size_t i = 0; i < beyond_.size(); ++i) {
      if (beyond_[i] == 0) continue;
      const double largest = pressures_[i].law->largest_half_angle();
      say(fmt::format(
          "pressure {}: none for {} of {} loads, whose half-angle "
          "is above {:.6g} deg",
          pressures_[i].name, beyond_[i], all_, largest / contact::degree));
    }
    return rough_ > 0 ? cli::some_bad : cli::all_good;
  }

 private:
  const std::vector<NamedPressure>& pressures_;
  std::size_t all_ = 0;
  std::size_t none_ = 0;
  std::size_t rough_ = 0;
  std::vector<std::size_t> beyond_;  // of each pressure law
};

void write_table(const PressureTable& pressures, const LoadedContacts& contacts,
                 int points, const Options& options, Gaps& gaps) {
  const cli::OutputOptions& to = options.output;
  cli::Output output(to.output);
  const cli::Table table(to, options.summary ? pressures.summary_columns()
                                             : pressures.profile_columns());
  cli::TableWriter writer(output, table);
  cli::Text rows;
  cli::Progress progress("loads", contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const LoadedContact contact = contacts[i];
    gaps.add(contact);
    rows.clear();
    cli::RowWriter row(table, rows);
    if (options.summary) {
      pressures.write_summary(contact, row);
    } else {
      pressures.write_profile(contact, points, row);
    }
    writer.write(rows.view());
    progress.add(1);
  }
  writer.finish();
  output.commit();
}

}  // namespace

cli::ExitStatus run(const Options& options) {
  const cli::Joint joint = make_joint(options.joint);
  const Input input = make_input(options.load, joint);
  const int points = cli::parse_count("--points", options.points, 2, 1'000'000);
  warn_of_validity("hinge-pressure", joint);
  const LoadedContacts contacts(input, joint);
  const PressureTable table(joint);
  Gaps gaps(joint.pressures);
  write_table(table, contacts, points, options, gaps);
  const cli::ExitStatus status = gaps.report(joint.laws[0].name);
  if (options.output.plot.empty()) return status;
  return cli::drawn("hinge-pressure",
                    draw(table, joint, contacts, options.output.plot), status);
}

}  // namespace hinge_pressure
