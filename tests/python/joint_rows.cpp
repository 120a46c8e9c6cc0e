// Answers of C++ to rows of a joint, for the tests of the Python package:
//   joint_rows JOINT.toml TIMES <ROWS >ANSWERS
// solves all rows (R and Dw, six doubles each) as often and says on standard
// error how many processor seconds the fastest time took.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <vector>

#include "libcontact/files.hpp"
#include "libcontact/joint.hpp"

int main(int, char** arguments) {
  const contact::Joint joint(contact::read_joint(arguments[1]).contact());
  std::vector<contact::Joint::Slip> rows;
  double row[6];
  while (std::fread(row, sizeof(double), 6, stdin) == 6) {
    rows.push_back({{row[0], row[1], row[2]}, {row[3], row[4], row[5]}});
  }
  std::vector<contact::JointSolution> answers;
  std::clock_t fastest = std::numeric_limits<std::clock_t>::max();
  for (int i = 0; i < std::atoi(arguments[2]); ++i) {
    const std::clock_t begin = std::clock();
    answers = std::vector<contact::JointSolution>();
    answers.reserve(rows.size());
    for (const auto& slip : rows) answers.push_back(joint.solve(slip));
    fastest = std::min(fastest, std::clock() - begin);
  }
  std::fprintf(stderr, "%.9g\n", double(fastest) / CLOCKS_PER_SEC);
  for (const auto& s : answers) {
    const double numbers[] = {
        s.normal_force,       s.half_angle,         s.friction_moment[0],
        s.friction_moment[1], s.friction_moment[2], s.normal[0],
        s.normal[1],          s.normal[2],          s.power,
        s.slip_axis_angle(),  s.peak_pressure,      s.residual};
    std::fwrite(numbers, sizeof(numbers), 1, stdout);
  }
}
