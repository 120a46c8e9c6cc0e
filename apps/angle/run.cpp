#include "angle/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "angle/angle_table.hpp"
#include "cli/ordered_blocks.hpp"
#include "cli/output.hpp"
#include "cli/plot.hpp"
#include "cli/progress.hpp"
#include "cli/sweep.hpp"
#include "cli/table.hpp"
#include "libcontact/error.hpp"
#include "libcontact/units.hpp"

namespace hinge_angle {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<NamedLaw> make_laws(const Setup& setup) {
  std::vector<NamedLaw> laws;
  for (const std::string& name : setup.half_angle_laws) {
    laws.push_back(
        {name, contact::make_half_angle_law(name, setup.kind, setup.pair,
                                            setup.half_angle_options)});
  }
  return laws;
}

// What is swept: a load in one of its variables, or the half-angle.
struct Input {
  LoadVariable variable;
  bool inverse;
  cli::Sweep values;
};

Input make_input(const Options& options, const Setup& setup) {
  if (options.inverse || !options.theta0.empty()) {
    if (!options.inverse || options.theta0.empty() || !options.load.empty() ||
        !options.load_parameter.empty() || !options.x.empty()) {
      throw contact::Error("--inverse and --theta0: belong together, no load");
    }
    // Curves are drawn over the load where there is one.
    return {setup.geometry ? LoadVariable::load : LoadVariable::load_parameter,
            true, cli::Sweep("--theta0", options.theta0, {0, 180, "deg"})};
  }
  const bool sphere = setup.kind == contact::JointKind::spherical;
  struct Source {
    std::string_view option;
    const std::string& text;
    LoadVariable variable;
    std::string_view unit;
  };
  const std::array<Source, 3> sources = {{
      {"--load", options.load, LoadVariable::load, sphere ? "N" : "N/m"},
      {"--load-parameter", options.load_parameter, LoadVariable::load_parameter,
       ""},
      {"--x", options.x, LoadVariable::x, ""},
  }};
  const auto given = [](const Source& source) { return !source.text.empty(); };
  if (std::count_if(sources.begin(), sources.end(), given) != 1) {
    throw contact::Error(
        "needs one of --load, --load-parameter, --x, or --inverse with "
        "--theta0 (see hinge-angle --help)");
  }
  const Source& source = *std::find_if(sources.begin(), sources.end(), given);
  if (source.variable == LoadVariable::load && !setup.geometry) {
    throw contact::Error(
        "--load: a dimensionless joint takes --load-parameter or --x; a load "
        "needs --radius and --clearance");
  }
  return {source.variable, false,
          cli::Sweep(source.option, source.text, {0, infinity, source.unit})};
}

// Some rows on their way through the program.
struct Block {
  std::size_t first;
  std::size_t last;
  cli::Text rows;
  std::vector<Failures> failures;
};

// Writes the table; returns what the laws could not give.
std::vector<Failures> write_table(const AngleTable& angles, const Input& input,
                                  std::size_t laws,
                                  const cli::OutputOptions& options) {
  constexpr std::size_t block_rows = 256;
  cli::Output output(options.output);
  const cli::Table table(options.format, input.inverse
                                             ? angles.inverse_columns()
                                             : angles.columns());
  cli::TableWriter writer(output, table);
  cli::Progress progress("rows", input.values.size());
  std::vector<Failures> failures(laws);
  std::size_t taken = 0;
  cli::ordered_blocks<Block>(
      options.jobs,
      [&](Block& block) {
        block.first = taken;
        block.last = taken = std::min(taken + block_rows, input.values.size());
        return block.first < block.last;
      },
      [&](Block& block) {
        block.rows.clear();
        block.failures.assign(laws, {});
        cli::RowWriter row(table, block.rows);
        for (std::size_t i = block.first; i < block.last; ++i) {
          if (input.inverse) {
            angles.write_inverse_row(input.values[i], row, block.failures);
          } else {
            angles.write_row(input.variable, input.values[i], row,
                             block.failures);
          }
        }
      },
      [&](const Block& block) {
        writer.write(block.rows.view());
        progress.add(block.last - block.first);
        for (std::size_t i = 0; i < laws; ++i) {
          failures[i].out_of_range += block.failures[i].out_of_range;
          failures[i].not_converged += block.failures[i].not_converged;
        }
      });
  writer.finish();
  output.commit();
  return failures;
}

std::string load_label(LoadVariable variable, contact::JointKind kind) {
  const bool sphere = kind == contact::JointKind::spherical;
  switch (variable) {
    case LoadVariable::load:
      return sphere ? "compressive force, N" : "force per unit length, N/m";
    case LoadVariable::x:
      return sphere ? "x = cbrt(μ)" : "x = 2 sqrt(λ)";
    case LoadVariable::load_parameter:
      break;
  }
  return sphere ? "load parameter μ" : "load parameter λ";
}

// Half-angle of every law over the load.
std::string draw(const AngleTable& angles, const Input& input,
                 const Setup& setup, const std::vector<NamedLaw>& laws,
                 const std::string& file) {
  // What a picture of some 1,000 dots across can show.
  constexpr std::size_t most_points = 1000;
  const std::size_t count = input.values.size();
  const std::size_t points = std::min(count, most_points);

  cli::LinePlot plot;
  plot.title = fmt::format("{} joint", to_string(setup.kind));
  plot.x_label = load_label(input.variable, setup.kind);
  plot.y_label = "contact half-angle θ₀, deg";
  plot.logarithmic_x = input.values.is_logarithmic();
  for (const NamedLaw& law : laws) {
    cli::Curve curve{law.name, {}, {}, false};
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t index =
          points == 1 ? 0 : i * (count - 1) / (points - 1);
      const double value = input.values[index];
      if (input.inverse) {
        curve.x.push_back(angles.convert(
            LoadVariable::load_parameter,
            law.law->load_parameter(value * contact::degree).load_parameter,
            input.variable));
        curve.y.push_back(value);
      } else {
        curve.x.push_back(value);
        curve.y.push_back(
            law.law
                ->half_angle(angles.convert(input.variable, value,
                                            LoadVariable::load_parameter))
                .half_angle /
            contact::degree);
      }
    }
    plot.curves.push_back(std::move(curve));
  }
  return cli::draw(plot, file);
}

// Warns of the use of the joint and the laws outside their ranges, once for
// each reason.
void print_validity(const Setup& setup, const std::vector<NamedLaw>& laws) {
  if (setup.geometry) {
    for (const std::string& text : setup.geometry->validity_notes()) {
      cli::warn("hinge-angle", text);
    }
  }
  std::map<std::string, std::string> laws_by_reason;
  for (const NamedLaw& law : laws) {
    for (const std::string& text : law.law->validity_notes(setup.pair)) {
      std::string& names = laws_by_reason[text];
      names += (names.empty() ? "" : ", ") + law.name;
    }
  }
  for (const auto& [text, names] : laws_by_reason) {
    cli::warn("hinge-angle", fmt::format("law {}: {}", names, text));
  }
}

}  // namespace

cli::ExitStatus run(const Options& options) {
  const Setup setup = make_setup(options);
  const std::vector<NamedLaw> laws = make_laws(setup);
  const auto pressure =
      contact::make_pressure_law(setup.pressure_law, setup.kind);
  const AngleTable angles(setup, laws, *pressure);
  const Input input = make_input(options, setup);
  print_validity(setup, laws);

  const auto failures = write_table(angles, input, laws.size(), options.output);
  cli::ExitStatus status = cli::all_good;
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const auto [out_of_range, not_converged] = failures[i];
    if (out_of_range > 0) {
      cli::warn("hinge-angle",
                fmt::format("law {}: no value for {} of {} rows, which "
                            "are outside its range",
                            laws[i].name, out_of_range, input.values.size()));
    }
    if (not_converged > 0) {
      cli::warn("hinge-angle",
                fmt::format("law {}: {} of {} rows have not converged",
                            laws[i].name, not_converged, input.values.size()));
      status = cli::some_bad;
    }
  }
  if (options.output.plot.empty()) return status;
  const std::string problem =
      draw(angles, input, setup, laws, options.output.plot);
  if (problem.empty()) return status;
  cli::warn("hinge-angle", problem);
  return cli::some_bad;
}

}  // namespace hinge_angle
