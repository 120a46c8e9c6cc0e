// Points for hinge-table: any text gives a table with a row for every line,
// each row with all its columns, the columns that ride along unchanged, and
// one line of message for every bad line; or one contact::Error for the
// header.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "cli/stream/csv.hpp"
#include "cli/stream/line_blocks.hpp"
#include "cli/stream/points.hpp"
#include "cli/table.hpp"
#include "fuzz.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/pressure/cosine.hpp"
#include "programs/table/method.hpp"
#include "programs/table/point_block.hpp"

namespace {

using contact::test::check;

std::size_t count(std::string_view text, char c) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), c));
}

// A record is its raw fields joined by commas, and raw fields survive
// decoding.
void check_record(std::string_view line) {
  std::vector<std::string_view> fields;
  if (!cli::split_record(line, fields).empty()) return;
  std::string joined;
  for (const std::string_view field : fields) {
    joined += std::string(field) + ',';
    const std::string value = cli::field_value(field);
    std::vector<std::string_view> again;
    const std::string raw = cli::raw_field(value);
    check(cli::split_record(raw, again).empty());
    check(again.size() == 1 && cli::field_value(again[0]) == value);
  }
  joined.pop_back();
  check(joined == line);
}

std::string write(const cli::PointColumns& columns, cli::Format format,
                  hinge_table::PointBlock& block) {
  std::vector<std::string> names = {"theta0_deg", "alpha_deg"};
  for (const auto& quantity : hinge_table::quantities()) {
    names.emplace_back(quantity.symbol);
  }
  const auto riding = cli::distinct_names(columns.riding, names);
  names.insert(names.end(), riding.begin(), riding.end());
  const cli::Table table({format}, names);
  block.rows.clear();
  cli::RowWriter row(table, block.rows);
  hinge_table::write_rows(columns, block, row);
  std::string_view rows = block.rows.view();
  if (format == cli::Format::json && !rows.empty()) rows.remove_prefix(1);
  return table.header() + std::string(rows) + table.footer();
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const std::string header(cli::next_line(text));
    check_record(header);
    const cli::PointColumns columns({header, "fuzz"},
                                    hinge_table::point_columns);

    hinge_table::PointBlock block;
    block.lines = {std::string(text), 2};
    cli::read_points(columns, block);
    static const hinge_table::Method method = hinge_table::find_method(
        "viscous", 1e-10,
        {"cosine",
         std::make_shared<contact::CosinePressure>(contact::JointKind::ball)});
    hinge_table::compute(method, block);
    check(count(block.messages, '\n') == block.bad_lines);
    for (const char c : block.messages) {
      check(c == '\n' || static_cast<unsigned char>(c) >= ' ');
    }

    const std::string csv = write(columns, cli::Format::csv, block);
    std::string_view rest = csv;
    rest.remove_prefix(rest.find('\n') + 1);
    std::vector<std::string_view> in;
    std::vector<std::string_view> out;
    std::size_t bad = 0;
    for (std::string_view lines = text; !lines.empty();) {
      const std::string_view line = cli::next_line(lines);
      if (line.find_first_not_of(" \t") == std::string_view::npos) continue;
      check_record(line);
      const std::string_view row = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(row.size() + 1);
      check(cli::split_record(row, out).empty());
      check(out.size() == 10 + columns.count);
      bad += out[0] == "ERROR";
      if (!cli::split_record(line, in).empty() || in.size() != columns.count) {
        check(out[0] == "ERROR");
        continue;
      }
      std::size_t column = 12;
      for (std::size_t i = 0; i < in.size(); ++i) {
        if (i == columns.at[0] || i == columns.at[1]) continue;
        check(out[column++] == in[i]);
      }
    }
    check(rest.empty());
    check(bad == block.bad_lines);

    const auto json =
        nlohmann::json::parse(write(columns, cli::Format::json, block));
    check(json.size() == block.size());
  } catch (const contact::Error& error) {
    const std::string_view message = error.what();
    check(message.starts_with("fuzz: "));
    check(message.find_first_of("\n\r") == message.npos);
  }
  return 0;
}
