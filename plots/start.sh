# figures.sh and tutorials.sh begin with this file: names of folders, programs on
# the PATH, and the output folder.
set -euo pipefail
unset CDPATH
if [ $# -ne 2 ]; then
  sed -n '1d;/^#/!q;s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
plots=$(cd "$(dirname "$0")" && pwd)
data=$(cd "$plots/../data" && pwd)
PATH=$(cd "$1/bin" && pwd):$PATH
mkdir -p "$2"
cd "$2"
if ! command -v gnuplot >/dev/null; then
  echo "$(basename "$0"): gnuplot is not installed, no figures" >&2
  exit 1
fi
