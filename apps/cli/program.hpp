#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>

#include "cli/output_names.hpp"
#include "cli/table.hpp"

namespace CLI {
class App;
class Option;
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

/// What every program's --help says about them; goes into its footer.
inline constexpr std::string_view exit_status_help =
    "Exit status: 0 all computed; 1 a line of the input, a point or the\n"
    "picture failed and the rest is there; 2 bad option or file, no result.\n";

/// Options that every program has.
struct OutputOptions : TableStyle {
  std::string output;  ///< file name, "" for standard output
  std::string plot;    ///< file name, "" for none
  int jobs = 1;
};

/// Those of --output and --plot, which can be made, for a program to add its
/// own to.
/// @throws contact::Error as OutputNames::keep() does
OutputNames names_of(const OutputOptions& options);

/// Adds --output, --plot, --format and the other options of tables to a
/// program. That the files can be made is found out with the command line; then
/// come what else is refused, warnings, and the work.
void add_output_options(CLI::App& app, OutputOptions& options);
/// Adds --jobs.
void add_jobs_option(CLI::App& app, OutputOptions& options);

/// Adds options that take a text: what it is, and what --help calls it.
class TextOptions {
 public:
  explicit TextOptions(CLI::App& app) : app_(app) {}
  CLI::Option* operator()(const char* name, std::string& value,
                          const char* what, const char* kind) const;

 private:
  CLI::App& app_;
};

/// Has an option conflict with others.
void exclude(CLI::App& app, const char* option,
             std::initializer_list<const char*> others);

/// What a program ends with that has drawn a picture: `status`, or with a
/// problem, of which it warns, some_bad.
ExitStatus drawn(std::string_view program, const std::string& problem,
                 ExitStatus status);

/// Sets up --help and --version, reads the command line and runs `body`,
/// which returns an ExitStatus; turns exceptions into the one message
/// "NAME: ..." on standard error and `failed`.
int run_program(CLI::App& app, int argc, char** argv,
                const std::function<ExitStatus()>& body);

/// A message that is no error: "PROGRAM: warning: ..." on standard error.
void warn(std::string_view program, std::string_view message);
/// What is neither: "PROGRAM: note: ...".
void note(std::string_view program, std::string_view message);

}  // namespace cli
