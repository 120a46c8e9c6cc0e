// Files of points as duty cycles: answered line by line, summarised, drawn.
#include <gtest/gtest.h>

#include <string>

#include "support/program.hpp"

namespace {

using contact::test::ProgramFolder;
using contact::test::ProgramResult;

const std::string joint =
    "hinge-joint --joint data/joints/paper_example_1.toml ";

// What is at the other end of two pipes writes a line and waits for the
// answer; the header comes with the first line, as from a program that writes
// whole buffers. 20 s are long against the time of a row.
TEST(Points, AreAnsweredLineByLine) {
  const ProgramFolder folder;
  folder.write("dialogue.sh",
               "coproc P { $1 --points -; }\n"
               "ask() { printf \"$1\" >&${P[1]}; }\n"
               "hear() { read -t 20 -r line <&${P[0]} && echo \"$line\"; }\n"
               "ask \"$2\\n1$3\\n\" && hear && hear && ask \"2$3\\n\" && hear "
               "&& ask \"3$3\" && ask \"\\n4$3\\n\" && hear && hear\n"
               "status=$?\nkill $P_PID 2>/dev/null\nexit $status\n");
  const std::string header_and_line[2][3] = {
      {joint + "--jobs 1", "R_N,b_deg,name", "e5,90,R"},
      {"hinge-table --jobs 2", "theta0_deg,alpha_deg,name", "0,20,x"}};
  for (const auto& [program, header, line] : header_and_line) {
    std::string points = header + '\n';
    for (const char* row : {"1", "2", "3", "4"}) points += row + line + '\n';
    folder.write("points.csv", points);
    const ProgramResult dialogue =
        folder.run("bash dialogue.sh '" + program + "' " + header + ' ' + line);
    EXPECT_EQ(dialogue.status, 0) << dialogue.err;
    EXPECT_EQ(dialogue.out, folder.run(program + " --points points.csv").out);
  }
}

}  // namespace
