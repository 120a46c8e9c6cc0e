#!/usr/bin/env bash
# pip install from an existing build, into a virtual environment, offline; the
# wheel is whole, and what cannot be installed is refused in a sentence.
#   pip.sh PYTHON SOURCE BUILD FOLDER
set -euo pipefail
unset CDPATH
unset PYTHONPATH
rm -rf "$4"
"$1" -m venv --system-site-packages "$4"
cd "$2"
pip=("$4/bin/pip" --disable-pip-version-check)

# Every file of the wheel has its hash, and the metadata are those that pip is
# told without a build.
"${pip[@]}" wheel --quiet --no-build-isolation --no-index --no-deps \
  --config-settings "build=$3" --wheel-dir "$4/wheel" .
"$4/bin/python" - "$4" <<'PYTHON'
import base64, csv, glob, hashlib, io, sys, zipfile
sys.path.insert(0, "apps/python")
import build_backend
folder = sys.argv[1]
archive = zipfile.ZipFile(glob.glob(f"{folder}/wheel/*.whl")[0])
info = build_backend.prepare_metadata_for_build_wheel(folder)
for name in ("METADATA", "WHEEL", "LICENSE"):
    assert archive.read(f"{info}/{name}") == open(f"{folder}/{info}/{name}", "rb").read()
record = list(csv.reader(io.StringIO(archive.read(f"{info}/RECORD").decode())))
assert {name for name, _, _ in record} == set(archive.namelist())
for name, code, size in record[:-1]:
    digest = hashlib.sha256(archive.read(name)).digest()
    code_now = base64.urlsafe_b64encode(digest).rstrip(b"=").decode()
    assert code == f"sha256={code_now}" and int(size) == len(archive.read(name))
PYTHON

# refused SENTENCE OPTION...
refused() {
  local output
  output=$("${pip[@]}" install --no-build-isolation --no-index "${@:2}" . 2>&1) &&
    exit 1
  grep -F "$1" <<<"$output"
}
mkdir "$4/other"
refused "is no build of libcontact" --config-settings "build=$4/other"
printf '%s\n' '#!/bin/sh' 'echo cp312' >"$4/other/python"
chmod +x "$4/other/python"
echo "Python_EXECUTABLE:FILEPATH=$4/other/python" >"$4/other/CMakeCache.txt"
refused "is for cp312, this is cp3" --config-settings "build=$4/other"
refused "libcontact cannot be installed with -e" -e

"${pip[@]}" install --quiet --no-index "$4"/wheel/*.whl
cd "$4"
bin/python -c 'import libcontact, os
assert os.path.dirname(libcontact.__file__).startswith(os.getcwd())
hip = libcontact.Joint.from_file(libcontact.examples["joints/hip_cocr_uhmwpe.toml"])
print(hip.solve([0, 0, 2000], [1, 0, 1]).power)
assert libcontact.materials["UHMWPE"]["youngs_modulus_GPa"] == 1
# By the program beside this Python, which is not on the PATH.
import concurrent.futures
with concurrent.futures.ThreadPoolExecutor(1) as executor:
    print(libcontact.study.run(
        libcontact.examples["studies/hip.toml"], executor, runs=48))'
bin/hinge-joint --version
version=$(bin/python -c 'import libcontact; print(libcontact.__version__)')
bin/pip --disable-pip-version-check show libcontact |
  grep -Fx -e "Version: $version" -e 'License: MIT'
bin/pip uninstall --quiet --yes libcontact
! bin/python -c 'import libcontact' 2>/dev/null
! test -e bin/hinge-joint
