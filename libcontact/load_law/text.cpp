#include <fmt/format.h>

#include <cctype>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/load_law/languages.hpp"
#include "libcontact/load_law/load_law.hpp"
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

bool has_adhesion(const Joint& joint) {
  const auto* dry = std::get_if<FrictionLaw>(&joint.contact().friction());
  return dry != nullptr && dry->adhesion() > 0;
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
      has_adhesion(pin)
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

}  // namespace

LoadLawText load_law_text(const Joint& joint, const LoadLawOptions& o) {
  const Language& in = detail::language(o.language);
  check_name(o.name);
  const PinLoadLaw law = pin_load_law(joint, o.error, o.loads);
  const std::string open = has_adhesion(joint)
                               ? without_coefficient(in.pin.open)
                               : std::string(in.pin.open);
  const std::string code =
      std::string(in.prelude) + detail::written(detail::pin_formula(law),
                                                detail::pin_constants(law), in,
                                                {open, in.pin.close});
  return {comment(heading(joint, o, in) + pin_comment(joint, law), in) +
              detail::replaced(detail::replaced(code, "NAME", o.name), "F0",
                               detail::real_text(coefficient_of(joint))),
          law.error, law.float_error};
}

}  // namespace contact
