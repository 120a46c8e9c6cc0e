#include <fmt/format.h>

#include <cctype>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/load_law/ball.hpp"
#include "libcontact/load_law/languages.hpp"
#include "libcontact/load_law/load_law.hpp"
#include "libcontact/load_law/minimax.hpp"
#include "libcontact/load_law/pin_formula.hpp"
#include "libcontact/version.hpp"

namespace contact {
namespace {

using detail::Language;

void check_name(const std::string& name) {
  const bool is_word = !name.empty() && name.size() <= 60 &&
                       std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
                       name.find_first_not_of(
                           "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWX"
                           "YZ0123456789_") == std::string::npos;
  if (!is_word) {
    throw Error(detail::must_be(
        "the name " + detail::printable(name) + " of a function",
        "a letter and then letters, digits and _"));
  }
}

// f0 of dry friction, else 0: of other laws the caller knows f.
double coefficient_of(const Joint& joint) {
  const auto* dry = std::get_if<FrictionLaw>(&joint.contact().friction());
  return dry == nullptr ? 0 : dry->coefficient();
}

std::string comment(const std::string& lines, const Language& in) {
  std::string text;
  std::size_t at = 0;
  while (at < lines.size()) {
    const std::size_t end = lines.find('\n', at);
    text += fmt::format("{}{}\n", in.comment, lines.substr(at, end - at));
    at = end + 1;
  }
  return text;
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

// Without the coefficient, which is that of the file.
std::string without_coefficient(std::string_view open) {
  std::string text(open);
  for (const char* f :
       {", KREAL f", ", f = F0", ", f=F0", ", float f", ", f"}) {
    text = detail::replaced(std::move(text), f, "");
  }
  return text;
}

std::string pin_comment(const Joint& pin, const PinLoadLaw& law) {
  const std::string f =
      law.form == PinLoadLaw::Form::adhesion
          ? fmt::format(
                "Coefficient of friction {} and adhesion are those of the "
                "joint. Outside of\nthese loads M is proportional to R.\n",
                coefficient_of(pin))
          : "f: coefficient of friction at this speed.\n";
  return fmt::format(
      "Largest error over M: {:.1e} in double, {:.1e} in float, at radial "
      "loads "
      "from {:.3g}\nto {:.3g} N. {} numbers.\n"
      "load: R, N, the part of the reaction normal to the axis, 0 or above.\n{}"
      "moment: M, N m, which resists while the joint turns, and up to which it "
      "holds\nat rest. slope, dM: dM/dR, m.\n"
      "Left out: ends and tilt of the pin, grease, temperature.\n",
      law.error, law.float_error, law.loads.first, law.loads.second,
      law.numbers.size(), f);
}

std::string ball_comment(const Joint& ball, const detail::BallLoadLaw& of) {
  return fmt::format(
      "Largest error over |M|, vectors: {:.1e} in double, {:.1e} in float, at "
      "reactions from {:.6g}\nto {:.6g} N in all directions. {} numbers.\n"
      "R: reaction on the body, N; w: angular velocity of the body against the "
      "carrier,\nrad/s; both in one frame. The {} has the ball.\nf: "
      "coefficient of "
      "friction, at most {}; errors are those with {}, the joint's.\n"
      "M: friction moment on the body about the centre, N m; normal force, N. "
      "The flag is 1 for\nreactions outside, at which M is proportional to R; "
      "2 for R = 0 or w = 0, where M = 0;\n4 for NaN; else 0.\n"
      "At rest _hold() says which share of what it holds friction has to "
      "supply, with m the\nmoment on the body, N m: it rests up to 1.\n"
      "_gradient() has dM/dR, m, and dM/dw, N m s, row by row: 99 of 100 "
      "states to 20 times\nthe error of M, at the rim to 300 times.\n"
      "Left out: rims and relief of the seat, grease, temperature.\n",
      of.error, of.float_error, of.law.low, of.law.high, of.law.table.size(),
      of.law.side > 0 ? "carrier" : "body", detail::most_friction(ball),
      coefficient_of(ball));
}

void check_loops(const Language& in) {
  if (!in.table.empty()) return;
  throw Error(detail::must_be(
      fmt::format("the language {} of a ball's load law", in.name),
      "one that has loops and vectors: c, cuda, glsl, jax, js or numpy"));
}

// Names the parts of both derivatives.
std::string matrices(std::string code) {
  for (const char letter : {'X', 'W'}) {
    std::string parts;
    for (int i = 0; i < 9; ++i)
      parts += fmt::format("{}{}{}{}", i ? ", " : "", letter, i / 3, i % 3);
    code = detail::replaced(std::move(code), letter == 'X' ? "DM_DR" : "DM_DW",
                            parts);
  }
  return code;
}

std::string ball_code(const detail::BallLaw<double>& law, const Language& in) {
  std::string numbers;
  for (const double x : law.table) {
    numbers += (numbers.empty() ? "" : ", ") + detail::real_text(x);
  }
  const detail::Constants constants = detail::ball_constants(law);
  return detail::replaced(std::string(in.table), "TABLE", numbers) +
         detail::written(detail::ball_friction_formula, constants, in,
                         in.ball) +
         detail::written(detail::ball_hold_formula, constants, in, in.hold) +
         matrices(detail::written(detail::ball_gradient_formula, constants, in,
                                  in.gradient));
}

std::string pin_code(const PinLoadLaw& law, const Language& in) {
  const std::string open = law.form == PinLoadLaw::Form::adhesion
                               ? without_coefficient(in.pin.open)
                               : std::string(in.pin.open);
  return detail::written(detail::pin_formula(law), detail::pin_constants(law),
                         in, {open, in.pin.close});
}

}  // namespace

LoadLawText load_law_text(const Joint& joint, const LoadLawOptions& o) {
  const Language& in = detail::language(o.language);
  check_name(o.name);
  detail::check_endless(joint);
  LoadLawText law;
  std::string about = heading(joint, o, in);
  std::string code(in.prelude);
  if (joint.is_pin()) {
    const PinLoadLaw pin = pin_load_law(joint, o.error, o.loads);
    law = {"", pin.error, pin.float_error};
    about += pin_comment(joint, pin);
    code += pin_code(pin, in);
  } else {
    check_loops(in);
    const detail::BallLoadLaw ball = detail::ball_load_law(joint, o);
    law = {"", ball.error, ball.float_error};
    about += ball_comment(joint, ball);
    code += ball_code(ball.law, in);
  }
  const std::string f0 = detail::real_text(coefficient_of(joint));
  law.text = comment(about, in) +
             detail::replaced(detail::replaced(code, "F0", f0), "NAME", o.name);
  return law;
}

}  // namespace contact
