// hinge-duty: heat, p v and wear of one ball or pin joint on a duty cycle.
#include <array>
#include <string>
#include <string_view>

#include "cli/program.hpp"
#include "programs/duty/run.hpp"

namespace {

using contact::JointBody;
using hinge_duty::Options;

constexpr std::array<cli::Choice<JointBody>, 2> bodies = {
    {{"body", JointBody::body}, {"carrier", JointBody::carrier}}};

constexpr std::string_view help = R"(
--cycle FILE.csv has one period of forces and motion, a row for each time:
  time_s             ascending, 4 rows or more; the last row comes before the
                     first one returns, after --period or, where the steps are
                     even, one step. A last row that repeats the first is left
                     out, and its time ends the period
  R_x_N,R_y_N,R_z_N  force on the body in carrier axes; --force-on, --force-in
and one of
  w_x_rad_per_s,w_y_rad_per_s,w_z_rad_per_s
                     angular velocity Dw, body against carrier, carrier axes
  NAME_deg, three columns, with --euler SEQUENCE
                     angles of the body against the carrier in the order of
                     SEQUENCE, its letters the axes, each as the turns before
                     it have left it: zxy, xyz, zyz, ...
  NAME_deg, one column, of a pin
                     its angle; a pin's axis is Z
Periodic cubic splines go through all columns. Other columns are left out.

--cycle FILE.sto or FILE.mot is a table of OpenSim: column time, and those that
--force-columns and --angle-columns name; angles are in rad without a line
inDegrees=yes. Cut it to one period.

Wear is Archard's: depth k times the integral of p v. k has no default. It is
that of the unworn joint. --map writes it for points of equal area on both
bodies, unit vectors in the body's own axes, of a pin the angle beta from X
towards Y: pv_integral_Pa_m (times k: depth), depth_mm, cross_shear (share of
the friction work across its main direction: 0 on a line, 0.5 without one).
--map-plot draws it: balls from outside, above the middle of the wear, areas
equal, circles 30 deg apart, axes of the body; pins over beta.

--measured-volume V with --measured-cycles N finds k: what was weighed, over
the density, is N k pv_integral_J, of seat and inner body alike. k is that of
the unworn joint: --wear-seat k --cycles N says whether the contact widens.

--cycles N wears the seat or hole in, with k of --wear-seat: after blocks of
cycles the contact is widened by the volume that is gone (v, over pi rho^2 eps
or 2 rho eps l), and the pressure p ~ cos theta has a share in its own that grows
with v (worn_share). Half-angles to 1.1 deg while theta0 < 90 deg, peaks to 6 %;
those of a ball much worn are up to 17 % too high. The load is taken to stand
still in the seat: contact_spread_deg says how far the contact wanders, from 0.3
of the half-angle on with a warning, beyond it refused. Nothing is known of
balls that mostly spin, creep, walls that wear through, edges and wear of the
ball or pin. worn_...: after N cycles; --blocks: on the way.

Output: quantity, value, at_time_s, x, y, z (where it is), meaning. With wear
volume_defect says how well the map's sum fits the volume: 2/N for N points.
--states: a row for each row of the cycle, columns as of hinge-joint --pv, and
heat_W and pv_total_W over the contact. --plot draws R, the friction moment and
the largest p and p v over the time.

)";

constexpr std::string_view examples = R"(
Examples:
  hinge-duty --joint data/reference/duty/cycle_hip.toml --cycle data/reference/duty/cycle_hip_in.csv --euler zxy --format markdown
  hinge-duty --joint data/reference/duty/cycle_hip.toml --cycle data/reference/duty/cycle_hip_in.csv --euler zxy --wear-seat 1e-6 --map map.csv --map-plot map.svg --output hip.csv
  hinge-duty --joint data/reference/duty/cycle_hip.toml --cycle data/reference/duty/cycle_hip_in.csv --euler zxy --wear-seat 1e-6 --cycles 5e6 --blocks blocks.csv --format markdown
  hinge-duty --joint data/reference/duty/cycle_hip.toml --cycle data/reference/duty/cycle_hip_in.csv --euler zxy --measured-volume 25.6 --measured-error 1.2 --measured-cycles 1e6
  hinge-duty --joint data/reference/duty/cycle_pin.toml --cycle data/reference/duty/cycle_pin_in.csv --wear-seat 2e-7 --wear-inner 5e-8 --states states.csv
  hinge-duty --joint data/joints/hip_cocr_uhmwpe.toml --cycle data/duty/hip_cycle.sto --euler zxy --force-columns hip_on_leg_in_pelvis_fx,hip_on_leg_in_pelvis_fy,hip_on_leg_in_pelvis_fz --angle-columns hip_flexion_r,hip_adduction_r,hip_rotation_r

)";

void add_cycle(cli::Program& program, Options& o) {
  program.add(
      "Cycle",
      {{"--cycle", &o.cycle, "FILE",
        "CSV file, - for standard input; or table of OpenSim, .sto or .mot", "",
        "", true},
       {"--period", &o.period, "TIME", "of the cycle, s"},
       {"--euler", &o.euler, "SEQUENCE", "axes of the angles, such as zxy"},
       {"--force-columns", &o.force_columns, "NAMES",
        "of .sto, .mot: columns of R_x, R_y, R_z, N, with commas"},
       {"--angle-columns", &o.angle_columns, "NAMES",
        "of .sto, .mot: columns of the angles, as inDegrees says"},
       {"--force-on", cli::word("--force-on", o.force_on, bodies), "BODY",
        "that the forces act on: body (default) or carrier"},
       {"--force-in", cli::word("--force-in", o.force_in, bodies), "BODY",
        "in whose axes they are: body or carrier (default)"}});
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
        "that wore off one body, mm^3, for its k", "--measured-cycles"},
       {"--measured-error", any("--measured-error", o.measured_error, "mm^3"),
        "NUMBER", "its standard error, mm^3", "--measured-volume"},
       {"--measured-cycles",
        any("--measured-cycles", o.measured_cycles, "", 1, 1e15), "N",
        "in which it wore off", "--measured-volume"},
       {"--map", &o.map, "FILE", "CSV file of the wear of both bodies"},
       {"--map-plot", &o.map_plot, "FILE",
        "picture of the wear of both bodies: .svg, .png or .pdf"},
       {"--grid", cli::count("--grid", o.grid, 10, 1'000'000), "N",
        "points of each body; default 2000",
        "--map, --map-plot, --wear-seat or --wear-inner"},
       {"--cycles", any("--cycles", o.cycles, "", 0, 1e15), "N",
        "number of cycles in which wear of the seat changes the contact",
        "--wear-seat"},
       {"--blocks", &o.blocks, "FILE", "CSV file of the joint as it wears",
        "--cycles"}});
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program program("Heat, p v and wear of a joint on a duty cycle",
                       "hinge-duty");
  Options options;
  add_joint_options(program, options.joint);
  add_law_options(program, options.joint, cli::Laws::one, cli::Laws::one);
  add_friction_options(program, options.friction);
  add_cycle(program, options);
  add_wear(program, options);
  program.add_output(options.output);
  program.add("Output", {{"--states", &options.states, "FILE",
                          "CSV file of the states at the rows of the cycle"}});
  return program.run(argc, argv,
                     std::string(help) + std::string(cli::size_help) +
                         std::string(cli::joint_help) + std::string(examples) +
                         std::string(cli::exit_status_help),
                     [&] { return hinge_duty::run(options); });
}
