#!/usr/bin/env bash
# Redraws figures 3, 4, 5, 8 and 9 of the paper from the programs' output:
#   plots/figures.sh BUILD_DIR OUTPUT_DIR
# leaves figureN.svg, figureN.png and the tables they show, as CSV.
set -euo pipefail
if [ $# -ne 2 ]; then
  sed -n '2,4s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
plots=$(cd "$(dirname "$0")" && pwd)
programs=$(cd "$1/bin" && pwd)
mkdir -p "$2"
cd "$2"
if ! command -v gnuplot >/dev/null; then
  echo "figures.sh: gnuplot is not installed, no figures" >&2
  exit 1
fi

# Figure 3: limit half-angle against the modulus ratio, 10^-2 to 10^2 in 81
# steps, and the short form where it holds.
limit() { # FORM RATIO
  "$programs/hinge-angle" --joint cylinder --modulus-ratio "$2" \
    --limit-angle "$1" --law tanh --x inf | tail -n 1 | cut -d, -f3
}
{
  echo modulus_ratio,theta0_limit_formula_deg,theta0_limit_linear_deg
  for i in {-40..40}; do
    ratio=$(awk -v i="$i" 'BEGIN { printf "%.9g", 10^(i / 20) }')
    linear=
    # 10^(6/20) is the last of them below 2.
    [ "${i#-}" -le 6 ] && linear=$(limit linear "$ratio")
    echo "$ratio,$(limit formula "$ratio"),$linear"
  done
} >figure3.csv
echo "rigid_seat_deg,rigid_pin_deg
$(limit formula 0),$(limit formula inf)" >figure3_ends.csv

# Figures 4 and 5: half-angle laws of a pin (equal materials) and of a ball
# in a rigid seat, with the exact solutions of the reference tables.
laws=hertz,arctan,tanh,blend:0.5
"$programs/hinge-angle" --joint cylinder --modulus-ratio 1 --law $laws \
  --limit-angle 84.85 --load-parameter 0:1:0.0025 --output figure4.csv \
  2>figure4.log
"$programs/hinge-angle" --joint sphere --modulus-ratio 0 --law $laws \
  --limit-angle 92.5 --load-parameter 0:4:0.01 --output figure5.csv \
  2>figure5.log
exact() { # FILE MODULUS_RATIO LARGEST_LOAD
  echo load_parameter,theta0_deg
  awk -F, -v ratio="$2" -v most="$3" \
    '!/^#/ && $1 + 0 == ratio && $2 >= most / 200 && $2 <= most {
      print $2 "," $3 }' "$plots/../data/reference/conforming/$1"
}
exact cylinder_theta0.csv 1 1 >figure4_exact.csv
exact sphere_theta0.csv 0 4 >figure5_exact.csv

# Figures 8 and 9: coefficients and area integrals against the slip axis
# angle, exact and by the planar sliding-spinning model.
for method in exact planar; do
  "$programs/hinge-table" --theta0 20:80:20 --alpha 0:90:1 \
    --method $method --output figure8_$method.csv
done

for figure in 3 4 5 8 9; do
  wide=0
  [ $figure -ge 8 ] && wide=1
  if [ $wide -eq 1 ]; then
    svg="size 1260,460 font 'sans,17'" png="size 2100,766 font 'sans,22'"
  else
    svg="size 840,560 font 'sans,19'" png="size 1260,840 font 'sans,21'"
  fi
  gnuplot -e "set terminal svg $svg rounded linewidth 1.2 background 'white'" \
    -e "set output 'figure$figure.svg'; plots = '$plots'" \
    "$plots/style.gp" "$plots/figure$figure.gp"
  gnuplot -e "set terminal pngcairo $png rounded linewidth 1.7" \
    -e "set output 'figure$figure.png'; plots = '$plots'" \
    "$plots/style.gp" "$plots/figure$figure.gp"
done
