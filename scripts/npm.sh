#!/usr/bin/env bash
# Makes the npm package, build-wasm/libcontact-VERSION.tgz, by emscripten
# (libcontact/docs/how-to/javascript.md). Some minutes at first.
set -euo pipefail
unset CDPATH
cd "$(dirname "$0")/.."
[ "${CONTACT_SKIP_SETUP:-}" = 1 ] ||
  scripts/setup.sh scripts/packages.txt scripts/packages-page.txt
# As for the page: -O3 makes it a tenth larger and no faster.
cmake --preset wasm -D CMAKE_CXX_FLAGS_RELEASE="-O2 -DNDEBUG" "$@"
cmake --build --preset wasm --target npm
(cd build-wasm && npm pack --silent ./npm && ls -l libcontact-*.tgz)
