#!/usr/bin/env bash
# Prints the tables of libcontact/docs/explanation/pressure.md and
# reference/accuracy.md, which compare the pressure laws on contacts and on the
# paper's examples:
#   scripts/pressure_tables.sh BUILD_DIR
# Docs.PressureTables compares them with the pages.
set -euo pipefail
unset CDPATH
if [ $# -ne 1 ]; then
  sed -n '2,6s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
bin=$(cd "$1" && pwd)/bin
cd "$(dirname "$0")/.."

# Percent of the exact pressure's value as cells, a row for each half-angle:
# JOINT RATIO COLUMNS
rows() {
  local loads
  loads=$("$bin/hinge-angle" --joint "$1" --modulus-ratio "$2" --inverse \
    --theta0 5,30,60,80 --law exact 2>/dev/null |
    awk -F, 'NR > 1 {printf("%s%s", NR > 2 ? "," : "", $2)}')
  "$bin/hinge-pressure" --joint "$1" --modulus-ratio "$2" \
    --load-parameter "$loads" --law exact --pressure all --summary |
    awk -F, -v ratio="$2" -v columns="$3" '
      function percent(x) {
        if (x > -0.005 && x < 0.005) return "0"
        return sprintf((x * x < 1 ? "%+.2f" : "%+.1f"), x)
      }
      NR == 1 {
        for (i = 1; i <= NF; ++i) at[$i] = i
        n = split(columns, names, " ")
        next
      }
      {
        for (i = 1; i <= n; ++i) value[$at["pressure"], i] = $at[names[i]]
        if ($at["pressure"] != "exact") next
        printf "| %s | %.0f |", ratio == "inf" ? "infinity" : ratio,
          $at["theta0_deg"]
        split("cosine sqrt_tan sqrt_theta mixture", laws, " ")
        for (l = 1; l <= 4; ++l) {
          for (i = 1; i <= n; ++i) {
            printf("%s %s", i > 1 ? " /" : "",
              percent(100 * (value[laws[l], i] / value["exact", i] - 1)))
          }
          printf " |"
        }
        print ""
      }'
}

head='| Ebar | theta0, deg | cosine | sqrt_tan | sqrt_theta | mixture |
|---|---|---|---|---|---|'
echo "Balls, S / peak / chi / sigma_Y / sigma_Z:"
echo
echo "$head"
for ratio in 0 1 inf; do
  rows ball $ratio "S p_peak_over_nominal chi_0 sigma_Y_0 sigma_Z_90"
done
echo
echo "Pins, S / peak:"
echo
echo "$head"
for ratio in 0 1 inf; do
  rows pin $ratio "S p_peak_over_nominal"
done

# One column of one answer: COLUMN OPTIONS...
value() {
  local name=$1
  shift
  "$bin/hinge-joint" "$@" --format csv 2>/dev/null |
    awk -F, -v name="$name" '
      NR == 1 {for (i = 1; i <= NF; ++i) if ($i == name) at = i}
      END {print $at}'
}
example_1=(--joint data/joints/paper_example_1.toml)
example_2=(--joint data/joints/paper_example_2.toml --joints 2
  --reaction-xyz "1.122e6,3.23e5,0" --rate-xyz "0,0,1" --outer "0,-0.026,0")
sliding=(--reaction 2.6261e5 --beta 67.618)
spinning=(--normal-force 2e5 --alpha 90)
echo
echo "Paper's examples:"
echo
echo "| half-angle law, pressure | example 1: M_t, N m | peak, MPa \
| spinning, N m | without adhesion | example 2: M, N m |"
echo "|---|---|---|---|---|---|"
for laws in tanh,cosine tanh,exact exact,cosine exact,exact; do
  by=(--law "${laws%,*}" --pressure "${laws#*,}")
  moment=$(value M_t_N_m "${example_1[@]}" "${by[@]}" "${sliding[@]}")
  peak=$(value p_peak_Pa "${example_1[@]}" "${by[@]}" "${sliding[@]}")
  outer=$(value M_N_m "${example_2[@]}" "${by[@]}")
  spin=$(value M_t_N_m "${example_1[@]}" "${by[@]}" "${spinning[@]}")
  dry=$(value M_t_N_m "${example_1[@]}" "${by[@]}" "${spinning[@]}" \
    --friction 0.1)
  awk -v laws="${laws/,/, }" -v m="$moment" -v p="$peak" -v o="$outer" \
    -v s="$spin" -v d="$dry" 'BEGIN {
      printf "| %s | %.1f | %.1f | %.0f | %.1f | %.0f |\n",
        laws, m, p / 1e6, s, d, o
    }'
done
