#!/usr/bin/env bash
# Runs a program for Windows, whose lines then end as they do here.
set -o pipefail
export WINEDEBUG=-all
wine=$(command -v wine64) || wine=/usr/lib/wine/wine64
"$wine" "$@" | tr -d '\r'
