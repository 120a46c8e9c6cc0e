#include "libcontact/load_law/languages.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace contact::detail {
namespace {

constexpr std::string_view c_loop = "for (int {0} = 0; {0} < {1}; ++{0}) {{";

// clang-format off
constexpr Notation c_notation = {
    "{0}", "(KREAL){0}", "KREAL {0};", "{0} = {1};", "{0} ? {1} : {2}",
    "{0}[{1}]", c_loop, "}", "if ({0}) break;",
    {"sqrt", "log", "fabs", "exp", "NAME_poly"}};
constexpr Notation glsl_notation = {
    "{0}.0", "{0}", "float {0};", "{0} = {1};", "{0} ? {1} : {2}",
    "{0}[{1}]", c_loop, "}", "if ({0}) break;",
    {"sqrt", "log", "abs", "exp", "NAME_poly"}};
constexpr Notation js_notation = {
    "{0}", "{0}", "let {0};", "{0} = {1};", "{0} ? {1} : {2}",
    "{0}[{1}]", "for (let {0} = 0; {0} < {1}; ++{0}) {{", "}", "if ({0}) break;",
    {"Math.sqrt", "Math.log", "Math.abs", "Math.exp", "NAME_poly"}};
constexpr Notation python_notation = {
    "{0}", "{0}", "", "{0} = {1}", "xp.where({0}, {1}, {2})",
    "{0}[..., {1}]", "for {0} in range({1}):", "", "",
    {"xp.sqrt", "xp.log", "xp.abs", "xp.exp", "NAME_poly"}};
constexpr Notation st_notation = {
    "{0}.0", "{0}", "VAR {0} : LREAL; END_VAR", "{0} := {1};", "SEL({0}, {2}, {1})",
    "", "", "", "",
    {"SQRT", "LN", "ABS", "EXP", ""}};
// clang-format on

constexpr std::string_view c_pin = R"(
KDEF KREAL NAME(KREAL load@, KREAL f@, KREAL *dM) {
{MOMENT}  if (dM) *dM = slope;
  return moment;
}
)";

constexpr std::string_view c_ball = R"(
KDEF KREAL NAME_poly(KREAL first, KREAL count, KREAL x) {
  static const KREAL c[] = {TABLE};
  KREAL sum = 0;
  for (int i = (int)count - 1; i >= 0; --i) sum = sum * x + c[(int)first + i];
  return sum;
}
KDEF int NAME(const KREAL R[3], const KREAL w[3], KREAL f, KREAL M[3],
                KREAL *normal_force) {
{FRICTION}  M[0] = M0; M[1] = M1; M[2] = M2;
  if (normal_force) *normal_force = normal;
  return (int)flag;
}
KDEF KREAL NAME_hold(const KREAL R[3], const KREAL m[3], KREAL f) {
{HOLD}  return used;
}
KDEF int NAME_gradient(const KREAL R[3], const KREAL w[3], KREAL f,
    KREAL dM_dR[9], KREAL dM_dw[9]) {
{GRADIENT}  const KREAL r9[] = {DM_DR}, w9[] = {DM_DW};
  for (int i = 0; i < 9; ++i) { dM_dR[i] = r9[i]; dM_dw[i] = w9[i]; }
  return (int)flag;
}
)";

constexpr std::string_view js_pin = R"(export function NAME(load@, f = F0@) {
{MOMENT}  return [moment, slope];
}
)";

constexpr std::string_view js_ball = R"(const NAME_table = [TABLE];
function NAME_poly(first, count, x) {
  let sum = 0;
  for (let i = count - 1; i >= 0; --i) sum = sum * x + NAME_table[first + i];
  return sum;
}
export function NAME(R, w, f = F0) {
{FRICTION}  return [[M0, M1, M2], normal, flag];
}
export function NAME_hold(R, m, f = F0) {
{HOLD}  return used;
}
export function NAME_gradient(R, w, f = F0) {
{GRADIENT}  return [[DM_DR], [DM_DW], flag];
}
)";

constexpr std::string_view python_pin = R"(def NAME(load@, f=F0@):
{MOMENT}    return moment, slope
)";

constexpr std::string_view python_ball = R"(NAME_table = xp.array([TABLE])


def NAME_poly(first, count, x):
    at = xp.asarray(first).astype(int)
    total = 0.0
    for i in range(int(count) - 1, -1, -1):
        total = total * x + NAME_table[at + i]
    return total


def NAME(R, w, f=F0):
{FRICTION}    return xp.stack([M0, M1, M2], -1), normal, flag


def NAME_hold(R, m, f=F0):
{HOLD}    return used


def NAME_gradient(R, w, f=F0):
{GRADIENT}    all = xp.stack(xp.broadcast_arrays(DM_DR, DM_DW), -1)
    all = all.reshape(flag.shape + (2, 3, 3))
    return all[..., 0, :, :], all[..., 1, :, :], flag
)";

constexpr std::string_view glsl_pin =
    R"(float NAME(float load@, float f@, out float dM) {
{MOMENT}  dM = slope;
  return moment;
}
)";

constexpr std::string_view glsl_ball =
    R"(const float NAME_table[] = float[](TABLE);
float NAME_poly(float first, float count, float x) {
  float sum = 0.0;
  for (int i = int(count) - 1; i >= 0; --i)
    sum = sum * x + NAME_table[int(first) + i];
  return sum;
}
int NAME(vec3 R, vec3 w, float f, out vec3 M, out float normal_force) {
{FRICTION}  M = vec3(M0, M1, M2);
  normal_force = normal;
  return int(flag);
}
float NAME_hold(vec3 R, vec3 m, float f) {
{HOLD}  return used;
}
int NAME_gradient(vec3 R, vec3 w, float f, out mat3 dM_dR, out mat3 dM_dw) {
{GRADIENT}  dM_dR = transpose(mat3(DM_DR));
  dM_dw = transpose(mat3(DM_DW));
  return int(flag);
}
)";

constexpr std::string_view st_pin = R"(FUNCTION NAME : LREAL
  VAR_INPUT load@, f@ : LREAL; END_VAR
  VAR_OUTPUT dM : LREAL; END_VAR
{MOMENT}  dM := slope;
  NAME := moment;
END_FUNCTION
)";

#define C_PRELUDE(real, def)           \
  "#ifndef KREAL\n#define KREAL " real \
  "\n#endif\n#ifndef KDEF\n#define KDEF " def "\n#endif"
constexpr Language languages[] = {
    {"c", "// ", "  ", c_notation,
     "#include <math.h>\n" C_PRELUDE("double", "static inline"), c_pin, c_ball,
     true},
    {"cuda", "// ", "  ", c_notation,
     C_PRELUDE("float", "__host__ __device__ static inline"), c_pin, c_ball,
     false},
    {"glsl", "// ", "  ", glsl_notation, "", glsl_pin, glsl_ball, false},
    {"jax", "# ", "    ", python_notation, "import jax.numpy as xp\n\n\n",
     python_pin, python_ball, false},
    {"js", "// ", "  ", js_notation, "", js_pin, js_ball, true},
    {"numpy", "# ", "    ", python_notation, "import numpy as xp\n\n\n",
     python_pin, python_ball, true},
    {"st", "// ", "  ", st_notation, "", st_pin, "", false}};

}  // namespace

const Language& language(std::string_view name) {
  const auto found = std::ranges::find(languages, name, &Language::name);
  if (found != std::end(languages)) return *found;
  std::vector<std::string> names;
  for (const Language& one : languages) names.emplace_back(one.name);
  throw Error(unknown("language", name, names));
}

}  // namespace contact::detail
