#!/usr/bin/env bash
# Scripts stay where they are, and say when they cannot do what they were asked
# for:
#   tests/install/scripts.sh WORK_DIR
set -euo pipefail
unset CDPATH
cd "$(dirname "$0")/../.."
rm -rf "$1"
mkdir -p "$1/elsewhere/scripts" "$1/bin"

fail() {
  echo "$*" >&2
  exit 1
}

# Folders of a user's CDPATH come before those beside a script. A script runs
# what it finds: all that change into a folder by a relative name forget it.
count=0
while read -r script; do
  grep -qE '(^|[(;&| ])cd [^/]' "$script" || continue
  count=$((count + 1))
  sed -n '1,/[(;&| ]*cd [^/]/p' "$script" | grep -qx 'unset CDPATH' ||
    fail "$script changes folders by CDPATH"
done < <(find .ci plots scripts tests -name node_modules -prune -o \
  \( -name '*.sh' -o -path .ci/run \) -print)
[ "$count" -gt 15 ] || fail "only $count scripts were found"

# In the place of what would install packages.
for command in sudo apt-get; do
  printf '#!/bin/sh\ntouch "%s/installed"\n' "$1" >"$1/bin/$command"
  chmod +x "$1/bin/$command"
done
export PATH=$1/bin:$PATH
echo no-such-package >"$1/elsewhere/scripts/packages.txt"
CDPATH=$1/elsewhere scripts/setup.sh <(echo bash) || fail "setup.sh"
scripts/setup.sh NO_SUCH_LIST 2>/dev/null &&
  fail "setup.sh takes a list that is not there for an empty one"
CDPATH=$1/elsewhere scripts/check.sh english >/dev/null || true
[ ! -e "$1/installed" ] || fail "check.sh english installs packages"
