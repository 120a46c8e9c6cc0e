#!/usr/bin/env bash
# The SBOM names every package that the build looks for, with its version.
#   sbom.sh SBOM SOURCE
set -euo pipefail
unset CDPATH
sbom=$1
cd "$2"
# Simulators are not in packages; the rest is of the compiler.
names=$(grep -rhoP '(find_package|pkg_check_modules|pkg_search_module)\(\K\w+' \
  --include=CMakeLists.txt --include=python.cmake CMakeLists.txt libcontact apps cmake |
  sort -u | grep -vxE 'PkgConfig|Threads|mujoco|Simbody|DART')
for name in $names; do
  grep -qix "SPDXID: SPDXRef-${name//_/-}" "$sbom" || { echo "$name is missing"; exit 1; }
done
# Random123 does not say its version.
unknown=$(grep -A1 '^SPDXID: SPDXRef-' "$sbom" | grep -B1 'PackageVersion: NOASS' |
  sed -n 's/^SPDXID: //p')
[ "$unknown" = SPDXRef-Random123 ] || { echo "without version: $unknown"; exit 1; }
# Each is described once, and related to the library.
parts=$(sed -n 's/^SPDXID: SPDXRef-//p' "$sbom" | sort)
[ "$parts" = "$(uniq <<<"$parts")" ]
diff <(grep -vx DOCUMENT <<<"$parts") \
  <(sed -n 's/^Relationship: .* SPDXRef-//p' "$sbom" | sort)
