#!/usr/bin/env bash
# The shared library exports what the headers declare, and nothing else:
#   symbols.sh LIBRARY HEADER...
set -euo pipefail
diff <(nm -D --defined-only --format=posix "$1" | cut -d ' ' -f 1 | sort) \
  <(grep -ohE '\bcontact_\w+\(' "${@:2}" | tr -d '(' | sort -u)
