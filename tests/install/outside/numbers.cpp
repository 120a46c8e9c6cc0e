// Every number of a solution, with its symbol, meaning and unit.
#include <cstdio>
#include <libcontact/contact.hpp>

int main() {
  using namespace contact;
  const Joint hip({.geometry = JointGeometry::ball(0.014, 100e-6),  // m
                   .inner = Material{230e9, 0.3},                   // Pa, 1
                   .outer = Material{1e9, 0.4},
                   .friction = FrictionLaw(0.0587)});
  const JointSolution s =
      hip.solve({.reaction = {0, 0, 2000}, .angular_velocity = {1, 0, 0}});
  for (const auto& column : columns_of(solution_quantities())) {
    std::printf("%-24s %12g  %s\n", column.name.c_str(), column(s),
                std::string(column.meaning).c_str());
  }
}
