#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>

#include "cli/output.hpp"
#include "cli/program.hpp"
#include "cli/progress.hpp"
#include "cli/stream/ordered_blocks.hpp"
#include "cli/table.hpp"

/// The one loop over the rows of a table: by their numbers, or by the lines of
/// a file (points.hpp).
namespace cli {

/// Some rows on their way through a program, one block for each thread, whose
/// memory is used again for the rows that follow.
struct RowBlock {
  std::size_t first = 0;  ///< number of its first row, from 0
  std::size_t last = 0;   ///< one behind its last row
  Text rows;              ///< their text
  std::string messages;   ///< on bad lines
  std::size_t bad_lines = 0;

  std::size_t size() const { return last - first; }
};

/// Rows by their numbers, in blocks of some.
class NumberedRows {
 public:
  /// Large against the cost of passing a block between threads.
  static constexpr std::size_t usual_block = 256;

  explicit NumberedRows(std::size_t count, std::size_t block = usual_block)
      : count_(count), block_(block) {}

  std::size_t count() const { return count_; }
  bool next(RowBlock& block) {
    block.first = taken_;
    block.last = taken_ = std::min(taken_ + block_, count_);
    return block.first < block.last;
  }

 private:
  std::size_t count_;
  std::size_t block_;
  std::size_t taken_ = 0;
};

/// Works on the blocks of a source in `jobs` threads, says how far that is and
/// which lines are bad.
/// @param source  bool next(Block&) fills a block; count(): 0 if not known
/// @param what    "rows": what is counted of how far it is
/// @param work    void(Block&): called by all threads at once
/// @param done    void(const Block&): one block after the other, in order
template <class Block, class Source, class Work, class Done>
void row_blocks(int jobs, Source& source, const char* what, const Work& work,
                const Done& done) {
  Progress progress(what, source.count());
  ordered_blocks<Block>(
      jobs, [&](Block& block) { return source.next(block); },
      [&](Block& block) {
        block.rows.clear();
        work(block);
      },
      [&](const Block& block) {
        done(block);
        progress.add(block.size());
        if (block.bad_lines == 0) return;
        progress.clear();
        std::fputs(block.messages.c_str(), stderr);
      });
}

/// The same of a table that is written.
/// @param work  void(Block&, RowWriter&)
template <class Block, class Source, class Work, class Done>
void write_rows(const OutputOptions& options, Output& output,
                const Table& table, Source& source, const char* what,
                const Work& work, const Done& done) {
  TableWriter writer(output, table);
  row_blocks<Block>(
      options.jobs, source, what,
      [&](Block& block) {
        RowWriter row(table, block.rows);
        work(block, row);
      },
      [&](const Block& block) {
        writer.write(block.rows.view());
        done(block);
      });
  writer.finish();
  output.commit();
}

}  // namespace cli
