#!/usr/bin/env bash
# Installs packages, builds, and runs all tests. Tests whose package is missing
# are skipped and listed (`scripts/setup.sh scripts/packages-extra.txt` installs
# these packages).
set -euo pipefail
unset CDPATH
cd "$(dirname "$0")/.."
scripts/setup.sh
cmake --preset release
cmake --build --preset release
status=0
ctest --test-dir build --output-on-failure --no-tests=error \
  --parallel "${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}" || status=$?
grep '^skipped: ' build/Testing/Temporary/LastTest.log | sort -u || true
exit $status
