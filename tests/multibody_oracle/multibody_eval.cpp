#include <algorithm>
#include <string>

#include "cli/output.hpp"
#include "cli/program.hpp"
#include "libcontact/base/error.hpp"
#include "multibody_oracle/case_file.hpp"

namespace {

constexpr const char* description =
    "Accelerations and reactions of a carrier with hinged bodies at one "
    "instant.\n\n"
    "FILE is a case in the format of data/reference/multibody/README.md or,\n"
    "where bodies hang on bodies, of data/reference/trees/README.md; the\n"
    "result is a JSON object with the keys of its \"expected\", in the same\n"
    "units and frames.\n\n"
    "Keys that may be left out: active_force, active_moment_com and\n"
    "friction_moment (then zero), held (false), position_com and velocity_com\n"
    "(no result depends on them), what is given twice, and name, seed, "
    "oracle,\n"
    "expected. gravity_inertial has to be there. Other keys are refused.";

constexpr const char* footer =
    "Example:\n"
    "  multibody-eval data/reference/multibody/axes_18_balanced_rotors_L3.json"
    "\n\nExit status: 0 computed; 2 bad option or file, no result.\n";

bool is_finite(const multibody::InstantResult& result) {
  return result.acceleration.allFinite() &&
         result.angular_acceleration.allFinite() &&
         std::all_of(result.bodies.begin(), result.bodies.end(),
                     [](const multibody::BodyResult& body) {
                       return body.acceleration.allFinite() &&
                              body.angular_acceleration.allFinite() &&
                              body.reaction_force.allFinite() &&
                              body.reaction_moment.allFinite();
                     });
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program program(description, "multibody-eval");
  std::string file;
  std::string output;
  program.add("Options", {{"FILE", &file, "", "case to evaluate", "", "", true},
                          {"--output", &output, "FILE",
                           "file to write; default standard output"}});
  return program.run(argc, argv, footer, [&] {
    const multibody::CaseInstant instant = multibody::read_case(file);
    const multibody::InstantResult result = multibody::evaluate(instant);
    if (!is_finite(result)) {
      throw contact::Error(file +
                           ": accelerations are not finite: a mass, inertia, "
                           "distance, rate or force is too large");
    }
    cli::Output to(output);
    to.write(multibody::to_json(instant, result).dump(2) + '\n');
    to.commit();
    return cli::all_good;
  });
}
