#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "multibody/dynamics.hpp"

/// Cases in the format of data/reference/multibody (its README.md): one
/// instant of a carrier with loads, as JSON.
namespace multibody {

/// One instant: bodies, joints, state and what acts.
struct Case {
  std::string name;
  System system;
  std::vector<JointMode> modes;
  std::vector<double> state;  ///< StateLayout(system, modes)
  Loading<double> loading;
  Eigen::Vector3d gravity;  ///< inertial axes
};

/// Reads a case. The file's "kind" is "spherical" or "axes" for all loads, or
/// "mixed": then each load has its own "kind", one of "spherical", "axis",
/// "held" (a joint that does not turn, given like a spherical one) and "free".
/// Forces that are left out are zero; velocities and rotations that are given
/// twice have to agree to 1e-6.
/// @throws contact::Error "FILE: key: what is wrong, what is allowed"
Case read_case(const std::string& file);

/// Accelerations and reactions of the case, with the keys and in the frames
/// of the format's "expected".
nlohmann::ordered_json evaluate(const Case& c);

}  // namespace multibody
