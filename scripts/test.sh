#!/usr/bin/env bash
# Set-up, build, all tests; those whose package is missing are skipped, and it
# says which (`scripts/setup.sh scripts/packages-extra.txt` installs them).
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
