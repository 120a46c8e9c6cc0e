#include "cli/joint/key_settings.hpp"

#include <algorithm>
#include <limits>
#include <string_view>

#include "cli/number.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "cli/sweep.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace cli {
namespace {

constexpr const char* option = "--set";
// Each may have laws of its own, which take some milliseconds.
constexpr std::size_t most_joints = 10'000;

bool is_number(std::string_view part) {
  return parse_number(part).has_value() ||
         (part.starts_with("log") && parse_number(part.substr(3)));
}

std::vector<std::string> values_of(std::string_view text) {
  const auto parts = split(text, ",");
  std::vector<std::string> values;
  if (!std::ranges::all_of(split(text, ",:"), is_number)) {
    return {parts.begin(), parts.end()};
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Sweep sweep(option, text, {-infinity, infinity, ""});
  for (std::size_t i = 0; i < std::min(sweep.size(), most_joints + 1); ++i) {
    values.push_back(number_text(sweep[i]));
  }
  return values;
}

}  // namespace

std::vector<contact::KeySettings> key_settings(
    const std::vector<std::string>& texts) {
  std::vector<contact::KeySettings> all(1);
  for (const std::string& text : texts) {
    const auto equals = text.find('=');
    if (equals == 0 || equals == text.npos) {
      refuse(option, text, "KEY=VALUE or KEY=VALUE,VALUE,...");
    }
    const std::string key = text.substr(0, equals);
    for (const contact::KeySetting& other : all[0]) {
      if (other.key != key) continue;
      throw contact::Error(contact::detail::duplicate(option, key));
    }
    const auto values = values_of(std::string_view(text).substr(equals + 1));
    if (all.size() * values.size() > most_joints) {
      refuse(option, text, "at most 10000 joints in all");
    }
    std::vector<contact::KeySettings> longer;
    for (const contact::KeySettings& settings : all) {
      for (const std::string& value : values) {
        longer.push_back(settings);
        longer.back().push_back({key, value});
      }
    }
    all = std::move(longer);
  }
  return all;
}

}  // namespace cli
