#!/usr/bin/env bash
# Redraws the last pictures of the tutorials, by the commands on their pages:
#   plots/tutorials.sh BUILD_DIR OUTPUT_DIR
source "$(dirname "$0")/start.sh"

hinge-joint "$data/joints/hip_cocr_uhmwpe.toml" --reaction 2000 --beta 60 \
  --map hip_contact.png --output hip_contact.csv
hinge-duty "$data/joints/pin_joint.toml" --cycle "$data/duty/pin_swing.csv" \
  --force-in body --wear-seat 2e-7 --map-plot bush_wear.png \
  --output bush_wear.csv
hinge-duty "$data/joints/hip_cocr_uhmwpe.toml" \
  --cycle "$data/duty/hip_cycle.csv" --euler zxy --wear-seat 1e-6 \
  --map-plot hip_wear.png --output hip_wear.csv
hinge-separation "$data/cases/pendulum.toml" --plot pendulum.png \
  --output pendulum.json
hinge-study "$data/studies/soyuz.toml" --runs 200 --plot soyuz_study.png \
  --output soyuz_study.json >/dev/null
