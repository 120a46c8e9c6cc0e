#include "libcontact/files/joint_form.hpp"

#include <utility>

#include "libcontact/base/text.hpp"
#include "libcontact/files/joint_tables.hpp"

namespace contact {
namespace {

// Any number will do: it is given another one before it is read.
TomlForm form_of(const std::string& text, const std::string& source,
                 const std::filesystem::path& folder,
                 const KeySettings& settings,
                 const std::vector<std::string>& keys) {
  KeySettings all = settings;
  KeySettings own;
  for (const std::string& key : keys) {
    own.push_back({key, "1"});
    all.push_back(own.back());
  }
  return {TomlFiles().text(text, source, joint_keys, folder, all), own};
}

}  // namespace

JointForm::JointForm(std::string text, std::string source,
                     std::filesystem::path folder, KeySettings settings,
                     std::vector<std::string> keys)
    : text_(std::move(text)),
      source_(std::move(source)),
      folder_(std::move(folder)),
      settings_(std::move(settings)),
      keys_(std::move(keys)),
      form_(form_of(text_, source_, folder_, settings_, keys_)) {}

KeySettings JointForm::settings_of(std::span<const double> numbers) const {
  KeySettings all = settings_;
  for (std::size_t k = 0; k < keys_.size(); ++k)
    all.push_back({keys_[k], detail::message("{}", numbers[k])});
  return all;
}

JointSpec JointForm::with(std::span<const double> numbers) {
  try {
    for (std::size_t k = 0; k < keys_.size(); ++k) form_.set(k, numbers[k]);
    return joint_of_file(form_.table());
  } catch (const Error&) {
    // Messages of settings name them.
    return parse_joint(text_, source_, settings_of(numbers), folder_);
  }
}

}  // namespace contact
