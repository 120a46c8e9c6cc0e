#!/usr/bin/env bash
# Redraws figures 3, 4, 5, 8 and 9 of the paper from the programs' output,
# the limit half-angles of other materials, pressure profiles, the error of
# leaving walls out, the torque of a pin with interference, pressures on seats
# that end, also in side faces, what calculators give for pressures, a separation
# of boosters and a hinge's sketch:
#   plots/figures.sh BUILD_DIR OUTPUT_DIR
# leaves NAME.svg, NAME.png and the tables they show, as CSV.
source "$(dirname "$0")/start.sh"

# Figure 3: limit half-angle against the modulus ratio, 10^-2 to 10^2 in 81
# steps, the short form where it holds, and the exact limits.
limit() { # JOINT RATIO NU FORM LAWS: theta0 in deg, comma between laws
  hinge-angle --joint "$1" --modulus-ratio "$2" --poisson1 "$3" \
    --poisson2 "$3" ${4:+--limit-angle "$4"} --law "$5" --x inf 2>/dev/null |
    tail -n 1 | cut -d, -f3,5
}
ratio() { # STEP STEPS_PER_DECADE
  awk -v i="$1" -v n="$2" 'BEGIN { printf "%.9g", 10^(i / n) }'
}
{
  echo modulus_ratio,theta0_limit_formula_deg,theta0_limit_linear_deg,\
theta0_limit_exact_pin_deg,theta0_limit_exact_ball_deg
  for i in {-40..40}; do
    r=$(ratio "$i" 20)
    IFS=, read -r formula pin < <(limit pin "$r" 0.3 formula tanh,exact)
    linear=
    # 10^(6/20) is the last of them below 2.
    [ "${i#-}" -le 6 ] && linear=$(limit pin "$r" 0.3 linear tanh)
    echo "$r,$formula,$linear,$pin,$(limit ball "$r" 0.3 '' exact)"
  done
} >figure3.csv

# Figures 4 and 5: half-angle laws of a pin (equal materials) and of a ball in
# a rigid seat, with the paper's limit half-angles.
laws=hertz,arctan,tanh,blend:0.5,fitted,exact
hinge-angle --joint pin --modulus-ratio 1 --law $laws \
  --limit-angle 84.85 --load-parameter 0:1:0.0025 --output figure4.csv \
  2>figure4.log
hinge-angle --joint ball --modulus-ratio 0 --law $laws \
  --limit-angle 92.5 --load-parameter 0:4:0.01 --output figure5.csv \
  2>figure5.log

# Limit half-angles of other materials.
{
  echo poissons_ratio,modulus_ratio,theta0_limit_pin_deg,theta0_limit_ball_deg
  for nu in 0.2 0.3 0.4 0.45 0.49; do
    for i in {-20..20}; do
      r=$(ratio "$i" 10)
      echo "$nu,$r,$(limit pin "$r" $nu '' exact),$(
        limit ball "$r" $nu '' exact)"
    done
  done
} >limit_angles.csv

# Pressure of pin and ball, equal materials, for contacts of 40, 60 and 80 deg.
for joint in pin ball; do
  loads=$(hinge-angle --joint $joint --modulus-ratio 1 --law exact \
    --inverse --theta0 40:80:20 | tail -n +2 | cut -d, -f2 | paste -sd,)
  hinge-pressure --joint $joint --modulus-ratio 1 --law exact \
    --load-parameter "$loads" --pressure cosine,exact --points 401 \
    --output pressure_$joint.csv
done

# Figures 8 and 9: coefficients and area integrals against the slip axis
# angle, exact and by the planar sliding-spinning model.
for method in exact planar; do
  hinge-table --theta0 20:80:20 --alpha 0:90:1 \
    --method $method --output figure8_$method.csv
done

# How wrong a seat without an end is: a ball and a pin of steel in a wall of a
# polymer or bronze, at the load at which the infinite seat has 40 deg.
source "$plots/../scripts/walled_joint.sh"
one() { # FILE LOAD: half-angle and peak
  hinge-angle --joint "$1" --load "$2" --law exact \
    --pressure exact --columns theta0_exact_deg,p_peak_exact_by_exact_Pa |
    tail -n 1
}
{
  echo kind,material,backing,thickness_over_radius,half_angle_error_percent,\
peak_error_percent
  for kind in ball pin; do
    for name in polymer bronze; do
      [ $name = polymer ] && wall="1 0.4" || wall="110 0.34"
      joint=(walled_joint wall.toml $kind 10 10 "210 0.3" "$wall")
      "${joint[@]}"
      load=$(hinge-angle --joint wall.toml --law exact --inverse \
        --theta0 40 | tail -n 1 | cut -d, -f2)
      infinite=$(one wall.toml "$load")
      for backing in rigid steel held; do
        for i in {0..36}; do
          t=$(ratio $((i - 24)) 12)
          "${joint[@]}" "${backing/steel/210 0.3}" \
            "$(awk -v t="$t" 'BEGIN { printf "%.6g", 10 * t }')"
          awk -F, -v what="$kind,$name,$backing,$t" -v a="$infinite" \
            -v b="$(one wall.toml "$load")" 'BEGIN {
              split(a, x); split(b, y)
              printf "%s,%.6g,%.6g\n", what, 100 * (x[1] / y[1] - 1),
                100 * (x[2] / y[2] - 1)
            }'
        done
      done
    done
  done
  rm wall.toml
} >wall_errors.csv

# Torque against load of a lined bush, from interference to clearance, um.
clearances='-5 -3 -1 0 5'
for eps in $clearances; do
  sed "s/radial_interference_um = 3/radial_clearance_um = $eps/" \
    "$data/joints/lined_bush_pressed.toml" >bush.toml
  hinge-joint --joint bush.toml --law exact --reaction 0:15kN:100N \
    --columns R_N,M_t_N_m --output "preload_$eps.csv" 2>preload.log
done
rm bush.toml

# Pressure on seats that end, over the seat and in the plane of the load, and
# what the seat without an end would have.
seat() { # NAME JOINT LOAD DIRECTION
  local joint=(--joint "$data/joints/$2.toml" --load "$3")
  hinge-pressure "${joint[@]}" --direction "$4" --points 181 \
    --output "$1.csv" 2>seat.log
  # Both halves in one: a seam between two surfaces would be seen.
  awk -F, 'function turn(i) {
      if (n == 0) return
      for (i = n; i > 1; i--) print v, -phi[i], p[i]
      for (i = 1; i <= n; i++) print v, phi[i], p[i]
      print ""
      n = 0
    }
    NR > 1 { if ($3 != v) turn(); v = $3; phi[++n] = $4; p[n] = $5 }
    END { turn() }' "$1.csv" >"$1.dat"
  awk -F, 'NR > 1 && $4 == 0 { v[++n] = $3; print $3, $5 }
    END { for (; n > 0; n--) print v[n], 0 }' "$1.csv" >"$1_cut.dat"
  hinge-pressure "${joint[@]}" --law exact --pressure exact \
    2>>seat.log | tail -n +2 | tr , ' ' >"$1_free.dat"
}
seat seat_ring spherical_plain_bearing_ge50 100kN 90
seat seat_cup hip_cup 2kN 65

# The same of two cups in the plane of the load, with and without side faces.
cup() { # NAME LOAD DIRECTION JOINT
  for face in goes_on free; do
    hinge-pressure --joint "$4" --set "seat.side_face=$face" \
      --load "$2" --direction "$3" --points 91 --output face.csv \
      --columns v_deg,phi_deg,p_Pa 2>seat.log
    awk -F, 'NR > 1 && ($2 == 0 || $2 == 180) {
      print ($2 == 0 ? $1 : -$1), $3 / 1e6 }' face.csv | sort -g \
      >"side_face_$1_$face.dat"
  done
}
source "$plots/../scripts/walled_joint.sh"
walled_joint cup.toml ball 10 10 "210 0.3" "110 0.34" rigid 10
printf '[seat]\ncup_deg = 35\nedge_angle_deg = 65\n' >>cup.toml
cup bronze 4258N 0 cup.toml
cup hip 3162N 65 "$data/joints/hip_cup.toml"
rm cup.toml face.csv

# Pressures that calculators give, over the exact one: half-angle in deg, Hertz,
# over the projected area with the factor for a pin or a ball, and without.
calculators() { # JOINT RADIUS_mm CLEARANCE_um
  walled_joint steel.toml "$@" "210 0.3" "210 0.3"
  local loads
  loads=$(hinge-angle --joint steel.toml --law exact --inverse \
    --theta0 2:84:1 --columns load_exact_N | tail -n +2 | paste -sd,)
  hinge-pressure --joint steel.toml --load "$loads" --law exact \
    --pressure exact --summary --columns load_N,theta0_deg,p_peak_Pa \
    2>steel.log |
    awk -F, -v joint="$1" -v r="$2" -v eps="$3" 'NR > 1 {
      pi = atan2(0, -1); f = $1; r_m = r / 1000; e = 210e9 / (2 * 0.91)
      curvature = eps / 1000 / (r * (r + eps / 1000)) * 1000
      if (joint == "pin") {
        hertz = sqrt(f * e * curvature / pi)
        area = 2 * r_m; factor = 4 / pi
      } else {
        hertz = (6 * f * e ^ 2 * curvature ^ 2 / pi ^ 3) ^ (1 / 3)
        area = pi * r_m ^ 2; factor = 1.5
      }
      print $2, hertz / $3, factor * f / area / $3, f / area / $3
    }' >"calculators_$1.dat"
}
calculators pin 25 50
calculators ball 33 45
rm steel.toml

over() { # FILE JOINT COLUMNS OPTIONS: a table of loads or directions
  hinge-pressure --joint "$data/joints/$2.toml" \
    --columns "$3" --output "seat_loads_$1.csv" "${@:4}" 2>>seat.log
}
loads=1kN:200kN:log100
over ring spherical_plain_bearing_ge50 \
  load_N,half_width_deg,p_peak_Pa,p_at_load_Pa --load $loads --direction 90
over free spherical_plain_bearing_ge50 load_N,theta0_deg,p_peak_Pa \
  --load $loads --law exact --pressure exact --summary
over cup hip_cup direction_deg,p_peak_Pa,p_at_load_Pa --load 2kN \
  --direction 0:85:1

# Four boosters leaving a core.
times='0.5 1 1.4 2.2 3'
hinge-separation "$data/cases/soyuz.toml" \
  --history separation.csv --output separation.json --no-clearance
awk -v times="$times" -f "$plots/outlines.awk" separation.csv >outlines.csv

# One picture: NAME SVG_SIZE PNG_SIZE
draw() {
  gnuplot -e "set terminal svg $2 rounded linewidth 1.2 background 'white'" \
    -e "set output '$1.svg'; plots = '$plots'; times = '$times'" \
    "$plots/style.gp" "$plots/$1.gp"
  gnuplot -e "set terminal pngcairo $3 rounded linewidth 1.7" \
    -e "set output '$1.png'; plots = '$plots'; times = '$times'" \
    "$plots/style.gp" "$plots/$1.gp"
}
for figure in 3 4 5; do
  draw figure$figure "size 840,760 font 'sans,19'" \
    "size 1260,1140 font 'sans,21'"
done
for figure in 8 9; do
  draw figure$figure "size 1260,460 font 'sans,17'" \
    "size 2100,766 font 'sans,22'"
done
draw pressure_profiles "size 1160,520 font 'sans,18'" \
  "size 1740,780 font 'sans,21'"
draw wall_errors "size 1080,900 font 'sans,18'" "size 1620,1350 font 'sans,21'"
draw preload "size 840,520 font 'sans,18'" "size 1260,780 font 'sans,21'"
draw seat_pressure "size 1000,833 font 'sans,16'" \
  "size 1500,1250 font 'sans,21'"
draw seat_loads "size 1260,460 font 'sans,17'" "size 2100,766 font 'sans,22'"
draw side_face "size 1260,460 font 'sans,17'" "size 2100,766 font 'sans,22'"
draw calculators "size 1260,420 font 'sans,17'" "size 2100,700 font 'sans,22'"
draw limit_angles "size 1080,520 font 'sans,18'" \
  "size 1620,780 font 'sans,21'"
draw separation "size 900,553 font 'sans,17'" "size 1350,830 font 'sans,20'"
draw hinge "size 740,600 font 'sans,18'" "size 1110,900 font 'sans,22'"
