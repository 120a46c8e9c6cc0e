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

/// Exit statuses of every program. A program ends with `failed`, one message
/// and no output file if options are wrong, files are unreadable or wrong, or
/// results cannot be written. A run stopped by SIGINT or SIGTERM keeps its
/// results so far; its status is the one that shells report for the signal.
enum ExitStatus {
  all_good = 0,
  some_bad = 1,
  failed = 2,
  interrupted = 130,
  terminated = 143
};

/// When to use colours: automatic is on a terminal without NO_COLOR.
enum class Colour { automatic, always, never };

/// Options that every program has.
struct OutputOptions : TableStyle {
  Colour colour = Colour::automatic;
  std::string output;  ///< file name, "" for standard output
  std::string plot;    ///< file name, "" for none
  int jobs = 1;
};

/// Names of --output and --plot, after a check that the files can be made; a
/// program adds its other files.
/// @throws contact::Error as OutputNames::keep() does
OutputNames names_of(const OutputOptions& options);

/// The command line of a program: options in groups.
class Program {
 public:
  /// @param does  its purpose, for --help
  Program(const std::string& does, const std::string& name);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Adds rows of options under a heading.
  /// @param group  the heading in --help
  void add(const std::string& group, const std::vector<Option>& options);
  /// Adds --output, --plot, --format and the other options of tables. While it
  /// reads the command line the program checks that the files can be made;
  /// other errors, warnings and the work follow.
  void add_output(OutputOptions& options);
  /// Adds --jobs.
  void add_jobs(OutputOptions& options);
  /// Adds --schema, which prints the schema of the program's file and ends.
  void add_schema(std::function<std::string()> text);
  /// Replaces the meaning of an option in --help.
  void describe(const char* flag, const char* meaning);
  /// Adds a check that runs before the checks of needs and excludes.
  void add_check(std::function<void()> check);

  /// True if an option is on the command line.
  bool has(std::string_view flag) const;
  const std::string& name() const;

  /// Sets up --help and --version, reads the command line and runs `body`,
  /// which returns an ExitStatus. An exception becomes the only message, "NAME:
  /// ...", on standard error and the status `failed`.
  /// @param help  text of --help below the options
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
/// warning if drawing failed.
ExitStatus drawn(std::string_view program, const std::string& problem,
                 ExitStatus status);

/// Prints "PROGRAM: warning: ..." on standard error.
void warn(std::string_view program, std::string_view message);
/// Prints "PROGRAM: note: ..." on standard error, except with --quiet.
void note(std::string_view program, std::string_view message);

}  // namespace cli
