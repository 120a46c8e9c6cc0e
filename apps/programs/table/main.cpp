// hinge-table: tables of friction integrals and coefficients.
#include <string>
#include <string_view>

#include "cli/program.hpp"
#include "programs/table/run.hpp"

namespace {

constexpr std::string_view help = R"(
Angles, degrees:
  theta0   half-angle of the contact, 0 to 120
  alpha    slip axis angle, -90 to 90: 0 is pure sliding, 90 pure spinning
Each takes a value, a list a,b,c, a range start:stop:step, or
start:stop:logN for N values in equal ratios.

Columns, all without units but the angles:
  theta0_deg,alpha_deg  the point
  I_normal              normal integral, R_n = rho^2 p0 I_normal
  I_p,J_p,K_p           friction integrals with weight cos(t) - cos(theta0)
  I_a,J_a,K_a           the same with weight 1 (adhesion)
  chi,sigma_Y,sigma_Z   coefficients I_p, J_p, K_p over I_normal, of the
                        friction force, sliding and spinning moment
The names of the columns that depend on the pressure end in its: chi_cosine,
I_p_exact. With another pressure than cosine the weight is p(t)/p(0), R_n = rho^2
p(0) I_normal. Pressures: cosine (default without materials), sqrt_tan,
sqrt_theta, worn (up to 90 deg), and mixture and exact (default with materials),
which need the materials by --joint, --pair or --modulus-ratio.
CSV and JSON have the shortest numbers that read back as the same double.
markdown and latex are for print, with 4 significant digits: of a grid a
two-way table of one --quantity, of --points a list. A picture shows one
--quantity over alpha, a curve for each theta0, at most 12 of them.

A file of points is CSV with a header that names theta0_deg and alpha_deg.
Other columns are handed on behind sigma_Z, unchanged ("_in" is added to a
name that is taken); lines that start with # before the header are skipped.
A bad line gives "ERROR: line N: ..." on standard error and in the table, in
its place, a row with ERROR, empty cells and its other columns. Numbers that
are not finite, though the pressure goes that far, are ERROR too; both end with
status 1.

)";

constexpr std::string_view examples = R"(
Examples:
  hinge-table --theta0 0:95:5 --alpha 0:90:7.5
  hinge-table --theta0 45 --alpha 30 --format json
  hinge-table --theta0 5:85:20 --alpha 0:90:15 --quantity sigma_Z --format markdown
  hinge-table --theta0 20:80:20 --alpha 0,45,90 --pressure exact --modulus-ratio 1
  hinge-table --theta0 20:80:20 --alpha 0,45,90 --modulus-ratio 100 --wall 0.5 --backing rigid
  hinge-table --theta0 1:90:log50 --alpha 0,45,90 --output table.csv --jobs 2
  printf 'theta0_deg,alpha_deg,note\n40,15,pin\n' | hinge-table --points -

)";

}  // namespace

int main(int argc, char** argv) {
  cli::Program program(
      "Friction integrals and coefficients of a ball joint with dry friction",
      "hinge-table");
  hinge_table::Options o;
  program.add(
      "Options",
      {{"--theta0", &o.theta0, "ANGLES", "half-angles, deg", "--alpha"},
       {"--alpha", &o.alpha, "ANGLES", "slip axis angles, deg", "--theta0"},
       {"--points", &o.points, "FILE",
        "CSV file of points, - for standard input", "",
        "--theta0 --alpha --quantity --plot"},
       {"--method", &o.method, "NAME",
        "exact (default), elliptic, quadrature, planar, viscous, cosine"},
       {"--tolerance", &o.tolerance, "NUMBER",
        "of --method quadrature, relative; default 1e-10"},
       {"--quantity", &o.quantity, "NAME",
        "of a grid in markdown, latex and pictures; default chi"}});
  add_joint_options(program, o.joint);
  add_law_options(program, o.joint, cli::Laws::one, cli::Laws::one);
  program.add_output(o.output);
  program.add_jobs(o.output);
  return program.run(argc, argv,
                     std::string(help) + std::string(cli::joint_help) +
                         std::string(examples) +
                         std::string(cli::exit_status_help),
                     [&] { return hinge_table::run(o); });
}
