#include "libcontact/load_law/languages.hpp"

#include <algorithm>
#include <vector>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace contact::detail {
namespace {

constexpr Notation c_notation = {
    .whole = "{0}",
    .real = "(KREAL){0}",
    .declared = "KREAL {0};",
    .assigned = "{0} = {1};",
    .choice = "{0} ? {1} : {2}",
    .component = "{0}[{1}]",
    .loop = "for (int {0} = 0; {0} < {1}; ++{0}) {{",
    .end = "}",
    .leave = "if ({0}) break;",
    .functions = {"sqrt", "log", "fabs", "exp"}};

constexpr Notation js_notation = [] {
  Notation js = c_notation;
  js.real = "{0}";
  js.declared = "let {0};";
  js.loop = "for (let {0} = 0; {0} < {1}; ++{0}) {{";
  js.functions = {"Math.sqrt", "Math.log", "Math.abs", "Math.exp"};
  return js;
}();

constexpr Notation glsl_notation = [] {
  Notation glsl = c_notation;
  glsl.whole = "{0}.0";
  glsl.real = "{0}";
  glsl.declared = "float {0};";
  glsl.functions[2] = "abs";
  return glsl;
}();

constexpr Notation python_notation = {
    .whole = "{0}",
    .real = "{0}",
    .declared = "",
    .assigned = "{0} = {1}",
    .choice = "xp.where({0}, {1}, {2})",
    .component = "{0}[..., {1}]",
    .loop = "for {0} in range({1}):",
    .end = "",
    .leave = "",
    .functions = {"xp.sqrt", "xp.log", "xp.abs", "xp.exp"}};

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
                                  .functions = {"SQRT", "LN", "ABS", "EXP"}};

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
    .table = R"(KDEF KREAL NAME_poly(KREAL first, KREAL count, KREAL x) {
  static const KREAL c[] = {TABLE};
  KREAL sum = 0;
  for (int i = (int)count - 1; i >= 0; --i) sum = sum * x + c[(int)first + i];
  return sum;
}
)",
    .pin = {"KDEF KREAL NAME(KREAL load, KREAL f, KREAL *dM) {",
            "  if (dM) *dM = slope;\n  return moment;\n}"},
    .ball = {"KDEF int NAME(const KREAL R[3], const KREAL w[3], KREAL f, "
             "KREAL M[3],\n                KREAL *normal_force) {",
             "  M[0] = M0;\n  M[1] = M1;\n  M[2] = M2;\n"
             "  if (normal_force) *normal_force = normal;\n"
             "  return (int)flag;\n}"},
    .hold = {"KDEF KREAL NAME_hold(const KREAL R[3], const KREAL m[3], "
             "KREAL f) {",
             "  return used;\n}"},
    .gradient = {"KDEF int NAME_gradient(const KREAL R[3], const KREAL w[3], "
                 "KREAL f,\n    KREAL dM_dR[9], KREAL dM_dw[9]) {",
                 "  const KREAL r9[] = {DM_DR};\n"
                 "  const KREAL w9[] = {DM_DW};\n"
                 "  for (int i = 0; i < 9; ++i) {\n"
                 "    dM_dR[i] = r9[i];\n    dM_dw[i] = w9[i];\n  }\n"
                 "  return (int)flag;\n}"},
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

constexpr Language js = {
    .name = "js",
    .comment = "// ",
    .indent = "  ",
    .notation = js_notation,
    .prelude = "",
    .table = R"(const NAME_table = [TABLE];
function NAME_poly(first, count, x) {
  let sum = 0;
  for (let i = count - 1; i >= 0; --i) sum = sum * x + NAME_table[first + i];
  return sum;
}
)",
    .pin = {"export function NAME(load, f = F0) {",
            "  return [moment, slope];\n}"},
    .ball = {"export function NAME(R, w, f = F0) {",
             "  return [[M0, M1, M2], normal, flag];\n}"},
    .hold = {"export function NAME_hold(R, m, f = F0) {", "  return used;\n}"},
    .gradient = {"export function NAME_gradient(R, w, f = F0) {",
                 "  return [[DM_DR], [DM_DW], flag];\n}"},
    .was_run = true};

constexpr Language numpy = {
    .name = "numpy",
    .comment = "# ",
    .indent = "    ",
    .notation = python_notation,
    .prelude = "import numpy as xp\n\n\n",
    .table = R"(NAME_table = xp.array([TABLE])


def NAME_poly(first, count, x):
    at = xp.asarray(first).astype(int)
    total = 0.0
    for i in range(int(count) - 1, -1, -1):
        total = total * x + NAME_table[at + i]
    return total


)",
    .pin = {"def NAME(load, f=F0):", "    return moment, slope"},
    .ball = {"def NAME(R, w, f=F0):",
             "    return xp.stack([M0, M1, M2], -1), normal, flag\n\n"},
    .hold = {"def NAME_hold(R, m, f=F0):", "    return used\n\n"},
    .gradient = {"def NAME_gradient(R, w, f=F0):",
                 "    all = xp.stack(xp.broadcast_arrays(DM_DR, DM_DW), -1)\n"
                 "    all = all.reshape(flag.shape + (2, 3, 3))\n"
                 "    return all[..., 0, :, :], all[..., 1, :, :], flag"},
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
    .table = R"(const float NAME_table[] = float[](TABLE);
float NAME_poly(float first, float count, float x) {
  float sum = 0.0;
  for (int i = int(count) - 1; i >= 0; --i)
    sum = sum * x + NAME_table[int(first) + i];
  return sum;
}
)",
    .pin = {"float NAME(float load, float f, out float dM) {",
            "  dM = slope;\n  return moment;\n}"},
    .ball = {"int NAME(vec3 R, vec3 w, float f, out vec3 M, "
             "out float normal_force) {",
             "  M = vec3(M0, M1, M2);\n  normal_force = normal;\n"
             "  return int(flag);\n}"},
    .hold = {"float NAME_hold(vec3 R, vec3 m, float f) {", "  return used;\n}"},
    .gradient = {"int NAME_gradient(vec3 R, vec3 w, float f, out mat3 dM_dR, "
                 "out mat3 dM_dw) {",
                 "  dM_dR = transpose(mat3(DM_DR));\n"
                 "  dM_dw = transpose(mat3(DM_DW));\n  return int(flag);\n}"}};

constexpr Language st = {
    .name = "st",
    .comment = "// ",
    .indent = "  ",
    .notation = st_notation,
    .prelude = "",
    .table = "",
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
