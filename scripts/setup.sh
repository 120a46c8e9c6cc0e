#!/usr/bin/env bash
# Installs missing packages (Debian, Ubuntu). Lists them first; does nothing if
# none is missing.
#   scripts/setup.sh [LIST...]
# installs the packages of other lists than scripts/packages.txt, the list for
# the build: packages-extra.txt (for some tests, which are skipped without
# them), packages-check.txt (scripts/check.sh), packages-hosts.txt (adapters to
# simulators, left out without them), packages-page.txt (the hinge calculator,
# the npm package), packages-site.txt (scripts/site.sh).
set -euo pipefail
unset CDPATH
cd "$(dirname "$0")/.."

lists=$(cat "${@:-scripts/packages.txt}")
mapfile -t packages < <(printf %s "$lists")

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  [ "${CONTACT_SKIP_SETUP:-}" = 1 ] && exit 0
  cat >&2 <<EOF
setup: this script installs packages with apt, which this system lacks.
Install the equivalents of these Debian packages, then run the command again
with CONTACT_SKIP_SETUP=1 in the environment:
$(printf '  %s\n' "${packages[@]}")
EOF
  exit 1
fi

# That of the system that is, or would be, installed: older ones do not read the
# presets, and install 30 packages first.
needed=$(sed -n 's/^cmake_minimum_required(VERSION \(.*\))$/\1/p' CMakeLists.txt)
if command -v cmake >/dev/null; then
  found=$(cmake --version | sed -n '1s/.*version //p')
else
  found=$(apt-cache policy cmake | sed -n 's/^ *Candidate: //p')
fi
if dpkg --compare-versions "${found:-$needed}" lt "$needed"; then
  echo "setup: cmake $found is too old: $needed is needed, as in Debian 12 or" \
    "Ubuntu 24.04 and newer ones" >&2
  exit 1
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: not root and no sudo; install these: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "setup: installing with apt-get: ${missing[*]}"
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -q -y --no-install-recommends "${missing[@]}"
