#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace hinge_fmu {

/// This machine's platform name in an FMU of the given FMI version.
std::string platform(int version);

/// A library of libcontact installed with the program.
/// @throws contact::Error if it is missing
std::filesystem::path shared_object(const std::string& name);

/// Libraries that a shared object loads, as names and paths. The C and C++
/// runtime, which every Linux has, and the runtime of sanitizers are left out.
/// @throws contact::Error if one is missing
std::map<std::string, std::filesystem::path> carried_libraries(
    const std::filesystem::path& object);

}  // namespace hinge_fmu
