#!/usr/bin/env bash
# scripts/site.sh BUILD_DIR builds the documentation as a site in
# BUILD_DIR/site, with the C++ and C reference in site/cpp. The site works from
# disk or a server, without a network. Warnings, and formulas that KaTeX cannot
# parse, are errors. It needs a configured build and the packages of
# scripts/packages-site.txt.
set -euo pipefail
unset CDPATH
if [ $# -ne 1 ]; then
  sed -n '2,6s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
build=$(cd "$1" && pwd)
cd "$(dirname "$0")/.."
[ "${CONTACT_SKIP_SETUP:-}" = 1 ] || scripts/setup.sh scripts/packages-site.txt

node scripts/site/formulas.js README.md CHANGELOG.md CONTRIBUTING.md data \
  libcontact/docs

# The pages as they lie in the tree, the README first.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r scripts/site/{mkdocs.yml,hooks.py,theme} "$work"
mkdir "$work/docs"
cp --parents -r libcontact/docs data/README.md CONTRIBUTING.md CHANGELOG.md \
  plots/*.{png,jpg} apps/python/gallery/*.png "$work/docs"
mv "$work/docs/libcontact/docs/index.md" "$work"  # the menu has its links
cp README.md "$work/docs/index.md"
cp scripts/site/*.{css,js} "$work/docs"
cp -rL /usr/share/javascript/katex "$work/docs"
mkdocs build --strict --config-file "$work/mkdocs.yml" \
  --site-dir "$build/site" >"$work/log" 2>&1 || {
  cat "$work/log" >&2
  exit 1
}

doxygen "$build/Doxyfile"
cp -r "$build/reference/html" "$build/site/cpp"
echo "The documentation is in $build/site: open index.html there in a browser"
