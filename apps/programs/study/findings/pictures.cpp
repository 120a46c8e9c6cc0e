#include "programs/study/findings/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/gnuplot.hpp"
#include "cli/number.hpp"
#include "programs/study/findings/envelope.hpp"
#include "programs/study/findings/report.hpp"

namespace study {
namespace {

std::string named(const std::string& file, const std::string& what) {
  const std::size_t dot = file.rfind('.');
  return fmt::format("{}_{}{}", file.substr(0, dot), what, file.substr(dot));
}

std::string heading(const std::string& title, const std::string& x_label,
                    const std::string& y_label) {
  return fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n",
                     cli::gnuplot_text(title), cli::gnuplot_text(x_label),
                     cli::gnuplot_text(y_label));
}

// Counts of equal classes between the smallest and the largest number: as wide
// as Freedman and Diaconis have them, 80 at most.
struct Classes {
  double low;
  double width;
  std::vector<int> counts;
};
Classes classes_of(const std::vector<double>& sorted) {
  constexpr double most = 80;
  const double low = sorted.front();
  const double span = sorted.back() - low;
  const auto at = [&](double p) {
    return sorted[static_cast<std::size_t>(
        p * static_cast<double>(sorted.size() - 1))];
  };
  const double wanted =
      2 * (at(0.75) - at(0.25)) / std::cbrt(static_cast<double>(sorted.size()));
  const double count =
      wanted > 0 ? std::clamp(std::ceil(span / wanted), 1.0, most) : 1;
  Classes classes{low, span > 0 ? span / count : 1,
                  std::vector<int>(static_cast<std::size_t>(count))};
  for (const double x : sorted) {
    const auto i = static_cast<std::size_t>((x - low) / classes.width);
    ++classes.counts[std::min(i, classes.counts.size() - 1)];
  }
  return classes;
}

// A line across the picture; none at infinity.
std::string upright(double x, int style, int dash, const std::string& label) {
  if (std::isinf(x)) return {};
  return fmt::format(
      ", '+' using ({0}):($0 > 0 ? top : 0) every 2 with lines lw 2 lt {1} "
      "dt {2} title {3}",
      cli::number_text(x), style, dash, cli::gnuplot_text(label));
}

std::string histogram(const Study& study, const Journal& journal,
                      const Judgement& judgement, std::size_t place) {
  const Requirement& requirement = study.plan().requirements[place];
  std::vector<double> values = column(study, journal, [&](const Row& row) {
    return study.value_of(place, row);
  });
  std::erase_if(values, [](double x) { return std::isnan(x); });
  if (values.empty()) return {};
  std::ranges::sort(values);
  const Classes classes = classes_of(values);
  std::string script = "$counts << END\n";
  for (std::size_t i = 0; i < classes.counts.size(); ++i) {
    script += fmt::format(
        "{} {}\n",
        cli::number_text(classes.low +
                         (static_cast<double>(i) + 0.5) * classes.width),
        classes.counts[i]);
  }
  const int top = std::ranges::max(classes.counts);
  script += "END\n" + heading(study.plan().name, requirement.quantity, "runs");
  script += fmt::format(
      "top = {}\nset samples 3\nset yrange [0:*]\nset style fill solid 0.5\n"
      "set key above\n"
      "plot $counts using 1:2:({}) with boxes lt 1 lw 0.5 title '{} runs{}'",
      1.05 * top, cli::number_text(classes.width), values.size(),
      judgement.missing == 0
          ? ""
          : fmt::format(", {} have no number", judgement.missing));
  script += upright(requirement.limit, 2, 1, "limit");
  const Percentile& p = judgement.percentile;
  const std::string share = fmt::format("{:.6g} %", 100 * judgement.share);
  script += upright(p.value, 3, 1, share);
  if (p.low) script += upright(*p.low, 3, 2, "lower bound");
  if (p.high) script += upright(*p.high, 3, 3, "upper bound");
  return script + '\n';
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
    bars.emplace_back(
        std::isnan(strength) ? 0 : strength,
        sobol ? study.design().sources()[i] : study.design().draws()[i].name);
  }
  std::ranges::stable_sort(bars, std::greater(),
                           [](const auto& bar) { return std::abs(bar.first); });
  bars.resize(std::min(shown, bars.size()));
  std::string script = "$bars << END\n";
  std::string tics;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    script += fmt::format("{} {}\n", cli::number_text(bars[i].first), i);
    tics += fmt::format("{}{} {}", i == 0 ? "" : ", ",
                        cli::gnuplot_text(bars[i].second), i);
  }
  script += "END\n" + heading("",
                              sobol ? "total Sobol' index"
                                    : "standardised regression coefficient",
                              "");
  // gnuplot reserves twice the room that names need, and centres the title on
  // what is left.
  std::size_t longest = 0;
  for (const auto& bar : bars) longest = std::max(longest, bar.second.size());
  const double span = std::max(0.0, std::ranges::max(bars).first) -
                      std::min(0.0, std::ranges::min(bars).first);
  script += fmt::format(
      "set label {} at screen 0.5, 0.96 center\nset lmargin at screen {}\n"
      "set rmargin at screen 0.94\nset tmargin at screen 0.9\n",
      cli::gnuplot_text("What drives " + driven.quantity),
      std::clamp(0.012 * static_cast<double>(longest) + 0.03, 0.2, 0.64));
  script += fmt::format(
      "unset key\nset xtics {}\nset ytics ({})\nset yrange [{}:-0.7]\n"
      "set style fill solid 0.8\nset yzeroaxis lt -1\n"
      "plot $bars using (0):2:(0):1:($2-0.35):($2+0.35) with boxxyerror lt 1\n",
      span > 1.2 ? 0.5 : 0.2, tics, static_cast<double>(bars.size()) - 0.3);
  return script;
}

std::string band(const Envelope& envelope, const std::string& title) {
  std::string script = "$band << END\n";
  for (std::size_t i = 0; i < envelope.times.size(); ++i) {
    script += fmt::format("{}", envelope.times[i]);
    for (const double x : envelope.shares[i]) {
      script += ' ' + cli::number_text(x);
    }
    script += '\n';
  }
  script += "END\n" + heading(title, "time, s", envelope.label);
  if (envelope.is_wide()) script += "set logscale y\nset format y '%g'\n";
  script += fmt::format(
      "plot $band using 1:2:6 with filledcurves lc rgb '#c8d6e8' title "
      "'{0} runs', '' using 1:3:5 with filledcurves lc rgb '#7fa3c8' "
      "title '5 to 95 %', '' using 1:4 with lines lt 1 title '50 %', "
      "'' using 1:7 with lines lt 2 dt 2 title {1}\n",
      envelope.runs, cli::gnuplot_text(envelope.special));
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
  if (!study.plan().joint_file.empty()) return pictures;
  for (const Envelope& envelope : envelopes(study, findings)) {
    pictures.push_back({envelope.name, band(envelope, study.plan().name)});
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
