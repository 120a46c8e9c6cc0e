#include "cli/program.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <sstream>
#include <utility>

#include "cli/choice.hpp"
#include "cli/files_in_use.hpp"
#include "cli/gnuplot.hpp"
#include "cli/gone.hpp"
#include "cli/help/short_help.hpp"
#include "cli/joint/shipped.hpp"
#include "cli/output.hpp"
#include "cli/plot.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/standard_streams.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/instruction_set.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/version.hpp"

namespace cli {
namespace {

using contact::detail::must_be;

constexpr std::array<Choice<Colour>, 3> colours = {{{"auto", Colour::automatic},
                                                    {"always", Colour::always},
                                                    {"never", Colour::never}}};

constexpr std::array<Choice<Format>, 5> formats = {
    {{"csv", Format::csv},
     {"json", Format::json},
     {"markdown", Format::markdown},
     {"latex", Format::latex},
     {"report", Format::report}}};

char parse_separator(const std::string& text) {
  if (text == "tab") return '\t';
  if (text.size() != 1 || std::string_view(",;|").find(text) == text.npos) {
    refuse("--separator", text, "one of ; | tab and the comma");
  }
  return text[0];
}

// Prints on one line, without control characters.
void complain(std::string_view program, std::string_view message) {
  say(fmt::format("{}: {}\n", program,
                  contact::detail::printable(message, message.npos)));
}

// The options named in a sentence.
std::vector<std::string_view> flags_in(std::string_view words) {
  std::vector<std::string_view> flags;
  for (const std::string_view word : split(words, " ,")) {
    if (word.starts_with("--")) flags.push_back(word);
  }
  return flags;
}

// Synonyms of options, accepted if the program has no option with that name.
constexpr std::pair<std::string_view, std::string_view> synonyms[] = {
    {"--load", "--reaction"},
    {"--reaction", "--load"},
    {"--language", "--kernel"},
    {"--error", "--kernel-error"}};

// Names from other programs, which may mean something else here: used only for
// suggestions.
constexpr std::pair<std::string_view, std::string_view> other_names[] = {
    {"--mu", "--friction"},        {"--f0", "--friction"},
    {"--force", "--reaction"},     {"--force", "--load"},
    {"--width", "--length"},       {"--material", "--pair"},
    {"--materials", "--pair"},     {"--file", "--joint"},
    {"--thickness", "--wall"},     {"--speed", "--rate"},
    {"--designation", "--bearing"}};

// The option that a word probably means.
std::string meant_option(const CLI::App& app, const std::string& word) {
  const std::string flag = word.substr(0, word.find('='));
  if (!flag.starts_with("--") || app.get_option_no_throw(flag) != nullptr) {
    return word;
  }
  for (const auto& [other, ours] : synonyms) {
    if (flag == other && app.get_option_no_throw(std::string(ours))) {
      return std::string(ours) + word.substr(flag.size());
    }
  }
  return word;
}

// ": did you mean "--load"?" for the first unknown option.
std::string nearest_option(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    names.push_back(option->get_name());
  }
  const std::size_t own = names.size();
  for (const auto& [other, ours] : synonyms) {
    const auto end = names.begin() + static_cast<std::ptrdiff_t>(own);
    if (std::find(names.begin(), end, ours) != end) names.emplace_back(other);
  }
  for (const std::string& word : app.remaining()) {
    if (!word.starts_with("--")) continue;
    const std::string flag = word.substr(0, word.find('='));
    std::string near;
    for (const auto& [other, ours] : other_names) {
      if (flag == other && std::ranges::find(names, ours) != names.end()) {
        near = ours;
      }
    }
    if (near.empty()) near = contact::detail::nearest(flag, names);
    return contact::detail::did_you_mean(near);
  }
  return {};
}

// Message about words that are unknown or removed options.
std::string stranger_message(const CLI::App& app, const std::string& program) {
  for (const std::string& word : app.remaining()) {
    const std::string gone = gone_option(program, word);
    if (!gone.empty()) return gone;
  }
  return fmt::format("unexpected on the command line: {}{} (see {} --help)",
                     fmt::join(app.remaining(), " "), nearest_option(app),
                     program);
}

// The words of the command line, last first, as CLI11 parses them. Inserts
// --joint before the file of a joint, or the name of a shipped one, that is not
// the value of an option. The first word may be an option without dashes, the
// task, also if this option follows the file.
std::vector<std::string> words_of(const CLI::App& app, int argc, char** argv) {
  const auto option = [&app](const std::string& word) {
    return app.get_option_no_throw(word);
  };
  const bool has_joint = option("--joint") != nullptr;
  const auto is_file = [](std::string_view word) {
    return word.ends_with(".toml");
  };
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    const CLI::Option* before = words.empty() ? nullptr : option(words.back());
    const bool is_value =
        before != nullptr && before->get_items_expected_max() > 0;
    std::string word = is_value ? argv[i] : meant_option(app, argv[i]);
    const std::string verb = "--" + word;
    if (i == 1 && option(verb) != nullptr) {
      word = verb;
      if (argc > 2 && is_file(argv[2]) &&
          std::any_of(argv + 3, argv + argc, [&](const std::string& later) {
            const std::string meant = meant_option(app, later);
            return meant == verb || meant.starts_with(verb + '=');
          })) {
        continue;
      }
    }
    if (has_joint && !is_value && !word.starts_with("-") &&
        (is_file(word) || shipped_file(Shipped::joints, word) != word)) {
      words.emplace_back("--joint");
    }
    words.push_back(word);
  }
  std::ranges::reverse(words);
  return words;
}

// Scripts pass an empty text for an unset variable; it must not count as a
// missing option.
void refuse_empty(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& text : option->results()) {
      if (!text.empty()) continue;
      refuse(option->get_name(), text, "a value, not empty");
    }
  }
}

// Rejects lists that can only be one number.
void refuse_cut_numbers(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& text : option->results()) {
      if (!has_cut_number(text)) continue;
      refuse(option->get_name(), text,
             "a list of numbers without leading zeros: write thousands without "
             "commas, decimals with a point");
    }
  }
}

// Notes lists that look like one number.
void note_thousands(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& text : option->results()) {
      if (!looks_like_thousands(text)) continue;
      note(app.get_name(), given(option->get_name(), text) +
                               " is read as a list of numbers: write thousands "
                               "without commas, decimals with a point");
    }
  }
}

// Messages show names of files and all other text on one line.
void refuse_control_characters(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view text = argv[i];
    if (!contact::detail::has_control_characters(text)) continue;
    throw contact::Error(must_be(contact::detail::printable(text),
                                 "without control characters"));
  }
}

// Prints to standard output; reports an error if it cannot be written.
ExitStatus say_text(std::string_view text) {
  Output output("");
  output.write(text);
  return all_good;
}

ExitStatus say_requested(const CLI::App& app, const CLI::Success& request) {
  std::ostringstream text;
  app.exit(request, text);
  return say_text(text.str());
}

constexpr std::array<Choice<const char*>, 3> shells = {
    {{"bash", "bash"}, {"zsh", "zsh"}, {"fish", "fish"}}};

// Checks table options against each other, and sets the separator.
void settle_table_options(bool separator, TableStyle& style) {
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

Program::Program(const std::string& does, const std::string& name)
    : app_(std::make_unique<CLI::App>(does, name)) {
  find_shipped();
}

Program::~Program() = default;

void Program::add(const std::string& group,
                  const std::vector<Option>& options) {
  const auto made = [this](const Option& o) {
    if (const auto* flag = std::get_if<bool*>(&o.target)) {
      return app_->add_flag(o.flag, **flag, o.meaning);
    }
    if (const auto* list = std::get_if<List>(&o.target)) {
      return app_->add_option(o.flag, *list->texts, o.meaning)
          ->delimiter(list->separator);
    }
    if (const auto* texts = std::get_if<Texts*>(&o.target)) {
      return app_->add_option(o.flag, **texts, o.meaning);
    }
    if (const auto* text = std::get_if<std::string*>(&o.target)) {
      return app_->add_option(o.flag, **text, o.meaning);
    }
    // Empty texts are rejected for all options at once.
    const auto read = [reader = std::get<Reader>(o.target)](const auto& text) {
      if (!text.empty()) reader(text);
    };
    return app_->add_option_function<std::string>(o.flag, read, o.meaning);
  };
  for (const Option& option : options) {
    CLI::Option* added = made(option)->group(group)->required(option.required);
    added->option_text(*option.kind == 0 ? " " : option.kind);
    if (std::holds_alternative<Texts*>(option.target)) {
      added->allow_extra_args(false);
    }
    rows_.push_back(option);
    groups_.push_back(group);
  }
}

void Program::add_output(OutputOptions& options) {
  output_ = &options;
  const Reader separator = [&options](const std::string& text) {
    options.separator = parse_separator(text);
  };
  const Reader plot = [&options](const std::string& file) {
    check_picture_name("--plot", file);
    options.plot = file;
  };
  add("Output",
      {{"--output", &options.output, "FILE",
        "file to write; default standard output"},
       {"--plot", plot, "FILE", "picture to draw: .svg, .png or .pdf"},
       {"--format", word("--format", options.format, formats), "NAME",
        "csv (default), json, markdown, latex, or report, the default on a "
        "terminal"},
       {"--all", &options.report.all, "", "print all columns in the report"},
       {"--quiet", &quiet, "", "leave notes and progress out"},
       {"--color", word("--color", options.colour, colours), "WHEN",
        "colours of the report: auto (default), always, never"},
       {"--columns", List{&options.columns}, "NAMES",
        "print only these columns, in this order"},
       {"--separator", separator, "CHAR",
        "separator of CSV: comma (default), ; | or tab; in input it is "
        "detected"},
       {"--decimal-comma", &options.decimal_comma, "",
        "decimal comma in CSV (0,5) and ; as the separator; in input 1,250 is "
        "then 1.25"}});
  app_->get_option("--columns")->allow_extra_args(false);
}

// Prints a report on a terminal unless a format is given.
void Program::settle_report() {
  OutputOptions& o = *output_;
  const bool on_terminal =
      (o.output.empty() || o.output == "-") && isatty(STDOUT_FILENO) == 1;
  const bool has_form =
      has("--format") || has("--separator") || o.decimal_comma;
  if (on_terminal && !has_form && !has("--output")) o.format = Format::report;
  if (o.format != Format::report) return;
  const char* no_colour = std::getenv("NO_COLOR");
  o.report.colour = o.colour == Colour::always ||
                    (o.colour == Colour::automatic && on_terminal &&
                     (no_colour == nullptr || *no_colour == 0));
  if (!on_terminal || o.report.all || !o.columns.empty()) return;
  o.report.more = "--all, --plot FILE, --format csv";
}

void Program::add_jobs(OutputOptions& options) {
  add("Output", {{"--jobs", count("--jobs", options.jobs, 1, 256), "N",
                  "threads, 1 (default) to 256"}});
}

void Program::add_schema(std::function<std::string()> text) {
  app_->add_flag_callback(
          "--schema", [text] { throw CLI::CallForVersion(text(), 0); },
          "print a JSON schema of the file's keys and units,\n"
          "for editors")
      ->group("Output");
}

void Program::describe(const char* flag, const char* meaning) {
  app_->get_option(flag)->description(meaning);
}

void Program::add_check(std::function<void()> check) {
  checks_.push_back(std::move(check));
}

bool Program::has(std::string_view flag) const {
  const CLI::Option* option = app_->get_option_no_throw(std::string(flag));
  return option != nullptr && option->count() > 0;
}

const std::string& Program::name() const { return app_->get_name(); }

void Program::check_rows() const {
  std::vector<Option> given;
  std::ranges::copy_if(rows_, std::back_inserter(given),
                       [this](const Option& row) { return has(row.flag); });
  const auto is_given = [this](std::string_view flag) { return has(flag); };
  for (const Option& row : given) {
    for (const std::string_view other : flags_in(row.excludes)) {
      if (has(other)) refuse_beside(row.flag, other);
    }
  }
  for (const Option& row : given) {
    for (const std::string_view needed : split(row.needs, ";")) {
      const auto flags = flags_in(needed);
      if (flags.empty() || std::ranges::any_of(flags, is_given)) continue;
      refuse_without(row.flag, needed.substr(needed.find('-')));
    }
  }
}

ProgramHelp Program::described(std::string_view text) const {
  ProgramHelp help{name(), app_->get_description(), {}, std::string(text)};
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    help.options.push_back({groups_[i], rows_[i]});
  }
  return help;
}

void Program::add_help(std::string_view help) {
  const auto flag = [this](const char* name, const char* meaning,
                           std::function<std::string()> text) {
    app_->add_flag_callback(
            name, [text] { throw CLI::CallForVersion(text(), 0); }, meaning)
        ->group("Options");
  };
  flag("--help-columns", "print the meanings of the columns", [help] {
    std::string text = columns_help(help);
    text.pop_back();
    return text;
  });
  flag("--man", "print the manual page",
       [this, help] { return man_page(described(help), contact::version); });
  const auto complete = [this, help](const std::string& shell) {
    throw CLI::CallForVersion(
        completion(choice("--completion", shell, shells), described(help)), 0);
  };
  app_->add_option_function<std::string>(
          "--completion", complete, "print completions for bash, zsh or fish")
      ->option_text("SHELL")
      ->group("Options");
}

int Program::run(int argc, char** argv, std::string_view help,
                 const std::function<ExitStatus()>& body) {
  app_->option_defaults()->group("Options");
  app_->set_version_flag("--version",
                         name() + " (libcontact) " + contact::version,
                         "print the version");
  app_->set_help_flag("-h,--help", "print a short help");
  app_->set_help_all_flag("--help-all", "print this help");
  app_->get_formatter()->column_width(26);
  app_->footer(std::string(help));
  add_help(help);
  try {
    open_missing_streams();
    note_reading();
    refuse_control_characters(argc, argv);
    try {
      app_->parse(words_of(*app_, argc, argv));
    } catch (const CLI::CallForHelp&) {
      return say_text(short_help(described(help)));
    } catch (const CLI::Success& request) {  // --help-all, --version
      return say_requested(*app_, request);
    }
    contact::detail::check_instruction_set();
    for (const auto& check : checks_) check();
    check_rows();
    if (output_ != nullptr) {
      settle_report();
      // Before the program reads, computes or prints anything.
      settle_table_options(has("--separator"), *output_);
      OutputNames names;
      names.add("--output", output_->output.empty() ? "-" : output_->output);
      names.add("--plot", output_->plot);
    }
    refuse_empty(*app_);
    refuse_cut_numbers(*app_);
    const ExitStatus status = body();
    note_thousands(*app_);
    return status;
  } catch (const CLI::ExtrasError&) {  // its text lists them backwards
    complain(name(), stranger_message(*app_, name()));
  } catch (const CLI::ArgumentMismatch& error) {  // "--load: 1 required ..."
    const std::string_view text = error.what();
    complain(name(), fmt::format("{} requires a value (see {} --help)",
                                 text.substr(0, text.find(':')), name()));
  } catch (const CLI::ParseError& error) {
    complain(name(), fmt::format("{} (see {} --help)", error.what(), name()));
  } catch (const std::exception& error) {
    complain(name(), error.what());
  }
  return failed;
}

void warn(std::string_view program, std::string_view message) {
  complain(program, fmt::format("warning: {}", message));
}

void note(std::string_view program, std::string_view message) {
  if (quiet) return;
  complain(program, fmt::format("note: {}", message));
}

ExitStatus drawn(std::string_view program, const std::string& problem,
                 ExitStatus status) {
  if (problem.empty()) return status;
  warn(program, problem);
  return some_bad;
}

}  // namespace cli
