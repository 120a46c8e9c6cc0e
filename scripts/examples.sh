#!/usr/bin/env bash
# The examples of the pages, commands after "$ " in a block with what they say
# below them:
#   scripts/examples.sh BUILD_DIR          runs all of them, rewrites the pages
#   scripts/examples.sh BUILD_DIR --check  says what that would change
set -euo pipefail
if [ $# -lt 1 ] || [ "${2:---check}" != --check ]; then
  sed -n '2,5s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
PATH=$(cd "$1" && pwd)/bin:$PATH
source=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
ln -s "$source/data" "$work/data"

# A page with the examples run again; errors and warnings come last.
with_examples() { # <PAGE
  local line more in_block='' in_output=''
  while IFS= read -r line; do
    case $line in
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
    (cd "$work" && eval "${line#'$ '}" 2>errors </dev/null) || true
    cat "$work/errors"
    in_output=yes
  done
}

status=0
grep -rlE --include='*.md' '^\$ ' "$source"/*.md "$source"/{apps,libcontact} \
  >"$work/pages"
while IFS= read -r page; do
  with_examples <"$page" >"$work/page"
  if cmp -s "$page" "$work/page"; then continue; fi
  if [ $# -eq 2 ]; then
    diff -u "$page" "$work/page" || status=1
  else
    cat "$work/page" >"$page"
    echo "${page#"$source/"}"
  fi
done <"$work/pages"
exit $status
