#!/usr/bin/env bash
# Prints the tables of libcontact/docs/explanation/half_angle.md: the largest
# errors of the half-angle laws against the exact contact.
#   scripts/law_errors.sh BUILD_DIR
# Load parameters range from 1e-6 to 1e8.
set -euo pipefail
if [ $# -ne 1 ]; then
  sed -n '2,5s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
program=$1/bin/hinge-angle

# Errors in percent as cells: JOINT RATIO NU LAWS
cells() {
  "$program" --compare --joint "$1" --modulus-ratio "$2" --poisson1 "$3" \
    --poisson2 "$3" --law "$4" 2>/dev/null |
    awk -F, 'NR > 1 {
      printf " %s |", $2 < 1e-6 ? "0" : sprintf($2 < 1 ? "%.2g" : "%.1f", $2)
    }'
}

echo "nu1 = nu2 = 0.3:"
for joint in pin ball; do
  echo
  echo "| $joint, Ebar | arctan | tanh | blend:0.5 | fitted |"
  echo "|---|---|---|---|---|"
  for ratio in 0 0.01 0.1 0.5 1 2 10 100 inf; do
    echo "| $ratio |$(cells $joint $ratio 0.3 \
      arctan,tanh,blend:0.5,fitted)"
  done
done
echo
echo "Other Poisson's ratios, of both bodies:"
echo
echo "| joint | nu | Ebar | paper | fitted |"
echo "|---|---|---|---|---|"
for joint in pin ball; do
  for nu in 0.2 0.4 0.49; do
    for ratio in 0 1 inf; do
      echo "| $joint | $nu | $ratio |$(cells $joint $ratio $nu \
        paper,fitted)"
    done
  done
done
