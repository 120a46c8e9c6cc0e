#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/help/short_help.hpp"
#include "cli/option.hpp"
#include "cli/output_names.hpp"
#include "cli/table.hpp"

namespace CLI {
class App;
}  // namespace CLI

namespace cli {

/// Exit statuses of every program. Wrong options, unreadable or wrong files
/// and results that cannot be written end a program with `failed`: one
/// message, and no output file. A run that SIGINT or SIGTERM has stopped, and
/// whose results so far are there, ends as the shell says it of a program that
/// the signal ends.
enum ExitStatus {
  all_good = 0,
  some_bad = 1,
  failed = 2,
  interrupted = 130,
  terminated = 143
};

/// When colours are shown: on a terminal without NO_COLOR, or as asked for.
enum class Colour { automatic, always, never };

/// Options that every program has.
struct OutputOptions : TableStyle {
  Colour colour = Colour::automatic;
  std::string output;  ///< file name, "" for standard output
  std::string plot;    ///< file name, "" for none
  int jobs = 1;
};

/// Names of --output and --plot, which can be made, for a program to add its
/// own to.
/// @throws contact::Error as OutputNames::keep() does
OutputNames names_of(const OutputOptions& options);

/// The command line of a program: options in groups.
class Program {
 public:
  /// @param does  what it does, for --help
  Program(const std::string& does, const std::string& name);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Adds rows of options.
  /// @param group  their heading in --help
  void add(const std::string& group, const std::vector<Option>& options);
  /// Adds --output, --plot, --format and the other options of tables. That the
  /// files can be made is found out with the command line; then come what else
  /// is refused, warnings, and the work.
  void add_output(OutputOptions& options);
  /// Adds --jobs.
  void add_jobs(OutputOptions& options);
  /// --schema: prints the schema of the program's file, and no more.
  void add_schema(std::function<std::string()> text);
  /// Gives an option another meaning in --help.
  void describe(const char* flag, const char* meaning);
  /// Adds a check that precedes the checks of needs and excludes.
  void add_check(std::function<void()> check);

  /// Whether an option is on the command line.
  bool has(std::string_view flag) const;
  const std::string& name() const;

  /// Sets up --help and --version, reads the command line and runs `body`,
  /// which returns an ExitStatus; turns exceptions into the one message
  /// "NAME: ..." on standard error and `failed`.
  /// @param help  what --help says below the options
  int run(int argc, char** argv, std::string_view help,
          const std::function<ExitStatus()>& body);

 private:
  void check_rows() const;

  void settle_report();
  void add_help(std::string_view help);
  ProgramHelp described(std::string_view help) const;

  std::unique_ptr<CLI::App> app_;
  std::vector<Option> rows_;
  std::vector<std::string> groups_;  ///< group of each row
  std::vector<std::function<void()>> checks_;
  OutputOptions* output_ = nullptr;
};

/// Status of a program that has drawn a picture: `status`, or some_bad with a
/// warning if there is a problem.
ExitStatus drawn(std::string_view program, const std::string& problem,
                 ExitStatus status);

/// A message that is no error: "PROGRAM: warning: ..." on standard error.
void warn(std::string_view program, std::string_view message);
/// A message that is neither: "PROGRAM: note: ...", if not --quiet.
void note(std::string_view program, std::string_view message);

}  // namespace cli
