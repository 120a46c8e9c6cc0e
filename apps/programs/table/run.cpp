#include "programs/table/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/choice.hpp"
#include "cli/output.hpp"
#include "cli/plot.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/line_blocks.hpp"
#include "cli/stream/points.hpp"
#include "cli/sweep.hpp"
#include "cli/table.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/pressure/registry.hpp"
#include "libcontact/quantities/tables.hpp"
#include "programs/table/elliptic_table.hpp"
#include "programs/table/method.hpp"
#include "programs/table/operation_table.hpp"
#include "programs/table/point_block.hpp"

namespace hinge_table {
namespace {

using cli::given;

// The quantity of printed tables and pictures.
std::size_t quantity_index(const std::string& name) {
  std::vector<cli::Choice<std::size_t>> choices;
  for (std::size_t i = 0; i < quantities().size(); ++i) {
    choices.push_back({quantities()[i].symbol, i});
  }
  return cli::choice("--quantity", name.empty() ? "chi" : name, choices);
}

double tolerance_of(const Options& options) {
  if (options.tolerance.empty()) return 1e-10;
  if (options.method != "quadrature") {
    cli::refuse_without(given("--tolerance", options.tolerance),
                        "--method quadrature");
  }
  return cli::parse_value("--tolerance", options.tolerance, {1e-13, 1e-2, ""});
}

// A ball whose pressure may affect the table; rejects options without effect.
cli::Joint make_ball(const cli::JointOptions& options) {
  cli::Joint ball = make_joint(options);
  const std::string materials = options.materials();
  const std::string name = ball.pressures[0].law->name();
  using Needs = contact::detail::LawEntry::Needs;
  const Needs needs = contact::detail::find_pressure_entry(name)->about.needs;
  const bool by_materials = needs != Needs::nothing;
  if (by_materials && materials.empty()) {
    cli::refuse_without(given("--pressure", name),
                        "materials by --joint, --pair or "
                        "--modulus-ratio");
  }
  if (!options.loading.empty() && needs != Needs::conditions) {
    cli::refuse_without(given("--loading", options.loading),
                        "--pressure exact");
  }
  // A file may only name a pressure law other than the default.
  const bool named =
      options.pressures.empty() && name != contact::default_pressure_law;
  if (!materials.empty() && !by_materials && !named) {
    std::vector<std::string> laws;
    for (const auto* entry : contact::detail::pressure_entries()) {
      if (entry->about.needs != Needs::nothing) {
        laws.emplace_back(entry->about.name);
      }
    }
    cli::refuse_without(materials,
                        fmt::format("--pressure {}: the other laws do not "
                                    "depend on the materials",
                                    contact::detail::either(laws)));
  }
  return ball;
}

// The name of a quantity; for quantities that depend on the pressure also the
// pressure.
std::string quantity_name(std::size_t quantity, const Method& method) {
  const std::string_view name = quantities()[quantity].symbol;
  return name.ends_with("_a") ? std::string(name)
                              : fmt::format("{}_{}", name, method.pressure);
}

std::vector<std::string> column_names(const Method& method,
                                      std::vector<std::string> riding) {
  std::vector<std::string> names = {"theta0_deg", "alpha_deg"};
  for (std::size_t i = 0; i < quantities().size(); ++i) {
    names.push_back(quantity_name(i, method));
  }
  riding = cli::distinct_names(std::move(riding), names);
  names.insert(names.end(), riding.begin(), riding.end());
  return names;
}

// Counts faults over a whole table.
struct Problems {
  std::size_t bad_lines = 0;
  std::size_t inaccurate = 0;
  std::size_t beyond = 0;
  std::size_t failed = 0;

  void add(const PointBlock& block) {
    bad_lines += block.bad_lines;
    inaccurate += block.inaccurate;
    beyond += block.beyond;
    failed += block.failed;
  }
};

// A table of points from a file or standard input.
Problems write_points(const Options& options, const Method& method) {
  cli::LineReader reader(options.points);
  const cli::PointHeader header = cli::read_header(reader, options.output);
  const cli::PointColumns columns(header, point_columns);
  cli::Output output(options.output.output);
  const cli::Table table(options.output, column_names(method, columns.riding));
  cli::PointRows rows(reader);
  Problems problems;
  cli::write_rows<PointBlock>(
      options.output, output, table, rows, "points",
      [&](PointBlock& block, cli::RowWriter& row) {
        cli::read_points(columns, block);
        compute(method, block);
        write_rows(columns, block, row);
      },
      [&](const PointBlock& block) { problems.add(block); });
  return problems;
}

// All pairs of half-angles and slip axis angles; alpha varies fastest.
struct Grid {
  cli::Sweep theta0;
  cli::Sweep alpha;
  std::size_t size() const { return theta0.size() * alpha.size(); }
};

// Writes a table of a grid; `write` makes the rows of its points.
template <class Write>
Problems write_blocks(const Grid& grid, std::size_t block_size,
                      const Method& method, const cli::OutputOptions& options,
                      const cli::Table& table, const Write& write) {
  cli::Output output(options.output);
  cli::NumberedRows rows(grid.size(), block_size);
  Problems problems;
  cli::write_rows<PointBlock>(
      options, output, table, rows, "points",
      [&](PointBlock& block, cli::RowWriter& row) {
        take_grid_points(grid.theta0, grid.alpha, block);
        compute(method, block);
        write(block, row);
      },
      [&](const PointBlock& block) { problems.add(block); });
  return problems;
}

// A row for each point.
Problems write_list(const Grid& grid, const Method& method,
                    const cli::OutputOptions& options) {
  // Large compared with the cost of passing a block between threads, but small
  // enough for the cache.
  constexpr std::size_t block_rows = 1024;
  const cli::Table table(options, column_names(method, {}));
  return write_blocks(grid, block_rows, method, options, table,
                      [](const PointBlock& block, cli::RowWriter& row) {
                        write_rows(block, row);
                      });
}

// One quantity, theta0 down, alpha across.
Problems write_two_way(const Grid& grid, const Method& method,
                       std::size_t quantity,
                       const cli::OutputOptions& options) {
  const auto corner = [&](const char* down_and_across) {
    return fmt::format("{}: {}", quantity_name(quantity, method),
                       down_and_across);
  };
  std::vector<std::string> names = {corner("theta0_deg, alpha_deg")};
  for (std::size_t i = 0; i < grid.alpha.size(); ++i) {
    names.push_back(cli::number_text(grid.alpha[i]));
  }
  if (cli::Table(options, names).is_turned()) {
    names[0] = corner("alpha_deg, theta0_deg");
  }
  const cli::Table table(options, names);
  return write_blocks(grid, grid.alpha.size(), method, options, table,
                      [&](const PointBlock& block, cli::RowWriter& row) {
                        row.text(cli::number_text(block.theta0_deg()[0]));
                        for (std::size_t i = 0; i < block.size(); ++i) {
                          write_quantity(block, i, quantity, row);
                        }
                        row.end();
                      });
}

// Draws one quantity: a curve over alpha for each theta0, or over theta0 if
// there is a single alpha. Returns the reason if there is no picture, or "".
std::string draw(const Grid& grid, const Method& method, std::size_t quantity,
                 const std::string& joint, const Options& options) {
  // Limits of a picture of some 1,000 dots across, however long the table is.
  constexpr std::size_t most_curves = 12;
  constexpr std::size_t most_points = 1000;
  const bool over_alpha = grid.alpha.size() > 1 || grid.theta0.size() == 1;
  const cli::Sweep& x = over_alpha ? grid.alpha : grid.theta0;
  const cli::Sweep& family = over_alpha ? grid.theta0 : grid.alpha;

  cli::LinePlot plot;
  plot.title =
      fmt::format("{}, method {}, pressure {}", quantities()[quantity].symbol,
                  options.method, method.pressure);
  if (!joint.empty()) plot.title += ", " + joint;
  const auto& shown =
      *contact::find_quantity(contact::solution_quantities(),
                              over_alpha ? "slip_axis_angle" : "half_angle");
  plot.x = cli::axis_of(shown);
  plot.x.logarithmic = x.is_logarithmic();
  plot.y.name = quantities()[quantity].symbol;
  plot.family = true;
  for (const double member : cli::spread(family, most_curves)) {
    const std::vector<double> xs = cli::spread(x, most_points);
    const std::vector<double> members(xs.size(), member);
    PointBlock block;
    set_points(over_alpha ? members : xs, over_alpha ? xs : members, block);
    compute(method, block);
    plot.curves.push_back(
        {fmt::format("{} = {}°", over_alpha ? "θ₀" : "α", member), xs,
         block.results[quantity]});
  }
  return cli::draw(plot, options.output.plot);
}

cli::ExitStatus report(const Problems& problems, const Method& method) {
  if (problems.beyond > 0) {
    cli::warn("hinge-table",
              fmt::format("points without a value: {}; the pressure {} ends at "
                          "{:.6g} deg",
                          problems.beyond, method.pressure,
                          method.largest_half_angle / contact::degree));
  }
  if (problems.failed > 0) {
    cli::warn(
        "hinge-table",
        fmt::format(
            "points whose numbers are not finite: {}; the table shows ERROR",
            problems.failed));
  }
  if (problems.inaccurate > 0) {
    cli::warn("hinge-table",
              fmt::format("points that missed the tolerance: {}; their rows "
                          "contain the best values found",
                          problems.inaccurate));
  }
  const std::size_t all = problems.bad_lines + problems.inaccurate +
                          problems.beyond + problems.failed;
  return all == 0 ? cli::all_good : cli::some_bad;
}

cli::ExitStatus run_grid(const Options& options, const Method& method,
                         const std::string& joint) {
  if (options.theta0.empty()) {
    cli::refuse_without(
        "a table",
        "--theta0 and --alpha, or --points (see hinge-table --help)");
  }
  if (options.alpha.empty()) cli::refuse_without("--theta0", "--alpha");
  const std::size_t quantity = quantity_index(options.quantity);
  const Grid grid{{"--theta0", options.theta0, point_columns[0].allowed,
                   contact::Dimension::angle},
                  {"--alpha", options.alpha, point_columns[1].allowed,
                   contact::Dimension::angle}};
  if (!options.output.plot.empty() && grid.size() == 1) {
    cli::refuse_without("--plot", "a range of --theta0 or --alpha");
  }
  const bool two_way = options.output.format == cli::Format::report
                           ? !options.quantity.empty()
                           : options.output.format >= cli::Format::markdown;
  if (!two_way && options.output.plot.empty() && !options.quantity.empty()) {
    cli::refuse_without(given("--quantity", options.quantity),
                        "--format markdown or latex, or --plot; csv and json "
                        "have all quantities");
  }
  if (two_way && !options.output.columns.empty()) {
    cli::refuse_without("--columns",
                        "--format csv or json, or --points: a grid in "
                        "markdown and latex has one --quantity");
  }
  // Wider tables cannot be printed, and their header must fit in memory.
  constexpr std::size_t most_columns = 1000;
  if (two_way && grid.alpha.size() > most_columns) {
    cli::refuse(
        "--alpha", options.alpha,
        fmt::format("at most {} values in markdown and latex, where each is a "
                    "column; these are {}",
                    most_columns, grid.alpha.size()));
  }
  const cli::ExitStatus status =
      report(two_way ? write_two_way(grid, method, quantity, options.output)
                     : write_list(grid, method, options.output),
             method);
  if (options.output.plot.empty()) return status;
  return cli::drawn("hinge-table", draw(grid, method, quantity, joint, options),
                    status);
}

}  // namespace

cli::ExitStatus run(const Options& options) {
  const double tolerance = tolerance_of(options);
  if (!options.bodies.empty() && options.quantity != operations_quantity) {
    cli::refuse_without(given("--bodies", options.bodies),
                        given("--quantity", operations_quantity));
  }
  if (options.quantity == elliptic_quantity) return run_elliptic(options);
  if (options.quantity == operations_quantity) return run_operations(options);
  const cli::Joint ball = make_ball(options.joint);
  return run(options, find_method(options.method, tolerance, ball.pressures[0]),
             ball.spec.name);
}

cli::ExitStatus run(const Options& options, const Method& method,
                    const std::string& joint) {
  if (options.points.empty()) return run_grid(options, method, joint);
  return report(write_points(options, method), method);
}

}  // namespace hinge_table
