// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace contact {

/// A key of a file that is given another value: as `wall.layer[1].thickness_mm`
/// = `8`. It takes the place of the same key in another unit. A table among
/// several is called by its number or by its `name`, as in
/// `body[slosh].mass_t`, a number of an array by its place: `com_m[1]`. What a
/// table leaves to a file that it names is a key of the table. The value
/// `*1.05` multiplies what is there: a number, or all numbers of an array.
struct KeySetting {
  std::string key;    ///< with the tables that it stands in
  std::string value;  ///< as in TOML; a text may stand without quotes
  /// Source of the setting, such as an option: "--radius -50mm". Messages name
  /// it, if there is one, in place of file, key and value.
  std::string origin = {};
};
using KeySettings = std::vector<KeySetting>;

}  // namespace contact
