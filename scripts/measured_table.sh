#!/usr/bin/env bash
# Prints the tables of libcontact/docs/explanation/measured.md, which compare
# published measurements and computations with libcontact:
#   scripts/measured_table.sh BUILD_DIR [LEDGER]
# It also writes them to a CSV file (data/ledger.csv). Docs.MeasuredTable
# compares the tables with the page, Pages.LedgerIsThePages the CSV file.
set -euo pipefail
unset CDPATH
if [ $# -lt 1 ] || [ $# -gt 2 ]; then
  sed -n '2,6s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
bin=$(cd "$1" && pwd)/bin
ledger=${2:+$(realpath "$2")}
cd "$(dirname "$0")/.."
data=$PWD/data
source scripts/walled_joint.sh
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
cd "$work"

# Interval of a column of numbers: FORMAT, "least to largest".
interval() {
  awk -v format="$1" 'NR == 1 {low = high = $1}
    {if ($1 < low) low = $1; if ($1 > high) high = $1}
    END {printf format " to " format, low, high}'
}
in_tenths() {
  awk '{for (i = 1; i <= NF; ++i) printf "%.1f%s", $i, i < NF ? " " : "\n"}'
}
# Stated LOW to HIGH and ours, "low to high": what they have to do with another.
verdict() {
  awk -v low="$1" -v high="$2" -v ours="$3" 'BEGIN {
    split(ours, x, " to ")
    if (x[2] < low || x[1] > high) print "outside"
    else if (x[1] <= low && x[2] >= high) print "inside"
    else print "they overlap"
  }'
}
# Programs say of such joints that they are out of the ordinary; the page does too.
# A call with the same arguments and files is made once.
quietly() {
  local call arg
  call=call.$({
    printf '%s\n' "$@"
    for arg in "$@"; do if [ -f "$arg" ]; then cat "$arg"; fi; done
  } | md5sum | cut -c -32)
  [ -f "$call" ] || "$bin/$@" >"$call.new" 2>/dev/null || return
  [ -f "$call" ] || mv "$call.new" "$call"
  cat "$call"
}
# JOINT COLUMN ARGUMENTS...: the last number of hinge-joint
joint() {
  quietly hinge-joint --joint "$1" --columns "$2" "${@:3}" | tail -n 1
}

# A bush of thickness t/rho and Poisson's ratio on a housing that does not yield.
bush() { # T NU CLEARANCE_um
  walled_joint bush.toml pin 25 "$3" "inf 0" "0.5 $2" rigid \
    "$(awk -v t="$1" 'BEGIN {print 25 * t}')"
  printf '[friction]\ncoefficient = 0.1\n' >>bush.toml
}
# Torque with interference over that with clearance, at P/P_l for one bush.
bush_ratio() { # T NU LOAD
  bush "$1" "$2" -150
  local load
  load=$(joint bush.toml R_lift_off_N --reaction 0 |
    awk -v n="$3" '{printf "%.12g", $1 * n}')
  local pressed loose
  pressed=$(joint bush.toml M_t_N_m --reaction "$load")
  bush "$1" "$2" 350
  loose=$(joint bush.toml M_t_N_m --reaction "$load")
  awk -v a="$pressed" -v b="$loose" 'BEGIN {print a / b}'
}
# SOURCE KIND STATED ASSUMED OURS VERDICT WHY
row() {
  (IFS='|'; printf '| %s |\n' "$*" | sed 's/\([^ ]\)|\([^ ]\)/\1 | \2/g')
  if [ -z "$ledger" ] || [ "$1" = --- ]; then return; fi
  printf '%s\n' "$@" | sed 's/\[\([^]]*\)\]([^)]*)/\1/g; s/"/""/g; s/.*/"&"/' |
    paste -sd, >>"$ledger"
}
ref() { printf '[%s](../reference/references.md#%s)' "$1" "$2"; }

if [ -n "$ledger" ]; then : >"$ledger"; fi
row source kind stated assumed ours "the stated is" why
row --- --- --- --- --- --- ---

ours=$(for t in 0.1 0.3; do for nu in 0.4 0.49; do for load in 1.01 5; do
  bush_ratio $t $nu $load; done; done; done | interval %.2f)
row "$(ref "Colbert 2010" colbert-2010), PTFE bushes" measured \
  "torque with 150 um interference over torque with 350 um clearance: 1.50" \
  "t/rho 0.1 to 0.3, nu 0.40 to 0.49, rigid housing, load 1.01 to 5 times the lift-off load" \
  "$ours" "$(verdict 1.50 1.50 "$ours")" \
  "the abstract does not state the load, which decides"

# KIND THETA0_deg COLUMN ARGUMENTS...: a number of a contact of that half-angle.
at_half_angle() {
  local load
  load=$(quietly hinge-angle --joint "$1" --modulus-ratio 1 --law exact \
    --inverse --theta0 "$2" --columns load_parameter_exact | tail -n 1)
  quietly hinge-pressure --joint "$1" --modulus-ratio 1 --law exact \
    --load-parameter "$load" --summary --columns "$3" "${@:4}" | tail -n 1
}
ours=$(for angle in 10 80; do at_half_angle pin $angle S --pressure worn; done |
  interval %.3f)
row "$(ref "Colbert 2010" colbert-2010), worn bushes" measured \
  "torque grows with the wrap angle at one coefficient" \
  "worn in, half-angles of 10 to 80 deg" "$ours times f0 R rho" agrees \
  "4/pi = 1.273 for half a turn"

# KEY STATE: a number of Klang's pin.
klang() {
  walled_joint klang.toml pin 29.995 5 "210 0.3" "210 0.3"
  quietly hinge-pressure --joint klang.toml --set "plane_state=$2" \
    --load 9.375e5 --law exact --pressure exact --summary --columns "$1" |
    tail -n 1
}
klang_row() { # WHAT STATED KEY SCALE WHY
  local ours
  ours=$(for state in stress strain; do klang "$3" $state; done |
    awk -v scale="$4" '{printf "%s%.1f", NR == 2 ? " (plane strain " : "",
      $1 / scale} END {print ")"}')
  row "$(ref "Klang 1979" klang-1979), pin 59.99 mm in a hole of 60 mm" computed \
    "$1 $2" "no friction, 0.9375 MN/m" "$ours" outside "$5"
}
klang_row "half-angle, deg," 60 theta0_deg 1 "friction of 0.4 on first loading"
klang_row "peak, MPa," 17.8 p_peak_Pa 1e6 \
  "friction of 0.4 on first loading carries a part"

# E_GPa LOAD FACTOR: f0 of a friction factor of the sample hip.
hip_f0() {
  quietly hinge-joint --joint "$data/joints/hip_cocr_uhmwpe.toml" \
    --set "materials.outer.youngs_modulus_GPa=$1" --reaction "$2" --beta 90 \
    --measured-moment "$(awk -v f="$3" -v r="$2" 'BEGIN {print f * 0.014 * r}')" \
    --columns f0 | tail -n 1
}
ours=$(for e in 0.5 1; do for load in 500 3000; do hip_f0 $e $load 0.062; done
  done | interval %.4f)
row "$(ref "Di Puccio 2015" dipuccio-2015), CoCrMo on UHMWPE in serum" measured \
  "friction factor f_M 0.062 +- 0.008" \
  "head of 28 mm, 8 mm of 0.5 to 1 GPa, 0.5 to 3 kN" "f0 $ours" "no test" \
  "a conversion: f_M is not f0"

# LOAD HEAD_mm CLEARANCE_um LINER_mm: friction moment of a head.
head_moment_under() {
  walled_joint head.toml ball "$(awk -v d="$2" 'BEGIN {print d / 2}')" "$3" \
    "380 0.26" "1 0.4" rigid "$4"
  printf '[friction]\ncoefficient = 0.05\n' >>head.toml
  joint head.toml M_t_N_m --reaction "$1" --beta 90
}
head_moment() { head_moment_under 2000 "$@"; }
for head in 36 40; do
  ours=$(for clearance in 50 150; do for liner in 5 8; do
    awk -v a="$(head_moment $head $clearance $liner)" \
      -v b="$(head_moment 28 $clearance $liner)" 'BEGIN {print a / b}'
  done; done | interval %.2f)
  row "$(ref "Sonntag 2017" sonntag-2017), ceramic on polyethylene" measured \
    "torque is larger with heads of $head mm than of 28 mm" \
    "one f0, 2 kN, radial clearance 0.05 to 0.15 mm, liner 5 to 8 mm, 1 GPa" \
    "$ours times" agrees "slightly less than the ratio of the diameters"
done

# CLEARANCE_um BONE_GPa: half-angle of a metal hip of 50 mm.
metal_hip() {
  walled_joint metal.toml ball 25 "$1" "230 0.3" "230 0.3" "$2 0.3" 4
  printf '[friction]\ncoefficient = 0.1\n' >>metal.toml
  joint metal.toml theta0_deg --reaction 3200 --beta 90
}
for clearance in 50 150; do
  ours=$(for bone in 0.3 2; do metal_hip $clearance $bone; done | interval %.1f)
  row "$(ref "Underwood 2012" underwood-2012), metal on metal" measured \
    "low clearance brings the contact's edge nearer to the rim" \
    "head 50 mm, cup of 4 mm in bone of 0.3 to 2 GPa, 3.2 kN, radial clearance $clearance um" \
    "half-angle $ours deg" agrees "the abstract does not state the sizes of the hips"
done

ours=$(for angle in 10 70; do at_half_angle ball $angle sigma_Y_0; done |
  interval %.2f)
row "$(ref "SKF 4407" skf-4407), radial spherical plain bearings" catalogue \
  "friction moment over f P d/2: 1" "half-angles of 10 to 70 deg" "$ours" \
  "at its lower end" "a convention: f of catalogues is f_M"

# GROUP: a steel bearing GE 50.
ge50() {
  cat >ge50.toml <<END
name = "GE 50"
kind = "ball"
[geometry]
designation = "GE50DO"
clearance_group = "$1"
[materials]
pair = "$data/materials/steel_steel.toml"
[friction]
coefficient = 0.1
END
}
ours=$(for group in C2 C3; do ge50 $group
  joint ge50.toml M_t_N_m --reaction 45180 --beta 90 --without-seat |
    awk '{print $1 / (0.1 * 45180 * 0.033)}'; done | interval %.3f)
row "$(ref "INA 238" ina-238), GE 50 DO, page 100" catalogue \
  "friction moment over f P d_K/2: 1" "45.18 kN, groups C2 to C3, f0 0.1, a seat without rims" "$ours" \
  "at its lower end" "a convention again: f of catalogues is f_M"
ours=$(ge50 CN; joint ge50.toml p_nominal_Pa --reaction 45180 --beta 90 |
  awk '{printf "%.2f", $1 / 1e6}')
row "$(ref "INA 238" ina-238), GE 50 DO, page 100" catalogue \
  "specific load K P/C_r, MPa, 28.96" "45.18 kN over d_K C" "$ours" outside \
  "C_r = 156 kN at K = 100 MPa is 84 % of d_K C"

# LINER_mm NU CLEARANCE_um LOAD BETA: friction moment of a lined ball of 25.4 mm.
gimbal() {
  walled_joint gimbal.toml ball 12.7 "$3" "207 0.292" "3.1 $2" "207 0.292" "$1"
  printf '[friction]\ncoefficient = 0.06\n' >>gimbal.toml
  joint gimbal.toml M_t_N_m --reaction "$4" --beta "$5"
}
gimbal_interval() { # LOAD BETA
  for liner in 0.3 0.5; do for nu in 0.3 0.45; do for clearance in 2 20; do
    gimbal $liner $nu $clearance "$1" "$2"; done; done; done | interval %.1f
}
for load in 15 22.5; do
  textbook=$(awk -v load="$load" 'BEGIN {printf "%.1f", 0.06 * load * 12.7}')
  row "f F r, gimbal bearing of 25.4 mm at $load kN" textbook \
    "breakaway $textbook N m with f = 0.06" \
    "liner 0.3 to 0.5 mm of 3.1 GPa, nu 0.3 to 0.45, radial clearance 2 to 20 um" \
    "$(gimbal_interval "${load}kN" 90) N m across the load, $(gimbal_interval "${load}kN" 0) spinning about it" \
    "between them" "it ignores the width of the contact and spinning"
done

# A polymer bush of 3 mm in a cold rigid shell, warmer by 30 K, on a rigid pin of
# 12.5 mm: Lame's cylinder in plane strain, u = A r + B/r with u(b) = 0.
lame=$(awk 'BEGIN {
  E = 0.5e9; nu = 0.4; strain = (1 + nu) * 1.3e-4 * 30
  a = 12.5e-3; b = 15.5e-3; closed = 20e-6
  A = closed * a / (b * b - a * a)
  left = strain - A * (1 + (1 - 2 * nu) * b * b / (a * a))
  printf "%.3f", E * left / ((1 + nu) * (1 - 2 * nu)) / 1e6}')
walled_joint warm.toml pin 12.5 20 "inf 0" "0.5 0.4" rigid 3
sed -i 's/^backing = .*/backing = { youngs_modulus_Pa = inf, thermal_expansion_per_K = 0 }/' warm.toml
ours=$(joint warm.toml p_0_Pa --reaction 0 --friction 0.1 \
  --set materials.outer.thermal_expansion_per_K=1.3e-4 \
  --set inner_temperature_C=20 --set outer_temperature_C=50 \
  --set axial_growth=held | awk '{printf "%.3f", $1 / 1e6}')
row "Lame's thick cylinder ([Roark](../reference/references.md#roark))" computed \
  "pressure on the pin, MPa, of a bush that closes on warming: $lame" \
  "3 mm of 0.5 GPa, nu 0.4, 1.3e-4 per K, 30 K, radial clearance 20 um" "$ours" \
  "$(awk -v a="$lame" -v b="$ours" 'BEGIN {
    d = 100 * (b / a - 1); print ((d < 0 ? -d : d) < 0.5 ? "inside" : "outside")}')" \
  "the same to six digits"

# INTERFERENCE_um F0: moment of a car's ball joint that nothing loads.
car_joint() {
  walled_joint car.toml ball 12.5 "-$1" "207 0.3" "2.8 0.35" rigid 3
  printf '[friction]\ncoefficient = %s\n' "$2" >>car.toml
  joint car.toml M_t_N_m --reaction 0 --beta 90
}
ours=$(for depth in 1 10; do for f0 in 0.05 0.1; do car_joint $depth $f0; done
  done | interval %.1f)
row "[Repair manuals](../reference/references.md#car-ball-joints), ball joints of cars" catalogue \
  "turning torque without load 0.5 to 3.5 N m" \
  "ball of 25 mm pressed 1 to 10 um into 3 mm of POM (2.8 GPa) in a rigid shell, f0 0.05 to 0.1" \
  "$ours N m" "$(verdict 0.5 3.5 "$ours")" \
  "no sizes are stated, and a micrometre in a stiff shell decides"

# CLEARANCE_um E_GPa LINER_mm LOAD: friction moment over f0 R rho of a hip of
# 22.225 mm, new.
charnley() {
  walled_joint charnley.toml ball 11.1125 "$1" "210 0.3" "$2 0.4" rigid "$3"
  printf '[friction]\ncoefficient = 0.1\n' >>charnley.toml
  joint charnley.toml M_t_N_m --reaction "$4" --beta 90 |
    awk -v load="$4" '{print $1 / (0.1 * load * 0.0111125)}'
}
new=$(for clearance in 80 150; do for e in 0.5 1; do for liner in 8 11; do
  for load in 500 2000; do charnley $clearance $e $liner $load
  done; done; done; done | interval %.9g)
worn=$(quietly hinge-table --theta0 60,90 --alpha 0 --pressure worn \
  --columns sigma_Y_worn | tail -n 2 | interval %.9g)
ours=$(awk -v new="$new" -v worn="$worn" 'BEGIN {
  split(new, n, " to "); split(worn, w, " to ")
  printf "%.2f to %.2f", w[1] / n[2], w[2] / n[1]}')
for stated in 1.18 1.5; do
  row "$(ref "Charnley hips" charnley-friction), retrieved over new, $(
    [ $stated = 1.18 ] && echo dry || echo lubricated)" measured \
    "friction factor larger by $stated" \
    "one f0, new: 22.225 mm, 8 to 11 mm of 0.5 to 1 GPa, 80 to 150 um, 0.5 to 2 kN, retrieved: worn in over 60 to 90 deg" \
    "$ours" "$(verdict $stated $stated "$ours")" "$(
    [ $stated = 1.18 ] && echo "geometry can explain all of it" ||
      echo "geometry alone cannot explain it: surfaces or film")"
done

# HEAD_mm CLEARANCE_um: friction moment over f0 R rho under 3 kN, 8 mm liner.
head_factor() {
  head_moment_under 3000 "$1" "$2" 8 |
    awk -v d="$1" '{print $1 / (0.05 * 3000 * d / 2000)}'
}
ours=$(for clearance in 100 300; do
  awk -v a="$(head_factor 44 $clearance)" -v b="$(head_factor 40 $clearance)" \
    'BEGIN {print a / b}'; done | interval %.3f)
row "$(ref "Haider 2016" haider-2016), heads of 44 over 40 mm" measured \
  "friction factor 0.66 to 0.73 times" "one f0, 100 to 300 um, 8 mm, 3 kN" \
  "$ours" "$(verdict 0.66 0.73 "$ours")" "lubrication, not geometry"

# CLEARANCE_um E_GPa LINER_mm LOAD: pressure over approach, N/m^3.
pressure_modulus() {
  walled_joint module.toml ball 14 "$1" "230 0.3" "$2 0.4" rigid "$3"
  quietly hinge-pressure --joint module.toml --load "$4" --law exact \
    --pressure exact --summary --columns p_peak_Pa,approach_m | tail -n 1 |
    awk -F, '{printf "%.3g\n", $1 / $2 / 1e11}'
}
ours=$(for e in 0.5 1; do for liner in 5 12; do for load in 500 3000; do
  pressure_modulus 100 $e $liner $load; done; done; done | interval %.1f)
row "$(ref "AnyBody" anybody-wiki), pressure module of PE on CoCr" "rule of thumb" \
  "about 1e11 N/m^3, 4e9 is used for a knee" \
  "28 mm, 100 um, 5 to 12 mm of 0.5 to 1 GPa, 0.5 to 3 kN" "$ours e11 N/m^3" \
  "$(verdict 1 1 "$ours")" "not constant: it falls with the thickness"

ours=$(for depth in 1 5; do for f0 in 0.05 0.1; do car_joint $depth $f0; done
  done | interval %.1f)
# MOMENT F0: the interference that makes it, um; the moment is in proportion.
pressed_for() {
  awk -v moment="$1" -v of_one="$(car_joint 1 "$2")" \
    'BEGIN {printf "%.1f", moment / of_one}'
}
row "[Production limits](../reference/references.md#ball-joint-limits), ball joints" catalogue \
  "breakaway torque up to 8 N m, running up to 4 N m" \
  "ball of 25 mm pressed 1 to 5 um into 3 mm of POM (2.8 GPa) in a rigid shell, f0 0.05 to 0.1" \
  "$ours N m, and 4 to 8 N m take $(pressed_for 4 0.1) to $(pressed_for 8 0.05) um" \
  "$(verdict 0 8 "$ours")" "micrometres decide, as above"

# Calculators take Hertz' pressure, or the larger one of it and that over a
# projected area. By how many per cent that is off for a steel pin of 50 mm over a
# length's load, "hertz largest".
pin_calculators() { # CLEARANCE_um THETA0
  walled_joint pin.toml pin 25 "$1" "210 0.3" "210 0.3"
  local load
  load=$(quietly hinge-angle --joint pin.toml --law exact --inverse \
    --theta0 "$2" --columns load_exact_N | tail -n 1)
  quietly hinge-pressure --joint pin.toml --load "$load" --law exact \
    --pressure exact --summary --columns p_peak_Pa | tail -n 1 |
    awk -v f="$load" -v eps="$1" 'BEGIN {pi = atan2(0, -1)} {
      d = 0.05; hole = d + 2e-6 * eps
      hertz = 0.798 * sqrt(f / (d * hole / (hole - d)) / (2 * 0.91 / 210e9))
      area = 4 * f / (pi * d)
      largest = hertz > area ? hertz : area
      printf "%.4f %.4f\n", 100 * (hertz / $1 - 1), 100 * (largest / $1 - 1)}'
}
ours=$(for angle in 10 47 84; do pin_calculators 50 $angle; done |
  awk '{printf "%s%.1f", NR == 1 ? "" : NR == 2 ? ", " : " and ", $1}')
row "$(ref Roark roark)'s cylinder in a socket, as $(ref calculators socket-calculators) have it" \
  calculator "0.798 sqrt(p/(K_D C_E))" \
  "steel pin of 50 mm, radial clearance of 50 um, half-angles of 10, 47 and 84 deg" \
  "the formula is off by $ours %" outside "it equals Hertz, for narrow contacts"
ours=$(for clearance in 20 100; do for angle in 10 47 84; do
  pin_calculators $clearance $angle; done; done | cut -d' ' -f2 | interval %.1f)
row "$(ref "A pin calculator" efi-tools), max(Hertz, 4 F/(pi D L))" calculator \
  "conservative, truth 5 to 15 % above" \
  "steel pin of 50 mm, clearance of 20 to 100 um, half-angles of 10 to 84 deg" \
  "the calculator is off by $ours %" outside \
  "lowest at 47 deg, where neither form holds"

# E_GPa CLEARANCE_um: largest pressures of a pin of 20 mm under 2 kN in its middle
# (MPa), and how much larger they are a twelfth and a sixth of its length off it.
off_middle() {
  walled_joint bush20.toml pin 10 "$2" "210 0.3" "$1 0.4" rigid 1
  sed -i 's/length_m = 1/length_mm = 15/' bush20.toml
  for place in 1e-6 1.25 2.5; do
    quietly hinge-pressure --joint bush20.toml --load 2kN --load-at ${place}mm \
      --columns p_peak_Pa | tail -n 1
  done | paste -sd' ' | awk '{print $1 / 1e6, $2 / $1, $3 / $1}'
}
rows=$(for e in 1 3; do for clearance in 10 50; do off_middle $e $clearance
  done; done)
near=$(cut -d' ' -f2 <<<"$rows" | interval %.2f)
row "$(ref "A pin calculator" efi-tools), 1 + 6 e/L of a load off the middle" \
  calculator "1.5 at e = L/12, 2 at L/6" \
  "20 mm by 15 mm, 1 mm of 1 to 3 GPa in a rigid shell, clearance of 10 to 50 um, 2 kN" \
  "$near, $(cut -d' ' -f3 <<<"$rows" | interval %.2f), and it is taken of $(
    awk 'BEGIN {printf "%.1f", 4 * 2000 / (atan2(0, -1) * 20 * 15)}') MPa, ours is $(
    cut -d' ' -f1 <<<"$rows" | interval %.1f)" "$(verdict 1.5 1.5 "$near")" \
  "safe, but its base is not"

# E1_GPa E2_GPa NU2 CLEARANCE_um LOAD_N: the calculator's pressure of a ball of 66
# mm, MPa, as that of a ball and, over 28 mm, as that of a rod end.
ball_calculator() {
  awk -v e1="$1" -v e2="$2" -v nu="$3" -v eps="$4" -v f="$5" 'BEGIN {
    pi = atan2(0, -1); r = 0.033
    e = 1e9 / (0.91 / e1 + (1 - nu * nu) / e2)
    radius = r * (r + eps * 1e-6) / (eps * 1e-6)
    hertz = (6 * f * e ^ 2 / (pi ^ 3 * radius ^ 2)) ^ (1 / 3)
    ball = 3 * f / (2 * pi * r * r)
    rod_end = 4 * f / (pi * 2 * r * 0.028)
    printf "%.9g %.9g\n", (hertz > ball ? hertz : ball) / 1e6,
      (hertz > rod_end ? hertz : rod_end) / 1e6}'
}
# JOINT: pressures of a ball at 100 kN in a ring that goes on beyond its rims.
in_ring() {
  quietly hinge-pressure --joint "$1" --set seat.side_face=goes_on \
    --load 100kN --direction 90 --columns p_at_load_Pa,p_peak_Pa | tail -n 1 |
    awk -F, '{printf "%.0f MPa in the middle, %.0f near the rims",
      $1 / 1e6, $2 / 1e6}'
}
endless() { # JOINT LOAD
  quietly hinge-pressure --joint "$1" --load "$2" --law exact --pressure exact \
    --summary --columns p_peak_Pa | tail -n 1 | awk '{print $1 / 1e6}'
}
steel_off_at() { # THETA0
  local load
  load=$(quietly hinge-angle --joint ball66.toml --law exact --inverse \
    --theta0 "$1" --columns load_exact_N | tail -n 1)
  ball_calculator 210 210 0.3 45 "$load" |
    awk -v ours="$(endless ball66.toml "$load")" '{print 100 * ($1 / ours - 1)}'
}
walled_joint ball66.toml ball 33 45 "210 0.3" "210 0.3"
lined=$data/joints/spherical_plain_bearing_ge50.toml
off=$(for angle in 10 50 84; do steel_off_at $angle; done | interval %.1f)
read -r steel _ < <(ball_calculator 210 210 0.3 45 1e5 | in_tenths)
row "$(ref "A bearing calculator" efi-tools), max(Hertz, 3 F/(2 pi R^2))" calculator \
  "steel on steel: $steel MPa" \
  "ball of 66 mm, diametral clearance of 90 um, 100 kN, no rims" \
  "$(endless ball66.toml 1e5 | in_tenths) MPa, and at half-angles of 10 to 84 deg it is off by $off %" \
  outside "lowest at 50 deg: the contact is wide and no cap of Hertz'"
printf '[seat]\nring_width_mm = 28\n' >>ball66.toml
of_steel=$(in_ring ball66.toml)
row "$(ref "A bearing calculator" efi-tools), max(Hertz, 3 F/(2 pi R^2))" calculator \
  "steel on steel: $steel MPa" "the same in a ring of 28 mm" \
  "$of_steel" outside "and the seat has edges"
read -r ball rod_end < <(ball_calculator 207 3.1 0.4 10 1e5 | in_tenths)
of_lined=$(in_ring "$lined")
row "$(ref "A bearing calculator" efi-tools), max(Hertz, 3 F/(2 pi R^2))" calculator \
  "lined: $ball MPa, as a rod end (4 F/(pi D C)) $rod_end" \
  "GE 50 of data/joints, 0.5 mm of 3.1 GPa, 100 kN" \
  "$of_lined, $(endless "$lined" 1e5 | in_tenths) without rims" outside \
  "as a rod end above a seat without rims, below its own"
row "$(ref NHBB nhbb), projected area 0.91 T D_B" catalogue \
  "$(awk 'BEGIN {printf "%.1f", 1e5 / (0.91 * 28 * 66)}') MPa" \
  "the same lined GE 50, 100 kN" "$of_lined" outside \
  "a mean, good for comparing bearings alone"
row "$(ref "SKF 4407" skf-4407), specific load p = K P/C" catalogue \
  "$(awk 'BEGIN {printf "%.1f", 100 * 100 / 156}') MPa" \
  "the steel GE 50, K = 100 MPa and C = 156 kN as INA has them, 100 kN" \
  "$of_steel" outside "a mean again"

# COEFFICIENT LOAD: friction moment of a door's pin of 8 mm in acetal.
door_pin() {
  walled_joint door.toml pin 4 50 "210 0.3" "2.8 0.35"
  sed -i 's/length_m = 1/length_mm = 10/' door.toml
  printf '[friction]\ncoefficient = %s\n' "$1" >>door.toml
  joint door.toml M_t_N_m --reaction "$2"
}
ours=$(for load in 30 80; do door_pin 0.3 $load; done | interval %.3f)
row "$(ref "Drake" drake-door), dishwasher door" "measured by hand" \
  "hinge friction 2 N m at rest, 3 N m moving" \
  "pins of 8 mm of steel in acetal, f0 0.3, 30 to 80 N" "$ours N m" \
  "$(verdict 2 3 "$ours")" "the resistance does not come from the pins"
row "$(ref "Durom cups" durom-deformed), 42 um out of round" measured \
  "wears 7.5 times as much as a round one" "Archard, one wear coefficient" \
  "1.0 times, by the form of the law" outside "film and rim, not pressure"
row "$(ref "Leslie 2009" leslie-2009), cup at 60 deg, metal on metal" measured \
  "wears 9 times as much, with microseparation 17 times" \
  "Archard, one wear coefficient" "1.0 times, by the form of the law" outside \
  "film and rim, not pressure"
