#include "cli/joint/key_settings.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "cli/number.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "cli/sweep.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"

namespace cli {
namespace {

constexpr const char* option = "--set";
// Each joint may need laws of its own, which take some milliseconds.
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
  using contact::detail::infinity;
  const Sweep sweep(option, text, {-infinity, infinity, ""});
  for (std::size_t i = 0; i < std::min(sweep.size(), most_joints + 1); ++i) {
    values.push_back(number_text(sweep[i]));
  }
  return values;
}

// Takes the text unchanged; the key must not occur before.
contact::KeySetting setting_of(const std::string& text, const char* rule,
                               const contact::KeySettings& earlier) {
  const auto equals = text.find('=');
  if (equals == 0 || equals == text.npos) refuse(option, text, rule);
  std::string key = text.substr(0, equals);
  if (std::ranges::count(earlier, key, &contact::KeySetting::key) > 0) {
    throw contact::Error(contact::detail::duplicate(option, key));
  }
  return {std::move(key), text.substr(equals + 1)};
}

}  // namespace

contact::KeySettings single_settings(const std::vector<std::string>& texts) {
  contact::KeySettings all;
  for (const std::string& text : texts) {
    all.push_back(setting_of(text, "KEY=VALUE", all));
  }
  return all;
}

std::vector<contact::KeySettings> key_settings(
    const std::vector<std::string>& texts) {
  std::vector<contact::KeySettings> all(1);
  for (const std::string& text : texts) {
    const auto asked =
        setting_of(text, "KEY=VALUE or KEY=VALUE,VALUE,...", all[0]);
    const auto values = values_of(asked.value);
    if (all.size() * values.size() > most_joints) {
      refuse(option, text, "at most 10000 joints in all");
    }
    std::vector<contact::KeySettings> longer;
    for (const contact::KeySettings& settings : all) {
      for (const std::string& value : values) {
        longer.push_back(settings);
        longer.back().push_back({asked.key, value});
      }
    }
    all = std::move(longer);
  }
  return all;
}

}  // namespace cli
