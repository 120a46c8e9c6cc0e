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

  /// A row; its table must outlive it.
  class Row {
   public:
    const std::string& text(std::string_view column) const;
    /// True if the column exists and the cell is not empty.
    bool given(std::string_view column) const {
      return table_->has(column) && !text(column).empty();
    }

    /// The cell as a number: value<double>(...), or any type that is
    /// constructed from a decimal string (Boost.Multiprecision).
    template <class Real = double>
    Real value(std::string_view column) const {
      return Real(text(column));
    }

    /// "friction_integrals.csv:17: theta0_deg=0.01, alpha_deg=85": place of the
    /// row and its first two cells, for reports.
    std::string label() const;

   private:
    friend class ReferenceTable;
    Row(const ReferenceTable& table, std::size_t number)
        : table_(&table), number_(number) {}
    const ReferenceTable* table_;
    std::size_t number_;
  };

  std::size_t size() const { return rows_.size(); }
  bool has(std::string_view column) const;
  Row operator[](std::size_t row) const { return {*this, row}; }

  struct Iterator {
    const ReferenceTable* table;
    std::size_t number;
    Row operator*() const { return (*table)[number]; }
    Iterator& operator++() {
      ++number;
      return *this;
    }
    bool operator==(const Iterator&) const = default;
  };
  Iterator begin() const { return {this, 0}; }
  Iterator end() const { return {this, size()}; }

 private:
  std::string name_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<int> lines_;
};

template <>
double ReferenceTable::Row::value<double>(std::string_view column) const;

}  // namespace contact::test
