#!/usr/bin/env bash
# The lines of wrong_types.py in which mypy finds mistakes.
#   wrong_types.sh MYPY OPTION...
set -euo pipefail
file=$(dirname "$0")/wrong_types.py
diff <(grep -n '# wrong$' "$file" | cut -d : -f 1) \
  <("$@" "$file" | grep 'wrong_types.py:.*: error: ' | sed 's/.*wrong_types.py:\([0-9]*\): .*/\1/' | uniq)
