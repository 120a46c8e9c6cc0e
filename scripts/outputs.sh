#!/usr/bin/env bash
# Outputs of the programs, for changes that must not change them:
#   scripts/outputs.sh BUILD_DIR FOLDER
# writes them; `diff -r` of two folders says what a change did. Both are made on
# one machine, since the last digits are those of its instruction set. Examples
# of pages and messages are compared by ctest.
set -euo pipefail
unset CDPATH
bin=$(cd "$1/bin" && pwd)
mkdir -p "$2"
out=$(cd "$2" && pwd)
cd "$(dirname "$0")/.."
PATH=$bin:$PATH

for case in data/cases/*.toml; do
  name=$(basename "$case" .toml)
  hinge-separation "$case" --history "$out/$name.csv" \
    --events "$out/$name.events.csv" --output "$out/$name.json"
done
for study in hip:768 lined_bearing:50 soyuz:50; do
  name=study_${study%:*}
  hinge-study "data/studies/${study%:*}.toml" --runs "${study#*:}" \
    --journal "$out/$name.journal" --csv "$out/$name.csv" \
    --output "$out/$name.json" >"$out/$name.txt" || true
  rm "$out/$name.journal"  # has the identity of the joints, as text
done

# run NAME COMMAND...
run() { "${@:2}" >"$out/$1" 2>"$out/$1.err"; }
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
