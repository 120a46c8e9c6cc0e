#!/usr/bin/env bash
# Installs packages, builds, and runs the demonstration into demo-output/:
# tables of friction coefficients, half-angle curves of real joints, a stage
# separation, once and 1,705 times with scatter, and the paper's figures.
set -euo pipefail
unset CDPATH
cd "$(dirname "$0")/.."
scripts/setup.sh
cmake --preset release
# Builds only the programs that run below.
cmake --build --preset release --target hinge-table hinge-angle \
  hinge-pressure hinge-joint hinge-separation hinge-study

out=demo-output
mkdir -p "$out"
PATH="$PWD/build/bin:$PATH"

# What is run, for the page at the end.
commands=$(mktemp)
trap 'rm -f "$commands"' EXIT
title() {
  echo "$1"
  echo "# $1" >>"$commands"
}
run() {
  echo "$*" >>"$commands"
  command "$@"
}
for program in table angle pressure joint separation study; do
  eval "hinge-$program() { run hinge-$program \"\$@\"; }"
done

title "Friction coefficients of a ball joint"
grid=(--theta0 0:95:5 --alpha 0:90:7.5)
hinge-table "${grid[@]}" --output "$out/friction_table.csv"
{
  echo "# Friction coefficients of a ball joint"
  echo
  echo "theta0_deg down: half-angle of the contact. alpha_deg across: slip"
  echo "axis angle, 0 is pure sliding, 90 pure spinning."
  for quantity in chi sigma_Y sigma_Z; do
    echo
    hinge-table "${grid[@]}" --quantity $quantity --format markdown
  done
} >"$out/friction_table.md"

# Pictures need gnuplot; the tables are there without it.
picture() {
  if command -v gnuplot >/dev/null; then echo "--plot=$out/$1.svg"; fi
}
hinge-table --theta0 10:90:10 --alpha 0:90:1 --quantity sigma_Z \
  --output "$out/sigma_Z.csv" $(picture sigma_Z)

title "Half-angles of real joints"
half_angle() { # NAME LOADS
  hinge-angle --joint "data/joints/$1.toml" --load "$2" \
    --law all \
    --output "$out/half_angle_$1.csv" $(picture "half_angle_$1")
}
half_angle hip_cocr_uhmwpe_infinite 1:5000:log100
half_angle spherical_plain_bearing_infinite 10:1e6:log100
half_angle pin_joint 50:5e6:log100
hinge-angle --joint ball --pair data/materials/steel_bronze.toml \
  --radius 50mm --clearance 50um --load 1e3:1e7:log100 \
  --output "$out/half_angle_steel_bronze.csv" \
  $(picture half_angle_steel_bronze)

title "Friction moment of a joint, and the paper's examples"
hinge-joint --joint data/joints/paper_example_2.toml --beta 30,60,90 \
  --reaction 1e4:2e6:1e4 --output "$out/friction_moment.csv" \
  $(picture friction_moment)
beside=(--beside data/reference/paper_examples.csv --format markdown)
{
  echo "# Examples of the paper beside its printed numbers"
  echo
  echo "Example 1: the contact"
  echo
  hinge-joint --joint data/joints/paper_example_1.toml --normal-force 2e5 \
    --alpha 30 --summary "${beside[@]}"
  echo
  echo "Example 1: inner loop"
  echo
  hinge-joint --joint data/joints/paper_example_1.toml --reaction 2.63e5 \
    --beta 67.6 --trace "${beside[@]}"
  example_2=(--joint data/joints/paper_example_2.toml
    --reaction-xyz 1.122e6,3.23e5,0 --rate-xyz 0,0,1 --outer 0,-0.026,0
    --joints 2 --inner-steps 4,3)
  echo
  echo "Example 2: outer loop"
  echo
  hinge-joint "${example_2[@]}" --braking -6.5e-6 "${beside[@]}"
  echo
  echo "Example 2: inner loops"
  echo
  hinge-joint "${example_2[@]}" --trace "${beside[@]}"
} >"$out/paper_examples.md"

title "Separation of four boosters"
hinge-separation data/cases/soyuz.toml --output "$out/soyuz.json" \
  --history "$out/soyuz.csv" --events "$out/soyuz_events.csv" \
  --replay "$out/soyuz.html" --replay "$out/soyuz.glb" $(picture soyuz)
{
  echo "# Ideal joints, friction, and the traditional estimate of friction"
  for case in two_stage_turn soyuz; do
    echo
    hinge-separation "data/cases/$case.toml" --compare --format markdown
  done
} >"$out/separation_comparison.md"

title "The same 1,705 times with scatter"
hinge-study data/studies/soyuz.toml --jobs "$(nproc)" \
  --journal "$out/soyuz_study.journal" --csv "$out/soyuz_study.csv" \
  --output "$out/soyuz_study.json" --report "$out/soyuz_study.html" \
  $(picture soyuz_study) \
  >"$out/soyuz_study.md"

title "Pressure of a hip joint"
hinge-pressure --joint data/joints/hip_cocr_uhmwpe_infinite.toml --load 2000 --pressure all \
  --output "$out/pressure_hip.csv" $(picture pressure_hip)

if command -v gnuplot >/dev/null; then
  title "Figures 3, 4, 5, 8 and 9 of the paper, and limit half-angles"
  run plots/figures.sh build "$out/figures"
fi
scripts/demo_index.sh "$out" "$commands"
echo "Results are in $PWD/$out: open index.html there in a browser"
echo "The other programs and libraries:" \
  "cmake --build --preset release --target installed"
