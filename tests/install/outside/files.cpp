// A joint from a file.
#include <cstdio>
#include <libcontact/files.hpp>

int main(int, char** arguments) {
  const contact::JointSpec joint = contact::read_joint(arguments[1]);
  const double peak = joint.make_pressure_law()->peak(1);
  std::printf("peak pressure at 1 rad: %.4f\n", peak);
  return peak > 0 ? 0 : 1;
}
