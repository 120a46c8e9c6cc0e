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

/// The loop over the rows of a table, used by all programs; rows come from
/// their numbers or from the lines of a file (points.hpp).
namespace cli {

/// A block of rows. Each thread has one and uses its memory again for the next
/// rows.
struct RowBlock {
  std::size_t first = 0;  ///< number of its first row, from 0
  std::size_t last = 0;   ///< number after its last row
  Text rows;              ///< their text
  std::string messages;   ///< on bad lines
  std::size_t bad_lines = 0;

  std::size_t size() const { return last - first; }
};

/// Numbered rows in blocks.
class NumberedRows {
 public:
  /// Large compared with the cost of passing a block between threads.
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

/// Works on the blocks of a source in `jobs` threads; reports progress and bad
/// lines.
/// @param source  bool next(Block&) fills a block; count(): 0 if not known
/// @param what    what progress counts: "rows"
/// @param work    void(Block&): called by all threads at once
/// @param done    void(const Block&): called for one block after another, in
///                order
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

/// As above, for rows that are written to a table.
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
