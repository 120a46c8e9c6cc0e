// hinge-joint: friction of one ball or pin joint under a known reaction.
#include <fmt/format.h>

#include <string>
#include <string_view>

#include "cli/program.hpp"
#include "programs/joint/run.hpp"
#include "programs/joint/solution_row.hpp"

namespace {

using hinge_joint::Options;

constexpr std::string_view help = R"(
The joint is one of
  --joint FILE.toml           a joint file
  --joint ball --pair FILE.toml --radius R --clearance EPS
  --joint pin --pair FILE.toml --radius R --clearance EPS --length L
Friction, half-angle law and pressure law are those of the files unless options
name others; of comma lists of laws every pair is computed.
Half-angle laws as in hinge-angle: hertz, arctan, tanh, blend, blend:K, paper,
fitted, exact, or all.
)";

constexpr std::string_view state_help = R"(
The state is one of
  --reaction-xyz X,Y,Z --rate-xyz X,Y,Z    R on the body, N; angular velocity
                                           Dw of the body against the carrier,
                                           rad/s; 0,0,0: at rest
  --reaction-xyz X,Y,Z --moment-xyz X,Y,Z  at rest: whether the joint holds
                                           the moment M on the body, N m
  --reaction R --beta B      R in N at B degrees from Dw; Dw along Z, R in the
                             plane XOZ
  --normal-force F --alpha A normal force R_n in N, slip axis angle in
                             degrees: 0 sliding, 90 spinning; R_n along Z, Dw
                             in the plane YOZ
  --points FILE              a state in each line of a CSV file, by the columns
                             of this program's output: R_N,b_deg or R_n_N,a_deg
                             or R_x_N,R_y_N,R_z_N with w_x_rad_per_s,... or,
                             at rest, M_x_N_m,M_y_N_m,M_z_N_m
A pin has no angles; its axis is the direction of Dw (of M), and the part
of R along it is left out. --reaction,
--beta, --normal-force, --alpha take a value, a list a,b,c, a range
start:stop:step, or start:stop:logN for N values in equal ratios; of two, all
pairs are computed, angles running fastest.

Other columns of --points are handed on behind the results, unchanged ("_in"
is added to a name that is taken). A bad line gives "ERROR: line N: ..." on
standard error and in the table, in its place, a row with ERROR. From a pipe
each line is answered as it comes.
--points --summary prints the largest values (in size) of reaction, normal
force, friction moment, f_M, peak pressure, half-angle and power, where they
are, and their means; --points --plot draws moment, reaction and peak pressure.
With a column of the time that never falls (time_s, t_s, time, t in s, time_ms,
t_ms) these are over the time, and dissipated_energy_J is the heat of the cycle,
minus the work of friction, by the trapezoidal rule from the first line to the
last. Without, lines are counted. What has no solution is left out, and counted.

f_M = M_t/(rho R) is what catalogues call the coefficient of friction; f0 is
that of the surface. --measured-moment M finds f0, 0 to 3, from |M_t| in one
state that slides, with the adhesion of the joint or of --adhesion; all is
printed with that f0, the last column.

--trace prints the paper's inner loop step by step: law, pressure, step, g_deg,
a_deg, R_n_N, Abar, load_parameter, theta0_deg, f (the next step's tan g).
--outer X,Y,Z lets the reaction answer to the friction moment M about Dw of
--joints equal joints: R = R0 + M (X,Y,Z). It prints, round by round, law,
pressure, M, the braking C M with --braking C, R, and the contact that gave M.
--inner-steps 4,3 cuts the inner loop short after 4 steps in the first round, 3
in the others; with --trace all steps of the inner loops are printed.

--beside FILE.csv shows printed or measured numbers beside the computed ones:
columns joint (name in the joint file), table (solution, trace, outer, inner),
row (from 1), column, value.

Columns: joint and the keys of --set if there are several joints, law and
pressure (names), state (sliding, resting, unloaded; with
--moment-xyz holds or slips), status (ok, out_of_range, not_converged), then
)";

constexpr std::string_view examples = R"(
Forces and moments act on the body. What has no meaning at rest or without
load is empty, in JSON null. The law exact alone has approach_m and
stiffness_N_per_m; they are empty for a pin in an infinite hole, which gives way
without end, and for loading through the back. With --moment-xyz utilisation
and u are there too, and the others are those of the slip about u at 1 rad/s
that would begin; with --measured-moment f0 is; with --pv those from pv_max_W_per_m2
on are, what bearings are rated by.
--summary prints a line for each quantity instead. --plot draws the friction
moment over the swept force or angle, dashed the traditional estimate from R.
--map draws p, p v and slip over the contact of one state, p and p v with their
largest values marked: of a ball as it is seen from outside, above the contact's
centre, in equal areas, with the slip of the body as arrows and circles each 30
deg; of a pin over the angle.

Examples:
  hinge-joint --joint data/joints/paper_example_1.toml --reaction 2.63e5 --beta 67.6 --summary --format markdown
  hinge-joint --joint data/joints/paper_example_1.toml --normal-force 2e5 --alpha 30 --summary --beside data/reference/paper_examples.csv
  hinge-joint --joint data/joints/paper_example_1.toml --reaction 2.63e5 --beta 67.6 --trace --beside data/reference/paper_examples.csv
  hinge-joint --joint data/joints/paper_example_2.toml --reaction-xyz 1.122e6,3.23e5,0 --rate-xyz 0,0,1 --outer 0,-0.026,0 --joints 2 --braking=-6.5e-6 --inner-steps 4,3 --beside data/reference/paper_examples.csv --format markdown
  hinge-joint --joint data/joints/hip_cocr_uhmwpe.toml --reaction 10:5000:log50 --beta 30,60,90 --output hip.csv
  hinge-joint --joint ball --pair data/materials/steel_bronze.toml --radius 50mm --clearance 50um --friction 0.15 --law tanh --reaction-xyz 1e5,2e4,0 --moment-xyz 300,0,500 --format json
  hinge-joint --joint data/joints/pin_joint.toml --reaction 2e4 --measured-moment 40 --summary
  hinge-joint --joint data/joints/hip_cocr_uhmwpe.toml --reaction 2000 --beta 30,60,90 --rate 2 --pv --format markdown --columns b_deg,pv_nominal_W_per_m2,pv_max_W_per_m2,pv_max_theta_deg
  hinge-joint --joint data/joints/hip_cocr_uhmwpe.toml --reaction 2000 --beta 50 --rate 2 --map contact.svg --summary
  hinge-joint --joint data/joints/pin_joint.toml --law hertz,blend --reaction 1e3,1e4
  printf 'time_s,R_N,b_deg\n0,1e5,90\n0.1,2e5,80\n' | hinge-joint --joint data/joints/paper_example_1.toml --points -

)";

std::string footer() {
  std::string text(help);
  text += cli::size_help;
  text += cli::joint_help;
  text += state_help;
  for (const auto& quantity : hinge_joint::quantities(true, true, true, true)) {
    text += quantity.meaning.empty()
                ? fmt::format("  {}\n", quantity.name)
                : fmt::format("  {:<19} {}\n", quantity.name, quantity.meaning);
  }
  return text + std::string(examples) + std::string(cli::exit_status_help);
}

void add_friction(cli::Program& program, Options& o) {
  add_friction_options(program, o.friction);
  program.add("Friction",
              {{"--measured-moment", &o.measured_moment, "NUMBER",
                "|M_t|, N m, from which f0 is found", "",
                "--friction --viscous --moment-xyz --points --trace --outer"}});
}

void add_state(cli::Program& program, Options& o) {
  program.add(
      "State",
      {{"--reaction-xyz", &o.reaction_xyz, "X,Y,Z", "R on the body, N", "",
        "--reaction --normal-force --rate"},
       {"--rate-xyz", &o.rate_xyz, "X,Y,Z", "Dw, rad/s", "--reaction-xyz",
        "--moment-xyz"},
       {"--moment-xyz", &o.moment_xyz, "X,Y,Z", "M to hold at rest, N m",
        "--reaction-xyz"},
       {"--reaction", &o.reaction, "VALUES", "R, N", "", "--normal-force"},
       {"--beta", &o.beta, "ANGLES", "angle between R and Dw, deg, 0 to 180",
        "--reaction"},
       {"--normal-force", &o.normal_force, "VALUES", "R_n, N"},
       {"--alpha", &o.alpha, "ANGLES", "slip axis angle, deg, -90 to 90",
        "--normal-force"},
       {"--points", &o.points, "FILE",
        "CSV file of states, - for standard input", "",
        "--reaction-xyz --reaction --normal-force --trace --outer --beside "
        "--map"},
       {"--rate", &o.rate, "NUMBER", "|Dw|, rad/s; default 1"}});
}

void add_loops(cli::Program& program, Options& o) {
  program.add(
      "Loops",
      {{"--trace", &o.trace, "", "the paper's inner loop", "",
        "--braking --summary --plot --jobs --pv --map"},
       {"--outer", &o.outer, "X,Y,Z", "outer loop: change of R, N per N m of M",
        "", "--summary --plot --jobs --pv --map"},
       {"--joints", &o.joints, "N", "M is that of so many joints; default 1",
        "--outer"},
       {"--braking", &o.braking, "NUMBER",
        "angular acceleration over M, deg/s^2 per N m", "--outer"},
       {"--inner-steps", &o.inner_steps, "LIST",
        "steps of the inner loop in each round; default: until converged",
        "--outer"}});
}

void add_output(cli::Program& program, Options& o) {
  program.add(
      "Output",
      {{"--summary", &o.summary, "",
        "a line for each quantity instead of a column", "", "--jobs"},
       {"--pv", &o.pv, "",
        "with p v and heat over the contact, slip_coefficient"},
       {"--map", &o.map, "FILE",
        "picture of p, p v and slip over the contact of one state"},
       {"--beside", &o.beside, "FILE", "CSV file of numbers to compare"}});
  program.add_output(o.output);
  program.add_jobs(o.output);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program program("Friction of a ball or pin joint under a known reaction",
                       "hinge-joint");
  Options options;
  add_joint_options(program, options.joint);
  add_law_options(program, options.joint, cli::Laws::several,
                  cli::Laws::several);
  add_friction(program, options);
  add_state(program, options);
  add_loops(program, options);
  add_output(program, options);
  return program.run(argc, argv, footer(),
                     [&] { return hinge_joint::run(options); });
}
