// hinge-pressure: contact pressure of a joint under load.
#include <string>
#include <string_view>

#include "cli/program.hpp"
#include "programs/pressure/run.hpp"

namespace {

using hinge_pressure::Options;

constexpr std::string_view help = R"(
The joint and the load are given as to hinge-angle: a joint file, or ball or
pin with the materials and the size, or dimensionless with --modulus-ratio;
the load takes a value, a list a,b,c, a range start:stop:step, or
start:stop:logN for N values in equal ratios.

--law is the half-angle law that gives theta0 (see hinge-angle); default: the
joint file's, or fitted.
Pressure laws: cosine (the paper's (3.3)), sqrt_tan (sqrt(1 - tan^2(t/2)/
tan^2(theta0/2))), sqrt_theta (sqrt(1 - (t/theta0)^2)), mixture (cosine and
sqrt_tan in the share that suits the materials), exact (the theory of
elasticity for this pair; the default, unless the joint file names another),
worn (cos t, of a surface that has worn in; up to 90 deg), or all, which leaves
worn out. Each carries the whole load.
)";

constexpr std::string_view column_help = R"(
Columns, a row for each angle from the centre of the contact to its edge:
  joint, KEY          of several joints (--joint more than once, --set)
  load_N              load (load_N_per_m: of a pin without a length); not in
                      dimensionless runs
  load_parameter      mu or lambda
  theta0_deg          half-angle of the contact
  loading             back:PSI; not with a force at the centre
  theta_deg           angle from the centre of the contact
  p_LAW_Pa            pressure, Pa, or in dimensionless runs
  p_LAW_over_nominal  over the nominal pressure: force over pi R^2 (ball), over
                      2 R L (pin)
With --summary a row for each load and pressure law: load_N, load_parameter,
theta0_deg, law (of the half-angle), pressure (the law), p_peak_Pa, p_mean_Pa
(or _over_nominal), p_nominal_Pa, contact_area_m2 or contact_width_m (dimensionless:
contact_area_over_R2, contact_width_over_R), S (sum of the pressures over the
force that they carry); for a ball the friction coefficients chi_0 (force),
sigma_Y_0 (moment) of pure sliding and sigma_Z_90 (moment) of pure spinning.
A joint with a size and the half-angle law exact has approach_m too, how far the
load presses the two bodies together from first touch, and the stiffness there,
stiffness_N_per_m or, if loads are per length, stiffness_N_per_m2. Both are empty
for a pin in an infinite hole, which gives way without end, for loading through
the back and without load.
Where a law has no value the cell is empty, in JSON null, and the exit status 1.

Examples:
  hinge-pressure --joint data/joints/hip_cocr_uhmwpe.toml --load 500,2000 --summary --format markdown
  hinge-pressure --joint data/joints/pin_joint.toml --load 50kN --law exact --points 21
  hinge-pressure --joint ball --modulus-ratio 0 --x 1.5 --pressure cosine,exact --output ball.csv --plot ball.svg

)";

void add_options(cli::Program& program, Options& o) {
  add_joint_options(program, o.joint);
  hinge_angle::add_load_options(program, o.load);
  add_law_options(program, o.joint, cli::Laws::one, cli::Laws::several);
  program.add(
      "Profile",
      {{"--summary", &o.summary, "",
        "peak, mean, area and S in place of profiles"},
       {"--points", cli::count("--points", o.points, 2, 1'000'000), "N",
        "rows from the centre to the edge; default 101", "", "--summary"}});
  program.add_output(o.output);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program program("Contact pressure of a ball or pin joint under load",
                       "hinge-pressure");
  Options options;
  add_options(program, options);
  return program.run(argc, argv,
                     std::string(help) + std::string(cli::size_help) +
                         std::string(cli::joint_help) +
                         std::string(column_help) +
                         std::string(cli::exit_status_help),
                     [&] { return hinge_pressure::run(options); });
}
