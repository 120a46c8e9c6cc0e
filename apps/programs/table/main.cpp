// hinge-table: tables of friction integrals and coefficients.

#include "cli/program.hpp"
#include "help/help.hpp"
#include "programs/table/run.hpp"

int main(int argc, char** argv) {
  cli::Program program(
      "Friction integrals and coefficients of a ball joint with dry friction",
      "hinge-table");
  hinge_table::Options o;
  program.add(
      "Table",
      {{"--theta0", &o.theta0, "ANGLES", "half-angles, deg"},
       {"--alpha", &o.alpha, "ANGLES", "slip axis angles, deg", "--theta0"},
       {"--points", &o.points, "FILE",
        "CSV file of points, - for standard input", "",
        "--theta0 --alpha --quantity --plot"},
       {"--method", &o.method, "NAME",
        "exact (default), elliptic, quadrature, planar, viscous, cosine;\n"
        "of K,E: exact, chebyshev"},
       {"--tolerance", &o.tolerance, "NUMBER",
        "relative tolerance of --method quadrature; default 1e-10"},
       {"--quantity", &o.quantity, "NAME",
        "quantity of a grid in markdown, latex and pictures; default chi;\n"
        "K,E: the complete elliptic integrals of sin theta0;\n"
        "operations: of bodies on hinges"},
       {"--bodies", &o.bodies, "VALUES",
        "numbers of bodies, 1 to 1000; default 1:8:1", "--quantity"}});
  add_joint_options(program, o.joint);
  add_law_options(program, o.joint, cli::Laws::one, cli::Laws::one);
  program.add_output(o.output);
  program.add_jobs(o.output);
  add_fileless_joint_options(program, o.joint);
  return program.run(argc, argv, help, [&] { return hinge_table::run(o); });
}
