#!/usr/bin/env bash
# Builds the calculator, build-wasm/calculator.html: one file that opens from
# disk without a network (libcontact/docs/how-to/calculator.md). The first build
# takes some minutes.
set -euo pipefail
unset CDPATH
cd "$(dirname "$0")/.."
scripts/wasm.sh page "$@"
ls -l build-wasm/calculator.html
