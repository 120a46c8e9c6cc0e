#include "cli/program.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include <array>
#include <exception>

#include "cli/choice.hpp"
#include "cli/files_in_use.hpp"
#include "cli/gnuplot.hpp"
#include "cli/output.hpp"
#include "cli/plot.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/standard_streams.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/version.hpp"

namespace cli {
namespace {

using contact::detail::must_be;

constexpr std::array<Choice<Format>, 4> formats = {
    {{"csv", Format::csv},
     {"json", Format::json},
     {"markdown", Format::markdown},
     {"latex", Format::latex}}};

char parse_separator(const std::string& text) {
  if (text == "tab") return '\t';
  if (text.size() != 1 || std::string_view(",;|").find(text) == text.npos) {
    refuse("--separator", text, "one of ; | tab and the comma");
  }
  return text[0];
}

// On one line, and nothing in it speaks to the terminal.
void complain(std::string_view program, std::string_view message) {
  say(fmt::format("{}: {}\n", program,
                  contact::detail::printable(message, message.npos)));
}

// An empty text, as scripts pass it for a variable that is not set, must not
// count as an option that was left out.
void refuse_empty(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& text : option->results()) {
      if (!text.empty()) continue;
      refuse(option->get_name(), text, "a value, or the option left out");
    }
  }
}

// Lists that were hardly meant as such.
void note_thousands(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& text : option->results()) {
      if (!looks_like_thousands(text)) continue;
      note(app.get_name(),
           given(option->get_name(), text) +
               " is a list of numbers: thousands have no commas here");
    }
  }
}

// Names of files and all other text are shown in messages, on one line.
void refuse_control_characters(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view text = argv[i];
    if (!contact::detail::has_control_characters(text)) continue;
    throw contact::Error(must_be(contact::detail::printable(text),
                                 "without control characters"));
  }
}

void add_table_options(CLI::App& app, TableStyle& style) {
  app.add_option_function<std::string>(
         "--format",
         [&style](const std::string& name) {
           style.format = choice("--format", name, formats);
         },
         "csv (default), json, markdown, latex")
      ->option_text("NAME");
  app.add_option("--columns", style.columns,
                 "of the table, only these and in this order")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->option_text("NAMES");
  app.add_option_function<std::string>(
         "--separator",
         [&style](const std::string& text) {
           style.separator = parse_separator(text);
         },
         "of CSV: ; | tab or a comma (default)")
      ->option_text("CHAR");
  app.add_flag("--decimal-comma", style.decimal_comma,
               "0,5 for 0.5 in CSV, and ; for the separator")
      ->option_text(" ");
}

// What they are of each other; sets the separator beside decimal commas.
void settle_table_options(const CLI::App& app, TableStyle& style) {
  const bool separator = app.count("--separator") > 0;
  if (style.format != Format::csv && (separator || style.decimal_comma)) {
    refuse_without(separator ? "--separator" : "--decimal-comma",
                   "--format csv");
  }
  if (style.decimal_comma && !separator) style.separator = ';';
  if (style.decimal_comma && style.separator == ',') {
    refuse_beside("--decimal-comma", given("--separator", ","));
  }
  for (auto name = style.columns.begin(); name != style.columns.end(); ++name) {
    if (std::find(style.columns.begin(), name, *name) == name) continue;
    throw contact::Error(contact::detail::duplicate("--columns", *name));
  }
}

}  // namespace

OutputNames names_of(const OutputOptions& options) {
  OutputNames names;
  names.keep("--output", options.output.empty() ? "-" : options.output);
  names.keep("--plot", options.plot);
  return names;
}

void add_output_options(CLI::App& app, OutputOptions& options) {
  app.option_defaults()->group("Output");
  add_table_options(app, options);
  app.add_option("--output", options.output,
                 "file to write; default standard output")
      ->option_text("FILE");
  app.add_option_function<std::string>(
         "--plot",
         [&options](const std::string& file) {
           check_picture_name("--plot", file);
           options.plot = file;
         },
         "picture to draw: .svg, .png or .pdf")
      ->option_text("FILE");
  // Before anything is read, computed or said.
  app.parse_complete_callback([&app, &options] {
    settle_table_options(app, options);
    OutputNames names;
    names.add("--output", options.output.empty() ? "-" : options.output);
    names.add("--plot", options.plot);
  });
}

void add_jobs_option(CLI::App& app, OutputOptions& options) {
  app.add_option_function<std::string>(
         "--jobs",
         [&options](const std::string& text) {
           options.jobs = parse_count("--jobs", text, 1, 256);
         },
         "threads, 1 (default) to 256")
      ->option_text("N")
      ->group("Output");
}

CLI::Option* TextOptions::operator()(const char* name, std::string& value,
                                     const char* what, const char* kind) const {
  return app_.add_option(name, value, what)->option_text(kind);
}

void exclude(CLI::App& app, const char* option,
             std::initializer_list<const char*> others) {
  for (const char* other : others) {
    app.get_option(option)->excludes(app.get_option(other));
  }
}

int run_program(CLI::App& app, int argc, char** argv,
                const std::function<ExitStatus()>& body) {
  app.option_defaults()->group("Options");
  app.set_version_flag("--version",
                       app.get_name() + " (libcontact) " + contact::version,
                       "print the version");
  app.set_help_flag("-h,--help", "print this help");
  app.get_formatter()->column_width(26);
  try {
    open_missing_streams();
    note_reading();
    refuse_control_characters(argc, argv);
    app.parse(argc, argv);
    refuse_empty(app);
    const ExitStatus status = body();
    note_thousands(app);
    return status;
  } catch (const CLI::Success& request) {
    return app.exit(request);          // --help, --version
  } catch (const CLI::ExtrasError&) {  // whose text has them backwards
    complain(app.get_name(),
             fmt::format("not expected: {} (see {} --help)",
                         fmt::join(app.remaining(), " "), app.get_name()));
  } catch (const CLI::ExcludesError& error) {  // "A excludes B"
    std::string text = error.what();
    constexpr std::string_view excludes = " excludes ";
    const std::size_t at = text.find(excludes);
    complain(app.get_name(),
             contact::detail::conflicts(text.substr(0, at),
                                        text.substr(at + excludes.size())));
  } catch (const CLI::RequiresError& error) {
    complain(app.get_name(), error.what());
  } catch (const CLI::ParseError& error) {
    complain(app.get_name(),
             fmt::format("{} (see {} --help)", error.what(), app.get_name()));
  } catch (const std::exception& error) {
    complain(app.get_name(), error.what());
  }
  return failed;
}

void warn(std::string_view program, std::string_view message) {
  complain(program, fmt::format("warning: {}", message));
}

void note(std::string_view program, std::string_view message) {
  complain(program, fmt::format("note: {}", message));
}

ExitStatus drawn(std::string_view program, const std::string& problem,
                 ExitStatus status) {
  if (problem.empty()) return status;
  warn(program, problem);
  return some_bad;
}

}  // namespace cli
