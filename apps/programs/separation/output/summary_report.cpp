#include "programs/separation/output/summary_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli/stream/report.hpp"

namespace separation {
namespace {

using nlohmann::ordered_json;

// Adds the numbers of a body or joint, and of its nested objects under their
// names.
void add_numbers(const std::string& name, const ordered_json& of,
                 cli::RowWriter& row) {
  for (const auto& [key, value] : of.items()) {
    if (value.is_number()) {
      row.text(name);
      row.text(key);
      row.number(value.get<double>());
      row.end();
    } else if (value.is_object()) {
      add_numbers(name, value, row);
    } else if (value.is_array()) {
      for (const ordered_json& part : value) {
        if (!part.is_object()) continue;
        add_numbers(name + ' ' + part.value("name", ""), part, row);
      }
    }
  }
}

}  // namespace

void write_report(const ordered_json& summary, cli::Output& output,
                  const cli::TableStyle& style) {
  cli::TableStyle shown = style.titled(summary.at("case").get<std::string>());
  shown.columns.clear();  // --columns selects columns of histories
  cli::write_table(
      shown, {"body", "quantity", "value"}, output, [&](cli::RowWriter& row) {
        for (const ordered_json& event : summary.at("events")) {
          row.text(event.at("body").get<std::string>());
          row.text(event.at("what").get<std::string>());
          row.text(fmt::format("{:.4g} s", event.at("time_s").get<double>()));
          row.end();
        }
        for (const ordered_json& body : summary.at("bodies")) {
          add_numbers(body.at("name").get<std::string>(), body, row);
        }
        for (const ordered_json& pair : summary.at("clearance")) {
          add_numbers("clearance", pair, row);
        }
        add_numbers("energy", summary.at("energy"), row);
      });
}

}  // namespace separation
