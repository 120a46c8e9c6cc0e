#include "libcontact/files/key_schema.hpp"

#include <map>

#include "libcontact/base/text.hpp"
#include "libcontact/files/key_units.hpp"

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

// "properties" of a table at a place, a JSON pointer.
std::string properties(const KnownKeys& keys, const std::string& place) {
  Texts all;
  for (const KnownKey& key : keys) {
    const bool number = key.dimension != Dimension::number;
    for (const std::string& name : detail::spellings(key.key, key.dimension)) {
      Texts about;
      if (!key.kinds.empty()) {
        about["$comment"] = message("\"of kind {}\"", key.kinds);
      }
      if (const Unit* unit = detail::unit_in(name, key.key, key.dimension);
          number && unit != nullptr) {
        about["type"] = "[\"number\", \"array\"]";
        about["description"] = message("\"in {}\"", unit_symbol(unit->ending));
      }
      if (!key.inside.empty()) {
        const std::string here = place + "/properties/" + name;
        about["type"] = "[\"object\", \"array\", \"string\"]";
        about["items"] = message("{{\"$ref\": \"{}\"}}", here);
        about["additionalProperties"] = "false";
        about["properties"] = properties(key.inside, here);
      }
      all[name] = message("{{{}}}", joined(about));
    }
  }
  return message("{{{}}}", joined(all));
}

}  // namespace

std::string schema_text(const KnownKeys& keys) {
  return message(
      "{{\"$schema\": \"http://json-schema.org/draft-07/schema#\",\n\"type\": "
      "\"object\",\n\"additionalProperties\": false,\n\"properties\": {}}}",
      properties(keys, "#"));
}

}  // namespace contact
