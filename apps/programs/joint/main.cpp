// hinge-joint: friction of one ball or pin joint under a known reaction.
#include <fmt/format.h>

#include <optional>
#include <string>

#include "cli/program.hpp"
#include "cli/sweep.hpp"
#include "help/help.hpp"
#include "libcontact/files/joint_tables.hpp"
#include "libcontact/files/key_schema.hpp"
#include "programs/joint/run.hpp"
#include "programs/joint/solution_row.hpp"

namespace {

using contact::Dimension;
using hinge_joint::Options;

// Three components.
cli::Reader xyz(const char* flag, std::optional<Eigen::Vector3d>& to,
                const char* what, Dimension dimension) {
  return [flag, &to, what, dimension](const std::string& text) {
    const auto [x, y, z] = cli::parse_vector(flag, text, what, dimension);
    to = {x, y, z};
  };
}

// The help with the meanings of the columns.
std::string help_with_columns() {
  constexpr std::string_view place = "%COLUMNS%\n";
  std::string columns;
  for (const auto& column : hinge_joint::answer_columns({.rest = true,
                            .approach = true,
                            .preload = true,
                            .friction = true,
                            .pv = true,
                            .rims = true,
                            .lie = true,
                            .place = true})) {
    columns += column.meaning.empty()
                   ? fmt::format("  {}\n", column.name)
                   : fmt::format("  {:<19} {}\n", column.name, column.meaning);
  }
  std::string text(help);
  return text.replace(text.find(place), place.size(), columns);
}

void add_friction(cli::Program& program, Options& o) {
  add_friction_options(program, o.friction);
  program.add(
      "Friction",
      {{"--measured-moment",
        cli::number("--measured-moment", o.measured_moment, Dimension::moment,
                    {0, hinge_joint::allowed_force.max, "N m"}),
        "NUMBER", "measured |M_t|, N m, to compute f0", "",
        "--friction --viscous --moment-xyz --points --trace --outer"}});
}

void add_state(cli::Program& program, Options& o) {
  program.add(
      "State",
      {{"--reaction-xyz",
        xyz("--reaction-xyz", o.reaction_xyz, "a force in N", Dimension::force),
        "X,Y,Z", "R on the body, N", "",
        "--reaction --normal-force --points --rate"},
       {"--rate-xyz",
        xyz("--rate-xyz", o.rate_xyz, "in rad/s", Dimension::angular_velocity),
        "X,Y,Z", "Dw, rad/s", "--reaction-xyz", "--moment-xyz"},
       {"--moment-xyz",
        xyz("--moment-xyz", o.moment_xyz, "a moment in N m", Dimension::moment),
        "X,Y,Z", "M to hold at rest, N m", "--reaction-xyz"},
       {"--reaction", &o.reaction, "VALUES", "R, N", "",
        "--normal-force --points"},
       {"--beta", &o.beta, "ANGLES", "angle between R and Dw, deg, 0 to 180",
        "--reaction"},
       {"--normal-force", &o.normal_force, "VALUES", "R_n, N", "", "--points"},
       {"--alpha", &o.alpha, "ANGLES", "slip axis angle, deg, -90 to 90",
        "--normal-force"},
       {"--points", &o.points, "FILE",
        "CSV file of states, - for standard input", "",
        "--trace --outer --beside --map"},
       {"--rate", &o.rate, "VALUES", "|Dw|, rad/s; default 1"}});
}

void add_tilt(cli::Program& program, Options& o) {
  add_tilt_options(
      program, o.tilt, "--reaction",
      "--reaction-xyz --beta --normal-force --alpha --points --trace --outer "
      "--measured-moment --map --plot --law --pressure");
  program.add("Tilt",
              {{"--slide",
                cli::number("--slide", o.slide, Dimension::velocity,
                            {-1e100, 1e100, "m/s"}),
                "SPEED", "speed of the body along the pin, m/s; default 0",
                "--tilt or --load-at"},
               {"--without-relief", &o.without_relief, "",
                "let a pin be straight, whatever its [relief]", "",
                "--tilt --load-at"}});
}

void add_seat(cli::Program& program, Options& o) {
  program.add(
      "Seat",
      {{"--without-seat", &o.without_seat, "",
        "let the contact of a ball extend beyond the rims of its [seat]", "",
        "--normal-force --tilt --load-at"}});
}

void add_equivalent(cli::Program& program, Options& o) {
  program.add(
      "Other programs",
      {{"--equivalent", &o.equivalent, "",
        "print numbers for the friction formulas of Adams, MotionSolve, PhysX, "
        "MuJoCo and others, with the least error over the sweep",
        "--reaction",
        "--trace --outer --measured-moment --map --beside --summary "
        "--plot --jobs --tilt --load-at --pv"},
       {"--kernel", &o.kernel.language, "LANGUAGE",
        "print friction over load as a function in c, cuda, glsl, jax, js, "
        "numpy or st",
        "",
        "--reaction-xyz --beta --normal-force --points --rate --trace "
        "--outer --measured-moment --map --beside --summary --plot "
        "--jobs --tilt --load-at --pv --equivalent --format "
        "--columns --separator --decimal-comma"},
       {"--kernel-error",
        cli::number("--kernel-error", o.kernel.error, Dimension::number,
                    {1e-9, 1, ""}),
        "NUMBER", "largest relative error of the function; default 1e-4",
        "--kernel"},
       {"--kernel-name", &o.kernel.name, "NAME",
        "name of the function; default friction", "--kernel"}});
}

void add_loops(cli::Program& program, Options& o) {
  program.add(
      "Loops",
      {{"--trace", &o.trace, "", "the paper's inner loop", "",
        "--braking --summary --plot --jobs --pv --map"},
       {"--outer",
        xyz("--outer", o.outer, "a change of R in N per N m",
            Dimension::number),
        "X,Y,Z", "outer loop: change of R, N per N m of M", "",
        "--summary --plot --jobs --pv --map"},
       {"--joints", cli::count("--joints", o.joints, 1, 1000), "N",
        "number of joints whose moments add up to M; default 1", "--outer"},
       {"--braking",
        cli::number("--braking", o.braking, Dimension::number,
                    {-1e100, 1e100, "deg/s^2 per N m"}),
        "NUMBER", "angular acceleration over M, deg/s^2 per N m", "--outer"},
       {"--inner-steps",
        [&o](const std::string& text) {
          o.inner_steps = cli::whole_numbers("--inner-steps", text, 1000);
        },
        "LIST",
        "steps of the inner loop in each round; default: until converged",
        "--outer"}});
}

void add_output(cli::Program& program, Options& o) {
  program.add(
      "Output",
      {{"--summary", &o.summary, "",
        "a line for each quantity instead of a column", "", "--jobs"},
       {"--pv", &o.pv, "",
        "more columns: p v and heat over the contact, slip_coefficient"},
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
  add_state(program, options);
  add_tilt(program, options);
  add_seat(program, options);
  add_equivalent(program, options);
  add_friction(program, options);
  add_law_options(program, options.joint, cli::Laws::several,
                  cli::Laws::several);
  add_output(program, options);
  add_loops(program, options);
  add_fileless_joint_options(program, options.joint);
  program.add_schema(
      [] { return contact::schema_text(contact::joint_keys()); });
  return program.run(argc, argv, help_with_columns(),
                     [&] { return hinge_joint::run(options); });
}
