#include "programs/separation/output/history_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "cli/hdf5/columns.hpp"
#include "cli/output.hpp"
#include "cli/stream/file_name.hpp"
#include "libcontact/base/dimension.hpp"
#include "multibody/friction/hinge_friction.hpp"

namespace separation {
namespace {

using multibody::HingeMode;

bool is_mode(const std::string& column) { return column.ends_with(".mode"); }

void write_csv(const Rows& rows, const cli::Table& table, cli::Output& output) {
  cli::TableWriter writer(output, table);
  cli::Text text;
  cli::RowWriter row(table, text);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows.columns.size(); ++j) {
      const double value = rows.at(i, j);
      if (is_mode(rows.columns[j])) {
        row.text(to_string(static_cast<HingeMode>(static_cast<int>(value))));
      } else {
        row.number(value);
      }
    }
    row.end();
    writer.write(text.view());
    text.clear();
  }
  writer.finish();
}

// Splits the column "BODY.QUANTITY_UNIT" into a path and its unit. The
// quantity's name itself contains no unit.
struct Place {
  std::string path;
  std::string unit;
};
Place place_of(std::string column) {
  static constexpr std::string_view endings[] = {
      "_deg_per_s2", "_deg_per_s", "_rad_per_s", "_m_per_s", "_N_m_s", "_N_m",
      "_deg",        "_Pa",        "_N",         "_J",       "_m",     "_s"};
  const auto* const ending = std::ranges::find_if(
      endings, [&](std::string_view end) { return column.ends_with(end); });
  std::string unit = ending == std::end(endings)
                         ? ""
                         : contact::unit_symbol(ending->substr(1));
  for (char& c : column) {
    if (c == '.') c = '/';
  }
  return {std::move(column), std::move(unit)};
}

std::string mode_words() {
  std::string words;
  for (const HingeMode mode : multibody::hinge_modes) {
    if (!words.empty()) words += ", ";
    words += fmt::format("{} {}", static_cast<int>(mode), to_string(mode));
  }
  return words;
}

std::string hdf5_of(const Rows& rows, const std::vector<std::string>& names) {
  std::vector<cli::Hdf5Column> columns;
  for (const std::string& name : names) {
    const auto [path, unit] = place_of(name);
    columns.push_back({path, unit, is_mode(name) ? mode_words() : ""});
  }
  return cli::hdf5_image(columns, rows.size(),
                         [&](std::size_t k, double* values) {
                           const std::size_t j = rows.column(names[k]);
                           for (std::size_t i = 0; i < rows.size(); ++i)
                             values[i] = rows.at(i, j);
                         });
}

const std::string& checked(const std::string& name) {
  cli::check_ending("--history", name, {".csv", ".h5", ".hdf5"},
                    ".csv, .h5 or .hdf5; - for CSV on standard output");
  return name;
}

}  // namespace

HistoryFile::HistoryFile(const std::string& name, const cli::TableStyle& style,
                         const std::vector<std::string>& columns)
    : hdf5_(cli::is_hdf5(name)),
      table_(style, columns),
      output_(checked(name)) {}

void HistoryFile::write(const Rows& rows) {
  if (hdf5_) {
    const auto& asked = table_.style().columns;
    output_.write(hdf5_of(rows, asked.empty() ? rows.columns : asked));
  } else {
    write_csv(rows, table_, output_);
  }
  output_.commit();
}

}  // namespace separation
