#!/usr/bin/env bash
# Makes the page to calculate on, build-wasm/calculator.html: one file that opens
# from a disk without a network (libcontact/docs/how-to/calculator.md). Some minutes at first.
set -euo pipefail
unset CDPATH
cd "$(dirname "$0")/.."
scripts/wasm.sh page "$@"
ls -l build-wasm/calculator.html
