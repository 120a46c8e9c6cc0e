#pragma once

#include <array>
#include <string>
#include <vector>

namespace contact::test {

using Three = std::array<double, 3>;

/// A sliding state reached by a simulator, and its friction moment, in one
/// frame.
struct DoorRow {
  Three reaction;  ///< N
  Three rate;      ///< Dw, rad/s
  Three axis;      ///< a pin's; 0 for a ball
  Three moment;    ///< N m
};

/// Random states of the simulators whose adapters are built.
std::vector<DoorRow> mujoco_rows(const std::string& file, bool pin, int count);
std::vector<DoorRow> simbody_rows(const std::string& file, bool pin, int count);

}  // namespace contact::test
