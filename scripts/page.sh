#!/usr/bin/env bash
# Makes the page to calculate on, build-wasm/calculator.html: one file that opens
# from a disk without a network (libcontact/docs/how-to/calculator.md). Some minutes at first.
set -euo pipefail
unset CDPATH
cd "$(dirname "$0")/.."
[ "${CONTACT_SKIP_SETUP:-}" = 1 ] ||
  scripts/setup.sh scripts/packages.txt scripts/packages-page.txt
# Its -O2: -O3 makes it a tenth larger and no faster; -Os six times as slow.
cmake --preset wasm "$@"
cmake --build --preset wasm --target page
ls -l build-wasm/calculator.html
