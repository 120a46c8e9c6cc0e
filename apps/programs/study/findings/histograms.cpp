#include "programs/study/findings/histograms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/gnuplot.hpp"
#include "cli/number.hpp"
#include "cli/picture/axis.hpp"
#include "libcontact/base/text.hpp"
#include "programs/study/findings/names.hpp"

namespace study {

std::string heading(const std::string& title, const std::string& x_label,
                    const std::string& y_label) {
  return fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n",
                     cli::gnuplot_text(title), cli::gnuplot_text(x_label),
                     cli::gnuplot_text(y_label));
}

namespace {

// Counts in equal classes between the smallest and the largest number. Width
// after Freedman and Diaconis, at most 80 classes; if half of the numbers are
// equal, the number of classes after Sturges.
struct Classes {
  double low;
  double width;
  std::vector<int> counts;
};
Classes classes_of(const std::vector<double>& sorted) {
  constexpr double most = 80;
  const double low = sorted.front();
  const double span = sorted.back() - low;
  const double scale = std::max(std::abs(low), std::abs(sorted.back()));
  // Numbers that differ by rounding are one: a narrow class about it.
  if (!(span > 1e-9 * scale)) {
    const double width = scale > 0 ? 0.01 * scale : 1;
    return {low - width / 2, width, {static_cast<int>(sorted.size())}};
  }
  const auto at = [&](double p) {
    return sorted[static_cast<std::size_t>(
        p * static_cast<double>(sorted.size() - 1))];
  };
  const auto size = static_cast<double>(sorted.size());
  const double wanted = 2 * (at(0.75) - at(0.25)) / std::cbrt(size);
  const double count = wanted > 0
                           ? std::clamp(std::ceil(span / wanted), 1., most)
                           : 1 + std::ceil(std::log2(size));
  Classes classes{low, span / count,
                  std::vector<int>(static_cast<std::size_t>(count))};
  for (const double x : sorted) {
    const auto i = static_cast<std::size_t>((x - low) / classes.width);
    ++classes.counts[std::min(i, classes.counts.size() - 1)];
  }
  return classes;
}

// The middle of each class and its count.
std::string data_of(const Classes& classes, const std::string& name) {
  std::string script = fmt::format("${} << END\n", name);
  for (std::size_t i = 0; i < classes.counts.size(); ++i) {
    script += fmt::format(
        "{} {}\n",
        cli::number_text(classes.low +
                         (static_cast<double>(i) + 0.5) * classes.width),
        classes.counts[i]);
  }
  return script + "END\n";
}

// A vertical line across the picture; none at infinity.
std::string upright(double x, int style, int dash, const std::string& label) {
  if (std::isinf(x)) return {};
  return fmt::format(
      ", '+' using ({0}):($0 > 0 ? top : 0) every 2 with lines lw 2 lt {1} "
      "dt {2} title {3}",
      cli::number_text(x), style, dash, cli::gnuplot_text(label));
}

}  // namespace

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
  const int top = std::ranges::max(classes.counts);
  std::string script =
      data_of(classes, "counts") +
      heading(study.plan().name, shown_label(requirement.quantity), "runs");
  // A limit at the end of the range is not drawn on the axis.
  const double high =
      classes.low + classes.width * static_cast<double>(classes.counts.size());
  cli::Extent extent{classes.low, high};
  if (std::isfinite(requirement.limit)) {
    extent = cli::joined(extent, {requirement.limit, requirement.limit});
  }
  const double margin = 0.04 * (extent.high - extent.low);
  script +=
      fmt::format("set xrange [{}:{}]\n", cli::number_text(extent.low - margin),
                  cli::number_text(extent.high + margin));
  script += fmt::format(
      "top = {}\nset samples 3\nset yrange [0:*]\nset style fill solid 0.5\n"
      "set key above\n"
      "plot $counts using 1:2:({}) with boxes lt 1 lw 0.5 title '{} runs{}'",
      1.05 * top, cli::number_text(classes.width), values.size(),
      judgement.missing == 0
          ? ""
          : fmt::format(", {} have no number", judgement.missing));
  script += upright(requirement.limit, 2, 1,
                    requirement.at_least ? "least allowed" : "most allowed");
  const Percentile& p = judgement.percentile;
  const std::string share =
      fmt::format("percentile {:.6g} %", 100 * judgement.share);
  script += upright(p.value, 3, 1, share);
  if (p.low) script += upright(*p.low, 3, 2, "lower bound");
  if (p.high) script += upright(*p.high, 3, 3, "upper bound");
  return script + '\n';
}

namespace {

// More panels would leave no room for their names.
constexpr std::size_t most_panels = 9;

// All draws of a dispersion, in all runs.
std::vector<double> drawn(const Study& study, const Journal& journal,
                          std::size_t dispersion) {
  std::vector<double> all;
  const auto& draws = study.design().draws();
  for (std::size_t i = 0; i < draws.size(); ++i) {
    if (draws[i].dispersion != dispersion) continue;
    const auto values =
        column(study, journal, [i](const Row& row) { return row.numbers[i]; });
    all.insert(all.end(), values.begin(), values.end());
  }
  std::erase_if(all, [](double x) { return std::isnan(x); });
  std::ranges::sort(all);
  return all;
}

std::string panel(const Study& study, const Journal& journal,
                  std::size_t dispersion) {
  const Dispersion& d = study.plan().dispersions[dispersion];
  const std::vector<double> values = drawn(study, journal, dispersion);
  const Classes classes = classes_of(values);
  const std::string name = fmt::format("input{}", dispersion);
  constexpr std::size_t longest = 32;
  const std::string title = contact::detail::printable(
      d.relative ? shown_name(d.key) + ", factor" : shown_label(d.key),
      longest);
  const auto tic = [](double x) {
    return fmt::format("{} {}", cli::gnuplot_tic(fmt::format("{:.4g}", x)),
                       cli::number_text(x));
  };
  const double high =
      classes.low + classes.width * static_cast<double>(classes.counts.size());
  return data_of(classes, name) +
         fmt::format(
             "set title {}\nset xtics ({}, {})\nset xrange [{}:{}]\n"
             "plot ${} using 1:2:({}) with boxes lt 1 lw 0.5\n",
             cli::gnuplot_text(title), tic(classes.low), tic(high),
             cli::number_text(classes.low), cli::number_text(high), name,
             cli::number_text(classes.width));
}

}  // namespace

std::size_t count_input_pictures(const Study& study) {
  return (study.plan().dispersions.size() + most_panels - 1) / most_panels;
}

std::string input_picture(std::size_t number) {
  return fmt::format("inputs_{}", number + 1);
}

std::string input_histograms(const Study& study, const Journal& journal,
                             std::size_t number) {
  const std::size_t first = number * most_panels;
  const std::size_t end =
      std::min(first + most_panels, study.plan().dispersions.size());
  const std::size_t panels = end - first;
  // Later pictures have the layout of the first one.
  const std::size_t places = number > 0 ? most_panels : panels;
  const std::size_t columns = places == 1 ? 1 : places <= 4 ? 2 : 3;
  std::string script = fmt::format(
      "unset key\nunset ytics\nunset grid\nset xtics font ',13' nomirror "
      "scale 0.4 offset 0,0.3\nset tmargin 1.6\nset bmargin 1.8\n"
      "set title font ',13' offset 0,-0.6\nset yrange [0:*]\n"
      "set style fill solid 0.5\nset lmargin 3\nset rmargin 4\n"
      "set multiplot layout {},{} title {}\n",
      (places + columns - 1) / columns, columns,
      cli::gnuplot_text(fmt::format("Inputs drawn in {} runs", study.runs())));
  for (std::size_t i = first; i < end; ++i) {
    script += panel(study, journal, i);
  }
  return script + "unset multiplot\n";
}

}  // namespace study
