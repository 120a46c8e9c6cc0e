#!/usr/bin/env bash
# The page libcontact/docs/reference/speed.md, from the benchmarks:
#   scripts/speed_page.sh BUILD_DIR [REPETITIONS]
# builds and runs them, repetitions (21) interleaved at random, and puts the
# least time of each into scripts/speed.md.in: {NAME} is a benchmark's time in ns,
# {NAME#COUNTER} a counter of it, {X : Y} a ratio of two of those or of a number
# and one of them; "-" stands for times that could not be measured.
set -euo pipefail
unset CDPATH
if [ $# -lt 1 ] || [ $# -gt 2 ]; then
  sed -n '2,8s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
build=$(cd "$1" && pwd)
repetitions=${2:-21}
cd "$(dirname "$0")/.."
results=$(mktemp)
trap 'rm -f "$results"' EXIT

# Adds lines "PROGRAM/BENCHMARK#COUNTER VALUE", one for each repetition of what
# the page names.
measure() { # PROGRAM
  local names
  names=$(grep -ohE "[{ ]$1/[^ #}]+" scripts/speed.md.in |
    sed "s,^.$1/,," | sort -u | paste -sd '|')
  cmake --build "$build" --target "$1_bench" >&2
  "$build/bench/$1_bench" --benchmark_filter="^($names)\$" \
    --benchmark_repetitions="$repetitions" --benchmark_min_time=0.02 \
    --benchmark_enable_random_interleaving=true --benchmark_format=json |
    awk -F '"' -v program="$1" '
      function put(column, value) {print program "/" name "#" column, value}
      $2 == "name" {name = $4}
      $2 == "run_type" {is_measured = $4 == "iteration"}
      $2 == "cpu_time" {time = substr($3, 3) + 0}
      $2 == "time_unit" && is_measured {
        put("ns", time * ($4 == "ms" ? 1e6 : $4 == "us" ? 1e3 : 1))
        is_counter = 1
        next
      }
      /}/ {is_counter = 0}
      is_counter {put($2, substr($3, 3) + 0)}' >>"$results"
}

for program in friction pressure half_angle conforming joint duty finite_pin multibody separation; do
  measure $program
done

awk -v repetitions="$repetitions" \
  -v date="$(date +%Y-%m-%d)" \
  -v processor="$(sed -n 's/^model name\s*: //p' /proc/cpuinfo | head -1)" \
  -v compiler="$("$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' \
    "$build/CMakeCache.txt")" --version | head -1)" '
  # Significant digits; as many decimals below 1.
  function show(x, digits, unit) {
    for (unit = 1; unit * 10 ^ digits <= x; unit *= 10) {}
    if (unit > 1) return sprintf("%.0f", int(x / unit + 0.5) * unit)
    for (unit = 1; unit <= x; unit *= 10) --digits
    return sprintf("%." digits "f", x)
  }
  function value(name) {
    if (name ~ /^[0-9.e-]+$/) return name + 0
    if (name !~ /#/) name = name "#ns"
    return name in least ? least[name] : "-"
  }
  function expanded(name, pair) {
    if (name in word) return word[name]
    if (split(name, pair, " : ") == 1) {
      pair[2] = value(name)
      if (pair[2] == "-" || name ~ /#/ && pair[2] == int(pair[2])) return pair[2]
      return show(pair[2], 3)
    }
    if (value(pair[1]) == "-" || value(pair[2]) == "-") return "-"
    return show(value(pair[1]) / value(pair[2]), 2)
  }
  BEGIN {
    word["repetitions"] = repetitions
    word["date"] = date
    word["processor"] = processor
    word["compiler"] = compiler
  }
  FNR == NR {
    if (!($1 in least) || $2 < least[$1]) least[$1] = $2
    next
  }
  {
    rest = $0
    line = ""
    while (match(rest, /[{][^}]*[}]/)) {
      line = line substr(rest, 1, RSTART - 1) \
        expanded(substr(rest, RSTART + 1, RLENGTH - 2))
      rest = substr(rest, RSTART + RLENGTH)
    }
    print line rest
  }' "$results" scripts/speed.md.in >libcontact/docs/reference/speed.md
