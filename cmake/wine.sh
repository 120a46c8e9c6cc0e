#!/usr/bin/env bash
# Runs a program for Windows, whose lines then end as they do here. Its shared
# libraries are in bin beside its folder.
set -o pipefail
export WINEDEBUG=-all
wine=$(command -v wine64) || wine=/usr/lib/wine/wine64
libraries=$(cd "$(dirname "$1")/.." && pwd)/bin
export WINEPATH="Z:${libraries//\//\\}"
errors=$(mktemp)
trap 'rm -f "$errors"' EXIT
# Once more if wine itself fails, whose server may end as a program begins.
for _ in 1 2; do
  "$wine" "$@" 2>"$errors" | tr -d '\r' && status=0 || status=$?
  grep -q '^wine client error' "$errors" || break
done
cat "$errors" >&2
exit $status
