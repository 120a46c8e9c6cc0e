#!/usr/bin/env bash
# Builds the npm package, build-wasm/libcontact-VERSION.tgz, by emscripten
# (libcontact/docs/how-to/javascript.md). The first build takes some minutes.
set -euo pipefail
unset CDPATH
cd "$(dirname "$0")/.."
scripts/wasm.sh npm "$@"
cd build-wasm
npm pack --silent ./npm
ls -l libcontact-*.tgz
