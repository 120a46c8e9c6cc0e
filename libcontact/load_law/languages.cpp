#include "libcontact/load_law/languages.hpp"

#include <algorithm>
#include <vector>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace contact::detail {
namespace {

constexpr Notation c_notation = {.whole = "{0}",
                                 .real = "(KREAL){0}",
                                 .declared = "KREAL {0};",
                                 .assigned = "{0} = {1};",
                                 .choice = "{0} ? {1} : {2}",
                                 .component = "{0}[{1}]",
                                 .loop = "for (int i = 0; i < {0}; ++i) {{",
                                 .end = "}",
                                 .leave = "if ({0}) break;",
                                 .sqrt = "sqrt",
                                 .log = "log",
                                 .abs = "fabs",
                                 .exp = "exp"};

constexpr Notation js_notation = [] {
  Notation js = c_notation;
  js.real = "{0}";
  js.declared = "let {0};";
  js.loop = "for (let i = 0; i < {0}; ++i) {{";
  js.sqrt = "Math.sqrt";
  js.log = "Math.log";
  js.abs = "Math.abs";
  js.exp = "Math.exp";
  return js;
}();

constexpr Notation glsl_notation = [] {
  Notation glsl = c_notation;
  glsl.whole = "{0}.0";
  glsl.real = "{0}";
  glsl.declared = "float {0};";
  glsl.abs = "abs";
  return glsl;
}();

constexpr Notation python_notation = {.whole = "{0}",
                                      .real = "{0}",
                                      .declared = "",
                                      .assigned = "{0} = {1}",
                                      .choice = "xp.where({0}, {1}, {2})",
                                      .component = "{0}[..., {1}]",
                                      .loop = "for _ in range({0}):",
                                      .end = "",
                                      .leave = "",
                                      .sqrt = "xp.sqrt",
                                      .log = "xp.log",
                                      .abs = "xp.abs",
                                      .exp = "xp.exp"};

// There are no loops for pins.
constexpr Notation st_notation = {.whole = "{0}.0",
                                  .real = "{0}",
                                  .declared = "VAR {0} : LREAL; END_VAR",
                                  .assigned = "{0} := {1};",
                                  .choice = "SEL({0}, {2}, {1})",
                                  .component = "{0}[{1}]",
                                  .loop = "",
                                  .end = "",
                                  .leave = "",
                                  .sqrt = "SQRT",
                                  .log = "LN",
                                  .abs = "ABS",
                                  .exp = "EXP"};

constexpr Language c = {
    .name = "c",
    .comment = "// ",
    .indent = "  ",
    .notation = c_notation,
    .prelude = R"(#include <math.h>
#ifndef KREAL
#define KREAL double
#endif
#ifndef KDEF
#define KDEF static inline
#endif
)",
    .pin = {"KDEF KREAL NAME(KREAL load, KREAL f, KREAL *dM) {",
            "  if (dM) *dM = slope;\n  return moment;\n}"},
    .was_run = true};

constexpr Language cuda = [] {
  Language language = c;
  language.name = "cuda";
  language.prelude = R"(#ifndef KREAL
#define KREAL float
#endif
#ifndef KDEF
#define KDEF __host__ __device__ static inline
#endif
)";
  language.was_run = false;
  return language;
}();

constexpr Language js = {.name = "js",
                         .comment = "// ",
                         .indent = "  ",
                         .notation = js_notation,
                         .prelude = "",
                         .pin = {"export function NAME(load, f = F0) {",
                                 "  return [moment, slope];\n}"},
                         .was_run = true};

constexpr Language numpy = {
    .name = "numpy",
    .comment = "# ",
    .indent = "    ",
    .notation = python_notation,
    .prelude = "import numpy as xp\n\n\n",
    .pin = {"def NAME(load, f=F0):", "    return moment, slope"},
    .was_run = true};

constexpr Language jax = [] {
  Language language = numpy;
  language.name = "jax";
  language.prelude = "import jax.numpy as xp\n\n\n";
  language.was_run = false;
  return language;
}();

constexpr Language glsl = {
    .name = "glsl",
    .comment = "// ",
    .indent = "  ",
    .notation = glsl_notation,
    .prelude = "",
    .pin = {"float NAME(float load, float f, out float dM) {",
            "  dM = slope;\n  return moment;\n}"}};

constexpr Language st = {
    .name = "st",
    .comment = "// ",
    .indent = "  ",
    .notation = st_notation,
    .prelude = "",
    .pin = {"FUNCTION NAME : LREAL\n  VAR_INPUT load, f : LREAL; END_VAR\n"
            "  VAR_OUTPUT dM : LREAL; END_VAR",
            "  dM := slope;\n  NAME := moment;\nEND_FUNCTION"}};

constexpr const Language* languages[] = {&c,  &cuda,  &glsl, &jax,
                                         &js, &numpy, &st};

}  // namespace

const Language& language(std::string_view name) {
  const auto found = std::ranges::find(
      languages, name, [](const Language* one) { return one->name; });
  if (found != std::end(languages)) return **found;
  std::vector<std::string> names;
  for (const Language* one : languages) names.emplace_back(one->name);
  throw Error(unknown("language", name, names));
}

std::string written(std::string_view formula, const Constants& constants,
                    const Language& in, const Function& as) {
  return std::string(as.open) + '\n' +
         printed(formula, constants, in.notation, in.indent) +
         std::string(as.close) + '\n';
}

}  // namespace contact::detail
