#!/usr/bin/env bash
# Names of the quantities at every door: columns, summaries, studies, Python.
#   names.sh BUILD PYTHON >names.txt       writes them anew
#   names.sh BUILD PYTHON --check          compares
set -euo pipefail
unset CDPATH
build=$1
python=$2
folder=$(cd "$(dirname "$0")" && pwd)
if [[ ${3-} == --check ]]; then
  exec diff "$folder/names.txt" <("$0" "$build" "$python")
fi
cd "$folder/../.."
PATH=$build/bin:$PATH
export PYTHONPATH=$build/python PYTHONDONTWRITEBYTECODE=1
out=$(mktemp -d)
trap 'rm -r "$out"' EXIT

columns() { echo "$1: $(head -n 1 "$2" | tr ',' ' ')"; }
lines() { echo "$1: $(tail -n +2 "$2" | cut -d , -f 1 | tr '\n' ' ')"; }
# table columns|lines NAME PROGRAM ARGUMENT...
table() {
  "${@:3}" >"$out/table" 2>"$out/errors" || cat "$out/errors" >&2
  "$1" "$2" "$out/table"
}

ball='--joint data/joints/hip_cocr_uhmwpe.toml'
open='--joint data/joints/hip_cocr_uhmwpe_infinite.toml'
pin='--joint data/joints/pin_joint.toml'
pressed='--joint data/joints/lined_bush_pressed.toml'
one='--reaction 2000 --beta 50'
rest='--reaction-xyz 0,0,2000 --moment-xyz 0.5,0,0.2'
printf 'time_s,R_N,b_deg\n0,10,90\n1,20,80\n' >"$out/points.csv"
printf 'R_x_N,R_y_N,R_z_N,M_x_N_m,M_y_N_m,M_z_N_m\n0,0,9,1,0,0\n' \
  >"$out/rest.csv"
table columns hinge-joint hinge-joint $ball $one --pv
table columns hinge-joint-fitted hinge-joint $open $one --law fitted
table columns hinge-joint-pressed hinge-joint $pressed --reaction 2000
table columns hinge-pressure-direction hinge-pressure \
  --joint data/joints/spherical_plain_bearing_ge50.toml --load 1e5 --direction 90
table columns hinge-joint-in-seat hinge-joint --joint data/joints/ball_stud.toml \
  --reaction-xyz 10,0,0 --moment-xyz 0,0.01,0
table columns hinge-joint-tilt hinge-joint --joint data/joints/relieved_bush.toml \
  --reaction 1e4 --tilt 0.01 --pv
bush='--joint data/joints/relieved_bush.toml'
table columns hinge-pressure-tilt hinge-pressure $bush --load 1e4 --tilt 0.01
table columns hinge-pressure-tilt-map hinge-pressure $bush --load 1e4 \
  --tilt 0.01 --points 2
table columns hinge-angle-tilt hinge-angle $bush --load 1e4 --load-at 1mm
table lines hinge-duty-tilt hinge-duty $bush --cycle data/duty/pin_cycle.csv \
  --tilt 0.01 --states "$out/states-tilt" --along "$out/along" \
  --along-map "$out/along-map"
for file in states-tilt along along-map; do
  columns "hinge-duty-$file" "$out/$file"
done
table columns hinge-joint-rest hinge-joint $ball $rest
table columns hinge-joint-f0 hinge-joint $pin --reaction 2e4 --measured-moment 40
table lines hinge-joint-summary hinge-joint $ball $one --pv --summary
table columns hinge-joint-points hinge-joint $ball --points "$out/points.csv"
for points in points rest; do
  table lines "hinge-joint-$points-summary" \
    hinge-joint $ball --points "$out/$points.csv" --summary
done
table columns hinge-joint-trace hinge-joint $ball $one --trace
table columns hinge-joint-outer hinge-joint $ball $one --outer 0,0,1 \
  --braking 1
duty="hinge-duty $ball --cycle data/duty/hip_cycle.csv --euler zxy"
table lines hinge-duty $duty --wear-seat 1e-6 --cycles 1e4 \
  --measured-volume 9 --measured-error 1 --measured-cycles 1e6 \
  --states "$out/states" --map "$out/map" --blocks "$out/blocks"
for file in states map blocks; do columns "hinge-duty-$file" "$out/$file"; done
table columns hinge-angle hinge-angle $open --load 1e3 --law exact,fitted
table columns hinge-angle-pin hinge-angle $pin --load 1e3
table columns hinge-angle-pressed hinge-angle $pressed --load 2kN
table columns hinge-angle-half-angle hinge-angle $open --inverse --theta0 30
table columns hinge-angle-compare hinge-angle $open --load 1e3 --compare
play="hinge-angle $ball --force-law --load 1e3"
table columns hinge-angle-force-law $play
table columns hinge-angle-force-law-compare $play --compare
table columns hinge-angle-impact hinge-angle $ball --impact --mass 1 \
  --speed 0.1 --restitution 0.5
table columns hinge-pressure hinge-pressure $ball --load 2kN
for joint in ball pin pressed; do
  table columns "hinge-pressure-summary-$joint" \
    hinge-pressure ${!joint} --load 2kN --law exact --summary
done
table columns hinge-table hinge-table --theta0 5 --alpha 0
table lines hinge-identify hinge-identify --joint data/duty/torque_rig.toml \
  --data data/duty/torque_rig.csv --profile --residuals "$out/residuals"
columns hinge-identify-residuals "$out/residuals"
table columns hinge-identify-report hinge-identify \
  --joint data/duty/torque_rig.toml --data data/duty/torque_rig.csv --profile
table lines study-of-joint hinge-study data/studies/hip.toml --quantities
table lines study-of-seat hinge-study data/studies/ring_out_of_line.toml \
  --quantities
table lines study-of-case hinge-study data/studies/soyuz.toml --quantities
"$python" - <<'END'
import libcontact
from libcontact import _core

for name, of in sorted(vars(_core).items()):
    if isinstance(of, type):
        names = [n for n, p in sorted(vars(of).items()) if isinstance(p, property)]
        if names:
            print(f"{name}:", *names)
hip = libcontact.Joint.from_file("data/joints/hip_cocr_uhmwpe.toml")
for answer in hip.solve([0, 0, 9], [1, 0, 1]), hip.at_rest([0, 0, 9], [1, 0, 1]):
    print(f"{type(answer).__name__}.to_dict:", *sorted(answer.to_dict()))
END
