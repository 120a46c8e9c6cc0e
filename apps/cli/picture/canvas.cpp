#include "cli/picture/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cli/gnuplot.hpp"
#include "cli/picture/text_size.hpp"

namespace cli {
namespace {

constexpr double margin = canvas_margin;
constexpr double sample = 2.2;      // length of a legend's line
constexpr double sample_gap = 0.5;  // gap between it and its text
constexpr double column_gap = 1.2;

double width_of(const std::vector<LegendEntry>& legend) {
  double widest = 0;
  for (const LegendEntry& entry : legend) {
    widest = std::max(widest, text_width(entry.label));
  }
  return sample + sample_gap + widest;
}

// Spreads labels so that they are at least a line apart within the room and as
// near as possible to their wished heights: touching labels are centred on the
// mean of their wishes.
std::vector<double> apart(const std::vector<double>& sorted, const Box& room) {
  struct Block {
    double top;  // mean of its lines' wishes for its first line
    double lines;
  };
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    blocks.push_back({sorted[i] - static_cast<double>(i) * line_step, 1});
    while (blocks.size() > 1 && blocks.back().top < blocks.end()[-2].top) {
      const Block last = blocks.back();
      blocks.pop_back();
      Block& to = blocks.back();
      to.top =
          (to.top * to.lines + last.top * last.lines) / (to.lines + last.lines);
      to.lines += last.lines;
    }
  }
  const double low = room.top + line_step / 2;
  const double high =
      std::max(low, room.bottom -
                        (static_cast<double>(sorted.size()) - 0.5) * line_step);
  std::vector<double> heights;
  for (const Block& block : blocks) {
    for (double n = 0; n < block.lines; ++n) {
      heights.push_back(std::clamp(block.top, low, high) +
                        static_cast<double>(heights.size()) * line_step);
    }
  }
  return heights;
}

}  // namespace

Canvas::Canvas(std::string_view title, const std::vector<LegendEntry>& legend,
               std::optional<double> height)
    : room_{margin, canvas_width - margin, margin, canvas_height - margin} {
  std::vector<LegendEntry> named = legend;
  std::erase_if(named, [](const LegendEntry& e) { return e.label.empty(); });
  const double width = width_of(named);
  constexpr double most_beside = 0.34;  // share of the width
  const bool below =
      !named.empty() &&
      (width > most_beside * canvas_width ||
       static_cast<double>(named.size()) * line_step > 0.8 * canvas_height);
  const auto columns = static_cast<std::size_t>(std::max(
      1., std::floor((room_.width() + column_gap) / (width + column_gap))));
  const std::size_t rows = (named.size() + columns - 1) / columns;
  const double legend_height = static_cast<double>(rows) * line_step + margin;
  std::vector<std::string> titles;
  if (!title.empty()) titles = wrapped(title, room_.width());
  const double title_height =
      titles.empty() ? 0
                     : static_cast<double>(titles.size()) * line_step + margin;
  if (height) room_.bottom = room_.top + title_height + *height;
  // Positions are final only with the height of the whole canvas.
  stretch_ =
      (room_.bottom + (below ? legend_height : 0) + margin) / canvas_height;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    script_ +=
        text((room_.left + room_.right) / 2,
             room_.top + (static_cast<double>(i) + 0.5) * line_step, titles[i]);
  }
  room_.top += title_height;
  if (below) {
    for (std::size_t i = 0; i < named.size(); ++i) {
      script_ += entry(
          room_.left + static_cast<double>(i / rows) * (width + column_gap),
          room_.bottom + margin +
              (static_cast<double>(i % rows) + 0.5) * line_step,
          named[i]);
    }
  } else if (!named.empty()) {
    room_.right -= width + 2 * margin;
    beside_ = std::move(named);
  }
}

std::string Canvas::script(std::vector<double> heights) const {
  heights.resize(beside_.size(), (room_.top + room_.bottom) / 2);
  std::vector<std::size_t> order(heights.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return heights[i]; });
  std::ranges::sort(heights);
  heights = apart(heights, room_);
  std::string script = script_;
  for (std::size_t k = 0; k < order.size(); ++k) {
    script += entry(room_.right + 2 * margin, heights[k], beside_[order[k]]);
  }
  return script;
}

std::string Canvas::at(double x, double y) const {
  return fmt::format("{:.5f},{:.5f}", x / canvas_width,
                     1 - y / (stretch_ * canvas_height));
}

std::string Canvas::text(double x, double y, std::string_view text,
                         Anchor anchor) const {
  constexpr std::string_view anchors[] = {"left", "center", "right"};
  return fmt::format("set label {} at screen {} {} front\n", gnuplot_text(text),
                     at(x, y), anchors[static_cast<int>(anchor)]);
}

double Canvas::upward_width(double room, std::string_view text) {
  return line_step * static_cast<double>(wrapped(text, room).size());
}

std::string Canvas::upward(double x, const Box& beside,
                           std::string_view text) const {
  const auto lines = wrapped(text, beside.height());
  std::string script;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    // The canvas leaves room above the highest plot and below the lowest one.
    const double half = text_width(lines[i]) / 2;
    const double middle = std::clamp(
        (beside.top + beside.bottom) / 2, margin + half,
        std::max(margin + half, stretch_ * canvas_height - margin - half));
    script += fmt::format(
        "set label {} at screen {} center rotate by 90 front\n",
        gnuplot_text(lines[i]),
        at(x - line_step * static_cast<double>(lines.size() - 1 - i), middle));
  }
  return script;
}

double Canvas::above_height(const Box& plot, std::string_view text) {
  return line_step * static_cast<double>(wrapped(text, plot.width()).size());
}

std::string Canvas::above(const Box& plot, std::string_view text) const {
  std::string script;
  double y = plot.top - above_height(plot, text) + line_step / 2;
  for (const std::string& line : wrapped(text, plot.width())) {
    script += this->text((plot.left + plot.right) / 2, y, line);
    y += line_step;
  }
  return script;
}

std::string Canvas::colour_box(const Box& box) const {
  return fmt::format(
      "set colorbox user origin screen {} size screen {:.5f},{:.5f}\n",
      at(box.left, box.bottom), box.width() / canvas_width,
      box.height() / (stretch_ * canvas_height));
}

std::string Canvas::margins(const Box& plot) const {
  const double height = stretch_ * canvas_height;
  return fmt::format(
      "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
      "set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n",
      plot.left / canvas_width, plot.right / canvas_width,
      1 - plot.top / height, 1 - plot.bottom / height);
}

std::string Canvas::entry(double x, double y, const LegendEntry& of) const {
  std::string script;
  if (!of.line.empty()) {
    script += fmt::format("set arrow from screen {} to screen {} nohead {}\n",
                          at(x, y), at(x + sample, y), of.line);
  }
  if (!of.point.empty()) {
    script += fmt::format("set label '' at screen {} front point {}\n",
                          at(x + sample / 2, y), of.point);
  }
  return script + text(x + sample + sample_gap, y, of.label, Anchor::left);
}

}  // namespace cli
