#!/usr/bin/env bash
# runpaths.sh FOLDER: every part of the RUNPATH or RPATH of every program,
# library and module below the folder is an absolute path or begins with
# $ORIGIN. An empty or relative part is the current directory, whose libraries
# would be loaded and run.
set -euo pipefail
mapfile -d '' files < <(find "$1" -path '*/install_test' -prune -o \
  -type f \( -perm -u+x -o -name '*.so' -o -name '*.so.*' \) -print0)
elf=()
for file in "${files[@]}"; do
  IFS= read -r -d '' -n 4 magic < "$file" || true
  if [[ $magic == $'\x7fELF' ]]; then elf+=("$file"); fi
done
if ((${#elf[@]} == 0)); then
  echo "no program below $1"
  exit 1
fi
status=0
for file in "${elf[@]}"; do
  # "0x1d (RUNPATH)  Library runpath: [/a:/b]"
  dynamic=$(LC_ALL=C readelf -d "$file")
  while IFS= read -r path; do
    while IFS= read -r -d : part; do
      case $part in
        /* | '$ORIGIN' | '$ORIGIN/'*) ;;
        *)
          echo "$file: RUNPATH [$path] has the part '$part'"
          status=1
          ;;
      esac
    done <<< "$path:"
  done < <(sed -nE 's/.*\((RUNPATH|RPATH)\).*\[(.*)\]$/\2/p' <<< "$dynamic")
done
echo "${#elf[@]} files"
exit $status
