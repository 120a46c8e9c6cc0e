#include <fmt/format.h>

#include <regex>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/load_law/ball.hpp"
#include "libcontact/load_law/formula.hpp"
#include "libcontact/load_law/load_law.hpp"
#include "libcontact/load_law/minimax.hpp"
#include "libcontact/load_law/pin_formula.hpp"
#include "libcontact/version.hpp"

namespace contact {
namespace {

using BallLaw = detail::BallLaw<double>;
using detail::Language;
using detail::printed;
using detail::replaced;

void check_name(const std::string& name) {
  static const std::regex& word = *new std::regex("[A-Za-z][A-Za-z0-9_]{0,59}");
  if (std::regex_match(name, word)) return;
  throw Error(
      detail::must_be("the name " + detail::printable(name) + " of a function",
                      "a letter and then letters, digits and _"));
}

std::string heading(const Joint& joint, const LoadLawOptions& o,
                    const Language& in) {
  std::string text = fmt::format(
      "{}: friction of the joint \"{}\" that depends on its load. Made by "
      "libcontact {}.\n{}",
      o.name, detail::printable(o.joint), version,
      in.was_run ? ""
                 : "The tests of libcontact do not run this language: look at "
                   "the text.\n");
  for (const std::string& note : joint.contact().validity_notes()) {
    text += "Warning: " + detail::printable(note, 400) + '\n';
  }
  return text;
}

std::string pin_comment(const PinLoadLaw& law, double f0) {
  const std::string f =
      law.form == PinLoadLaw::Form::adhesion
          ? fmt::format(
                "Coefficient of friction {} and adhesion are those of the "
                "joint. Outside of\nthese loads M is proportional to R.\n",
                f0)
          : "f: coefficient of friction at this speed.\n";
  return fmt::format(
      R"(Largest error over M: {:.1e} in double, {:.1e} in float, at radial loads from {:.3g}
to {:.3g} N. {} numbers.
load: R, N, the part of the reaction normal to the axis, 0 or above.
{}moment: M, N m, which resists while the joint turns, and up to which it holds
at rest. slope, dM: dM/dR, m.
Left out: ends and tilt of the pin, grease, temperature.
)",
      law.error, law.float_error, law.loads.first, law.loads.second,
      law.numbers.size(), f);
}

std::string ball_comment(const BallLaw& law, double f0, double most_friction) {
  return fmt::format(
      R"(Largest error over |M|, vectors: {:.1e} in double, {:.1e} in float, at reactions from {:.6g}
to {:.6g} N in all directions. {} numbers.
R: reaction on the body, N; w: angular velocity of the body against the carrier,
rad/s; both in one frame. The {} has the ball.
f: coefficient of friction, at most {}; errors are those with {}, the joint's.
M: friction moment on the body about the centre, N m; normal force, N. The flag is 1 for
reactions outside, at which M is proportional to R; 2 for R = 0 or w = 0, where M = 0;
4 for NaN; else 0.
At rest _hold() says which share of what it holds friction has to supply, with m the
moment on the body, N m: it rests up to 1.
_gradient() has dM/dR, m, and dM/dw, N m s, row by row: 99 of 100 states to 20 times
the error of M, at the rim to 300 times.
Left out: rims and relief of the seat, grease, temperature.
)",
      law.error, law.float_error, law.low, law.high, law.table.size(),
      law.side > 0 ? "carrier" : "body", most_friction, f0);
}

std::string ball_code(const BallLaw& law, const Language& in) {
  // The hold needs a number of evaluations, and the logarithm of a large cot a.
  detail::Constants constants{{{"hold_rounds", 8}, {"largest", 28}}, {}};
#define CONTACT_NAMED(name) constants.numbers[#name] = double(law.name);
  CONTACT_BALL_NUMBERS(CONTACT_NAMED, CONTACT_NAMED)
#undef CONTACT_NAMED
  std::string numbers;
  for (const double x : law.table) {
    numbers += (numbers.empty() ? "" : ", ") + detail::real_text(x);
  }
  const auto formula = [&](std::string_view text) {
    return printed(text, constants, in);
  };
  std::string code(in.ball);
  for (const auto& [word, by] :
       {std::pair("TABLE", numbers),
        {"{FRICTION}", formula(CONTACT_TEXT_OF(CONTACT_BALL_FRICTION))},
        {"{HOLD}", formula(CONTACT_TEXT_OF(CONTACT_BALL_HOLD))},
        {"{GRADIENT}", formula(CONTACT_TEXT_OF(CONTACT_BALL_GRADIENT))},
        {"DM_DR", "X00, X01, X02, X10, X11, X12, X20, X21, X22"},
        {"DM_DW", "W00, W01, W02, W10, W11, W12, W20, W21, W22"}}) {
    code = replaced(std::move(code), word, by);
  }
  return code;
}

std::string pin_code(const PinLoadLaw& law, const Language& in) {
  const std::regex f_given("@([^@]*)@");
  const bool has_f = law.form != PinLoadLaw::Form::adhesion;
  return replaced(
      std::regex_replace(std::string(in.pin), f_given, has_f ? "$1" : ""),
      "{MOMENT}",
      printed(detail::pin_formula(law), detail::pin_constants(law), in));
}

}  // namespace

LoadLawText load_law_text(const Joint& joint, const LoadLawOptions& o) {
  const Language& in = detail::language(o.language);
  check_name(o.name);
  const double f0 = detail::dry_friction(joint).coefficient();
  LoadLawText text;
  std::string about = heading(joint, o, in);
  std::string code(in.prelude);
  const auto take = [&](const auto& law, const std::string& comment,
                        const std::string& function) {
    text.error = law.error;
    text.float_error = law.float_error;
    about += comment;
    code += function;
  };
  if (joint.is_pin()) {
    const PinLoadLaw law = pin_load_law(joint, o.error, o.loads);
    take(law, pin_comment(law, f0), pin_code(law, in));
  } else {
    if (in.ball.empty()) {
      throw Error(detail::must_be(
          fmt::format("the language {} of a ball's load law", in.name),
          "one that has loops and vectors: c, cuda, glsl, jax, js or numpy"));
    }
    const BallLaw law = detail::ball_load_law(joint, o);
    take(law, ball_comment(law, f0, detail::most_friction(joint)),
         ball_code(law, in));
  }
  about.pop_back();
  text.text =
      std::string(in.comment) +
      replaced(about, "\n", fmt::format("\n{}", in.comment)) + '\n' +
      replaced(replaced(code, "F0", detail::real_text(f0)), "NAME", o.name);
  return text;
}

}  // namespace contact
