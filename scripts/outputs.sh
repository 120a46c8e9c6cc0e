#!/usr/bin/env bash
# Writes outputs of the programs, to check that a change does not affect them:
#   scripts/outputs.sh BUILD_DIR FOLDER
# Compare two folders by `diff -r`. Write both on one machine, because the last
# digits depend on its instruction set. ctest compares the examples of pages and
# the messages.
set -euo pipefail
unset CDPATH
build=$(cd "$1" && pwd)
bin=$build/bin
mkdir -p "$2"
out=$(cd "$2" && pwd)
cd "$(dirname "$0")/.."
PATH=$bin:$PATH

for case in data/cases/*.toml; do
  name=$(basename "$case" .toml)
  hinge-separation "$case" --history "$out/$name.csv" \
    --events "$out/$name.events.csv" --output "$out/$name.json"
done
for study in hip:768 lined_bearing:50 soyuz:50 ring_out_of_line:20; do
  name=study_${study%:*}
  hinge-study "data/studies/${study%:*}.toml" --runs "${study#*:}" \
    --journal "$out/$name.journal" --csv "$out/$name.csv" \
    --output "$out/$name.json" >"$out/$name.txt" || true
  rm "$out/$name.journal"  # has the identity of the joints, as text
done

# run NAME COMMAND...: what it says and how it ends
run() { "${@:2}" >"$out/$1" 2>"$out/$1.err" || echo "exit $?" >>"$out/$1.err"; }
hip=data/joints/hip_cocr_uhmwpe.toml
pin=data/joints/pin_joint.toml
run angle.csv hinge-angle --joint "$pin" --load 100:1e5:log30 --compare
run pressure.csv hinge-pressure --joint "$hip" --load 2kN --pressure exact,worn
run table.csv hinge-table --theta0 5:80:16 --alpha 0:90:10
run joint.csv hinge-joint --joint "$hip" --reaction 10:5000:log40 \
  --beta 0:90:13 --pv
run rest.csv hinge-joint --joint "$hip" --reaction-xyz 0,0,2000 \
  --moment-xyz 0.5,0,0.2
run duty.csv hinge-duty --joint "$hip" --cycle data/duty/hip_cycle.csv \
  --euler zxy --wear-seat 1e-6 --cycles 1e6 --states "$out/duty_states.csv" \
  --map "$out/duty_map.csv"
run identify.csv hinge-identify --joint data/duty/torque_rig.toml \
  --data data/duty/torque_rig.csv --profile

# Every joint at every door that asks for one.
cat >"$out/ge50es.toml" <<EOF
name = "GE50ES"
kind = "ball"
[materials]
pair = "$PWD/data/materials/steel_steel.toml"
[geometry]
designation = "GE50ES"
[friction]
coefficient = 0.15
EOF
for joint in data/joints/*.toml "$out/ge50es.toml"; do
  name=$(basename "$joint" .toml)
  cycle=(--cycle data/duty/hip_cycle.csv --euler zxy)
  angle=(--beta 90)
  if grep -q '^kind = "pin"' "$joint"; then
    cycle=(--cycle data/duty/pin_cycle.csv)
    angle=()
  fi
  run "$name.joint.csv" hinge-joint --joint "$joint" --reaction 10:5000:log8 \
    "${angle[@]}" --pv
  run "$name.xyz.csv" hinge-joint --joint "$joint" --reaction-xyz 800,200,500 \
    --rate-xyz 0.1,0.2,1
  run "$name.rest.csv" hinge-joint --joint "$joint" \
    --reaction-xyz 800,200,500 --moment-xyz 0.1,0.2,1
  run "$name.angle.csv" hinge-angle --joint "$joint" --load 100:1e4:log5
  run "$name.pressure.csv" hinge-pressure --joint "$joint" --load 1kN
  run "$name.duty.csv" hinge-duty --joint "$joint" "${cycle[@]}" \
    --states "$out/$name.duty_states.csv"
  run "$name.fmu.txt" hinge-fmu "$joint" --output "$out/$name.fmu"
  rm -f "$out/$name.fmu"
  if grep -q '^\[seat\]' "$joint"; then
    run "$name.without_seat.csv" hinge-joint --joint "$joint" --without-seat \
      --reaction-xyz 800,200,500 --rate-xyz 0.1,0.2,1
  fi
done
run tilt.csv hinge-joint --joint data/joints/relieved_bush.toml \
  --reaction 10kN,100kN --tilt 0,0.02,0.05
run tilt_duty.csv hinge-duty --joint data/joints/relieved_bush.toml \
  --cycle data/duty/pin_cycle.csv --load-at 2mm
if [[ -d $build/python ]]; then
  PYTHONPATH=$build/python run loop.py.txt /usr/bin/python3 \
    scripts/outputs/loop.py data/joints/*.toml "$out/ge50es.toml"
fi
cc -I. -I"$build/include" scripts/outputs/loop.c -o "$out/loop" \
  -L"$build/lib" -Wl,-rpath,"$build/lib" -lcontact_c
run loop.c.txt "$out/loop" data/joints/*.toml "$out/ge50es.toml"
rm "$out/loop" "$out/ge50es.toml"
sed -i "s|$out/||g" "$out"/*.err "$out"/loop.*.txt "$out"/*.txt
