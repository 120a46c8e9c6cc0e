#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cli {

/// A shipped folder of data/, and the term for its files.
enum class Shipped { joints, materials, backings };

/// The names of its files without their endings, sorted; none where the
/// programs are neither in their tree nor installed with it.
std::vector<std::string> shipped_names(Shipped kind);

/// The file of such a name, in the folder data of the tree or of the
/// installation that the program is from; `name` itself if there is none or it
/// is a file's already, with an ending or a slash.
std::string shipped_file(Shipped kind, const std::string& name);

/// `: did you mean "steel_bronze"?` for a name that is none, among the shipped
/// ones and other words; "" if nothing is near.
std::string shipped_hint(Shipped kind, std::string_view name,
                         std::vector<std::string> words = {});

/// Throws contact::Error if a file that cannot be read as `wanted` ("a case
/// file") is a joint's: "FILE is a joint file; PROGRAM takes WANTED".
void refuse_joint_file(std::string_view program, const std::string& file,
                       std::string_view wanted);

}  // namespace cli
