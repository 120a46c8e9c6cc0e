#include "multibody_oracle/json_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string_view>
#include <vector>

#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace multibody {
namespace {

using contact::detail::printable;
using nlohmann::json;

constexpr std::size_t deepest = 64;

// What the parser of nlohmann::json lets pass, or says without a place.
class Checker : public nlohmann::json_sax<json> {
 public:
  Checker(const std::string& text, const std::string& source)
      : text_(text), source_(source) {}

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(std::int64_t) override { return value(); }
  bool number_unsigned(std::uint64_t) override { return value(); }
  bool number_float(double, const std::string&) override { return value(); }
  bool string(std::string&) override { return value(); }
  bool binary(json::binary_t&) override { return value(); }
  bool start_object(std::size_t) override { return open(false); }
  bool start_array(std::size_t) override { return open(true); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(std::string& name) override {
    open_.back().key = name;
    if (open_.back().keys.insert(name).second) return true;
    throw contact::Error(
        fmt::format("{}: {}: there twice, allowed is once", source_, place()));
  }

  bool parse_error(std::size_t position, const std::string& token,
                   const json::exception& error) override {
    constexpr int out_of_range = 406;
    if (error.id == out_of_range) {
      fail(position - std::min(position, token.size()) + 1,
           fmt::format("{}{}, allowed is a finite number",
                       open_.empty() ? "" : place() + ": ", token));
    }
    if (position > text_.size()) {
      fail(position, "not JSON: ends in the middle");
    }
    fail(position, fmt::format("not JSON: unexpected {}", printable(token)));
  }

 private:
  // An object or array that has begun and not ended.
  struct Open {
    bool is_array;
    std::size_t index;
    std::string key;
    std::set<std::string> keys;
  };

  bool value() {
    if (!open_.empty()) ++open_.back().index;
    return true;
  }
  bool open(bool is_array) {
    if (open_.size() == deepest) {
      throw contact::Error(
          fmt::format("{}: {}: nested deeper than {}, which is allowed",
                      source_, printable(place()), deepest));
    }
    open_.push_back({is_array, 0, {}, {}});
    return true;
  }
  bool close() {
    open_.pop_back();
    return value();
  }

  // Of the value that is being read.
  std::string place() const {
    std::string result;
    for (const Open& part : open_) {
      if (part.is_array) {
        result += fmt::format("[{}]", part.index);
      } else {
        if (!result.empty()) result += '.';
        result += printable(part.key);
      }
    }
    return result;
  }

  // `position` counts bytes from 1.
  [[noreturn]] void fail(std::size_t position, const std::string& message) {
    const std::string_view before = std::string_view(text_).substr(
        0, std::min(position, text_.size() + 1) - 1);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
    throw contact::Error(fmt::format("{}:{}:{}: {}", source_, line,
                                     before.size() - line_begin + 1, message));
  }

  const std::string& text_;
  const std::string& source_;
  std::vector<Open> open_;
};

}  // namespace

json parse_json(const std::string& text, const std::string& source) {
  Checker checker(text, source);
  json::sax_parse(text, &checker);
  return json::parse(text);
}

}  // namespace multibody
