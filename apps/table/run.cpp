#include "table/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "cli/choice.hpp"
#include "cli/line_blocks.hpp"
#include "cli/ordered_blocks.hpp"
#include "cli/output.hpp"
#include "cli/plot.hpp"
#include "cli/progress.hpp"
#include "cli/sweep.hpp"
#include "cli/table.hpp"
#include "libcontact/error.hpp"
#include "table/method.hpp"
#include "table/point_block.hpp"

namespace hinge_table {
namespace {

std::size_t quantity_index(const std::string& name) {
  std::array<cli::Choice<std::size_t>, quantities.size()> choices;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    choices[i] = {quantities[i], i};
  }
  return cli::choice("--quantity", name, choices);
}

std::vector<std::string> column_names(std::vector<std::string> riding) {
  std::vector<std::string> names = {"theta0_deg", "alpha_deg"};
  names.insert(names.end(), quantities.begin(), quantities.end());
  riding = cli::distinct_names(std::move(riding), names);
  names.insert(names.end(), riding.begin(), riding.end());
  return names;
}

// A table of points from a file or standard input.
class PointsRun {
 public:
  PointsRun(const Options& options, const Method& method)
      : options_(options),
        method_(method),
        output_(options.output.output),
        reader_(options.points) {}

  cli::ExitStatus run() {
    const PointColumns columns = read_header();
    const cli::Table table(options_.output.format,
                           column_names(columns.riding));
    cli::TableWriter writer(output_, table);
    cli::Progress progress("points", 0);
    std::size_t bad_lines = 0;
    cli::ordered_blocks<PointBlock>(
        options_.output.jobs,
        [&](PointBlock& block) { return reader_.next(block.lines); },
        [&](PointBlock& block) {
          read_points(columns, block);
          compute(method_, block);
          write_rows(table, block);
        },
        [&](const PointBlock& block) {
          writer.write(block.rows.view());
          progress.add(block.size());
          if (block.bad_lines == 0) return;
          bad_lines += block.bad_lines;
          progress.clear();
          std::fputs(block.messages.c_str(), stderr);
        });
    writer.finish();
    output_.commit();
    return bad_lines == 0 ? cli::all_good : cli::some_bad;
  }

 private:
  PointColumns read_header() {
    for (;;) {
      const std::string place =
          fmt::format("{}, line {}", reader_.name(), reader_.next_number());
      const auto line = reader_.line();
      if (!line) throw contact::Error(reader_.name() + ": no header line");
      if (!line->starts_with('#')) return {*line, place};
    }
  }

  const Options& options_;
  const Method& method_;
  cli::Output output_;
  cli::LineReader reader_;
};

// Tables and pictures over a grid of theta0 and alpha.
class GridRun {
 public:
  GridRun(const Options& options, const Method& method)
      : options_(options),
        method_(method),
        quantity_(quantity_index(options.quantity)),
        theta0_("--theta0", options.theta0, allowed_theta0),
        alpha_("--alpha", options.alpha, allowed_alpha) {}

  void write() const {
    cli::Output output(options_.output.output);
    if (options_.output.format >= cli::Format::markdown) {
      write_two_way(output);
    } else {
      write_list(output);
    }
    output.commit();
  }

  std::string draw() const;

 private:
  // Rows of a list in a block: large against the cost of passing a block
  // between threads, small enough for the cache.
  static constexpr std::size_t block_rows = 1024;

  struct Block : PointBlock {
    std::size_t first;
    std::size_t last;
  };

  // Rows `first` to `last` for `rows` of `count` in all.
  template <class WriteRows>
  void write_blocks(cli::Output& output, const cli::Table& table,
                    std::size_t block_size, const WriteRows& rows) const {
    cli::TableWriter writer(output, table);
    const std::size_t count = theta0_.size() * alpha_.size();
    cli::Progress progress("points", count);
    std::size_t taken = 0;
    cli::ordered_blocks<Block>(
        options_.output.jobs,
        [&](Block& block) {
          block.first = taken;
          block.last = taken = std::min(taken + block_size, count);
          return block.first < block.last;
        },
        [&](Block& block) {
          take_grid_points(theta0_, alpha_, block.first, block.last, block);
          compute(method_, block);
          rows(block);
        },
        [&](const Block& block) {
          writer.write(block.rows.view());
          progress.add(block.last - block.first);
        });
    writer.finish();
  }

  void write_list(cli::Output& output) const {
    const cli::Table table(options_.output.format, column_names({}));
    write_blocks(output, table, block_rows,
                 [&](Block& block) { write_rows(table, block); });
  }

  // theta0 down, alpha across.
  void write_two_way(cli::Output& output) const {
    std::vector<std::string> names = {
        fmt::format("{}: theta0_deg, alpha_deg", options_.quantity)};
    for (std::size_t i = 0; i < alpha_.size(); ++i) {
      names.push_back(cli::number_text(alpha_[i]));
    }
    const cli::Table table(options_.output.format, names);
    write_blocks(output, table, alpha_.size(), [&](Block& block) {
      block.rows.clear();
      cli::RowWriter row(table, block.rows);
      row.text(cli::number_text(block.theta0_deg[0]));
      for (const double value : block.results[quantity_]) row.number(value);
      row.end();
    });
  }

  double value(double theta0_deg, double alpha_deg) const {
    PointBlock block;
    block.theta0_deg = {theta0_deg};
    block.alpha_deg = {alpha_deg};
    compute(method_, block);
    return block.results[quantity_][0];
  }

  const Options& options_;
  const Method& method_;
  std::size_t quantity_;
  cli::Sweep theta0_;
  cli::Sweep alpha_;
};

// At most `most` indices below `count`, evenly spread, the ends included.
std::vector<std::size_t> spread(std::size_t count, std::size_t most) {
  const std::size_t size = std::min(count, most);
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < size; ++i) {
    indices.push_back(size == 1 ? 0 : i * (count - 1) / (size - 1));
  }
  return indices;
}

std::string GridRun::draw() const {
  // A curve for each theta0 over alpha; over theta0 if there is one alpha.
  // The numbers: what a picture of some 1,000 dots across can show, however
  // long the table is.
  constexpr std::size_t most_curves = 12;
  constexpr std::size_t most_points = 1000;
  const bool over_alpha = alpha_.size() > 1 || theta0_.size() == 1;
  const cli::Sweep& x = over_alpha ? alpha_ : theta0_;
  const cli::Sweep& family = over_alpha ? theta0_ : alpha_;

  cli::LinePlot plot;
  plot.title = fmt::format("{}, method {}", options_.quantity, options_.method);
  plot.x_label =
      over_alpha ? "slip axis angle α, deg" : "contact half-angle θ₀, deg";
  plot.y_label = options_.quantity;
  plot.logarithmic_x = x.is_logarithmic();
  plot.family = true;
  for (const std::size_t i : spread(family.size(), most_curves)) {
    cli::Curve curve;
    curve.label = fmt::format("{} = {}°", over_alpha ? "θ₀" : "α", family[i]);
    for (const std::size_t j : spread(x.size(), most_points)) {
      curve.x.push_back(x[j]);
      curve.y.push_back(over_alpha ? value(family[i], x[j])
                                   : value(x[j], family[i]));
    }
    plot.curves.push_back(std::move(curve));
  }
  return cli::draw(plot, options_.output.plot);
}

}  // namespace

cli::ExitStatus run(const Options& options) {
  const Method method = find_method(options.method, options.tolerance);
  if (!options.points.empty()) {
    if (!options.output.plot.empty()) {
      throw contact::Error("--plot: needs a grid (--theta0 and --alpha)");
    }
    return PointsRun(options, method).run();
  }
  if (options.theta0.empty() || options.alpha.empty()) {
    throw contact::Error(
        "needs --theta0 and --alpha, or --points (see hinge-table --help)");
  }
  const GridRun grid(options, method);
  grid.write();
  if (options.output.plot.empty()) return cli::all_good;
  const std::string problem = grid.draw();
  if (problem.empty()) return cli::all_good;
  cli::warn("hinge-table", problem);
  return cli::some_bad;
}

}  // namespace hinge_table
