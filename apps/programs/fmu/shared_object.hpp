#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace hinge_fmu {

/// Name of this machine in an FMU of a version of FMI.
std::string platform(int version);

/// A library of libcontact that is installed with the program.
/// @throws contact::Error if it is not there
std::filesystem::path shared_object(const std::string& name);

/// Libraries that a shared object loads, but for the C and C++ runtime, which
/// every Linux has, and the runtime of sanitizers: paths by names.
/// @throws contact::Error if one is missing
std::map<std::string, std::filesystem::path> carried_libraries(
    const std::filesystem::path& object);

}  // namespace hinge_fmu
