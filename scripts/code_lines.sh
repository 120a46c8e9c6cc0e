#!/usr/bin/env bash
# Code lines of every module and its tests, without blanks and comments, rounded
# to 50. Growth shows in the diff of the commit that causes it.
#   scripts/code_lines.sh >tests/rooms/code_lines.txt   renews the list
#   scripts/code_lines.sh --check                       compares
set -euo pipefail
unset CDPATH
cd "$(dirname "$0")/.."
if [[ ${1-} == --check ]]; then
  if ! diff tests/rooms/code_lines.txt <("$0"); then
    echo "to write them anew: $0 >tests/rooms/code_lines.txt"
    exit 1
  fi
  exit
fi

# Rooms of the library, of their tests and of most others are folders in these;
# those of separation, multibody and programs lie one deeper.
find libcontact apps tests scripts cmake -name node_modules -prune -o \
  -name __pycache__ -prune -o -type f \
  -print | grep -E '\.(cpp|hpp|h|c|py|pyi|in|js|sh|cmake)$|CMakeLists\.txt$' |
  LC_ALL=C sort | xargs awk '
    FNR == 1 { inside = 0 }
    inside { if (/\*\//) inside = 0; next }
    /^[ \t]*$/ { next }
    FILENAME ~ /\.(cpp|hpp|h|c|js)$/ {
      if (/^[ \t]*\/\//) next
      if (/^[ \t]*\/\*/) { inside = !/\*\//; next }
    }
    FILENAME !~ /\.(cpp|hpp|h|c|js)$/ && /^[ \t]*#/ { next }
    {
      count = split(FILENAME, part, "/")
      depth = FILENAME ~ /^apps\/(separation|multibody|programs)\// ? 4 : 3
      if (count < depth) depth = count
      room = part[1]
      for (i = 2; i < depth; ++i) room = room "/" part[i]
      ++lines[room]
    }
    END {
      for (room in lines) print room ":", int(lines[room] / 50 + 0.5) * 50
    }' | LC_ALL=C sort
