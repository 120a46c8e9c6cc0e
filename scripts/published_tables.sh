#!/usr/bin/env bash
# Prints the tables of libcontact/docs/explanation/against_the_world.md, which
# compare published contacts with libcontact:
#   scripts/published_tables.sh BUILD_DIR
# Docs.PublishedTables compares them with the page.
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
cd "$work"
cocr="230 0.3" polyethylene="1 0.4" bone="0.8 0.3" alumina="380 0.26"

# LOAD: theta0_deg,p_peak_Pa,contact_area_m2 of joint.toml
solve() {
  "$bin/hinge-pressure" --joint joint.toml --load "$1" --law exact \
    --pressure exact --summary \
    --columns theta0_deg,p_peak_Pa,contact_area_m2 | tail -n 1
}
# LOAD: where its peak is, deg
place() {
  "$bin/hinge-pressure" --joint joint.toml --load "$1" --law exact \
    --pressure exact --points 2001 --columns theta_deg,p_exact_Pa |
    awk -F, 'NR > 1 && $2 > peak {peak = $2; at = $1} END {printf "%.1f", at}'
}
# TEXT: the metal hip of joint.toml as a row
metal() {
  solve 3200 | awk -F, -v text="$1" -v place="$(place 3200)" '{
    printf "| %s | %.1f | %.1f | %.0f | %s |\n", text, $1, $2 / 1e6, $3 * 1e6,
      place
  }'
}
durom() { walled_joint joint.toml ball 25 72.5 "$@"; }
metasul() { walled_joint joint.toml ball 14 60 "$cocr" "$cocr" "$@"; }

echo "Metal on metal, 3200 N:"
echo
echo "| hip | half-angle, deg | peak, MPa | area, mm2 | peak at, deg |"
echo "|---|---|---|---|---|"
echo "| DUROM 50 mm, published | - | 22 | 237 | - |"
durom "$cocr" "$cocr"
metal "cup without an end"
durom "$cocr" "$cocr" "$bone" 4
metal "cup of 4 mm in bone"
coating="4 $cocr" durom "$bone" "$cocr" "$bone" 4
metal "the same, head a shell of 4 mm on bone"
echo "| METASUL 28 mm, published | - | 47 | 74 | - |"
metasul
metal "cup without an end"
for inlay in 2 3 4 5 8; do
  metasul "$polyethylene" $inlay
  metal "inlay of $inlay mm in polyethylene"
done

# Columns, p = (eps/k) (cos t/cos theta0 - 1): half-angle and peak at a load.
# RADIUS_mm CLEARANCE_mm THICKNESS_mm E_MPa NU LOAD
column() {
  awk -v r="$1" -v eps="$2" -v t="$3" -v e="$4" -v nu="$5" -v load="$6" 'BEGIN {
    pi = atan2(0, -1)
    k = t * (1 + nu) * (1 - 2 * nu) / (e * (1 - nu))
    low = 0
    high = pi / 2
    for (i = 0; i < 60; ++i) {
      theta = (low + high) / 2
      c = cos(theta)
      if (2 * pi * r * r * eps / k * ((1 - c^3) / (3 * c) - (1 - c * c) / 2) \
          < load) low = theta
      else high = theta
    }
    printf "%.10g,%.10g", theta * 180 / pi, eps / k * (1 / c - 1) * 1e6
  }'
}
echo
echo "Metal on 8 mm of polyethylene in a rigid shell, 2.5 kN:"
echo
echo "| head, mm | radial clearance, mm | half-angle, deg | peak, MPa \
| columns: half-angle | peak |"
echo "|---|---|---|---|---|---|"
echo "| published | - | 40 to 50 | - | worse | good |"
for head in 22.225 28 32; do
  for clearance in 80 100 150; do
    radius=$(awk -v d=$head 'BEGIN {print d / 2}')
    walled_joint joint.toml ball "$radius" $clearance "$cocr" \
      "$polyethylene" rigid 8
    columns=$(column "$radius" 0.${clearance/80/08} 8 1000 0.4 2500)
    echo "$(solve 2500),$columns" |
      awk -F, -v head=$head -v clearance=$clearance '{
        printf "| %s | %.2f | %.1f | %.1f | %+.1f deg | %+.1f %% |\n", head,
          clearance / 1e3, $1, $2 / 1e6, $4 - $1, 100 * ($5 / $2 - 1)
      }'
  done
done

echo
echo "Peak of a 28 mm head over that of a 36 mm head:"
echo
echo "| polyethylene, mm | radial clearance 0.05 mm | 0.1 mm | 0.15 mm |"
echo "|---|---|---|---|"
echo "| 5 to 12, published | 1.30, 1.37 | | |"
for thickness in 5 12; do
  printf '| %s |' $thickness
  for clearance in 50 100 150; do
    for radius in 14 18; do
      walled_joint joint.toml ball $radius $clearance "$cocr" \
        "$polyethylene" rigid $thickness
      solve 2000
    done | awk -F, 'NR == 1 {first = $2} END {printf " %.2f |", first / $2}'
  done
  echo
done

echo
echo "Ceramic on ceramic, against Hertz:"
echo
echo "| insert, mm | radius of the contact | peak |"
echo "|---|---|---|"
echo "| at least 5, published | Hertz usable | Hertz usable |"
for insert in 3 5 8; do
  walled_joint joint.toml ball 14 40 "$alumina" "$alumina" "110 0.3" \
    $insert
  exact=$(solve 2500)
  walled_joint joint.toml ball 14 40 "$alumina" "$alumina"
  "$bin/hinge-angle" --joint joint.toml --load 2500 --law hertz \
    --columns theta0_hertz_deg | tail -n 1 |
    awk -v insert=$insert -v exact="$exact" '{
      pi = atan2(0, -1)
      split(exact, is, ",")
      radius = 14e-3 * $1 * pi / 180
      printf "| %s | %+.1f %% | %+.1f %% |\n", insert,
        100 * (14e-3 * sin(is[1] * pi / 180) / radius - 1),
        100 * (is[2] / (1.5 * 2500 / (pi * radius^2)) - 1)
    }'
done

echo
echo "Friction moment over f R_n times the radius:"
echo
echo "| half-angle, deg | sliding, sigma_Y | spinning, sigma_Z |"
echo "|---|---|---|"
echo "| SKF, published | 1 | 0.7 |"
angles=20,40,60,70
loads=$("$bin/hinge-angle" --joint ball --modulus-ratio 1 --law exact \
  --inverse --theta0 $angles --columns load_parameter_exact | tail -n +2 |
  paste -sd,)
"$bin/hinge-pressure" --joint ball --modulus-ratio 1 --law exact \
  --pressure exact --load-parameter "$loads" --summary \
  --columns theta0_deg,sigma_Y_0,sigma_Z_90 | tail -n +2 |
  awk -F, '{printf "| %.0f | %.3f | %.3f |\n", $1, $2, $3}'
