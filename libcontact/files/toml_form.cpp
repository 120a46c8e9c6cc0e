#include "libcontact/files/toml_form.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/files/toml_file.hpp"

namespace contact {

TomlForm::TomlForm(TomlTable table, const KeySettings& settings)
    : table_(std::move(table)) {
  auto& places = table_.file_->settings;
  places.erase(places.begin(), places.end() - std::ssize(settings));
  for (std::size_t i = 0; i < settings.size(); ++i) {
    keys_.push_back(key_at(places[i], settings[i]));
  }
}

TomlForm::Key TomlForm::key_at(const detail::KeyPlace& place,
                               const KeySetting& setting) {
  if (place.of_file) {
    return &*std::ranges::find(table_.file_->for_files.at(place.table),
                               place.key, &KeySetting::key);
  }
  Numbers numbers{detail::numbers_at(place), setting.value.starts_with('*'),
                  true};
  if (numbers.nodes.empty()) {
    throw Error(detail::needs(detail::setting_text(setting), "a number"));
  }
  for (const Key& other : keys_) {
    const auto* earlier = std::get_if<Numbers>(&other);
    if (earlier == nullptr) continue;
    for (const auto& node : earlier->nodes) {
      if (std::ranges::find(numbers.nodes, node.number,
                            &detail::NumberNode::number) !=
          numbers.nodes.end()) {
        numbers.is_first = false;
      }
    }
  }
  return numbers;
}

const std::string& TomlForm::place(std::size_t key) const {
  return table_.file_->settings[key].text;
}

// To add 0 makes -0 what it is in a file, where it is written as an integer.
void TomlForm::set(std::size_t key, double number) {
  if (auto* const* setting = std::get_if<KeySetting*>(&keys_[key])) {
    const bool is_factor = (*setting)->value.starts_with('*');
    (*setting)->value = detail::message("{}{}", is_factor ? "*" : "", number);
    return;
  }
  const Numbers& numbers = std::get<Numbers>(keys_[key]);
  for (const auto& [node, was] : numbers.nodes) {
    const double there = numbers.is_first ? was : *node;
    *node = (numbers.is_factor ? there * number : number) + 0.0;
  }
}

}  // namespace contact
