#include "pressure/run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "angle/input.hpp"
#include "cli/laws.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/quantity.hpp"
#include "cli/table.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/units.hpp"
#include "pressure/pressure_plot.hpp"
#include "pressure/pressure_table.hpp"

namespace hinge_pressure {
namespace {

using hinge_angle::Input;
using hinge_angle::Setup;

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
  const cli::OutputOptions& to = options.contact.output;
  cli::Output output(to.output);
  const cli::Table table(to.format, options.summary
                                        ? pressures.summary_columns()
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
  const Setup setup = hinge_angle::make_setup(options.contact);
  if (setup.half_angle_laws.size() != 1) {
    throw contact::Error("--law: one half-angle law here (see --help)");
  }
  const std::vector<NamedPressure> pressures = cli::make_pressure_laws(
      cli::pressure_laws(options.pressures.empty()
                             ? std::vector<std::string>{"all"}
                             : options.pressures,
                         {}, setup.conditions),
      setup.kind, setup.pair, setup.conditions);
  const Input input = hinge_angle::make_input(options.contact, setup);
  const int points = cli::parse_count("--points", options.points, 2, 1'000'000);
  const auto laws =
      cli::make_half_angle_laws(setup.half_angle_laws, setup.kind, setup.pair,
                                setup.half_angle_options, setup.conditions);
  cli::warn_of_validity("hinge-pressure", setup.geometry_notes(),
                        cli::LawNotes(laws, setup.pair));
  const LoadedContacts contacts(input, setup, *laws[0].law);
  const PressureTable table(setup, laws[0], pressures);
  Gaps gaps(pressures);
  write_table(table, contacts, points, options, gaps);
  const cli::ExitStatus status = gaps.report(laws[0].name);
  const std::string& picture = options.contact.output.plot;
  if (picture.empty()) return status;
  const std::string problem = draw(table, setup, pressures, contacts, picture);
  if (problem.empty()) return status;
  cli::warn("hinge-pressure", problem);
  return cli::some_bad;
}

}  // namespace hinge_pressure
