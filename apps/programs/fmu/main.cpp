// hinge-fmu: a joint or a case as an FMU.
#include "cli/program.hpp"
#include "cli/stream/standard_streams.hpp"
#include "help/help.hpp"
#include "programs/fmu/run.hpp"

int main(int argc, char** argv) {
  cli::Program program("A joint or a case as an FMU, for simulators",
                       "hinge-fmu");
  hinge_fmu::Options o;
  program.add("FMU", {{"FILE.toml", &o.file, "", "joint file or case file", "",
                       "", true},
                      {"--fmi", cli::count("--fmi", o.version, 2, 3), "N",
                       "version of FMI: 2 (default) or 3"},
                      {"--output", &o.output, "FILE",
                       "FMU to write; default: FILE.fmu in this folder"},
                      {"--quiet", &cli::quiet, "", "leave notes out"}});
  return program.run(argc, argv, help, [&] { return hinge_fmu::run(o); });
}
