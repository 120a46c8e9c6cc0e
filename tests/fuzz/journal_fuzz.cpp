// Journals of studies with changed bytes: a row is read as it was written, or
// one contact::Error gives the reason. Every three bytes of the input are a
// place of the file (from its beginning or, if odd, its end) and the byte
// there.
#include <sqlite3.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz.hpp"
#include "study/rows/journal.hpp"

namespace {

using contact::test::check;
using study::Journal;
using study::Row;

const std::vector<std::string> names = {"input", "output"};
constexpr std::uint64_t rows = 20;

Row row(std::uint64_t run) {
  const auto x = static_cast<double>(run);
  return {run, run % 5 == 0 ? "it failed" : "", {x, 1 / (1 + x)}};
}

std::string good_journal() {
  const std::string path = contact::test::written("", ".good");
  std::filesystem::remove(path);
  {
    Journal journal(path, "identity", names, Journal::Use::write);
    for (std::uint64_t run = 0; run < rows; ++run) journal.append(row(run));
  }
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  static const std::string good = good_journal();
  std::string bytes = good;
  for (std::size_t i = 0; i + 2 < size; i += 3) {
    const std::size_t place = (data[i] << 8U | data[i + 1]) % bytes.size();
    bytes[place % 2 == 0 ? place : bytes.size() - 1 - place / 2] =
        static_cast<char>(data[i + 2]);
  }
  if (size % 3 == 1) bytes.resize(bytes.size() * data[size - 1] / 255);
  const std::string path = contact::test::written(bytes, ".journal");
  contact::test::read_or_one_line(
      [&] {
        const Journal journal(path, "identity", names, Journal::Use::read);
        for (std::uint64_t run = 0; run < rows; ++run) {
          if (!journal.has(run)) continue;
          const Row as_read = journal.at(run);
          check(as_read.run == run && as_read.numbers == row(run).numbers &&
                as_read.failure == row(run).failure);
        }
      },
      path);
  return 0;
}
