#include "cli/help/short_help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "cli/quantity.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/pressure/factory.hpp"

namespace cli {
namespace {

constexpr std::size_t page_width = 79;

bool is_flag(const Option& row) {
  return std::holds_alternative<bool*>(row.target);
}

bool is_file(const Option& row) {
  return std::string_view(row.kind).find("FILE") != std::string_view::npos;
}

// "--radius LENGTH"
std::string form_of(const Option& row) {
  return *row.kind == 0 ? row.flag : fmt::format("{} {}", row.flag, row.kind);
}

// Paragraphs of a text, separated by empty lines.
std::vector<std::string> paragraphs(std::string_view text) {
  std::vector<std::string> all(1);
  for (const std::string_view line : split(text, "\n")) {
    if (line.empty()) {
      if (!all.back().empty()) all.emplace_back();
    } else {
      all.back() += std::string(line) + '\n';
    }
  }
  return all;
}

std::vector<std::string_view> examples(std::string_view text) {
  constexpr std::string_view heading = "Examples:\n";
  std::vector<std::string_view> all;
  const std::size_t at = text.find(heading);
  if (at == text.npos) return all;
  for (const std::string_view line :
       split(text.substr(at + heading.size()), "\n")) {
    if (!line.starts_with("  ")) break;
    all.push_back(line.substr(2));
  }
  return all;
}

// Groups in the order of their first options.
std::vector<std::string> groups(const ProgramHelp& program) {
  std::vector<std::string> all;
  for (const GroupedOption& option : program.options) {
    if (std::ranges::find(all, option.group) == all.end()) {
      all.push_back(option.group);
    }
  }
  return all;
}

std::string quoted(std::string_view text) {
  std::string shown;
  for (const char c : text) {
    shown += c == '\'' ? "'\\''" : c == '\n' ? " " : std::string(1, c);
  }
  return shown;
}

// Words listed in a kind or a meaning, such as the values of an enumeration.
std::string words_of(const Option& row) {
  const std::string_view given = row.flag;
  if (given == "--law") {
    return fmt::format("{} all",
                       fmt::join(contact::half_angle_law_names(), " "));
  }
  if (given == "--pressure") {
    return fmt::format("{} all", fmt::join(contact::pressure_law_names(), " "));
  }
  constexpr std::pair<std::string_view, std::string_view> known[] = {
      {"--format", "csv json markdown latex report"},
      {"--color", "auto always never"},
      {"--fit-clearance", "minimum mean maximum"},
      {"--group", "C2 CN C3"},
      {"--separator", "; | tab ,"}};
  for (const auto& [flag, words] : known) {
    if (flag == given) return std::string(words);
  }
  return {};
}

std::string bash(const ProgramHelp& program) {
  std::string flags = "--help --help-all --help-columns --version";
  std::string files;
  std::string others;
  for (const auto& [group, row] : program.options) {
    flags += fmt::format(" {}", row.flag);
    if (is_flag(row)) continue;
    std::string& to = is_file(row) ? files : others;
    if (words_of(row).empty()) to += fmt::format("{}|", row.flag);
  }
  std::string words;
  for (const auto& [group, row] : program.options) {
    if (words_of(row).empty()) continue;
    words += fmt::format(
        "    {}) COMPREPLY=($(compgen -W '{}' -- \"$at\")); return ;;\n",
        row.flag, words_of(row));
  }
  std::string function = "_" + program.name;
  std::ranges::replace(function, '-', '_');
  return fmt::format(
      "{0}() {{\n"
      "  local at=${{COMP_WORDS[COMP_CWORD]}}\n"
      "  case ${{COMP_WORDS[COMP_CWORD-1]}} in\n{1}"
      "    {2}--) compopt -o filenames\n"
      "      COMPREPLY=($(compgen -f -- \"$at\")); return ;;\n"
      "    {3}--) return ;;\n"
      "  esac\n"
      "  if [[ $at == -* ]]; then\n"
      "    COMPREPLY=($(compgen -W '{4}' -- \"$at\"))\n"
      "  else\n"
      "    compopt -o filenames\n"
      "    COMPREPLY=($(compgen -f -- \"$at\"))\n"
      "  fi\n}}\n"
      "complete -F {0} {5}\n",
      function, words, files, others, flags, program.name);
}

std::string zsh(const ProgramHelp& program) {
  std::string text =
      fmt::format("#compdef {}\n_arguments -s \\\n", program.name);
  for (const auto& [group, row] : program.options) {
    std::string about;
    for (const char c : quoted(row.meaning)) {
      about += c == '[' || c == ']' || c == ':' ? fmt::format("\\{}", c)
                                                : std::string(1, c);
    }
    text += fmt::format("  '{}[{}]{}' \\\n", row.flag, about,
                        is_flag(row) ? ""
                        : !words_of(row).empty()
                            ? fmt::format(":{}:({})", row.kind, words_of(row))
                        : is_file(row) ? ":file:_files"
                                       : fmt::format(":{}: ", row.kind));
  }
  return text + "  '*:file:_files'\n";
}

std::string fish(const ProgramHelp& program) {
  std::string text;
  for (const auto& [group, row] : program.options) {
    const std::string_view flag = row.flag;
    if (!flag.starts_with("--")) continue;
    const std::string words = words_of(row);
    text += fmt::format("complete -c {} -l {} {}-d '{}'\n", program.name,
                        flag.substr(2),
                        is_flag(row)     ? ""
                        : !words.empty() ? fmt::format("-x -a '{}' ", words)
                        : is_file(row)   ? "-r -F "
                                         : "-x ",
                        quoted(row.meaning));
  }
  return text;
}

// Escapes text for troff.
std::string troff(std::string_view text) {
  std::string shown;
  for (const std::string_view line : split(text, "\n")) {
    if (!shown.empty()) shown += '\n';
    if (line.starts_with('.') || line.starts_with('\'')) shown += "\\&";
    for (const char c : line) {
      shown += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    }
  }
  return shown;
}

}  // namespace

std::string short_help(const ProgramHelp& program) {
  std::string text = fmt::format("{}\n\n", program.does);
  // The first examples are the most useful ones.
  auto shown = examples(program.text);
  shown.resize(std::min<std::size_t>(shown.size(), 3));
  for (const std::string_view example : shown) {
    text += fmt::format("  {}\n", example);
  }
  if (!shown.empty()) text += '\n';
  for (const std::string& group : groups(program)) {
    std::string line = fmt::format("{}:", group);
    for (const auto& [of, row] : program.options) {
      if (of != group) continue;
      const std::string form = form_of(row);
      if (line.size() + form.size() + 2 > page_width) {
        text += line + '\n';
        line = "   ";
      }
      line += "  " + form;
    }
    text += line + '\n';
  }
  return text + fmt::format(
                    "\nAll of it, with units and examples: {0} --help-all; "
                    "meanings of columns:\n{0} --help-columns\n",
                    program.name);
}

std::string columns_help(std::string_view text) {
  std::string found;
  for (const std::string& paragraph : paragraphs(text)) {
    const std::string first = paragraph.substr(0, paragraph.find('\n'));
    if (first.starts_with("Columns") || first.starts_with("Output:")) {
      found += (found.empty() ? "" : "\n") + paragraph;
    }
  }
  return found.empty() ? std::string(text) : found;
}

std::string completion(std::string_view shell, const ProgramHelp& program) {
  return shell == "bash"  ? bash(program)
         : shell == "zsh" ? zsh(program)
                          : fish(program);
}

std::string man_page(const ProgramHelp& program, std::string_view version) {
  std::string title = program.name;
  std::ranges::transform(title, title.begin(), [](unsigned char c) {
    return static_cast<char>(std::toupper(c));
  });
  std::string text = fmt::format(
      ".TH {} 1 \"\" \"libcontact {}\" \"User commands\"\n.SH NAME\n{} \\- "
      "{}\n.SH SYNOPSIS\n.B {}\n[\\fIoptions\\fR]\n",
      title, version, troff(program.name), troff(program.does),
      troff(program.name));
  for (const std::string& group : groups(program)) {
    text += fmt::format(".SH {}\n", troff(group));
    for (const auto& [of, row] : program.options) {
      if (of != group) continue;
      text += fmt::format(".TP\n\\fB{}\\fR {}\n{}\n", troff(row.flag),
                          troff(row.kind), troff(row.meaning));
    }
  }
  return text +
         fmt::format(".SH DESCRIPTION\n.nf\n{}\n.fi\n", troff(program.text));
}

}  // namespace cli
