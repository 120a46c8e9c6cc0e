#pragma once

#include <string>

#include "separation/case/case.hpp"

namespace contact_python {

/// A case from the text of a case file.
struct FileCase {
  separation::Case of;
  std::string toml;
};

}  // namespace contact_python
