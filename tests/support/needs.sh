#!/usr/bin/env bash
# Runs a test that needs a package which the build does not:
#   needs.sh PACKAGE PROBE COMMAND...
# where PROBE, a line of shell, fails without the package; then this says which
# and exits with 77, which ctest knows as skipped.
set -euo pipefail
if ! bash -c "$2" >/dev/null 2>&1; then
  echo "skipped: $1 is missing (scripts/setup.sh scripts/packages-extra.txt)"
  exit 77
fi
exec "${@:3}"
