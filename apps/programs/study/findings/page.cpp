#include "programs/study/findings/page.hpp"

#include <fmt/format.h>

#include "cli/html/markup.hpp"
#include "libcontact/version.hpp"
#include "programs/study/findings/names.hpp"
#include "programs/study/findings/report.hpp"

namespace study {
namespace {

using cli::in_markup;

// A file's name as a relative URL without quotes.
std::string address(std::string_view name) {
  constexpr std::string_view plain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~";
  std::string result;
  for (const char c : name) {
    result += plain.find(c) != plain.npos
                  ? std::string(1, c)
                  : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return result;
}

std::string cell(const char* element, const std::string& markup) {
  return fmt::format("<{0}>{1}</{0}>", element, markup);
}

// A cell with the name of its column, shown before it when rows are cards.
std::string named_cell(const char* element, const std::string& name,
                       const std::string& content) {
  return fmt::format("<{0} data-name=\"{1}\">{2}</{0}>", element,
                     in_markup(name), in_markup(content));
}

// Links of the worst runs beside their numbers.
std::string ways_to(const Study& study, std::uint64_t run,
                    const std::string& command, const PageExtras& extras) {
  std::string text;
  if (!extras.replays.empty()) {
    const auto found = extras.replays.find(run);
    text = cell("td", found == extras.replays.end()
                          ? "-"
                          : fmt::format("<a href=\"{}\">run {}</a>",
                                        address(found->second), run));
  }
  return text +
         cell("td", cell("code", in_markup(command_of(study, command, run))));
}

std::string table(const Study& study, const Part& part,
                  const std::string& command, const PageExtras& extras) {
  std::string text = "<div class=\"wide\"><table>\n<thead><tr>";
  for (const std::string& name : part.header)
    text += cell("th", in_markup(name));
  if (!part.runs.empty()) {
    if (!extras.replays.empty()) text += cell("th", "replay");
    text += cell("th", "to repeat it");
  }
  text += "</tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < part.rows.size(); ++i) {
    text += "<tr>";
    for (std::size_t k = 0; k < part.rows[i].size(); ++k) {
      text += named_cell(k == 0 ? "th" : "td", part.header[k], part.rows[i][k]);
    }
    if (!part.runs.empty()) {
      text += ways_to(study, part.runs[i], command, extras);
    }
    text += "</tr>\n";
  }
  return text + "</tbody>\n</table></div>\n";
}

// Removes the text before the svg element.
std::string figure(const std::string& svg) {
  return "<figure>" + svg.substr(svg.find("<svg")) + "</figure>\n";
}

std::string markup(const Study& study, const std::vector<Part>& parts,
                   const std::string& command, const PageExtras& extras) {
  std::string body;
  const char* end = "";
  for (const Part& part : parts) {
    if (!part.heading.empty()) {
      body += fmt::format("{}<section>\n<h2>{}</h2>\n", end,
                          in_markup(part.heading));
      end = "</section>\n";
    }
    if (!part.text.empty()) body += cell("p", in_markup(part.text)) + '\n';
    if (!part.header.empty()) body += table(study, part, command, extras);
    for (const std::string& name : part.pictures) {
      const auto found = extras.pictures.find(name);
      if (found != extras.pictures.end()) body += figure(found->second);
    }
  }
  return body + end;
}

// The answers, which stand before everything else.
std::string answers_of(const Study& study, const Findings& findings) {
  std::string body;
  for (std::size_t i = 0; i < findings.requirements.size(); ++i) {
    const Judgement& judgement = findings.requirements[i];
    constexpr const char* kinds[] = {"met", "not_met", "open"};
    body += fmt::format(
        "<p class=\"verdict {}\">{}</p>\n",
        judgement.answer ? kinds[static_cast<int>(*judgement.answer)] : "open",
        in_markup(
            verdict_sentence(study, study.plan().requirements[i], judgement)));
  }
  return body;
}

}  // namespace

std::string report_page(const Study& study, const Findings& findings,
                        const std::string& command, const PageExtras& extras) {
  std::string body = fmt::format(
      "<header>\n<h1>{}</h1>\n<p id=\"about\">hinge-study (libcontact) "
      "{}</p>\n</header>\n<main class=\"report\">\n",
      in_markup(study.plan().name), contact::version);
  body += answers_of(study, findings) +
          markup(study, parts_of(study, findings, in_words), command, extras) +
          markup(study, inputs_of(study, in_words), command, extras) +
          fmt::format("<section>\n<h2>{}</h2>\n<pre>{}</pre>\n</section>\n",
                      in_markup(study.plan().path.filename().string()),
                      in_markup(extras.study_file));
  return cli::still_page(study.plan().name, body + "</main>\n");
}

}  // namespace study
