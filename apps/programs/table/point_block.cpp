#include "programs/table/point_block.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libcontact/base/units.hpp"

namespace hinge_table {
namespace {

void write_point(const PointBlock& block, std::size_t i, cli::RowWriter& row) {
  row.number(block.theta0_deg()[i]);
  row.number(block.alpha_deg()[i]);
  for (std::size_t j = 0; j < quantities().size(); ++j) {
    write_quantity(block, i, j, row);
  }
}

// Points of good lines that should have values but have a number that is not
// finite.
std::size_t count_failed(const PointBlock& block) {
  std::size_t failed = 0;
  for (std::size_t i = 0; i < block.size(); ++i) {
    if (!block.good[i] || block.is_beyond(i)) continue;
    failed += std::ranges::any_of(block.results, [i](const auto& column) {
      return !std::isfinite(column[i]);
    });
  }
  return failed;
}

}  // namespace

void set_points(std::vector<double> theta0_deg, std::vector<double> alpha_deg,
                PointBlock& block) {
  block.good.assign(theta0_deg.size(), 1);
  block.values.resize(point_columns.size());
  block.last = theta0_deg.size();
  block.values[0] = std::move(theta0_deg);
  block.values[1] = std::move(alpha_deg);
}

void take_grid_points(const cli::Sweep& theta0, const cli::Sweep& alpha,
                      PointBlock& block) {
  block.good.assign(block.size(), 1);
  block.values.resize(point_columns.size());
  for (auto& values : block.values) values.clear();
  for (std::size_t i = block.first; i < block.last; ++i) {
    block.values[0].push_back(theta0[i / alpha.size()]);
    block.values[1].push_back(alpha[i % alpha.size()]);
  }
}

void compute(const Method& method, PointBlock& block) {
  const std::size_t count = block.size();
  block.beyond = 0;
  block.largest = method.largest_half_angle;
  block.half_angle.resize(count);
  block.axis_sin.resize(count);
  block.axis_cos.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    block.half_angle[i] = block.theta0_deg()[i] * contact::degree;
    if (block.is_beyond(i)) ++block.beyond;
    const auto [sin, cos] =
        contact::detail::sine_cosine_deg(block.alpha_deg()[i]);
    block.axis_sin[i] = sin;
    block.axis_cos[i] = cos;
  }
  block.results.resize(quantities().size());
  Columns columns;
  for (std::vector<double>& results : block.results) {
    results.resize(count);
    columns.push_back(results);
  }
  block.inaccurate =
      method({block.half_angle, block.axis_sin, block.axis_cos}, columns);
  block.failed = count_failed(block);
}

void write_quantity(const PointBlock& block, std::size_t point,
                    std::size_t quantity, cli::RowWriter& row) {
  const double value = block.results[quantity][point];
  if (std::isfinite(value) || block.is_beyond(point)) {
    row.number(value);
  } else {
    row.text("ERROR");
  }
}

void write_rows(const PointBlock& block, cli::RowWriter& row) {
  for (std::size_t i = 0; i < block.size(); ++i) {
    write_point(block, i, row);
    row.end();
  }
}

void write_rows(const cli::PointColumns& columns, const PointBlock& block,
                cli::RowWriter& row) {
  for (std::size_t i = 0; i < block.size(); ++i) {
    if (block.good[i]) {
      write_point(block, i, row);
    } else {
      row.text("ERROR");
      for (std::size_t j = 0; j <= quantities().size(); ++j) row.empty();
    }
    write_riding(columns, block, i, row);
    row.end();
  }
}

}  // namespace hinge_table
