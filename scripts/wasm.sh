#!/usr/bin/env bash
# Builds a target by emscripten, in build-wasm; some minutes at first.
#   scripts/wasm.sh TARGET [OPTIONS of cmake]
set -euo pipefail
unset CDPATH
cd "$(dirname "$0")/.."
[ "${CONTACT_SKIP_SETUP:-}" = 1 ] ||
  scripts/setup.sh scripts/packages.txt scripts/packages-page.txt
# The preset's -O2: -O3 makes them a tenth larger and no faster; -Os six times as slow.
cmake --preset wasm "${@:2}"
cmake --build --preset wasm --target "$1"
