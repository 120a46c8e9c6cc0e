#!/usr/bin/env bash
# Makes the npm package, build-wasm/libcontact-VERSION.tgz, by emscripten
# (libcontact/docs/how-to/javascript.md). Some minutes at first.
set -euo pipefail
unset CDPATH
cd "$(dirname "$0")/.."
scripts/wasm.sh npm "$@"
cd build-wasm
npm pack --silent ./npm
ls -l libcontact-*.tgz
