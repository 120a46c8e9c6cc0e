#!/usr/bin/env bash
# scripts/demo_index.sh FOLDER COMMANDS writes FOLDER/index.html: a page with
# the files that the commands wrote into the folder, pictures first, each with
# its command. A line of COMMANDS is "# title" or a command; words that name
# files in FOLDER are its outputs.
set -euo pipefail
out=$1 commands=$2

escaped() { sed 's/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g; s/"/\&quot;/g'; }

# Lists the files of a command, one per line: words in the folder, files in
# folders it was given, and pictures it numbered.
files() {
  local word
  for word in $1; do
    word=${word#*=}
    case $word in "$out"/*) ;; *) continue ;; esac
    if [ -d "$word" ]; then
      find "$word" -type f | sort
    elif [ -e "$word" ]; then
      echo "$word"
    else
      compgen -G "${word%.*}_*.${word##*.}" || true
    fi
  done
}

# One a line, by name.
links() {
  local file
  while IFS= read -r file; do
    echo "<a href=\"${file#"$out"/}\">${file#"$out"/}</a>"
  done
}

figure() { # FILE
  local name=${1#"$out"/}
  case $name in
    *.svg | *.png) echo "<a href=\"$name\"><img src=\"$name\" alt=\"$name\" loading=\"lazy\"></a>" ;;
  esac
}

page() {
  cat <<'END'
<!DOCTYPE html>
<html lang="en"><meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>What the demonstration made</title>
<style>
:root { color-scheme: light dark; font-family: sans-serif; line-height: 1.4; }
body { max-width: 72rem; margin: 1rem auto; padding: 0 1rem; }
img { max-width: 100%; height: auto; background: #fff; }
figure { margin: 1rem 0 2rem; }
pre { white-space: pre-wrap; overflow-wrap: anywhere; padding: .5rem;
  background: #8882; }
</style>
<h1>What the demonstration made</h1>
<p>Every picture, page and table has the command that made it, as it is typed in
the folder of the project with build/bin on the path.</p>
END
  local line file
  while IFS= read -r line; do
    if [ "${line:0:2}" = "# " ]; then
      echo "<h2>$(printf %s "${line:2}" | escaped)</h2>"
      continue
    fi
    echo "<figure>"
    files "$line" | while IFS= read -r file; do figure "$file"; done
    echo "<figcaption><p>"
    files "$line" | links
    echo "</p><pre>$(printf %s "$line" | escaped)</pre></figcaption></figure>"
  done <"$commands"
  echo "<h2>All files</h2><p>"
  find "$out" -type f ! -name 'index.html*' | sort | links
  echo "</p></html>"
}

page >"$out/index.html.new"
mv "$out/index.html.new" "$out/index.html"
