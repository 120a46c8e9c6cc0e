#!/usr/bin/env bash
# Prints the table of libcontact/docs/how-to/walls_matter.md, which compares
# joints with their walls and with unbounded seats:
#   scripts/walls_table.sh BUILD_DIR
# Docs.WallsTable compares it with the page.
set -euo pipefail
unset CDPATH
if [ $# -ne 1 ]; then
  sed -n '2,5s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
bin=$(cd "$1" && pwd)/bin
cd "$(dirname "$0")/.."
source scripts/walled_joint.sh
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

# FILE LOAD: the row of hinge-pressure, behind its head
solve() {
  "$bin/hinge-pressure" --joint "$1" --load "$2" --summary --law exact \
    --pressure exact 2>/dev/null
}

# TEXT LOAD FILE_WITH_WALLS FILE_WITHOUT
row() {
  { solve "$3" "$2" && solve "$4" "$2"; } | awk -F, -v text="$1" '
    function change(name) {
      return sprintf("%+.0f %%", 100 * (value[4, name] / value[2, name] - 1))
    }
    function both(name, format, unit) {
      return sprintf(format " / " format, value[2, name] / unit,
                     value[4, name] / unit)
    }
    function number(line, name, unit) {
      x = value[line, name]
      return x == "" ? "-" : sprintf("%.3g", x / unit) + 0
    }
    function pair(name, unit) {
      x = number(2, name, unit) " / " number(4, name, unit)
      return x == "- / -" ? "-" : x
    }
    NR == 1 {for (i = 1; i <= NF; ++i) names[i] = $i}
    NR % 2 == 0 {for (i = 1; i <= NF; ++i) value[NR, names[i]] = $i}
    END {
      ball = (2, "sigma_Z_90") in value
      printf "| %s | %s (%s) | %s (%s) | %s | %s | %s | %s |\n", text,
        both("theta0_deg", "%.1f", 1), change("theta0_deg"),
        pair("p_peak_Pa", 1e6), change("p_peak_Pa"), both("S", "%.3f", 1),
        ball ? both("sigma_Z_90", "%.3f", 1) : "-", pair("approach_m", 1e-6),
        pair("stiffness_N_per_m", ball ? 1e6 : 1e9)
    }'
}

cd "$work"
cocr="230 0.3" steel="210 0.3" ptfe="1 0.42" bronze="110 0.34"
hip() { walled_joint "$1.toml" ball 14 100 "$cocr" "${@:2}"; }
hip pe "1 0.4"
hip pe_shell "1 0.4" rigid 8
hip pe46 "1 0.46"
hip pe46_shell "1 0.46" rigid 8
hip pe_bone "1 0.4" "1 0.3" 8 "2 110 0.3"
liner() { walled_joint "$1.toml" ball 25 25 "$steel" "${@:2}"; }
liner ptfe "$ptfe"
liner steel "$steel"
liner ptfe_steel "$ptfe" "$steel" 0.4
liner ptfe_ring "$ptfe" held 0.4 "8 $steel"
bush() { walled_joint "$1.toml" pin 25 25 "$steel" "$bronze" "${@:2}"; }
bush bronze
bush bronze_steel "$steel" 5
bush bronze_housing held 5 "25 $steel"
bush bronze_cast_iron held 5 "10 110 0.26"

echo "| joint, load | half-angle, deg | peak, MPa | S | sigma_Z | approach, um | \
stiffness, kN/mm |"
echo "|---|---|---|---|---|---|---|"
row "hip, 8 mm of polyethylene in a rigid shell, 2 kN" 2e3 pe_shell.toml pe.toml
row "same, nu = 0.46" 2e3 pe46_shell.toml pe46.toml
row "hip in a titanium shell of 2 mm in bone" 2e3 pe_bone.toml pe.toml
row "PTFE of 0.4 mm on steel, 20 kN" 2e4 ptfe_steel.toml ptfe.toml
row "same beside a seat of steel" 2e4 ptfe_steel.toml steel.toml
row "same, 100 kN" 1e5 ptfe_steel.toml ptfe.toml
row "same, 100 kN, beside a seat of steel" 1e5 ptfe_steel.toml steel.toml
row "PTFE in a free ring of steel, 8 mm, 20 kN" 2e4 ptfe_ring.toml ptfe.toml
row "bronze bush of 5 mm in steel, 2 kN/mm" 2e6 bronze_steel.toml bronze.toml
row "same in a free housing of steel, 25 mm" 2e6 bronze_housing.toml bronze.toml
row "same of cast iron, 10 mm" 2e6 bronze_cast_iron.toml bronze.toml
