#!/usr/bin/env bash
# Runs the examples of the pages: commands after "$ " in a block, followed by
# their output.
#   scripts/examples.sh BUILD_DIR          runs all of them, rewrites the pages
#   scripts/examples.sh BUILD_DIR --check  prints what that would change, except
#       numbers that differ by 1e-9 or less, as with other instruction sets
# Commands of a block "console" run on a terminal, all others in a pipe.
set -euo pipefail
unset CDPATH
if [ $# -lt 1 ] || [ "${2:---check}" != --check ]; then
  sed -n '2,7s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
PATH=$(cd "$1" && pwd)/bin:$PATH
source=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
ln -s "$source/data" "$work/data"

# What a command prints in a pipe, or on a terminal; in a pipe errors come last.
in_pipe() { # COMMAND
  eval "$1" 2>errors </dev/null || true
  cat errors
}
in_console() { # COMMAND
  # Without lines of progress, which slow machines show.
  NO_COLOR=1 script -qec "$1" /dev/null </dev/null | tr -d '\r' |
    sed 's/.*\x1b\[K//' || true
}

# A page with the examples run again.
with_examples() { # <PAGE
  local line more in_block='' in_output='' where
  while IFS= read -r line; do
    case $line in
      '```console') where=console ;;&
      '```') where=pipe ;;&
      '```'*) [ "$in_block" ] && in_block='' || in_block=yes ;;&
      '$ '* | '```'*) in_output='' ;;
    esac
    [ "$in_output" ] || printf '%s\n' "$line"
    [ "$in_block" ] && [ "${line#'$ '}" != "$line" ] || continue
    while [ "${line%\\}" != "$line" ]; do
      IFS= read -r more
      printf '%s\n' "$more"
      line=${line%\\}$more
    done
    (cd "$work" && "in_$where" "${line#'$ '}")
    in_output=yes
  done
}

# Whether two texts are the same but for the rounding of numbers.
are_alike() { # PAGE PAGE
  [ "$(wc -l <"$1")" = "$(wc -l <"$2")" ] && paste -d '\n' "$1" "$2" | awk '
    function is_near(a, b) {
      return a ~ /^-?[0-9]+[.][0-9]+(e-?[0-9]+)?$/ && b ~ /^-?[0-9]+[.][0-9]+(e-?[0-9]+)?$/ &&
        (a - b) ^ 2 <= (1e-9 * a) ^ 2
    }
    NR % 2 {before = $0; next}
    $0 != before {
      n = split($0, now, /[^-+.0-9a-zA-Z]+/)
      if (split(before, old, /[^-+.0-9a-zA-Z]+/) != n) exit 1
      for (i = 1; i <= n; ++i) {
        if (now[i] != old[i] && !is_near(now[i], old[i])) exit 1
      }
    }'
}

status=0
grep -rlE --include='*.md' '^\$ ' "$source"/*.md "$source"/{apps,libcontact} \
  >"$work/pages"
while IFS= read -r page; do
  with_examples <"$page" >"$work/page"
  if cmp -s "$page" "$work/page"; then continue; fi
  if [ $# -eq 2 ]; then
    are_alike "$page" "$work/page" || { status=1; diff -u "$page" "$work/page" || true; }
  else
    cat "$work/page" >"$page"
    echo "${page#"$source/"}"
  fi
done <"$work/pages"
exit $status
