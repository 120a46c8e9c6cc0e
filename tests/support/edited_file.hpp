#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace contact::test {

/// Files and the messages about them.
inline std::filesystem::path messages_folder() {
  return CONTACT_DATA_DIR "/../tests/messages";
}

inline std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::ifstream stream(path);
  EXPECT_TRUE(stream) << path;
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// A file with replaced lines; @DATA@ in it stands for the folder data.
class EditedFile {
 public:
  EditedFile() = default;
  /// @param name  of a file in tests/messages
  explicit EditedFile(const std::string& name)
      : lines_(lines_of(messages_folder() / name)) {}

  /// Replaces line "4", or line 4 and all below it, "4...", by `text`; appends
  /// it at the end, "+", or below the text of the last call, "".
  EditedFile& edit(const std::string& where, const std::string& text) {
    if (where.empty()) {
      lines_.at(last_) += '\n' + text;
      return *this;
    }
    last_ = where == "+" ? lines_.size() : std::stoul(where) - 1;
    if (where == "+") lines_.emplace_back();
    lines_.at(last_) = text;
    if (where.ends_with("...")) lines_.resize(last_ + 1);
    return *this;
  }

  std::string text() const {
    std::string text;
    for (const std::string& line : lines_) text += line + '\n';
    const std::string data = "@DATA@";
    for (auto at = text.find(data); at != text.npos; at = text.find(data)) {
      text.replace(at, data.size(), CONTACT_DATA_DIR);
    }
    return text;
  }

 private:
  std::vector<std::string> lines_;
  std::size_t last_ = 0;
};

}  // namespace contact::test
