#include "libcontact/files/key_schema.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/base/text.hpp"
#include "libcontact/files/key_units.hpp"
#include "libcontact/files/stranger.hpp"

namespace contact {
namespace {

using detail::message;
using Texts = std::map<std::string, std::string>;  // without doubles, sorted

std::string joined(const Texts& all) {
  std::string text;
  for (const auto& [name, value] : all) {
    text += message("{}\"{}\": {}", text.empty() ? "" : ",\n", name, value);
  }
  return text;
}

// Some texts with commas between.
std::string list(const std::vector<std::string>& all) {
  std::string text;
  for (const std::string& each : all) {
    text += (text.empty() ? "" : ", ") + each;
  }
  return text;
}

const Unit& unit_of(const std::string& spelling, const KnownKey& key) {
  return *detail::unit_in(spelling, key.key, key.dimension);
}

// Limits of numbers as JSON's keywords, which hold for nothing but numbers. The
// digits beyond twelve are the rounding of a unit's factor.
Texts limits(const Interval& range, const Unit& unit) {
  Texts all;
  const auto add = [&](const char* name, double limit) {
    if (std::abs(limit) == Interval::largest) return;
    all[name] = message("{:.12g}", unit.from_si(limit));
  };
  add(range.low_excluded ? "exclusiveMinimum" : "minimum", range.low);
  if (range.or_infinity) return all;
  add(range.high_excluded ? "exclusiveMaximum" : "maximum", range.high);
  return all;
}

// What is allowed, in a unit: of a number, of an array and of its rows.
Texts rules_of(const KnownKey& key, const Unit& unit) {
  const AllowedValues& allowed = key.allowed;
  if (allowed.integers) {
    return {{"type", "\"integer\""},
            {"minimum", message("{}", allowed.integers->first)},
            {"maximum", message("{}", allowed.integers->second)}};
  }
  if (!allowed.words.empty()) {
    std::vector<std::string> words;
    for (const std::string& word : allowed.words) {
      words.push_back('"' + word + '"');
    }
    const std::string one = message("[{}]", list(words));
    if (key.inside.empty()) return {{"enum", one}};
    return {{"if", "{\"type\": \"string\"}"},
            {"then", message("{{\"enum\": {}}}", one)}};
  }
  if (!allowed.numbers) return {};
  Texts all = limits(*allowed.numbers, unit);
  for (int depth = 0; depth < 2 && !all.empty(); ++depth) {
    Texts outer = limits(*allowed.numbers, unit);
    outer["items"] = message("{{{}}}", joined(all));
    all = std::move(outer);
  }
  all["type"] = "[\"number\", \"array\"]";
  return all;
}

// A key stands once, in one of its units.
std::string two_spellings(const KnownKeys& keys) {
  std::vector<std::string> pairs;
  for (const KnownKey& key : keys) {
    const auto names = detail::spellings(key.key, key.dimension);
    for (std::size_t i = 0; i < names.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        pairs.push_back(
            message("{{\"required\": [\"{}\", \"{}\"]}}", names[j], names[i]));
      }
    }
  }
  return pairs.empty() ? "{}"
                       : message("{{\"type\": \"object\", \"anyOf\": [{}]}}",
                                 list(pairs));
}

// The keys that a table of one kind does not have, and what the others of that
// kind may be.
std::string not_of_kind(const KnownKeys& keys, std::string_view kind) {
  Texts none;
  const auto set = [&](const KnownKey& key, bool fits) {
    for (const auto& name : detail::spellings(key.key, key.dimension)) {
      const Texts rules = rules_of(key, unit_of(name, key));
      if (!fits) {
        none[name] = "false";
      } else if (key.kinds.empty() || rules.empty()) {
        none.erase(name);
      } else {
        none[name] = message("{{{}}}", joined(rules));
      }
    }
  };
  const auto fits = [kind](const KnownKey& key) {
    return key.kinds.empty() || detail::has_word(key.kinds, kind);
  };
  for (const KnownKey& key : keys) {
    if (!fits(key)) set(key, false);
  }
  // Keys of several kinds are there once for each.
  for (const KnownKey& key : keys) {
    if (fits(key)) set(key, true);
  }
  return message(
      "{{\"if\": {{\"properties\": {{\"kind\": {{\"const\": \"{}\"}}}}, "
      "\"required\": [\"kind\"]}}, \"then\": {{\"properties\": {{{}}}}}}}",
      kind, joined(none));
}

// Conditions between the keys of a table.
void add_rules(const KnownKeys& keys, Texts& to) {
  std::set<std::string> kinds;
  for (const KnownKey& key : keys) {
    std::string_view words = key.kinds;
    while (!words.empty()) {
      const std::size_t end = std::min(words.find(' '), words.size());
      kinds.emplace(words.substr(0, end));
      words.remove_prefix(std::min(end + 1, words.size()));
    }
  }
  std::vector<std::string> rules;
  for (const std::string& kind : kinds) {
    if (!kind.empty()) rules.push_back(not_of_kind(keys, kind));
  }
  const std::string twice = two_spellings(keys);
  if (twice != "{}") rules.push_back(message("{{\"not\": {}}}", twice));
  if (!rules.empty()) to["allOf"] = message("[{}]", list(rules));
}

// All kinds whose tables have a key: it may be listed for each on its own.
std::string kinds_of(const KnownKeys& keys, std::string_view name) {
  std::string all;
  for (const KnownKey& key : keys) {
    if (key.key != name) continue;
    if (!all.empty()) all += ' ';
    all += key.kinds;
  }
  return all;
}

// "properties" of a table at a place, a JSON pointer.
std::string properties(const KnownKeys& keys, const std::string& place) {
  Texts all;
  for (const KnownKey& key : keys) {
    for (const std::string& name : detail::spellings(key.key, key.dimension)) {
      const Unit& unit = unit_of(name, key);
      Texts about;
      if (key.kinds.empty()) {
        about = rules_of(key, unit);
      } else {
        about["$comment"] = message("\"of kind {}\"", kinds_of(keys, key.key));
      }
      if (key.dimension != Dimension::number) {
        about["type"] = "[\"number\", \"array\"]";
        about["description"] = message("\"in {}\"", unit_symbol(unit.ending));
      }
      if (!key.inside.empty()) {
        const std::string here = place + "/properties/" + name;
        about["type"] = "[\"object\", \"array\", \"string\"]";
        about["items"] = message("{{\"$ref\": \"{}\"}}", here);
        about["additionalProperties"] = "false";
        about["properties"] = properties(key.inside, here);
        add_rules(key.inside, about);
      }
      all[name] = message("{{{}}}", joined(about));
    }
  }
  return message("{{{}}}", joined(all));
}

}  // namespace

std::string schema_text(const KnownKeys& keys) {
  Texts all = {{"$schema", "\"http://json-schema.org/draft-07/schema#\""},
               {"type", "\"object\""},
               {"additionalProperties", "false"},
               {"properties", properties(keys, "#")}};
  add_rules(keys, all);
  return message("{{{}}}", joined(all));
}

}  // namespace contact
