#!/usr/bin/env bash
# Builds the calculator, build-wasm/calculator.html: one file that opens from
# disk without a network (libcontact/docs/how-to/calculator.md). The first build
# takes some minutes.
set -euo pipefail
unset CDPATH
cd "$(dirname "$0")/.."
[ "${CONTACT_SKIP_SETUP:-}" = 1 ] ||
  scripts/setup.sh scripts/packages.txt scripts/packages-page.txt
# Its -O2: -O3 makes it a tenth larger and no faster; -Os six times as slow.
cmake --preset wasm "$@"
cmake --build --preset wasm --target page
ls -l build-wasm/calculator.html
