#include "cli/picture/text_size.hpp"

#include <algorithm>
#include <array>

namespace cli {
namespace {

// Widths of the characters from the blank to the tilde, in thousandths.
constexpr std::array<int, 95> ascii = {
    318, 401, 460, 838, 636,  950, 780, 275, 390, 390, 500, 838, 318, 361,
    318, 337, 636, 636, 636,  636, 636, 636, 636, 636, 636, 636, 337, 337,
    838, 838, 838, 531, 1000, 684, 686, 698, 770, 632, 575, 775, 752, 295,
    295, 656, 557, 863, 748,  787, 603, 787, 695, 635, 611, 732, 684, 989,
    685, 611, 685, 390, 337,  390, 838, 500, 500, 613, 635, 550, 635, 615,
    352, 635, 634, 278, 278,  579, 278, 974, 634, 612, 635, 635, 411, 521,
    392, 634, 592, 818, 592,  592, 525, 636, 337, 636, 838};
// Greek letters and signs of the labels have widths of 0.3 to 0.84; Chinese
// characters (lead byte 0xe3 and above) are squares.
constexpr double other = 0.7;
constexpr double square = 1;

// Breaks the text into lines that fit into the room, after an `end`.
std::vector<std::string> filled(std::string_view text, std::string_view end,
                                double room) {
  std::vector<std::string> lines;
  std::string line;
  while (!text.empty()) {
    const std::size_t at = text.find(end);
    const std::size_t size = at == text.npos ? text.size() : at + end.size();
    const std::string longer = line + std::string(text.substr(0, size));
    if (!line.empty() && text_width(longer) > room) {
      lines.push_back(line.substr(0, line.find_last_not_of(' ') + 1));
      line = text.substr(0, size);
    } else {
      line = longer;
    }
    text.remove_prefix(size);
  }
  lines.push_back(line);
  return lines;
}

}  // namespace

double text_width(std::string_view text) {
  double width = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= ' ' && byte <= '~') {
      width += ascii[byte - ' '] / 1000.;
    } else if (byte >= 0xc0) {  // the first byte of a character
      width += byte >= 0xe3 ? square : other;
    }
  }
  return width;
}

std::vector<std::string> wrapped(std::string_view text, double room) {
  if (text_width(text) <= room) return {std::string(text)};
  std::vector<std::string> lines = filled(text, ", ", room);
  const bool fits = std::ranges::all_of(lines, [room](const std::string& line) {
    return text_width(line) <= room;
  });
  return fits ? lines : filled(text, " ", room);
}

}  // namespace cli
