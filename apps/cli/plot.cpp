#include "cli/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "cli/number.hpp"
#include "cli/output.hpp"
#include "cli/plot_style.hpp"

namespace cli {
namespace {

// Kinds of pictures: gnuplot's terminal, and its options. Sizes and fonts
// keep text readable when the picture is shown at a third of its width.
struct Kind {
  std::string_view suffix;
  std::string_view terminal;
  std::string_view options;
};
constexpr std::array<Kind, 3> kinds = {{
    {".svg", "svg",
     "size 840,560 font 'sans,19' rounded linewidth 1.2 background 'white'"},
    {".png", "pngcairo", "size 1260,840 font 'sans,20' rounded linewidth 1.5"},
    {".pdf", "pdfcairo", "size 7in,4.67in font 'sans,14' rounded"},
}};

const Kind* kind_of(std::string_view file) {
  for (const Kind& kind : kinds) {
    if (file.size() > kind.suffix.size() && file.ends_with(kind.suffix)) {
      return &kind;
    }
  }
  return nullptr;
}

bool shell(const std::string& command) {
  return std::system(command.c_str()) == 0;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view space = " \t\r\n^";
  const std::size_t begin = text.find_first_not_of(space);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(space) - begin + 1);
}

std::string shell_text(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      quoted += c;
    }
  }
  return quoted + '\'';
}

// What gnuplot says last, without the place in our script; "" if all is well.
// Its warnings are no business of the user's.
std::string run_gnuplot(const std::string& script) {
  const std::string command = "gnuplot " + shell_text(script) + " 2>&1";
  std::FILE* const pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return "gnuplot cannot be run";
  std::string last;
  std::array<char, 4096> line;
  while (std::fgets(line.data(), line.size(), pipe) != nullptr) {
    const std::string_view text = trimmed(line.data());
    if (!text.empty()) last = text;
  }
  if (::pclose(pipe) == 0) return {};
  const std::size_t place = last.find(": ");
  if (last.starts_with('"') && place != std::string::npos) {
    last.erase(0, place + 2);
  }
  return "gnuplot: " + (last.empty() ? "failed" : last);
}

std::string why_not(const Kind& kind) {
  if (!shell("command -v gnuplot >/dev/null 2>&1")) {
    return "gnuplot is not installed";
  }
  if (!shell(fmt::format("gnuplot -e 'set terminal {}' >/dev/null 2>&1",
                         kind.terminal))) {
    return fmt::format("this gnuplot has no terminal \"{}\" for {} files",
                       kind.terminal, kind.suffix);
  }
  return {};
}

}  // namespace

bool is_picture_name(std::string_view file) { return kind_of(file) != nullptr; }

std::string gnuplot_text(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    quoted += c;
    if (c == '\'') quoted += c;
  }
  return quoted + '\'';
}

std::string draw_script(std::string_view script, const std::string& file) {
  const Kind& kind = *kind_of(file);
  const std::string reason = why_not(kind);
  if (!reason.empty()) return "no picture " + file + ": " + reason;

  Output picture(file);
  // Never committed: the script goes when this function ends.
  Output commands(file + ".gp");
  commands.write(fmt::format(
      "set encoding utf8\nset terminal {} noenhanced {}\nset output {}\n{}\n",
      kind.terminal, kind.options,
      gnuplot_text(picture.temporary().empty() ? file
                                               : picture.temporary().native()),
      plot_style));
  commands.write(script);
  const std::string problem = run_gnuplot(commands.temporary().native());
  if (!problem.empty()) return "no picture " + file + ": " + problem;
  picture.commit();
  return {};
}

namespace {

// In plots/style.gp.
constexpr std::size_t plain_colours = 7;

// The data of the curves, added to the script, and what `plot` says of them.
std::string add_curves(std::string& script, const std::string& name,
                       const std::vector<Curve>& curves, bool family) {
  std::string lines;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Curve& curve = curves[i];
    script += fmt::format("${}{} << END\n", name, i);
    for (std::size_t j = 0; j < curve.x.size(); ++j) {
      script += number_text(curve.x[j]) + ' ' + number_text(curve.y[j]) + '\n';
    }
    script += "END\n";
    const std::string colour =
        family
            ? fmt::format("lw 2.5 lc palette frac {:.3f}",
                          static_cast<double>(i) /
                              static_cast<double>(
                                  std::max<std::size_t>(curves.size() - 1, 1)))
            : fmt::format("lt {}", curve.colour > 0
                                       ? static_cast<std::size_t>(curve.colour)
                                       : i % plain_colours + 1);
    // What goes round the colours again is dotted.
    const int dashes = curve.dashed ? 2 : !family && i >= plain_colours ? 3 : 1;
    lines += fmt::format("{}${}{} using 1:2 with lines {} dt {} title {}",
                         lines.empty() ? "" : ", \\\n  ", name, i, colour,
                         dashes, gnuplot_text(curve.label));
  }
  return lines;
}

// The upper panel's share and the room for text, as parts of the picture; the
// key of all laws in one column.
constexpr std::string_view upper_panel =
    "set multiplot\nset lmargin at screen 0.13\nset rmargin at screen 0.79\n"
    "set tmargin at screen 0.89\nset bmargin at screen 0.48\n"
    "set key spacing 1\nset format x ''\n";
constexpr std::string_view lower_panel =
    "unset title\nunset key\nset tmargin at screen 0.44\n"
    "set bmargin at screen 0.19\nset format x '%g'\n";

}  // namespace

std::string draw(const LinePlot& plot, const std::string& file) {
  std::string script;
  const std::string lines =
      add_curves(script, "curve", plot.curves, plot.family);
  script += fmt::format("set title {}\nset ylabel {}\nunset colorbox\n",
                        gnuplot_text(plot.title), gnuplot_text(plot.y_label));
  if (plot.logarithmic_x) script += "set logscale x\nset format x '%g'\n";
  if (plot.logarithmic_y) script += "set logscale y\nset format y '%g'\n";
  const std::string x_label =
      fmt::format("set xlabel {}\n", gnuplot_text(plot.x_label));
  if (!plot.lower) {
    return draw_script(script + x_label + "plot " + lines + '\n', file);
  }
  const std::string lower =
      add_curves(script, "lower", plot.lower->curves, false);
  script += upper_panel;
  script += "plot " + lines + '\n';
  script += lower_panel;
  script += x_label;
  script += fmt::format("set ylabel {}\nset yrange [{}:{}]\nplot {}\n",
                        gnuplot_text(plot.lower->y_label),
                        number_text(-plot.lower->half_range),
                        number_text(plot.lower->half_range), lower);
  return draw_script(script + "unset multiplot\n", file);
}

}  // namespace cli
