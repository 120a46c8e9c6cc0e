#include "pressure/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "angle/input.hpp"
#include "angle/loads.hpp"
#include "cli/laws.hpp"
#include "cli/output.hpp"
#include "cli/quantity.hpp"
#include "cli/table.hpp"
#include "libcontact/error.hpp"
#include "libcontact/units.hpp"
#include "pressure/pressure_plot.hpp"
#include "pressure/pressure_table.hpp"

namespace hinge_pressure {
namespace {

using hinge_angle::Input;
using hinge_angle::LoadVariable;
using hinge_angle::Setup;

int point_count(const std::string& text) {
  const double points = cli::parse_value("--points", text, {2, 1e6, ""});
  if (points != std::floor(points)) {
    throw contact::Error(
        fmt::format("--points {}: allowed is a whole number", text));
  }
  return static_cast<int>(points);
}

std::vector<LoadedContact> make_contacts(const Input& input,
                                         const Setup& setup) {
  const auto laws = cli::make_half_angle_laws(
      setup.half_angle_laws, setup.kind, setup.pair, setup.half_angle_options);
  cli::warn_of_validity("hinge-pressure", setup.geometry_notes(),
                        cli::LawNotes(laws, setup.pair));
  const hinge_angle::Loads loads(setup.kind, setup.geometry, setup.pair);
  std::vector<LoadedContact> contacts;
  for (std::size_t i = 0; i < input.values.size(); ++i) {
    const double parameter = loads.convert(input.variable, input.values[i],
                                           LoadVariable::load_parameter);
    const double load =
        loads.have_load()
            ? loads.convert(input.variable, input.values[i], LoadVariable::load)
            : parameter;
    const auto result = laws[0].law->half_angle(parameter);
    contacts.push_back({load, parameter, result.half_angle, result.status});
  }
  return contacts;
}

// Loads without a half-angle, or one that has not converged, and half-angles
// beyond a pressure law.
cli::ExitStatus report_gaps(const std::vector<LoadedContact>& contacts,
                            const std::vector<NamedPressure>& pressures,
                            const std::string& half_angle_law) {
  const auto gap = [](const LoadedContact& c) {
    return std::isnan(c.half_angle);
  };
  const auto gaps = std::count_if(contacts.begin(), contacts.end(), gap);
  if (gaps > 0) {
    cli::warn("hinge-pressure",
              fmt::format("law {}: no half-angle for {} of {} loads, which "
                          "are outside its range",
                          half_angle_law, gaps, contacts.size()));
  }
  const auto rough = [](const LoadedContact& c) {
    return c.status == contact::Status::not_converged;
  };
  const auto roughs = std::count_if(contacts.begin(), contacts.end(), rough);
  if (roughs > 0) {
    cli::warn("hinge-pressure",
              fmt::format("law {}: {} of {} half-angles have not converged",
                          half_angle_law, roughs, contacts.size()));
  }
  for (const NamedPressure& law : pressures) {
    const double largest = law.law->largest_half_angle();
    const auto beyond = [&](const LoadedContact& c) {
      return c.half_angle > largest;
    };
    const auto count = std::count_if(contacts.begin(), contacts.end(), beyond);
    if (count == 0) continue;
    cli::warn("hinge-pressure",
              fmt::format("pressure {}: none for {} of {} loads, whose "
                          "half-angle is above {:.6g} deg",
                          law.name, count, contacts.size(),
                          largest / contact::degree));
  }
  return roughs > 0 ? cli::some_bad : cli::all_good;
}

void write_table(const PressureTable& pressures,
                 const std::vector<LoadedContact>& contacts,
                 const Options& options) {
  const int points = point_count(options.points);
  const cli::OutputOptions& to = options.contact.output;
  cli::Output output(to.output);
  const cli::Table table(to.format, options.summary
                                        ? pressures.summary_columns()
                                        : pressures.profile_columns());
  cli::TableWriter writer(output, table);
  cli::Text rows;
  for (const LoadedContact& contact : contacts) {
    rows.clear();
    cli::RowWriter row(table, rows);
    if (options.summary) {
      pressures.write_summary(contact, row);
    } else {
      pressures.write_profile(contact, points, row);
    }
    writer.write(rows.view());
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
      cli::pressure_laws(options.pressures, contact::pressure_law_names()),
      setup.kind, setup.pair);
  const Input input = hinge_angle::make_input(options.contact, setup);
  const auto contacts = make_contacts(input, setup);
  const PressureTable table(setup, pressures);
  write_table(table, contacts, options);
  const cli::ExitStatus status =
      report_gaps(contacts, pressures, setup.half_angle_laws.front());
  const std::string& picture = options.contact.output.plot;
  if (picture.empty()) return status;
  const std::string problem = draw(table, setup, pressures, contacts, picture);
  if (problem.empty()) return status;
  cli::warn("hinge-pressure", problem);
  return cli::some_bad;
}

}  // namespace hinge_pressure
