#include "programs/study/rows_file.hpp"

#include "cli/hdf5/columns.hpp"
#include "cli/output.hpp"

namespace study {

void write_csv(const Study& study, const Journal& journal,
               cli::TableStyle style, const std::string& file) {
  std::vector<std::string> names = study.columns();
  names.insert(names.begin(), "run");
  names.emplace_back("status");
  style.format = cli::Format::csv;
  cli::Output output(file);
  const cli::Table table(std::move(style), names);
  cli::TableWriter writer(output, table);
  cli::Text text;
  cli::RowWriter cells(table, text);
  for (std::uint64_t run = 0; run <= study.runs(); ++run) {
    const Row row = journal.at(run);
    cells.count(row.run);
    for (const double number : row.numbers) cells.number(number);
    cells.text(row.failure.empty() ? "ok" : row.failure);
    cells.end();
    writer.write(text.view());
    text.clear();
  }
  writer.finish();
  output.commit();
}

void write_hdf5(const Study& study, const Journal& journal,
                const std::string& file) {
  std::vector<cli::Hdf5Column> columns = {{"run", "", ""},
                                          {"status", "", "0 ok, 1 failed"}};
  for (const std::string& name : study.columns()) {
    const bool input = columns.size() < study.inputs() + 2;
    columns.push_back({(input ? "inputs/" : "quantities/") + name, "", ""});
  }
  cli::Output output(file);
  output.write(cli::hdf5_image(
      columns, study.runs() + 1, [&](std::size_t column, double* values) {
        for (std::uint64_t run = 0; run <= study.runs(); ++run) {
          const Row row = journal.at(run);
          values[run] = column == 0   ? static_cast<double>(run)
                        : column == 1 ? (row.failure.empty() ? 0 : 1)
                                      : row.numbers[column - 2];
        }
      }));
  output.commit();
}

}  // namespace study
