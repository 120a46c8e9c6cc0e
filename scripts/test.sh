#!/usr/bin/env bash
# Set-up, build, all tests.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
cmake --preset release
cmake --build --preset release
ctest --test-dir build --output-on-failure --no-tests=error \
  --parallel "$(nproc)"
