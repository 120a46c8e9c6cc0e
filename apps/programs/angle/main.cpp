// hinge-angle: half-angle of the contact against load.
#include <string>
#include <string_view>

#include "cli/program.hpp"
#include "programs/angle/run.hpp"

namespace {

using hinge_angle::Options;

constexpr std::string_view help = R"(
The joint is one of
  --joint FILE.toml           a joint file
  --joint ball|pin --pair FILE.toml --radius R --clearance EPS
  --joint ball|pin --pair FILE.toml              dimensionless
  --joint ball|pin --modulus-ratio E1/E2         dimensionless
with body 1 the ball or pin and body 2 the seat or hole. A modulus ratio of 0 is
a rigid seat, inf a rigid ball or pin.
)";

constexpr std::string_view load_help = R"(
The load is one of
  --load            normal force, N; of a pin without a length N/m. A unit says
                    it too: 20kN, 20kN/m
  --load-parameter  mu = 3 R_n/(2 ebar rho1^2 E) (ball) or
                    lambda = 2 P/(pi ebar rho1 E) (pin), with
                    E = 2/((1-nu1^2)/E1 + (1-nu2^2)/E2), ebar = EPS/R
  --x               cbrt(mu) or 2 sqrt(lambda)
Each takes a value, a list a,b,c, a range start:stop:step, or
start:stop:logN for N values in equal ratios.

Laws: hertz, arctan, tanh, blend, blend:K (K arctan + (1-K) tanh), paper
(blend:0.5 for a pin, tanh for a ball), fitted (a formula fitted to exact
contacts of any pair; the default), exact (the theory of elasticity for this
pair), or all (but paper, which is one of them).
Limit half-angle of arctan, tanh and blend: formula, linear (0.5 <= E1/E2 <= 2),
or a value in degrees. A joint file may name the law, the limit half-angle
and the pressure law; options go before it.

Columns of several joints (--joint more than once, --set): joint, and the keys.
Then load_N (load_N_per_m of a pin without a length; neither in dimensionless
runs), load_parameter, x, and
  p_nominal_Pa            force over projected area: pi R^2 (ball), 2 R L (pin);
                          makers of spherical plain bearings take ball diameter
                          times width of the ring, half of pi R^2
and for each law
  theta0_LAW_deg          half-angle of the contact, degrees
  p_peak_LAW_by_PRESSURE_Pa  peak pressure, Pa, by a pressure law: exact unless
                          the joint or --pressure names another; of hertz
                          Hertz' own. In dimensionless runs
  p_peak_LAW_by_PRESSURE_over_nominal
                          over the nominal pressure
The law exact of a joint with a size has two more,
  approach_m              how far the load presses the bodies together, from
                          first touch
  stiffness_N_per_m       d load/d approach; loads per length: _N_per_m2
They are empty for a pin in an infinite hole, which gives way without end, for
loading through the back and without load.
With --inverse: theta0_deg, then for each law load_LAW_N, load_parameter_LAW,
x_LAW, p_nominal_LAW_Pa and the others. Where a law has no value (hertz for
x > 1) the cell is empty, in JSON null; a row where none has one is a point that
failed.
A peak above 5 % of the smaller Young's modulus or above the limit_pressure of a
material, and half-angles beyond the limit of the joint are warned of.

With --compare one row for each law (all unless --law names some), between the
smallest and the largest load given, without one from 1e-6 to 1e8 of the load
parameter: error_percent, the largest difference from the exact half-angle at
the same load (inf if the law has no value); load_N, load_parameter,
theta0_exact_deg and theta0_law_deg where that is; cost_tanh, one half-angle as
a multiple of a std::tanh, roughly; recommended: yes for the cheapest law
within --tolerance. The picture of --plot has the errors below the half-angles
whenever exact is one of several laws.

)";

constexpr std::string_view examples = R"(
Examples:
  hinge-angle --joint pin --modulus-ratio 1 --load-parameter 0.001:10:log9 --law hertz,arctan,tanh,blend
  hinge-angle --joint ball --pair data/materials/steel_bronze.toml --radius 50mm --clearance 50um --load 1e4:1e6:log5
  hinge-angle --joint ball --pair data/materials/cocr_uhmwpe.toml --radius 14mm --clearance 100um --wall 8mm --backing rigid --load 2000
  hinge-angle --joint pin --pair data/materials/steel_bronze.toml --diameter 50mm --hole H7 --shaft g6 --load 1e5
  hinge-angle --joint ball --modulus-ratio 0 --limit-angle 92.5 --x 0:2:0.5 --law tanh --format markdown
  hinge-angle --joint data/joints/paper_example_1.toml --load 1e4:1e6:log9 --law hertz,arctan,tanh
  hinge-angle --compare --joint data/joints/hip_cocr_uhmwpe_infinite.toml --load 100:5000:log50 --format markdown
  hinge-angle --joint ball --modulus-ratio 2 --poisson1 0.4 --x 0.01:100:log200 --law all --output ball.csv --plot ball.svg
  hinge-angle --joint pin --modulus-ratio 1 --inverse --theta0 0:80:20 --format json
  hinge-angle --joint data/joints/hip_cocr_uhmwpe.toml --set geometry.radial_clearance_um=50,100,150 --load 500:3000:500 --plot hips.svg
  hinge-angle --force-law --joint data/joints/hip_cocr_uhmwpe.toml --output force.csv
  hinge-angle --impact --joint data/joints/hip_cocr_uhmwpe.toml --mass 5 --speed 0.01,0.1 --restitution 0.5

)";

void add_options(cli::Program& program, Options& o) {
  add_joint_options(program, o.joint);
  add_load_options(program, o.load);
  program.add("Load",
              {{"--inverse", &o.inverse, "", "from half-angles to loads",
                "--theta0", "--load --load-parameter --x"},
               {"--theta0", &o.load.theta0, "ANGLES",
                "half-angles, deg, 0 to 180", "--inverse"}});
  add_law_options(program, o.joint, cli::Laws::several, cli::Laws::one);
  add_play_options(program, o.play);
  program.add("Law",
              {{"--compare", &o.compare, "",
                "how far each law is from exact over the range of the load", "",
                "--inverse --pressure --jobs"},
               {"--tolerance",
                cli::number("--tolerance", o.tolerance,
                            contact::Dimension::number, {0, 100, "%"}),
                "PERCENT",
                "percent of theta0 that --compare takes for good; default 0.1",
                "--compare"}});
  program.add_output(o.output);
  program.add_jobs(o.output);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program program(
      "Half-angle of the contact of a ball or pin joint against load",
      "hinge-angle");
  Options options;
  add_options(program, options);
  return program.run(argc, argv,
                     std::string(help) + std::string(cli::size_help) +
                         std::string(cli::joint_help) + std::string(load_help) +
                         hinge_angle::play_help + std::string(examples) +
                         std::string(cli::exit_status_help),
                     [&] { return hinge_angle::run(options); });
}
