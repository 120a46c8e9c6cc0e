#include "programs/study/findings/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/gnuplot.hpp"
#include "cli/number.hpp"
#include "cli/picture/axis.hpp"
#include "cli/picture/canvas.hpp"
#include "cli/picture/text_size.hpp"
#include "libcontact/base/constants.hpp"
#include "programs/study/findings/envelope.hpp"
#include "programs/study/findings/histograms.hpp"
#include "programs/study/findings/names.hpp"
#include "programs/study/findings/report.hpp"

namespace study {
namespace {

std::string named(const std::string& file, const std::string& what) {
  const std::size_t dot = file.rfind('.');
  return fmt::format("{}_{}{}", file.substr(0, dot), what, file.substr(dot));
}

// Bars to the right and left of 0, the first at the top, with their names.
std::string bar_script(
    const std::string& title, const std::string& x_label,
    const std::vector<std::pair<double, std::string>>& bars) {
  const cli::Canvas canvas(title);
  const cli::Box& room = canvas.room();
  double longest = 0;
  cli::Extent extent{0, 0};
  for (const auto& [value, name] : bars) {
    longest = std::max(longest, cli::text_width(name));
    extent = joined(extent, {value, value});
  }
  constexpr double least = 8;  // width of the bars, em
  const double left = std::min(room.left + longest + 0.7, room.right - least);
  const cli::Box box{left, room.right - 1, room.top,
                     room.bottom - cli::under_axis};
  const cli::Ticks across =
      ticks_of({}, extent, cli::Run::across, box.width(), true);
  const double count = static_cast<double>(bars.size());
  std::string data = "$bars << END\n";
  std::string names;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const double place = static_cast<double>(i);
    data += fmt::format("{} {}\n", cli::number_text(bars[i].first), i);
    names += canvas.text(box.left - 0.7,
                         box.top + (place + 0.5) / count * box.height(),
                         bars[i].second, cli::Anchor::right);
  }
  return data + "END\n" + canvas.script() + canvas.margins(box) +
         std::string(cli::tick_style) + across.script("x") + names +
         canvas.text((box.left + box.right) / 2,
                     room.bottom - cli::line_step / 2, x_label) +
         fmt::format(
             "unset key\nunset ytics\nset yrange [{}:-0.5]\n"
             "set style fill solid 0.8\nset yzeroaxis lt -1\n"
             "plot $bars using (0):2:(0):1:($2-0.35):($2+0.35) with boxxyerror "
             "lt 1\n",
             count - 0.5);
}

// The largest of the standardised coefficients, or of the total indices.
std::string ranking(const Study& study, const Driven& driven) {
  constexpr std::size_t shown = 10;
  const bool sobol = !driven.sobol.empty();
  std::vector<std::pair<double, std::string>> bars;
  const std::size_t size = sobol ? driven.sobol.size() : study.inputs();
  for (std::size_t i = 0; i < size; ++i) {
    const double strength =
        sobol ? driven.sobol[i].total : driven.regression.standardised[i];
    bars.emplace_back(std::isnan(strength) ? 0 : strength,
                      shown_name(sobol ? study.design().source_label(i)
                                       : study.design().draws()[i].label));
  }
  std::ranges::stable_sort(bars, std::greater(),
                           [](const auto& bar) { return std::abs(bar.first); });
  bars.resize(std::min(shown, bars.size()));
  return bar_script(
      "What drives " + shown_name(driven.quantity),
      sobol ? "total Sobol' index" : "standardised regression coefficient",
      bars);
}

// @param limit  NaN without one
std::string band(const Envelope& envelope, const std::string& title,
                 double limit) {
  std::string script = "$band << END\n";
  for (std::size_t i = 0; i < envelope.times.size(); ++i) {
    script += fmt::format("{}", envelope.times[i]);
    for (const double x : envelope.shares[i]) {
      script += ' ' + cli::number_text(x);
    }
    script += fmt::format(" {}\n", envelope.counts[i]);
  }
  script += "END\n" + heading(title, "time, s", envelope.label);
  // A key beside the curves would take half of the width.
  script += "set key above maxcols 3\n";
  if (envelope.is_wide()) script += "set logscale y\n";
  const auto [fewest, most] = std::ranges::minmax(envelope.counts);
  const std::string counts =
      fewest == most ? ""
                     : ", '' using 1:8 axes x1y2 with steps lt 4 dt 3 "
                       "title 'runs (right)'";
  if (!counts.empty()) {
    script +=
        "set y2tics\nset ytics nomirror\nset y2range [0:*]\n"
        "set y2label 'runs'\n";
  }
  script += fmt::format(
      "plot $band using 1:2:6 with filledcurves lc rgb '#c8d6e8' title "
      "'{0} runs', '' using 1:3:5 with filledcurves lc rgb '#7fa3c8' "
      "title '5 to 95 %', '' using 1:4 with lines lt 1 title '50 %', "
      "'' using 1:7 with lines lw 2 lc rgb '#333333' dt 2 title {1}{2}",
      envelope.runs, cli::gnuplot_text(envelope.special), counts);
  if (std::isfinite(limit)) {
    script += fmt::format(", {} with lines lt 2 title 'least allowed'",
                          cli::number_text(limit));
  }
  script += '\n';
  return script;
}

}  // namespace

std::vector<Picture> pictures_of(const Study& study, const Findings& findings,
                                 const Journal& journal) {
  std::vector<Picture> pictures;
  for (std::size_t i = 0; i < findings.requirements.size(); ++i) {
    pictures.push_back(
        {fmt::format("{}", i + 1),
         histogram(study, journal, findings.requirements[i], i)});
  }
  for (std::size_t i = 0; i < findings.driven.size(); ++i) {
    pictures.push_back(
        {fmt::format("ranking_{}", i + 1), ranking(study, findings.driven[i])});
  }
  for (std::size_t i = 0; i < count_input_pictures(study); ++i) {
    pictures.push_back({input_picture(i), input_histograms(study, journal, i)});
  }
  if (!study.plan().joint_file.empty()) return pictures;
  for (const Envelope& envelope : envelopes(study, findings)) {
    double limit = contact::detail::nan;
    for (const Requirement& r : study.plan().requirements) {
      if (r.quantity == envelope.quantity) limit = r.limit;
    }
    pictures.push_back(
        {envelope.name, band(envelope, study.plan().name, limit)});
  }
  return pictures;
}

std::vector<std::string> picture_files(const Study& study,
                                       const std::string& file) {
  std::vector<std::string> files;
  for (std::size_t i = 1; i <= study.plan().requirements.size(); ++i) {
    files.push_back(named(file, fmt::format("{}", i)));
  }
  for (std::size_t i = 1; i <= count_driven(study); ++i) {
    files.push_back(named(file, fmt::format("ranking_{}", i)));
  }
  for (std::size_t i = 0; i < count_input_pictures(study); ++i) {
    files.push_back(named(file, input_picture(i)));
  }
  if (study.plan().joint_file.empty()) {
    for (const char* name : envelope_names) files.push_back(named(file, name));
  }
  return files;
}

std::string draw(const std::vector<Picture>& pictures,
                 const std::string& file) {
  std::string problem;
  for (const Picture& picture : pictures) {
    const std::string name = named(file, picture.name);
    const std::string other =
        picture.script.empty() ? fmt::format("no picture {}: no numbers", name)
                               : cli::draw_script(picture.script, name);
    if (problem.empty()) problem = other;
  }
  return problem;
}

}  // namespace study
