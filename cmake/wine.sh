#!/usr/bin/env bash
# Runs a program for Windows, whose lines then end as they do here. Its shared
# libraries are in bin beside its folder.
set -o pipefail
export WINEDEBUG=-all
wine=$(command -v wine64) || wine=/usr/lib/wine/wine64
libraries=$(cd "$(dirname "$1")/.." && pwd)/bin
export WINEPATH="Z:${libraries//\//\\}"
"$wine" "$@" | tr -d '\r'
