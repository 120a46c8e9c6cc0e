#!/usr/bin/env bash
# Runs every script of the gallery of the Python package; each makes a picture
# with something in it.
#   gallery.sh PYTHON GALLERY FOLDER
set -euo pipefail
mkdir -p "$3"
for script in "$2"/*.py; do
  name=$(basename "$script" .py)
  [ "$name" != picture ] || continue
  "$1" -W error::RuntimeWarning "$script" "$3/$name.png"
  # All of one colour takes less.
  size=$(stat -c %s "$3/$name.png")
  [ "$size" -gt 20000 ] || {
    echo "$name.png has $size bytes only"
    exit 1
  }
  echo "$name.png"
done
