#include "cli/gnuplot.hpp"

#include <fmt/format.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/mman.h>
#endif

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>

#include "cli/output.hpp"
#include "cli/plot_style.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace cli {
namespace {

// Kinds of pictures: gnuplot's terminal, factor and unit of its size, its other
// options, and the last bytes of a complete picture except line ends. Sizes and
// fonts keep text readable when the picture is shown at a third of its width.
struct Kind {
  std::string_view suffix;
  std::string_view terminal;
  double scale;
  std::string_view unit;
  std::string_view options;
  std::string_view end;

  std::string size(double stretch) const {
    return fmt::format("size {0:.5g}{2},{1:.5g}{2}", scale * picture_width,
                       std::round(picture_height * stretch) * scale, unit);
  }
};
constexpr std::array<Kind, 3> kinds = {{
    {".svg", "svg", 1, "",
     "font 'sans,19' rounded linewidth 1.2 background 'white'", "</svg>"},
    // The chunk that ends a PNG: name and checksum.
    {".png", "pngcairo", 1.5, "", "font 'sans,20' rounded linewidth 1.5",
     "IEND\xae\x42\x60\x82"},
    {".pdf", "pdfcairo", 1. / 120, "in", "font 'sans,14' rounded", "%%EOF"},
}};

const Kind* kind_of(std::string_view file) {
  for (const Kind& kind : kinds) {
    if (file.size() > kind.suffix.size() && file.ends_with(kind.suffix)) {
      return &kind;
    }
  }
  return nullptr;
}

// Runs a command; true if it succeeds. std::system() would ignore SIGINT
// meanwhile.
bool shell(const std::string& command) {
  std::FILE* const pipe = ::popen(command.c_str(), "r");
  return pipe != nullptr && ::pclose(pipe) == 0;
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

// Characters around gnuplot's messages.
constexpr std::string_view gnuplot_blanks = " \t\r\n^";

// A file in memory, which a full disk does not affect; where the system has
// none, a file on disk without a name.
int unnamed_file() {
#ifdef __linux__
  return memfd_create("gnuplot", 0);
#else
  std::FILE* const file = std::tmpfile();
  if (file == nullptr) return -1;
  const int descriptor = dup(fileno(file));
  std::fclose(file);
  return descriptor;
#endif
}

// A file that passes text to or from another program, so that no name given by
// the user is part of its command.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(unnamed_file()) {
    if (descriptor_ < 0) throw contact::Error(std::strerror(errno));
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string path() const { return fmt::format("/dev/fd/{}", descriptor_); }
  void write(std::string_view text) const {
    std::ofstream stream(path(), std::ios::binary);
    if (!(stream << text << std::flush)) {
      throw contact::Error("a file in memory cannot be written");
    }
  }
  std::string text() const {
    std::ifstream stream(path(), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

 private:
  int descriptor_;
};

// Throws contact::Error with gnuplot's last message, without its place in the
// script, if gnuplot fails. Discards gnuplot's warnings.
void run_gnuplot(const MemoryFile& script, const MemoryFile& picture) {
  const std::string command =
      fmt::format("gnuplot {} 2>&1 >{}", script.path(), picture.path());
  std::FILE* const pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) throw contact::Error("gnuplot cannot be run");
  std::string last;
  std::array<char, 4096> line;
  while (std::fgets(line.data(), line.size(), pipe) != nullptr) {
    const std::string_view text =
        contact::detail::trimmed(line.data(), gnuplot_blanks);
    if (!text.empty()) last = text;
  }
  if (::pclose(pipe) == 0) return;
  const std::size_t place = last.find(": ");
  if (last.starts_with('"') && place != std::string::npos) {
    last.erase(0, place + 2);
  }
  throw contact::Error("gnuplot: " + (last.empty() ? "failed" : last));
}

// Throws contact::Error with the reason if there is no picture.
std::string drawn(std::string_view script, std::string_view file,
                  double stretch = 1) {
  const Kind& kind = *kind_of(file);
  const std::string reason = why_not(kind);
  if (!reason.empty()) throw contact::Error(reason);
  const MemoryFile commands;
  commands.write(fmt::format(
      "set encoding utf8\nset terminal {} noenhanced "
      "{} {}\nset output\n{}\n{}",
      kind.terminal, kind.size(stretch), kind.options, plot_style, script));
  const MemoryFile picture;
  run_gnuplot(commands, picture);
  std::string text = picture.text();
  if (!is_whole_picture(text, file)) {
    throw contact::Error("gnuplot left it unfinished");
  }
  return text;
}

}  // namespace

void check_picture_name(std::string_view option, std::string_view file) {
  if (kind_of(file) != nullptr) return;
  refuse(option, file, "a name that ends in .svg, .png, .pdf");
}

bool is_whole_picture(std::string_view picture, std::string_view file) {
  return contact::detail::trimmed(picture, gnuplot_blanks)
      .ends_with(kind_of(file)->end);
}

std::string gnuplot_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : contact::detail::printable(text, text.npos)) {
    constexpr std::string_view special = "\"\\`'";
    quoted += special.find(c) == special.npos
                  ? std::string(1, c)
                  : fmt::format("\\{:03o}", static_cast<unsigned>(c));
  }
  return quoted + '"';
}

std::string gnuplot_tic(std::string_view text) {
  std::string format;
  for (const char c : text) format += c == '%' ? "%%" : std::string(1, c);
  return gnuplot_text(format);
}

std::string draw_script(std::string_view script, const std::string& file,
                        double stretch) {
  try {
    const std::string picture = drawn(script, file, stretch);
    Output output(file);
    output.write(picture);
    output.commit();
  } catch (const contact::Error& error) {
    return "no picture " + file + ": " + error.what();
  }
  return {};
}

std::string svg_of(std::string_view script) {
  return drawn(script, "picture.svg");
}

}  // namespace cli
