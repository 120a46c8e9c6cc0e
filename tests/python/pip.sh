#!/usr/bin/env bash
# pip install from an existing build, into a virtual environment, offline.
#   pip.sh PYTHON SOURCE BUILD FOLDER
set -euo pipefail
unset PYTHONPATH
rm -rf "$4"
"$1" -m venv --system-site-packages "$4"
cd "$2"
"$4/bin/pip" install --quiet --no-build-isolation --no-index \
  --config-settings "build=$3" .
cd "$4"
bin/python -c 'import libcontact, os
assert os.path.dirname(libcontact.__file__).startswith(os.getcwd())
hip = libcontact.Joint.from_file("'"$2"'/data/joints/hip_cocr_uhmwpe.toml")
print(hip.solve([0, 0, 2000], [1, 0, 1]).power)'
version=$(bin/python -c 'import libcontact; print(libcontact.__version__)')
bin/pip --disable-pip-version-check show libcontact |
  grep -Fx "Version: $version"
bin/pip uninstall --quiet --yes libcontact
! bin/python -c 'import libcontact' 2>/dev/null
