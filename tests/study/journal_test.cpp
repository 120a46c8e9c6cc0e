// The rows of a study that are done, whatever happens to their writers.
#include "study/rows/journal.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "support/error_message.hpp"
#include "support/program.hpp"

namespace contact::test::journal_test {
namespace {

using contact::test::error_message;
using study::Journal;
using study::Row;

class JournalFile : public testing::Test {
 protected:
  std::string path(const std::string& name) const {
    return (folder_.path() / name).string();
  }
  static constexpr auto write_it = Journal::Use::write;
  static Row row(std::uint64_t run) {
    return {run,
            run % 3 == 0 ? "it failed" : "",
            {1.5 * static_cast<double>(run), std::nan("")}};
  }
  void fill(const std::string& name, std::uint64_t rows) const {
    Journal journal(path(name), "study", {"x", "y"}, write_it);
    for (std::uint64_t i = 0; i < rows; ++i) journal.append(row(i));
  }

  contact::test::ProgramFolder folder_;
};

// NaN too.
void expect_same(const Row& a, const Row& b) {
  EXPECT_EQ(a.run, b.run);
  EXPECT_EQ(a.failure, b.failure);
  EXPECT_EQ(a.numbers[0], b.numbers[0]);
  EXPECT_EQ(std::isnan(a.numbers[1]), std::isnan(b.numbers[1]));
}

// A closed journal is one file.
TEST_F(JournalFile, RowsComeBackBitForBit) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> numbers = {-0.0,
                                       5e-324,
                                       0.1,
                                       3,
                                       1e308,
                                       -infinity,
                                       0x1p63,
                                       -7,
                                       -5e-324,
                                       infinity,
                                       9007199254740993.0};
  std::vector<std::string> names(numbers.size());
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = "a\"b";
  {
    Journal journal(path("j"), "study", names, write_it);
    journal.append({7, "", numbers});
    journal.append({7, "", std::vector<double>(numbers.size())});
    EXPECT_EQ(journal.size(), 1u);
  }
  const Journal journal(path("j"), "study", names, Journal::Use::read);
  EXPECT_FALSE(journal.has(6));
  ASSERT_TRUE(journal.has(7));
  const std::vector<double> back = journal.at(7).numbers;
  EXPECT_EQ(
      std::memcmp(back.data(), numbers.data(), numbers.size() * sizeof(double)),
      0);
  EXPECT_NE(error_message([&] { journal.at(6); }).find("run 6 is missing"),
            std::string::npos);
  for (const char* end : {"-wal", "-shm", "-journal"}) {
    EXPECT_FALSE(std::filesystem::exists(path(std::string("j") + end)));
  }
}

// Killed at any instant, a writer leaves the rows that it has appended, and
// nothing of another one.
TEST_F(JournalFile, KilledWritersLeaveWholeRows) {
  std::mt19937 random(1);
  std::uint64_t rows = 0;
  for (int i = 0; i < 50; ++i) {
    int done[2];
    ASSERT_EQ(pipe(done), 0);
    const pid_t writer = fork();
    if (writer == 0) {
      Journal journal(path("j"), "study", {"x", "y"}, write_it);
      for (std::uint64_t run = journal.size();; ++run) {
        journal.append(row(run));
        const char said = '.';
        if (write(done[1], &said, 1) != 1) _exit(1);
      }
    }
    close(done[1]);
    char said = 0;
    std::uint64_t appended = rows;
    for (auto wanted = random() % 40; wanted > 0; --wanted) {
      if (read(done[0], &said, 1) == 1) ++appended;
    }
    kill(writer, SIGKILL);
    waitpid(writer, nullptr, 0);
    while (read(done[0], &said, 1) == 1) ++appended;
    close(done[0]);
    const Journal journal(path("j"), "study", {"x", "y"}, write_it);
    EXPECT_GE(journal.size(), appended);
    rows = journal.size();
    for (std::uint64_t run = 0; run < rows; ++run) {
      expect_same(journal.at(run), row(run));
    }
  }
  EXPECT_GT(rows, 500u);
}

TEST_F(JournalFile, TenWritersAtOnceLoseNothing) {
  constexpr std::uint64_t each = 40;
  std::vector<pid_t> writers;
  for (std::uint64_t i = 0; i < 10; ++i) {
    writers.push_back(fork());
    if (writers.back() != 0) continue;
    // Half of its rows are in the next one too.
    for (std::uint64_t run = 0; run < each; run += 10) {
      Journal journal(path("j"), "study", {"x", "y"}, write_it);
      for (std::uint64_t k = run; k < run + 10; ++k) {
        journal.append(row(i * each / 2 + k));
      }
    }
    _exit(0);
  }
  for (const pid_t writer : writers) {
    int status = 0;
    waitpid(writer, &status, 0);
    EXPECT_EQ(status, 0);
  }
  const Journal journal(path("j"), "study", {"x", "y"}, Journal::Use::read);
  EXPECT_EQ(journal.size(), 11 * each / 2);
  for (std::uint64_t i = 0; i < journal.size(); ++i) {
    expect_same(journal.at(i), row(i));
  }
}

// A byte that is another one makes no other number: the row is refused, or is
// missing and computed anew.
TEST_F(JournalFile, DamageMakesNoOtherNumbers) {
  fill("a", 6);
  const std::string whole = folder_.read("a");
  std::size_t seen = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (i > 200 && whole[i] == 0) continue;
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x41);
    folder_.write("b", damaged);
    seen += error_message([&] {
              const Journal journal(path("b"), "study", {"x", "y"},
                                    Journal::Use::read);
              for (std::uint64_t run = 0; run < 6; ++run) {
                if (journal.has(run)) expect_same(journal.at(run), row(run));
              }
            }) != "(no error)";
  }
  EXPECT_GT(seen, 200u);
}

TEST_F(JournalFile, OthersAreRefused) {
  fill("a", 2);
  const auto message = [&](const std::string& name, const char* study,
                           std::size_t numbers = 2) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < numbers; ++i) {
      names.push_back(std::to_string(i));
    }
    const std::string text = error_message(
        [&] { const Journal journal(path(name), study, names, write_it); });
    return text.substr(std::min(text.size(), path(name).size()));
  };
  EXPECT_EQ(
      message("a", "another"),
      ": the study of this journal must be the same, with the same files, "
      "seed and version; remove it or name another one with --journal");
  const std::string stranger = ": the file must be a journal of hinge-study";
  folder_.write("c", "time_s,x\n1,2\n");
  EXPECT_EQ(message("c", "study"), stranger);
  cli::Database(path("d"), cli::Database::Use::write).run("CREATE TABLE t (x)");
  EXPECT_EQ(message("d", "study"), stranger);
  folder_.write("e", "hinge-study journal 2 0123456789abcdef 2\n");
  EXPECT_EQ(message("e", "study"),
            ": a journal of another version must be removed, or another one "
            "named with --journal");
  EXPECT_EQ(message("f", "study", 1998),
            ": 1998 inputs and quantities of a row must be 1997 at most");
  EXPECT_EQ(message("g", "study", 1997), "");
}

// Files that read as a journal does, but by SQL that they have in them.
TEST_F(JournalFile, SqlOfOthersIsNotRun) {
  for (const char* const forged :
       {"ALTER TABLE rows RENAME TO r; CREATE VIEW rows AS SELECT * FROM r",
        "ALTER TABLE study RENAME TO s; CREATE VIEW study AS SELECT * FROM s",
        "CREATE TRIGGER t BEFORE INSERT ON rows BEGIN "
        "SELECT RAISE(IGNORE); END",
        "CREATE INDEX i ON rows (y + 1)"}) {
    for (const auto use : {Journal::Use::read, write_it}) {
      std::filesystem::remove(path("a"));
      fill("a", 2);
      cli::Database(path("a"), cli::Database::Use::write).run(forged);
      EXPECT_NE(error_message([&] {
                  const Journal journal(path("a"), "study", {"x", "y"}, use);
                }).find("the study of this journal must be the same"),
                std::string::npos)
          << forged;
    }
  }
}

}  // namespace
}  // namespace contact::test::journal_test
