#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace contact::test {

/// A CSV file of reference values: '#' lines are comments, the first other
/// line names the columns. Cells stay strings, so that one file serves
/// double and 50-digit comparisons. Anything wrong throws contact::Error.
class ReferenceTable {
 public:
  /// @param path  file name, relative to data/reference/ of this project
  explicit ReferenceTable(const std::filesystem::path& path);

  std::size_t size() const { return rows_.size(); }
  const std::string& text(std::size_t row, std::string_view column) const;
  bool has(std::string_view column) const;

  /// The cell as a number: value<double>(...), or any type that is
  /// constructed from a decimal string (Boost.Multiprecision).
  template <class Real = double>
  Real value(std::size_t row, std::string_view column) const {
    return Real(text(row, column));
  }

  /// "friction_integrals.csv:17: theta0_deg=0.01, alpha_deg=85": place of the
  /// row and its first two cells, for reports.
  std::string label(std::size_t row) const;

 private:
  std::string name_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<int> lines_;
};

template <>
double ReferenceTable::value<double>(std::size_t row,
                                     std::string_view column) const;

}  // namespace contact::test
