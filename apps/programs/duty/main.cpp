// hinge-duty: heat, p v and wear of one ball or pin joint on a duty cycle.
#include <array>

#include "cli/program.hpp"
#include "help/help.hpp"
#include "programs/duty/run.hpp"

namespace {

using contact::JointBody;
using hinge_duty::Options;

constexpr std::array<cli::Choice<JointBody>, 2> bodies = {
    {{"body", JointBody::body}, {"carrier", JointBody::carrier}}};

void add_cycle(cli::Program& program, Options& o) {
  program.add(
      "Cycle",
      {{"--cycle", &o.cycle, "FILE",
        "CSV file, - for standard input; or table of OpenSim, .sto or .mot", "",
        "", true},
       {"--period", &o.period, "TIME", "period of the cycle, s"},
       {"--euler", &o.euler, "SEQUENCE", "axes of the angles, such as zxy"},
       {"--force-columns", &o.force_columns, "NAMES",
        "columns of R_x, R_y, R_z, N, of .sto, .mot, with commas"},
       {"--angle-columns", &o.angle_columns, "NAMES",
        "columns of the angles of .sto, .mot, as inDegrees says"},
       {"--force-on", cli::word("--force-on", o.force_on, bodies), "BODY",
        "body on which the forces act: body (default) or carrier"},
       {"--force-in", cli::word("--force-in", o.force_in, bodies), "BODY",
        "axes of the forces: body or carrier (default)"}});
}

void add_wear(cli::Program& program, Options& o) {
  const auto any = [](const char* flag, auto& to, const char* unit,
                      double least = 0, double most = 1e30) {
    return cli::number(flag, to, contact::Dimension::number,
                       {least, most, unit});
  };
  program.add(
      "Wear",
      {{"--wear-seat", any("--wear-seat", o.wear_seat, "mm^3/(N m)"), "NUMBER",
        "k of the seat or hole, mm^3/(N m)"},
       {"--wear-inner", any("--wear-inner", o.wear_inner, "mm^3/(N m)"),
        "NUMBER", "k of the ball or pin, mm^3/(N m)"},
       {"--measured-volume",
        any("--measured-volume", o.measured_volume, "mm^3"), "NUMBER",
        "measured wear volume of one body, mm^3, to compute k",
        "--measured-cycles"},
       {"--measured-error", any("--measured-error", o.measured_error, "mm^3"),
        "NUMBER", "standard error of the volume, mm^3", "--measured-volume"},
       {"--measured-cycles",
        any("--measured-cycles", o.measured_cycles, "", 1, 1e15), "N",
        "number of cycles that caused this volume", "--measured-volume"},
       {"--map", &o.map, "FILE", "CSV file of the wear of both bodies"},
       {"--map-plot", &o.map_plot, "FILE",
        "picture of the wear of both bodies: .svg, .png or .pdf"},
       {"--grid", cli::count("--grid", o.grid, 10, 1'000'000), "N",
        "points of each body; default 2000",
        "--map, --map-plot, --wear-seat or --wear-inner"},
       {"--cycles", any("--cycles", o.cycles, "", 0, 1e15), "N",
        "number of cycles in which wear changes the contact",
        "--wear-seat or --wear-inner"},
       {"--blocks", &o.blocks, "FILE",
        "CSV file of the joint after each block of cycles", "--cycles"},
       {"--worn", &o.worn, "FILE", "worn seat or hole to start from",
        "--cycles"},
       {"--worn-out", &o.worn_out, "FILE",
        "file for the worn seat or hole after N cycles, for --worn",
        "--cycles"}});
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program program("Heat, p v and wear of a joint on a duty cycle",
                       "hinge-duty");
  Options options;
  add_joint_options(program, options.joint);
  add_cycle(program, options);
  add_wear(program, options);
  add_friction_options(program, options.friction);
  add_law_options(program, options.joint, cli::Laws::one, cli::Laws::one);
  program.add_output(options.output);
  program.add(
      "Output",
      {{"--states", &options.states, "FILE",
        "CSV file of the states at the rows of the cycle"},
       {"--without-seat", &options.without_seat, "",
        "let the contact of a ball extend beyond the rims of its [seat]", "",
        "--seat-table"},
       {"--seat-table", &options.seat_table, "FILE",
        "file for the table of contacts at rims: read if it exists, else "
        "computed and written"}});
  add_tilt_options(program, options.tilt, "", "");
  program.add("Tilt",
              {{"--along", &options.along, "FILE",
                "CSV file of p v at places along a finite-length pin"},
               {"--along-map", &options.along_map, "FILE",
                "CSV file of its wear over length and angle on both bodies"}});
  add_fileless_joint_options(program, options.joint);
  return program.run(argc, argv, help,
                     [&] { return hinge_duty::run(options); });
}
